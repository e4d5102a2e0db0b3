#!/usr/bin/env python3
"""What the partner's half makes of frames, in every language, is what lib/signals says.

Usage: agreement_test.py PARTNER_PROGRAM SOURCE_DIRECTORY

Frames are those of a simulated run of each sample, and random ones. The C header is compiled as C99 and C++ with every
warning an error, for the ARM as well where that compiler is installed, and run; Python is run; Structured Text is read
by the strict reader in structured_text.py, and interpreted; STX is read by that in stx.py. The same again with hostile names and texts.
"""
import csv
import importlib.util
import pathlib
import shutil
import subprocess
import sys
import tempfile
import types
import unittest

import structured_text
import stx

PROGRAM = sys.argv[1]
SOURCES = pathlib.Path(sys.argv[2])
SAMPLES = ["samples/genset.toml", "samples/manual-example.toml", "tests/data/full.toml"]
HOSTILE_SEEDS = range(1, 7)
WARNINGS = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wundef"]
COMPILERS = {"c99": ["gcc", "-std=c99"], "c++98": ["g++", "-std=c++98"], "c++20": ["g++", "-std=c++20"]}
HOSTILE_COMPILERS = {name: COMPILERS[name] for name in ("c99", "c++20")}
ARM = ["arm-none-eabi-gcc", "-std=c99", "-mcpu=cortex-m4", "-mthumb", "-ffreestanding", "-c"]


def run(*command, stdin=None):
    return subprocess.run(command, input=stdin, capture_output=True, text=True, timeout=300, check=False)


class Plant:
    """The halves of one plant in a directory of its own."""

    def __init__(self, sample, seed=0):
        self.name = f"{sample}, seed {seed}"
        self.seed = seed
        self.scratch = tempfile.TemporaryDirectory()
        self.directory = pathlib.Path(self.scratch.name)
        made = run(PROGRAM, str(SOURCES / sample), self.scratch.name, str(seed))
        if made.returncode != 0:
            raise AssertionError(f"{self.name}: {made.stderr}")

    def path(self, name):
        return str(self.directory / name)

    def text(self, name):
        return (self.directory / name).read_text(encoding="utf-8")


BUSY_PLANTS = [Plant(sample) for sample in SAMPLES] + [Plant(SAMPLES[0], seed) for seed in HOSTILE_SEEDS]
QUIET_PLANT = Plant("samples/minimal.toml")  # no PDO is active
PLANTS = BUSY_PLANTS + [QUIET_PLANT]


class Agreement(unittest.TestCase):
    maxDiff = 2000

    def test_the_frames_are_worth_comparing(self):
        for plant in BUSY_PLANTS:
            lines = plant.text("frames.txt").splitlines()
            identifiers = {line.split()[0] for line in lines}
            self.assertGreater(len(lines), 40 * len(identifiers))
            self.assertGreater(len(lines), 150)
        genset = BUSY_PLANTS[0].text("decoded.txt")
        for line in ("RPDO1 FunctLoadEnable 0 on", "RPDO1 FunctLoadEnable 1 off", "TPDO4 Speed "):
            self.assertIn(line, genset)

    def test_c_header(self):
        for plant in BUSY_PLANTS:
            for name, compiler in (COMPILERS if plant.seed == 0 else HOSTILE_COMPILERS).items():
                with self.subTest(plant=plant.name, compiler=name):
                    program = self.compiled(plant, name, compiler)
                    for given, expected in (("frames.txt", "decoded.txt"), ("encode.txt", "encoded.txt")):
                        said = run(program, stdin=plant.text(given))
                        self.assertEqual((said.returncode, said.stderr), (0, ""))
                        self.assertEqual(said.stdout, plant.text(expected))

    def compiled(self, plant, name, compiler):
        program = plant.path("program-" + name)
        language = "c" if name == "c99" else "c++"
        self.compiles(*compiler, *WARNINGS, "-x", language, plant.path("main.c"), "-o", program)
        return program

    def compiles(self, *command):
        made = run(*command)
        self.assertEqual((made.returncode, made.stderr[:2000]), (0, ""))

    def test_c_header_without_pdos_and_of_two_gateways(self):
        two = '#include "{}"\n#include "{}"\n#include "{}"\nint main(void) {{ return 0; }}\n'
        quiet, one, other = (plant.path("partner.h") for plant in (QUIET_PLANT, PLANTS[0], PLANTS[1]))
        source = QUIET_PLANT.directory / "two.c"
        source.write_text(two.format(one, other, one), encoding="utf-8")
        self.compiles(*COMPILERS["c99"], *WARNINGS, str(source), "-o", QUIET_PLANT.path("two"))
        self.compiles(*COMPILERS["c99"], *WARNINGS, "-x", "c", "-include", quiet, "-c", "/dev/null", "-o",
                      QUIET_PLANT.path("quiet.o"))

    @unittest.skipUnless(shutil.which(ARM[0]), "the ARM compiler is not installed")
    def test_c_header_on_arm(self):
        for plant in PLANTS:
            with self.subTest(plant=plant.name):
                self.compiles(*ARM, *WARNINGS, "-x", "c", "-include", plant.path("partner.h"), "/dev/null", "-o",
                              plant.path("arm.o"))

    def test_points(self):
        for plant in PLANTS:
            with self.subTest(plant=plant.name), open(plant.path("partner.csv"), encoding="utf-8", newline="") as file:
                points = list(csv.DictReader(file))
                self.assertEqual(decode_by_points(points, plant.text("frames.txt")), plant.text("decoded.txt"))
                self.assertEqual(len({point["tag"].lower() for point in points}), len(points))
                self.assertFalse([line for point in points for line in point.values() if "\n" in line])

    def test_python(self):
        for plant in PLANTS:
            with self.subTest(plant=plant.name):
                module = python_module(plant)
                self.assertEqual(decoded_by_python(module, plant), plant.text("decoded.txt"))
                self.assertEqual(encoded_by_python(module, plant), plant.text("encoded.txt"))

    def test_rest_is_every_switch_off_and_all_else_0(self):
        low_active = 0
        for plant in PLANTS:
            module = python_module(plant)
            header = plant.text("partner.h")
            for pdo in module.PDOS:
                if pdo.read:
                    self.assertEqual(pdo.rest, bytes(pdo.length))
                    continue
                self.assertEqual(module.encode(pdo.name, {}), pdo.rest)
                macro = f"GW{module.NODE_ID}_{pdo.name}_REST {{ {{ {', '.join(f'0x{byte:02x}' for byte in pdo.rest)} }} }}\n"
                self.assertIn("#define " + macro, header)
                expected = 0
                for signal in pdo.signals:
                    if signal.on is not None:
                        self.assertIs(module.value_of(signal, module.raw_value(signal, pdo.rest)), False)
                        expected |= (1 - signal.on) << signal.first_bit
                        low_active += 1 - signal.on
                self.assertEqual(int.from_bytes(pdo.rest, "little"), expected)
        self.assertGreater(low_active, 3)

    def test_python_refuses_what_is_no_pdo(self):
        module = python_module(BUSY_PLANTS[0])
        self.assertIsNone(module.decode(0x48C, bytes(7)))
        self.assertIsNone(module.decode(0x48D, bytes(8)))
        for name, values, error in (("TPDO4", {}, ValueError), ("RPDO9", {}, KeyError), ("RPDO2", {"x": 1}, KeyError),
                                    ("RPDO2", {"AssignIn_Setp1Ext": float("nan")}, ValueError),
                                    ("RPDO2", {"AssignIn_Setp1Ext": float("inf")}, ValueError)):
            with self.assertRaises(error, msg=name):
                module.encode(name, values)
        self.assertEqual(module.encode("RPDO2", {}, b"\x01\x02\x03\x04\x05\x06"), b"\x01\x02\x03\x04\x05\x06")

    def test_python_on_its_own(self):
        script = BUSY_PLANTS[0].path("partner.py")
        decoded = run(sys.executable, "-I", script, "decode", "48C#0000000000000000")
        self.assertEqual((decoded.returncode, decoded.stderr), (0, ""))
        self.assertIn("TPDO4 Speed 0.0 1/min\n", decoded.stdout)
        decoded = run(sys.executable, "-I", script, "decode", "20C#000000000000")
        self.assertIn("RPDO1 FunctLoadEnable on\n", decoded.stdout)
        for arguments, code in ((["decode", "48D#00"], 1), (["decode", "48C#0"], 2), (["decode", "#"], 2), (["decode"], 2),
                                ([], 2), (["listen"], 2)):
            result = run(sys.executable, "-I", script, *arguments)
            self.assertEqual((result.returncode, result.stdout), (code, ""))
            self.assertNotIn("Traceback", result.stderr)

    def test_python_with_a_canopen_network(self):
        module = python_module(BUSY_PLANTS[0])
        network, heard = Network(), []
        module.subscribe(network, lambda *what: heard.append(what))
        self.assertEqual(set(network.subscribers), {pdo.cob_id for pdo in module.PDOS if pdo.read})
        network.subscribers[0x48C](0x48C, bytearray(8), 1.5)
        network.subscribers[0x48C](0x48C, bytearray(3), 1.75)
        self.assertEqual([(name, values["Speed"], time) for name, values, time in heard], [("TPDO4", 0.0, 1.5)])
        module.start(network)
        module.send_heartbeat(network)
        module.send_periodic(network, "RPDO1", {"FunctLoadEnable": True, "FunctIdleSpeed": True})
        self.assertEqual(network.sent, [(0, b"\x01\x0C"), (0x701, b"\x05", 0.5),
                                        (0x20C, b"\x01\0\0\0\0\0", 0.125)])

    def test_structured_text(self):
        for plant in PLANTS:
            with self.subTest(plant=plant.name):
                program = structured_text.Program(plant.text("partner.st"))
                module = python_module(plant)
                for pdo in module.PDOS:
                    self.assertEqual(constant(program, pdo, "COB_ID"), pdo.cob_id)
                    self.assertEqual(constant(program, pdo, "LENGTH"), pdo.length)
                    self.assertEqual(constant(program, pdo, "CYCLE_US" if pdo.read else "MONITORING_US"), pdo.time_us)
                self.check_decoding(program, module, plant)
                self.check_encoding(program, module, plant)

    def check_decoding(self, program, module, plant):
        decoded = iter(plant.text("decoded.txt").splitlines())
        for identifier, data in (line.split() for line in plant.text("frames.txt").splitlines()):
            pdo = next(pdo for pdo in module.PDOS if pdo.cob_id == int(identifier, 16))
            data = list(bytes.fromhex(data))
            members = decoded_by_structured_text(program, module, pdo, data)
            for signal, value in zip(pdo.signals, members.values()):
                _, name, raw, *rest = next(decoded).split()
                self.assertEqual(name, signal.name)
                if signal.bits == 1:
                    self.assertEqual(value, rest[0] == "on" if rest else raw == "1")
                elif isinstance(value, float):
                    scale = abs(int(raw) * signal.factor) + abs(signal.offset)
                    self.assertLessEqual(abs(value - float(rest[0])), 4 * scale / 2**24, name)
                else:
                    self.assertEqual(value, int(raw))
        self.assertIsNone(next(decoded, None))

    def check_encoding(self, program, module, plant):
        put = refused = 0
        for asked, expected in zip(plant.text("encode.txt").splitlines(), plant.text("encoded.txt").splitlines()):
            name, *values = asked.split()
            _, data, could = expected.split()
            pdo = module.find_pdo(name)
            said, written = encoded_by_structured_text(program, module, pdo, [float(value) for value in values])
            self.assertEqual(said, "0" not in could, asked)
            put, refused = put + said, refused + (not said)
            if not said:
                self.assertEqual(written, [0xAA] * 8)
                continue
            self.assertEqual(written[pdo.length:], [0xAA] * (8 - pdo.length))
            self.assert_same_raw(pdo, bytes(written[:pdo.length]), bytes.fromhex(data), module)
        if plant.text("encode.txt"):
            self.assertGreater(min(put, refused), 10)

    def assert_same_raw(self, pdo, found, expected, module):
        """Half a step can be rounded to either side in 32 bits."""
        for signal in pdo.signals:
            difference = abs(module.raw_value(signal, found) - module.raw_value(signal, expected))
            self.assertLessEqual(difference, 1 if signal.scaled else 0, signal.name)

    def test_stx(self):
        for plant in PLANTS:
            with self.subTest(plant=plant.name):
                program = stx.Program(plant.text("partner.stx"))
                module = python_module(plant)
                self.assertEqual((program.started, program.operational), (module.NODE_ID, True))
                self.assertEqual(program.own_node or 0, module.PARTNER_NODE_ID)
                registers = (400100 + module.NODE_ID, 400228 + module.NODE_ID)
                self.assertEqual(tuple(program.defines[f"GW{module.NODE_ID}_REG_{what}"] for what in ("STATE", "TIMEOUT")),
                                 registers)
                for pdo in module.PDOS:
                    self.check_stx_pdo(program, module, pdo)
                identifiers = {call[0] for call in program.received + program.sent}
                self.assertEqual(identifiers, {pdo.cob_id for pdo in module.PDOS})

    def check_stx_pdo(self, program, module, pdo):
        """Each signal lies in a word that is received or sent, and its definitions say what Python's table says."""
        words = program.words(program.received if pdo.read else program.sent, pdo.cob_id)
        self.assertFalse(program.words(program.sent if pdo.read else program.received, pdo.cob_id))
        signals = [signal for signal in pdo.signals]
        bits = defined(program, module, pdo, "BIT")
        factors, offsets = defined(program, module, pdo, "FACTOR"), defined(program, module, pdo, "OFFSET")
        self.assertEqual(bits, [signal.first_bit % 16 for signal in signals if signal.bits == 1])
        self.assertEqual(factors, [signal.factor for signal in signals if signal.scaled])
        self.assertEqual(offsets, [signal.offset for signal in signals if signal.scaled])
        if not pdo.read:
            rest = {byte: int.from_bytes(pdo.rest[byte:byte + 2], "little") for byte in words}
            self.assertEqual({byte: program.values[variable] for byte, (_, variable, _) in words.items()}, rest)
        for signal in signals:
            signed, _, time = words[signal.first_bit // 16 * 2]
            self.assertEqual(signed, signal.signed)
            if pdo.time_us >= 4000:
                self.assertLessEqual(time, pdo.time_us / (1000 if pdo.read else 4000))
        self.assertLessEqual(max(words) + 2, pdo.length)


class Network:
    """What the forms use of canopen.Network."""

    def __init__(self):
        self.subscribers, self.sent = {}, []

    def subscribe(self, can_id, callback):
        self.subscribers[can_id] = callback

    def send_message(self, can_id, data, remote=False):
        self.sent.append((can_id, bytes(data)))

    def send_periodic(self, can_id, data, period, remote=False):
        self.sent.append((can_id, bytes(data), period))
        return types.SimpleNamespace()


def python_module(plant):
    specification = importlib.util.spec_from_file_location("partner", plant.path("partner.py"))
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def decoded_by_python(module, plant):
    lines = []
    for identifier, data in (line.split() for line in plant.text("frames.txt").splitlines()):
        name, values = module.decode(int(identifier, 16), bytes.fromhex(data))
        pdo = module.find_pdo(name)
        for signal in pdo.signals:
            line = f"{name} {signal.name} {module.raw_value(signal, bytes.fromhex(data))}"
            if signal.on is not None:
                line += " on" if values[signal.name] is True else " off"
            elif signal.factor is not None:
                line += f" {values[signal.name]:.17g}"
            lines.append(line + "\n")
    return "".join(lines)


def encoded_by_python(module, plant):
    lines = []
    for name, *values in (line.split() for line in plant.text("encode.txt").splitlines()):
        data, could = None, ""
        for signal, value in zip(module.find_pdo(name).signals, values):
            try:
                data = module.encode(name, {signal.name: float(value)}, data)
                could += "1"
            except ValueError:
                could += "0"
        data = data or bytes(module.find_pdo(name).length)
        lines.append(f"{name} {data.hex().upper()} {could}\n")
    return "".join(lines)


def constant(program, pdo, what):
    return next(value[1] for name, value in program.constants.items() if name.endswith(f"_{pdo.name}_{what}"))


def defined(program, module, pdo, what):
    """The values of the definitions of one kind, in the order in which they stand."""
    prefix = f"GW{module.NODE_ID}_{pdo.name}_{what}_"
    return [value for name, value in program.defines.items() if name.startswith(prefix)]


def type_name(module, pdo):
    return f"GW{module.NODE_ID}_{pdo.name}"


def decoded_by_structured_text(program, module, pdo, data):
    kind = type_name(module, pdo)
    members = program.new(kind)
    untouched = dict(members)
    padded = data + [0x55] * (8 - len(data))
    short = program.call(kind + "_DECODE", data=padded, length=pdo.length - 1, pdo=members)
    if short[kind + "_DECODE"] or members != untouched:
        raise AssertionError("a short frame was taken")
    if not program.call(kind + "_DECODE", data=padded, length=pdo.length, pdo=members)[kind + "_DECODE"]:
        raise AssertionError("a frame was refused")
    return members if pdo.signals else {}


def encoded_by_structured_text(program, module, pdo, values):
    kind = type_name(module, pdo)
    members = program.new(kind)
    for name, value in zip(members, values):
        kind_of = program.types[kind][1][name]
        members[name] = structured_text.real(value) if kind_of == "REAL" else bool(value) if kind_of == "BOOL" else int(value)
    data = [0xAA] * 8
    return program.call(kind + "_ENCODE", data=data, pdo=members)[kind + "_ENCODE"], data


def decode_by_points(points, frames):
    """The lines of decoded.txt, from the columns of the list alone."""
    lines = []
    for frame in frames.splitlines():
        identifier, data = frame.split()
        value = int.from_bytes(bytes.fromhex(data), "little")
        for point in points:
            if int(point["cob_id"], 16) != int(identifier, 16):
                continue
            width = int(point["bits"])
            raw = value >> (8 * int(point["byte"]) + int(point["bit"])) & ((1 << width) - 1)
            if point["type"] == "INT16" and raw >= 1 << 15:
                raw -= 1 << 16
            line = f"{point['pdo']} {point['tag'].split('.')[-1]} {raw}"
            if point["values"]:
                line += " " + dict(pair.split("=") for pair in point["values"].split("; "))[str(raw)]
            elif point["factor"]:
                line += f" {raw * float(point['factor']) + float(point['offset']):.17g}"
            lines.append(line + "\n")
    return "".join(lines)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
