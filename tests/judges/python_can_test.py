"""python-can joins the hub with its own socketcand interface: what it sends arrives, what others send it reads."""
import os
import queue
import socket
import threading
import time
import unittest

from hub_test_case import CGW, DEADLINE, HOST, HubTest, can

PEER = os.environ["CGW_HUB_PEER"]


class PythonCan(HubTest):
    def peer(self):
        """A client of ours, which answers even identifiers with the next one and the data reversed."""
        process = self.start([PEER, f"hub:{HOST}:{self.port}"])
        self.assertEqual(process.stdout.readline(), f"up hub:{HOST}:{self.port}: on bus can0\n")
        return process

    def receive(self, bus, count=1):
        end = time.monotonic() + DEADLINE
        frames = []
        while len(frames) < count and time.monotonic() < end:
            message = bus.recv(timeout=1)
            if message is not None:
                frames.append((message.arbitration_id, bytes(message.data)))
        self.assertEqual(len(frames), count, frames[-3:])
        return frames

    def test_two_of_python_can_and_one_of_ours_exchange_frames(self):
        self.peer()
        one, two = self.bus(), self.bus()
        for identifier, extended, data in ((0x122, False, b"\x01\x02\x03\x04\x05\x06\x07\x08"), (0x7FE, False, b"\xf0"),
                                           (0x000, False, b""), (0x1ABCDEF0, True, b"\x0a\x0b"), (0x8000, True, b"")):
            one.send(can.Message(arbitration_id=identifier, is_extended_id=extended, data=data))
            answer = (identifier + 1, data[::-1])
            self.assertEqual(self.receive(two, 2), [(identifier, data), answer])
            self.assertEqual(self.receive(one), [answer])  # not its own

    def test_time_stamps_are_the_clock_of_this_machine(self):
        one, two = self.bus(), self.bus()
        before = time.time()
        one.send(can.Message(arbitration_id=1, is_extended_id=False))
        stamp = None
        end = time.monotonic() + DEADLINE
        while stamp is None and time.monotonic() < end:
            message = two.recv(timeout=1)
            stamp = message and message.timestamp
        self.assertLess(before - 1, stamp)
        self.assertLess(stamp, time.time() + 1)

    def test_many_frames_arrive_complete_and_in_order(self):
        one, two = self.bus(), self.bus()
        for batch in range(20):
            sent = [(number % 0x800, bytes([number % 251] * (number % 9)))
                    for number in range(batch * 300, batch * 300 + 300)]
            for identifier, data in sent:
                one.send(can.Message(arbitration_id=identifier, is_extended_id=False, data=data))
            self.assertEqual(self.receive(two, len(sent)), sent)

    def test_joins_a_busy_bus(self):
        """python-can expects every answer of the handshake alone."""
        stop = threading.Event()
        sender = socket.create_connection((HOST, self.port), timeout=DEADLINE)
        self.addCleanup(sender.close)
        sender.sendall(b"< open can0 >")

        def flood():
            while not stop.is_set():
                sender.sendall(b"< send 123 3 1 2 3 >" * 20)

        thread = threading.Thread(target=flood)
        thread.start()
        try:
            for _ in range(15):
                bus = can.Bus(interface="socketcand", host=HOST, port=self.port, channel="can0")
                self.assertEqual(self.receive(bus), [(0x123, b"\x01\x02\x03")])
                bus.shutdown()
        finally:
            stop.set()
            thread.join()

    def test_remote_frames_pass_between_those_who_know_them(self):
        """python-can's interface neither sends nor reads remote frames; they must not disturb it."""
        self.peer()
        bus = self.bus()
        with socket.create_connection((HOST, self.port), timeout=DEADLINE) as raw:
            for message in (b"", b"< open can0 >", b"< rawmode >"):
                raw.sendall(message)
                raw.recv(100)
            raw.sendall(b"< sendrtr 704 4 >")
            self.assertRegex(raw.recv(100), rb"\A\n< rtr 705 \d+\.\d{6} 4 >\Z")
            raw.sendall(b"< send 123 1 2a >")
        self.assertEqual(self.receive(bus), [(0x123, b"\x2a")])

    def test_buses_are_apart(self):
        one, two, elsewhere = self.bus("can1"), self.bus("can1"), self.bus("can2")
        one.send(can.Message(arbitration_id=1, is_extended_id=False))
        self.assertEqual(self.receive(two), [(1, b"")])
        one_more = self.bus("can2")
        one_more.send(can.Message(arbitration_id=2, is_extended_id=False))
        self.assertEqual(self.receive(elsewhere), [(2, b"")])

    def test_our_client_comes_back_with_the_hub(self):
        peer = self.peer()
        lines = queue.Queue()
        threading.Thread(target=lambda: [lines.put(line) for line in peer.stdout], daemon=True).start()
        self.end(self.hub)
        self.assertRegex(lines.get(timeout=DEADLINE), r"\Adown hub:")
        self.hub = self.start([CGW, "hub", "--listen", f"{HOST}:{self.port}"])
        self.assertIn(str(self.port), self.hub.stdout.readline())
        line = lines.get(timeout=DEADLINE)
        while line.startswith("down"):
            line = lines.get(timeout=DEADLINE)
        self.assertRegex(line, r"\Aup hub:")
        bus = self.bus()
        bus.send(can.Message(arbitration_id=2, is_extended_id=False, data=[1, 2]))
        self.assertEqual(self.receive(bus), [(3, b"\x02\x01")])


if __name__ == "__main__":
    unittest.main()
