"""A strict reader of the part of Jetter STX that cgw writes, and what the calls of the CANopen API in it do.

Types, limits and return values of the calls are those that the manual of the API prints (60881083); every other call,
constant or form of statement is an error.
"""
import re

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
DEFINE = re.compile(r"#Define ([A-Za-z]\w*) (0x[0-9A-F]+|-?[0-9]+(?:\.[0-9]+)?(?:e[-+][0-9]+)?)\Z")
DECLARATION = re.compile(r"    ([A-Za-z]\w*) : (Word|Int);(?: // signed)?\Z")
CALL = re.compile(r"(\w+) := (\w+) \+ (\w+)\((.*)\);\Z")
SIZES = {"Word": 2, "Int": 4}
TYPES = {"CANOPEN_UNSIGNED16": 2, "CANOPEN_INTEGER16": 2}
COMMANDS = {("CAN_CMD_HEARTBEAT", "CAN_HEARTBEAT_OPERATIONAL")}


class Fault(Exception):
    """Not what the manual prints."""


class Program:
    def __init__(self, text):
        self.defines, self.variables, self.received, self.sent = {}, {}, [], []
        self.values = {}  # of variables, before they are sent
        self.own_node = self.started = None
        self.operational = False
        if not text.isascii():
            raise Fault("not ASCII")
        lines = [line for line in text.split("\n") if line and not line.lstrip().startswith("//")]
        begin, end = lines.index("Var"), lines.index("End_Var;")
        for line in lines[:begin]:
            self.define(line)
        for line in lines[begin + 1:end]:
            self.declare(line)
        for statement in " ".join(lines[end + 1:]).replace(";", ";\n").splitlines():
            self.execute(re.sub(r"\s+", " ", statement.strip()))

    def new_name(self, name):
        names = {other.lower() for other in list(self.defines) + list(self.variables)}
        if not NAME.match(name) or "__" in name or name.endswith("_") or len(name) > 64 or name.lower() in names:
            raise Fault(f"{name} is no name, or stands twice")

    def define(self, line):
        found = DEFINE.match(line)
        if found is None:
            raise Fault(f"no definition: {line!r}")
        name, value = found.groups()
        self.new_name(name)
        self.defines[name] = int(value, 16) if value.startswith("0x") else float(value) if re.search("[.e]", value) else int(value)

    def declare(self, line):
        found = DECLARATION.match(line)
        if found is None:
            raise Fault(f"no declaration: {line!r}")
        self.new_name(found[1])
        self.variables[found[1]] = found[2]

    def integer(self, text, lowest, highest):
        value = self.defines.get(text, text)
        if not isinstance(value, int):
            value = int(text)
        if not lowest <= value <= highest:
            raise Fault(f"{text} is not in {lowest}..{highest}")
        return value

    def execute(self, statement):
        if re.fullmatch(r"\w+ := 0;", statement) and self.variables.get(statement.split()[0]) == "Int":
            return
        start = re.fullmatch(r"(\w+) := (\d+);", statement)
        if start is not None and self.variables.get(start[1]) == "Word" and start[1] not in self.values and \
                all(start[1] != call[3] for call in self.received + self.sent):
            self.values[start[1]] = self.integer(start[2], 0, 0xFFFF)
            return
        found = CALL.match(statement)
        if found is None or found[1] != found[2] or self.variables.get(found[1]) != "Int":
            raise Fault(f"no statement: {statement!r}")
        calls = {"CanOpenInit": self.init, "CanOpenSetCommand": self.command,
                 "CanOpenAddPDORx": lambda *given: self.received.append(self.pdo(*given)),
                 "CanOpenAddPDOTx": lambda *given: self.sent.append(self.pdo(*given))}
        if found[3] not in calls:
            raise Fault(f"{found[3]} is no call of the API")
        calls[found[3]](*re.split(r", (?![^()]*\))", found[4]))

    def init(self, line, node, version):
        self.integer(line, 0, 0)
        self.own_node = self.integer(node, 1, 127)
        if not re.fullmatch(r"'[ -&(-~]{0,255}'", version):
            raise Fault(f"{version} is no version")

    def command(self, line, kind, value):
        self.integer(line, 0, 0)
        if kind == "CAN_CMD_NMT":
            found = re.fullmatch(r"CAN_CMD_NMT_Value\((\w+), CAN_NMT_OPERATIONAL\)", value)
            self.started = self.integer(found[1], 1, 127)
        elif (kind, value) in COMMANDS:
            self.operational = True
        else:
            raise Fault(f"{kind} {value} is no command")

    def pdo(self, line, cob_id, byte, kind, size, variable, event_time, inhibit_time, parameters):
        self.integer(line, 0, 0)
        if variable not in self.variables or size != f"sizeof({variable})":
            raise Fault(f"{size} of {variable}")
        if TYPES[kind] != SIZES[self.variables[variable]] or parameters != "CANOPEN_ASYNCPDO":
            raise Fault(f"{kind} in {variable}, {parameters}")
        inhibit = self.integer(inhibit_time, 0, 65535)
        self.integer(event_time, inhibit + 1, 2**31 - 1)
        return (self.integer(cob_id, 0, 0x7FF), self.integer(byte, 0, 8 - TYPES[kind]), kind == "CANOPEN_INTEGER16",
                variable, int(event_time))

    def words(self, calls, cob_id):
        """{first byte: (signed, variable, event time)} of a PDO; overlapping ones are an error."""
        found = {}
        for identifier, byte, signed, variable, time in calls:
            if identifier == cob_id:
                if byte in found or byte - 1 in found or byte + 1 in found:
                    raise Fault(f"byte {byte} of {cob_id:X} twice")
                found[byte] = (signed, variable, time)
        return found
