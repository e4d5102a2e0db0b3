"""Hooks and CI recipes that others copy: they are YAML, and cgw understands every command in them."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

import yaml

CGW = pathlib.Path(os.environ["CGW"])
SOURCE = pathlib.Path(os.environ["CGW_SAMPLES"]).parent
HOOKS = yaml.safe_load((SOURCE / ".pre-commit-hooks.yaml").read_text())
PAGE = (SOURCE / "docs/build-integration.md").read_text()
RECIPES = [yaml.safe_load(block) for block in re.findall(r"```yaml\n(.*?)```", PAGE, re.S)]


class Recipes(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-hooks-"))
        self.addCleanup(shutil.rmtree, self.dir)
        (self.dir / "plants").mkdir()
        shutil.copy(SOURCE / "samples/genset.toml", self.dir / "plants/genset-2.toml")
        self.run_line("cgw build plants/genset-2.toml -o artefacts/genset-2", 0)

    def run_line(self, line, expected):
        path = f"{CGW.parent}{os.pathsep}{os.environ['PATH']}"
        result = subprocess.run(["sh", "-c", line], cwd=self.dir, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                env={**os.environ, "PATH": path}, timeout=120)
        self.assertEqual(result.returncode, expected, (line, result.stdout))

    def spoil(self):
        plant = self.dir / "plants/genset-2.toml"
        plant.write_text(plant.read_text() + "nodes = 1\n")

    def hook_lines(self):
        uses = {hook["id"]: hook for hook in RECIPES[0]["repos"][0]["hooks"]}
        for hook in HOOKS:
            words = uses[hook["id"]].get("args", [])
            files = [] if hook.get("pass_filenames") is False else ["plants/genset-2.toml"]
            yield f"{hook['entry']} {shlex.join([*words, *files])}"

    def test_hooks_have_what_pre_commit_asks_for(self):
        self.assertEqual([hook["id"] for hook in HOOKS], ["cgw-check", "cgw-build-check"])
        for hook in HOOKS:
            self.assertEqual(hook["language"], "system")
            for key in ("name", "description", "entry"):
                self.assertTrue(hook[key])

    def test_the_documented_hooks_pass_a_good_plant_and_stop_a_bad_one(self):
        lines = list(self.hook_lines())
        self.assertEqual(len(lines), 2)
        for line in lines:
            self.run_line(line, 0)
        self.spoil()
        for line in lines:
            self.run_line(line, 1)

    def test_the_documented_workflow_passes_a_good_plant_and_stops_a_bad_one(self):
        steps = RECIPES[1]["jobs"]["check"]["steps"]
        lines = [step["run"] for step in steps if step.get("run", "").startswith("cgw ")]
        self.assertEqual(len(lines), 2)
        for line in lines:
            self.run_line(line, 0)
        self.spoil()
        for line in lines:
            self.run_line(line, 1)


if __name__ == "__main__":
    unittest.main()
