"""cgw network from outside: verdict, tables, foreign nodes, what-if, suggestions that patch applies."""
import csv
import io
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

import jsonschema

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
DATA = pathlib.Path(os.environ["CGW_TEST_DATA"])
SCHEMA = json.loads((SAMPLES.parent / "schemas" / "network-report.schema.json").read_text())
CHECK_SCHEMA = json.loads((SAMPLES.parent / "schemas" / "check-report.schema.json").read_text())
GENSET = SAMPLES / "genset.toml"

FULL = """format = 1
[governor]
main_cycle_us = 10000
[governor.parameters]
401 = 1
403 = 2
416 = 250
4406 = 1
16400 = [{words}]
16460 = [{cycles}]
[gateway.parameters]
401 = 2
402 = 1
416 = 250
4400 = 1
426 = {rate}          # of the whole bus
427 = {node}
429 = 1000
16404 = [{identifiers}]
"""


def place(path, start, column):
    """Line and column of the first line that begins so."""
    lines = path.read_text(encoding="latin-1").splitlines()
    return f"{[line.startswith(start) for line in lines].index(True) + 1}:{column}"


def plant(node=1, cycle=10, rate=125, first=0x680, tpdos=13, more=""):
    """A gateway with TPDO4.. of 8 bytes each."""
    return FULL.format(words=", ".join(str((2000, 2031, 2300)[i % 3]) for i in range(4 * tpdos)),
                       cycles=", ".join([str(cycle)] * tpdos), rate=rate, node=node,
                       identifiers=", ".join(f"0x{first + i:X}" for i in range(tpdos - 1))) + more


class Network(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.dir)

    def write(self, name, text):
        (self.dir / name).write_text(text)
        return name

    def run_cgw(self, *arguments, verb="network", code=None, timeout=60):
        result = subprocess.run([CGW, verb, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                timeout=timeout, text=True, cwd=self.dir)
        if code is not None:
            self.assertEqual(result.returncode, code, result.stderr + result.stdout)
        return result

    def report(self, *arguments, code=0):
        result = self.run_cgw(*arguments, "--format", "json", code=code)
        document = json.loads(result.stdout)
        jsonschema.validate(document, SCHEMA)
        self.assertEqual(document["works"], code == 0)
        jsonschema.validate(document["findings"], CHECK_SCHEMA)
        self.assertEqual(document["findings"]["valid"], code == 0)
        return document

    def message(self, document, identifier):
        found, = [m for m in document["result"]["messages"] if m["identifier"] == identifier]
        return found

    def test_the_sample_works(self):
        result = self.run_cgw(GENSET, code=0)
        self.assertEqual(result.stderr, "")
        self.assertRegex(result.stdout, r"^it will work: 250 kbit/s, load \d+\.\d % on average and up to \d+\.\d %")
        for line in result.stdout.splitlines():
            self.assertLessEqual(len(line), 80)
        document = self.report(GENSET)
        tpdo4 = self.message(document, 0x48C)
        self.assertEqual((tpdo4["name"], tpdo4["sender"], tpdo4["bytes"]), ("TPDO4", "node 12", 8))
        self.assertEqual((tpdo4["period_ms"], tpdo4["deadline_ms"]), (125, 125))
        event = self.message(document, 0x18C)
        self.assertEqual((event["release"], event["period_ms"], event["average_load"]), ("event", 15.625, 0))
        received = self.message(document, 0x30C)
        self.assertTrue(received["assumed"])
        self.assertAlmostEqual(received["period_ms"], received["deadline_ms"] / 2, places=3)
        heartbeat = self.message(document, 0x70C)
        self.assertEqual((heartbeat["period_ms"], heartbeat["bytes"]), (800, 1))
        self.assertTrue(self.message(document, 0x58C)["assumed"])
        self.assertTrue(self.message(document, 0x701)["assumed"])

    def test_identifiers_are_mapped_without_gaps(self):
        ranges = self.report(GENSET)["identifiers"]
        self.assertEqual((ranges[0]["first"], ranges[-1]["last"]), (0, 2047))
        for before, after in zip(ranges, ranges[1:]):
            self.assertEqual(before["last"] + 1, after["first"])
        text = self.run_cgw(GENSET, "--map", code=0).stdout
        self.assertIn("680 free   |#...", text)
        self.assertIn("free identifiers: 682h..6DFh", text)
        for line in text.splitlines():
            self.assertLessEqual(len(line), 80)

    def test_a_bus_that_is_full(self):
        self.write("full.toml", plant())
        result = self.run_cgw("full.toml", code=1)
        self.assertTrue(result.stdout.startswith("it will not work: 125 kbit/s"), result.stdout)
        self.assertIn("unbounded", result.stdout)
        self.assertIn("[E1105 message-unbounded]", result.stderr.replace("\n", " "))
        document = self.report("full.toml", code=1)
        self.assertGreater(document["result"]["worst_load"], 0.8)

    def test_bands(self):
        self.write("plant.toml", plant(cycle=40))
        self.assertEqual(self.report("plant.toml", "--bands", "30,50,90")["result"]["band"], "ok")
        self.run_cgw("plant.toml", "--bands", "10,20,25", code=1)
        self.assertIn("E1107", self.run_cgw("plant.toml", "--bands", "10,20,25").stderr)
        self.assertIn("E1108", self.run_cgw("plant.toml", "--bands", "10,20,90", code=0).stderr)

    def test_errors_and_jitter_make_it_later(self):
        calm = self.report(GENSET)["result"]["messages"]
        for options in (["--errors", "10"], ["--jitter", "5"]):
            rough = self.report(GENSET, *options)["result"]["messages"]
            self.assertTrue(all(a["response_ms"] <= b["response_ms"] for a, b in zip(calm, rough)))
            self.assertLess(sum(m["response_ms"] for m in calm), sum(m["response_ms"] for m in rough))
        self.assertLess(len(self.report(GENSET, "--sdo", "0")["result"]["messages"]), len(calm))

    def test_two_plants_on_one_bus(self):
        self.write("a.toml", plant(1, 200))
        self.write("b.toml", plant(2, 200, first=0x690))
        document = self.report("a.toml", "b.toml")
        self.assertEqual([p["node_id"] for p in document["plants"]], [1, 2])
        self.assertEqual({self.message(document, i)["sender"] for i in (0x680, 0x690)}, {"node 1", "node 2"})
        self.write("b.toml", plant(2, 200, first=0x68B))
        result = self.run_cgw("a.toml", "b.toml", code=1)
        self.assertIn("68Bh is sent as TPDO16 of node 1 and as TPDO5 of node 2", " ".join(result.stderr.split()))
        document = json.loads(self.run_cgw("a.toml", "b.toml", "--format", "json").stdout)
        self.assertIn({"first": 0x68B, "last": 0x68B, "use": "conflict",
                       "owners": ["TPDO16 of node 1", "TPDO5 of node 2"]}, document["identifiers"])
        self.write("b.toml", plant(2, 200, rate=250, first=0x690))
        result = self.run_cgw("a.toml", "b.toml", code=1)
        self.assertIn("E1102", result.stderr)
        self.assertEqual(result.stdout, "")
        self.write("b.toml", plant(1, 200))
        self.assertEqual(self.run_cgw("a.toml", "b.toml", code=1).stderr.count("[E1"), 1)

    def test_rows_of_messages(self):
        rows = ('[[network.message]]\nid = 0x30C\nbytes = 8\nperiod_ms = 12.5\nname = "setpoint"\njitter_ms = 2\n'
                "deadline_ms = 10\n[[network.message]]\nid = 0x123\nperiod_ms = 1000\n")
        self.write("rows.toml", GENSET.read_text() + rows)
        document = self.report("rows.toml")
        row = self.message(document, 0x30C)
        self.assertEqual((row["name"], row["period_ms"], row["jitter_ms"], row["deadline_ms"], row["assumed"]),
                         ("setpoint", 12.5, 2, 10, False))
        self.assertEqual(self.message(document, 0x123)["name"], "message 123h")
        self.run_cgw("rows.toml", verb="check", code=0)
        self.write("short.toml", GENSET.read_text() + "[[network.message]]\nid = 0x30C\nbytes = 1\nperiod_ms = 10\n")
        self.assertIn("E1110", self.run_cgw("short.toml", code=1).stderr)

    def test_wrong_rows_are_findings_of_the_file(self):
        for row, code in (("id = 2048\nperiod_ms = 1", "E0104"), ("id = 1", "E0103"), ("id = 1\nperiod_ms = 0", "E0104"),
                          ("id = 1\nperiod_ms = -1", "E0104"), ("id = 1\nperiod_ms = 1e300", "E0104"),
                          ("id = 1\nperiod_ms = nan", "E0104"), ("id = 1\nperiod_ms = 1.0801", "E0104"),
                          ("id = 1\nperiod_ms = 1e-4", "E0104"), ("id = 1\nperiod_ms = 1\njitter_ms = 0.0005", "E0104"),
                          ("id = 1\nperiod_ms = 1\ndeadline_ms = 0", "E0104"),
                          ("id = 1\nperiod_ms = 1\ndeadline_ms = 0.5001", "E0104"),
                          ("id = 1\nperiod_ms = \"1\"", "E0102"),
                          ("id = 1\nperiod_ms = 1\nbytes = 9", "E0104"), ("id = 1\nperiod_ms = 1\nperiod = 1", "E0101")):
            self.write("rows.toml", plant(cycle=500) + "[[network.message]]\n" + row + "\n")
            result = self.run_cgw("rows.toml", code=1)
            self.assertEqual(result.stdout, "")
            self.assertIn(code, result.stderr, row)

    def test_times_of_rows_are_whole_microseconds(self):
        for time_ms in ("1.080", "0.001", "3599999.999", "3600000", "15.625", "0.3", "1e-3", "999999.007"):
            self.write("rows.toml", plant(cycle=500) + f"[[network.message]]\nid = 0x7F0\nperiod_ms = {time_ms}\n"
                       f"deadline_ms = {time_ms}\njitter_ms = 0\n")
            self.run_cgw("rows.toml", verb="check", code=0)
        self.write("rows.toml", plant(cycle=500) + "[[network.message]]\nid = 1\nperiod_ms = 0\n")
        self.assertIn("`period_ms` is 0, which is no time", " ".join(self.run_cgw("rows.toml", code=1).stderr.split()))

    def test_thousands_of_rows(self):
        rows = "".join(f"[[network.message]]\nid = {i}\nbytes = 8\nperiod_ms = {2000 + i}.125\n"
                       for i in range(0x100, 0x680) if i not in (0x181, 0x201, 0x281, 0x481, 0x581, 0x601))
        self.write("many.toml", plant(cycle=500, rate=1000) + rows)
        begin = time.monotonic()
        self.assertGreater(len(self.report("many.toml")["result"]["messages"]), 1300)
        self.assertLess(time.monotonic() - begin, 30)
        faulty = "".join(f"[[network.message]]\nid = {i + 5000}\nperoid_ms = 0\nname = 5\n" for i in range(2000))
        self.write("faulty.toml", plant() + faulty)
        begin = time.monotonic()
        self.run_cgw("faulty.toml", code=1)
        self.assertLess(time.monotonic() - begin, 30)

    def test_the_order_of_the_files_says_nothing(self):
        partner = "428 = 1\n430 = {}\n"
        row = "[[network.message]]\nid = 0x180\nbytes = 8\nperiod_ms = 1.68\nname = \"fast\"\ndeadline_ms = 3\n"
        self.write("a.toml", plant(5, 500, tpdos=2, more=partner.format(2000)))
        self.write("b.toml", plant(6, 500, tpdos=2, first=0x690, more=partner.format(32) + row))
        results = []
        for order in (("a.toml", "b.toml"), ("b.toml", "a.toml")):
            result = self.run_cgw(*order, "--format", "json")
            document = json.loads(result.stdout)
            self.assertEqual(self.message(document, 0x701)["period_ms"], 16)
            results.append((result.returncode, document["works"], document["result"]["worst_load"],
                            [(m["identifier"], m["period_ms"], m["response_ms"]) for m in document["result"]["messages"]]))
        self.assertEqual(*results)

    def test_a_description_of_another_node_than_asked_for(self):
        self.run_cgw("dcf", GENSET, "-o", "node.dcf", verb="emit", code=0)
        self.write("plant.toml", plant(1, 500, first=0x690, rate=250))
        result = self.run_cgw("plant.toml", "--node", "node.dcf:5", code=2)
        self.assertIn("node.dcf is about node 12, and 5 is asked for", " ".join(result.stderr.split()))

    def test_another_node_from_its_data_sheet(self):
        self.run_cgw("eds", GENSET, "-o", "node.eds", verb="emit", code=0)
        self.write("plant.toml", plant(1, 500, first=0x690))
        document = self.report("plant.toml", "--node", "node.eds:12")
        self.assertEqual(self.message(document, 0x48C)["sender"], "node 12")
        self.assertEqual(self.message(document, 0x48C)["bytes"], 8)
        self.assertEqual(self.message(document, 0x70C)["period_ms"], 800)
        for option in ("node.eds", "node.eds:0", "node.eds:128", ":5", "node.eds:x"):
            self.assertIn("--node", self.run_cgw("plant.toml", "--node", option, code=2).stderr)
        self.run_cgw("plant.toml", "--node", "missing.eds:5", code=3)

    def test_a_node_id_belongs_to_one_device(self):
        self.run_cgw("eds", GENSET, "-o", "own.eds", verb="emit", code=0)
        alone = self.report(GENSET)
        told_twice = self.report(GENSET, "--node", "own.eds:12")
        self.assertEqual(alone, told_twice)
        self.report(GENSET, "--node", "own.eds:12", "--what-if", "TPDO5=100ms")
        sample = SAMPLES / "manual-example.toml"
        self.run_cgw("eds", sample, "-o", "quantised.eds", verb="emit", code=0)
        self.run_cgw(sample, "--node", "quantised.eds:1", code=0)
        eds = (self.dir / "own.eds").read_text(encoding="latin-1")
        begin = eds.index("[1017]")
        other = eds[:begin] + eds[begin:].replace("DefaultValue=0x0320", "DefaultValue=200", 1)
        self.assertNotEqual(eds, other)
        (self.dir / "other.eds").write_text(other, encoding="latin-1")
        result = self.run_cgw(GENSET, "--node", "other.eds:12", code=1)
        words = " ".join(result.stderr.split())
        self.assertIn("other.eds: error: a plant has node id 12 as well, and is another device: 70Ch heartbeat of node "
                      "12 is every 200 ms, and the plant's every 800 ms [E1104 node-shared]", words)
        self.assertEqual(words.count("[E1"), 1)
        self.assertTrue(result.stdout.startswith("it will not work"))
        result = self.run_cgw(SAMPLES / "minimal.toml", "--node", "own.eds:5", "--node", "own.eds:5", code=1)
        self.assertIn("two other nodes have node id 5 [E1104 node-shared]", " ".join(result.stderr.split()))

    def test_nodes_without_the_bit_rate_of_the_bus(self):
        self.run_cgw("eds", GENSET, "-o", "full.eds", verb="emit", code=0)
        eds = (self.dir / "full.eds").read_text(encoding="latin-1")
        self.assertIn("BaudRate_500=1", eds)
        self.write("slow.eds", eds.replace("BaudRate_500=1", "BaudRate_500=0").replace("BaudRate_1000=1", "BaudRate_1000=0"))
        self.write("plant.toml", plant(1, 500, first=0x690, rate=500))
        result = self.run_cgw("plant.toml", "--node", "slow.eds:12", code=1)
        self.assertIn("slow.eds:{}: error: node 12 has no 500 kbit/s, by its description: it has 125, 250 [E1114"
                      .format(place(self.dir / "slow.eds", "[DeviceInfo]", 2)),
                      " ".join(result.stderr.split()))
        self.run_cgw("plant.toml", "--node", "slow.eds:12", "--what-if", "baud=250", code=0)
        patch = self.run_cgw("plant.toml", "--node", "slow.eds:12", "--suggest", code=0).stdout
        self.assertIn("+426 = 250 ", patch)

    def test_nodes_that_are_set_to_another_bit_rate(self):
        self.run_cgw("dcf", GENSET, "-o", "node.dcf", verb="emit", code=0)
        rate, = [line for line in (self.dir / "node.dcf").read_text(encoding="latin-1").splitlines()
                 if line.startswith("Baudrate=")]
        self.assertEqual(rate.strip(), "Baudrate=250")
        self.write("plant.toml", plant(1, 500, first=0x690, rate=125))
        result = self.run_cgw("plant.toml", "--node", "node.dcf:12", code=1)
        self.assertIn("node.dcf:{}: error: node 12 is set to 250 kbit/s, and the bus has 125 [E1102"
                      .format(place(self.dir / "node.dcf", "Baudrate=", len("Baudrate=") + 1)),
                      " ".join(result.stderr.split()))
        self.run_cgw("plant.toml", "--node", "node.dcf:12", "--what-if", "baud=500", code=0)
        patch = self.run_cgw("plant.toml", "--node", "node.dcf:12", "--suggest", code=0).stdout
        self.assertIn("+426 = 250 ", patch)

    def test_two_files_that_tell_one_message(self):
        row = "[[network.message]]\nid = 0x301\nname = 'setpoint'\nbytes = 8\nperiod_ms = {}\n"
        self.write("a.toml", plant(1, 200, more=row.format(800)))
        self.write("b.toml", plant(2, 200, first=0x690, more=row.format(200)))
        document = self.report("a.toml", "b.toml")
        self.assertEqual(self.message(document, 0x301)["period_ms"], 200)
        result = self.run_cgw("a.toml", "b.toml", code=0)
        self.assertIn("warning: 301h setpoint comes every 200 ms, and elsewhere every 800 ms: the shorter counts [E1113",
                      " ".join(result.stderr.split()))
        self.write("b.toml", plant(2, 200, first=0x690, more=row.format(800)))
        self.assertNotIn("E1113", self.run_cgw("a.toml", "b.toml", code=0).stderr)

    def test_findings_about_a_node_say_where_its_description_has_it(self):
        self.run_cgw("eds", GENSET, "-o", "full.eds", verb="emit", code=0)
        eds = (self.dir / "full.eds").read_text(encoding="latin-1")
        own = eds[eds.index("[1800sub1]"):eds.index("[1800sub2]")]
        default, = [line for line in own.splitlines() if line.startswith("DefaultValue=")]
        self.write("foreign.eds", eds.replace(own, own.replace(default, "DefaultValue=0x690")))
        self.write("extended.eds", eds.replace(own, own.replace(default, "DefaultValue=0x20000690")))
        self.write("plant.toml", plant(1, 500, first=0x690, rate=500))
        header = place(self.dir / "foreign.eds", "[1800sub1]", 0).split(":")[0]
        line = int(header) + own.splitlines().index(default)
        words = " ".join(self.run_cgw("plant.toml", "--node", "foreign.eds:12", code=1).stderr.split())
        self.assertIn(f"foreign.eds:{line}:14: error: 690h is sent as", words)
        self.assertIn("DefaultValue=0x690", words)  # the line is shown
        words = " ".join(self.run_cgw("plant.toml", "--node", "extended.eds:12", code=0).stderr.split())
        self.assertIn(f"extended.eds:{line}:14: warning: TPDO1 of node 12: its identifier has 29 bits", words)

    def test_two_messages_of_one_name_and_identifier(self):
        row = "[[network.message]]\nid = 0x300\nname = \"status\"\nbytes = {}\nperiod_ms = 600\n"
        self.write("rows.toml", GENSET.read_text() + row.format(4) + row.format(8))
        self.assertIn("300h is sent as two messages of 4 and 8 bytes, each called status",
                      " ".join(self.run_cgw("rows.toml", code=1).stderr.split()))

    def test_errors_that_take_all_the_bus(self):
        sample = SAMPLES / "minimal.toml"
        result = self.run_cgw(sample, "--errors", "3000", code=1)
        words = " ".join(result.stderr.split())
        self.assertIn("minimal.toml:17:7: error: 000h NMT and 3 others may wait for ever: 3000 errors per second may take "
                      "all the bus [E1105 message-unbounded]", words)
        self.assertIn("help: raise the bit rate, or count with fewer errors", words)
        self.assertIn("minimal.toml: not valid, 1 error", words)
        self.write("full.toml", plant(more="[[network.message]]\nid = 0x10\nperiod_ms = 1\n"))
        words = " ".join(self.run_cgw("full.toml", code=1).stderr.split())
        self.assertIn("help: send it and what is above it less often, or raise the bit rate", words)

    def test_the_document_says_why_it_does_not_work(self):
        self.assertEqual(self.report(GENSET)["findings"]["files"], [])
        rows = ("[[network.message]]\nid = 0x30C\nbytes = 4\nperiod_ms = 600\n"
                "[[network.message]]\nid = 0x48C\nbytes = 8\nperiod_ms = 600\n"
                "[[network.message]]\nid = 0x40C\nbytes = 8\nperiod_ms = 2000\n")
        self.write("rows.toml", GENSET.read_text() + rows)
        file, = self.report("rows.toml", code=1)["findings"]["files"]
        self.assertEqual(file["path"], "rows.toml")
        codes = [finding["code"] for finding in file["diagnostics"]]
        self.assertEqual(sorted(codes), ["E1101", "E1110", "E1112", "E1112"])
        stderr = self.run_cgw("rows.toml", "--format", "json", code=1).stderr
        self.assertTrue(all(code in stderr for code in codes))
        remarks = {row["identifier"]: row["remark"] for row in
                   csv.DictReader(io.StringIO(self.run_cgw("rows.toml", "--format", "csv", code=1).stdout))}
        self.assertEqual([remarks[i] for i in ("30Ch", "48Ch", "40Ch", "680h")],
                         ["too short", "conflict", "too slow", ""])
        for line in self.run_cgw("rows.toml", code=1).stdout.splitlines():
            self.assertLessEqual(len(line), 80)

    def test_what_if(self):
        document = self.report(GENSET, "--what-if", "baud=125", "--what-if", "TPDO5=100ms")
        self.assertEqual(document["what_if"], ["baud=125", "TPDO5=100ms"])
        self.assertEqual((document["before"]["bit_rate"], document["result"]["bit_rate"]), (250000, 125000))
        before, = [m for m in document["before"]["messages"] if m["identifier"] == 0x680]
        self.assertEqual((before["period_ms"], self.message(document, 0x680)["period_ms"]), (500, 93.75))
        text = self.run_cgw(GENSET, "--what-if", "baud=125", code=0).stdout
        self.assertTrue(text.startswith("as it is, it will work: 250 kbit/s"), text)
        self.assertIn("with baud=125, it will work: 125 kbit/s", text)
        self.write("full.toml", plant())
        self.run_cgw("full.toml", "--what-if", "baud=500", code=0)
        for change in ("baud=0", "baud=333", "baud=20", "baud=", "baud=2000", "baud=12.5", "TPDO3=5", "TPDO17=5", "TPDO5=0", "TPDO5=x", "x", "TPDO5", "TPDO5=5000ms", "TPDO5=65535"):
            self.assertIn("--what-if", self.run_cgw(GENSET, "--what-if", change, code=2).stderr)
        for change in ("baud=125", "TPDO5=100"):
            again = self.run_cgw(GENSET, "--what-if", change, "--what-if", change, code=2)
            self.assertIn("is given twice", again.stderr)
        self.run_cgw(GENSET, "--what-if", "TPDO4=100", "--what-if", "TPDO5=100ms", code=0)
        self.assertIn("no plant sends TPDO16", self.run_cgw(GENSET, "--what-if", "TPDO16=100", code=2).stderr)

    def test_a_rate_set_by_hand(self):
        self.write("hand.toml", plant(cycle=500, more="4426 = 1\n420 = 3\n423 = 6\n424 = 1\n425 = 5\n"))
        result = self.run_cgw("hand.toml", code=1)
        self.assertIn("E1103", result.stderr)
        self.assertEqual(self.report("hand.toml", "--what-if", "baud=250")["before"], None)

    def apply(self, *paths, options=()):
        result = self.run_cgw(*paths, "--suggest", *options, code=0)
        patch = subprocess.run(["patch", "-p0"], input=result.stdout, cwd=self.dir, text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT)
        self.assertEqual(patch.returncode, 0, patch.stdout + result.stdout)
        for path in paths:
            self.run_cgw(path, verb="check", code=0)
        return result.stdout, self.report(*paths)

    def test_suggest_raises_the_bit_rate(self):
        self.write("full.toml", plant())
        patch, document = self.apply("full.toml")
        self.assertIn("+426 = 500          # of the whole bus", patch)
        self.assertEqual(document["result"]["bit_rate"], 500000)
        self.assertLessEqual(document["result"]["worst_load"], 0.5)

    def test_suggest_lengthens_cycles(self):
        self.write("full.toml", plant())
        _, document = self.apply("full.toml", options=["--keep-rate", "--target", "30"])
        self.assertEqual(document["result"]["bit_rate"], 125000)
        self.assertLessEqual(document["result"]["worst_load"], 0.3)

    def test_suggest_moves_identifiers(self):
        self.write("a b.toml", plant(1, 200))
        self.write("c.toml", plant(2, 200, first=0x68B).replace("16404 = [", "16404 = [ # first\n  ").rstrip("\n"))
        patch, document = self.apply("a b.toml", "c.toml", options=["--keep-rate"])
        self.assertIn("which nobody has", patch)
        self.assertEqual([r for r in document["identifiers"] if r["use"] == "conflict"], [])
        self.assertIn("# first", (self.dir / "c.toml").read_text())

    def test_suggest_refuses_paths_that_patch_refuses(self):
        self.write("full.toml", plant())
        (self.dir / "below").mkdir()
        self.write("below/full.toml", plant())
        for path in (self.dir / "full.toml", "../full.toml", "below/../full.toml"):
            result = self.run_cgw(path, "--suggest", code=2)
            self.assertIn("run cgw in the directory of the files", " ".join(result.stderr.split()))
            self.assertEqual(result.stdout, "")
        self.apply("./full.toml")
        self.apply("below/full.toml")

    def test_suggest_has_nothing_to_do_or_nothing_to_offer(self):
        self.write("genset.toml", GENSET.read_text())
        result = self.run_cgw("genset.toml", "--suggest", code=0)
        self.assertEqual(result.stdout, "")
        self.assertIn("nothing to suggest", result.stderr)
        rows = "".join(f"[[network.message]]\nid = {i}\nperiod_ms = 1\n" for i in range(16, 26))
        self.write("rows.toml", plant(more=rows))
        self.assertIn("nothing that --suggest may change", self.run_cgw("rows.toml", "--suggest", code=1).stderr)
        for more in (["--map"], ["--format", "json"], ["--what-if", "baud=250"]):
            self.run_cgw(GENSET, "--suggest", *more, code=2)
        self.run_cgw(GENSET, "--target", "30", code=2)

    def test_tables(self):
        rows = list(csv.DictReader(io.StringIO(self.run_cgw(GENSET, "--format", "csv", code=0).stdout)))
        self.assertEqual(rows[0]["message"], "NMT")
        page = self.run_cgw(GENSET, "--format", "md", code=0).stdout
        self.assertTrue(page.startswith("**it will work: 250 kbit/s, load "), page)
        self.assertIn("\n\n| id | message |", page)
        self.assertIn("\n\n- Times in ms: ", page)
        self.write("full.toml", plant(rate=500))
        page = self.run_cgw("full.toml", "--format", "md", "--what-if", "baud=125", code=1).stdout
        self.assertTrue(page.startswith("**as it is, it will work: 500 kbit/s, load "), page)
        self.assertIn("\n\n**with baud=125, it will not work: 125 kbit/s, load ", page)
        self.assertRegex(page, r"\n- error: .* \[E1105 message-unbounded\]\n")
        self.run_cgw(GENSET, "--format", "csv", "-o", "out.csv", code=0)
        self.assertTrue((self.dir / "out.csv").exists())

    def test_wrong_usage_and_missing_files(self):
        self.run_cgw(code=2)
        for option in (["--errors", "-1"], ["--errors", "x"], ["--jitter", "nan"], ["--bands", "30,50"],
                       ["--bands", "50,30,70"], ["--bands", "1,2,3,4"], ["--sdo", "1e9"]):
            self.run_cgw(GENSET, *option, code=2)
        self.run_cgw("missing.toml", code=3)
        self.run_cgw(DATA / "checks" / "cob-id-duplicate" / "bad.toml", code=1)
        self.write("plant.toml", plant(cycle=500))
        self.run_cgw("plant.toml", "-o", "plant.toml", code=2)


if __name__ == "__main__":
    unittest.main()
