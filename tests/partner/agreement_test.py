#!/usr/bin/env python3
"""What the partner's half makes of frames, in every language, is what lib/signals says.

Usage: agreement_test.py PARTNER_PROGRAM SOURCE_DIRECTORY

Frames are those of a simulated run of each sample, and random ones. The C header is compiled as C99 and C++ with every
warning an error, for the ARM as well where that compiler is installed, and run. The same again with hostile names and
texts.
"""
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv[1]
SOURCES = pathlib.Path(sys.argv[2])
SAMPLES = ["samples/genset.toml", "samples/manual-example.toml", "tests/data/full.toml"]
HOSTILE_SEEDS = range(1, 9)
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
