"""Parameter files for the judges of the schema: read as editors read them, and generated."""
import datetime
import itertools
import json
import math
import os
import pathlib
import random
import re
import subprocess
import tomllib

CGW = os.environ["CGW"]
SOURCE = pathlib.Path(os.environ["CGW_SOURCE"])
SCHEMA_FILE = SOURCE / "schemas/parameter-file.schema.json"


def as_json(value):
    """A TOML value as a JSON document: what tools that check TOML against a schema make of it."""
    if isinstance(value, dict):
        return {key: as_json(item) for key, item in value.items()}
    if isinstance(value, list):
        return [as_json(item) for item in value]
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    return None if isinstance(value, float) and not math.isfinite(value) else value


def load(path):
    """None when the file is not TOML."""
    try:
        return as_json(tomllib.loads(pathlib.Path(path).read_bytes().decode()))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError):
        return None


def codes(paths):
    """What cgw finds: the set of error codes by path."""
    found = {}
    paths = [str(path) for path in paths]
    for chunk in (paths[i:i + 200] for i in range(0, len(paths), 200)):
        result = subprocess.run([CGW, "check", "--format", "json", *chunk], stdout=subprocess.PIPE, timeout=300)
        for file in json.loads(result.stdout)["files"]:
            found[file["path"]] = {f["code"] for f in file["diagnostics"] if f["level"] == "error"}
    return found


def is_well_formed(error_codes):
    """Nothing is wrong with keys and values; whether the plant would work is no business of a schema."""
    return not any(code < "E0200" for code in error_codes)


class Row:
    """One settable parameter of a shipped catalogue."""

    def __init__(self, device, table, offset=0):
        self.device, self.table = device, table
        self.number = table["number"] + offset
        self.array = "count" in table
        self.names = [table["name"]] if "name" in table else []
        self.names += table.get("aliases", [])
        if self.array:
            bare = self.names[:1] if offset == 0 else []
            self.names = [f"{name}({offset})" for name in self.names] + bare
            self.last = max(table["number"] + table["count"] - 1, table.get("list_end", 0) if offset == 0 else 0)
        self.text = re.sub(r"\{(\d+)\}", lambda m: str(int(m[1]) + offset), table.get("text", ""))

    def label(self):
        return f"{self.number} {self.names[0]}" if self.names else str(self.number)

    def limits(self):
        if "range" in self.table:
            return self.table["range"]
        return {"switch": (0, 4), "sensor": (0, 4)}[self.table["kind"]] if self.number > 4000 else (-32768, 32767)


def shipped_rows(device):
    name = {"governor": "digital-governor", "gateway": "canopen-gateway"}[device]
    tables = tomllib.loads((SOURCE / f"schemas/parameters/{name}.toml").read_text())["row"]
    for table in tables:
        if table["kind"] == "measurement":
            continue
        count = table.get("count", table.get("last", table["number"]) - table["number"] + 1)
        yield from (Row(device, table, offset) for offset in range(count))


ROWS = {device: list(shipped_rows(device)) for device in ("governor", "gateway")}


class Generator:
    """Files that are right as far as keys and values go, spelled in every way that cgw accepts."""

    def __init__(self, seed, directory):
        self.random = random.Random(seed)
        self.directory = pathlib.Path(directory)

    def value(self, row):
        if "choices" in row.table:
            return str(self.random.choice(row.table["choices"]))
        low, high = row.limits()
        if row.table.get("decimal") and self.random.random() < 0.5:
            return repr(self.random.choice([float(low), float(high), self.random.uniform(low, high)]))
        number = self.random.choice([low, high, self.random.randint(int(low), int(high))])
        return hex(number) if number >= 0 and self.random.random() < 0.3 else str(number)

    def any_case(self, text):
        how = self.random.choice([str, str, str.lower, str.upper, str.swapcase])
        return how(text).replace("(", self.random.choice(["(", "(", " (", "  ("]))

    def key(self, row):
        blank = lambda: self.random.choice(["", "", "", " ", "\t"])
        number = str(row.number)
        if not row.names:
            text = self.random.choice([number, f"{number} Anything {chr(0x3a9)}", f"{number}\t"])
        else:
            name = self.any_case(self.random.choice(row.names))
            misprint = self.random.choice(row.table.get("misprints", [number]))
            both = f"{number}{self.random.choice([' ', '  ', chr(9)])}{name}"
            text = self.random.choice([number, name, both, row.names[0], row.label(), misprint])
        text = blank() + text + blank()
        return text if re.fullmatch(r"[A-Za-z0-9_-]+", text) else json.dumps(text, ensure_ascii=False)

    def parameters(self, device):
        rows = {row.number: row for row in ROWS[device]}
        needed = {"governor": (401, 403, 416), "gateway": (401, 402, 416, 426, 427)}[device]
        wanted = set(needed) | set(self.random.sample(sorted(rows), self.random.randint(0, 25)))
        done, lines = set(), []
        for number in sorted(wanted, key=lambda _: self.random.random()):
            row = rows[number]
            if number in done:
                continue
            numbers = [number]
            if row.array and self.random.random() < 0.6:
                room = itertools.takewhile(lambda n: n not in done, range(number, row.last + 1))
                numbers = list(room)[:self.random.randint(1, 60)]
            done.update(numbers)
            values = [self.value(rows[n]) for n in numbers]
            is_list = row.array and (len(values) > 1 or self.random.random() < 0.3)
            lines.append(f"{self.key(row)} = {'[' + ', '.join(values) + ']' if is_list else values[0]}")
        return lines

    def declarations(self):
        for number in self.random.sample(range(2990, 3000), self.random.randint(1, 3)):
            yield from ["[[governor.declare]]", f"number = {number}", f'name = "Own{number}"', 'kind = "measurement"']
            if self.random.random() < 0.2:
                yield "bit = true"
            else:
                yield from ["width = 16", "signed = true", 'unit = "%"', "internal = [-32768, 32767.0]"]
                yield self.random.choice(["external = [-100.0, 100]", "external = [0, { parameter = 981 }]", ""])

    def catalogue(self, name):
        """A catalogue with one settable parameter that cgw does not know; returns its spellings."""
        rows = ['device = "governor"', "[[row]]", "number = 5123", 'name = "Own.Setting"', 'kind = "function"',
                "range = [-5, 7]"]
        (self.directory / name).write_text("\n".join(rows))
        return ["5123 = -5", '"5123 OWN.Setting" = 7', '"own.setting" = 0']

    def file(self, index):
        choose = lambda *texts: self.random.choice(("", *texts))
        lines = ["format = 1", choose('title = "Genset \\u00e4"', "title = '''T'''")]
        own = []
        if self.random.random() < 0.2:
            own = [self.random.choice(self.catalogue(f"own{index}.toml"))]
            lines.append(f'catalogue = ["own{index}.toml"]')
        lines += [choose("document.created = 2026-03-01", 'document = { author = "", revision = 255 }')]
        lines += ["[governor]", choose('profile = "digital-governor"'), choose("main_cycle_us = 10000")]
        lines += self.declarations() if self.random.random() < 0.2 else []
        lines += ["[governor.parameters]", *self.parameters("governor"), *own]
        lines += ["[gateway]", choose("identity = { software_version = 65535, serial_date = 9912 }", "identity = {}")]
        lines += [choose('bit_timing = { can1 = { clock_hz = 16000000, family = "mcp2515" } }')]
        lines += ["[gateway.parameters]", *self.parameters("gateway")]
        lines += [choose("[network]", "[network]\nnodes = []", "[network]\nnodes = [2, 127]")]
        path = self.directory / f"generated{index}.toml"
        path.write_text("\n".join(lines) + "\n")
        return path


# Slips of the kind that are made while typing: (what, the line of the sample that is replaced, by what).
# Each is an error to cgw, and the schema shows it too.
SAMPLE = """format = 1
title = "Genset 2"
[document]
created = 2026-03-01
[governor]
main_cycle_us = 15625
[governor.parameters]
401 = 1
403 = 1
416 = 250
4406 = 1
16400 = [2000, 2031]
[gateway]
identity = { software_version = 1 }
[gateway.parameters]
401 = 1
402 = 1
416 = 250
4400 = 1
426 = 125
427 = 1
"CanOpTPDO5-16ID(0)" = 0x282
[network]
nodes = [2]
"""
SLIPS = [
    ("value out of range", "427 = 1", "427 = 128"),
    ("value out of range by name", "427 = 1", "CanOpenMyNodeID = 0"),
    ("value out of range by number and name", "427 = 1", '"427 CanOpenMyNodeID" = 300'),
    ("bit rate that does not exist", "426 = 125", "426 = 200"),
    ("identifier above 7FFh", '"CanOpTPDO5-16ID(0)" = 0x282', '"CanOpTPDO5-16ID(0)" = 0x800'),
    ("value of a list out of range", "16400 = [2000, 2031]", "16400 = [2000, 30000]"),
    ("number in quotes", "427 = 1", '427 = "1"'),
    ("true for 1", "4406 = 1", "4406 = true"),
    ("fraction where a whole number is due", "416 = 250", "416 = 250.5"),
    ("list for a single value", "427 = 1", "427 = [1]"),
    ("empty list", "16400 = [2000, 2031]", "16400 = []"),
    ("list longer than its array", '"CanOpTPDO5-16ID(0)" = 0x282', f"CanOpTPDO5-16ID = {[5] * 13}"),
    ("misspelt name", "427 = 1", "CanOpenMyNodeId_ = 1"),
    ("name with another number", "427 = 1", '"428 CanOpenMyNodeID" = 1'),
    ("number with a misspelt name", "427 = 1", '"427 CanOpenMyNode" = 1'),
    ("parameter of the other device", "402 = 1", "402 = 1\n403 = 1"),
    ("number that nobody knows", "427 = 1", "427 = 1\n499 = 1"),
    ("measurement", "16400 = [2000, 2031]", "2000 = 1"),
    ("element behind the array", '"CanOpTPDO5-16ID(0)" = 0x282', '"CanOpTPDO5-16ID(12)" = 0x282'),
    ("format of the future", "format = 1", "format = 2"),
    ("format missing", "format = 1", ""),
    ("unknown key at the top", 'title = "Genset 2"', 'titel = "Genset 2"'),
    ("unknown key of a table", "main_cycle_us = 15625", "main_cycle_ms = 15"),
    ("unknown key of an inline table", "identity = { software_version = 1 }", "identity = { version = 1 }"),
    ("empty title", 'title = "Genset 2"', 'title = ""'),
    ("date in quotes with blanks", "created = 2026-03-01", 'created = "1 March"'),
    ("main cycle out of range", "main_cycle_us = 15625", "main_cycle_us = 15"),
    ("node id out of range", "nodes = [2]", "nodes = [2, 128]"),
    ("node listed twice", "nodes = [2]", "nodes = [2, 2]"),
    ("controller family that does not exist", "identity = { software_version = 1 }",
     'bit_timing = { can1 = { clock_hz = 1, family = "sja1000" } }'),
    ("half of a bit timing", "identity = { software_version = 1 }", "bit_timing = { can1 = { clock_hz = 1 } }"),
    ("declaration without a number", "main_cycle_us = 15625", 'declare = [{ name = "X", kind = "sensor" }]'),
    ("declaration of a kind that does not exist", "main_cycle_us = 15625",
     'declare = [{ number = 2990, name = "X", kind = "gauge", width = 16, signed = true }]'),
    ("gateway missing", "[gateway]\nidentity = { software_version = 1 }\n[gateway.parameters]", ""),
]


def slipped(old, new):
    assert SAMPLE.count(old + "\n") >= 1, old
    at = SAMPLE.rindex("\n" + old + "\n") + 1 if "\n" + old + "\n" in SAMPLE else SAMPLE.index(old)
    return SAMPLE[:at] + new + SAMPLE[at + len(old):]
