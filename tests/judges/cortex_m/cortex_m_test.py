"""The gateway on a Cortex-M3, which QEMU emulates: it replays an exchange that was recorded on this machine and must
answer it byte for byte like this machine. Then the figures: code, image and memory of a firmware with a full
configuration, linked file by file and as a whole.
   cortex_m_test.py SOURCES CGW CORTEX_M_RECORD PARAMETER_FILE"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
COMPILER, SIZE, QEMU = "arm-none-eabi-g++", "arm-none-eabi-size", "qemu-system-arm"
BOARD = "mps2-an385"
CPU = ["-mcpu=cortex-m3", "-mthumb"]
FLAGS = ["-std=c++20", *CPU, "-Os", "-ffreestanding", "-ffunction-sections", "-fdata-sections", "-fno-exceptions", "-fno-rtti",
         "-fno-unwind-tables", "-fno-asynchronous-unwind-tables", "-fno-threadsafe-statics",
         "-fno-tree-loop-distribute-patterns", "-Wall", "-Wextra", "-Werror"]
# Code for a link file by file and for one that sees the whole program (-flto), from one compilation. Neither what the
# compiler calls by itself (start.cpp) nor the image may be seen through: the latter may be replaced after the link.
WHOLE_PROGRAM, OPAQUE = ["-flto", "-ffat-lto-objects"], ("start.cpp", "plant_image.cpp")
# No C library: whatever the compiler needs of its own must not be needed either.
LINK = [*CPU, "-nostdlib", "-Wl,--gc-sections", "-Wl,--fatal-warnings"]
ROOMS = ["wire", "object", "frame", "facts", "image", "canopen", "device", "link"]
TEXT_LIMIT, RAM_LIMIT = 16 * 1024, 4 * 1024
NODE = 12  # of tests/data/full.toml, where TPDO5 to 16 have 680h to 68Bh
SECONDS = 200


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Build:
    def __init__(self, sources, scratch):
        self.lib = sources / "lib"
        self.here = pathlib.Path(__file__).parent
        self.scratch = scratch

    def compile(self, source):
        target = self.scratch / (source.parent.name + "_" + source.name + ".o")
        flags = FLAGS if source.name in OPAQUE else FLAGS + WHOLE_PROGRAM
        run([COMPILER, *flags, f"-I{self.lib}", "-c", str(source), "-o", str(target)])
        return target

    def all(self, image_source):
        rooms = [path for room in ROOMS for path in sorted((self.lib / room).glob("*.cpp"))]
        own = [self.here / name for name in ("start.cpp", "replay.cpp", "firmware.cpp")]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            objects = list(pool.map(self.compile, rooms + own + [image_source]))
        archive = self.scratch / "libgateway.a"
        run(["arm-none-eabi-gcc-ar", "rcs", str(archive), *map(str, objects[:len(rooms)])])
        start, replay, firmware, image = objects[len(rooms):]
        programs = [("replay", replay, "-flto"), ("firmware", firmware, "-flto"), ("apart", firmware, "-fno-lto")]
        return [self.link(name, lto, [start, main, image, archive]) for name, main, lto in programs]

    def link(self, name, lto, parts):
        target = self.scratch / f"{name}.elf"
        run([COMPILER, *LINK, "-Os", lto, "-T", str(self.here / "board.ld"), *map(str, parts), "-o", str(target)])
        return target


def first_difference(seen, wanted):
    at = next((i for i, (a, b) in enumerate(zip(seen, wanted)) if a != b), min(len(seen), len(wanted)))
    return f"at byte {at} of {len(wanted)}: {seen[at - 8:at + 24].hex(' ')}\n  wanted {wanted[at - 8:at + 24].hex(' ')}"


def replay(program, directory):
    """(answers, bytes of stack) of the board."""
    command = [QEMU, "-M", BOARD, "-nographic", "-monitor", "none", "-serial", "none", "-semihosting-config",
               "enable=on,target=native", "-kernel", str(program)]
    try:
        done = subprocess.run(command, cwd=directory, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        sys.exit(f"the board did not come to an end within {SECONDS} s")
    said = done.stdout + done.stderr
    stack = re.search(r"^stack +0*(\d+)$", said, re.MULTILINE)
    if done.returncode != 0 or not stack:
        sys.exit(f"the board ended with {done.returncode}: {said}")
    return (directory / "answers").read_bytes(), int(stack.group(1))


def poverty(answers):
    """What the exchange lacks of what it should hold: all states, every PDO, refusals of every kind."""
    length = {"=": 14, ">": 17, "S": 18, "P": 10, "?": 41}
    at, states, sent, refused, received, aborts = 0, set(), set(), 0, set(), set()
    while at < len(answers):
        tag = chr(answers[at])
        line = answers[at:at + length[tag]]
        at += length[tag]
        if tag == "=":
            states.add(line[10])
        elif tag == "P":
            received.add(line[1])
        elif tag == ">" and line[1] == 2:
            refused += line[2] == 0
            identifier = int.from_bytes(line[3:7], "little")
            sent.add(identifier)
            if identifier == 0x580 + NODE and line[9] == 0x80:
                aborts.add(int.from_bytes(line[13:17], "little"))
    lacking = []
    wanted = {base + NODE for base in (0x180, 0x280, 0x380, 0x480, 0x580, 0x700)} | set(range(0x680, 0x68C))
    for what, seen, expected in (("states", states, set(range(5))), ("sent identifiers", sent, wanted),
                                 ("receive PDOs", received, {1, 2, 3, 4}),
                                 ("abort codes", aborts, {0x05040001, 0x06010002, 0x06020000, 0x06070012, 0x06070013, 0x06090011})):
        if seen != expected:
            lacking.append(f"{what}: {sorted(seen)} instead of {sorted(expected)}")
    if refused < 100:
        lacking.append(f"the port of CAN2 refused only {refused} frames")
    return lacking


def sizes(program):
    listed = run([SIZE, "-A", str(program)])
    return {name: int(size) for name, size in re.findall(r"^(\.\w+) +(\d+) +\d+$", listed, re.MULTILINE)}


def measure(how, program):
    """What the program takes of the two memories, the image included: what is over the limit."""
    size = sizes(program)
    code = sum(size.get(name, 0) for name in (".vectors", ".text", ".rodata", ".init_array"))
    image, data, bss = size[".cgw_config"], size.get(".data", 0), size.get(".bss", 0)
    print(f"{how}: {code} bytes of code, {image} of image, together {code + image}; RAM {data + bss}: data {data}, bss {bss}")
    return code, code + image, data + bss


def over_the_limit(what, bytes_taken, limit):
    return [f"{what}: {bytes_taken} bytes, more than {limit}"] if bytes_taken > limit else []


def main():
    sources, cgw, record, parameters = map(pathlib.Path, sys.argv[1:])
    missing = [name for name in (COMPILER, SIZE, QEMU) if shutil.which(name) is None]
    if missing:
        print(f"skipped: not installed: {', '.join(missing)}; .ci/install-packages test gets what is missing")
        return SKIP
    with tempfile.TemporaryDirectory(prefix="cgw-cortex-m-") as name:
        scratch = pathlib.Path(name)
        image, image_source = scratch / "image.bin", scratch / "plant_image.cpp"
        run([str(cgw), "emit", "image", str(parameters), "-o", str(image), "--no-labels"])
        run([str(cgw), "emit", "image-source", str(parameters), "-o", str(image_source), "--section", ".cgw_config",
             "--no-labels"])
        replayer, firmware, apart = Build(sources, scratch).all(image_source)
        calls = run([str(record), str(image), str(scratch / "exchange"), str(scratch / "wanted")]).strip()
        wanted = (scratch / "wanted").read_bytes()
        seen, stack = replay(replayer, scratch)
        problems = [] if seen == wanted else ["the board answers otherwise than this machine " + first_difference(seen, wanted)]
        problems += poverty(wanted)
        print(f"{calls}, {len(wanted)} bytes of answers; the board used {stack} bytes of stack")
        _, text, ram = measure("linked as a whole", firmware)
        code, _, ram_apart = measure("linked file by file", apart)
        problems += over_the_limit("code and image", text, TEXT_LIMIT) + over_the_limit("code, file by file", code, TEXT_LIMIT)
        problems += over_the_limit("data and bss", max(ram, ram_apart), RAM_LIMIT)
    print("\n".join(problems))
    return 1 if problems else 0


sys.exit(main())
