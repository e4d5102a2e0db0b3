"""The JSON Schema of the parameter file, judged by python3-jsonschema: current, never stricter than cgw, useful."""
import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import jsonschema

from documents import CGW, ROWS, SAMPLE, SCHEMA_FILE, SLIPS, SOURCE, Generator, codes, is_well_formed, load, slipped

SCHEMA = json.loads(SCHEMA_FILE.read_text())
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def objections(document):
    return [f"{list(e.absolute_path)}: {e.message[:200]}" for e in VALIDATOR.iter_errors(document)]


class Schema(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-schema-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def assert_never_stricter(self, paths, at_least):
        """Whatever cgw accepts fits the schema; enough of the files are accepted to say so."""
        found = codes(paths)
        accepted = [path for path in paths if is_well_formed(found[str(path)])]
        refused = [f"{path.name}: {found[str(path)]}" for path in paths if path not in accepted]
        self.assertGreaterEqual(len(accepted), at_least, refused[:5])
        for path in accepted:
            document = load(path)
            self.assertIsNotNone(document, path)
            self.assertEqual(objections(document), [], path.read_text())

    def test_is_a_valid_schema_and_the_committed_one_is_current(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)
        result = subprocess.run([CGW, "schema", "--check", "-o", SCHEMA_FILE], stderr=subprocess.PIPE)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def test_refers_to_nothing_outside_itself(self):
        text = SCHEMA_FILE.read_text()
        self.assertEqual(text.count("http"), 1)  # the draft it is written in
        self.assertNotIn("$id", text)

    def test_accepts_every_file_of_the_project_that_cgw_accepts(self):
        files = [*SOURCE.glob("samples/**/*.toml"), *SOURCE.glob("tests/data/checks/**/*.toml")]
        documents = [path for path in files
                     if (load(path) or {}).get("device") is None and path.parent.name != "scenarios"]
        self.assert_never_stricter(documents, at_least=40)

    def test_accepts_generated_files_in_every_spelling_that_cgw_accepts(self):
        generator = Generator(1, self.dir)
        self.assert_never_stricter([generator.file(i) for i in range(150)], at_least=145)

    def test_accepts_whatever_cgw_still_accepts_after_a_random_change(self):
        generator = Generator(2, self.dir)
        values = ["0", "1", "-1", "31.0", "0x7FF", "1.5", "nan", "true", "'a'", "[]", "[1, 2]", "[0.0]", "{}", "65536"]
        paths = []
        for i in range(200):
            path = generator.file(i)
            lines = path.read_text().split("\n")
            at = generator.random.choice([n for n, line in enumerate(lines) if " = " in line])
            lines[at] = lines[at].rsplit(" = ", 1)[0] + " = " + generator.random.choice(values)
            path.write_text("\n".join(lines))
            paths.append(path)
        self.assert_never_stricter(paths, at_least=15)

    def test_shows_the_slips_that_cgw_refuses(self):
        (self.dir / "right.toml").write_text(SAMPLE)
        self.assertEqual(codes([self.dir / "right.toml"]), {str(self.dir / "right.toml"): set()})
        self.assertEqual(objections(load(self.dir / "right.toml")), [])
        for i, (what, old, new) in enumerate(SLIPS):
            path = self.dir / f"slip{i}.toml"
            path.write_text(slipped(old, new))
            self.assertFalse(is_well_formed(codes([path])[str(path)]), what)
            self.assertGreaterEqual(len(objections(load(path))), 1, what)

    def test_leaves_unknown_names_to_cgw_where_the_file_brings_its_own(self):
        for own in ('catalogue = ["own.toml"]\n', ""):
            declare = "" if own else '[[governor.declare]]\nnumber = 812\nname = "Mine"\nkind = "switch"\n'
            text = own + slipped("401 = 1\n403 = 1", "401 = 1\n403 = 1\nMine = 3")
            text = text.replace("[governor.parameters]", declare + "[governor.parameters]")
            (self.dir / "own.toml").write_text(
                'device = "governor"\n[[row]]\nnumber = 5001\nname = "Mine"\nkind = "parameter"\n')
            path = self.dir / "plant.toml"
            path.write_text(text)
            self.assertEqual(codes([path])[str(path)], set(), text)
            self.assertEqual(objections(load(path)), [])

    def test_explains_every_parameter_under_its_number_its_name_and_both(self):
        for device, rows in ROWS.items():
            keys = SCHEMA["definitions"][f"{device}Parameters"]["properties"]
            for row in rows:
                spellings = [str(row.number), row.label(), *row.names[:1]]
                for spelling in spellings:
                    name = keys[spelling]["$ref"].rsplit("/", 1)[1]
                    shown = SCHEMA["definitions"][name]
                    self.assertEqual(shown["title"], row.label())
                    for part in (row.label(), row.text, row.table["section"], row.table.get("unit", "")):
                        self.assertIn(part, shown["description"], spelling)
                    if "range" in row.table and "choices" not in row.table:
                        low, high = row.table["range"]
                        self.assertEqual((shown["minimum"], shown["maximum"]), (low, high), spelling)


if __name__ == "__main__":
    unittest.main(verbosity=2)
