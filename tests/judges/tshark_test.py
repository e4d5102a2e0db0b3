"""tshark reads the recorded traffic of the gateway: everything is CANopen, nothing is malformed, and the
functions that the gateway has are all there."""
import collections
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
FIELDS = ["frame.number", "can.id", "canopen.function_code", "canopen.sdo.abort_code", "_ws.malformed", "frame.protocols"]

if shutil.which("tshark") is None:
    print("skipped: tshark is not installed")
    sys.exit(SKIP)

with tempfile.TemporaryDirectory(prefix="cgw-tshark-") as directory:
    log = pathlib.Path(directory) / "run.log"
    subprocess.run([sys.argv[1], "--can1", "simulated", "--can2", "virtual", "--master", "--log", str(log),
                    "--duration", "10"], check=True, stdout=subprocess.DEVNULL)
    # CAN1 carries the governor link, which is no CANopen.
    lines = [line for line in log.read_text().splitlines(keepends=True) if " can2 " in line]
    log.write_text("".join(lines))
    logged = len(lines)
    command = ["tshark", "-r", str(log), "-d", "can.subdissector,canopen", "-T", "fields", "-E", "separator=;"]
    for field in FIELDS:
        command += ["-e", field]
    rows = [line.split(";") for line in
            subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()]

problems = []
if len(rows) != logged or logged < 100:
    problems.append(f"{logged} frames logged, {len(rows)} read by tshark")
seen = collections.Counter()
for number, identifier, function, abort, malformed, protocols in rows:
    seen[function] += 1
    if malformed or "malformed" in protocols:
        problems.append(f"frame {number} (id {identifier}) is malformed")
    if "canopen" not in protocols:
        problems.append(f"frame {number} (id {identifier}) is not CANopen: {protocols}")
aborts = sum(1 for row in rows if row[3])
# CiA 301 function codes: identifier >> 7.
for name, code in (("NMT", 0x0), ("TPDO4", 0x9), ("RPDO2", 0x6), ("SDO answer", 0xB), ("SDO request", 0xC),
                   ("boot-up and heartbeat", 0xE)):
    if not any(int(function, 0) == code for function in seen if function):
        problems.append(f"no {name} frame in the log")
if aborts == 0:
    problems.append("no SDO abort in the log")
print("\n".join(problems[:20]) or f"{len(rows)} frames, all CANopen, none malformed, {aborts} SDO aborts")
sys.exit(1 if problems else 0)
