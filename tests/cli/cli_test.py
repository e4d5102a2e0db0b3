"""The command line from outside: exit code and both streams of every verb."""
import csv
import io
import json
import os
import pathlib
import pty
import re
import shutil
import subprocess
import tempfile
import unittest
import urllib.parse

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
README = SAMPLES.parent / "README.md"
GENSET = str(SAMPLES / "genset.toml")
MANUAL = str(SAMPLES / "manual-example.toml")
CLEAN_GENSET = """: valid, no findings
  not verified:
  - sensors 902, 903, 910: whether this governor has them
  - other nodes: identifiers beyond the default ones of 1, 11
  - both devices: whether they hold these values; compare in DcDesk
"""
ARTEFACTS = ["CANopenGateway.dbc", "CANopenGateway.dcf", "CANopenGateway.eds",
             "CANopenGateway.xdc", "CANopenGateway.xdd", "entry-sheet.csv",
             "entry-sheet.html", "entry-sheet.md", "gateway-config.bin", "pdo-table.csv", "pdo-table.json", "pdo-table.md",
             "report.html", "report.md"]


def cgw(*arguments, stdin=None, stdout=subprocess.PIPE, directory=None, **environment):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "SOURCE_DATE_EPOCH")}
    return subprocess.run([CGW, *map(str, arguments)], input=stdin, stdout=stdout, stderr=subprocess.PIPE,
                          env={**clean, **environment}, cwd=directory, timeout=120)


class Verb(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-cli-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def broken(self, old="CanOpenMyNodeID = ", new="427 = 1"):
        """The genset with one line replaced; returns the path and the number of that line."""
        lines = pathlib.Path(GENSET).read_text().split("\n")
        at = next(i for i, line in enumerate(lines) if line.startswith(old))
        lines[at] = new
        path = self.dir / "broken.toml"
        path.write_text("\n".join(lines))
        return path, at + 1

    def bad(self):
        return self.broken(new="427 = 200")

    def files(self, directory):
        return sorted(p.name for p in pathlib.Path(directory).iterdir())


class Readme(Verb):
    def test_its_taste_is_what_the_program_prints(self):
        text = README.read_text()
        taste = re.search(r"```toml\n(.*?)```\n.*?```\n(.*?)```", text, re.DOTALL)
        (self.dir / "plant.toml").write_text(taste[1])
        result = cgw("check", "plant.toml", directory=self.dir)
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        self.assertEqual(result.stdout.decode(), taste[2])


class Check(Verb):
    def test_valid_samples_pass(self):
        for name in ("manual-example.toml", "minimal.toml", "genset.toml"):
            result = cgw("check", SAMPLES / name)
            self.assertEqual((result.returncode, result.stderr), (0, b""), name)
        self.assertEqual(cgw("check", GENSET).stdout.decode(), f"{GENSET}{CLEAN_GENSET}")

    def test_every_bad_sample_is_refused_with_findings_on_stdout(self):
        bad = sorted((SAMPLES / "bad").glob("*.toml"))
        self.assertGreaterEqual(len(bad), 5)
        for path in bad:
            result = cgw("check", path, "--format", "concise")
            self.assertEqual((result.returncode, result.stderr), (1, b""), path)
            self.assertRegex(result.stdout.decode(), r":\d+:\d+: error: .* \[E0\d{3} [a-z-]+\]\n")

    def test_one_mistake_gives_one_finding_at_the_value(self):
        path, line = self.bad()
        result = cgw("check", path, "--format", "concise")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout.decode().count("\n"), 1, result.stdout)
        self.assertTrue(result.stdout.decode().startswith(f"{path}:{line}:7: error: "), result.stdout)

    def test_json_is_one_document_with_the_documented_keys(self):
        path, line = self.bad()
        result = cgw("check", path, GENSET, "--format", "json")
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        document = json.loads(result.stdout)
        self.assertEqual(list(document), ["format_version", "valid", "files"])
        self.assertEqual((document["format_version"], document["valid"]), (1, False))
        self.assertEqual([f["path"] for f in document["files"]], [str(path), GENSET])
        finding = document["files"][0]["diagnostics"][0]
        self.assertEqual(list(finding), ["code", "name", "level", "message", "range", "related", "help"])
        self.assertEqual(finding["range"], {"start": {"line": line, "column": 7}, "end": {"line": line, "column": 10}})
        self.assertEqual(finding["level"], "error")
        self.assertEqual(document["files"][1]["diagnostics"], [])
        self.assertTrue(json.loads(cgw("check", GENSET, "--format", "json").stdout)["valid"])

    def test_json_fits_its_schema(self):
        schema = json.loads((SAMPLES.parent / "schemas/check-report.schema.json").read_text())
        reports = [cgw("check", *sorted((SAMPLES / "bad").glob("*.toml")), GENSET, "none.toml", "--format", "json")]
        reports.append(cgw("check", "-", "--format", "json", stdin=b"\xff"))
        for report in reports:
            jsonschema.validate(json.loads(report.stdout), schema)

    def test_a_missing_file_is_exit_3_in_every_format(self):
        for format in ("human", "concise", "json", "sarif", "github"):
            result = cgw("check", self.dir / "none.toml", "--format", format)
            self.assertEqual(result.returncode, 3)
            self.assertIn(b"No such file", result.stdout)
            self.assertIn(b"E0001", result.stdout)

    def test_all_files_are_processed_and_the_most_serious_code_wins(self):
        path, _ = self.bad()
        result = cgw("check", path, self.dir / "none.toml", GENSET)
        self.assertEqual(result.returncode, 3)
        self.assertIn(f"{path}: not valid, 1 error", result.stdout.decode())
        self.assertIn(f"{GENSET}: valid", result.stdout.decode())

    def test_standard_input(self):
        result = cgw("check", "-", stdin=pathlib.Path(GENSET).read_bytes())
        self.assertEqual((result.returncode, result.stdout.decode()), (0, f"<stdin>{CLEAN_GENSET}"))
        result = cgw("check", "-", stdin=b"format = 1\ntitle = ")
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"<stdin>:2:", result.stdout)
        self.assertEqual(cgw("check", "-", "-", stdin=b"").returncode, 2)

    def test_an_empty_file_and_a_pipe_are_judged_like_files(self):
        empty = self.dir / "empty.toml"
        empty.write_bytes(b"")
        self.assertEqual(cgw("check", empty).returncode, 1)
        pipe = self.dir / "pipe"
        os.mkfifo(pipe)
        with subprocess.Popen(["cp", GENSET, "/dev/stdout"], stdout=subprocess.PIPE) as reader, \
                subprocess.Popen(["sh", "-c", 'exec cat > "$0"', str(pipe)], stdin=reader.stdout):
            result = cgw("check", pipe)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_hostile_files_are_refused_without_a_crash(self):
        for name, content in (("binary", os.urandom(5000)), ("nul", b"format = 1\x00"), ("deep", b"a = " + b"[" * 200000),
                              ("large", b"#" * (4 * 1024 * 1024 + 1)), ("latin1", b"title = '\xe4'")):
            path = self.dir / f"{name}.toml"
            path.write_bytes(content)
            result = cgw("check", path, "--format", "concise")
            self.assertEqual(result.returncode, 1, (name, result.stderr))
            self.assertRegex(result.stdout.decode(errors="replace"), r"error: .*\[E0\d{3}")
        self.assertEqual(cgw("check", "/dev/zero").returncode, 1)
        self.assertEqual(cgw("check", self.dir).returncode, 3)

    def test_colour_only_on_request_or_on_a_terminal(self):
        path, _ = self.bad()
        self.assertNotIn(b"\x1b", cgw("check", path).stdout)
        self.assertIn(b"\x1b[1;31m", cgw("check", path, "--color", "always").stdout)
        self.assertNotIn(b"\x1b", cgw("check", path, "--color", "never").stdout)

    def on_a_terminal(self, *arguments, **environment):
        """What arrives at the other end of a pseudo-terminal."""
        ours, theirs = pty.openpty()
        try:
            result = cgw(*arguments, stdout=theirs, **environment)
            os.close(theirs)
            text = b""
            while True:
                try:
                    part = os.read(ours, 65536)
                except OSError:  # the other end is closed and everything is read
                    break
                if not part:
                    break
                text += part
            return result.returncode, text
        finally:
            os.close(ours)

    def test_colour_on_a_terminal_unless_the_environment_objects(self):
        path, _ = self.bad()
        for expected, arguments, environment in (
                (True, [], {"TERM": "xterm"}), (True, [], {"TERM": "xterm", "NO_COLOR": ""}),
                (False, [], {"TERM": "xterm", "NO_COLOR": "1"}), (False, [], {"TERM": "dumb"}),
                (False, ["--color", "never"], {"TERM": "xterm"}),
                (True, ["--color", "always"], {"TERM": "dumb", "NO_COLOR": "1"}),
                (False, ["--format", "json"], {"TERM": "xterm"}), (False, ["--format", "github"], {"TERM": "xterm"}),
                (False, ["--format", "concise"], {"TERM": "xterm"})):
            code, text = self.on_a_terminal("check", path, *arguments, **environment)
            self.assertEqual((code, b"\x1b[" in text), (1, expected), (arguments, environment, text))

    def test_formats_for_programs_are_never_coloured(self):
        path, _ = self.bad()
        for format in ("human", "concise", "github", "json", "sarif"):
            result = cgw("check", path, "--format", format, "--color", "always")
            self.assertEqual((result.returncode, b"\x1b[" in result.stdout), (1, format == "human"), format)

    def names(self, *arguments):
        """Exit code, and level and name of every finding."""
        result = cgw("check", *arguments, "--format", "concise")
        return result.returncode, re.findall(r": (error|warning|note): .*\[E\d{4} ([a-z0-9-]+)\]", result.stdout.decode())

    def test_the_manuals_example_has_five_warnings_and_eight_notes(self):
        code, found = self.names(MANUAL)
        self.assertEqual((code, len(found)), (0, 13))
        self.assertEqual(sum(level == "warning" for level, _ in found), 5)
        self.assertIn("valid, 5 warnings, 8 notes", cgw("check", MANUAL).stdout.decode())
        lines = cgw("check", "manual-example.toml", directory=SAMPLES).stdout.decode().split("\n")
        self.assertEqual([line for line in lines if len(line) > 80], [])

    def test_warnings_and_notes_can_be_hidden_and_shown_again(self):
        everything = self.names(MANUAL)[1]
        for name in ("monitoring-early", "time-quantised"):
            self.assertEqual(self.names(MANUAL, "-W", f"no-{name}")[1], [f for f in everything if f[1] != name])
            self.assertEqual(self.names(MANUAL, "-W", f"no-{name}", "-W", name)[1], everything)
            self.assertEqual(self.names(MANUAL, "-W", name, "-W", f"no-{name}")[1],
                             [f for f in everything if f[1] != name])
        self.assertEqual(self.names(MANUAL, "-W", "no-E0301")[1], self.names(MANUAL, "-W", "no-monitoring-early")[1])

    def test_werror_makes_errors_of_the_warnings_that_are_left(self):
        code, found = self.names(MANUAL, "--werror")
        self.assertEqual(code, 1)
        self.assertEqual([level for level, _ in found].count("error"), 5)
        self.assertEqual([level for level, _ in found].count("note"), 8)
        hidden = [word for name in ("monitoring-early", "rpdo-unmonitored", "tpdo-empty") for word in ("-W", f"no-{name}")]
        code, found = self.names(MANUAL, "--werror", *hidden)
        self.assertEqual((code, {level for level, _ in found}), (0, {"note"}))
        text = cgw("check", MANUAL, "--werror").stdout.decode()
        self.assertIn("not valid, 5 errors, 8 notes", text)
        self.assertNotIn("not verified", text)

    def test_what_is_not_verified_is_in_human_and_json_only(self):
        lines = [line[4:] for line in CLEAN_GENSET.split("\n") if line.startswith("  - ")]
        document = json.loads(cgw("check", GENSET, self.bad()[0], "--format", "json").stdout)
        self.assertEqual([f["not_verified"] for f in document["files"]], [lines, []])
        for format in ("concise", "github", "sarif"):
            self.assertNotIn(b"both devices", cgw("check", GENSET, "--format", format).stdout.split(b'"results"')[-1])

    def test_github_commands_name_the_place(self):
        path, line = self.bad()
        result = cgw("check", path, MANUAL, "--format", "github")
        self.assertEqual((result.returncode, result.stderr), (1, b""))
        commands = result.stdout.decode().splitlines()
        self.assertEqual(len(commands), 14)
        self.assertTrue(commands[0].startswith(f"::error file={path},line={line},col=7,endLine={line},endColumn=10,"
                                               "title=E0111 value-range::427 CanOpenMyNodeID is 200,"), commands[0])
        self.assertEqual({c.split(" ")[0] for c in commands[1:]}, {"::warning", "::notice"})
        self.assertEqual(cgw("check", GENSET, "--format", "github").stdout, b"")


class Sarif(Verb):
    def log(self, *arguments, **environment):
        result = cgw("check", *arguments, "--format", "sarif", **environment)
        self.assertEqual(result.stderr, b"")
        log = json.loads(result.stdout)
        jsonschema.validate(log, json.loads((pathlib.Path(__file__).parent / "sarif.schema.json").read_text()))
        return result.returncode, log["runs"][0]

    def test_every_finding_is_a_result_of_its_rule(self):
        paths = [*sorted((SAMPLES / "bad").glob("*.toml")), MANUAL, GENSET, self.dir / "none.toml"]
        code, run = self.log(*paths)
        self.assertEqual(code, 3)
        driver = run["tool"]["driver"]
        self.assertEqual(driver["semanticVersion"], os.environ["CGW_VERSION"])
        self.assertEqual([rule["id"] for rule in driver["rules"]], sorted(rule["id"] for rule in driver["rules"]))
        self.assertEqual(len(run["artifacts"]), len(paths))
        documents = json.loads(cgw("check", *paths, "--format", "json").stdout)["files"]
        findings = [finding for file in documents for finding in file["diagnostics"]]
        self.assertEqual(len(run["results"]), len(findings))
        for result, finding in zip(run["results"], findings):
            rule = driver["rules"][result["ruleIndex"]]
            self.assertEqual((rule["id"], rule["name"]), (finding["code"], finding["name"]))
            self.assertEqual((result["ruleId"], result["level"]), (finding["code"], finding["level"]))
            self.assertTrue(result["message"]["text"].startswith(finding["message"]))
            self.assertEqual(len(result.get("relatedLocations", [])), len(finding["related"]))

    def test_levels_follow_werror(self):
        levels = [result["level"] for result in self.log(MANUAL, "--werror")[1]["results"]]
        self.assertEqual((levels.count("error"), levels.count("warning"), levels.count("note")), (5, 0, 8))

    def test_columns_are_utf16_code_units_and_uris_are_encoded(self):
        path = self.dir / "gen\u00e4 1.toml"
        path.write_text('format = 1\n"\u00e4\U0001f6a2" = 1\n[governor.parameters]\n[gateway.parameters]\n')
        _, run = self.log(path)
        result = next(r for r in run["results"] if r["ruleId"] == "E0101")
        location = result["locations"][0]["physicalLocation"]
        self.assertEqual(location["region"], {"startLine": 2, "startColumn": 1, "endLine": 2, "endColumn": 6})
        self.assertEqual(urllib.parse.unquote(location["artifactLocation"]["uri"]), f"file://{path}")
        self.assertTrue(location["artifactLocation"]["uri"].isascii())

    def test_standard_input_and_broken_text(self):
        for text in (b"", b"\xff\xfe", b"format = 1\ntitle = ", b"x" * 100000):
            code, run = self.log("-", stdin=text)
            self.assertEqual(code, 1)
            self.assertEqual(run["artifacts"][0]["location"]["uri"], "-")
            self.assertGreater(len(run["results"]), 0)

    def test_it_is_the_same_twice(self):
        self.assertEqual(*(cgw("check", MANUAL, "--format", "sarif", TZ=zone).stdout for zone in ("UTC", "Asia/Tokyo")))


class CheckOutput(Verb):
    def test_full_standard_output_is_exit_3(self):
        with open("/dev/full", "wb") as full:
            result = cgw("check", GENSET, stdout=full)
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"No space left", result.stderr)


class List(Verb):
    def rows(self, *arguments):
        result = cgw("list", *arguments, "--format", "json")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        document = json.loads(result.stdout)
        self.assertEqual(list(document), ["format_version", arguments[0]])
        self.assertEqual(document["format_version"], 1)
        return document[arguments[0]]

    def test_every_list_has_every_format(self):
        for what in ("parameters", "checks", "emitters", "codes"):
            rows = self.rows(what)
            self.assertGreater(len(rows), 3, what)
            for format in ("table", "csv", "md"):
                result = cgw("list", what, "--format", format)
                self.assertEqual((result.returncode, result.stderr), (0, b""), (what, format))
                self.assertTrue(result.stdout.endswith(b"\n"))
            read = list(csv.DictReader(io.StringIO(cgw("list", what, "--format", "csv").stdout.decode(), newline="")))
            self.assertEqual([{k: "" if v is None else str(v) for k, v in row.items()} for row in rows], read)

    def test_the_table_is_the_default_and_fits_80_columns(self):
        for what in ("parameters", "checks", "emitters", "codes"):
            text = cgw("list", what).stdout.decode()
            self.assertEqual(text, cgw("list", what, "--format", "table").stdout.decode())
            self.assertLessEqual(max(map(len, text.splitlines())), 80, what)

    def test_a_device_limits_parameters_and_codes(self):
        self.assertEqual({r["device"] for r in self.rows("parameters")}, {"governor", "gateway"})
        self.assertEqual({r["device"] for r in self.rows("parameters", "--device", "gateway")}, {"gateway"})
        self.assertEqual({r["device"] for r in self.rows("codes", "--device", "governor")}, {"governor"})

    def test_values_are_numbers_or_null(self):
        row = next(r for r in self.rows("parameters") if r["name"] == "CanOpTPDO5-16ID(3)")
        self.assertEqual((row["number"], row["minimum"], row["maximum"], row["base"]), (16407, 0, 2047, "hexadecimal"))
        self.assertIsNone(next(r for r in self.rows("parameters") if r["name"] == "Speed")["level"])

    def test_emitters_are_those_of_emit(self):
        names = {r["name"] for r in self.rows("emitters")}
        self.assertTrue({"eds", "pdo-table", "image"} <= names)
        files = {r["file"] for r in self.rows("emitters")} - {""}
        self.assertRegex(cgw("list", "emitters").stdout.decode(), r"concise-dcf +bin +none ")
        self.assertTrue(set(ARTEFACTS) <= files)

    def test_what_makes_no_sense_is_refused(self):
        for arguments, text in ((["list"], "WHAT"), (["list", "parameter"], "did you mean 'parameters'?"),
                                (["list", "checks", "--device", "gateway"], "checks do not belong to a device"),
                                (["list", "codes", "--format", "xml"], "table, json, csv, md"),
                                (["list", "codes", "--device", "engine"], "governor, gateway")):
            result = cgw(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
            self.assertIn(text, result.stderr.decode())


class Explain(Verb):
    def test_answers_go_to_stdout(self):
        for question, text in (("416", "gateway 416 HzmCanBaudrate"), ("canopenmynodeid", "gateway 427"),
                               ("12412", "action"), ("2005h=0x0102", "bit 8   12419 CanOpGWResetErr"),
                               ("3800=9", "check sum"), ("2003h:1", "Switch1..16"), ("0x06010002", "read-only"),
                               ("E0203", "428 = 5"), ("sensor-error", "3005 ErrSetpointExtern")):
            result = cgw("explain", question)
            self.assertEqual((result.returncode, result.stderr), (0, b""), question)
            self.assertIn(text, result.stdout.decode(), question)
            self.assertLessEqual(max(map(len, result.stdout.decode().splitlines())), 80, question)

    def test_several_questions_at_a_time(self):
        result = cgw("explain", "427", "E0203")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stdout, cgw("explain", "427").stdout + b"\n" + cgw("explain", "E0203").stdout)

    def test_json_has_the_documented_keys(self):
        result = cgw("explain", "12412", "--format", "json")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        document = json.loads(result.stdout)
        self.assertEqual(list(document), ["format_version", "answers"])
        answer = document["answers"][0]
        self.assertEqual(answer["question"], "12412")
        self.assertEqual([e["kind"] for e in answer["entries"]], ["error", "parameter", "parameter"])
        self.assertIn("action", answer["entries"][0]["fields"])

    def test_what_is_not_understood_is_refused_with_a_proposal_and_no_answer(self):
        result = cgw("explain", "427", "CanOpenMyNodID")
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertEqual(result.stderr.decode(), "cgw: nothing is known about `CanOpenMyNodID`\n"
                                                 "cgw: did you mean `CanOpenMyNodeID`?\n")
        result = cgw("explain", "2005h=much", "--format", "json")
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertIn("What can be explained:\n  416 ", result.stderr.decode())
        self.assertEqual(cgw("explain").returncode, 2)

    def test_nothing_steers_the_terminal(self):
        result = cgw("explain", "\x1b[31m")
        self.assertEqual(result.returncode, 2)
        self.assertNotIn(b"\x1b", result.stderr)


class Usage(Verb):
    def assert_usage(self, words, *arguments):
        result = cgw(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
        self.assertIn(words, result.stderr.decode())

    def test_mistakes_are_exit_2_and_go_to_stderr(self):
        self.assert_usage("did you mean 'check'?", "chek", GENSET)
        self.assert_usage("a verb is missing", *[])
        self.assert_usage("cgw image needs one of verify, inspect, annotate, diff, decompile, embed", "image")
        self.assert_usage("did you mean 'image verify'?", "image", "verfy", "x")
        self.assert_usage("cgw check has no option --bogus", "check", "--bogus", GENSET)
        self.assert_usage("cgw check has no option -x", "check", "-x")
        self.assert_usage("did you mean '--format'?", "check", "--formt", "json", GENSET)
        self.assert_usage("FILE is missing", "check")
        self.assert_usage("FORMAT missing", "check", GENSET, "--format")
        self.assert_usage("--format is given twice: json and human", "check", GENSET, "--format", "json",
                          "--format=human")
        self.assert_usage("'b' is one argument too many", "emit", "eds", "a", "b")
        self.assert_usage("--section is an option of image-source, not of eds", "emit", "eds", GENSET,
                          "--section", ".x")
        self.assert_usage("--generic takes no FILE", "emit", "eds", GENSET, "--generic")
        self.assert_usage("--generic is an option of eds, not of dcf", "emit", "dcf", "--generic")
        self.assert_usage("FILE is missing", "emit", "eds")
        self.assert_usage("--eds-name is an option of eds, dcf, xdd, xdc, dbc, not of image", "emit", "image", GENSET,
                          "--eds-name", "x")
        for name in ("../x", "a/b.eds", "", ".eds", "x;y", "Gr\u00f6\u00dfe", "x.dcf", "x.xdd"):
            self.assert_usage("is no name for a data sheet", "emit", "eds", GENSET, "--eds-name", name)
            self.assert_usage("is no name for a data sheet", "build", GENSET, "-o", self.dir, "--eds-name", name)
        self.assert_usage("human, concise, json", "check", "--format", "xml", GENSET)
        self.assert_usage("--color", "check", "--color", "sometimes", GENSET)
        self.assert_usage("did you mean 'node-id-duplicate'?", "check", "-W", "no-node-id-duplicat", GENSET)
        self.assert_usage("cannot be hidden", "check", "-W", "no-node-id-duplicate", GENSET)
        self.assert_usage("'E0203' is an error and cannot be hidden", "check", "-W", "no-E0203", GENSET)
        self.assert_usage("did you mean 'pdo-table'?", "emit", "pdo-tabel", GENSET)
        self.assert_usage("the formats of pdo-table are", "emit", "pdo-table", GENSET, "--format", "xml")
        self.assert_usage("--base is an option of image --format ihex, image --format srec, not of image --format bin",
                          "emit", "image", GENSET, "--base", "0x100")
        self.assert_usage("--incbin is an option of image-source --format asm, not of image-source --format cpp",
                          "emit", "image-source", GENSET, "--incbin", "x.bin")
        self.assert_usage("--format srec needs --base ADDRESS", "emit", "image", GENSET, "--format", "srec")
        for base in ("0x104", "0x100000000", "4294967288"):
            self.assert_usage("a multiple of 8 up to 0xFFFF0000", "emit", "image", GENSET, "--format", "ihex", "--base", base)
        for base in ("", "x", "0x", "-8", "+8", "0x1G", "8 "):
            self.assert_usage("such as 0x08010000", "emit", "image", GENSET, "--format", "ihex", "--base", base)
        self.assert_usage("without quotes", "emit", "image-source", GENSET, "--format", "asm", "--incbin", 'a"b')
        self.assert_usage("power of two", "emit", "image-source", GENSET, "--align", "3")
        self.assert_usage("C identifier", "emit", "image-source", GENSET, "--symbol", "a-b")
        self.assert_usage("section name", "emit", "image-source", GENSET, "--section", '"x')
        self.assert_usage("-o PATH", "emit", "eds", GENSET, "--check")
        self.assert_usage("--output", "build", GENSET)

    def test_arguments_cannot_steer_the_terminal(self):
        for arguments in (["x\x1b[31m"], ["emit", "x\x1b[31m", GENSET], ["check", "--format", "\x1b[31m", GENSET],
                          ["emit", "eds", GENSET, "-o", "none/\x1b[31m"], ["check", "\x1b[31m\u009b"],
                          ["image", "verify", "no\x1b[31m"]):
            result = cgw(*arguments)
            self.assertNotEqual(result.returncode, 0)
            self.assertNotIn(b"\x1b", result.stdout + result.stderr, arguments)
            self.assertNotIn("\u009b".encode(), result.stdout + result.stderr, arguments)

    def test_a_usage_mistake_is_one_line_with_the_programs_name(self):
        text = cgw("check").stderr.decode()
        self.assertRegex(text, r"\Acgw: [^\n]*\n\Z")

    def test_two_dashes_end_the_options(self):
        result = cgw("check", "--", "-h")
        self.assertEqual((result.returncode, result.stderr), (3, b""))
        self.assertIn(b"cannot read -h", result.stdout)

    def test_help_fits_80_columns_and_every_option_is_documented(self):
        documented = pathlib.Path(os.environ["CGW_DOCS"], "command-line.md").read_text()
        verbs = re.findall(r"^  ([a-z]+(?: [a-z]+)?)  ", cgw("--help").stdout.decode(), re.M)
        self.assertIn("image inspect", verbs)
        for verb in verbs:
            text = cgw(*verb.split(), "--help").stdout.decode()
            self.assertLessEqual(max(map(len, text.splitlines())), 80, verb)
            self.assertIn(f"cgw {verb}", documented)
            for option in re.findall(r"^  (-[-\w]+)", text, re.M):
                self.assertIn(f"{option}", documented, verb)

    def test_help_and_version_go_to_stdout(self):
        result = cgw("--version")
        self.assertEqual((result.returncode, result.stdout.decode()), (0, f"cgw {os.environ['CGW_VERSION']}\n"))
        for arguments in (["--help"], ["check", "--help"], ["build", "--help"], ["emit", "--help"],
                          ["image", "--help"], ["image", "verify", "--help"]):
            result = cgw(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)
            self.assertIn(b"Usage", result.stdout)


class Build(Verb):
    def test_writes_every_artefact_and_says_so(self):
        out = self.dir / "deep" / "out"
        result = cgw("build", GENSET, "-o", out)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual(self.files(out), ARTEFACTS)
        text = result.stdout.decode()
        for name in ARTEFACTS:
            self.assertIn(str(out / name), text)
        self.assertIn("reset BOTH devices", text)
        self.assertRegex(text, r"configuration id [0-9a-f]{16}\n")

    def test_identical_and_foreign_files_stay_untouched(self):
        cgw("build", GENSET, "-o", self.dir)
        (self.dir / "notes.txt").write_text("mine")
        for name in ARTEFACTS:
            os.utime(self.dir / name, (1, 1))
        (self.dir / "pdo-table.md").write_text("stale")
        self.assertEqual(cgw("build", GENSET, "-o", self.dir).returncode, 0)
        self.assertEqual((self.dir / "notes.txt").read_text(), "mine")
        for name in ARTEFACTS:
            self.assertEqual((self.dir / name).stat().st_mtime == 1, name != "pdo-table.md", name)

    def test_a_failed_check_writes_nothing_at_all(self):
        path, line = self.bad()
        result = cgw("build", path, "-o", self.dir / "out")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(f"{path}:{line}:7: error:", result.stderr.decode())
        self.assertFalse((self.dir / "out").exists())

    def test_a_failed_write_leaves_nothing_behind(self):
        out = self.dir / "out"
        (out / "pdo-table.md").mkdir(parents=True)
        result = cgw("build", GENSET, "-o", out)
        self.assertEqual((result.returncode, result.stdout), (3, b""))
        self.assertIn(b"pdo-table.md: it is a directory", result.stderr)
        self.assertEqual(self.files(out), ["pdo-table.md"])
        (self.dir / "file").write_text("")
        self.assertEqual(cgw("build", GENSET, "-o", self.dir / "file").returncode, 3)

    def test_an_input_is_never_overwritten(self):
        plant = self.dir / "pdo-table.md"
        shutil.copy(GENSET, plant)
        before = plant.read_bytes()
        link = self.dir / "link"
        link.symlink_to(plant)
        out = self.dir / "x.eds"
        for arguments in (("emit", "eds", plant, "-o", plant), ("emit", "eds", plant, "-o", link),
                          ("emit", "eds", plant, "-o", out, "--depfile", plant),
                          ("build", plant, "-o", self.dir), ("build", plant, "-o", self.dir / "d", "--depfile", link),
                          ("emit", "eds", plant, "-o", out, "--depfile", out)):
            result = cgw(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
            self.assertRegex(result.stderr.decode(), "is an input file|are the same file")
        self.assertEqual(plant.read_bytes(), before)
        self.assertEqual(self.files(self.dir), ["link", "pdo-table.md"])

    def test_a_failing_depfile_leaves_no_artefact(self):
        for depfile in ("/dev/full", self.dir / "none" / "d"):
            result = cgw("build", GENSET, "-o", self.dir / "out", "--depfile", depfile)
            self.assertEqual((result.returncode, result.stdout), (3, b""))
            self.assertFalse((self.dir / "out").exists())
        self.assertEqual(cgw("build", GENSET, "-o", "-").returncode, 2)

    def test_a_file_size_limit_is_a_failed_write(self):
        script = f'ulimit -f 8; exec "{CGW}" build "{GENSET}" -o "{self.dir}/out"'
        result = subprocess.run(["bash", "-c", script], capture_output=True, timeout=60)
        self.assertEqual((result.returncode, result.stdout), (3, b""), result.stderr)
        self.assertFalse((self.dir / "out").exists())

    def test_check_and_list_outputs(self):
        out = self.dir / "out"
        listed = cgw("build", GENSET, "-o", out, "--list-outputs").stdout.decode().split()
        self.assertEqual(sorted(listed), [str(out / name) for name in ARTEFACTS])
        self.assertFalse(out.exists())
        self.assertEqual(cgw("build", GENSET, "-o", out, "--check").returncode, 1)
        cgw("build", GENSET, "-o", out)
        self.assertEqual(cgw("build", GENSET, "-o", out, "--check").returncode, 0)
        (out / "pdo-table.csv").write_text("x")
        result = cgw("build", GENSET, "-o", out, "--check")
        self.assertEqual((result.returncode, result.stderr.decode().count("stale")), (1, 1))

    def test_two_gateways_in_one_project_stay_apart(self):
        other = self.dir / "other.toml"
        other.write_text(pathlib.Path(GENSET).read_text().replace("Genset 2, starboard", "Genset 1, port"))
        for file, given, name, title in ((GENSET, "starboard", "starboard", "Genset 2, starboard"),
                                         (other, "port.eds", "port", "Genset 1, port")):
            out = self.dir / name
            self.assertEqual(cgw("build", file, "-o", out, "--eds-name", given).returncode, 0)
            self.assertEqual(self.files(out), sorted(a.replace("CANopenGateway", name) for a in ARTEFACTS))
            eds = (out / f"{name}.eds").read_text()
            self.assertIn(f"FileName={name}.eds\n", eds)
            self.assertIn(f"Description={title}, configuration ", eds)
            dcf = (out / f"{name}.dcf").read_text()
            self.assertIn(f"FileName={name}.dcf\n", dcf)
            self.assertIn(f"LastEDS={name}.eds\n", dcf)
            self.assertIn(f'CM_ "{title}. Gateway node 12', (out / f"{name}.dbc").read_text())
            self.assertEqual(cgw("build", file, "-o", out, "--eds-name", given, "--check").returncode, 0)
            listed = cgw("build", file, "-o", out, "--eds-name", given, "--list-outputs").stdout.decode()
            self.assertEqual(sorted(listed.split()), [str(out / f) for f in self.files(out)])

    def test_depends_on_the_file_only(self):
        copy = self.dir / "copy" / "genset.toml"
        copy.parent.mkdir()
        shutil.copy(GENSET, copy)
        cgw("build", GENSET, "-o", self.dir / "a")
        cgw("build", copy, "-o", self.dir / "b", TZ="Pacific/Kiritimati", LC_ALL="de_DE.UTF-8")
        for name in ARTEFACTS:
            self.assertEqual((self.dir / "a" / name).read_bytes(), (self.dir / "b" / name).read_bytes(), name)

    def test_source_date_epoch_fills_in_for_a_file_without_a_date(self):
        minimal = SAMPLES / "minimal.toml"
        eds = cgw("emit", "eds", minimal, SOURCE_DATE_EPOCH="1700000000").stdout.decode()
        self.assertIn("CreationDate=11-14-2023", eds)
        self.assertIn("CreationDate=05-19-2004", cgw("emit", "eds", minimal).stdout.decode())
        result = cgw("emit", "eds", minimal, SOURCE_DATE_EPOCH="yesterday")
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertIn(b"SOURCE_DATE_EPOCH", result.stderr)


class Emit(Verb):
    def test_standard_output_and_file_are_the_same(self):
        cgw("build", GENSET, "-o", self.dir / "built")
        for arguments, name in ((["eds"], "CANopenGateway.eds"), (["dcf"], "CANopenGateway.dcf"),
                                (["dbc"], "CANopenGateway.dbc"), (["xdd"], "CANopenGateway.xdd"),
                                (["xdc"], "CANopenGateway.xdc"), (["image"], "gateway-config.bin"),
                                (["pdo-table", "--format", "md"], "pdo-table.md"),
                                (["pdo-table", "--format", "csv"], "pdo-table.csv"),
                                (["pdo-table", "--format", "json"], "pdo-table.json")):
            result = cgw("emit", arguments[0], GENSET, *arguments[1:])
            self.assertEqual((result.returncode, result.stderr), (0, b""), name)
            cgw("emit", arguments[0], GENSET, *arguments[1:], "-o", self.dir / name)
            built = (self.dir / "built" / name).read_bytes()
            self.assertEqual(result.stdout, built, name)
            self.assertEqual((self.dir / name).read_bytes(), built, name)

    def test_the_generic_data_sheet_needs_no_file(self):
        result = cgw("emit", "eds", "--generic")
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        text = result.stdout.decode()
        self.assertIn("FileName=CANopenGateway.eds\r\n", text)
        self.assertIn("DefaultValue=$NODEID+0x80000180\r\n", text)
        self.assertIn(f"ModifiedBy=cgw {os.environ['CGW_VERSION']}\r\n", text)
        target = self.dir / "plain.eds"
        arguments = ("emit", "eds", "--generic", "--eds-name", "plain", "-o", target)
        self.assertEqual(cgw(*arguments, "--check").returncode, 1)
        self.assertEqual(cgw(*arguments, "--depfile", self.dir / "d").returncode, 0)
        self.assertEqual(cgw(*arguments, "--check").returncode, 0)
        self.assertEqual(target.read_bytes(), text.replace("CANopenGateway.eds", "plain.eds").encode())
        self.assertEqual((self.dir / "d").read_text(), f"{target}:\n")
        dated = cgw("emit", "eds", "--generic", SOURCE_DATE_EPOCH="1700000000").stdout.decode()
        self.assertIn("ModificationDate=11-14-2023\r\n", dated)
        self.assertIn("CreationDate=05-19-2004\r\n", dated)
        self.assertEqual(cgw("emit", "eds", "--generic", SOURCE_DATE_EPOCH="yesterday").returncode, 2)

    def test_pdo_table_json_fits_its_schema(self):
        schema = json.loads((SAMPLES.parent / "schemas/pdo-table.schema.json").read_text())
        for name in ("minimal.toml", "genset.toml", "manual-example.toml"):
            document = json.loads(cgw("emit", "pdo-table", SAMPLES / name, "--format", "json").stdout)
            jsonschema.validate(document, schema)
            self.assertEqual([p["name"] for p in document["pdos"]],
                             [f"TPDO{n}" for n in range(1, 17)] + [f"RPDO{n}" for n in range(1, 5)])

    def test_labels_can_be_left_out_of_the_image(self):
        sizes = []
        for arguments in ([], ["--no-labels"]):
            image = self.dir / "x.bin"
            self.assertEqual(cgw("emit", "image", GENSET, "-o", image, *arguments).returncode, 0)
            self.assertEqual(cgw("image", "verify", image).returncode, 0)
            shown = json.loads(cgw("image", "inspect", image, "--json").stdout)
            self.assertEqual(bool(shown["labels"]), not arguments)
            self.assertIn(f"{image.stat().st_size} bytes", cgw("emit", "image-source", GENSET, *arguments).stdout.decode())
            sizes.append(image.stat().st_size)
        self.assertLess(sizes[1], sizes[0])
        result = cgw("emit", "eds", GENSET, "--no-labels")
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertIn(b"--no-labels is an option of image, image-source --format cpp, image-source --format h, not of eds", result.stderr)

    def test_the_report_shows_changes_against_an_earlier_file(self):
        old, _ = self.broken(old="CanOpenMyNodeID = ", new="427 = 13")
        page = cgw("emit", "report", GENSET, "--against", old, "--format", "md").stdout.decode()
        self.assertIn("## Changes\n\nCompared with broken.toml.\n", page)
        self.assertIn("| gateway | 427 | CanOpenMyNodeID | 13 | 12 |", page)
        self.assertNotIn("## Changes", cgw("emit", "report", GENSET, "--format", "md").stdout.decode())
        same = cgw("emit", "report", GENSET, "--against", GENSET, "--format", "md").stdout.decode()
        self.assertIn("Nothing differs from genset.toml.", same)

    def test_the_report_says_what_cgw_network_says(self):
        genset = pathlib.Path(GENSET).read_text()
        for rows, rule in (("id = 0x30C\nbytes = 4\nperiod_ms = 600", "E1110"), ("id = 0x48C\nbytes = 8\nperiod_ms = 100", "E1101"),
                           ("id = 0x10\nbytes = 8\nperiod_ms = 0.6", "E1106")):
            plant = self.dir / "plant.toml"
            plant.write_text(genset + "\n[[network.message]]\n" + rows + "\n")
            self.assertEqual(cgw("network", plant).returncode, 1)
            page = cgw("emit", "report", plant, "--format", "md").stdout.decode()
            self.assertIn("**Error:** the configuration is valid by itself, but it will not work on this bus", page)
            findings = page[page.index("## Findings"):page.index("## CANopen bus")]
            self.assertIn(rule, findings)
            self.assertEqual(rule == "E1101", "- 1 identifier with two senders" in page)
            self.assertNotIn("No check has anything to say", findings)

    def test_a_report_against_what_cannot_be_read(self):
        (self.dir / "old.toml").write_text("format = ")
        for old, code, words in ((self.dir / "none.toml", 3, b"No such file"), (self.dir / "old.toml", 1, b"cannot be compared")):
            result = cgw("emit", "report", GENSET, "--against", old, "-o", self.dir / "report.html")
            self.assertEqual((result.returncode, result.stdout), (code, b""))
            self.assertIn(words, result.stderr)
            self.assertFalse((self.dir / "report.html").exists())
        result = cgw("emit", "eds", GENSET, "--against", GENSET)
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertIn(b"--against is an option of report, not of eds", result.stderr)
        self.assertEqual(cgw("emit", "report", "-", "--against", "-", stdin=b"").returncode, 2)

    def test_an_invalid_file_emits_nothing(self):
        path, _ = self.bad()
        result = cgw("emit", "eds", path, "-o", self.dir / "x.eds")
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertFalse((self.dir / "x.eds").exists())

    def test_unwritable_outputs_are_exit_3(self):
        self.assertEqual(cgw("emit", "eds", GENSET, "-o", "/dev/full").returncode, 3)
        self.assertEqual(cgw("emit", "eds", GENSET, "-o", self.dir / "none" / "x.eds").returncode, 3)
        with open("/dev/full", "wb") as full:
            self.assertEqual(cgw("emit", "eds", GENSET, stdout=full).returncode, 3)

    def test_depfile_names_every_file_that_was_read(self):
        catalogue = self.dir / "more.toml"
        catalogue.write_text((SAMPLES.parent / "tests/data/catalogue/empty.toml").read_text()
                             if (SAMPLES.parent / "tests/data/catalogue/empty.toml").exists() else 'device = "governor"\n')
        text = pathlib.Path(GENSET).read_text()
        file = self.dir / "with catalogue.toml"
        file.write_text(text.replace("format = 1\n", 'format = 1\ncatalogue = ["more.toml"]\n', 1))
        result = cgw("emit", "image", file, "-o", self.dir / "x.bin", "--depfile", self.dir / "x.d")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.dir / "x.d").read_text(),
                         f"{self.dir}/x.bin: \\\n  {self.dir}/with\\ catalogue.toml \\\n  {self.dir}/more.toml\n"
                         f"{self.dir}/more.toml:\n")

    def test_check_tells_fresh_from_stale(self):
        target = self.dir / "x.eds"
        self.assertEqual(cgw("emit", "eds", GENSET, "-o", target, "--check").returncode, 1)
        cgw("emit", "eds", GENSET, "-o", target)
        self.assertEqual(cgw("emit", "eds", GENSET, "-o", target, "--check").returncode, 0)
        self.assertEqual(cgw("emit", "eds", GENSET, "-o", target, "--list-outputs").stdout.decode(), f"{target}\n")


class Schema(Verb):
    def test_prints_a_schema_that_writes_and_checks_itself(self):
        printed = cgw("schema")
        self.assertEqual((printed.returncode, printed.stderr), (0, b""))
        self.assertEqual(json.loads(printed.stdout)["$schema"], "http://json-schema.org/draft-07/schema#")
        target = self.dir / "s.json"
        missing = cgw("schema", "--check", "-o", target)
        self.assertEqual(missing.returncode, 1)
        self.assertIn(f"{target} is missing or stale; run cgw schema -o {target}", missing.stderr.decode())
        self.assertEqual(cgw("schema", "-o", target).returncode, 0)
        self.assertEqual(target.read_bytes(), printed.stdout)
        self.assertEqual(cgw("schema", "--check", "-o", target).returncode, 0)
        target.write_bytes(printed.stdout + b" ")
        self.assertEqual(cgw("schema", "--check", "-o", target).returncode, 1)

    def test_check_needs_a_file_and_writing_can_fail(self):
        self.assertEqual(cgw("schema", "--check").returncode, 2)
        self.assertEqual(cgw("schema", "-o", self.dir / "none" / "s.json").returncode, 3)
        with open("/dev/full", "wb") as full:
            self.assertEqual(cgw("schema", stdout=full).returncode, 3)

    def test_the_samples_name_the_schema(self):
        for path in set(SAMPLES.rglob("*.toml")) - set((SAMPLES / "scenarios").iterdir()):
            directive, name = path.read_text().split("\n")[0].split(" ")
            self.assertEqual(directive, "#:schema", path)
            self.assertTrue((path.parent / name).samefile(SAMPLES.parent / "schemas/parameter-file.schema.json"), path)


class New(Verb):
    VALUES = {"416 CanBaudrate": 250, "416 HzmCanBaudrate": 250, "426 CanOpenBaudrate": 125, "427 CanOpenMyNodeID": 5,
              "428 CanOpenPartnerNodeID": 127}

    def test_is_refused_for_its_five_values_and_clean_with_them(self):
        path = self.dir / "plant.toml"
        self.assertEqual(cgw("new", "-o", path, "--title", "Genset 2").returncode, 0)
        text = path.read_text()
        self.assertEqual(re.findall(r'^# FILL IN: .*(?:\n# [^"\n]*)+\n# "(.*)" =$', text, re.M), list(self.VALUES))
        report = json.loads(cgw("check", path, "--format", "json").stdout)
        errors = [f["message"] for f in report["files"][0]["diagnostics"] if f["level"] == "error"]
        self.assertEqual(len(errors), 5, errors)
        for label in self.VALUES:
            self.assertEqual(sum(label in message for message in errors), 1, (label, errors))
        for label, value in self.VALUES.items():
            text = text.replace(f'# "{label}" =\n', f'"{label}" = {value}\n')
        path.write_text(text)
        self.assertTrue(cgw("check", path).stdout.decode().startswith(f"{path}: valid, no findings\n"))
        self.assertIn(b"Genset 2", cgw("emit", "pdo-table", path).stdout)

    def test_overwrites_nothing_unless_told_to(self):
        path = self.dir / "plant.toml"
        path.write_text("mine")
        refused = cgw("new", "-o", path)
        self.assertEqual((refused.returncode, refused.stdout), (2, b""))
        self.assertIn(f"{path} exists; --force overwrites it", refused.stderr.decode())
        self.assertEqual(path.read_text(), "mine")
        self.assertEqual(cgw("new", "-o", path, "--force").returncode, 0)
        self.assertEqual(path.read_bytes(), cgw("new").stdout)

    def test_wrong_titles_and_places_are_refused(self):
        self.assertEqual(cgw("new", "--title", "").returncode, 2)
        self.assertEqual(cgw("new", "--title", "x" * 201).returncode, 2)
        self.assertEqual(cgw("new", "-o", self.dir / "none" / "x.toml").returncode, 3)
        self.assertEqual(cgw("new", "-o", self.dir).returncode, 3)


class Image(Verb):
    def setUp(self):
        super().setUp()
        self.image = self.dir / "x.bin"
        cgw("emit", "image", GENSET, "-o", self.image)

    def test_verify_tells_valid_from_refused(self):
        result = cgw("image", "verify", self.image)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertRegex(result.stdout.decode(), r"valid.*configuration id [0-9a-f]{16}")
        damaged = bytearray(self.image.read_bytes())
        damaged[100] ^= 4
        self.image.write_bytes(damaged)
        result = cgw("image", "verify", self.image)
        self.assertEqual((result.returncode, result.stdout), (1, b""))
        self.assertIn(b"refused: ", result.stderr)
        self.assertEqual(cgw("image", "inspect", self.image).returncode, 1)

    def test_files_that_are_no_image(self):
        for content in (b"", b"x", os.urandom(70000), pathlib.Path(GENSET).read_bytes()):
            self.image.write_bytes(content)
            self.assertEqual(cgw("image", "verify", self.image).returncode, 1)
        self.assertEqual(cgw("image", "verify", self.dir / "none.bin").returncode, 3)
        self.assertEqual(cgw("image", "verify", self.dir).returncode, 3)

    def test_inspect_shows_the_configuration(self):
        text = cgw("image", "inspect", self.image).stdout.decode()
        self.assertIn("TPDO4", text)
        self.assertLessEqual(max(map(len, text.split("\n"))), 80)
        document = json.loads(cgw("image", "inspect", self.image, "--json").stdout)
        self.assertEqual(document["format_version"], 1)


if __name__ == "__main__":
    unittest.main()
