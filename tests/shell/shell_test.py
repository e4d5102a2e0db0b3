"""Man pages judged by mandoc and groff; completion asked of bash, zsh and fish themselves."""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import tempfile
import time
import unittest

SHARE = pathlib.Path(os.environ["CGW_SHARE"])
SAMPLES = os.environ["CGW_SAMPLES"]
CGW = os.environ["CGW"]
GATEWAY = os.environ["CANOPEN_GATEWAY"]


def run(*command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, text=True, **options)


def verbs():
    text = subprocess.run([CGW, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    return re.findall(r"^  ([a-z-]+(?: [a-z]+)?)  ", text, re.M)


class ManPages(unittest.TestCase):
    def test_there_is_one_for_the_program_and_each_verb(self):
        pages = sorted(path.name for path in (SHARE / "man/man1").iterdir())
        wanted = ["canopen-gateway.1", "cgw.1"] + [f"cgw-{verb.replace(' ', '-')}.1" for verb in verbs()]
        self.assertEqual(pages, sorted(wanted))

    def test_mandoc_and_groff_find_nothing_to_complain_about(self):
        for page in sorted((SHARE / "man/man1").iterdir()):
            lint = run("mandoc", "-T", "lint", "-W", "warning", str(page))
            complaints = [line for line in lint.stdout.splitlines() if "missing date" not in line]
            self.assertEqual(complaints, [], page.name)
            self.assertEqual(run("groff", "-man", "-ww", "-z", str(page)).stdout, "", page.name)

    def test_every_option_of_the_help_is_on_the_page(self):
        for verb in verbs():
            help_text = run(CGW, *verb.split(), "--help").stdout
            page = run("mandoc", "-T", "ascii", str(SHARE / f"man/man1/cgw-{verb.replace(' ', '-')}.1")).stdout
            page = re.sub(".\b", "", page)
            for option in re.findall(r"^  (-[-\w]+)", help_text, re.M):
                self.assertIn(option, page, verb)

    def test_every_option_of_the_gateway_is_on_its_page(self):
        help_text = run(GATEWAY, "--help").stdout
        page = re.sub(".\b", "", run("mandoc", "-T", "ascii", str(SHARE / "man/man1/canopen-gateway.1")).stdout)
        options = re.findall(r"^  (--[-\w]+)", help_text, re.M)
        self.assertIn("--can1", options)
        for option in options + ["hub:HOST:PORT", "SIGUSR1"]:
            self.assertIn(option, page)


class Asked(unittest.TestCase):
    """The same questions to each shell; `ask` returns the set of proposals for a line."""

    def setUp(self):
        self.dir = tempfile.mkdtemp(prefix="cgw-shell-")
        self.addCleanup(shutil.rmtree, self.dir)
        pathlib.Path(self.dir, "plant.toml").touch()
        pathlib.Path(self.dir, "artefacts").mkdir()

    def check_all(self):
        self.assertLessEqual({"check", "build", "emit", "image"}, self.ask("cgw "))
        self.assertEqual(self.ask("cgw ch"), {"check"})
        self.assertEqual(self.ask("cgw image "), {"verify", "inspect", "annotate", "diff", "decompile", "embed"})
        self.assertLessEqual({"human", "concise", "json"}, self.ask("cgw check --format "))
        self.assertLessEqual({"eds", "pdo-table", "image", "image-source"}, self.ask("cgw emit "))
        self.assertIn("plant.toml", self.ask("cgw check p"))
        self.assertIn("plant.toml", self.ask("cgw check --format json p"))
        self.assertIn("plant.toml", self.ask("cgw emit eds p"))
        self.assertIn("plant.toml", self.ask("cgw emit --section .x eds p"))
        self.assertEqual({word.rstrip("/") for word in self.ask("cgw build plant.toml -o a")}, {"artefacts"})
        self.assertEqual(self.ask("cgw check --colo"), {"--color"})
        self.assertEqual(self.ask("cgw image inspect --j"), {"--json"})
        self.assertIn("monitoring-short", self.ask("cgw check -W mon"))
        self.assertIn("no-monitoring-short", self.ask("cgw check -W no-mon"))
        codes = set(re.findall(r"^E02\d\d", run(CGW, "list", "checks").stdout, re.M))
        self.assertGreater(len(codes), 3)
        self.assertEqual(self.ask("cgw explain E02"), codes)
        self.assertEqual(self.ask("canopen-gateway --sta"), {"--state", "--status"})
        self.assertEqual(self.ask("canopen-gateway --can1 s"), {"simulated"})
        self.assertIn("plant.toml", self.ask("canopen-gateway --status --log p"))


class Bash(Asked):
    def ask(self, line):
        words = line.split(" ")
        function = "_" + words[0].replace("-", "_")
        script = (f"source '{SHARE}/bash-completion/completions/{words[0]}'; COMP_WORDS=({' '.join(words)} ''); "
                  f"COMP_WORDS[{len(words) - 1}]='{words[-1]}'; COMP_CWORD={len(words) - 1}; {function}; "
                  "printf '%s\\n' \"${COMPREPLY[@]}\"")
        return set(run("bash", "--norc", "-uc", script, cwd=self.dir).stdout.split())

    def test_proposals(self):
        self.check_all()

    def test_a_value_behind_an_equals_sign(self):
        # bash splits --format=j into three words
        self.assertEqual(self.ask("cgw check --format = j"), {"json"})
        self.assertLessEqual({"human", "json"}, self.ask("cgw check --format ="))


class Fish(Asked):
    def ask(self, line):
        script = f"source '{SHARE}/fish/vendor_completions.d/{line.split()[0]}.fish'; complete -C '{line}'"
        environment = {**os.environ, "HOME": self.dir, "TERM": "dumb"}
        text = run("fish", "--no-config", "-c", script, cwd=self.dir, env=environment).stdout
        return {row.split("\t")[0] for row in text.splitlines()}

    def test_proposals(self):
        self.check_all()


class Zsh(Asked):
    """zsh completes only at a prompt, so it gets one. A widget prints what would be proposed."""

    def ask(self, line):
        master, slave = pty.openpty()
        process = subprocess.Popen(["zsh", "-f", "-i"], stdin=slave, stdout=slave, stderr=slave, cwd=self.dir,
                                   env={**os.environ, "TERM": "dumb", "HOME": self.dir, "COLUMNS": "300"},
                                   start_new_session=True)
        os.close(slave)
        try:
            self.say(master, "PS1='READY> '; unsetopt zle_bracketed_paste; setopt no_beep; LISTMAX=1000; "
                             f"fpath=('{SHARE}/zsh/site-functions' $fpath); autoload -U compinit; compinit -u -D; "
                             "zstyle ':completion:*' list-prompt ''; stty rows 100 cols 300; echo SET''UP\n")
            self.hear(master, "SETUP")
            self.say(master, "compadd() { builtin compadd -O found \"$@\"; [[ -n $found ]] && "
                             "print -l -- PROPOSAL:$^found; builtin compadd \"$@\" }; echo WRAP''PED\n")
            self.hear(master, "WRAPPED")
            self.say(master, line + "\t\x01#\n echo DO''NE\n")
            return set(re.findall(r"PROPOSAL:(\S+)", self.hear(master, "DONE")))
        finally:
            process.kill()
            process.wait()
            os.close(master)

    @staticmethod
    def say(master, text):
        os.write(master, text.encode())

    def hear(self, master, mark):
        heard = ""
        deadline = time.monotonic() + 30
        while mark not in heard:
            self.assertLess(time.monotonic(), deadline, heard)
            if select.select([master], [], [], 1)[0]:
                heard += os.read(master, 65536).decode(errors="replace")
        return heard

    def test_proposals(self):
        self.check_all()


if __name__ == "__main__":
    unittest.main(verbosity=1)
