"""What tests with python-can on a hub share: a hub, and python-can's own interface to it."""
import os
import re
import signal
import subprocess
import sys
import unittest

try:
    import can
except ImportError:
    print("skipped: python3-can is not installed")
    sys.exit(77)

CGW = os.environ["CGW"]
DEADLINE = 60
# Loopback, but not the address from which connections are made: nobody takes the port of a hub that is away.
HOST = "127.83.0.1"


class HubTest(unittest.TestCase):
    def setUp(self):
        self.hub = self.start([CGW, "hub", "--listen", f"{HOST}:0"])
        self.port = int(re.search(r":(\d+),", self.hub.stdout.readline()).group(1))

    def start(self, command):
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        if process.returncode is None:
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=DEADLINE)
            self.assertEqual(process.returncode, 0)

    def bus(self, channel="can0"):
        bus = can.Bus(interface="socketcand", host=HOST, port=self.port, channel=channel)
        self.addCleanup(bus.shutdown)
        return bus
