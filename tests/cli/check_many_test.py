"""cgw check over many files: patterns, threads, the same output in the same order."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

CGW = os.environ["CGW"]
GENSET = pathlib.Path(os.environ["CGW_SAMPLES"]) / "genset.toml"


class CheckMany(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-many-"))
        self.addCleanup(shutil.rmtree, self.dir)
        text = GENSET.read_text()
        for ship in ("aurora", "bellona"):
            for number in range(12):
                path = self.dir / "plants" / ship / f"engine-{number:02}.toml"
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text.replace("CanOpenBaudrate = 250", "CanOpenBaudrate = 251") if number == 7 else text)

    def check(self, *arguments):
        return subprocess.run([CGW, "check", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              cwd=self.dir, timeout=120, text=True)

    def test_a_pattern_is_its_files_in_order(self):
        result = self.check("plants/**/*.toml", "--format", "json")
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        paths = [file["path"] for file in json.loads(result.stdout)["files"]]
        self.assertEqual(paths, sorted(str(p.relative_to(self.dir)) for p in self.dir.rglob("*.toml")))
        self.assertEqual(len(paths), 24)
        self.assertEqual(self.check("plants/*/engine-0[0-6].toml").returncode, 0)

    def test_threads_change_nothing(self):
        for form in ("human", "concise", "json", "sarif", "github"):
            outputs = {self.check("plants/**/*.toml", "--format", form, "-j", jobs).stdout for jobs in (1, 2, 7, 256)}
            outputs.add(self.check("plants/**/*.toml", "--format", form).stdout)
            self.assertEqual(len(outputs), 1, form)

    def test_one_line_over_all_files(self):
        last = self.check("plants/**/*.toml").stdout.splitlines()[-1]
        self.assertEqual(last, "24 files: 22 valid, 2 not valid; 2 errors")
        self.assertNotIn("files:", self.check(GENSET).stdout)

    def test_a_pattern_without_files_is_exit_3(self):
        result = self.check(GENSET, "plants/**/*.yaml")
        self.assertEqual((result.returncode, result.stdout), (3, ""))
        self.assertEqual(result.stderr, "cgw: no file matches plants/**/*.yaml\n")

    def test_a_missing_file_among_many_is_exit_3(self):
        result = self.check("plants/**/*.toml", "none.toml", "-j", 3)
        self.assertEqual(result.returncode, 3)
        self.assertTrue(result.stdout.splitlines()[-1].startswith("25 files: 22 valid, 3 not valid"))

    def test_the_number_of_jobs(self):
        for jobs in ("0", "-1", "257", "two", "", "1.5", "99999999999999999999"):
            result = self.check(GENSET, "-j", jobs)
            self.assertEqual((result.returncode, result.stdout), (2, ""), jobs)
            self.assertIn("is not a number from 1 to 256", result.stderr)


if __name__ == "__main__":
    unittest.main()
