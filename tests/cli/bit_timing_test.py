"""cgw bit-timing from outside: exit codes, both streams, all forms."""
import csv
import io
import json
import os
import pathlib
import re
import subprocess
import unittest

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
CHECKS = pathlib.Path(os.environ["CGW_TEST_DATA"]) / "checks"
DOCS = pathlib.Path(os.environ["CGW_DOCS"])
CONTROLLER = ("--clock", "16M", "--family", "mcp2515")


def bit_timing(*arguments):
    clean = {k: v for k, v in os.environ.items() if k != "NO_COLOR"}
    return subprocess.run([CGW, "bit-timing", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=clean, timeout=60, text=True)


class BitTiming(unittest.TestCase):
    def rows(self, *arguments, code=0):
        result = bit_timing(*arguments, "--format", "json")
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return json.loads(result.stdout)["timings"]

    def refused(self, message, *arguments):
        result = bit_timing(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn(message, result.stderr)

    def test_registers_to_rate(self):
        row, = self.rows(*CONTROLLER, "--registers", "1,0,0,6,1,5")
        self.assertEqual(row["kbit_per_s"], 250)
        self.assertEqual(row["cnf"], "01 B5 01")
        self.assertEqual((row["quanta"], row["quantum_ns"]), (16, 250))
        self.assertEqual((row["sample_point_percent"], row["tolerance_percent"]), (87.5, 0.3125))
        self.assertEqual((row["bus_length_m"], row["remark"]), (250, ""))

    def test_rate_to_registers(self):
        # What public calculators give for an MCP2515 at 16 MHz.
        for rate, cnf in (("1000", "00 91 01"), ("500", "00 B5 01"), ("250", "01 B5 01"), ("125", "03 B5 01")):
            self.assertEqual(self.rows(*CONTROLLER, "--rate", rate)[0]["cnf"], cnf)

    def test_there_and_back(self):
        for family in ("mcp2515", "at90can"):
            for row in self.rows("--clock", "8MHz", "--family", family):
                if row["remark"]:
                    continue
                registers = ",".join(str(row[key]) for key in ("brp", "sjw", "sam", "ps1", "ps2", "prop"))
                again, = self.rows("--clock", "8000000", "--family", family, "--registers", registers)
                self.assertEqual(again, row)

    def test_all_rates_of_canopen(self):
        rates = [row["kbit_per_s"] for row in self.rows(*CONTROLLER)]
        self.assertEqual(rates, [1000, 800, 500, 250, 125, 50, 20, 10])

    def test_what_a_controller_forbids_is_told(self):
        row, = self.rows(*CONTROLLER, "--registers", "3,0,0,6,0,5", code=1)
        self.assertEqual(row["remark"], "phase segment 2 has 1 TQ, the controller needs 2")

    def test_a_rate_out_of_reach(self):
        row, = self.rows("--clock", "7.3728M", "--family", "mcp2515", "--rate", "500", code=1)
        self.assertEqual((row["remark"], row["brp"]), ("this clock cannot make it", None))

    def test_a_plant(self):
        rows = self.rows(SAMPLES / "genset.toml")
        self.assertEqual([row["bus"] for row in rows], ["governor", "CAN1", "CAN2"])
        self.assertEqual([row["set_by"] for row in rows], ["416 = 250", "416 = 250", "426 = 250"])
        result = bit_timing(CHECKS / "sample-point" / "bad.toml")
        self.assertEqual(result.returncode, 0)
        self.assertIn("[E0317 sample-point]", result.stderr.replace("\n", " "))
        self.assertRegex(result.stdout, r"CAN2 +420\.\.425 +125 +3,0,0,4,5,3 +03 A3 05 +16 +62\.5 ")

    def test_a_plant_with_errors(self):
        result = bit_timing(CHECKS / "bit-timing-impossible" / "bad.toml")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("E0216", result.stderr)
        self.assertEqual(bit_timing(SAMPLES / "missing.toml").returncode, 3)

    def test_lines_fit_80_columns(self):
        for arguments in ([SAMPLES / "genset.toml"], [CHECKS / "sample-point" / "good.toml"], [*CONTROLLER],
                          [*CONTROLLER, "--registers", "3,3,0,6,0,5"]):
            for line in bit_timing(*arguments).stdout.splitlines():
                self.assertLessEqual(len(line), 80)

    def test_csv_and_markdown(self):
        rows = list(csv.DictReader(io.StringIO(bit_timing(*CONTROLLER, "--format", "csv").stdout)))
        self.assertEqual(rows[0]["cnf"], "00 91 01")
        self.assertIn("| 0,0,0,6,1,5 | 00 B5 01 |", bit_timing(*CONTROLLER, "--format", "md").stdout)

    def test_the_page_shows_what_it_prints(self):
        example = re.search(r"\$ cgw (bit-timing .*)\n((?:.+\n)+)```", (DOCS / "command-line.md").read_text())
        self.assertEqual(bit_timing(*example[1].split()[1:]).stdout, example[2])

    def test_wrong_usage(self):
        self.refused("FILE is missing, or --clock and --family")
        self.refused("FILE is missing, or --clock and --family", "--clock", "16M")
        self.refused("--clock and FILE exclude each other", SAMPLES / "genset.toml", "--clock", "16M")
        self.refused("go with neither --rate", *CONTROLLER, "--registers", "0,0,0,6,1,5", "--rate", "125")
        for registers in ("", "1", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,5,-6", "1,2,3,4,5,256", "a,b,c,d,e,f", ","):
            self.refused("is not six numbers", *CONTROLLER, "--registers", registers)
        for clock in ("0", "-1", "nan", "1e400", "2000M", "16G", "0.5", "M", ""):
            self.refused("--clock", "--clock", clock, "--family", "mcp2515")
        for rate in ("0", "1001", "x"):
            self.refused("--rate", *CONTROLLER, "--rate", rate)
        self.refused("--sample-point", *CONTROLLER, "--sample-point", "101")
        self.refused("--family", "--clock", "16M", "--family", "sja1000")


if __name__ == "__main__":
    unittest.main()
