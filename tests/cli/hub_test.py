"""cgw hub from outside: what it prints, how it ends, and what it says when it cannot listen."""
import os
import re
import resource
import signal
import socket
import subprocess
import time
import unittest

CGW = os.environ["CGW"]
DEADLINE = 60


class Hub:
    """A running hub; `line` is what it printed, `port` where it listens."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([CGW, "hub", "--listen", "127.0.0.1:0", *arguments], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.line = self.process.stdout.readline()
        self.port = int(re.search(r":(\d+),", self.line).group(1))

    def __enter__(self):
        return self

    def __exit__(self, *failure):
        self.stop()

    def stop(self, number=signal.SIGTERM):
        """Exit code, and the rest of both streams."""
        if self.process.returncode is None:
            self.process.send_signal(number)
            self.rest = self.process.communicate(timeout=DEADLINE)
        return self.process.returncode, *self.rest


def cgw(*arguments):
    return subprocess.run([CGW, "hub", *arguments], capture_output=True, text=True, timeout=DEADLINE)


def joined(port, bus="can0"):
    client = socket.create_connection(("127.0.0.1", port), timeout=DEADLINE)
    for message in ("", f"< open {bus} >", "< rawmode >"):
        client.sendall(message.encode())
        client.recv(100)
    return client


class Verb(unittest.TestCase):
    def test_says_where_it_listens_and_stops_on_both_signals(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with Hub() as hub:
                self.assertEqual(hub.line, f"listening on 127.0.0.1:{hub.port}, any bus\n")
                self.assertEqual(hub.stop(number), (0, "", ""))

    def test_says_which_buses_there_are(self):
        with Hub("--bus", "can1", "--bus", "can2") as hub:
            self.assertEqual(hub.line, f"listening on 127.0.0.1:{hub.port}, buses can1, can2\n")
        with Hub("--bus", "can1") as hub:
            self.assertEqual(hub.line, f"listening on 127.0.0.1:{hub.port}, bus can1\n")

    def test_stops_with_clients_connected(self):
        with Hub() as hub:
            with joined(hub.port), joined(hub.port):
                self.assertEqual(hub.stop(), (0, "", ""))

    def test_verbose_says_who_comes_and_goes(self):
        with Hub("--verbose") as hub:
            client = joined(hub.port, "can5")
            host, port = client.getsockname()
            client.close()
            with joined(hub.port):  # the hub has seen the first one go when it answers the second
                pass
            code, out, errors = hub.stop()
            self.assertEqual((code, out), (0, ""))
            self.assertEqual(errors.splitlines()[:2], [f"cgw: {host}:{port} joins bus can5",
                                                       f"cgw: {host}:{port} is gone: has closed the connection"])

    def test_says_at_its_end_what_slow_clients_lost(self):
        with Hub() as hub, joined(hub.port) as sender, joined(hub.port):
            batch = b"< send 123 8 1 2 3 4 5 6 7 8 >" * 1000
            for _ in range(20):
                sender.sendall(batch)
            sender.sendall(b"< echo >")
            self.assertEqual(sender.recv(100), b"< echo >")
            code, _, errors = hub.stop()
            self.assertEqual(code, 0)
            self.assertRegex(errors, r"\Acgw: \d+ frames were lost for clients that read too slowly\n\Z")

    def test_hostile_clients_do_not_disturb_the_others(self):
        with Hub() as hub, joined(hub.port) as sender, joined(hub.port) as receiver:
            for stream in (b"<" + b"x" * 3_000_000, b"x" * 3_000_000, b"\0<>" * 1_000_000, b"< echo >" * 200_000):
                with socket.create_connection(("127.0.0.1", hub.port)) as hostile:
                    hostile.settimeout(1)  # the hub does not listen to those who do not read
                    try:
                        hostile.sendall(stream)
                    except OSError:
                        pass
                    sender.sendall(b"< send 123 1 2a >")
                    self.assertRegex(receiver.recv(100), rb"\A\n< frame 123 \d+\.\d{6} 2A >\Z")
            self.assertEqual(hub.stop(), (0, "", ""))

    def test_goes_on_when_the_system_has_no_room_for_more_connections(self):
        with Hub() as hub:
            used = len(os.listdir(f"/proc/{hub.process.pid}/fd"))
            resource.prlimit(hub.process.pid, resource.RLIMIT_NOFILE, (used + 2, used + 2))
            first, second = joined(hub.port), joined(hub.port)
            third = socket.create_connection(("127.0.0.1", hub.port), timeout=DEADLINE)
            second.sendall(b"< echo >")
            self.assertEqual(second.recv(100), b"< echo >")
            first.close()
            self.assertEqual(third.recv(100), b"< hi >")
            second.close()
            third.close()
            self.assertEqual(hub.stop(), (0, "", ""))

    def test_a_port_in_use_is_an_environment_error(self):
        with Hub() as hub:
            result = cgw("--listen", f"127.0.0.1:{hub.port}")
            self.assertEqual((result.returncode, result.stdout, result.stderr),
                             (3, "", f"cgw: cannot listen on 127.0.0.1:{hub.port}: Address already in use\n"))

    def test_its_port_is_free_again_at_once(self):
        with Hub() as hub:
            with joined(hub.port):
                hub.stop()
            again = subprocess.Popen([CGW, "hub", "--listen", f"127.0.0.1:{hub.port}"], stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, text=True)
            self.assertIn(str(hub.port), again.stdout.readline())
            again.terminate()
            self.assertEqual(again.communicate(timeout=DEADLINE), ("", ""))

    def test_a_host_that_is_none_is_an_environment_error(self):
        result = cgw("--listen", "no host:1")
        self.assertEqual((result.returncode, result.stdout), (3, ""))
        self.assertRegex(result.stderr, r"\Acgw: host 'no host': [^\n]+\n\Z")

    def test_wrong_usage(self):
        for arguments, text in ((["--listen", "29536"], "cgw: --listen: '29536' is not HOST:PORT\n"),
                                (["--listen", "h:65536"],
                                 "cgw: --listen: 'h:65536' is not HOST:PORT with a port 0..65535\n"),
                                (["--bus", "a/b"],
                                 "cgw: --bus a/b: a name has 1..16 letters, digits, '.', '_' or '-'\n")):
            result = cgw(*arguments)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (2, "", text))

    def test_a_full_disk_is_said_before_anybody_joins(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([CGW, "hub", "--listen", "127.0.0.1:0"], stdout=full, stderr=subprocess.PIPE,
                                    text=True, timeout=DEADLINE)
        self.assertEqual(result.returncode, 3)
        self.assertIn("cannot write standard output", result.stderr)

    def test_an_idle_hub_takes_no_time(self):
        with Hub() as hub, joined(hub.port):
            with open(f"/proc/{hub.process.pid}/stat") as stat:
                fields = stat.read().rsplit(")", 1)[1].split()
            ticks = os.sysconf("SC_CLK_TCK")
            before = int(fields[11]) + int(fields[12])
            time.sleep(1)
            with open(f"/proc/{hub.process.pid}/stat") as stat:
                fields = stat.read().rsplit(")", 1)[1].split()
            self.assertLess(int(fields[11]) + int(fields[12]) - before, ticks / 10)


if __name__ == "__main__":
    unittest.main()
