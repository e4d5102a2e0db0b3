"""cgw import table, diff and clone from outside: exit codes, both streams, what is written and what is not."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
DATA = pathlib.Path(os.environ["CGW_TEST_DATA"])
SCHEMAS = SAMPLES.parent / "schemas"
GENSET = SAMPLES / "genset.toml"
MINIMAL = SAMPLES / "minimal.toml"
MANUAL = SAMPLES / "manual-example.toml"
GATEWAY_TABLE = DATA / "tables" / "manual-gateway.tabs.txt"


def cgw(*arguments, stdin=None):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "SOURCE_DATE_EPOCH")}
    return subprocess.run([CGW, *map(str, arguments)], input=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=clean, timeout=120)


class Case(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-tables-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def write(self, name, text):
        path = self.dir / name
        path.write_text(text)
        return path

    def governor_table(self, edit=lambda text: text):
        """The manual's table, with the dots removed."""
        lines = (DATA / "tables" / "manual-governor.blanks.txt").read_text().splitlines()
        return self.write("governor.txt", edit("\n".join(l for l in lines if not l.startswith(":")) + "\n"))

    def listing(self):
        return sorted(p.name for p in self.dir.iterdir())


class ImportTable(Case):
    def test_the_manuals_tables_become_the_manuals_sample(self):
        out = self.dir / "plant.toml"
        result = cgw("import", "table", "--governor", self.governor_table(), "--gateway", GATEWAY_TABLE, "-o", out,
                     "--title", "Manual DG 04005-e, chapter 7")
        self.assertEqual((result.returncode, result.stdout), (0, b""), result.stderr)
        self.assertEqual(result.stderr.count(b"manual-misprint"), 3)
        same = cgw("diff", MANUAL, out)
        self.assertEqual((same.returncode, same.stderr), (0, b""), same.stdout)

    def test_a_table_with_dots_is_refused_and_nothing_written(self):
        out = self.dir / "plant.toml"
        result = cgw("import", "table", "--governor", DATA / "tables" / "manual-governor.tabs.txt", "--gateway",
                     GATEWAY_TABLE, "-o", out)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        text = b" ".join(result.stderr.split())  # where lines break depends on the length of the path
        self.assertIn(b"manual-governor.tabs.txt:24:1: error: dots stand for rows", text)
        self.assertEqual(self.listing(), [])

    def test_a_plant_that_is_wrong_as_found_is_written_with_its_findings(self):
        out = self.dir / "plant.toml"
        table = self.governor_table(lambda text: text.replace("CanCMNodeNumber             1", "CanCMNodeNumber 2"))
        result = cgw("import", "table", "--governor", table, "--gateway", GATEWAY_TABLE, "-o", out)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0201 hzm-node-mismatch", result.stderr)
        self.assertIn(b"says what the tables say, and is not valid as it stands", result.stderr)
        self.assertIn('"403 CanCMNodeNumber" = 2', out.read_text())

    def test_standard_output_and_input_work_and_the_file_is_valid(self):
        table = self.governor_table().read_bytes()
        result = cgw("import", "table", "--governor", "-", "--gateway", GATEWAY_TABLE, stdin=table)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(cgw("check", "-", stdin=result.stdout).returncode, 0)

    def test_a_file_that_exists_is_overwritten_only_when_told(self):
        out = self.write("plant.toml", "mine")
        tables = ["--governor", self.governor_table(), "--gateway", GATEWAY_TABLE, "-o", out]
        result = cgw("import", "table", *tables)
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertIn(b"plant.toml exists; --force overwrites it", result.stderr)
        self.assertEqual(out.read_text(), "mine")
        self.assertEqual(cgw("import", "table", *tables, "--force").returncode, 0)
        self.assertIn("format = 1", out.read_text())

    def test_what_the_tables_do_not_print_is_said_and_written(self):
        out = self.dir / "plant.toml"
        table = self.governor_table(lambda text: text.replace("14401", "# 14401"))
        result = cgw("import", "table", "--governor", table, "--gateway", GATEWAY_TABLE, "-o", out)
        said = b" ".join(result.stderr.split())  # messages are wrapped
        self.assertRegex(said, rb"governor\.txt: note: not printed for the governor, taken as 0: [0-9., ]*14401, ")
        self.assertEqual(result.stderr.count(b"[E0509 table-row-absent]"), 2)
        self.assertRegex(out.read_text(), r"# Governor: not printed, taken as 0:[^\n]* 14401,")
        whole = self.write("sheet.csv", cgw("emit", "entry-sheet", GENSET, "--format", "csv").stdout.decode())
        result = cgw("import", "table", "--governor", whole, "--gateway", whole)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertNotIn(b"taken as 0", result.stdout)

    def test_wrong_usage(self):
        table = self.governor_table()
        before = table.read_bytes()
        for arguments in (["--governor", table], ["--governor", "-", "--gateway", "-"],
                          ["--governor", table, "--gateway", GATEWAY_TABLE, "-o", table],
                          ["--governor", table, "--gateway", GATEWAY_TABLE, "--title", ""],
                          ["--governor", table, "--gateway", GATEWAY_TABLE, "--title", "a\nb"]):
            result = cgw("import", "table", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
            self.assertTrue(result.stderr.startswith(b"cgw: "), result.stderr)
        self.assertEqual(table.read_bytes(), before)

    def test_unreadable_tables_and_unwritable_outputs_exit_3(self):
        table = self.governor_table()
        for arguments in (["--governor", self.dir / "none.txt", "--gateway", GATEWAY_TABLE],
                          ["--governor", table, "--gateway", GATEWAY_TABLE, "-o", self.dir / "no" / "plant.toml"]):
            result = cgw("import", "table", *arguments)
            self.assertEqual((result.returncode, result.stdout), (3, b""), result.stderr)
        self.assertEqual(self.listing(), ["governor.txt"])


class Diff(Case):
    def changed(self):
        return self.write("b.toml", GENSET.read_text().replace("[2000, 2031, 2300, 2918]", "[2000, 0, 2300, 2918]"))

    def test_a_file_and_itself_are_the_same(self):
        result = cgw("diff", GENSET, GENSET)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertTrue(result.stdout.endswith(b"\nNothing differs.\n"), result.stdout)

    def test_differences_exit_1_and_name_the_consequence_in_80_columns(self):
        result = cgw("diff", GENSET, self.changed())
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        text = result.stdout.decode()
        self.assertIn("governor 16401 CanOpTPDO4Assign(1)   2031 -> 0\n", text)
        self.assertIn("2300 ActPos, moved from word 3", text)
        body = [line for line in text.splitlines() if not line.startswith(("A: ", "B: "))]
        self.assertTrue(all(len(line) <= 80 for line in body), text)

    def test_json_keeps_to_its_schema(self):
        schema = json.loads((SCHEMAS / "diff-report.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        for b, same in ((GENSET, True), (self.changed(), False)):
            result = cgw("diff", GENSET, b, "--format", "json")
            document = json.loads(result.stdout)
            jsonschema.validate(document, schema)
            self.assertEqual((document["same"], result.returncode), (same, 0 if same else 1))
        tables = cgw("diff", MANUAL, "--governor", self.governor_table(lambda text: text.replace("14401", "# 14401")),
                     "--gateway", GATEWAY_TABLE, "--format", "json")
        document = json.loads(tables.stdout)
        jsonschema.validate(document, schema)
        self.assertEqual([p["number"] for p in document["not_in_table"]], [14401])
        self.assertIsNone(document["b"]["configuration_id"])

    def test_page_schema_and_code_name_the_same_keys_and_kinds(self):
        schema = json.loads((SCHEMAS / "diff-report.schema.json").read_text())
        page = (SCHEMAS.parent / "docs/command-line.md").read_text().split("\n### diff\n")[1].split("\n### ")[0]
        keys = [key for row in re.findall(r"^\| (`[^|]*) \|", page, re.M) for key in re.findall(r"`(\w+)`", row)]
        self.assertEqual(sorted(keys), sorted(schema["properties"]))
        self.assertEqual(sorted(keys), sorted(json.loads(cgw("diff", GENSET, GENSET, "--format", "json").stdout)))
        for key in ("parameters", "not_printed"):
            items = schema["properties"][key]["items"]
            required = (schema["$defs"]["parameter"] if "$ref" in items else items)["required"]
            row = re.search(rf"^\| `{key}` \| (.*) \|$", page, re.M).group(1)
            self.assertEqual(re.findall(r"`(\w+)`", row)[:len(required)], required)
        sentence = page.split("Kinds of consequences: ")[1].split("Use\n`kind`")[0]
        consequences, otherwise = sentence.split("; otherwise: ")
        wanted = {key: sorted(schema["properties"][key]["items"]["properties"]["kind"]["enum"])
                  for key in ("consequences", "otherwise")}
        self.assertEqual(sorted(re.findall(r"`([a-z-]+)`", consequences)), wanted["consequences"])
        self.assertEqual(sorted(re.findall(r"`([a-z-]+)`", otherwise)), wanted["otherwise"])
        sources = [*(SCHEMAS.parent / "lib/compare").glob("*.cpp"), SCHEMAS.parent / "cli/cgw/verb_image_diff.cpp"]
        code = "".join(path.read_text() for path in sources)
        for kind in wanted["consequences"] + wanted["otherwise"]:
            self.assertIn(f'"{kind}"', code)
        noted = re.findall(r'\bnote\([\w.]+,\s*"([a-z-]+)"', code)
        self.assertGreater(len(noted), 8)
        self.assertLessEqual(set(noted), set(wanted["consequences"] + wanted["otherwise"]))

    def test_a_file_and_tables_as_found(self):
        result = cgw("diff", MANUAL, "--governor", self.governor_table(), "--gateway", GATEWAY_TABLE)
        self.assertEqual((result.returncode, result.stderr), (0, b""), result.stdout)
        other = self.governor_table(lambda text: text.replace("2908", "2907"))
        result = cgw("diff", MANUAL, "--governor", other, "--gateway", GATEWAY_TABLE)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertIn(b"2908 -> 2907", result.stdout)

    def test_only_titles_differ(self):
        b = self.write("b.toml", GENSET.read_text().replace("Genset 2", "Genset 3"))
        result = cgw("diff", GENSET, b)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"\nAll parameters are the same.\n\nOtherwise\n  title", result.stdout)

    def test_findings_of_both_files_go_to_stderr_and_nothing_is_compared(self):
        a = self.write("a.toml", GENSET.read_text().replace("CanOpenMyNodeID = 12", "CanOpenMyNodeID = 200"))
        b = self.write("b.toml", "format = ")
        result = cgw("diff", a, b)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0111", result.stderr)
        self.assertIn(b"E0004", result.stderr)

    def test_a_plant_that_would_fail_is_compared_and_reported(self):
        b = self.write("b.toml", GENSET.read_text().replace("CanOpenMyNodeID = 12", "CanOpenMyNodeID = 1"))
        result = cgw("diff", GENSET, b)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"E0203", result.stderr)
        self.assertIn(b"12 -> 1\n", result.stdout)

    def test_unreadable_exits_3(self):
        result = cgw("diff", GENSET, self.dir / "none.toml")
        self.assertEqual((result.returncode, result.stdout), (3, b""))
        result = cgw("diff", GENSET, "--governor", self.dir / "none.txt", "--gateway", GATEWAY_TABLE)
        self.assertEqual((result.returncode, result.stdout), (3, b""))

    def test_wrong_usage(self):
        for arguments in ([GENSET], [GENSET, MINIMAL, "--governor", GATEWAY_TABLE, "--gateway", GATEWAY_TABLE],
                          [GENSET, "--governor", GATEWAY_TABLE], ["-", "-"]):
            result = cgw("diff", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)


class Clone(Case):
    def test_a_copy_goes_to_standard_output(self):
        result = cgw("clone", MINIMAL, "--node-id", "9")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        expected = MINIMAL.read_text().replace("427 = 1 ", "427 = 9 ")
        self.assertEqual(result.stdout.decode(), expected)

    def test_a_copy_goes_to_a_file_and_never_over_the_original(self):
        original = self.write("a.toml", MINIMAL.read_text())
        copy = self.dir / "b.toml"
        self.assertEqual(cgw("clone", original, "--node-id", "9", "--title", "B", "-o", copy).returncode, 0)
        self.assertIn('title = "B"', copy.read_text())
        result = cgw("clone", original, "--node-id", "9", "-o", original)
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertEqual(original.read_text(), MINIMAL.read_text())

    def test_identifiers_that_would_meet_are_refused_and_nothing_written(self):
        copy = self.dir / "b.toml"
        result = cgw("clone", GENSET, "--node-id", "13", "-o", copy)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertEqual(result.stderr.count(b"E0508 clone-identifier"), 2)
        self.assertEqual(self.listing(), [])
        self.assertIn(b"0x682 is free", result.stderr)
        self.assertIn(b"0x683 is free", result.stderr)
        kept = cgw("clone", GENSET, "--node-id", "13", "--keep-identifiers", "-o", copy)
        self.assertEqual(kept.returncode, 0)
        self.assertEqual(kept.stderr,
                         b"cgw: note: original and copy have the same title; --title gives the copy its own\n")

    def test_new_identifiers_are_given_from_a_start(self):
        copy = self.dir / "b.toml"
        result = cgw("clone", GENSET, "--node-id", "13", "--title", "B", "--identifiers-from", "0x690", "-o", copy)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertIn("CanOpTPDO5-16ID = [0x690, 0x691]", copy.read_text())

    def test_a_file_that_exists_is_overwritten_only_by_force(self):
        copy = self.write("b.toml", "mine")
        arguments = ("clone", MINIMAL, "--node-id", "9", "-o", copy)
        refused = cgw(*arguments)
        self.assertEqual((refused.returncode, refused.stdout), (2, b""))
        self.assertIn(f"{copy} exists; --force overwrites it", refused.stderr.decode())
        self.assertEqual(copy.read_text(), "mine")
        self.assertEqual(cgw(*arguments, "--force").returncode, 0)
        self.assertIn("427 = 9 ", copy.read_text())

    def test_a_copy_that_would_not_be_valid_is_refused(self):
        copy = self.dir / "b.toml"
        result = cgw("clone", GENSET, "--node-id", "11", "--keep-identifiers", "-o", copy)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0204", result.stderr)
        self.assertIn(b"cgw: the copy would not be valid and is not written\n", result.stderr)
        self.assertEqual(self.listing(), [])

    def test_an_original_with_errors_is_refused(self):
        original = self.write("a.toml", MINIMAL.read_text().replace("403 = 1", "403 = 2"))
        result = cgw("clone", original, "--node-id", "9")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"E0201", result.stderr)
        self.assertEqual(cgw("clone", self.dir / "none.toml", "--node-id", "9").returncode, 3)

    def test_wrong_usage(self):
        for arguments in ([MINIMAL], [MINIMAL, "--node-id", "0"], [MINIMAL, "--node-id", "128"],
                          [MINIMAL, "--node-id", "x"], [MINIMAL, "--node-id", "1"],
                          [MINIMAL, "--node-id", "9", "--title", "x" * 201],
                          [MINIMAL, "--node-id", "9", "--identifiers-from", "0x6E0"],
                          [MINIMAL, "--node-id", "+9"], [MINIMAL, "--node-id", "0b1"],
                          [MINIMAL, "--node-id", "9", "--identifiers-from", "0x690", "--keep-identifiers"]):
            result = cgw("clone", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
            self.assertTrue(result.stderr.startswith(b"cgw: "), result.stderr)

    def test_numbers_have_one_spelling(self):
        for number in ("0x6_90", "0b11010010000", "+1680", "0x+690", "1680.0", " 1680", ""):
            result = cgw("clone", MINIMAL, "--node-id", "9", "--identifiers-from", number)
            self.assertEqual((result.returncode, result.stdout), (2, b""), number)
            said = f"--identifiers-from {number}: a number is written 17, 0x11 or 11h".encode()
            self.assertIn(said, result.stderr)
        for number in ("1680", "0x690", "690h"):
            result = cgw("clone", MINIMAL, "--node-id", "9", "--identifiers-from", number)
            self.assertEqual(result.returncode, 0, result.stderr)


class SchemaLine(Case):
    def test_the_first_line_names_the_schema_where_one_lies(self):
        path = self.dir / "plants" / "a.toml"
        path.parent.mkdir()
        self.assertEqual(cgw("new", "-o", path).returncode, 0)
        self.assertTrue(path.read_text().startswith("# Editors complete and explain parameters"))
        self.write("parameter-file.schema.json", "{}")
        self.assertEqual(cgw("new", "-o", path, "--force").returncode, 0)
        self.assertEqual(path.read_text().splitlines()[0], "#:schema ../parameter-file.schema.json")
        out = self.dir / "b.toml"
        (self.dir / "schemas").mkdir()
        (self.dir / "schemas" / "parameter-file.schema.json").write_text("{}")
        cgw("import", "table", "--governor", self.governor_table(), "--gateway", GATEWAY_TABLE, "-o", out)
        self.assertEqual(out.read_text().splitlines()[0], "#:schema schemas/parameter-file.schema.json")


class EntrySheet(Case):
    def test_the_page_is_well_formed_and_loads_nothing(self):
        page = cgw("emit", "entry-sheet", GENSET, "--format", "html").stdout
        judged = subprocess.run(["xmllint", "--noout", "-"], input=page, stderr=subprocess.PIPE)
        self.assertEqual(judged.returncode, 0, judged.stderr)
        for word in (b"http", b"src=", b"<script", b"url("):
            self.assertNotIn(word, page)

    def test_texts_of_users_are_neither_markup_nor_formula(self):
        text = GENSET.read_text().replace('"Genset 2, starboard"', '"=1+1 <b>|"')
        text = text.replace("902 = 2 ", "902 = 2 # ")
        plant = self.write("a.toml", text)
        self.assertIn(b"&lt;b&gt;", cgw("emit", "entry-sheet", plant, "--format", "html").stdout)
        self.assertIn(b",'=1+1 <b>|,15625\n", cgw("emit", "entry-sheet", plant, "--format", "csv").stdout)
        self.assertIn(b"=1+1 \\<b>\\|\n", cgw("emit", "entry-sheet", plant).stdout)


if __name__ == "__main__":
    unittest.main()
