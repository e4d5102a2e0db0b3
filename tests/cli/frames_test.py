"""cgw pdo, encode, decode: frames drawn, made of values and read back, with exit codes and both output streams."""
import csv
import io
import json
import os
import pathlib
import random
import struct
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

    def test_what_is_not_given_is_told_as_it_stands_in_the_frame(self):
        # FunctLoadEnable is low-active: off is a 1.
        made = cgw("encode", GENSET, "RPDO1").stdout.decode()
        self.assertEqual(made.splitlines()[0], "20C#040000000000")
        self.assertIn("0.2    835 FunctLoadEnable: off -> 1, not given\n", made)
        document = json.loads(cgw("encode", GENSET, "RPDO1", "--format", "json").stdout)
        enable, = [signal for signal in document["signals"] if signal["name"].endswith("LoadEnable")]
        self.assertEqual((enable["given"], enable["raw"], enable["text"]), (False, 1, "off"))

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


def decode(*arguments, **options):
    return cgw("decode", "--config", GENSET, *arguments, **options)


def pcap(frames):
    data = struct.pack("<IHHIIII", 0xA1B2C3D4, 2, 4, 0, 0, 262144, 227)
    for time_us, identifier, payload in frames:
        record = struct.pack(">IBBBB", identifier, len(payload), 0, 0, 0) + payload
        data += struct.pack("<IIII", time_us // 1000000, time_us % 1000000, len(record), len(record)) + record
    return data


class DecodeFrame(unittest.TestCase):
    def test_every_spelling(self):
        for words in (["0x48C", "00", "60", "00", "60", "00", "80", "00", "80"], ["48Ch", "0060006000800080"],
                      ["48C#0060006000800080"]):
            shown = decode(*words)
            self.assertEqual((shown.returncode, shown.stderr), (0, b""))
            self.assertIn("0..1   2000 Speed: 24576 -> 1500.02 1/min\n", shown.stdout.decode())

    def test_what_is_no_frame(self):
        for words in (["0x48C", "0"], ["0x800"], ["48C#0"], ["0x48C", "00112233445566778899"]):
            shown = decode(*words)
            self.assertEqual((shown.returncode, shown.stdout), (1, b""))
            self.assertIn("[E1206 frame-text]", shown.stderr.decode())
        short = decode("0x18C", "20", "00", "00", "80").stdout.decode()
        self.assertEqual(short.splitlines()[1:],
                         ["0.5    3005 ErrSetpointExtern: 1", "3.7    error 3031: 1",
                          "4.0    error 3032 and 31 flags after it: not in the frame, which is too short"])
        self.assertEqual(decode("run.log", "00").returncode, 2)
        self.assertEqual(decode("0x48C", "00", "--audit").returncode, 2)
        self.assertEqual(cgw("decode", "0x48C", "00").returncode, 2)
        self.assertEqual(cgw("decode", "0x48C", "00", "--config", "missing.toml").returncode, 3)

    def test_random_values_of_all_signals_come_back(self):
        rng = random.Random(23)
        for frame in frames_of(GENSET):
            raws = {s["name"]: rng.randint(s["raw_minimum"], s["raw_maximum"]) for s in frame["signals"]}
            made = cgw("encode", GENSET, frame["name"], *(f"{name}={raw} raw" for name, raw in raws.items()),
                       "--format", "cansend").stdout.decode().strip()
            line = decode(made, "--format", "json").stdout.decode().splitlines()[1]
            self.assertEqual({s["name"]: s["raw"] for s in json.loads(line)["signals"]}, raws)


class DecodeLog(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="cgw-frames-")
        cls.dir = pathlib.Path(cls.scratch.name)
        cls.log = cls.dir / "run.log"
        cgw("simulate", GENSET, "--duration", "5.5", "--log", cls.log)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def write(self, name, content):
        path = self.dir / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def test_the_simulated_plant_is_in_order(self):
        shown = decode(self.log, "--interface", "can2")
        self.assertEqual((shown.returncode, shown.stderr), (0, b""))
        text = shown.stdout.decode()
        for line in text.splitlines():
            self.assertLessEqual(len(line), 80, line)
        self.assertIn("  HB      node 12 boot-up\n", text)
        self.assertIn("  NMT     start, node 12\n", text)
        self.assertRegex(text, r"TPDO4 +48Ch +\d+ +125 +12\d")
        audit = decode(self.log, "--interface", "can2", "--audit").stdout.decode()
        self.assertTrue(text.endswith(audit))
        nobody = decode(self.log, "--interface", "can9", "--audit")
        self.assertEqual(nobody.returncode, 1)
        self.assertIn("no frame is of interface can9; this log has frames of can1, can2", nobody.stderr.decode())

    def test_json_is_a_document_on_each_line(self):
        shown = decode(self.log, "--interface", "can2", "--format", "json")
        self.assertEqual((shown.returncode, shown.stderr), (0, b""))
        validator = jsonschema.Draft202012Validator(schema("decoded-log.schema.json"))
        lines = [json.loads(line) for line in shown.stdout.decode().splitlines()]
        for line in lines[:300] + lines[-3:]:
            validator.validate(line)
        self.assertEqual([lines[0]["kind"], lines[1]["kind"], lines[-1]["kind"]], ["log", "frame", "audit"])
        self.assertEqual(lines[-1]["count"], len(lines) - 2)
        self.assertEqual(lines[-1]["findings"], [])

    def test_csv_has_a_line_for_each_signal(self):
        rows = list(csv.DictReader(io.StringIO(decode(self.log, "--format", "csv").stdout.decode())))
        speeds = [row for row in rows if row["signal"] == "Speed"]
        self.assertGreater(len(speeds), 20)
        self.assertAlmostEqual(float(speeds[-1]["physical"]), int(speeds[-1]["raw"]) * 4000 / 65535, delta=0.01)

    def test_pcap_and_screen_say_the_same_as_the_log(self):
        frames = []
        screen = []
        for line in self.log.read_text().splitlines():
            time, interface, frame = line.split()
            identifier, data = frame.split("#")
            if interface == "can2":
                time_us = int(time[1:-1].replace(".", ""))
                frames.append((time_us, int(identifier, 16), bytes.fromhex(data)))
                screen.append(f" ({time[1:-1]})  can0  {identifier}   [{len(data) // 2}]  {bytes.fromhex(data).hex(' ').upper()}")
        expected = decode(self.log, "--interface", "can2", "--audit").stdout
        for name, content in (("run.pcap", pcap(frames)), ("screen.txt", "\n".join(screen))):
            shown = decode(self.write(name, content), "--audit")
            self.assertEqual((shown.returncode, shown.stderr), (0, b""))
            self.assertEqual(shown.stdout, expected, name)

    def test_findings_and_exit_codes(self):
        # Without the NMT command nothing of the log says when Operational began; RPDO2 goes missing for 2 s.
        lines = [line for line in self.log.read_text().splitlines()
                 if not (" 30C#" in line and 3 < float(line[1:18]) < 5)]
        shown = decode(self.write("gap.log", "\n".join(lines)), "--interface", "can2", "--audit")
        self.assertEqual(shown.returncode, 1)
        said = " ".join(shown.stderr.decode().split())
        self.assertIn("error: RPDO2 (30Ch) stayed out for 2050", said)
        self.assertIn("[E1217 monitoring-exceeded]", said)
        self.assertRegex(said, r"gap\.log:\d+:1: error")

    def test_what_is_no_log(self):
        for name, content, code in (("empty.log", "", "E1209"), ("binary.log", bytes(range(256)) * 40, "E1207"),
                                    ("giant.log", "x" * 3_000_000, "E1207"), ("cut.pcap", pcap([(1, 1, b"1")])[:-3], "E1207"),
                                    ("length.pcap", pcap([])+ b"\xff" * 16, "E1207")):
            shown = decode(self.write(name, content))
            self.assertEqual(shown.returncode, 1, name)
            self.assertIn(f"[{code} ", shown.stderr.decode(), name)
        self.assertEqual(decode(self.dir / "missing.log").returncode, 3)
        self.assertEqual(decode(self.dir).returncode, 3)

    def test_standard_input(self):
        shown = decode("-", "--audit", "--interface", "can2", input=self.log.read_bytes())
        self.assertEqual(shown.stdout, decode(self.log, "--audit", "--interface", "can2").stdout)
        self.assertEqual(cgw("decode", "-", "--config", "-", input=b"").returncode, 2)

    def test_what_python_can_records(self):
        try:
            import can
        except ImportError:
            self.skipTest("python-can is not installed")
        path = self.dir / "python.log"
        with can.CanutilsLogWriter(str(path)) as writer:
            for i in range(20):
                writer.on_message_received(can.Message(timestamp=1 + i * 0.125, arbitration_id=0x48C, channel="can0",
                                                       is_extended_id=False, data=bytes([0, 0x60] * 4)))
        lines = [json.loads(line) for line in decode(path, "--format", "json").stdout.decode().splitlines()]
        self.assertEqual(lines[-1]["count"], 20)
        self.assertEqual(lines[1]["signals"][0]["text"], "1500.02 1/min")
        with can.CanutilsLogReader(str(self.log)) as reader:
            self.assertEqual(sum(1 for _ in reader), len(self.log.read_text().splitlines()))


if __name__ == "__main__":
    unittest.main()
