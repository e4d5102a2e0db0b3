#!/usr/bin/env python3
"""The data sheet read by the standard library's configparser says the same as the JSON table, and the device
configuration file the same as the data sheet with the node number put in.

Usage: agreement_test.py DIRECTORY; the directory holds one sub-directory of artefacts per sample.
"""
import configparser
import json
import pathlib
import sys

NOT_VALID = 0x80000000


def number(text, node_id):
    if text.startswith("$NODEID+"):
        return int(text[len("$NODEID+"):], 0) + node_id
    return int(text, 0)


def read(path):
    parser = configparser.RawConfigParser(strict=True)
    parser.optionxform = str
    parser.read_string(path.read_bytes().decode("ascii"))
    return parser


def compare(directory):
    eds = read(directory / "CANopenGateway.eds")
    table = json.loads((directory / "pdo-table.json").read_text(encoding="utf-8"))
    node_id = table["node_id"]
    if table["configuration_id"] not in eds["FileInfo"]["Description"]:
        raise AssertionError("the data sheet carries another configuration id")

    def value(index, sub):
        return number(eds[f"{index:04X}sub{sub:X}"]["DefaultValue"], node_id)

    for pdo in table["pdos"]:
        transmit = pdo["direction"] == "transmit"
        communication = (0x1800 if transmit else 0x1400) + pdo["number"] - 1
        mapping = communication + 0x200
        expected = pdo["cob_id"] | (0 if pdo["active"] else NOT_VALID)
        check(pdo, "identifier", value(communication, 1), expected)
        check(pdo, "transmission type", value(communication, 2), pdo["transmission_type"])
        time = pdo["effective_time_us"] // 1000 if pdo["active"] else 0
        check(pdo, "event timer", value(communication, 5), time)
        entries = [e["index"] << 16 | e["sub_index"] << 8 | e["bits"] for e in pdo["mapping"]]
        check(pdo, "mapping", [value(mapping, i + 1) for i in range(value(mapping, 0))], entries)
        check(pdo, "length", sum(e["bits"] for e in pdo["mapping"]), 8 * pdo["length"])
    return len(table["pdos"])


def compare_configuration_file(directory):
    """Every value of the data sheet is the file's default; parameter values equal the defaults."""
    eds = read(directory / "CANopenGateway.eds")
    dcf = read(directory / "CANopenGateway.dcf")
    node_id = int(dcf["DeviceComissioning"]["NodeID"])
    values = 0
    for name in eds.sections():
        if "DefaultValue" not in eds[name]:
            continue
        expected = number(eds[name]["DefaultValue"], node_id)
        for key in ("DefaultValue", "ParameterValue"):
            if key in dcf[name] and int(dcf[name][key], 0) != expected:
                raise AssertionError(f"[{name}] {key} is {dcf[name][key]}, the data sheet's default {expected:X}h")
        values += "ParameterValue" in dcf[name]
    if set(dcf.sections()) != set(eds.sections()) | {"DeviceComissioning"}:
        raise AssertionError("data sheet and configuration file have different objects")
    if dcf["FileInfo"]["LastEDS"] != eds["FileInfo"]["FileName"]:
        raise AssertionError("the configuration file names another data sheet")
    return values


def check(pdo, what, found, expected):
    if found != expected:
        raise AssertionError(f"{pdo['name']}: {what} is {found} in the data sheet, {expected} in the table")


def main():
    samples = sorted(path.parent for path in pathlib.Path(sys.argv[1]).glob("*/CANopenGateway.eds"))
    if not samples:
        sys.exit("no artefacts found")
    for sample in samples:
        pdos = compare(sample)
        if pdos != 20:
            sys.exit(f"{sample.name}: {pdos} PDOs")
        values = compare_configuration_file(sample)
        if values < 200:
            sys.exit(f"{sample.name}: {values} parameter values in the configuration file")
        print(f"{sample.name}: data sheet, table and configuration file agree on {pdos} PDOs, {values} values")


if __name__ == "__main__":
    main()
