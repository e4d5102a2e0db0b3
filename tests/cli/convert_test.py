"""cgw convert from outside: exit codes, both streams, what is written and what is not."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
DATA = pathlib.Path(os.environ["CGW_TEST_DATA"])
SCHEMA = json.loads((SAMPLES.parent / "schemas" / "device-description.schema.json").read_text())
DEVICE = DATA / "convert" / "io-device.eds"
GENSET = SAMPLES / "genset.toml"


def cgw(*arguments, stdin=None):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "SOURCE_DATE_EPOCH")}
    return subprocess.run([CGW, *map(str, arguments)], input=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=clean, timeout=120)


class Convert(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-convert-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def expect(self, result, code, error=b""):
        self.assertEqual(result.returncode, code, result.stderr)
        if isinstance(error, bytes):
            self.assertEqual(result.stderr, error)
        else:
            for part in error:
                self.assertIn(part, result.stderr.decode())

    def test_the_ending_says_what_to_make(self):
        result = cgw("convert", DEVICE, "-o", self.dir / "a.xdd")
        self.expect(result, 0, b"not carried over: [Tools]\nxdd does not hold: links between objects (ObjectLinks) (1)\n")
        self.assertEqual(result.stdout, b"")
        self.assertIn(b"fileName=\"a.xdd\"", (self.dir / "a.xdd").read_bytes())
        self.assertIn(b"<ISO15745ProfileContainer", cgw("convert", DEVICE, "--to", "xdd").stdout)
        self.assertEqual(cgw("convert", "-", "--to", "csv", stdin=DEVICE.read_bytes()).stdout,
                         cgw("convert", DEVICE, "--to", "csv").stdout)

    def test_a_file_that_exists_is_not_overwritten(self):
        target = self.dir / "a.xdd"
        target.write_text("mine")
        result = cgw("convert", DEVICE, "-o", target)
        self.expect(result, 2, [f"{target} exists; --force overwrites it"])
        self.assertEqual(target.read_text(), "mine")
        self.expect(cgw("convert", DEVICE, "-o", target, "--force"), 0, ["ObjectLinks"])
        self.assertNotEqual(target.read_text(), "mine")

    def test_what_is_not_carried_over_is_told_with_counts(self):
        text = DEVICE.read_text()
        odd = self.dir / "odd.eds"
        odd.write_text("; by hand\n" + text.replace("[1017]\n", "[1017]\nUnit=ms\n", 1).replace("[1017]\r\n", "[1017]\r\nUnit=ms\r\n", 1))
        self.expect(cgw("convert", odd, "--to", "dcf", "--node-id", 5), 0,
                    ["not carried over: key Unit (1)\n", "not carried over: lines of comment (1)\n"])
        dcf = self.dir / "odd.dcf"
        self.expect(cgw("convert", odd, "-o", dcf, "--node-id", 5), 0, ["key Unit"])
        self.assertIn(b"[Tools]\r\n", dcf.read_bytes())
        self.expect(cgw("convert", dcf, "--to", "csv"), 0, ["not carried over: [Tools]\n"])
        xml = self.dir / "a.xdd"
        xml.write_bytes(cgw("convert", DEVICE, "--to", "xdd").stdout.replace(
            b"</label>", b"</label><description lang=\"en\">d</description>", 3))
        self.expect(cgw("convert", xml, "--to", "json"), 0, ["not carried over: element description (3)\n"])

    def test_a_node_number_without_use_is_refused(self):
        self.expect(cgw("convert", DEVICE, "--to", "json", "--node-id", 5), 2, ["--node-id is for formats"])
        cgw("convert", DEVICE, "-o", self.dir / "a.dcf", "--node-id", 5)
        cgw("convert", DEVICE, "-o", self.dir / "b.dcf", "--node-id", 6)
        self.expect(cgw("eds", "diff", self.dir / "a.dcf", self.dir / "b.dcf", "--node-id", 5), 2, ["both state theirs"])
        self.expect(cgw("eds", "diff", DEVICE, self.dir / "b.dcf", "--node-id", 5), 2, ["is about node 6"])
        large = self.dir / "large.eds"
        large.write_text(DEVICE.read_text().replace("$NODEID+0x180", "$NODEID+0xFFFFFFFF"))
        line = large.read_text()[:large.read_text().index("$NODEID+0xFFFFFFFF")].count("\n") + 1
        result = cgw("convert", large, "-o", self.dir / "c.dcf", "--node-id", 5)
        self.expect(result, 1, [f"large.eds:{line}:14: error: ", "[E0807"])
        self.assertIn("1800h:1: a formula with $NODEID makes too large a number", " ".join(result.stderr.decode().split()))
        self.assertFalse((self.dir / "c.dcf").exists())

    def test_a_concise_dcf_without_entries_is_told(self):
        result = cgw("convert", DEVICE, "--to", "concise-dcf", "--node-id", 5)
        self.expect(result, 0, ["the list has no entries: no value differs from its default\n"])
        self.assertEqual(result.stdout, bytes(4))
        self.expect(cgw("convert", DEVICE, "--to", "concise-dcf"), 2, ["--node-id is needed"])

    def test_tables_tell_what_they_leave_out(self):
        text = DEVICE.read_text()
        modular = self.dir / "modular.eds"
        modular.write_text(text + "\n[SupportedModules]\nNrOfEntries=1\n[M1ModuleInfo]\nProductName=DI\n")
        self.expect(cgw("convert", modular, "--to", "md"), 0, ["md does not hold: modules of a modular device (1)\n"])
        self.expect(cgw("convert", modular, "--to", "csv"), 0,
                    ["csv does not hold: modules of a modular device (1)\n",
                     "csv does not hold: vendor, product and features of the device (1)\n"])
        self.assertNotIn(b"LastEDS", cgw("convert", DEVICE, "--to", "xdc", "--node-id", 5).stderr)

    def test_other_files_with_the_ending_of_xml_are_told_as_such(self):
        other = self.dir / "board.xdc"
        other.write_text("set_property PACKAGE_PIN W5 [get_ports clk]\n")
        result = cgw("convert", other, "--to", "eds")
        self.assertEqual(result.returncode, 1)
        self.assertIn("FPGA design constraints", " ".join(result.stderr.decode().split()))
        empty = self.dir / "empty.XDD"
        empty.write_text("")
        self.assertIn("the file is no XML", " ".join(cgw("convert", empty, "--to", "eds").stderr.decode().split()))

    def test_utf_16_is_told(self):
        wide = self.dir / "wide.xdd"
        wide.write_bytes(cgw("convert", DEVICE, "--to", "xdd").stdout.decode().encode("utf-16"))
        self.expect(cgw("convert", wide, "--to", "eds"), 1, ["the file is UTF-16; save it as UTF-8"])

    def test_there_and_back_describes_the_same_device(self):
        self.expect(cgw("convert", DEVICE, "-o", self.dir / "a.xdd"), 0, ["ObjectLinks"])
        self.expect(cgw("convert", self.dir / "a.xdd", "-o", self.dir / "b.eds"), 0)
        differences = cgw("eds", "diff", DEVICE, self.dir / "b.eds", "--format", "json")
        self.assertEqual([d["aspect"] for d in json.loads(differences.stdout)["differences"]], ["links"])

    def test_a_node_needs_its_number(self):
        result = cgw("convert", DEVICE, "-o", self.dir / "a.dcf")
        self.expect(result, 2, ["--node-id is needed"])
        self.assertFalse((self.dir / "a.dcf").exists())
        result = cgw("convert", DEVICE, "-o", self.dir / "a.dcf", "--node-id", 5)
        self.expect(result, 0, ["resolved for node 5: $NODEID in default values (3)"])
        self.assertIn(b"ParameterValue=0x00000185\r\n", (self.dir / "a.dcf").read_bytes())
        self.expect(cgw("convert", self.dir / "a.dcf", "-o", self.dir / "a.xdc"), 0,
                    ["xdc does not hold: name of the data sheet"])
        self.expect(cgw("convert", self.dir / "a.dcf", "--to", "xdc", "--node-id", 6), 2, ["about node 5"])
        self.expect(cgw("convert", self.dir / "a.xdc", "-o", self.dir / "b.eds"), 0, ["values that one node is given"])

    def test_a_concise_dcf_has_what_a_manager_writes(self):
        self.expect(cgw("convert", DEVICE, "--to", "concise-dcf"), 2, ["--node-id is needed"])
        cgw("convert", DEVICE, "-o", self.dir / "a.dcf", "--node-id", 5)
        self.assertEqual(cgw("convert", self.dir / "a.dcf", "--to", "concise-dcf").stdout, bytes(4))
        text = (self.dir / "a.dcf").read_text()
        section = text.index("[1800sub2]")
        changed = text[:section] + text[section:].replace("ParameterValue=0xFF", "ParameterValue=0xFE", 1)
        (self.dir / "b.dcf").write_text(changed)
        result = cgw("convert", self.dir / "b.dcf", "-o", self.dir / "b.cdcf")
        self.expect(result, 0, ["[Tools]"] if "[Tools]" in text else b"")
        expected = struct.pack("<I", 3)
        for index, sub, data in ((0x1800, 1, struct.pack("<I", 0x80000185)), (0x1800, 2, b"\xFE"),
                                 (0x1800, 1, struct.pack("<I", 0x185))):
            expected += struct.pack("<HBI", index, sub, len(data)) + data
        self.assertEqual((self.dir / "b.cdcf").read_bytes(), expected)

    def test_json_keeps_to_its_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        for arguments in ([DEVICE], [DATA / "eds" / "printed.eds"]):
            result = cgw("convert", *arguments, "--to", "json")
            jsonschema.validate(json.loads(result.stdout), SCHEMA)
        cgw("convert", DEVICE, "-o", self.dir / "a.dcf", "--node-id", 5)
        document = json.loads(cgw("convert", self.dir / "a.dcf", "--to", "json").stdout)
        jsonschema.validate(document, SCHEMA)
        self.assertEqual(document["node"]["node_id"], 5)
        values = {(o["index"], v["sub_index"]): v["value"] for o in document["objects"] for v in o["variables"]}
        self.assertEqual(values[(0x1014, 0)], "0x00000085")
        self.assertIsNone(values[(0x6000, 1)])

    def test_what_does_not_fit_is_refused(self):
        self.expect(cgw("convert", DEVICE), 2, ["--to is missing"])
        self.expect(cgw("convert", DEVICE, "-o", self.dir / "a.txt"), 2, ["names no format"])
        self.expect(cgw("convert", DEVICE, "--to", "html"), 2, ["html"])
        self.expect(cgw("convert", DEVICE, "-o", DEVICE), 2, ["io-device.eds"])
        self.expect(cgw("convert", DEVICE, "--to", "eds", "--node-id", 128), 2, ["1 to 127"])
        self.expect(cgw("convert", GENSET, "--to", "eds"), 2, ["is a parameter file; cgw emit"])
        cgw("emit", "image", GENSET, "-o", self.dir / "a.bin")
        self.expect(cgw("convert", self.dir / "a.bin", "--to", "eds"), 2, ["is a configuration image"])
        self.expect(cgw("convert", self.dir / "none.eds", "--to", "xdd"), 3, ["none.eds"])
        self.expect(cgw("convert", DEVICE, "-o", self.dir / "none" / "a.xdd"), 3, ["none"])

    def test_a_file_with_errors_is_refused(self):
        broken = self.dir / "broken.eds"
        broken.write_bytes(DEVICE.read_bytes().replace(b"DataType=0x0008", b"DataType=0x0099", 1))
        result = cgw("convert", broken, "-o", self.dir / "a.xdd")
        self.expect(result, 1, ["E0811", "broken.eds has errors; nothing is written"])
        self.assertFalse((self.dir / "a.xdd").exists())
        xml = self.dir / "broken.xdd"
        xml.write_bytes(cgw("convert", DEVICE, "--to", "xdd").stdout.replace(b'accessType="ro"', b'accessType="rx"', 1))
        self.expect(cgw("convert", xml, "--to", "eds"), 1, ["broken.xdd:", "E0909"])
        (self.dir / "board.xdc").write_text("set_property PACKAGE_PIN W5 [get_ports clk]\n")
        self.assertEqual(cgw("convert", self.dir / "board.xdc", "--to", "eds").returncode, 1)


if __name__ == "__main__":
    unittest.main()
