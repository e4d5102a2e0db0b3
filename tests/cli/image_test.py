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
        self.write(self.image[:0xFC] + b"\xc8" + self.image[0xFD:])
        result = cgw("image", "annotate", "x.bin", directory=self.dir)
        self.assertEqual(result.stderr.decode(),
                         "x.bin: refused: the CRC-32 does not match (status 7)\n"
                         "x.bin: with a right CRC-32 also refused: a record holds a value that no configuration can "
                         "have (status 10)\n")
        self.assertIn("buses 2 of 2: CAN2\n! 00FC C8          u8    own_node          200        the gateway's node "
                      "(427)\n!      ^^ must be 1..127\n", result.stdout.decode())

    def test_a_full_disk_is_exit_3(self):
        self.has_full_disk("image", "annotate", self.path)
        self.has_full_disk("image", "annotate", self.path, "--json")


class Decompile(ImageVerb):
    def test_the_file_compiles_to_the_identical_image(self):
        for sample in ("genset.toml", "minimal.toml", "manual-example.toml"):
            image, file, again = (self.dir / name for name in ("a.bin", "a.toml", "b.bin"))
            cgw("emit", "image", SAMPLES / sample, "-o", image)
            result = cgw("image", "decompile", image, "-o", file, "--force")
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""), sample)
            self.assertIn("# It compiles to the identical image.\n", file.read_text())
            self.assertEqual(cgw("emit", "image", file, "-o", again).returncode, 0)
            self.assertEqual(again.read_bytes(), image.read_bytes(), sample)

    def test_without_labels_it_says_what_is_lost(self):
        cgw("emit", "image", GENSET, "--no-labels", "-o", self.path)
        result = cgw("image", "decompile", "x.bin", directory=self.dir)
        self.assertEqual(result.returncode, 0)
        lines = result.stderr.decode().splitlines()
        self.assertIn("x.bin: lost: title, and names, units and ranges of what was declared", lines)
        self.assertRegex(lines[-1], r"^x\.bin: the file compiles to another image, of configuration [0-9a-f]{16}; "
                                    r"different: configuration id$")
        self.assertIn("# What the image does not hold, and is lost:\n", result.stdout.decode())

    def test_a_model_of_another_id_is_refused(self):
        self.write(signed(self.image[:16] + b"\0" + self.image[17:]))
        result = cgw("image", "decompile", "x.bin", directory=self.dir)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"the configuration id is not that of the model", result.stderr)
        self.assertEqual(cgw("image", "annotate", self.path).returncode, 1)

    def test_bad_images_are_refused(self):
        for status, result in self.refused_by("image", "decompile"):
            self.assertEqual(result.stdout, b"", status)

    def test_files_and_full_disks(self):
        out = self.write(b"mine", "out.toml")
        self.assertEqual(cgw("image", "decompile", self.path, "-o", out).returncode, 2)
        self.assertEqual(out.read_bytes(), b"mine")
        self.assertEqual(cgw("image", "decompile", self.path, "-o", self.path, "--force").returncode, 2)
        self.assertEqual(cgw("image", "decompile", self.path, "-o", self.dir / "none" / "x.toml").returncode, 3)
        self.has_full_disk("image", "decompile", self.path)


class Diff(ImageVerb):
    def other(self, *options, old="427", new="427"):
        path = self.dir / "y.bin"
        file = self.dir / "y.toml"
        file.write_text(GENSET.read_text().replace(old, new))
        self.assertEqual(cgw("emit", "image", file, *options, "-o", path).returncode, 0)
        return path

    def diff(self, *options):
        return cgw("image", "diff", "x.bin", "y.bin", *options, directory=self.dir)

    def test_identical_images_are_said_to_be_so(self):
        self.other()
        result = self.diff()
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertIn("Nothing differs.\nThe images are byte for byte the same.\n", result.stdout.decode())
        self.assertTrue(json.loads(self.diff("--format", "json").stdout)["same"])

    def test_differences_are_told_as_parameters_and_what_follows(self):
        self.other(old='title = "Genset 2, starboard"', new='title = "Genset 3, port"')
        result = self.diff()
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertIn("Genset 3, port", result.stdout.decode())

    def test_labels_left_out_are_told(self):
        self.other("--no-labels")
        result = self.diff("--format", "json")
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        document = json.loads(result.stdout)
        self.assertEqual(document["consequences"], [])
        self.assertIn({"kind": "image-labels", "subject": "labels", "a": "in the image", "b": "left out"},
                      document["otherwise"])

    def test_another_version_of_cgw_is_told(self):
        self.write(signed(self.image[:48] + b"\7" + self.image[49:]), "y.bin")
        result = self.diff()
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout.decode(), r"written by +cgw \S+ -> cgw 7\.")

    def test_a_value_changed_by_other_means_is_told(self):
        at = struct.unpack_from("<I", self.image, 64 + 6 * 12 + 4)[0]
        self.write(signed(self.image[:at] + b"\x55" + self.image[at + 1:]), "y.bin")
        result = self.diff()
        self.assertEqual(result.returncode, 1)
        self.assertIn("section object_values", result.stdout.decode())

    def test_bad_images_are_refused(self):
        for content, status in self.bad_images().items():
            self.write(content, "y.bin")
            result = self.diff()
            self.assertEqual((result.returncode, result.stdout), (1, b""), status)
            self.assertIn(f"(status {status})".encode(), result.stderr)
        (self.dir / "y.bin").unlink()
        self.assertEqual(self.diff().returncode, 3)
        self.has_full_disk("image", "diff", self.path, self.path)


if __name__ == "__main__":
    unittest.main()
