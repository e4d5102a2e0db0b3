"""xmllint judges what cgw writes as XDD and XDC against a schema of CiA 311 (tests/judges/xdd/canopen.xsd)."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
DATA = pathlib.Path(os.environ["CGW_TEST_DATA"])
SCHEMA = pathlib.Path(__file__).with_name("xdd") / "canopen.xsd"


def xmllint(path):
    return subprocess.run(["xmllint", "--noout", "--nonet", "--schema", SCHEMA, path], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=120)


@unittest.skipUnless(shutil.which("xmllint"), "xmllint is not installed")
class Judged(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-xdd-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def cgw(self, *arguments):
        result = subprocess.run([CGW, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual(result.returncode, 0, result.stderr)

    def expect_valid(self, path):
        judged = xmllint(path)
        self.assertEqual(judged.returncode, 0, judged.stdout[:2000])
        # What xmllint leaves out: every reference finds its parameter, and no parameter is left alone.
        root = xml.etree.ElementTree.parse(path).getroot()
        parameters = [e.get("uniqueID") for e in root.iter("{http://www.canopen.org/xml/1.1}parameter")]
        references = [e.get("uniqueIDRef") for e in root.iter() if e.get("uniqueIDRef")]
        self.assertEqual(sorted(references), sorted(parameters))

    def test_emitted_files_are_valid(self):
        for sample in sorted(SAMPLES.glob("*.toml")):
            for emitter in ("xdd", "xdc"):
                path = self.dir / f"{sample.stem}.{emitter}"
                self.cgw("emit", emitter, sample, "-o", path)
                self.expect_valid(path)

    def test_converted_files_are_valid(self):
        for source in sorted((DATA / "convert").glob("*.eds")):
            for ending in ("xdd", "xdc"):
                path = self.dir / f"{source.stem}.{ending}"
                of_one_node = ("--node-id", 5) if ending == "xdc" else ()
                self.cgw("convert", source, "-o", path, *of_one_node)
                self.expect_valid(path)

    def test_there_is_something_to_convert(self):
        self.assertGreater(len(list((DATA / "convert").glob("*.eds"))), 0)

    def test_the_judge_sees_what_is_wrong(self):
        path = self.dir / "a.xdd"
        self.cgw("emit", "xdd", SAMPLES / "genset.toml", "-o", path)
        sound = path.read_text(encoding="utf-8")
        for before, after in (('index="1000"', 'index="100"'), ('accessType="ro"', 'accessType="rx"'),
                              ('uniqueID="UID_OBJ_1000"', 'uniqueID="UID_OBJ_1001"'),
                              ('index="1001"', 'index="1000"'), ("<UDINT/>", ""),
                              ('"Dummy0006=1"', '"Dummy0006=2"'), ("250 Kbps", "251 Kbps"),
                              ('xmlns="http://www.canopen.org/xml/1.1"', 'xmlns="http://www.canopen.org/xml/1.0"')):
            self.assertIn(before, sound)
            path.write_text(sound.replace(before, after, 1), encoding="utf-8")
            self.assertNotEqual(xmllint(path).returncode, 0, (before, after))


if __name__ == "__main__":
    unittest.main()
