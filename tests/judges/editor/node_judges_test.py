"""The schema judged by programs that editors use: ajv, taplo, and the language server of "Even Better TOML".
They are npm packages; .ci/install-packages test installs them. None of them may ask for the network."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import jsonschema

from documents import SAMPLE, SCHEMA_FILE, SLIPS, SOURCE, Generator, codes, is_well_formed, load, slipped

HERE = pathlib.Path(__file__).resolve().parent
PACKAGES = pathlib.Path(os.environ["CGW_NODE_PACKAGES"]) / "node_modules"
VALIDATOR = jsonschema.Draft7Validator(json.loads(SCHEMA_FILE.read_text()))


def skip(why):
    print(f"skipped: {why}; .ci/install-packages test installs what is missing, where npm packages can be had")
    sys.exit(77)


def node(script, *arguments, stdin=None, cwd=None):
    """Runs a script without the network: one that asks for it ends with code 99."""
    result = subprocess.run(["node", "--require", HERE / "deny_network.cjs", script, *map(str, arguments)],
                            input=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=cwd, timeout=300,
                            env={**os.environ, "NODE_PATH": str(PACKAGES)}, text=True)
    if result.returncode == 99:
        raise AssertionError(result.stderr)
    return result


def taplo(*arguments, cwd):
    return node(PACKAGES / "@taplo/cli/dist/cli.js", "check", "--no-auto-config", *arguments, cwd=cwd)


class Judges(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-schema-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def write(self, name, text):
        path = self.dir / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        return path

    def slips(self):
        return [(what, self.write(f"slip{i}.toml", slipped(old, new))) for i, (what, old, new) in enumerate(SLIPS)]

    def test_ajv_takes_the_schema_in_strict_mode_and_agrees_with_jsonschema(self):
        generator = Generator(3, self.dir)
        paths = [generator.file(i) for i in range(40)] + [path for _, path in self.slips()]
        paths += [*SOURCE.glob("samples/*.toml"), *SOURCE.glob("samples/bad/*.toml")]
        documents = {str(path): load(path) for path in paths if load(path) is not None}
        result = node(HERE / "ajv_judge.cjs", SCHEMA_FILE, stdin=json.dumps(documents))
        self.assertEqual(result.returncode, 0, result.stderr[:2000])
        verdicts = json.loads(result.stdout)
        for path, document in documents.items():
            self.assertEqual(verdicts[path] == [], VALIDATOR.is_valid(document), (path, verdicts[path]))

    def test_taplo_accepts_what_cgw_accepts_with_the_schema_named_in_the_file(self):
        result = taplo(*sorted(SOURCE.glob("samples/*.toml")), cwd=self.dir)
        self.assertEqual(result.returncode, 0, result.stderr[:2000])

    def test_taplo_accepts_generated_files(self):
        generator = Generator(4, self.dir)
        paths = [generator.file(i) for i in range(40)]
        found = codes(paths)
        paths = [path for path in paths if is_well_formed(found[str(path)])]
        self.assertGreaterEqual(len(paths), 38)
        result = taplo("--schema", SCHEMA_FILE.as_uri(), *paths, cwd=self.dir)
        self.assertEqual(result.returncode, 0, result.stderr[:2000])

    def test_taplo_shows_each_slip_and_nothing_else(self):
        (self.dir / "schemas").mkdir()
        shutil.copy(SCHEMA_FILE, self.dir / "schemas")
        directive = "#:schema schemas/parameter-file.schema.json\n"
        right = self.write("right.toml", directive + SAMPLE)
        slips = self.slips()
        for _, path in slips:
            path.write_text(directive + path.read_text())
        result = taplo(right, *(path for _, path in slips), cwd=self.dir)
        self.assertEqual(result.returncode, 1, result.stderr[:2000])
        refused = set(re.findall(r'invalid file .*path="(.*)"', result.stderr))
        self.assertEqual({path for _, path in slips} - set(map(pathlib.Path, refused)), set())
        self.assertNotIn(str(right), refused)

    def test_taplo_names_the_unknown_parameter_of_the_bad_sample(self):
        result = taplo(SOURCE / "samples/bad/unknown-parameter-name.toml", cwd=self.dir)
        self.assertEqual(result.returncode, 1)
        self.assertIn("'CanOpHeartBeatTxRate' was unexpected", result.stderr)

    def test_the_language_server_explains_completes_and_marks(self):
        (self.dir / "schemas").mkdir()
        shutil.copy(SCHEMA_FILE, self.dir / "schemas")
        text = "#:schema ../schemas/parameter-file.schema.json\n" + slipped("427 = 1", "CanOpenMyNodeID = 128")
        path = self.write("plants/plant.toml", text)
        lines = text.split("\n")
        at = lambda key, shift=1: f"{next(i for i, l in enumerate(lines) if l.startswith(key))}:{shift}"
        result = node(HERE / "language_server.cjs", path, at("403"), at("426"), at('"CanOpTPDO5'), at("16400"),
                      at("main_cycle_us"), at("nodes"))
        self.assertEqual(result.returncode, 0, result.stderr[:2000])
        answer = json.loads(result.stdout)
        expected = [
            ("403 CanCMNodeNumber", "of the governor", "1..31", "required", "GWM 7.1.1"),
            ("426 CanOpenBaudrate", "125, 250, 500 or 1000 kbit/s", "bit rate of the CANopen bus"),
            ("16404 CanOpTPDO5-16ID(0)", "0..0x7FF", "identifier of TPDO5"),
            ("16400 CanOpTPDO4Assign(0)", "a list fills 16400..16451"),
            ("main cycle", "1000..1000000", "15625 when it is not given"),
            ("node id",),
        ]
        for shown, parts in zip(answer["hovers"], expected, strict=True):
            for part in parts:
                self.assertIn(part, shown)
        self.assertIn("CanOpenPartnerNodeID", answer["completions"][1])
        self.assertEqual([one.split(": ", 1)[1] for one in answer["diagnostics"]],
                         ["128 is greater than the maximum of 127"])


if __name__ == "__main__":
    if shutil.which("node") is None:
        skip("there is no node")
    if not (PACKAGES / "ajv").is_dir() or not (PACKAGES / "@taplo/cli").is_dir():
        skip(f"ajv and taplo are not in {PACKAGES}")
    unittest.main(verbosity=2)
