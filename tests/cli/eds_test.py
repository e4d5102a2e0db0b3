"""The verbs of cgw eds from outside: exit codes, both streams, what is written and what is not."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
SCHEMAS = SAMPLES.parent / "schemas"
GENSET = SAMPLES / "genset.toml"
MINIMAL = SAMPLES / "minimal.toml"


def cgw(*arguments, stdin=None):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "SOURCE_DATE_EPOCH")}
    return subprocess.run([CGW, *map(str, arguments)], input=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=clean, timeout=120)


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.plants = pathlib.Path(tempfile.mkdtemp(prefix="cgw-eds-"))
        cls.addClassCleanup(shutil.rmtree, cls.plants)
        for sample in (GENSET, MINIMAL):
            built = cgw("build", sample, "-o", cls.plants / sample.stem)
            assert built.returncode == 0, built.stderr

    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-eds-"))
        self.addCleanup(shutil.rmtree, self.dir)
        self.eds = self.plants / "genset" / "CANopenGateway.eds"
        self.dcf = self.plants / "genset" / "CANopenGateway.dcf"
        self.image = self.plants / "genset" / "gateway-config.bin"

    def changed(self, before, after, name="changed.eds"):
        """The data sheet of the sample with one text in it replaced."""
        text = self.eds.read_bytes()
        self.assertIn(before, text)
        path = self.dir / name
        path.write_bytes(text.replace(before, after, 1))
        return path


class Diff(Case):
    def test_all_descriptions_of_one_gateway_are_the_same(self):
        for a in (GENSET, self.eds, self.dcf, self.image):
            for b in (GENSET, self.eds, self.dcf, self.image):
                result = cgw("eds", "diff", a, b)
                self.assertEqual((result.returncode, result.stderr), (0, b""), (a, b, result.stdout))
                self.assertIn(b"Both describe the same device.", result.stdout)

    def test_another_plant_differs(self):
        other = self.plants / "minimal" / "CANopenGateway.eds"
        for kind in (GENSET, self.eds, self.dcf, self.image):
            result = cgw("eds", "diff", kind, other)
            self.assertEqual((result.returncode, result.stderr), (1, b""))
            self.assertIn(b"1016h:1", result.stdout)

    def test_what_is_written_otherwise_and_means_the_same_does_not_differ(self):
        same = self.changed(b"VendorNumber=", b"; a comment\r\nvendornumber =")
        result = cgw("eds", "diff", self.eds, same)
        self.assertEqual((result.returncode, result.stdout.splitlines()[-1]), (0, b"Both describe the same device."))

    def test_node_number_resolves_formulas(self):
        fixed = self.changed(b"$NODEID+0x180", b"0x18C")
        self.assertEqual(cgw("eds", "diff", self.eds, fixed).returncode, 1)
        self.assertEqual(cgw("eds", "diff", "--node-id", 12, self.eds, fixed).returncode, 0)
        self.assertEqual(cgw("eds", "diff", "--node-id", 13, self.eds, fixed).returncode, 1)
        self.assertEqual(cgw("eds", "diff", GENSET, fixed).returncode, 0)

    def test_json_keeps_to_its_schema(self):
        schema = json.loads((SCHEMAS / "eds-diff-report.schema.json").read_text())
        for a, b, same in ((GENSET, self.image, True), (self.eds, MINIMAL, False), (self.image, MINIMAL, False)):
            result = cgw("eds", "diff", a, b, "--format", "json")
            document = json.loads(result.stdout)
            jsonschema.validate(document, schema)
            self.assertEqual(document["same"], same)
            self.assertEqual(result.returncode, 0 if same else 1)
        self.assertEqual(document["a"]["kind"], "image")
        self.assertIn("names", document["not_compared"])

    def test_one_difference_is_told_in_every_format(self):
        other = self.changed(b"VendorNumber=0x00000161", b"VendorNumber=0x00000162")
        document = json.loads(cgw("eds", "diff", self.eds, other, "--format", "json").stdout)
        self.assertEqual([d["aspect"] for d in document["differences"]], ["vendor-number"])
        self.assertIn(b"0x161 -> 0x162", cgw("eds", "diff", self.eds, other).stdout)
        self.assertIn(b"| device | vendor number | 0x161 | 0x162 |",
                      cgw("eds", "diff", self.eds, other, "--format", "md").stdout)

    def test_a_file_with_errors_is_refused_with_its_place(self):
        twice = self.dir / "twice.eds"
        twice.write_bytes(self.eds.read_bytes() + b"[1000]\r\nParameterName=Again\r\n")
        result = cgw("eds", "diff", self.eds, twice)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0804", result.stderr)
        self.assertIn(b"twice.eds:", result.stderr)

    def test_standard_input_and_what_cannot_be_read(self):
        result = cgw("eds", "diff", "-", self.eds, stdin=self.eds.read_bytes())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(cgw("eds", "diff", "-", "-", stdin=b"").returncode, 2)
        missing = cgw("eds", "diff", self.eds, self.dir / "none.eds")
        self.assertEqual((missing.returncode, missing.stdout), (3, b""))
        self.assertIn(b"E0001", missing.stderr)

    def test_wrong_options_are_usage_errors(self):
        for arguments in (("--node-id", "0"), ("--node-id", "128"), ("--node-id", "x"), ("--format", "xml")):
            result = cgw("eds", "diff", self.eds, self.eds, *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)

    def test_a_full_disk_is_told(self):
        with open("/dev/full", "wb") as full:
            result = subprocess.run([CGW, "eds", "diff", self.eds, self.dcf], stdout=full, stderr=subprocess.PIPE,
                                    timeout=60)
        self.assertEqual(result.returncode, 3)


if __name__ == "__main__":
    unittest.main()
