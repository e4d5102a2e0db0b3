"""The command line from outside: exit code and both streams of every verb."""
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
GENSET = str(SAMPLES / "genset.toml")
ARTEFACTS = ["CANopenGateway.eds", "gateway-config.bin", "pdo-table.csv", "pdo-table.json", "pdo-table.md"]


def cgw(*arguments, stdin=None, stdout=subprocess.PIPE, **environment):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "SOURCE_DATE_EPOCH")}
    return subprocess.run([CGW, *map(str, arguments)], input=stdin, stdout=stdout, stderr=subprocess.PIPE,
                          env={**clean, **environment}, timeout=120)


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


class Check(Verb):
    def test_valid_samples_pass(self):
        for name in ("manual-example.toml", "minimal.toml", "genset.toml"):
            result = cgw("check", SAMPLES / name)
            self.assertEqual((result.returncode, result.stderr), (0, b""), name)
        self.assertEqual(cgw("check", GENSET).stdout.decode(), f"{GENSET}: valid, no findings\n")

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
        for format in ("human", "concise", "json"):
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
        self.assertEqual((result.returncode, result.stdout), (0, b"<stdin>: valid, no findings\n"))
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

    def test_full_standard_output_is_exit_3(self):
        with open("/dev/full", "wb") as full:
            result = cgw("check", GENSET, stdout=full)
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"No space left", result.stderr)


class Usage(Verb):
    def assert_usage(self, words, *arguments):
        result = cgw(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
        self.assertIn(words, result.stderr.decode())

    def test_mistakes_are_exit_2_and_go_to_stderr(self):
        self.assert_usage("did you mean 'check'?", "chek", GENSET)
        self.assert_usage("a verb is missing", *[])
        self.assert_usage("cgw image needs one of verify, inspect", "image")
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
        self.assert_usage("human, concise, json", "check", "--format", "xml", GENSET)
        self.assert_usage("--color", "check", "--color", "sometimes", GENSET)
        self.assert_usage("did you mean 'node-id-duplicate'?", "check", "-W", "no-node-id-duplicat", GENSET)
        self.assert_usage("cannot be hidden", "check", "-W", "no-node-id-duplicate", GENSET)
        self.assert_usage("did you mean 'pdo-table'?", "emit", "pdo-tabel", GENSET)
        self.assert_usage("the formats of pdo-table are", "emit", "pdo-table", GENSET, "--format", "xml")
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
        for arguments, name in ((["eds"], "CANopenGateway.eds"), (["image"], "gateway-config.bin"),
                                (["pdo-table", "--format", "md"], "pdo-table.md"),
                                (["pdo-table", "--format", "csv"], "pdo-table.csv"),
                                (["pdo-table", "--format", "json"], "pdo-table.json")):
            result = cgw("emit", arguments[0], GENSET, *arguments[1:])
            self.assertEqual((result.returncode, result.stderr), (0, b""), name)
            cgw("emit", arguments[0], GENSET, *arguments[1:], "-o", self.dir / name)
            built = (self.dir / "built" / name).read_bytes()
            self.assertEqual(result.stdout, built, name)
            self.assertEqual((self.dir / name).read_bytes(), built, name)

    def test_pdo_table_json_fits_its_schema(self):
        schema = json.loads((SAMPLES.parent / "schemas/pdo-table.schema.json").read_text())
        for name in ("minimal.toml", "genset.toml", "manual-example.toml"):
            document = json.loads(cgw("emit", "pdo-table", SAMPLES / name, "--format", "json").stdout)
            jsonschema.validate(document, schema)
            self.assertEqual([p["name"] for p in document["pdos"]],
                             [f"TPDO{n}" for n in range(1, 17)] + [f"RPDO{n}" for n in range(1, 5)])

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
                         f"{self.dir}/x.bin: \\\n  {self.dir}/with\\ catalogue.toml \\\n  {self.dir}/more.toml\n")

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
        for path in SAMPLES.rglob("*.toml"):
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
        self.assertEqual(re.findall(r'^# FILL IN: .*\n# .*\n# "(.*)" =$', text, re.M), list(self.VALUES))
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
