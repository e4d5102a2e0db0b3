"""cgw simulate from outside: exit code, both streams, the log, and the live block on a terminal."""
import fcntl
import json
import os
import pathlib
import pty
import re
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import termios
import time
import unittest

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
SCENARIOS = SAMPLES / "scenarios"
GENSET = SAMPLES / "genset.toml"
DEADLINE = 120
ESCAPE = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def environment(**extra):
    clean = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "TERM", "SOURCE_DATE_EPOCH")}
    return {**clean, **extra}


def simulate(*arguments, directory=None, stdin=None, stdout=subprocess.PIPE):
    result = subprocess.run([CGW, "simulate", *map(str, arguments)], stdout=stdout, stderr=subprocess.PIPE,
                            cwd=directory, input=stdin, env=environment(), timeout=DEADLINE)
    return result.returncode, (result.stdout or b"").decode(), result.stderr.decode()


class Verb(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-simulate-"))
        self.addCleanup(shutil.rmtree, self.dir)

    def scenario(self, steps, head=f"plant = \"{GENSET}\"\nduration = 2"):
        path = self.dir / "scenario.toml"
        path.write_text(f"format = 1\n{head}\nstep = [\n{steps}\n]\n")
        return path


class Runs(Verb):
    def test_a_parameter_file_alone_runs_for_ten_seconds(self):
        code, out, errors = simulate(GENSET)
        self.assertEqual((code, errors), (0, ""))
        self.assertTrue(out.startswith("Genset 2, starboard, configuration "))
        self.assertIn("   0.146 s  boot-up  node 12\n", out)
        self.assertIn("   0.246 s  state    Operational\n", out)
        self.assertRegex(out, r"\n10\.000 s, gateway Operational\nCAN1 \d+ frames, load [\d.]+ %; "
                              r"CAN2 \d+ frames, load [\d.]+ %\n\Z")

    def test_every_sample_is_met_and_fits_into_80_columns(self):
        for path in sorted(SCENARIOS.glob("*.toml")):
            code, out, errors = simulate("--scenario", path)
            self.assertEqual((code, errors), (0, ""), path)
            self.assertRegex(out, r"\nas expected: (\d+) of \1 expectations met\n\Z")
            self.assertLessEqual(max(map(len, out.splitlines())), 80)
            self.assertNotIn("\x1b", out)

    def test_standard_input_is_a_parameter_file_or_a_scenario(self):
        self.assertEqual(simulate("-", "--duration", "1", stdin=GENSET.read_bytes())[0], 0)
        text = self.scenario("{ at = 1, expect-state = \"operational\" },").read_bytes()
        code, out, _ = simulate("--scenario", "-", stdin=text)
        self.assertEqual(code, 0)
        self.assertIn("as expected: 1 of 1 expectations met", out)
        self.assertEqual(simulate("-", "--scenario", "-", stdin=text)[0], 2)

    def test_an_expectation_that_is_not_met_is_exit_1(self):
        path = self.scenario("{ at = 1, expect-state = \"stopped\" },\n{ at = 1, expect-boot-ups = 1 },")
        code, out, errors = simulate("--scenario", path)
        self.assertEqual((code, errors), (1, ""))
        self.assertIn("   1.000 s  FAILED   expected: the gateway is Stopped; it is Operational\n", out)
        self.assertTrue(out.endswith("not as expected: 1 of 2 steps failed\n"))

    def test_the_file_given_goes_before_the_one_that_the_scenario_names(self):
        path = self.scenario("{ at = 1, expect-state = \"operational\" },", "plant = \"none.toml\"\nduration = 2")
        self.assertEqual(simulate(GENSET, "--scenario", path)[0], 0)
        code, out, errors = simulate("--scenario", path)
        self.assertEqual((code, out), (3, ""))
        self.assertIn("none.toml", errors)

    def test_duration_lengthens_and_never_cuts_steps_off(self):
        path = self.scenario("{ at = 1, expect-state = \"operational\" },")
        self.assertIn("\n5.000 s, gateway", simulate("--scenario", path, "--duration", "5")[1])
        code, out, errors = simulate("--scenario", path, "--duration", "0.5")
        self.assertEqual((code, out), (2, ""))
        self.assertEqual(errors, "cgw: --duration: the last step of the scenario is at 1 s\n")

    def test_a_governor_of_another_file(self):
        code, out, _ = simulate("--scenario", SCENARIOS / "wrong-governor.toml")
        self.assertEqual(code, 0)
        self.assertIn("link     refused: 14401: 0 at the governor, 1 at the gateway\n", out)

    def test_json_is_one_object_per_line(self):
        code, out, errors = simulate("--scenario", SCENARIOS / "cable-break.toml", "--format", "json")
        self.assertEqual((code, errors), (0, ""))
        events = [json.loads(line) for line in out.splitlines()]
        self.assertEqual(list(events[0]), ["format_version", "event", "title", "configuration_id", "node_id", "scenario"])
        self.assertEqual(list(events[1]), ["time_us", "event", "text", "bad"])
        self.assertEqual(events[-1]["event"], "end")
        self.assertEqual((events[-1]["complete"], events[-1]["expectations"], events[-1]["failed"]), (True, 11, 0))
        self.assertIn({"time_us": 4000000, "event": "step", "text": "CAN2 is cut", "bad": False}, events)

    def test_colour_marks_what_is_bad_and_what_is_met(self):
        path = self.scenario("{ at = 1, expect-state = \"stopped\" },\n{ at = 1, expect-boot-ups = 1 },")
        out = simulate("--scenario", path, "--color", "always")[1]
        self.assertIn("\x1b[31m   1.000 s  FAILED   expected: the gateway is Stopped; it is Operational\x1b[0m\n", out)
        self.assertIn("\x1b[32m   1.000 s  ok       1 boot-up so far\x1b[0m\n", out)

    def test_speed_follows_the_clock(self):
        begin = time.monotonic()
        code, out, _ = simulate(GENSET, "--speed", "4", "--duration", "2")
        passed = time.monotonic() - begin
        self.assertEqual(code, 0)
        self.assertGreaterEqual(passed, 0.5)
        self.assertEqual(out, simulate(GENSET, "--speed", "max", "--duration", "2")[1])


class Logs(Verb):
    def test_are_the_same_at_every_speed_and_hold_both_buses(self):
        scenario = self.scenario("{ at = 0.5, reset = \"gateway\" },\n{ at = 1.1, saturate = \"CAN2\", id = 1, for = 0.1 },")
        logs = []
        for speed in ("max", "3", "20"):
            log = self.dir / f"{speed}.log"
            code, out, errors = simulate("--scenario", scenario, "--speed", speed, "--log", log)
            self.assertEqual((code, errors), (0, ""))
            self.assertIn(f" frames in {log}\n", out)
            logs.append(log.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertEqual(logs[0], logs[2])
        lines = logs[0].decode().splitlines()
        self.assertRegex(lines[0], r"\A\(0+\.\d{6}\) can2 20C#")
        self.assertEqual({line.split()[1] for line in lines}, {"can1", "can2"})
        times = [float(line.split()[0].strip("()")) for line in lines]
        self.assertEqual(times, sorted(times))
        self.assertLessEqual(times[-1], 2)

    def test_are_pcap_by_name(self):
        log = self.dir / "run.pcap"
        self.assertEqual(simulate(GENSET, "--duration", "1", "--log", log)[0], 0)
        magic, _, _, _, _, _, link_type = struct.unpack("<IHHiIII", log.read_bytes()[:24])
        self.assertEqual(link_type, 227)
        self.assertIn(magic, (0xA1B2C3D4, 0xA1B23C4D))

    def test_that_cannot_be_written_are_exit_3(self):
        code, out, errors = simulate(GENSET, "--duration", "1", "--log", self.dir / "none" / "run.log")
        self.assertEqual(code, 3)
        self.assertIn("cgw: ", errors)
        self.assertEqual(out, "")  # said before the run

    def test_never_take_the_place_of_an_input(self):
        path = self.dir / "plant.log"
        shutil.copy(GENSET, path)
        code, out, errors = simulate(path, "--log", path)
        self.assertEqual((code, out), (2, ""))
        self.assertTrue(errors.startswith("cgw: "), errors)
        self.assertEqual(path.read_bytes(), GENSET.read_bytes())


class OnABus(Verb):
    """With --can2 the gateway is on a bus where others are."""

    def setUp(self):
        super().setUp()
        self.hub = subprocess.Popen([CGW, "hub", "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.hub.stdout.close)
        self.addCleanup(self.hub.wait)
        self.addCleanup(self.hub.terminate)
        self.port = int(re.search(r":(\d+),", self.hub.stdout.readline()).group(1))

    def test_a_program_on_the_bus_starts_it_and_reads_from_it(self):
        client = socket.create_connection(("127.0.0.1", self.port), timeout=DEADLINE)
        self.addCleanup(client.close)
        for message in ("", "< open can0 >", "< rawmode >"):
            client.sendall(message.encode())
            client.recv(100)
        gateway = subprocess.Popen([CGW, "simulate", str(GENSET), "--can2", f"hub:127.0.0.1:{self.port}"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment())
        self.addCleanup(gateway.stderr.close)
        self.addCleanup(gateway.stdout.close)
        self.addCleanup(gateway.wait)
        self.addCleanup(gateway.kill)
        seen = ""

        def wait_for(text):
            nonlocal seen
            end = time.monotonic() + DEADLINE
            while text not in seen:
                self.assertLess(time.monotonic(), end, f"{text} did not come: {seen[-500:]}")
                part = client.recv(4096).decode()
                self.assertTrue(part, f"{text} did not come: {seen}")
                seen += part
            seen = seen[seen.index(text):]

        wait_for("< frame 70C ")  # boot-up of node 12
        client.sendall(b"< send 60C 8 40 0 10 0 0 0 0 0 >")
        wait_for("4300100000000000")
        client.sendall(b"< send 0 2 1 C >")
        wait_for("< frame 18C ")  # TPDO1
        gateway.send_signal(signal.SIGUSR1)
        wait_for("< frame 70C ")  # it goes on
        gateway.send_signal(signal.SIGINT)
        out, errors = gateway.communicate(timeout=DEADLINE)
        self.assertEqual(gateway.returncode, 0)
        self.assertRegex(errors, r"(?m)^ *12403 .*$")  # the measurements, a line each
        self.assertTrue(out.startswith("Genset 2, starboard, configuration "), out)
        self.assertIn("state Operational\n", out)

    def test_ends_by_itself_and_writes_its_log(self):
        log = self.dir / "run.log"
        code, out, errors = simulate(GENSET, "--can2", f"hub:127.0.0.1:{self.port}", "--duration", "1", "--log", log)
        self.assertEqual((code, errors), (0, ""))
        self.assertIn(" can1 ", log.read_text())

    def test_there_is_no_scenario_speed_or_json(self):
        for option in (("--scenario", SCENARIOS / "normal-start.toml"), ("--speed", "2"), ("--format", "json")):
            code, out, errors = simulate(GENSET, "--can2", "hub:127.0.0.1:1", *option)
            self.assertEqual((code, out), (2, ""))
            self.assertEqual(errors, f"cgw: --can2 is for a PLC of your own, in real time: not with {option[0]}\n")

    def test_a_bus_that_does_not_exist_is_exit_3(self):
        code, out, errors = simulate(GENSET, "--can2", "socketcan:nowhere0")
        self.assertEqual(code, 3)
        self.assertIn("nowhere0", errors)


class Mistakes(Verb):
    def test_wrong_usage_is_exit_2(self):
        for arguments, message in (
                ([], "FILE is missing: name a parameter file, or a scenario that names one"),
                ([GENSET, "--speed", "0"], "--speed 0: a number above 0 and up to 1000 is needed"),
                ([GENSET, "--speed", "fast"], "--speed fast: a number above 0 and up to 1000 is needed"),
                ([GENSET, "--duration", "-1"], "--duration -1: a number above 0 and up to 2592000 is needed"),
                ([GENSET, "--log", "run.txt"], "--log run.txt: the name must end in .log (candump) or .pcap"),
                ([GENSET, "--log", "-"], "--log -: this needs a path; standard output is not possible here")):
            self.assertEqual(simulate(*arguments), (2, "", f"cgw: {message}\n"), arguments)
        path = self.scenario("", "duration = 1")
        self.assertEqual(simulate("--scenario", path), (2, "", "cgw: FILE is missing: the scenario names no plant\n"))

    def test_an_invalid_parameter_file_is_exit_1(self):
        path = self.dir / "plant.toml"
        path.write_text("format = 1\n")
        code, out, errors = simulate(path)
        self.assertEqual((code, out), (1, ""))
        self.assertIn("E0109", errors)

    def test_an_invalid_scenario_is_exit_1_with_its_place(self):
        path = self.scenario("{ at = 1, silense = \"RPDO1\" },")
        code, out, errors = simulate("--scenario", path)
        self.assertEqual((code, out), (1, ""))
        self.assertRegex(re.sub(r"\s+", " ", errors), r"scenario\.toml:5:11: error: unknown key `silense` in a step "
                                                      r"\[E0101 key-unknown\]")
        self.assertIn("help: did you mean `silence`?", errors)

    def test_what_the_plant_does_not_have_is_a_finding(self):
        path = self.scenario("{ at = 1, fail = 905 },")
        code, out, errors = simulate("--scenario", path)
        self.assertEqual((code, out), (1, ""))
        self.assertIn("E0603 step-subject", errors)

    def test_files_that_are_not_there_are_exit_3(self):
        self.assertEqual(simulate(self.dir / "none.toml")[0], 3)
        code, out, errors = simulate("--scenario", self.dir / "none.toml")
        self.assertEqual((code, out), (3, ""))
        self.assertIn("E0001", errors)

    def test_a_full_disk_ends_the_run(self):
        with open("/dev/full", "w") as full:
            code, _, errors = simulate(GENSET, stdout=full)
        self.assertEqual(code, 3)
        self.assertIn("cannot write standard output", errors)


class Interrupted(Verb):
    def test_by_both_signals_it_ends_with_the_summary(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([CGW, "simulate", GENSET, "--speed", "1", "--duration", "1000", "--log",
                                        self.dir / "run.log"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            while "state    Operational" not in process.stdout.readline():
                pass
            process.send_signal(number)
            out, errors = process.communicate(timeout=DEADLINE)
            self.assertEqual((process.returncode, errors), (0, ""))
            self.assertRegex(out, r"(?s)interrupted\n0\.\d{3} s, gateway Operational\n.*\d+ frames in ")
            self.assertGreater((self.dir / "run.log").stat().st_size, 1000)


    def test_a_scenario_that_did_not_come_to_its_end_is_exit_1(self):
        process = subprocess.Popen([CGW, "simulate", "--scenario", SCENARIOS / "silent-plc.toml", "--speed", "1"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while "state    Operational" not in process.stdout.readline():
            pass
        process.send_signal(signal.SIGINT)
        out, errors = process.communicate(timeout=DEADLINE)
        self.assertEqual((process.returncode, errors), (1, ""))
        self.assertRegex(out, r"interrupted after \d+ of \d+ steps\n")


class Terminal(Verb):
    def on_a_terminal(self, *arguments, columns=80, rows=24, until=None, **extra):
        """Exit code and what arrives at the other end of a pseudo-terminal; interrupted once `until` was seen."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        process = subprocess.Popen([CGW, "simulate", *map(str, arguments)], stdout=theirs, stderr=subprocess.PIPE,
                                   env=environment(**{"TERM": "xterm", **extra}))
        os.close(theirs)
        text = b""
        while True:
            try:
                part = os.read(ours, 65536)
            except OSError:  # the other end is closed and everything is read
                break
            if not part:
                break
            text += part
            if until and until in text:
                process.send_signal(signal.SIGINT)
                until = None
        os.close(ours)
        process.communicate(timeout=DEADLINE)
        return process.returncode, text.decode().replace("\r\n", "\n")

    def test_states_and_values_stand_below_the_events(self):
        code, text = self.on_a_terminal(GENSET, "--speed", "10", "--duration", "6")
        self.assertEqual(code, 0)
        self.assertRegex(text, r"\x1b\[\d+A\r\x1b\[J")
        last = ESCAPE.sub("", text[text.rindex("\x1b[J"):])
        self.assertIn("-- 6.0 s, speed 10 -- gateway Operational -- engine runs ---", last)
        self.assertIn("engine  1500 1/min, load 60.0 %, oil pressure 4.4", last)
        self.assertRegex(last, r"buses   CAN1 load 1\d\.\d %, CAN2 load \d\.\d %\n")
        self.assertIn("alarms  none\nerrors  none\n", last)
        self.assertRegex(last, r"2000 Speed +1500 1/min +2031 SpeedSetp +1500 1/min\n")
        self.assertIn("6.000 s, gateway Operational", last)
        self.assertLessEqual(max(len(line) for line in ESCAPE.sub("", text).splitlines()), 80)

    def test_errors_stand_in_the_block_by_name(self):
        path = self.scenario("{ at = 1, silence = \"RPDO1\" },", f"plant = \"{GENSET}\"\nduration = 3")
        _, text = self.on_a_terminal("--scenario", path, "--speed", "10")
        self.assertIn("errors  12413 CanOpTimeCtrlErr, 3005 ErrSetpointExtern", ESCAPE.sub("", text))

    def test_alarms_of_the_engine_stand_in_the_block(self):
        path = self.scenario("{ at = 3, fault = \"actuator-stuck\" },\n{ at = 3, fault = \"load-rejection\" },",
                             f"plant = \"{GENSET}\"\nduration = 6")
        _, text = self.on_a_terminal("--scenario", path, "--speed", "10")
        self.assertIn("-- engine runs down ---", ESCAPE.sub("", text))
        self.assertIn("alarms  emergency stop, overspeed\nerrors  none\n", ESCAPE.sub("", text))

    def test_a_small_terminal_is_not_overrun(self):
        code, text = self.on_a_terminal(GENSET, "--speed", "10", "--duration", "3", columns=40, rows=8)
        self.assertEqual(code, 0)
        ups = [int(n) for n in re.findall(r"\x1b\[(\d+)A", text)]
        self.assertLessEqual(max(ups), 6)
        block = text[text.rindex("\x1b[J") + 3:].splitlines()[:max(ups)]
        self.assertLessEqual(max(len(ESCAPE.sub("", line)) for line in block), 40)

    def test_it_runs_in_real_time_without_end_until_interrupted(self):
        begin = time.monotonic()
        code, text = self.on_a_terminal(GENSET, until=b"-- 1.")
        self.assertGreaterEqual(time.monotonic() - begin, 0.9)
        self.assertEqual(code, 0)
        self.assertIn("\ninterrupted\n1.", text)

    def test_a_dumb_terminal_gets_lines(self):
        code, text = self.on_a_terminal(GENSET, "--speed", "max", "--duration", "1", TERM="dumb")
        self.assertEqual(code, 0)
        self.assertNotIn("\x1b", text)
        self.assertIn("0.246 s  state    Operational\n", text)

    def test_no_color_leaves_the_block_and_takes_the_colour(self):
        _, text = self.on_a_terminal(GENSET, "--speed", "10", "--duration", "1", NO_COLOR="1")
        self.assertNotRegex(text, r"\x1b\[\d*m")
        self.assertRegex(text, r"\x1b\[\d+A")


if __name__ == "__main__":
    unittest.main()
