"""Our SocketCAN channel, canopen-gateway and cgw verify on a real CAN interface of the kernel, against candump, cansend and cangen of
can-utils: a Debian kernel in QEMU runs init.sh, and what that prints is checked here.
   vcan_test.py MEDIA_VCAN_CHECK CANOPEN_GATEWAY CGW PARAMETER_FILE DIRECTORY_OF_THE_KERNEL"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
PROGRAMS = ["qemu-system-x86_64", "busybox", "candump", "cansend", "cangen", "slcanpty", "tc", "cpio", "gzip", "strip"]
IN_GUEST = ["busybox", "candump", "cansend", "cangen", "slcanpty", "tc"]
MODULES = ["can", "can-raw", "can-dev", "vcan", "sch_tbf"]
SEARCH = "/usr/sbin:/usr/bin:/sbin:/bin"
FLOOD = 5000
BURST = 20
SECONDS = 240


def skip(reason):
    print(f"skipped: {reason}; .ci/install-packages test gets what is missing")
    sys.exit(SKIP)


def libraries(program):
    listed = subprocess.run(["ldd", str(program)], capture_output=True, text=True).stdout
    return re.findall(r"(/\S+)", listed)


def add(root, source, target):
    path = root / target.lstrip("/")
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        shutil.copy(pathlib.Path(source).resolve(), path)


def make_initramfs(directory, check, gateway, cgw, plant, kernel):
    root = directory / "root"
    programs = {name: shutil.which(name, path=SEARCH) for name in IN_GUEST} | {
        "media_vcan_check": check, "canopen-gateway": gateway, "cgw": cgw}
    for name, path in programs.items():
        add(root, path, f"bin/{name}")
        for library in libraries(path):
            add(root, library, library)
    ours = [str(root / "bin" / name) for name in ("media_vcan_check", "canopen-gateway", "cgw")]
    subprocess.run(["strip", "--strip-debug", *ours], check=True)
    add(root, plant, "plant.toml")
    for module in MODULES:
        add(root, kernel / f"{module}.ko", f"modules/{module}.ko")
    add(root, pathlib.Path(__file__).parent / "init.sh", "init")
    (root / "init").chmod(0o755)
    image = directory / "initramfs.gz"
    subprocess.run(f"find . | cpio -o -H newc --quiet | gzip -1 > '{image}'", shell=True, check=True, cwd=root)
    return image


def boot(kernel, image):
    command = ["qemu-system-x86_64", "-accel", "tcg", "-cpu", "max", "-m", "1024", "-smp", "1", "-nodefaults", "-no-reboot",
               "-display", "none", "-serial", "stdio", "-kernel", str(kernel / "vmlinuz"), "-initrd", str(image),
               "-append", "console=ttyS0 quiet panic=-1 loglevel=3"]
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS).stdout
    except subprocess.TimeoutExpired as expired:
        return (expired.stdout or b"") + b"\n[the guest was stopped after %d s]\n" % SECONDS


def sections(output):
    found = {}
    for line in output.splitlines():
        if line.startswith("== "):
            found[line[3:]] = current = []
        elif found:
            current.append(line)
    return found


def frames(lines):
    """The part of each candump line behind the interface."""
    return [line.split()[-1] for line in lines]


def problems_of(found):
    problems = []

    def expect(what, seen, wanted):
        if seen != wanted:
            problems.append(f"{what}:\n  seen   {seen}\n  wanted {wanted}")

    if "failed" in "".join(found["progress"]) or "end" not in found:
        problems.append("the guest did not reach its end")
    expect("refusals", found["refused"],
           ["vcan0: this kernel has no CAN support", "vcan0: there is no such interface", "lo: it is no CAN interface"])
    expect("candump", frames(found["candump"]),
           ["123#1122334455667788", "124#1122334455667788", "00012345#01", "00012346#01", "200#R", "201#R", "000#", "001#"])

    flood = [line for line in found["check"] if line.startswith(("frame 7A0#", "lost"))][1:]
    taken = flood.count("frame 7A0#")
    lost = sum(int(line.split()[1]) for line in flood if line.startswith("lost"))
    if taken + lost != FLOOD or lost == 0:
        problems.append(f"of {FLOOD} frames {taken} were taken and {lost} counted as lost")

    down, up = "down vcan0: the interface is down", "up vcan0: the interface is up"
    gone = "down vcan0: there is no such interface"
    seen = [line for line in found["check"] if line not in flood]
    # Whether an interface is seen to be down just before it is removed and just after it was added depends on the moment.
    expect("events", [line for i, line in enumerate(seen) if line != down or gone not in seen[max(i - 1, 0):i + 2]],
           [down, up, "frame 123#1122334455667788", "frame 00012345#01", "frame 200#R", "frame 000#",
            down, up, "frame 130#01", "frame 7A2#", down, up, gone, up, "frame 132#02",
            "up vcan0: the controller is error-passive: nobody acknowledges, or the bus is disturbed",
            "up vcan0: the controller is error-active again", "lost 1",
            "down vcan0: the controller is bus-off", up, "frame 7A1#", "frame 7F0#", "frame 7FF#"])

    burst = [frame for frame in frames(found["burst"]) if frame.startswith("500#")]
    expect("burst", burst, [f"500#{number:02X}" for number in range(BURST)])
    expect("exits", [line for line in found["progress"] if "ended" in line], ["ended with 0", "serial ended with 0", "verify ended with 0", "gateway ended with 0"])

    expect("candump behind the serial adapter", frames(found["adapter"]),
           ["123#1122334455667788", "124#1122334455667788", "00012345#01", "00012346#01", "200#R", "201#R"])
    up, down = "up /dev/pts/0: the adapter is open at 250 kbit/s", "down /dev/pts/0: the adapter is gone"
    # Whether the port is seen to be missing depends on the moment.
    expect("events of the serial adapter",
           [line for line in found["serial"] if not line.endswith("there is no such serial port")],
           [up, "frame 123#1122334455667788", "frame 00012345#01", "frame 200#R", down, up, "frame 7FF#"])
    # The queue must have refused frames, or the burst proves nothing.
    dropped = re.search(r"dropped (\d+)", " ".join(found["progress"]))
    if dropped is None or int(dropped.group(1)) == 0:
        problems.append(f"the queue has refused nothing: {found['progress']}")
    return problems + gateway_problems(found, expect)


def gateway_problems(found, expect):
    """`expect` collects what it finds; what else is wrong is returned."""
    problems = []
    node = frames(found["node"])
    expect("first frame of the gateway", node[:1], ["70C#00"])
    expect("SDO traffic", [frame for frame in node if frame[:4] in ("60C#", "58C#")],
           ["60C#4018100100000000", "58C#4318100161010000", "60C#2B171000F4010000", "58C#8017100002000106"])
    start = node.index("000#010C") if "000#010C" in node else 0
    for what, listed in (("before its start", node[:start]), ("after its return, before its start",
                         frames(found["node_again"])[:1])):
        if any(frame.startswith(("18C#", "28C#", "38C#", "48C#")) for frame in listed):
            problems.append(f"the gateway sends PDOs {what}: {listed}")
    for name, length in (("18C", 16), ("28C", 8), ("38C", 4), ("48C", 16)):
        if not any(re.fullmatch(f"{name}#[0-9A-F]{{{length}}}", frame) for frame in node[start:]):
            problems.append(f"no TPDO {name} in {node}")
    lines = [line[14:] for line in found["gateway"] if re.match(r"\d\d:\d\d:\d\d\.\d{3}  ", line)]
    own = [line for line in lines if line.startswith(("CAN2", "state", "error 3072", "cleared 3072", "ends"))]
    expect("lines of the gateway", own,
           ["CAN2 up: vcan0: the interface is up", "state Init", "state Pre-Operational", "state Operational",
            "CAN2 down: vcan0: the interface is down",
            "error 3072 ErrCanBus2: CANopen bus faulty: look at cabling,", "state Pre-Operational",
            "CAN2 up: vcan0: the interface is up", "state Operational", "cleared 3072 ErrCanBus2", "ends: SIGTERM"])
    if "The device has the configuration of the file, as far as CANopen shows it." not in found["verify"]:
        problems.append(f"cgw verify says {found['verify']}")
    expect("error memory", [line for line in found["state"] if line.startswith("3172 ")], ["3172 1"])
    return problems


def main():
    check, gateway, cgw, plant, kernel = (pathlib.Path(argument) for argument in sys.argv[1:6])
    missing = [name for name in PROGRAMS if shutil.which(name, path=SEARCH) is None]
    if missing:
        skip(f"not installed: {', '.join(missing)}")
    if libraries(shutil.which("busybox", path=SEARCH)):
        skip("busybox is not busybox-static")
    absent = [name for name in ["vmlinuz"] + [f"{module}.ko" for module in MODULES] if not (kernel / name).is_file()]
    if absent:
        skip(f"there is no kernel in {kernel} ({', '.join(absent)})")
    with tempfile.TemporaryDirectory(prefix="cgw-vcan-") as directory:
        output = boot(kernel, make_initramfs(pathlib.Path(directory), check, gateway, cgw, plant, kernel)).decode(errors="replace")
    found = sections(output.replace("\r", ""))
    if "progress" not in found or "check" not in found or not found["progress"]:
        print(f"the guest has said nothing of use:\n{output}")
        return 1
    problems = problems_of(found)
    if problems:
        print("\n".join(problems))
        print(output)
        return 1
    print("\n".join(found["progress"]))
    return 0


sys.exit(main())
