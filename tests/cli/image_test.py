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


def split(image):
    """{section id: (record size, bytes)}"""
    header, count = struct.unpack_from("<HH", image, 8)
    entries = (struct.unpack_from("<HHII", image, header + 12 * i) for i in range(count))
    return {number: (record, image[offset:offset + size]) for number, record, offset, size in entries}


def join(header, parts, minor=0):
    directory, content, start = b"", b"", len(header) + 12 * len(parts)
    for number, (record, part) in parts.items():
        directory += struct.pack("<HHII", number, record, start + len(content), len(part))
        content += part + bytes(-len(part) % 4)
    whole = bytearray(header + directory + content)
    struct.pack_into("<HHH", whole, 6, minor, len(header), len(parts))
    struct.pack_into("<I", whole, 12, len(whole) + 4)
    return signed(whole + bytes(4))


def hex_of(blocks):
    """Intel HEX of {address: bytes}."""
    def record(address, kind, data):
        body = struct.pack(">BHB", len(data), address, kind) + data
        return f":{(body + bytes([-sum(body) & 0xFF])).hex().upper()}\n"

    lines = []
    for start, content in blocks.items():
        for at in range(start, start + len(content), 16):
            lines.append(record(0, 4, struct.pack(">H", at >> 16)))
            lines.append(record(at & 0xFFFF, 0, content[at - start:at - start + 16]))
    return "".join([*lines, ":00000001FF\n"]).encode()


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
        return {b"": 1, b"x" * 67: 1, b"\xff" * 70000: 1, b"\0" * 100: 1, GENSET.read_bytes(): 3, b"x" * 70000: 3,
                signed(image[:4] + b"\2" + image[5:]): 4, image[:-5]: 6, image[:12] + b"\0\0\1\0" + image[16:]: 6,
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


ALONE = ("verify", "inspect", "annotate", "decompile")  # the verbs that take one image


class Region(ImageVerb):
    """What a programmer read out of a device: the image, and whatever stands behind it."""

    def all_say(self, file, code, *said, options=()):
        for verb in ALONE:
            result = cgw("image", verb, file, *options, directory=self.dir)
            self.assertEqual(result.returncode, code, (verb, result.stderr))
            for text in said:
                self.assertIn(text, result.stderr.decode(), verb)

    def test_the_image_is_judged_and_the_rest_told(self):
        for rest, said in ((b"\xff" * 16000, "16000 bytes behind the image, all 0xFF"),
                           (bytes(70000), "70000 bytes behind the image, all 0x00"),
                           (b"other", "5 bytes behind the image are not judged; they are no filling")):
            self.write(self.image + rest, "region.bin")
            self.all_say("region.bin", 0, f"region.bin: {said}\n")
            self.assertEqual(cgw("image", "decompile", "region.bin", directory=self.dir).stdout,
                             cgw("image", "decompile", "x.bin", directory=self.dir).stdout)
        result = cgw("image", "diff", "x.bin", "region.bin", directory=self.dir)
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"byte for byte the same", result.stdout)

    def test_an_erased_region_is_status_1_as_in_the_firmware(self):
        self.write(b"\xff" * 8192, "region.bin")
        self.all_say("region.bin", 1, "region.bin: refused: erased, all 8192 bytes are 0xFF (status 1)\n")

    def test_a_damaged_image_in_a_region_keeps_its_status(self):
        self.write(self.image[:300] + b"\x55" + self.image[301:] + b"\xff" * 9000, "region.bin")
        self.all_say("region.bin", 1, "region.bin: refused: the CRC-32 does not match (status 7)\n")


class Firmware(ImageVerb):
    """Images in firmware files, for every verb that reads one."""

    def hex_file(self, *images, name="fw.hex"):
        self.write(hex_of(dict(images)), name)
        return name

    def test_the_only_image_is_taken(self):
        name = self.hex_file((0x8000, self.image))
        for verb in ALONE:
            plain, inside = (cgw("image", verb, file, directory=self.dir) for file in ("x.bin", name))
            self.assertEqual((inside.returncode, inside.stderr), (0, b""), verb)
            self.assertEqual(inside.stdout.replace(b"fw.hex at 0x00008000", b"x.bin"), plain.stdout, verb)
        result = cgw("image", "diff", "x.bin", name, "--address", "0x8000", directory=self.dir)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        result = cgw("image", "diff", "x.bin", "x.bin", "--address", "0x8000", directory=self.dir)
        self.assertEqual(result.returncode, 2)

    def test_of_several_one_must_be_named(self):
        name = self.hex_file((0x8000, self.image), (0x20000, self.image))
        self.assertEqual(cgw("image", "verify", name, directory=self.dir).returncode, 0)
        for verb in ALONE[1:]:
            result = cgw("image", verb, name, directory=self.dir)
            self.assertEqual((result.returncode, result.stdout), (1, b""), verb)
            self.assertIn(b"fw.hex at 0x00020000: an image\nfw.hex: refused: 2 images are in it; say with --section or "
                          b"--address which one is meant\n", result.stderr)
            result = cgw("image", verb, name, "--address", "0x20000", directory=self.dir)
            self.assertEqual((result.returncode, result.stderr), (0, b""), verb)

    def test_a_cut_image_beside_a_sound_one_is_refused(self):
        name = self.hex_file((0x8000, self.image), (0x20000, self.image[:-40]))
        result = cgw("image", "verify", name, directory=self.dir)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"fw.hex at 0x00008000: valid", result.stdout)
        self.assertRegex(result.stderr.decode(), r"^fw\.hex at 0x00020000: refused: .* \(status 6\)\n$")

    def test_a_mistyped_address_is_refused_and_beside_allows_it(self):
        name = self.hex_file((0x3E000, self.image))
        into = ("image", "embed", "x.bin", "--into", name, "-o", "new.hex", "--address", "0x3a000")
        result = cgw(*into, directory=self.dir)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn("E0714 image-elsewhere", result.stderr.decode())
        self.assertIn("an image stands at 0x0003E000 already, configuration id", " ".join(result.stderr.decode().split()))
        self.assertFalse((self.dir / "new.hex").exists())
        self.assertEqual(cgw(*into, "--beside", directory=self.dir).returncode, 0)
        self.assertEqual(cgw("image", "verify", "new.hex", directory=self.dir).stdout.count(b"valid"), 2)

    def test_an_image_of_another_model_is_warned_about_and_not_embedded(self):
        self.write(signed(self.image[:16] + b"\0" + self.image[17:]))
        for verb in ALONE[:2]:
            result = cgw("image", verb, "x.bin", directory=self.dir)
            self.assertEqual(result.returncode, 0, verb)
            self.assertRegex(result.stderr.decode(), "^x.bin: warning: the configuration id is not that of the model")
        self.write(hex_of({0: b"code"}), "fw.hex")
        result = cgw("image", "embed", "x.bin", "--into", "fw.hex", "-o", "new.hex", "--address", "0x8000", directory=self.dir)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0713 image-model", result.stderr)

    def test_what_cannot_be_meant_is_a_usage_error(self):
        for said, arguments in ((b"standard input can be read only once", ("diff", "-", "-")),
                                (b"a firmware file cannot come from standard input",
                                 ("embed", "x.bin", "--into", "-", "--in-place", "--address", "0")),
                                (b"the address is too large", ("verify", "x.bin", "--address", "0x" + "F" * 20))):
            result = cgw("image", *arguments, directory=self.dir)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
            self.assertIn(said, result.stderr)


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
            self.assertIn(b"\n!", result.stdout, status)
        for status, result in self.refused_by("image", "annotate", "--json"):
            self.assertEqual(json.loads(result.stdout)["refusal"]["status"], status)

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
        self.assertRegex(lines[-1], r"^x\.bin: the file compiles with --no-labels to another image, of configuration "
                                    r"[0-9a-f]{16}; different: configuration id$")
        self.assertIn("# What is lost:\n", result.stdout.decode())

    def test_without_labels_only_no_labels_gives_the_identical_image(self):
        minimal, file = SAMPLES / "minimal.toml", self.dir / "a.toml"
        cgw("emit", "image", minimal, "--no-labels", "-o", self.path)
        result = cgw("image", "decompile", "x.bin", "-o", file, directory=self.dir)
        self.assertEqual(result.returncode, 0)
        self.assertTrue(result.stderr.endswith(b"x.bin: the file compiles with --no-labels to the identical image\n"),
                        result.stderr)
        self.assertIn("# With --no-labels it compiles to the identical image.\n", file.read_text())
        cgw("emit", "image", file, "--no-labels", "-o", self.dir / "b.bin")
        self.assertEqual((self.dir / "b.bin").read_bytes(), self.path.read_bytes())

    def test_what_a_later_format_added_is_lost(self):
        parts = split(self.image)
        for lost, image in (
                ("section 14, 8 bytes, which this cgw does not know", join(self.image[:64], {**parts, 14: (4, b"12345678")}, 1)),
                ("4 bytes of a longer header", join(self.image[:64] + b"more", parts, 1)),
                ("what the reserved bytes of the header say", join(self.image[:54] + b"\1" + self.image[55:64], parts, 1))):
            self.write(image)
            self.assertEqual(cgw("image", "verify", self.path).returncode, 0, lost)
            result = cgw("image", "decompile", "x.bin", directory=self.dir)
            said = result.stderr.decode()
            self.assertEqual(result.returncode, 1, lost)
            self.assertIn(f"x.bin: lost: {lost}\n", said)
            self.assertIn("compiles to another image", said)
            self.assertIn(f"# - {lost}\n", result.stdout.decode())
            self.assertNotIn("identical", said + result.stdout.decode(), lost)

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

    def test_the_same_parameters_are_not_claimed_where_they_are_not_known(self):
        plain = (SAMPLES / "minimal.toml").read_text()
        more = plain.replace("[governor.parameters]", "[governor.parameters]\n811 = 3", 1)
        self.assertNotEqual(plain, more)
        for name, text, options in (("x", plain, ()), ("xn", plain, ["--no-labels"]), ("yn", more, ["--no-labels"])):
            file = self.dir / "p.toml"
            file.write_text(text)
            self.assertEqual(cgw("emit", "image", file, *options, "-o", self.dir / f"{name}.bin").returncode, 0)
        for one in ("x.bin", "xn.bin"):
            result = cgw("image", "diff", one, "yn.bin", directory=self.dir)
            said = result.stdout.decode()
            self.assertEqual((result.returncode, result.stderr), (1, b""))
            self.assertNotIn("All parameters", said)
            self.assertIn("Without the model of both configurations not all parameters are known.\n", said)
            self.assertIn("What a gateway needs is the same.\n", said)
            self.assertRegex(said, r"configuration id +[0-9a-f]{16} -> [0-9a-f]{16}\n")
            document = json.loads(cgw("image", "diff", one, "yn.bin", "--format", "json", directory=self.dir).stdout)
            self.assertFalse(document["all_parameters_known"])

    def test_fields_of_the_header_are_named(self):
        parts = split(self.image)
        self.write(join(self.image[:54] + b"\1" + self.image[55:64], {**parts, 14: (4, b"12345678")}, 1), "y.bin")
        said = self.diff().stdout.decode()
        for text in ("format ", "1.0 -> 1.1", "header", "section 14", "left out -> 2 records of 4 bytes"):
            self.assertIn(text, said)

    def test_another_version_does_not_hide_a_changed_byte(self):
        at = struct.unpack_from("<I", self.image, 64 + 6 * 12 + 4)[0]
        changed = bytearray(self.image[:at] + b"\x55" + self.image[at + 1:])
        changed[48] = 7
        self.write(signed(changed), "y.bin")
        said = self.diff().stdout.decode()
        self.assertIn("section object_values", said)
        self.assertIn("written by", said)

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
