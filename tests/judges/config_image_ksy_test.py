"""schemas/config-image.ksy against real images: a small reader of the subset of Kaitai Struct that it uses takes images
apart by the specification alone, and every byte and value must be what `cgw image annotate` tells.

Kaitai's own compiler is no Debian package; this reader knows nothing of cgw. It understands seq, params, instances with io
and pos, size, size-eos, contents, repeat eos and expr, enum, switch-on, str, u1 u2 u4 f8 and types with arguments."""
import json
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest
import zlib

import yaml

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
SPECIFICATION = SAMPLES.parent / "schemas" / "config-image.ksy"
NUMBERS = {"u1": "<B", "u2": "<H", "u4": "<I", "f8": "<d"}
KNOWN = {"id", "type", "size", "size-eos", "contents", "repeat", "repeat-expr", "enum", "doc", "encoding", "io", "pos"}


class Stream:
    def __init__(self, data, start=0):
        self.data, self.start, self.at = data, start, 0

    def take(self, size):
        if size < 0 or self.at + size > len(self.data):
            raise ValueError("the bytes end before")
        self.at += size
        return self.data[self.at - size:self.at]


class Object(dict):
    """A parsed type; `leaves` are (offset, size, name, value) of everything read."""


class Reader:
    def __init__(self, specification, data):
        self.specification, self.leaves = specification, []
        self.root = Object(_io=Stream(data))
        self.fill(self.root, specification, self.root["_io"])

    def evaluate(self, expression, scope):
        if isinstance(expression, int):
            return expression
        if match := re.fullmatch(r"(.+) - (\d+)", expression):
            return self.evaluate(match[1], scope) - int(match[2])
        value = scope
        for name in expression.split("."):
            value = self.root if name == "_root" else value[name]
        return value

    def fill(self, scope, definition, stream):
        for field in definition.get("seq", []):
            scope[field["id"]] = self.field(field, scope, stream)
        for name, field in definition.get("instances", {}).items():
            source = self.evaluate(field["io"], scope) if "io" in field else stream
            before, source.at = source.at, self.evaluate(field["pos"], scope)
            scope[name] = self.field({"id": name, **field}, scope, source)
            source.at = before

    def field(self, field, scope, stream):
        assert set(field) <= KNOWN, field
        repeat = field.get("repeat")
        if repeat is None:
            return self.one(field, field["id"], scope, stream)
        values = []
        while (stream.at < len(stream.data) if repeat == "eos"
               else len(values) < self.evaluate(field["repeat-expr"], scope)):
            values.append(self.one(field, f"{field['id']}[{len(values)}]", scope, stream))
        return values

    def one(self, field, name, scope, stream):
        start = stream.start + stream.at
        if "contents" in field:
            content = stream.take(len(field["contents"]))
            assert content == field["contents"].encode()
            return self.leaf(start, content, name, content)
        type_ = field.get("type")
        if isinstance(type_, dict):
            type_ = type_["cases"].get(self.evaluate(type_["switch-on"], scope))
        if type_ in NUMBERS:
            content = stream.take(struct.calcsize(NUMBERS[type_]))
            value = struct.unpack(NUMBERS[type_], content)[0]
            if "enum" in field:
                value = self.specification["enums"][field["enum"]][value]
            return self.leaf(start, content, name, value)
        if "size" in field or field.get("size-eos"):
            size = len(stream.data) - stream.at if field.get("size-eos") else self.evaluate(field["size"], scope)
            content = stream.take(size)
            if type_ == "str":
                return self.leaf(start, content, name, content.decode(field["encoding"]))
            if type_ is None:
                return self.leaf(start, content, name, content)
            stream = Stream(content, start)
        made = Object()
        called, _, arguments = type_.partition("(")
        definition = self.specification["types"][called]
        for parameter, argument in zip(definition.get("params", []), filter(None, arguments.rstrip(")").split(","))):
            made[parameter["id"]] = self.evaluate(argument, scope)
        self.fill(made, definition, stream)
        return made

    def leaf(self, start, content, name, value):
        if content:
            self.leaves.append((start, len(content), name, value))
        return value


def cgw(*arguments):
    return subprocess.run([CGW, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, check=True,
                          timeout=120).stdout


class ConfigImage(unittest.TestCase):
    def setUp(self):
        self.specification = yaml.safe_load(SPECIFICATION.read_text())
        self.directory = tempfile.TemporaryDirectory(prefix="cgw-ksy-")
        self.addCleanup(self.directory.cleanup)

    def images(self):
        for sample in ("genset.toml", "minimal.toml", "manual-example.toml"):
            for options in ([], ["--no-labels"]):
                path = pathlib.Path(self.directory.name) / "x.bin"
                cgw("emit", "image", SAMPLES / sample, *options, "-o", path)
                yield sample, path, path.read_bytes()

    def test_takes_images_apart_as_annotate_does(self):
        for sample, path, image in self.images():
            leaves = {(start, size): (name, value) for start, size, name, value in
                      Reader(self.specification, image).leaves}
            compared = 0
            for record in json.loads(cgw("image", "annotate", path, "--json"))["records"]:
                if record["section"] in (None, "object_values", "strings", "model"):
                    continue
                for field in record["fields"]:
                    if field["name"] == "padding":
                        continue
                    name, value = leaves.pop((field["offset"], field["size"]), (None, None))
                    self.assertEqual(name, field["name"], (sample, record["title"]))
                    self.compare(value, field, (sample, record["title"], name))
                    compared += 1
            self.assertGreater(compared, 500, sample)
            self.assertTrue({name for name, _ in leaves.values()} <= {"content", "text"}, leaves)

    def compare(self, value, field, where):
        text = field["value"]
        if isinstance(value, bytes):
            self.assertEqual(value.hex(), field["bytes"], where)
        elif isinstance(value, str):  # of an enum
            self.assertIn(value.replace("_", " ").lower().replace("constant", "const"), field["meaning"].lower(), where)
        elif text.startswith("0x"):
            self.assertEqual(value, int(text, 16), where)
        elif text.endswith("h"):
            self.assertEqual(value, int(text[:-1], 16), where)
        elif field["type"] == "f64":
            self.assertEqual(value, float(text), where)
        else:
            self.assertEqual(value, int(text) & (256 ** field["size"] - 1), where)

    def test_gives_the_values_that_inspect_shows(self):
        for sample, path, image in self.images():
            told = json.loads(cgw("image", "inspect", path, "--json"))
            root = Reader(self.specification, image).root
            header = root["header"]
            self.assertEqual(header["total_size"], len(image))
            self.assertEqual(header["configuration_id"].hex(), told["configuration_sha256"])
            self.assertEqual(".".join(map(str, header["tool_version"])), told["tool_version"])
            self.assertEqual(root["trailer"]["crc32"], zlib.crc32(image[:-4]))
            ids = self.specification["enums"]["section_id"]
            sections = {ids[entry["id"]]: entry["content"] for entry in root["directory"]}
            records = {name: content["records"] for name, content in sections.items()
                       if isinstance(content, dict) and "records" in content}
            self.assertEqual(records["identity"][0], told["identity"])
            for record, bus in zip(records["buses"], told["buses"].values(), strict=True):
                self.assertEqual((record["own_node"], record["bit_rate_kbit"], record["registers"]),
                                 (bus["node"], bus["bit_rate_kbit"], bus["registers"]))
            active = [pdo for pdo in records["pdos"] if pdo["active"]]
            self.assertEqual([(pdo["direction"], pdo["number"], pdo["cob_id"]) for pdo in active],
                             [(pdo["direction"], pdo["number"], pdo["cob_id"]) for pdo in told["pdos"]])
            self.assertEqual(len(records["objects"]), told["object_count"])
            self.assertEqual([label["number"] for label in records.get("labels", [])],
                             [label["number"] for label in told["labels"]])
            self.assertEqual("model" in sections, "labels" in sections)


if __name__ == "__main__":
    unittest.main()
