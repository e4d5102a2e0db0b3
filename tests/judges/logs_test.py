"""tshark reads our pcap file and our candump log and sees the same frames in both; what tshark writes we read.
   logs_test.py CONVERT_LOG"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
# time, identifier, extended, remote, length, data
FRAMES = [
    ("0.000000", 0x000, False, False, 2, "0105"),
    ("0.000001", 0x701, False, False, 1, "00"),
    ("12.999999", 0x181, False, False, 8, "0102030405060708"),
    ("13.000000", 0x080, False, False, 0, ""),
    ("1700000000.123456", 0x1ABCDEF0, True, False, 3, "aabbcc"),
    ("1700000000.123457", 0x123, True, False, 0, ""),
    ("1700000000.123458", 0x705, False, True, 0, ""),
    ("1700000001.000000", 0x7FF, False, False, 8, "ffffffffffffffff"),
]
FIELDS = ["frame.time_epoch", "can.id", "can.flags.xtd", "can.flags.rtr", "can.len", "data.data"]


def candump_line(frame):
    time, identifier, extended, remote, _, data = frame
    seconds, fraction = time.split(".")
    return (f"({int(seconds):010}.{fraction}) can0 {identifier:0{8 if extended else 3}X}#"
            f"{'R' if remote else data.upper()}\n")


def convert(source, target):
    subprocess.run([sys.argv[1], str(source), str(target)], check=True)
    return target


def seen_by_tshark(file):
    # By itself tshark takes identifier 0 for another protocol than CANopen.
    command = ["tshark", "-r", str(file), "--disable-protocol", "autosar-nm", "-T", "fields", "-E", "separator=;"]
    for field in FIELDS:
        command += ["-e", field]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    frames = []
    for line in output.splitlines():
        time, identifier, extended, remote, length, data = line.split(";")
        frames.append((time[:-3], int(identifier, 0), extended in ("1", "True"), remote in ("1", "True"), int(length), data))
    return frames


if shutil.which("tshark") is None:
    print("skipped: tshark is not installed")
    sys.exit(SKIP)

problems = []
with tempfile.TemporaryDirectory(prefix="cgw-logs-") as name:
    directory = pathlib.Path(name)
    original = directory / "original.log"
    original.write_text("".join(map(candump_line, FRAMES)))

    log = convert(original, directory / "ours.log")
    pcap = convert(original, directory / "ours.pcap")
    for file in (log, pcap):
        seen = seen_by_tshark(file)
        if seen != FRAMES:
            problems.append(f"tshark sees something else in {file.name}:\n  {seen}\n  {FRAMES}")

    for file_type in ("pcap", "nsecpcap"):
        theirs = directory / f"theirs-{file_type}.pcap"
        subprocess.run(["tshark", "-r", str(pcap), "-F", file_type, "-w", str(theirs)], check=True, capture_output=True)
        back = convert(theirs, theirs.with_suffix(".log"))
        if back.read_text() != original.read_text():
            problems.append(f"{theirs.name}, written by tshark, reads as\n{back.read_text()}")

print("\n".join(problems) or f"{len(FRAMES)} frames, the same in candump log and pcap, forth and back")
sys.exit(1 if problems else 0)
