"""cgw verify --live from outside, over a hub: against a device that is made here from the EDS that cgw writes, honest or
lying, and against buses on which nobody is what he should be."""
import configparser
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
SCHEMAS = SAMPLES.parent / "schemas"
PLANT = SAMPLES / "genset.toml"
NODE = 12
DEADLINE = 60
NO_OBJECT, NO_SUB_INDEX, READ_ONLY = 0x06020000, 0x06090011, 0x06010002


def objects_of(plant):
    """{(index, sub-index): (bytes, value)} of the EDS that cgw writes."""
    run = subprocess.run([CGW, "emit", "eds", plant], capture_output=True, check=True)
    eds = configparser.ConfigParser(interpolation=None, delimiters="=")
    eds.optionxform = str
    eds.read_string(run.stdout.decode("ascii"))
    objects = {}
    for section in eds.sections():
        name = re.fullmatch(r"([0-9A-F]{4})(?:sub([0-9A-F]+))?", section)
        if name and "DataType" in eds[section]:
            size = {0x05: 1, 0x06: 2, 0x03: 2, 0x07: 4}[int(eds[section]["DataType"], 0)]
            value = sum(NODE if part == "$NODEID" else int(part, 0) for part in eds[section]["DefaultValue"].split("+"))
            objects[int(name[1], 16), int(name[2] or "0", 16)] = (size, value)
    return objects


class Hub:
    def __init__(self, test, port=0):
        self.process = subprocess.Popen([CGW, "hub", "--listen", f"127.83.0.2:{port}"], stdout=subprocess.PIPE, text=True)
        test.addCleanup(self.end)
        self.port = int(re.search(r":(\d+),", self.process.stdout.readline()).group(1))
        self.channel = f"hub:127.83.0.2:{self.port}"

    def end(self):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(DEADLINE)
        self.process.stdout.close()

    def join(self):
        client = socket.create_connection(("127.83.0.2", self.port), timeout=DEADLINE)
        for message in ("", "< open can0 >", "< rawmode >"):
            client.sendall(message.encode())
            client.recv(100)
        return client


class Device:
    """Answers SDO requests of node NODE from a table; `reply` may be replaced to lie."""

    def __init__(self, test, hub, objects):
        self.objects = objects
        self.requests = 0
        self.client = hub.join()
        self.thread = threading.Thread(target=self.serve)
        self.thread.start()
        test.addCleanup(self.end)

    def end(self):
        try:
            self.client.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass
        self.thread.join()
        self.client.close()

    def wait_for_requests(self):
        end = time.monotonic() + DEADLINE
        while self.requests < 30 and time.monotonic() < end:
            time.sleep(0.01)

    def send(self, identifier, data):
        try:
            self.client.sendall(f"< send {identifier:X} {len(data)} {' '.join(f'{byte:x}' for byte in data)} >".encode())
        except OSError:
            pass

    def serve(self):
        text = ""
        while True:
            try:
                part = self.client.recv(4096).decode()
            except OSError:
                return
            if not part:
                return
            text += part
            *whole, text = text.split(">")
            for message in whole:
                words = message.replace("<", " ").split()
                if words[0] == "frame" and int(words[1], 16) == 0x600 + NODE:
                    self.requests += 1
                    for answer in self.reply(bytes.fromhex(words[3])):
                        self.send(0x580 + NODE, answer)

    @staticmethod
    def abort(request, code):
        return b"\x80" + request[1:4] + code.to_bytes(4, "little")

    def reply(self, request):
        place = int.from_bytes(request[1:3], "little"), request[3]
        if request[0] == 0x80:
            return []
        if not any(index == place[0] for index, _ in self.objects):
            return [self.abort(request, NO_OBJECT)]
        if place not in self.objects:
            return [self.abort(request, NO_SUB_INDEX)]
        if request[0] != 0x40:
            return [self.abort(request, READ_ONLY)]
        size, value = self.objects[place]
        return [bytes([{1: 0x4F, 2: 0x4B, 4: 0x43}[size]]) + request[1:4] + value.to_bytes(4, "little")]


def verify(hub, *arguments, plant=PLANT):
    return subprocess.run([CGW, "verify", plant, "--live", hub.channel, *arguments], capture_output=True, text=True,
                          timeout=DEADLINE)


class Verify(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.objects = objects_of(PLANT)

    def setUp(self):
        self.hub = Hub(self)

    def device(self, objects=None, **lies):
        device = Device(self, self.hub, self.objects if objects is None else objects)
        for name, lie in lies.items():
            setattr(device, name, lie.__get__(device))
        return device

    def document(self, *arguments):
        result = verify(self.hub, "--format", "json", *arguments)
        document = json.loads(result.stdout)
        jsonschema.validate(document, json.loads((SCHEMAS / "verify-report.schema.json").read_text()))
        return document, result.returncode

    def test_a_device_made_from_the_eds_is_the_same(self):
        device = self.device()
        result = verify(self.hub)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        self.assertIn("The device has the configuration of the file", result.stdout)
        self.assertTrue(all(len(line) <= 80 for line in result.stdout.splitlines()), result.stdout)
        reading = device.requests
        document, code = self.document("--read-only")
        self.assertEqual((document["same"], document["differences"], code), (True, [], 0))
        self.assertFalse(document["wrote"])
        self.assertEqual(device.requests - reading, document["questions"])
        self.assertEqual(reading, document["questions"] + len(self.objects))  # each object is written once

    def test_differences_are_told_and_exit_with_1(self):
        objects = dict(self.objects)
        objects[0x1017, 0] = (2, 777)
        del objects[0x1A03, 2]
        objects[0x1014, 0] = (4, 0x81)
        self.device(objects)
        document, code = self.document("--read-only")
        self.assertEqual(code, 1)
        self.assertEqual([(d["kind"], d["index"], d["sub_index"]) for d in document["differences"]],
                         [("value", 0x1017, 0), ("missing", 0x1A03, 2), ("unexpected", 0x1014, 0)])
        found = document["differences"][0]
        self.assertEqual((found["file"], found["device"]), (self.objects[0x1017, 0][1], 777))
        self.assertEqual([parameter["number"] for parameter in found["parameters"]], [429])
        self.assertEqual(document["differences"][1]["abort_code"], NO_SUB_INDEX)
        self.assertRegex(verify(self.hub, "--read-only").stdout, r"1017h .*\n    file .*\n    device  0x0309  777 ms\n    from    gateway 429 ")

    def test_another_device_is_asked_nothing_else(self):
        objects = dict(self.objects)
        objects[0x1018, 2] = (4, 5)
        device = self.device(objects)
        document, code = self.document()
        self.assertEqual((document["ending"], code), ("other-device", 1))
        self.assertLess(device.requests, 5)

    def test_a_writable_object_is_found_but_only_when_writing_is_allowed(self):
        def reply(device, request):
            return [b"\x60" + request[1:4] + bytes(4)] if request[:4] == b"\x2b\x17\x10\x00" else Device.reply(device, request)
        self.device(reply=reply)
        document, code = self.document()
        self.assertEqual(([d["kind"] for d in document["differences"]], code), (["writable"], 1))
        document, code = self.document("--read-only")
        self.assertEqual((document["same"], code), (True, 0))

    def test_late_doubled_and_wrong_answers_do_not_mix_objects_up(self):
        late = []

        def reply(device, request):
            late.append(request)
            if len(late) == 40:
                time.sleep(1.3)  # longer than an answer may take: it is asked again
            answers = Device.reply(device, request)
            foreign = [answer[:3] + bytes([answer[3] ^ 1]) + answer[4:] for answer in answers[:1]]
            return foreign + answers + answers
        self.device(reply=reply)
        document, code = self.document("--read-only")
        self.assertEqual((document["differences"], code), ([], 0))

    def test_a_silent_bus_is_told_from_a_silent_node(self):
        result = verify(self.hub)
        self.assertEqual(result.returncode, 3)
        self.assertIn("nothing at all was heard on the bus", result.stdout)
        stop = threading.Event()
        device = self.device({})
        device.reply = lambda request: []

        def beat():
            while not stop.wait(0.2):
                device.send(0x700 + NODE, b"\x04")
        thread = threading.Thread(target=beat)
        thread.start()
        try:
            result = verify(self.hub)
            self.assertEqual(result.returncode, 3)
            self.assertIn(f"node {NODE} is Stopped: in this state it answers nothing", result.stdout)
        finally:
            stop.set()
            thread.join()

    def test_nobody_listens_at_the_hub(self):
        self.hub.end()
        result = verify(self.hub)
        self.assertEqual(result.returncode, 3)
        self.assertIn("no connection: hub:127.83.0.2", result.stdout)

    def test_the_hub_goes_away_on_the_way(self):
        device = self.device()
        process = subprocess.Popen([CGW, "verify", PLANT, "--live", self.hub.channel], stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        device.wait_for_requests()
        self.hub.end()
        text = process.communicate(timeout=DEADLINE)[0]
        self.assertEqual(process.returncode, 3)
        self.assertIn("no connection: hub:", text)

    def test_the_hub_comes_back_in_time(self):
        first = self.device()
        process = subprocess.Popen([CGW, "verify", PLANT, "--read-only", "--live", self.hub.channel], stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        first.wait_for_requests()
        self.hub.end()
        self.hub = Hub(self, self.hub.port)
        self.device()
        text = process.communicate(timeout=DEADLINE)[0]
        self.assertEqual(process.returncode, 0, text)

    def test_an_interrupt_ends_it_with_what_was_found(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            device = self.device()
            process = subprocess.Popen([CGW, "verify", PLANT, "--live", self.hub.channel], stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True)
            device.wait_for_requests()
            process.send_signal(number)
            text, errors = process.communicate(timeout=DEADLINE)
            self.assertEqual((process.returncode, errors), (3, ""))
            self.assertRegex(text, r"interrupted after \d+ of \d+ questions")
            self.assertNotIn("has the configuration", text)
            device.end()

    def test_traffic_of_others_does_not_matter(self):
        self.device()
        other = self.hub.join()
        self.addCleanup(other.close)
        stop = threading.Event()

        def talk():
            while not stop.wait(0.001):
                other.sendall(b"< send 281 2 1 2 >< send 705 1 5 >< send 1234567 1 5 >")
        thread = threading.Thread(target=talk)
        thread.start()
        try:
            self.assertEqual(verify(self.hub, "--read-only").returncode, 0)
        finally:
            stop.set()
            thread.join()


class Usage(unittest.TestCase):
    def run_cgw(self, *arguments):
        return subprocess.run([CGW, "verify", *arguments], capture_output=True, text=True, timeout=DEADLINE)

    def test_without_a_bus_it_is_wrong_usage(self):
        result = self.run_cgw(PLANT)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("--live", result.stderr)

    def test_what_is_no_bus_is_wrong_usage_and_what_is_not_there_is_not(self):
        self.assertEqual(self.run_cgw(PLANT, "--live", "can0").returncode, 2)
        result = self.run_cgw(PLANT, "--live", "slcan:/dev/none@250")
        self.assertEqual((result.returncode, result.stdout), (3, ""))

    def test_an_invalid_file_is_not_compared(self):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write("format = 1\n")
            file.flush()
            result = self.run_cgw(file.name, "--live", "hub:127.0.0.1:1")
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertIn("error", result.stderr)
        self.assertEqual(self.run_cgw("/none.toml", "--live", "hub:127.0.0.1:1").returncode, 3)


if __name__ == "__main__":
    unittest.main()
