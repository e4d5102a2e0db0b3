"""The verbs of `cgw image` from outside: exit code and both streams, for good and bad inputs."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
GENSET = SAMPLES / "genset.toml"


def cgw(*arguments, stdout=subprocess.PIPE, directory=None):
    return subprocess.run([CGW, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, cwd=directory, timeout=120)


def signed(image):
    """With the CRC-32 that the bytes have."""
    return bytes(image[:-4]) + struct.pack("<I", zlib.crc32(bytes(image[:-4])))


class ImageVerb(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-image-"))
        self.addCleanup(shutil.rmtree, self.dir)
        self.path = self.dir / "x.bin"
        cgw("emit", "image", GENSET, "-o", self.path)
        self.image = self.path.read_bytes()

    def write(self, content, name="x.bin"):
        path = self.dir / name
        path.write_bytes(content)
        return path

    def bad_images(self):
        """What no gateway takes, with the status number."""
        image = self.image
        return {b"": 1, b"x" * 67: 1, b"\xff" * 70000: 2, GENSET.read_bytes(): 3, b"\0" * 100: 3,
                signed(image[:4] + b"\2" + image[5:]): 4, image[:-5]: 6, image + b"\0": 6,
                image[:300] + b"\x55" + image[301:]: 7, signed(image[:64] + b"\7" + image[65:]): 8}

    def refused_by(self, *verb):
        for content, status in self.bad_images().items():
            result = cgw(*verb, self.write(content).name, directory=self.dir)
            self.assertEqual(result.returncode, 1, (verb, status))
            first = result.stderr.decode().split("\n")[0]
            self.assertRegex(first, rf"^x\.bin: refused: .* \(status {status}\)$")
            yield status, result
        for path in (self.dir / "none.bin", self.dir):
            result = cgw(*verb, path)
            self.assertEqual((result.returncode, result.stdout), (3, b""), verb)
            self.assertIn(str(path), result.stderr.decode())

    def has_full_disk(self, *arguments):
        with open("/dev/full", "w") as full:
            result = cgw(*arguments, stdout=full)
        self.assertEqual(result.returncode, 3, arguments)
        self.assertIn(b"standard output", result.stderr)


class Annotate(ImageVerb):
    def test_tells_a_sound_image_in_80_columns(self):
        result = cgw("image", "annotate", self.path.name, directory=self.dir)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        text = result.stdout.decode()
        self.assertTrue(text.startswith(f"x.bin: {len(self.image)} bytes\n\nheader\n"))
        self.assertLessEqual(max(map(len, text.split("\n"))), 80)
        self.assertNotIn("\n!", text)

    def test_json_holds_every_byte_once(self):
        result = cgw("image", "annotate", self.path, "--json")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        document = json.loads(result.stdout)
        self.assertEqual((document["format_version"], document["valid"], document["refusal"]), (1, True, None))
        told = "".join(field["bytes"] for record in document["records"] for field in record["fields"])
        self.assertEqual(bytes.fromhex(told), self.image)

    def test_refused_images_are_told_and_exit_1(self):
        for status, result in self.refused_by("image", "annotate"):
            if status == 2:
                self.assertEqual(result.stdout, b"")
            else:
                self.assertIn(b"\n!", result.stdout, status)
        for status, result in self.refused_by("image", "annotate", "--json"):
            if status != 2:
                document = json.loads(result.stdout)
                self.assertEqual(document["refusal"]["status"], status)

    def test_a_wrong_crc_does_not_hide_what_else_is_wrong(self):
        self.write(self.image[:0xF0] + b"\xc8" + self.image[0xF1:])
        result = cgw("image", "annotate", "x.bin", directory=self.dir)
        self.assertEqual(result.stderr.decode(),
                         "x.bin: refused: the CRC-32 does not match (status 7)\n"
                         "x.bin: with a right CRC-32 also refused: a record holds a value that no configuration can "
                         "have (status 10)\n")
        self.assertIn("buses 2 of 2: CAN2\n! 00F0 C8          u8    own_node          200        the gateway's node "
                      "(427)\n!      ^^ must be 1..127\n", result.stdout.decode())

    def test_a_full_disk_is_exit_3(self):
        self.has_full_disk("image", "annotate", self.path)
        self.has_full_disk("image", "annotate", self.path, "--json")


if __name__ == "__main__":
    unittest.main()
