"""python-can as master of the real gateway program over a hub, in real time: it knows the device from the EDS and the PDO
table that cgw writes, and from nothing else. Read here with configparser and json."""
import configparser
import json
import os
import queue
import re
import subprocess
import threading
import time
import unittest

from hub_test_case import CGW, HOST, HubTest, can

GATEWAY = os.environ["CGW_GATEWAY"]
PLANT = os.environ["CGW_PLANT"]  # the parameter file whose image the gateway has
ANSWER_WITHIN = 5
START, STOP, PRE_OPERATIONAL, RESET_NODE, RESET_COMMUNICATION = 0x01, 0x02, 0x80, 0x81, 0x82
HEARTBEAT = {START: 0x05, STOP: 0x04, PRE_OPERATIONAL: 0x7F}
PROCESS_VALUES = (0x1001, 0x2000, 0x2001, 0x2002, 0x2003, 0x2004, 0x2005)
SIZES = {0x03: 2, 0x05: 1, 0x06: 2, 0x07: 4}
LATE_RPDO, LOST_HEARTBEAT = 1 << 2, 1 << 9  # bits of 2005h: 12413, 12420


def product(*arguments):
    return subprocess.run([CGW, "emit", *arguments, PLANT], capture_output=True, check=True).stdout.decode()


PDOS = {pdo["name"]: pdo for pdo in json.loads(product("pdo-table", "--format", "json"))["pdos"] if pdo["active"]}
NODE = json.loads(product("pdo-table", "--format", "json"))["node_id"]
EDS = configparser.ConfigParser(interpolation=None, delimiters="=")
EDS.optionxform = str
EDS.read_string(product("eds"))


def value_of(text):
    return sum(NODE if part == "$NODEID" else int(part, 0) for part in text.split("+"))


def objects():
    """(index, sub-index, section of the EDS) of everything that can be read."""
    for name in EDS.sections():
        place = re.fullmatch(r"([0-9A-F]{4})(?:sub([0-9A-F]+))?", name)
        if place and "DataType" in EDS[name]:
            yield int(place[1], 16), int(place[2] or "0", 16), EDS[name]


class Master(HubTest):
    def setUp(self):
        super().setUp()
        self.can = self.bus()
        self.frames, self.answers = [], queue.Queue()
        self.ending = threading.Event()
        self.listener = threading.Thread(target=self.listen)
        self.listener.start()
        self.addCleanup(self.listener.join)
        self.addCleanup(self.ending.set)
        self.gateway = self.start([GATEWAY, "--can1", "simulated", "--can2", f"hub:{HOST}:{self.port}"])
        self.wait_for(0x700 + NODE, b"\x00")
        self.wait_for(0x700 + NODE, b"\x7f")

    def listen(self):
        while not self.ending.is_set():
            message = self.can.recv(timeout=0.2)
            if message is not None:
                self.frames.append((time.monotonic(), message.arbitration_id, bytes(message.data)))
                if message.arbitration_id == 0x580 + NODE:
                    self.answers.put(bytes(message.data))

    def send(self, identifier, data):
        self.can.send(can.Message(arbitration_id=identifier, is_extended_id=False, data=bytes(data)))

    def nmt(self, command, node=NODE):
        self.send(0x000, [command, node])

    def seen(self, identifier, since=0.0):
        return [(when, data) for when, number, data in list(self.frames) if number == identifier and when >= since]

    def wait_for(self, identifier, data=None, since=0.0):
        end = time.monotonic() + ANSWER_WITHIN
        while time.monotonic() < end:
            for when, found in self.seen(identifier, since):
                if data is None or found == data:
                    return when, found
            time.sleep(0.01)
        self.fail(f"{identifier:X}h {data} did not come: {[f'{i:X}' for _, i, _ in self.frames[-20:]]}")

    def enter(self, command):
        since = time.monotonic()
        self.nmt(command)
        self.wait_for(0x700 + NODE, bytes([HEARTBEAT[command]]), since)

    def ask(self, request, within=ANSWER_WITHIN):
        """The answer to an SDO request, None for silence."""
        while not self.answers.empty():
            self.answers.get()
        self.send(0x600 + NODE, request)
        try:
            return self.answers.get(timeout=within)
        except queue.Empty:
            return None

    @staticmethod
    def multiplexer(index, sub):
        return index.to_bytes(2, "little") + bytes([sub])

    def read(self, index, sub):
        """The data bytes, or the abort code."""
        answer = self.ask(b"\x40" + self.multiplexer(index, sub) + bytes(4))
        self.assertEqual(answer[1:4], self.multiplexer(index, sub))
        if answer[0] == 0x80:
            return int.from_bytes(answer[4:], "little")
        self.assertIn(answer[0], (0x43, 0x4B, 0x4F))
        return answer[4:4 + {0x43: 4, 0x4B: 2, 0x4F: 1}[answer[0]]]

    def number(self, index, sub):
        return int.from_bytes(self.read(index, sub), "little")

    def until(self, what, condition):
        end = time.monotonic() + ANSWER_WITHIN
        while not condition():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.02)


class Dictionary(Master):
    def read_all(self):
        count = 0
        for index, sub, section in objects():
            with self.subTest(object=section.name):
                data = self.read(index, sub)
                self.assertIsInstance(data, bytes)
                self.assertEqual(len(data), SIZES[int(section["DataType"], 0)])
                if index not in PROCESS_VALUES or (sub == 0 and index in range(0x2000, 0x2005)):
                    self.assertEqual(int.from_bytes(data, "little"), value_of(section["DefaultValue"]))
                count += 1
        self.assertGreater(count, 200)

    def test_holds_what_the_eds_says_in_pre_operational_and_operational(self):
        self.read_all()
        self.enter(START)
        self.read_all()

    def test_refuses_what_the_manual_says_it_refuses(self):
        read_only, no_object, no_sub, command = 0x06010002, 0x06020000, 0x06090011, 0x05040001
        for index, sub, section in objects():
            size = SIZES[int(section["DataType"], 0)]
            request = bytes([0x23 | (4 - size) << 2]) + self.multiplexer(index, sub) + bytes(4)
            self.assertEqual(self.ask(request), b"\x80" + request[1:4] + read_only.to_bytes(4, "little"), section.name)
        for request, code in ((b"\x40\x05\x10\x00", no_object), (b"\x40\x00\x60\x01", no_object), (b"\x40\x18\x10\x05", no_sub),
                              (b"\x40\x00\x10\x01", no_sub), (b"\x60\x18\x10\x01", command), (b"\xa0\x18\x10\x02", command),
                              (b"\x41\x18\x10\x03", command), (b"\x23\x17\x10\x00", 0x06070012), (b"\x2f\x17\x10\x00", 0x06070013)):
            self.assertEqual(self.ask(request + bytes(4)), b"\x80" + request[1:4] + code.to_bytes(4, "little"), request)
        self.assertIsNone(self.ask(b"\x80\x18\x10\x01" + bytes(4), within=0.5))
        self.assertIsNone(self.ask(b"\x40\x18\x10", within=0.5))
        self.assertEqual(self.read(0x1018, 1), (0x161).to_bytes(4, "little"))

    def test_is_what_cgw_verify_finds_as_well(self):
        def verify():
            return subprocess.run([CGW, "verify", PLANT, "--live", f"hub:{HOST}:{self.port}"], capture_output=True, text=True)
        self.enter(START)
        result = verify()
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        self.enter(STOP)
        result = verify()
        self.assertEqual(result.returncode, 3)
        self.assertIn(f"node {NODE} is Stopped", result.stdout)


class States(Master):
    def test_follow_every_command_and_the_heartbeat_tells(self):
        for command in (START, STOP, START, PRE_OPERATIONAL, STOP, PRE_OPERATIONAL, START):
            self.enter(command)
        period = value_of(EDS["1017"]["DefaultValue"]) / 1000
        since = time.monotonic()
        time.sleep(4 * period)
        times = [when for when, _ in self.seen(0x700 + NODE, since)]
        self.assertIn(len(times), (3, 4, 5))
        self.assertAlmostEqual((times[-1] - times[0]) / (len(times) - 1), period, delta=period / 8)

    def test_commands_for_others_and_malformed_ones_are_ignored(self):
        self.nmt(START, 0)
        self.wait_for(0x700 + NODE, b"\x05", time.monotonic() - 0.01)
        for data in ([STOP, NODE + 1], [STOP], [STOP, NODE, 0], [0x77, NODE], []):
            self.send(0x000, data)
        since = time.monotonic() + 0.2
        self.assertEqual(self.wait_for(0x700 + NODE, since=since)[1], b"\x05")

    def test_commands_back_to_back_all_count(self):
        for command in (START, STOP, PRE_OPERATIONAL, START, STOP):
            self.nmt(command)
        since = time.monotonic() + 0.2
        self.assertEqual(self.wait_for(0x700 + NODE, since=since)[1], b"\x04")

    def test_a_reset_gives_one_boot_up_and_then_pre_operational(self):
        for command in (RESET_NODE, RESET_COMMUNICATION):
            self.enter(START)
            since = time.monotonic()
            self.nmt(command)
            self.wait_for(0x700 + NODE, b"\x00", since)
            self.wait_for(0x700 + NODE, b"\x7f", since)
            after = [data for _, data in self.seen(0x700 + NODE, since)]
            self.assertEqual(after.count(b"\x00"), 1)
            self.assertNotIn(b"\x00", after[after.index(b"\x7f"):])

    def test_stopped_is_silent_but_for_the_heartbeat(self):
        self.enter(START)
        self.enter(STOP)
        since = time.monotonic()
        self.assertIsNone(self.ask(b"\x40\x00\x10\x00" + bytes(4), within=1.5))
        self.assertEqual({number for when, number, _ in self.frames if when >= since}, {0x700 + NODE})

    def test_process_data_is_sent_in_operational_only(self):
        identifiers = {pdo["cob_id"] for pdo in PDOS.values() if pdo["direction"] == "transmit"}
        time.sleep(1.5)
        self.assertFalse(identifiers & {number for _, number, _ in self.frames})
        self.enter(START)
        for identifier in identifiers:
            self.wait_for(identifier)


class ProcessData(Master):
    def setUp(self):
        super().setUp()
        self.produced = {0x700 + 1: b"\x05"}  # the partner's heartbeat
        self.stop_producing = threading.Event()
        self.producer = threading.Thread(target=self.produce)
        self.producer.start()
        self.addCleanup(self.producer.join)
        self.addCleanup(self.stop_producing.set)

    def produce(self):
        while not self.stop_producing.wait(0.1):
            for identifier, data in list(self.produced.items()):
                self.send(identifier, data)

    def words(self, name, of):
        """Data of a receive PDO, values by object: {(0x2004, 1): 30000}."""
        data = b""
        for word in PDOS[name]["mapping"]:
            data += of.get((word["index"], word["sub_index"]), 0).to_bytes(2, "little")
        return data

    def test_transmit_pdos_carry_what_sdo_reads_in_their_rhythm(self):
        self.enter(START)
        since = time.monotonic()
        read = {}
        while time.monotonic() < since + 5:
            for name, pdo in PDOS.items():
                if pdo["direction"] == "transmit":
                    for word in pdo["mapping"]:
                        place = word["index"], word["sub_index"]
                        read.setdefault(place, []).append(self.number(*place))
        for name, pdo in PDOS.items():
            if pdo["direction"] != "transmit":
                continue
            frames = self.seen(pdo["cob_id"])
            self.assertTrue(frames, name)
            for _, data in frames:
                self.assertEqual(len(data), pdo["length"], name)
            for position, word in enumerate(pdo["mapping"]):
                sent = [int.from_bytes(data[2 * position:2 * position + 2], "little") for _, data in frames]
                values = read[word["index"], word["sub_index"]]
                # Both are samples of one value that moves: their ranges must meet.
                self.assertLessEqual(max(min(sent), min(values)), min(max(sent), max(values)), (name, word["name"]))
            if pdo["effective_time_us"]:
                times = [when for when, _ in frames]
                period = (times[-1] - times[0]) / (len(times) - 1)
                self.assertAlmostEqual(period, pdo["effective_time_us"] / 1e6, delta=0.1 * period, msg=name)

    def test_receive_pdos_reach_their_objects(self):
        self.enter(START)
        for value in (0x1234, 0xFEDC):
            of = {(word["index"], word["sub_index"]): (value + 7 * word["sub_index"]) & 0xFFFF
                  for pdo in PDOS.values() if pdo["direction"] == "receive" for word in pdo["mapping"]}
            for name, pdo in PDOS.items():
                if pdo["direction"] == "receive":
                    self.produced[pdo["cob_id"]] = self.words(name, of=of)
            for place, expected in of.items():
                if place[0] != 0x0006:
                    self.until(f"{place} = {expected}", lambda p=place, e=expected: self.number(*p) == e)

    def test_a_receive_pdo_that_is_too_short_does_nothing_and_a_longer_one_does(self):
        self.enter(START)
        pdo = PDOS["RPDO2"]
        self.send(pdo["cob_id"], b"\x11" * (pdo["length"] - 1))
        time.sleep(0.3)
        self.assertEqual(self.number(0x2004, 1), 0)
        self.send(pdo["cob_id"], b"\x22" * 8)
        self.until("2004h:1", lambda: self.number(0x2004, 1) == 0x2222)

    def test_the_governor_obeys_a_setpoint(self):
        speed = PDOS["TPDO4"]["mapping"].index(next(w for w in PDOS["TPDO4"]["mapping"] if w["parameter"] == 2000))

        def last_speed():
            data = self.seen(PDOS["TPDO4"]["cob_id"])[-1][1]
            return int.from_bytes(data[2 * speed:2 * speed + 2], "little")
        self.enter(START)
        speeds = []
        for setpoint in (20000, 60000):
            for name, pdo in PDOS.items():
                if pdo["direction"] == "receive":
                    self.produced[pdo["cob_id"]] = self.words(name, of={(0x2004, 1): setpoint})
            time.sleep(8)
            speeds.append(last_speed())
        self.assertGreater(speeds[1], speeds[0] + 1000)

    def test_late_receive_pdos_and_a_lost_heartbeat_show_and_vanish(self):
        self.enter(START)
        for name, pdo in PDOS.items():
            if pdo["direction"] == "receive":
                self.produced[pdo["cob_id"]] = self.words(name, of={})
        self.until("no error", lambda: self.number(0x2005, 0) == 0)
        before = dict(self.produced)
        self.produced.pop(PDOS["RPDO3"]["cob_id"])
        self.until("12413", lambda: self.number(0x2005, 0) == LATE_RPDO)
        self.assertEqual(self.number(0x1001, 0), 0x11)
        self.produced.update(before)
        self.until("12413 gone", lambda: self.number(0x2005, 0) == 0)
        self.produced.pop(0x701)
        self.until("12420", lambda: self.number(0x2005, 0) == LOST_HEARTBEAT)
        self.produced.update(before)
        self.until("12420 gone", lambda: self.number(0x2005, 0) == 0)
        self.assertEqual(self.number(0x1001, 0) & 0x10, 0)


if __name__ == "__main__":
    unittest.main()
