"""cgw pdo, encode: frames drawn, and made of values, with exit codes and both output streams."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
GENSET = SAMPLES / "genset.toml"
SCHEMAS = SAMPLES.parent / "schemas"


def cgw(*arguments, **options):
    return subprocess.run([CGW, *map(str, arguments)], capture_output=True, check=False, timeout=120, **options)


def schema(name):
    return json.loads((SCHEMAS / name).read_text())


def frames_of(plant):
    document = json.loads(cgw("pdo", plant, "--layout", "--format", "json").stdout)
    jsonschema.validate(document, schema("frames.schema.json"))
    return document["frames"]


class Pdo(unittest.TestCase):
    def test_without_layout_it_is_the_pdo_table(self):
        for form in ("text", "md", "csv", "json"):
            shown = cgw("pdo", GENSET, "--format", form)
            self.assertEqual((shown.returncode, shown.stderr), (0, b""))
            self.assertEqual(shown.stdout, cgw("emit", "pdo-table", GENSET, "--format", form).stdout)

    def test_layouts_fit_80_columns(self):
        for name in ("genset.toml", "manual-example.toml", "minimal.toml"):
            shown = cgw("pdo", SAMPLES / name, "--layout")
            self.assertEqual((shown.returncode, shown.stderr), (0, b""))
            for line in shown.stdout.decode().splitlines():
                self.assertLessEqual(len(line), 80, line)
                self.assertEqual(line, line.rstrip())

    def test_one_frame_alone_by_name_and_identifier(self):
        named = cgw("pdo", GENSET, "TPDO4")
        self.assertEqual(named.returncode, 0)
        self.assertEqual(named.stdout, cgw("pdo", GENSET, "0x48C", "--layout").stdout)
        self.assertIn("3000 1/min -> 49151 -> FF BF -> 2999.98 1/min", named.stdout.decode())
        self.assertNotIn("TPDO5", named.stdout.decode())

    def test_an_inactive_frame_is_a_finding(self):
        shown = cgw("pdo", GENSET, "TPDO4", "TPDO9")
        self.assertEqual((shown.returncode, shown.stdout), (1, b""))
        self.assertIn("TPDO9: error: the plant has no active PDO", shown.stderr.decode())
        self.assertIn("frame-unknown", shown.stderr.decode())

    def test_a_layout_has_no_csv(self):
        self.assertEqual(cgw("pdo", GENSET, "--layout", "--format", "csv").returncode, 2)

    def test_layout_and_database_say_the_same(self):
        text = cgw("emit", "dbc", GENSET).stdout.decode()
        for frame in frames_of(GENSET):
            self.assertIn(f"BO_ {frame['cob_id']} GW12_{frame['name']}: {frame['length']} ", text)
            for signal in frame["signals"]:
                sign = "-" if signal["signed"] else "+"
                self.assertIn(f" SG_ {signal['name']} : {signal['first_bit']}|{signal['bits']}@1{sign} (", text)

    def test_wrong_files(self):
        self.assertEqual(cgw("pdo", "missing.toml").returncode, 3)
        self.assertEqual(cgw("pdo", "-", "--layout", input=b"format = 1\n").returncode, 1)

    def test_an_output_file(self):
        with tempfile.TemporaryDirectory() as name:
            target = pathlib.Path(name) / "frames.md"
            self.assertEqual(cgw("pdo", GENSET, "--layout", "--format", "md", "-o", target).returncode, 0)
            self.assertIn("## RPDO1\n", target.read_text())


class Encode(unittest.TestCase):
    def refused(self, code, *values, frame="RPDO2"):
        made = cgw("encode", GENSET, frame, *values)
        self.assertEqual((made.returncode, made.stdout), (1, b""), values)
        self.assertIn(f"[{code} ", made.stderr.decode())
        return " ".join(made.stderr.decode().split())

    def test_values_in_units_raw_and_bits(self):
        made = cgw("encode", GENSET, "RPDO2", "Setp1Ext=50%", "902=0x1F40 raw")
        self.assertEqual((made.returncode, made.stderr), (0, b""))
        lines = made.stdout.decode().splitlines()
        self.assertEqual(lines[0], "30C#0080401F0000")
        self.assertIn("0..1   900 AssignIn_Setp1Ext, channel 1: 50% -> 32768 -> 00 80 -> 50.0008 %", lines)
        made = cgw("encode", GENSET, "RPDO1", "LoadEnable=on", "IdleSpeed=ON", "Setp1Ext_Error=1", "--format", "cansend")
        self.assertEqual(made.stdout, b"20C#010000000100\n")

    def test_frames_that_the_gateway_sends_too(self):
        made = cgw("encode", GENSET, "TPDO4", "Speed=1500 1/min", "--format", "cansend")
        self.assertEqual(made.stdout, b"48C#0060000000000000\n")
        made = cgw("encode", GENSET, "TPDO2", "3070=1", "--format", "cansend")
        self.assertEqual(made.stdout, b"28C#40000000\n")

    def test_units_may_be_spelt_in_ascii(self):
        for value in ("CoolantTemp=80 °C", "CoolantTemp=80degC", "CoolantTemp=80"):
            made = cgw("encode", GENSET, "TPDO6", value, "--format", "cansend")
            self.assertEqual(made.stdout, b"681#E429000000000000\n", value)

    def test_json_fits_its_schema(self):
        document = json.loads(cgw("encode", GENSET, "RPDO2", "900=12.5", "--format", "json").stdout)
        jsonschema.validate(document, schema("encoded-frame.schema.json"))
        self.assertEqual([signal["given"] for signal in document["signals"]], [True, False, False])

    def test_what_is_wrong_is_said(self):
        self.assertIn("did you mean AssignIn_Setp1Ext?", self.refused("E1202", "Setp1Exd=50%"))
        self.assertIn("its range is 0..100 %", self.refused("E1204", "900=100.1"))
        self.assertIn("its range is 0..100 %", self.refused("E1204", "900=-1e300"))
        self.assertIn("it has 16 bits", self.refused("E1204", "900=65536 raw"))
        self.refused("E1204", "900=99999999999 raw")
        self.refused("E1204", "LoadEnable=2 raw", frame="RPDO1")
        for value in ("900", "900=", "900=raw", "900=x", "900=1,5", "900=5 bar", "900=0x10", "900=1e", "900=nan",
                      "900=99999999999999999999 raw"):
            self.refused("E1203", value)
        self.refused("E1203", "LoadEnable=maybe", frame="RPDO1")
        self.refused("E1205", "900=1", "Setp1Ext=2")
        self.refused("E1201", "900=1", frame="RPDO7")

    def test_all_mistakes_are_told_at_once(self):
        made = cgw("encode", GENSET, "RPDO2", "900=x", "901=1", "902=200")
        self.assertEqual(made.stderr.decode().count(": error: "), 3)

    def test_every_example_of_every_signal_encodes(self):
        for plant in ("genset.toml", "manual-example.toml"):
            for frame in frames_of(SAMPLES / plant):
                values = [f"{signal['name']}={signal['example']['value']}" for signal in frame["signals"]]
                made = json.loads(cgw("encode", SAMPLES / plant, frame["name"], *values, "--format", "json").stdout)
                self.assertEqual([signal["raw"] for signal in made["signals"]],
                                 [signal["example"]["raw"] for signal in frame["signals"]])


if __name__ == "__main__":
    unittest.main()
