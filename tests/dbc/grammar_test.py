#!/usr/bin/env python3
"""A strict reader of CAN databases: grammar, order of sections, names, references, layout and ranges; and whether
the database holds exactly the active PDOs of the JSON table beside it. It shares nothing with the program.

Usage: grammar_test.py DIRECTORY; the directory holds one sub-directory of artefacts per sample.
"""
import json
import pathlib
import re
import sys

NAME = r"[A-Za-z_][A-Za-z0-9_]*"
NUMBER = r"-?(?:0|[1-9]\d*)(?:\.\d+)?(?:e[+-]\d+)?"
TEXT = r'"([^"\\]*)"'
KEYWORDS = {"VERSION", "FILTER", "INT", "HEX", "FLOAT", "STRING", "ENUM"}
NOBODY = "Vector__XXX"

# The sections in their order. Everything up to the nodes stands once.
LINES = [
    ("VERSION", re.compile(f"VERSION {TEXT}")),
    ("NS_", re.compile(r"NS_ :")),
    ("symbol", re.compile(r"\t([A-Z_]+)")),
    ("BS_", re.compile(r"BS_:")),
    ("BU_", re.compile(rf"BU_:((?: {NAME})+)")),
    ("BO_", re.compile(rf"BO_ (\d+) ({NAME}): (\d) ({NAME})")),
    ("SG_", re.compile(rf" SG_ ({NAME}) : (\d+)\|(\d+)@1([+-]) \(({NUMBER}),({NUMBER})\) \[({NUMBER})\|({NUMBER})\] "
                       rf"{TEXT} ({NAME}(?:,{NAME})*)")),
    ("CM_", re.compile(rf"CM_ (?:BU_ ({NAME}) |BO_ (\d+) |SG_ (\d+) ({NAME}) )?{TEXT};")),
    ("BA_DEF_", re.compile(rf'BA_DEF_ (?:(BO_) )?"({NAME})" (STRING|INT -?\d+ -?\d+|ENUM "\w+"(?:,"\w+")*) ?;')),
    ("BA_DEF_DEF_", re.compile(rf'BA_DEF_DEF_ "({NAME})" ("\w*"|{NUMBER});')),
    ("BA_", re.compile(rf'BA_ "({NAME})" (?:BO_ (\d+) )?("\w*"|{NUMBER});')),
    ("VAL_", re.compile(rf"VAL_ (\d+) ({NAME})((?: \d+ {TEXT})+) ;")),
]
RANK = {name: rank for rank, (name, _) in enumerate(LINES)}
RANK["SG_"] = RANK["BO_"]


class Refused(Exception):
    pass


def demand(condition, what):
    if not condition:
        raise Refused(what)


class Database:
    def __init__(self, data):
        text = data.decode("ascii")
        demand(text.endswith("\r\n") and "\n" not in text.replace("\r\n", ""), "line ends are not CRLF")
        self.nodes, self.messages, self.definitions, self.defaults = [], {}, {}, {}
        self.comments, self.attributes, self.values = {}, {}, {}
        rank = 0
        for number, line in enumerate(text.split("\r\n"), 1):
            if not line:
                continue
            for name, pattern in LINES:
                match = pattern.fullmatch(line)
                if match:
                    break
            else:
                raise Refused(f"line {number} is none of the format: {line}")
            demand(RANK[name] >= rank, f"line {number}: {name} comes too late")
            rank = RANK[name]
            handler = getattr(self, "on_" + name.strip("_"), None)
            if handler:
                handler(*match.groups())
        self.check()

    def on_BU(self, names):
        self.nodes = names.split()

    def on_BO(self, identifier, name, length, sender):
        identifier = int(identifier)
        demand(identifier < 0x800, f"{identifier} has more than 11 bits")
        demand(identifier not in self.messages, f"identifier {identifier} twice")
        self.messages[identifier] = {"name": name, "length": int(length), "sender": sender, "signals": {}}
        self.last = self.messages[identifier]

    def on_SG(self, name, start, length, sign, factor, offset, low, high, unit, receivers):
        demand(name not in self.last["signals"], f"signal {name} twice in {self.last['name']}")
        self.last["signals"][name] = {
            "start": int(start), "length": int(length), "signed": sign == "-", "factor": float(factor),
            "offset": float(offset), "low": float(low), "high": float(high), "unit": unit,
            "receivers": receivers.split(",")}

    def on_CM(self, node, message, signal_message, signal, text):
        key = (node, message and int(message), signal_message and int(signal_message), signal)
        demand(key not in self.comments, f"comment twice: {key}")
        self.comments[key] = text

    def on_BA_DEF(self, where, name, kind):
        self.definitions[name] = (where, kind)

    def on_BA_DEF_DEF(self, name, value):
        self.defaults[name] = value

    def on_BA(self, name, message, value):
        demand((name, message) not in self.attributes, f"attribute twice: {name} {message}")
        self.attributes[name, message] = value

    def on_VAL(self, message, signal, pairs, _):
        self.values[int(message), signal] = [int(n) for n, _ in re.findall(rf" (\d+) {TEXT}", pairs)]

    def check(self):
        names = [m["name"] for m in self.messages.values()]
        demand(len({n.lower() for n in names}) == len(names), "message name twice")
        for name in names + self.nodes + [s for m in self.messages.values() for s in m["signals"]]:
            demand(len(name) <= 32, f"{name} is longer than 32")
            demand(name not in KEYWORDS and not name.endswith("_"), f"{name} is a word of the format")
        for message in self.messages.values():
            self.check_message(message)
        self.check_references()
        self.check_attributes()

    def check_message(self, message):
        used = set()
        demand(message["sender"] in self.nodes + [NOBODY], f"sender {message['sender']} is no node")
        demand(message["length"] <= 8, f"{message['name']} is too long")
        lower = [name.lower() for name in message["signals"]]
        demand(len(set(lower)) == len(lower), f"names of {message['name']} differ in case only")
        for name, signal in message["signals"].items():
            bits = set(range(signal["start"], signal["start"] + signal["length"]))
            demand(bits and max(bits) < 8 * message["length"], f"{name} does not fit {message['name']}")
            demand(not bits & used, f"{name} overlaps another signal of {message['name']}")
            used |= bits
            demand(signal["factor"] != 0, f"{name} has factor 0")
            demand(set(signal["receivers"]) <= set(self.nodes + [NOBODY]), f"receiver of {name} is no node")
            low = -(1 << signal["length"] - 1) if signal["signed"] else 0
            high = low + (1 << signal["length"]) - 1
            ends = sorted(raw * signal["factor"] + signal["offset"] for raw in (low, high))
            slack = 1e-9 * max(1, abs(ends[0]), abs(ends[1]))
            demand(signal["low"] < signal["high"], f"{name} has no range")
            demand(ends[0] - slack <= signal["low"] and signal["high"] <= ends[1] + slack, f"{name}: no word has its ends")

    def check_references(self):
        for node, message, signal_message, signal in self.comments:
            demand(node is None or node in self.nodes, f"comment on unknown node {node}")
            demand(message is None or message in self.messages, f"comment on unknown message {message}")
            demand(signal is None or signal in self.messages[signal_message]["signals"], f"comment on unknown {signal}")
        for (message, signal), values in self.values.items():
            length = self.messages[message]["signals"][signal]["length"]
            demand(max(values) < 1 << length and values == sorted(set(values)), f"values of {signal} do not fit")

    def check_attributes(self):
        demand(set(self.defaults) == set(self.definitions), "attributes and defaults differ")
        for (name, message), value in self.attributes.items():
            demand(name in self.definitions, f"attribute {name} is not defined")
            where, kind = self.definitions[name]
            demand((where == "BO_") == (message is not None), f"attribute {name} stands at the wrong place")
            demand(message is None or int(message) in self.messages, f"attribute of unknown message {message}")
            if kind.startswith("ENUM"):
                demand(int(value) < kind.count(",") + 1, f"{name} {value} is no index")
            elif kind.startswith("INT"):
                low, high = map(int, kind.split()[1:])
                demand(low <= int(value) <= high, f"{name} {value} is out of its range")


def compare(database, table):
    """Active PDOs: identifier, length, sender, cycle, one signal at every word that is no dummy."""
    gateway = f"GW{table['node_id']}"
    active = [pdo for pdo in table["pdos"] if pdo["active"]]
    pdos = {i: m for i, m in database.messages.items() if "PDO" in m["name"]}
    demand({pdo["cob_id"] for pdo in active} == set(pdos), "the PDOs of table and database differ")
    for pdo in active:
        message = pdos[pdo["cob_id"]]
        transmit = pdo["direction"] == "transmit"
        demand(message["name"] == f"{gateway}_{pdo['name']}", f"{pdo['name']} is called {message['name']}")
        demand(message["length"] == pdo["length"], f"{pdo['name']}: lengths differ")
        demand((message["sender"] == gateway) == transmit, f"{pdo['name']}: the sender is wrong")
        cycle = database.attributes.get(("GenMsgCycleTime", str(pdo["cob_id"])))
        expected = str(pdo["effective_time_us"] // 1000) if transmit and pdo["effective_time_us"] else None
        demand(cycle == expected, f"{pdo['name']}: cycle {cycle}, expected {expected}")
        for position, word in enumerate(pdo["mapping"]):
            signals = [n for n, s in message["signals"].items() if s["start"] // 16 == position]
            demand(bool(signals) == (word["index"] != 6), f"{pdo['name']} word {position + 1}: {signals}")
            if word["parameter"] is not None:
                comment = database.comments[None, None, pdo["cob_id"], signals[0]]
                demand(str(word["parameter"]) in comment, f"{signals[0]}: {comment}")
            for carried in word.get("switches", []):
                demand(any(s["start"] == 16 * position + carried["bit"] - 1 and s["length"] == 1
                           for s in message["signals"].values()), f"switch {carried} has no signal")
    return len(active)


BROKEN = [
    ("a duplicate identifier", b"BO_ 1548 ", b"BO_ 1420 "),
    ("an overlap", b" SG_ SpeedSetp : 16|16", b" SG_ SpeedSetp : 15|16"),
    ("a signal behind the end", b" SG_ ActPos : 32|16", b" SG_ ActPos : 49|16"),
    ("a name twice", b" SG_ SpeedSetp ", b" SG_ Speed "),
    ("a blank too many", b"BU_: ", b"BU_:  "),
    ("an enumeration as text", b'BA_ "VFrameFormat" BO_ 0 0;', b'BA_ "VFrameFormat" BO_ 0 "StandardCAN";'),
    ("an unknown receiver", b'"1/min" Node1', b'"1/min" Node2'),
    ("another byte order", b"@1+", b"@0+"),
    ("a wrong range", b"[0|4000]", b"[0|4001]"),
    ("another character set", b"degC", b"\xb0C"),
    ("sections out of order", b"BS_:\r\n", b"VAL_ 0 Command 1 \"x\" ;\r\n"),
]


def main():
    samples = sorted(path.parent for path in pathlib.Path(sys.argv[1]).glob("*/CANopenGateway.dbc"))
    if not samples:
        sys.exit("no databases found")
    for sample in samples:
        database = Database((sample / "CANopenGateway.dbc").read_bytes())
        table = json.loads((sample / "pdo-table.json").read_text(encoding="utf-8"))
        demand(table["configuration_id"] in database.comments[None, None, None, None], "another configuration id")
        active = compare(database, table)
        signals = sum(len(m["signals"]) for m in database.messages.values())
        print(f"{sample.name}: {active} PDOs, {len(database.messages)} messages, {signals} signals")
    good = (pathlib.Path(sys.argv[1]) / "genset" / "CANopenGateway.dbc").read_bytes()
    for what, old, new in BROKEN:
        if old not in good:
            sys.exit(f"{what}: nothing to break")
        try:
            Database(good.replace(old, new, 1))
        except (Refused, UnicodeDecodeError, ValueError):
            continue
        sys.exit(f"the judge does not notice {what}")


if __name__ == "__main__":
    main()
