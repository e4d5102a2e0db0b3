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


class Check(Case):
    def test_what_cgw_writes_has_no_findings_with_strict(self):
        for path in (self.eds, self.dcf):
            result = cgw("eds", "check", "--strict", path)
            self.assertEqual((result.returncode, result.stderr), (0, b""), result.stdout)
            self.assertIn(b"valid, no findings", result.stdout)
        generic = self.dir / "CANopenGateway.eds"
        self.assertEqual(cgw("emit", "eds", "--generic", "-o", generic).returncode, 0)
        self.assertEqual(cgw("eds", "check", "--strict", generic).returncode, 0)

    def test_findings_have_file_line_and_column(self):
        path = self.changed(b"AccessType=ro", b"AccessType=RO", "CANopenGateway.eds")
        line = path.read_bytes().split(b"AccessType=RO")[0].count(b"\n") + 1
        result = cgw("eds", "check", "--format", "concise", path)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual(result.stdout, b"%s:%d:12: warning: AccessType is `RO`; CiA 306 writes ro "
                         b"[E0859 eds-access-case]\n" % (str(path).encode(), line))

    def test_strict_and_werror_make_errors_of_it(self):
        path = self.changed(b"AccessType=ro", b"AccessType=RO", "CANopenGateway.eds")
        for option in ("--strict", "--werror"):
            result = cgw("eds", "check", option, path)
            self.assertEqual(result.returncode, 1)
            self.assertIn(b"not valid, 1 error", result.stdout)
            self.assertIn(b"cgw eds fix can make 1 safe repair", result.stdout)
        self.assertEqual(cgw("eds", "check", "--strict", "-W", "no-eds-access-case", path).returncode, 0)

    def test_all_files_are_checked_whatever_the_first_ones_hold(self):
        result = cgw("eds", "check", "--format", "json", self.dir / "none.eds", self.eds, "-", stdin=b"nothing")
        self.assertEqual(result.returncode, 3)
        report = json.loads(result.stdout)
        self.assertEqual([len(file["diagnostics"]) for file in report["files"]], [1, 0, 1])
        self.assertEqual([file["path"] for file in report["files"]][1:], [str(self.eds), "-"])

    def test_standard_input_has_no_file_name_to_compare_with(self):
        result = cgw("eds", "check", "-", stdin=self.eds.read_bytes())
        self.assertEqual((result.returncode, result.stdout), (0, b"<stdin>: valid, no findings\n"))

    def test_a_node_id_decides_which_identifiers_meet(self):
        text = self.eds.read_bytes().replace(b"DefaultValue=$NODEID+0x200", b"DefaultValue=0x00000185")
        for node, code in (("5", 1), ("6", 0)):
            result = cgw("eds", "check", "--node-id", node, "--format", "concise", "-", stdin=text)
            self.assertEqual(result.returncode, code, result.stdout)
        for node in ("0", "128", "x"):
            self.assertEqual(cgw("eds", "check", "--node-id", node, self.eds).returncode, 2)

    def test_sarif_and_github_work_as_for_parameter_files(self):
        path = self.changed(b"AccessType=ro", b"AccessType=RO")
        sarif = json.loads(cgw("eds", "check", "--format", "sarif", path).stdout)
        self.assertIn("E0859", [result["ruleId"] for result in sarif["runs"][0]["results"]])
        self.assertIn(b"::warning file=", cgw("eds", "check", "--format", "github", path).stdout)


class Fix(Case):
    def setUp(self):
        super().setUp()
        self.broken = self.changed(b"AccessType=ro", b"AccessType=RO", "CANopenGateway.eds")

    def test_the_repaired_file_is_the_one_it_was(self):
        out = self.dir / "out"
        out.mkdir()
        result = cgw("eds", "fix", self.broken, "-o", out / "CANopenGateway.eds")
        self.assertEqual((result.returncode, result.stdout), (0, b""))
        self.assertIn(b":12: repaired: RO becomes ro [E0859 eds-access-case]", result.stderr)
        self.assertEqual((out / "CANopenGateway.eds").read_bytes(), self.eds.read_bytes())

    def test_in_place_keeps_a_symbolic_link(self):
        link = self.dir / "links" / "CANopenGateway.eds"
        link.parent.mkdir()
        link.symlink_to(self.broken)
        self.assertEqual(cgw("eds", "fix", link, "--in-place").returncode, 0)
        self.assertTrue(link.is_symlink())
        self.assertEqual(self.broken.read_bytes(), self.eds.read_bytes())

    def test_in_place_changes_the_file_and_a_second_run_nothing(self):
        self.assertEqual(cgw("eds", "fix", self.broken, "--in-place").returncode, 0)
        self.assertEqual(self.broken.read_bytes(), self.eds.read_bytes())
        before = self.broken.stat().st_mtime_ns
        result = cgw("eds", "fix", self.broken, "--in-place")
        self.assertIn(b"nothing to repair", result.stderr)
        self.assertEqual(self.broken.stat().st_mtime_ns, before)

    def test_check_writes_nothing_and_says_whether_there_is_something_to_do(self):
        before = self.broken.read_bytes()
        result = cgw("eds", "fix", self.broken, "--check")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"to repair: RO becomes ro", result.stderr)
        self.assertEqual(self.broken.read_bytes(), before)
        self.assertEqual(cgw("eds", "fix", self.eds, "--check").returncode, 0)

    def test_standard_input_goes_to_standard_output(self):
        result = cgw("eds", "fix", "-", "-o", "-", stdin=self.broken.read_bytes())
        self.assertEqual((result.returncode, result.stdout), (0, self.eds.read_bytes()))

    def test_the_file_name_inside_becomes_the_one_outside(self):
        result = cgw("eds", "fix", self.eds, "-o", self.dir / "other.eds")
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"FileName=CANopenGateway.eds becomes other.eds", result.stderr)
        self.assertIn(b"FileName=other.eds\r\n", (self.dir / "other.eds").read_bytes())

    def test_nothing_is_written_where_it_is_not_certain_what_the_file_says(self):
        path = self.changed(b"AccessType=ro", b"AccessType=RO\r\nAccessType=rw", "twice.eds")
        before = path.read_bytes()
        result = cgw("eds", "fix", path, "--in-place")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0805 eds-key-twice", result.stderr)
        self.assertIn(b"nothing is repaired", result.stderr)
        self.assertEqual(path.read_bytes(), before)

    def test_what_cannot_be_written_is_not_told_as_repaired(self):
        result = cgw("eds", "fix", self.broken, "-o", self.dir / "none" / "CANopenGateway.eds")
        self.assertEqual(result.returncode, 3)
        self.assertNotIn(b"repaired", result.stderr)

    def test_one_thing_is_asked_for_and_no_other_file_overwritten(self):
        other = self.dir / "other.eds"
        other.write_bytes(b"")
        for arguments in ([], ["--check", "--in-place"], ["-o", self.broken], ["-o", other]):
            result = cgw("eds", "fix", self.broken, *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
        self.assertEqual(cgw("eds", "fix", "-", "--in-place", stdin=b"").returncode, 2)
        self.assertEqual(cgw("eds", "fix", self.broken, "-o", other, "--force").returncode, 0)


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


class Import(Case):
    def test_a_data_sheet_becomes_a_parameter_file_that_says_what_is_missing(self):
        out = self.dir / "plant.toml"
        result = cgw("import", "eds", self.dcf, "-o", out)
        self.assertEqual((result.returncode, result.stdout), (1, b""), result.stderr)
        self.assertIn(b"does not say: nodes and bit rate of CAN1", result.stderr)
        self.assertIn(b"E0109", result.stderr)
        text = out.read_text()
        self.assertIn("# - nodes and bit rate of CAN1", text)
        self.assertIn('"427 CanOpenMyNodeID" = 12', text)

    def test_with_what_was_missing_added_the_file_is_valid(self):
        minimal = self.plants / "minimal" / "CANopenGateway.dcf"
        out = self.dir / "plant.toml"
        self.assertEqual(cgw("import", "eds", minimal, "-o", out).returncode, 1)
        text = out.read_text()
        text = text.replace("[governor.parameters]", "[governor.parameters]\n401 = 1\n403 = 1\n416 = 250", 1)
        text = text.replace("[gateway.parameters]", "[gateway.parameters]\n401 = 1\n402 = 1\n416 = 250", 1)
        out.write_text(text)
        self.assertEqual(cgw("check", out).returncode, 0, cgw("check", out).stdout)
        self.assertEqual(cgw("eds", "diff", out, minimal).returncode, 0)

    def test_refuses_other_devices_and_existing_files(self):
        other = self.changed(b"DefaultValue=0x00001B59", b"DefaultValue=0x00001B5A")
        result = cgw("import", "eds", other)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"not the EDS, DCF, XDD or XDC of a CANopen Gateway", result.stderr)
        self.assertEqual(cgw("import", "eds", GENSET).returncode, 1)
        out = self.dir / "there.toml"
        out.write_text("precious")
        self.assertEqual(cgw("import", "eds", self.dcf, "-o", out).returncode, 2)
        self.assertEqual(out.read_text(), "precious")
        self.assertEqual(cgw("import", "eds", self.dir / "none.eds").returncode, 3)


    def test_the_rest_comes_from_a_parameter_file(self):
        out = self.dir / "new.toml"
        result = cgw("import", "eds", self.dcf, "--rest-from", GENSET, "-o", out)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual(cgw("diff", GENSET, out).returncode, 0)
        other = self.dir / "other.toml"
        other.write_text(pathlib.Path(GENSET).read_text().replace("CanOpenMyNodeID = 12", "CanOpenMyNodeID = 13"))
        result = cgw("import", "eds", self.dcf, "--rest-from", other)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.decode(), f"{self.dcf}: contradicts --rest-from: gateway 427 CanOpenMyNodeID: 12, not 13\n")
        self.assertIn(b'"427 CanOpenMyNodeID" = 12\n', result.stdout)

    def test_a_rest_that_is_not_valid_or_not_there(self):
        bad = SAMPLES / "bad" / "crossed-node-numbers.toml"
        result = cgw("import", "eds", self.dcf, "--rest-from", bad)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertEqual(cgw("import", "eds", self.dcf, "--rest-from", self.dir / "none.toml").returncode, 3)
        self.assertEqual(cgw("import", "eds", "-", "--rest-from", "-").returncode, 2)
        plant = self.dir / "plant.toml"
        plant.write_bytes(pathlib.Path(GENSET).read_bytes())
        self.assertEqual(cgw("import", "eds", self.dcf, "--rest-from", plant, "-o", plant, "--force").returncode, 2)


class Verify(Case):
    def test_the_artefacts_of_a_plant_are_proved(self):
        dbc = self.plants / "genset" / "CANopenGateway.dbc"
        arguments = ["verify", GENSET, "--eds", self.eds, "--eds", self.dcf, "--image", self.image, "--dbc", dbc]
        result = cgw(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""), result.stdout)
        self.assertEqual(result.stdout.count(b": the same; "), 4)
        self.assertLessEqual(max(len(line) for line in result.stdout.decode().splitlines()
                                 if str(self.plants) not in line), 80)
        document = json.loads(cgw(*arguments, "--format", "json").stdout)
        jsonschema.validate(document, json.loads((SCHEMAS / "proof-report.schema.json").read_text()))
        self.assertEqual([a["kind"] for a in document["artefacts"]], ["EDS", "DCF", "image", "DBC"])

    def test_one_changed_artefact_is_told(self):
        changed = self.changed(b"VendorNumber=0x00000161", b"VendorNumber=0x00000162")
        result = cgw("verify", GENSET, "--eds", changed, "--image", self.image)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"E0871", result.stderr)
        self.assertIn(b"vendor number: 0x162, not 0x161", result.stdout)
        document = json.loads(cgw("verify", GENSET, "--eds", changed, "--format", "json").stdout)
        jsonschema.validate(document, json.loads((SCHEMAS / "proof-report.schema.json").read_text()))
        self.assertFalse(document["same"])
        self.assertEqual(document["artefacts"][0]["differences"][0]["aspect"], "vendor-number")

    def test_a_database_with_other_nodes_or_formats_differs(self):
        text = (self.plants / "genset" / "CANopenGateway.dbc").read_bytes()
        for old, new, aspect in ((b"BU_: GW12", b"BU_: GW13", "node"),
                                 (b'BA_ "VFrameFormat" BO_ 396 0;', b'BA_ "VFrameFormat" BO_ 396 1;', "message-format")):
            self.assertIn(old, text)
            changed = self.dir / "changed.dbc"
            changed.write_bytes(text.replace(old, new))
            result = cgw("verify", GENSET, "--dbc", changed, "--format", "json")
            self.assertEqual(result.returncode, 1)
            differences = json.loads(result.stdout)["artefacts"][0]["differences"]
            self.assertEqual([difference["aspect"] for difference in differences], [aspect])

    def test_the_gateway_is_no_manager_of_the_network(self):
        dcf = self.dir / "CANopenGateway.dcf"
        text = cgw("emit", "dcf", GENSET).stdout
        for old, new, aspect in ((b"CANopenManager=0", b"CANopenManager=1", "manager"), (b"NodeID=12", b"NodeID=13", "node-id"),
                                 (b"Baudrate=250", b"Baudrate=125", "bit-rate")):
            self.assertEqual(text.count(old), 1)
            dcf.write_bytes(text.replace(old, new))
            result = cgw("verify", GENSET, "--eds", dcf, "--format", "json")
            self.assertEqual(result.returncode, 1)
            differences = json.loads(result.stdout)["artefacts"][0]["differences"]
            self.assertIn(aspect, [difference["aspect"] for difference in differences])

    def test_an_xdd_that_contradicts_itself_fails(self):
        xdd = self.dir / "plant.xdd"
        xdd.write_bytes(cgw("emit", "xdd", GENSET).stdout)
        self.assertEqual(cgw("verify", GENSET, "--eds", xdd).returncode, 0)
        for old, new, rule in ((b'<co:defaultValue value="0x00000681"', b'<co:defaultValue value="0x00000682"', b"E0912"),
                               (b'subNumber="5"', b'subNumber="99"', b"E0916"),
                               (b'subIndex="01" name="COB-ID" objectType="7"', b'subIndex="01" name="COB-ID" objectType="8"', b"E0917")):
            text = cgw("emit", "xdd", GENSET).stdout
            self.assertIn(old, text)
            xdd.write_bytes(text.replace(old, new, 1))
            result = cgw("verify", GENSET, "--eds", xdd)
            self.assertEqual(result.returncode, 1)
            self.assertIn(rule, result.stderr)

    def test_what_strict_importers_refuse_fails_though_nothing_differs(self):
        refused = self.changed(b"AccessType=rww", b"AccessType=rw")
        self.assertEqual(cgw("eds", "check", refused).returncode, 0)
        result = cgw("verify", GENSET, "--eds", refused)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"  strict importers refuse it: 1 error\n", result.stdout)
        document = json.loads(cgw("verify", GENSET, "--eds", refused, "--format", "json").stdout)
        jsonschema.validate(document, json.loads((SCHEMAS / "proof-report.schema.json").read_text()))
        self.assertEqual(document["artefacts"][0]["strict_errors"], 1)

    def test_an_entry_that_stands_twice_in_a_list_fails(self):
        twice = self.changed(b"[MandatoryObjects]\r\nSupportedObjects=3\r\n1=0x1000\r\n",
                             b"[MandatoryObjects]\r\nSupportedObjects=3\r\n1=0x1000\r\n1=0x1000\r\n")
        result = cgw("verify", GENSET, "--eds", twice)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"E0805 eds-key-twice", result.stderr)

    def test_a_file_that_is_too_large_is_a_finding_in_every_verb(self):
        large = self.dir / "large.eds"
        with large.open("wb") as file:
            file.truncate(32 * 1024 * 1024 + 1)
        for arguments in (("eds", "check", large), ("eds", "fix", large, "--check"), ("eds", "diff", large, self.eds),
                          ("convert", large, "--to", "json"), ("import", "eds", large), ("verify", GENSET, "--eds", large),
                          ("verify", GENSET, "--image", large), ("verify", GENSET, "--dbc", large), ("check", large)):
            result = cgw(*arguments)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertRegex((result.stderr + result.stdout).decode(), r"is\s+larger\s+than", arguments)

    def test_what_cannot_be_read_or_is_refused(self):
        cut = self.dir / "cut.bin"
        cut.write_bytes(self.image.read_bytes()[:-1])
        result = cgw("verify", GENSET, "--image", cut, "--eds", self.eds)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"E0712", result.stderr)
        self.assertIn(b"status 6", result.stderr)
        self.assertIn(b"the same", result.stdout)
        self.assertEqual(cgw("verify", GENSET, "--dbc", self.dir / "none.dbc").returncode, 3)
        wrong = cgw("verify", SAMPLES / "bad" / "crossed-node-numbers.toml", "--eds", self.eds)
        self.assertEqual((wrong.returncode, wrong.stdout), (1, b""))

    def test_wrong_usage(self):
        for arguments in ((), ("--eds", self.eds, "--live", "hub:127.0.0.1:1"), ("--eds", self.eds, "--read-only"),
                          ("--eds", "-", "--dbc", "-")):
            result = cgw("verify", GENSET, *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)


if __name__ == "__main__":
    unittest.main()
