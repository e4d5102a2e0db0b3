"""canopen-gateway in real time, from outside: real processes on a hub, its output, its files, its end."""
import os
import pathlib
import re
import select
import signal
import socket
import subprocess
import tempfile
import time
import unittest

CGW = os.environ["CGW"]
GATEWAY = os.environ["CANOPEN_GATEWAY"]
GOVERNOR = os.environ["GOVERNOR"]
DEADLINE = 60
SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
NODE = 12  # of samples/genset.toml


class Process:
    """A process whose standard output is waited for line by line."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.out = ""
        self.seen = 0  # of self.out, by wait_for()

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def wait_for(self, pattern):
        """The next match behind the one before."""
        end = time.monotonic() + DEADLINE
        compiled = re.compile(pattern, re.MULTILINE)
        while True:
            match = compiled.search(self.out, self.seen)
            if match:
                self.seen = match.end()
                return match
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                raise AssertionError(f"no '{pattern}' in\n{self.out}")
            data = os.read(self.process.stdout.fileno(), 65536)
            if not data:
                raise AssertionError(f"ended without '{pattern}':\n{self.out}\n{self.process.stderr.read().decode()}")
            self.out += data.decode()

    def end(self, number=signal.SIGTERM):
        """Exit code, everything on standard output, standard error."""
        if number:
            self.process.send_signal(number)
        os.set_blocking(self.process.stdout.fileno(), True)
        out, err = self.process.communicate(timeout=DEADLINE)
        self.out += out.decode()
        return self.process.returncode, self.out, err.decode()


def hub(port=0):
    process = Process(CGW, "hub", "--listen", f"127.0.0.1:{port}")
    process.port = int(process.wait_for(r"listening on 127\.0\.0\.1:(\d+)").group(1))
    return process


def gateway(*arguments):
    return Process(GATEWAY, *arguments)


class Bus:
    """A client of the hub, as python-can is one."""

    def __init__(self, port, bus="can0"):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=DEADLINE)
        self.text = ""
        for message, answer in (("", "< hi >"), (f"< open {bus} >", "< ok >"), ("< rawmode >", "< ok >")):
            self.socket.sendall(message.encode())
            self.take(re.escape(answer))
        self.socket.sendall(b"< echo >")
        self.take("< echo >")

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        self.socket.close()

    def take(self, pattern):
        end = time.monotonic() + DEADLINE
        while True:
            match = re.search(pattern, self.text)
            if match:
                self.text = self.text[match.end():]
                return match
            self.socket.settimeout(max(end - time.monotonic(), 0.001))
            data = self.socket.recv(65536)
            if not data:
                raise AssertionError(f"the hub has gone: {self.text}")
            self.text += data.decode()

    def frame(self, identifier):
        """The data of the next frame with that identifier."""
        return bytes.fromhex(self.take(rf"< frame {identifier:X} [0-9.]+ ([0-9A-F]*) >").group(1))

    def send(self, identifier, *data):
        words = " ".join(f"{byte:x}" for byte in data)
        self.socket.sendall(f"< send {identifier:x} {len(data)} {words} >".replace("  ", " ").encode())

    def upload(self, index, sub):
        self.send(0x600 + NODE, 0x40, index & 0xFF, index >> 8, sub, 0, 0, 0, 0)
        while True:
            data = self.frame(0x580 + NODE)
            if data[1:4] == bytes((index & 0xFF, index >> 8, sub)):
                return data


class RealTime(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def path(self, name):
        return str(self.directory / name)

    def test_a_client_of_the_hub_meets_a_canopen_gateway(self):
        with hub() as bus_hub, Bus(bus_hub.port) as bus, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}/can0") as node:
            self.assertEqual(bus.frame(0x700 + NODE), b"\0")  # boot-up
            node.wait_for(r"^\d\d:\d\d:\d\d\.\d{3}  state Pre-Operational$")
            self.assertEqual(bus.frame(0x700 + NODE), b"\x7F")
            bus.send(0, 1, NODE)
            node.wait_for("state Operational")
            self.assertEqual(len(bus.frame(0x180 + NODE)), 8)  # TPDO1, once on entry
            for _ in range(3):
                self.assertEqual(len(bus.frame(0x480 + NODE)), 8)  # TPDO4, cyclic
            self.assertEqual(bus.upload(0x1000, 0), bytes.fromhex("4300100000000000"))
            bus.send(0x600 + NODE, 0x2B, 0x17, 0x10, 0, 0xF4, 1, 0, 0)
            while (answer := bus.frame(0x580 + NODE))[1:4] != bytes((0x17, 0x10, 0)):
                pass
            self.assertEqual(answer, bytes.fromhex("8017100002000106"))
            bus.send(0, 2, NODE)
            node.wait_for("state Stopped")
            code, out, err = node.end()
            self.assertEqual((code, err), (0, ""))
            self.assertRegex(out, r"ends: SIGTERM\nran \d+\.\d s, gateway Stopped\n"
                                  r"CAN1 frames received \d+, sent \d+, lost 0\n"
                                  r"CAN2 frames received \d+, sent \d+, lost 0\n\Z")
            self.assertRegex(out, r"\Acanopen-gateway \d+\.\d+\.\d+, configuration [0-9a-f]{16}\n[^\n]+\n"
                                  r"node 12, 250 kbit/s, governor main cycle 15\.625 ms\nCAN1 a simulated governor\n"
                                  r"CAN2 hub:127\.0\.0\.1:\d+/can0\n\d{4}-\d\d-\d\d, until SIGINT or SIGTERM; "
                                  r"SIGUSR1 shows the measurements\n")
            self.assertLessEqual(max(len(line) for line in out.splitlines()), 80)

    def test_stops_on_an_interrupt_and_when_its_time_is_over(self):
        with hub() as bus_hub:
            can2 = f"hub:127.0.0.1:{bus_hub.port}/can0"
            with gateway("--can2", can2) as node:
                node.wait_for("CAN2 up")
                code, out, _ = node.end(signal.SIGINT)
                self.assertEqual(code, 0)
                self.assertIn("ends: SIGINT\n", out)
            with gateway("--can2", can2, "--duration", "0.5", "--status") as node:
                code, out, _ = node.end(None)
                self.assertEqual(code, 0)
                self.assertIn(", for 0.5 s\n", out)
                self.assertIn("ends: its time is over\nstate ", out)
                self.assertRegex(out, r"\n  2405 CanOnline +1\n")

    def test_follows_a_hub_that_goes_and_returns(self):
        with hub() as bus_hub, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}/can0") as node:
            node.wait_for("state Pre-Operational")
            bus_hub.end()
            node.wait_for("CAN2 down: ")
            node.wait_for("error 3072 ErrCanBus2")
            with hub(bus_hub.port), Bus(bus_hub.port) as bus:
                node.wait_for("CAN2 up: ")
                self.assertEqual(bus.frame(0x700 + NODE), b"\x7F")
                bus.send(0, 1, NODE)
                node.wait_for("state Operational")
                node.wait_for("cleared 3072 ErrCanBus2")
                self.assertEqual(len(bus.frame(0x480 + NODE)), 8)
                self.assertEqual(node.end()[0], 0)

    def test_waits_for_a_hub_that_is_not_there_yet(self):
        with hub() as bus_hub:
            port = bus_hub.port
            bus_hub.end()
        with gateway("--can2", f"hub:127.0.0.1:{port}") as node:
            node.wait_for("CAN2 down: ")
            with hub(port):
                node.wait_for("CAN2 up: ")
                self.assertEqual(node.end()[0], 0)

    def test_says_what_is_missing_and_exits_3(self):
        for option, value, message in (
                ("--can2", "socketcan:nowhere0", r"nowhere0: (there is no such interface|this kernel has no CAN support)"),
                ("--can1", "slcan:/dev/nowhere@250", "/dev/nowhere: there is no such serial port")):
            with gateway(option, value) as node:
                code, out, err = node.end(None)
                self.assertEqual((code, out), (3, ""))
                self.assertRegex(err, rf"\Acanopen-gateway: {message}\n\Z")

    def test_warns_of_a_bit_rate_that_is_not_the_configurations(self):
        adapter, port = os.openpty()  # a serial adapter that answers nothing
        try:
            for rate, warned in ((125, True), (250, False)):
                with gateway("--can2", f"slcan:{os.ttyname(port)}@{rate}") as node:
                    node.wait_for("CAN2 up: ")
                    code, out, _ = node.end()
                    self.assertEqual(code, 0)
                    text = " ".join(line[14:] for line in out.splitlines())
                    self.assertEqual("warning: CAN2 runs at 125 kbit/s, but the configuration says 250 kbit/s (426)"
                                     in text, warned, out)
        finally:
            os.close(adapter)
            os.close(port)

    def test_shows_the_measurements_on_sigusr1(self):
        with hub() as bus_hub, Bus(bus_hub.port) as bus, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}") as node:
            node.wait_for("state Pre-Operational")
            node.process.send_signal(signal.SIGUSR1)
            page = b""
            while b"meaning not printed" not in page:
                page += os.read(node.process.stderr.fileno(), 65536)
            self.assertRegex(page.decode(), r"\Astate Pre-Operational, \d+\.\d s after the start\nconfiguration [0-9a-f]{16}, node \d+\n")
            for row in (r"  2411 CanDCNodeState15to01 +0x0004", r" 12403 CanOpPreOperational +1", r" 12405 CanOpOnline +1"):
                self.assertRegex(page.decode(), f"\n{row}\n")
            bus.send(0, 1, NODE)  # and goes on
            node.wait_for("state Operational")
            self.assertEqual(node.end()[0], 0)

    def test_clears_errors_on_sigusr2(self):
        with hub() as bus_hub, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}") as node:
            node.wait_for("state Pre-Operational")
            bus_hub.end()
            node.wait_for("error 3072")
            with hub(bus_hub.port):
                node.wait_for("CAN2 up: ")
                node.process.send_signal(signal.SIGUSR2)
                node.wait_for(r"clear errors \(SIGUSR2\)")
                node.wait_for("cleared 3072 ErrCanBus2")
                self.assertEqual(node.end()[0], 0)

    def test_runs_with_a_governor_that_is_another_process(self):
        with hub() as bus_hub, Bus(bus_hub.port, "can2") as bus:
            where = f"hub:127.0.0.1:{bus_hub.port}"
            with gateway("--can1", f"{where}/can1", "--can2", f"{where}/can2") as node:
                node.wait_for("CAN1 up: ")
                node.wait_for("error 3071 ErrCanComm1")  # nobody is there
                with Process(GOVERNOR, f"{where}/can1") as governor:
                    governor.wait_for("ready")
                    node.wait_for("state Pre-Operational")
                    self.assertEqual(bus.frame(0x700 + NODE), b"\0")
                    bus.send(0, 1, NODE)
                    node.wait_for("state Operational")
                    words = bus.frame(0x480 + NODE)
                    while bus.frame(0x480 + NODE) == words:  # the engine runs up
                        pass
                    self.assertEqual(governor.end()[0], 0)
                node.wait_for("error 3071 ErrCanComm1")
                node.wait_for("state Undefined")
                self.assertEqual(node.end()[0], 0)

    def test_runs_with_only_the_governor_on_a_real_bus(self):
        with hub() as bus_hub, Process(GOVERNOR, f"hub:127.0.0.1:{bus_hub.port}/can1"):
            with gateway("--can1", f"hub:127.0.0.1:{bus_hub.port}/can1", "--can2", "virtual") as node:
                node.wait_for("state Pre-Operational")
                self.assertEqual(node.end()[0], 0)

    def test_keeps_the_error_memory_over_a_restart(self):
        state = self.path("state")
        with hub() as bus_hub:
            port = bus_hub.port
            with gateway("--can2", f"hub:127.0.0.1:{port}", "--state", state) as node:
                node.wait_for("CAN2 up: ")
                bus_hub.end()
                node.wait_for("error 3072")
                self.assertEqual(node.end()[0], 0)
        text = pathlib.Path(state).read_text()
        self.assertRegex(text, r"\Acanopen-gateway error memory 1\nconfiguration [0-9a-f]{16}\n3172 1\n3174 1\nend\n\Z")
        with hub(port), gateway("--can2", f"hub:127.0.0.1:{port}", "--state", state, "--duration", "0.2",
                                "--status") as node:
            code, out, _ = node.end(None)
            self.assertEqual(code, 0)
            self.assertRegex(out, r"\n  3172 SErrCanBus2 +1\n")
            self.assertRegex(out, r"\n  3072 ErrCanBus2 +0\n")
        self.assertEqual(pathlib.Path(state).read_text(), text)

    def test_writes_the_error_memory_while_it_runs(self):
        state = pathlib.Path(self.path("state"))
        with hub() as bus_hub, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}", "--state", str(state)) as node:
            node.wait_for("CAN2 up: ")
            bus_hub.end()
            end = time.monotonic() + DEADLINE
            while "3172 1\n" not in (state.read_text() if state.exists() else ""):
                self.assertLess(time.monotonic(), end)
                time.sleep(0.05)
            node.process.kill()

    def test_refuses_a_damaged_error_memory_and_leaves_it_alone(self):
        state = self.path("state")
        for text in ("hello\n", "canopen-gateway error memory 1\nconfiguration 00\n3172 1\n", "x" * 100_000):
            pathlib.Path(state).write_text(text)
            with gateway("--can2", "hub:127.0.0.1:1", "--state", state) as node:
                code, out, err = node.end(None)
                self.assertEqual((code, out), (3, ""))
                self.assertTrue(err.startswith("canopen-gateway: ") and state in err, err)
                self.assertEqual(len(err.splitlines()), 1)
            self.assertEqual(pathlib.Path(state).read_text(), text)

    def test_goes_on_when_the_disk_is_full_and_says_so_at_the_end(self):
        state = self.path("state")
        os.symlink("/dev/full", self.path("full"))
        with hub() as bus_hub, Bus(bus_hub.port) as bus:
            with gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}", "--state", state, "--log", "/dev/full") as node:
                node.wait_for("state Pre-Operational")
                end = time.monotonic() + DEADLINE
                while not os.path.exists(state):
                    self.assertLess(time.monotonic(), end)
                    time.sleep(0.05)
                os.replace(self.path("full"), state)
                bus.send(0, 1, NODE)
                node.wait_for("error 124")  # nobody sends what it waits for: a sentinel changes
                self.assertEqual(bus.upload(0x1000, 0)[:4], bytes.fromhex("43001000"))
                code, out, err = node.end()
                self.assertEqual(code, 3)
                self.assertIn("ends: SIGTERM\n", out)
                lines = sorted(err.splitlines())
                self.assertEqual(lines, sorted(
                    f"canopen-gateway: cannot write {path}: No space left on device; the gateway goes on, and tries again"
                    for path in (state, "/dev/full")))

    def test_logs_both_buses_as_they_run(self):
        for name in ("run.log", "run.pcap"):
            log = self.path(name)
            with hub() as bus_hub, Bus(bus_hub.port) as bus:
                with gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}", "--log", log) as node:
                    self.assertEqual(bus.frame(0x700 + NODE), b"\0")
                    end = time.monotonic() + DEADLINE
                    while os.path.getsize(log) < 2000:  # before the end
                        self.assertLess(time.monotonic(), end)
                        time.sleep(0.05)
                    code, out, _ = node.end()
                    self.assertEqual(code, 0)
                    frames = int(re.search(rf"log {re.escape(log)}: (\d+) frames\n", out).group(1))
            if name.endswith(".log"):
                lines = pathlib.Path(log).read_text().splitlines()
                self.assertEqual(len(lines), frames)
                for line in lines:
                    self.assertRegex(line, r"\A\(\d{10}\.\d{6}\) can[12] ([0-9A-F]{3}|[0-9A-F]{8})#[0-9A-F]*\Z")
                self.assertTrue(any(" can2 70C#00" in line for line in lines))
                self.assertAlmostEqual(float(lines[0][1:18]), time.time(), delta=600)

    def test_does_not_catch_up_after_it_was_stopped(self):
        with hub() as bus_hub, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}") as node:
            node.wait_for("state Pre-Operational")
            node.process.send_signal(signal.SIGSTOP)
            time.sleep(2.5)
            node.process.send_signal(signal.SIGCONT)
            node.wait_for(r"the program did not run for \d+\.\d s")
            self.assertEqual(node.end()[0], 0)

    def test_goes_on_when_nobody_reads_its_lines_any_more(self):
        with hub() as bus_hub, Bus(bus_hub.port) as bus, gateway("--can2", f"hub:127.0.0.1:{bus_hub.port}") as node:
            self.assertEqual(bus.frame(0x700 + NODE), b"\0")
            node.process.stdout.close()
            bus.send(0, 1, NODE)
            bus.frame(0x480 + NODE)
            bus.send(0, 2, NODE)
            bus.send(0, 128, NODE)
            self.assertEqual(bus.upload(0x1000, 0)[:4], bytes.fromhex("43001000"))
            node.process.terminate()
            self.assertEqual(node.process.wait(timeout=DEADLINE), 3)
            self.assertIn(b"cannot write to standard output", node.process.stderr.read())


class Embedded(unittest.TestCase):
    def test_an_image_that_was_put_in_after_the_link_is_the_one_that_runs(self):
        """A shorter one: the rest of the section is filled."""
        with tempfile.TemporaryDirectory() as name:
            image, program = pathlib.Path(name, "small.bin"), pathlib.Path(name, "gateway")
            subprocess.run([CGW, "emit", "image", SAMPLES / "minimal.toml", "-o", image], check=True)
            said = subprocess.run([CGW, "image", "embed", image, "--into", GATEWAY, "--section", ".cgw_config", "-o", program],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout
            wanted = re.search(r"configuration id ([0-9a-f]{16})", said).group(1)
            self.assertRegex(said, r"filling +[1-9]\d* bytes")
            done = subprocess.run([program, "--duration", "1"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  timeout=DEADLINE)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(wanted, done.stdout)


unittest.main()
