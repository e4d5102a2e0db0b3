#!/usr/bin/env python3
"""What the partner of gateway node 1 on the CANopen bus reads and sends.

Written by cgw 0.1.0; do not edit.
title:            none
configuration id: 99f7512666157afd

decode() and encode() need no library. With the library canopen (and python-can) there are subscribe(),
send_periodic(), send_heartbeat() and start(). On its own the file decodes frames and listens to a bus:
    python3 FILE decode 181#0000000000000000
    python3 FILE listen can0 socketcan
"""
import collections
import sys

CONFIGURATION_ID = "99f7512666157afd"
NODE_ID = 1
PARTNER_NODE_ID = 0  # 0: none
BIT_RATE = 125000  # bit/s; None: set by hand and not known here
HEARTBEAT_US = 800000  # time between two of the gateway; 0: it sends none
PARTNER_HEARTBEAT_US = 0  # longest time between two of the partner's; 0: any

# `read`: the gateway sends it. `time_us`: then the time between two frames, 0 on change; else the longest time
# between two of the partner's, 0 any. `rest`: every switch function off, all else 0.
Pdo = collections.namedtuple("Pdo", "name cob_id length read time_us rest signals")
# Physical value = raw * factor + offset, None where the scaling is not known. `on`: what a bit is when the switch
# is on. Bit 0 is the lowest of byte 0; numbers stand low byte first.
Signal = collections.namedtuple(
    "Signal", "name first_bit bits signed factor offset minimum maximum unit on scaled meaning")

PDOS = (
)


def find_pdo(name):
    for pdo in PDOS:
        if pdo.name == name:
            return pdo
    raise KeyError("no PDO of this gateway: {!r}".format(name))


def raw_value(signal, data):
    """The number on the bus, with its sign. `data` holds the whole frame."""
    raw = int.from_bytes(bytes(data), "little") >> signal.first_bit & ((1 << signal.bits) - 1)
    return raw - (1 << signal.bits) if signal.signed and raw >> (signal.bits - 1) else raw


def value_of(signal, raw):
    """Physical value; the number itself where no scaling is known; True for a bit that is 1 or a switch that is on."""
    if signal.bits == 1:
        return raw == (1 if signal.on is None else signal.on)
    return raw if signal.factor is None else raw * signal.factor + signal.offset


def raw_of(signal, value):
    """The nearest number; ValueError beyond the signal's range."""
    if signal.bits == 1:
        on = 1 if signal.on is None else signal.on
        return on if value else 1 - on
    if signal.factor is None:
        raw = int(value)
        lowest = -(1 << 15) if signal.signed else 0
        if raw != value or not lowest <= raw < lowest + (1 << 16):
            raise ValueError("{} is no number of 16 bits for {}".format(value, signal.name))
        return raw
    slack = abs(signal.factor) / 2
    if not signal.minimum - slack <= value <= signal.maximum + slack:
        raise ValueError("{} of {} is not in {}..{}".format(value, signal.name, signal.minimum, signal.maximum))
    steps = (min(max(value, signal.minimum), signal.maximum) - signal.offset) / signal.factor
    raw = int(steps)
    raw += (steps - raw >= 0.5) - (steps - raw <= -0.5)
    lowest = -(1 << 15) if signal.signed else 0
    if not lowest <= raw < lowest + (1 << 16):
        raise ValueError("{} of {} has no number of 16 bits".format(value, signal.name))
    return raw


def decode(cob_id, data):
    """(name of the PDO, {signal: value}); None for a frame that is none of the PDOs, or shorter than it."""
    for pdo in PDOS:
        if pdo.cob_id == cob_id and len(data) >= pdo.length:
            return pdo.name, {signal.name: value_of(signal, raw_value(signal, data)) for signal in pdo.signals}
    return None


def encode(name, values, data=None):
    """The bytes of a receive PDO. What `values` leaves out stays as in `data`, else as in the PDO's rest."""
    pdo = find_pdo(name)
    if pdo.read:
        raise ValueError("{} is sent by the gateway alone".format(name))
    signals = {signal.name: signal for signal in pdo.signals}
    word = int.from_bytes(bytes(data or pdo.rest), "little")
    for key, value in values.items():
        if key not in signals:
            raise KeyError("{} carries no {!r}".format(name, key))
        mask = (1 << signals[key].bits) - 1
        word &= ~(mask << signals[key].first_bit)
        word |= (raw_of(signals[key], value) & mask) << signals[key].first_bit
    return word.to_bytes(pdo.length, "little")


# With the library canopen: `network` is a connected canopen.Network.

def subscribe(network, on_pdo):
    """Calls on_pdo(name of the PDO, {signal: value}, time) for every transmit PDO."""
    def take(cob_id, data, timestamp):
        decoded = decode(cob_id, data)
        if decoded is not None:
            on_pdo(decoded[0], decoded[1], timestamp)

    for pdo in PDOS:
        if pdo.read:
            network.subscribe(pdo.cob_id, take)


def send_periodic(network, name, values, period=None):
    """Sends a receive PDO again and again, four times in its monitoring time unless `period` (s) is given. What it
    returns has update(encode(...)) and stop()."""
    pdo = find_pdo(name)
    if period is None:
        if pdo.time_us == 0:
            raise ValueError("{} is not monitored: say a period".format(name))
        period = pdo.time_us / 4e6
    return network.send_periodic(pdo.cob_id, encode(name, values), period)


def send_heartbeat(network):
    """The heartbeat of the partner, four times in the time within which the gateway wants it; None if it wants none."""
    if PARTNER_NODE_ID == 0 or PARTNER_HEARTBEAT_US == 0:
        return None
    return network.send_periodic(0x700 + PARTNER_NODE_ID, b"\x05", PARTNER_HEARTBEAT_US / 4e6)


def start(network):
    """NMT: the gateway becomes Operational. It sends and takes PDOs only then."""
    network.send_message(0, bytes([1, NODE_ID]))


def text_of(signal, value):
    if signal.bits == 1:
        return "{:d}".format(value) if signal.on is None else "on" if value else "off"
    return "{!r}{}".format(value, " " + signal.unit if signal.unit else "" if signal.scaled else " raw")


def print_pdo(name, values, _time=None):
    for signal in find_pdo(name).signals:
        print(name, signal.name, text_of(signal, values[signal.name]))


def parse_frame(text):
    identifier, _, data = text.partition("#")
    return int(identifier, 16), bytes.fromhex(data)


def listen(channel, interface):
    import canopen
    import time

    network = canopen.Network()
    network.connect(channel=channel, interface=interface)
    subscribe(network, print_pdo)
    try:
        while True:
            time.sleep(1)
    except KeyboardInterrupt:
        pass
    finally:
        network.disconnect()
    return 0


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "listen":
        return listen(arguments[1], arguments[2])
    if len(arguments) < 2 or arguments[0] != "decode":
        print("usage: decode FRAME... | listen CHANNEL INTERFACE\n"
              "FRAME is COB-ID#DATA, both hexadecimal; listen needs the library canopen", file=sys.stderr)
        return 2
    known = True
    for text in arguments[1:]:
        try:
            decoded = decode(*parse_frame(text))
        except ValueError:
            print("{!a} is no frame: COB-ID#DATA, both hexadecimal".format(text), file=sys.stderr)
            return 2
        if decoded is None:
            print("{} is no PDO of this gateway, or too short".format(text), file=sys.stderr)
            known = False
        else:
            print_pdo(*decoded)
    return 0 if known else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
