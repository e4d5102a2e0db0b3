"""samples/firmware, built with CMake and with make, on the board that QEMU emulates. A simulated plant's governor is
heard on CAN1; a master asks on CAN2, and what the board answers is what the EDS of the same parameter file says, also of
one that was embedded after the link. With an image that is damaged or unsuitable the board sends nothing and ends with the
refusal code. What the CAN controllers report is told to it like frames.
   board_test.py SOURCES CGW CMAKE"""
import configparser
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

SOURCES, CGW, CMAKE = sys.argv[1:]
SAMPLE = pathlib.Path(SOURCES) / "samples/firmware"
NEEDED = ("arm-none-eabi-g++", "arm-none-eabi-readelf", "qemu-system-arm", "make", "ninja")
# 256 ns per instruction, whatever this machine is busy with: the board's time is that of its own clock.
QEMU = ["qemu-system-arm", "-M", "mps2-an385", "-icount", "shift=8", "-nographic", "-monitor", "none", "-serial", "none",
        "-semihosting-config", "enable=on,target=native", "-kernel"]
RECORD = struct.Struct("<QIBBBB8s")  # board_mps2.cpp: time, identifier, bus, length, extended, kind, data
BUS_GOES_OFF, BUS_COMES_BACK, FRAMES_LOST = 2, 3, 4
GOVERNOR_KINDS = {0x01, *range(0x20, 0x31), 0x38, 0x39, 0x40, 0x41}  # docs/governor-link.md
NO_SUCH_OBJECT, READ_ONLY = 0x06020000, 0x06010002
OBJECTS, OBJECT_VALUES = 6, 7  # docs/image-format.md
VALUE_SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 1, 6: 2, 7: 4}  # by data type
REQUESTS, START, END = 1_000_000, 1_300_000, 2_100_000  # us


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def frame(time, bus, identifier, data, extended=False):
    return RECORD.pack(time, identifier, bus, len(data), extended, 0, bytes(data).ljust(8, b"\0"))


def event(time, bus, kind):
    return RECORD.pack(time, 0, bus, 0, 0, kind, bytes(8))


def governor_of(parameters, scratch):
    """What the simulated governor of this plant says to its gateway, as records."""
    log = scratch / "plant.log"
    run(CGW, "simulate", parameters, "--duration", "2.1", "--log", log)
    heard = []
    for seconds, identifier, data in re.findall(r"^\((\d+\.\d+)\) can1 ([0-9A-F]{8})#([0-9A-F]*)$", log.read_text(), re.M):
        time = round(float(seconds) * 1_000_000)
        if (int(identifier, 16) >> 16) & 0xFF in GOVERNOR_KINDS and time < END:
            heard.append(frame(time, 1, int(identifier, 16), bytes.fromhex(data), extended=True))
    assert len(heard) > 100
    return heard


def with_objects(image, change):
    """The image with other objects: `change` gets [(index, sub, type, rights, value)] and returns the same."""
    count = struct.unpack_from("<H", image, 10)[0]
    entries = [struct.unpack_from("<HHII", image, 64 + 12 * i) for i in range(count)]
    sections = {number: (size_of_one, image[offset:offset + size]) for number, size_of_one, offset, size in entries}
    block = sections[OBJECT_VALUES][1]
    objects = []
    for index, sub, kind, rights, _, offset in struct.iter_unpack("<HBBBBH", sections[OBJECTS][1]):
        objects.append((index, sub, kind, rights, block[offset:offset + VALUE_SIZES[kind]]))
    records, values, places = b"", b"", {}
    objects = change(objects)
    for size in (4, 2, 1):
        for index, sub, _, _, value in objects:
            if len(value) == size:
                places[index, sub] = len(values)
                values += value
    for index, sub, kind, rights, _ in objects:
        records += struct.pack("<HBBBBH", index, sub, kind, rights, 0, places[index, sub])
    sections[OBJECTS], sections[OBJECT_VALUES] = (8, records), (1, values)
    directory, content, start = b"", b"", 64 + 12 * count
    for number, (size_of_one, data) in sections.items():
        directory += struct.pack("<HHII", number, size_of_one, start + len(content), len(data))
        content += data + bytes(-len(data) % 4)
    whole = bytearray(image[:64] + directory + content)
    struct.pack_into("<I", whole, 12, len(whole) + 4)
    return bytes(whole) + struct.pack("<I", zlib.crc32(whole))


def upload(index, sub):
    return bytes([0x40, index & 0xFF, index >> 8, sub, 0, 0, 0, 0])


class Board:
    """One firmware and the files around it: what it hears, what it sent, what it keeps over a reset."""

    def __init__(self, program, directory):
        self.program, self.directory = directory / "firmware.elf", directory
        directory.mkdir()
        shutil.copy(program, self.program)
        section = re.search(r" \.cgw_config +PROGBITS +[0-9a-f]+ ([0-9a-f]+) ([0-9a-f]+)",
                            run("arm-none-eabi-readelf", "-SW", program))
        self.region, self.room = (int(number, 16) for number in section.groups())

    def change_region(self, change):
        content = bytearray(self.program.read_bytes())
        region = content[self.region:self.region + self.room]
        change(region)
        content[self.region:self.region + self.room] = region
        self.program.write_bytes(content)

    def boot(self, heard, end=END):
        """Exit code, and the frames that were sent: [(time, bus, identifier, data)]."""
        records = sorted(heard, key=lambda record: RECORD.unpack(record)[0])
        (self.directory / "received").write_bytes(b"".join(records) + frame(end, 0, 0, b""))
        (self.directory / "sent").write_bytes(b"")
        done = subprocess.run([*QEMU, str(self.program)], cwd=self.directory, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=60)
        fields = RECORD.iter_unpack((self.directory / "sent").read_bytes())
        sent = [(time, bus, identifier, data[:length]) for time, identifier, bus, length, _, _, data in fields]
        return done.returncode, sent, done.stdout + done.stderr

    def kept(self):
        return (self.directory / "kept").read_bytes()


class Firmware(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(tempfile.mkdtemp(prefix="cgw-firmware-"))
        cls.addClassCleanup(shutil.rmtree, cls.scratch)
        cls.genset, cls.minimal = (SAMPLE.parent / name for name in ("genset.toml", "minimal.toml"))
        cache = ["ccache"] if shutil.which("ccache") else []
        build = cls.scratch / "cmake"
        run(CMAKE, "-S", SAMPLE, "-B", build, "-G", "Ninja", "--toolchain", "cortex-m3.cmake", f"-DCGW_EXECUTABLE={CGW}",
            f"-DCONFIG={cls.genset}", "-DCMAKE_COMPILE_WARNING_AS_ERROR=ON", *[f"-DCMAKE_CXX_COMPILER_LAUNCHER={c}" for c in cache])
        run(CMAKE, "--build", build, "-j", "2")
        run("make", "-C", SAMPLE, "-j", "2", f"BUILD={cls.scratch / 'make'}", f"CGW={CGW}", f"CONFIG={cls.genset}",
            "CROSS=" + " ".join([*cache, "arm-none-eabi-"]))
        cls.programs = {name: cls.scratch / name / "firmware.elf" for name in ("cmake", "make")}
        cls.governor = governor_of(cls.genset, cls.scratch)

    def setUp(self):
        self.directory = self.scratch / self.id().rsplit(".", 1)[-1]
        self.directory.mkdir()

    def board(self, build="cmake"):
        return Board(self.programs[build], self.directory / build)

    def eds(self, parameters):
        path = self.directory / "plant.eds"
        run(CGW, "emit", "eds", parameters, "-o", path)
        document = configparser.ConfigParser(interpolation=None)
        document.read_string(path.read_text(encoding="latin-1"))
        return document

    def questions(self, eds):
        """[(request, answer)] with the values of the EDS."""
        asked = []
        for index, subs in ((0x1000, [None]), (0x1018, range(5))):
            for sub in subs:
                section = eds[f"{index:X}" if sub is None else f"{index:X}sub{sub:X}"]
                value = int(section["DefaultValue"].replace("$NODEID+", ""), 0)
                size = {"0x0005": 1, "0x0006": 2, "0x0007": 4}[section["DataType"]]
                request = upload(index, sub or 0)
                command = 0x43 | (4 - size) << 2
                asked.append((request, bytes([command]) + request[1:4] + value.to_bytes(4, "little")))
        self.assertNotIn("1005", eds)
        for request, abort in ((upload(0x1005, 0), NO_SUCH_OBJECT),
                               (bytes.fromhex("2300100001000000"), READ_ONLY)):
            asked.append((request, b"\x80" + request[1:4] + abort.to_bytes(4, "little")))
        return asked

    def speaks_as_the_eds_says(self, board, parameters, node, governor):
        asked = self.questions(self.eds(parameters))
        requests = [frame(REQUESTS + 20_000 * i, 2, 0x600 + node, request) for i, (request, _) in enumerate(asked)]
        code, sent, said = board.boot([*governor, *requests, frame(START, 2, 0, [1, node])])
        self.assertEqual((code, said), (0, ""))
        self.assertEqual([data for _, _, identifier, data in sent if identifier == 0x580 + node],
                         [answer for _, answer in asked])
        can2 = [(time, identifier, data) for time, bus, identifier, data in sent if bus == 2]
        self.assertEqual(can2[0][1:], (0x700 + node, b"\0"))
        for time, identifier, data in can2[1:]:
            if identifier == 0x700 + node:
                self.assertEqual(data, b"\x05" if time >= START else b"\x7f")
            self.assertTrue(identifier in (0x580 + node, 0x700 + node) or time >= START, hex(identifier))
        times = [time for time, _, _, _ in sent]
        self.assertEqual(times, sorted(times))
        return can2

    def test_both_builds_answer_as_the_eds_says_and_start(self):
        for build in self.programs:
            with self.subTest(build):
                can2 = self.speaks_as_the_eds_says(self.board(build), self.genset, 12, self.governor)
                tpdo4 = [time for time, identifier, _ in can2 if identifier == 0x48C and time < END]
                self.assertGreaterEqual(len(tpdo4), 5)
                for earlier, later in zip(tpdo4, tpdo4[1:]):
                    self.assertAlmostEqual(later - earlier, 125_000, delta=5_000)

    def test_a_bus_that_is_off_is_an_error_until_it_is_back_and_the_gateway_started_again(self):
        board = self.board()
        off, back, asked, again = START + 200_000, START + 350_000, START + 500_000, START + 600_000
        code, sent, _ = board.boot([*self.governor, frame(START, 2, 0, [1, 12]), event(off, 2, BUS_GOES_OFF),
                                    event(back, 2, BUS_COMES_BACK), frame(asked, 2, 0x60C, upload(0x2000, 5)),
                                    frame(again, 2, 0, [1, 12])])
        can2 = [(time, identifier, data) for time, bus, identifier, data in sent if bus == 2]
        said = [(time, identifier, data) for time, identifier, data in can2 if time >= off]
        self.assertEqual(code, 0)
        self.assertIn(0x18C, [identifier for time, identifier, _ in can2 if time < off])
        self.assertGreaterEqual(said[0][0], back)
        self.assertEqual(said[0][1:], (0x70C, b"\x7f"))
        self.assertEqual([(identifier, data) for time, identifier, data in said if asked <= time < again and identifier == 0x58C],
                         [(0x58C, bytes.fromhex("4b00200500050000"))])  # 3072 and 3074 are bits 8 and 10 of 2000h:5
        for time, identifier, data in said:
            self.assertTrue(identifier in (0x70C, 0x58C) or time >= again, hex(identifier))
        self.assertIn(0x48C, [identifier for time, identifier, _ in said if time >= again])
        self.assertEqual(board.kept(), bytes([1, 0, 0, 1, 0, 1]).ljust(26, b"\0"))  # 3072, and 3074 with it

    def test_what_the_controllers_report_keeps_it_off_the_bus_and_is_counted(self):
        for name, sentinel, bus, kind in (("off", 1, 1, BUS_GOES_OFF), ("lost1", 2, 1, FRAMES_LOST), ("lost2", 4, 2, FRAMES_LOST)):
            with self.subTest(name):
                board = Board(self.programs["cmake"], self.directory / name)
                code, sent, _ = board.boot([*self.governor, frame(REQUESTS, 2, 0, [1, 12]), event(START, bus, kind)])
                times = [time for time, bus_of_it, _, _ in sent if bus_of_it == 2]
                self.assertEqual(code, 0)
                self.assertLess(START - 300_000, max(time for time in times if time < START))
                self.assertEqual([time for time in times if time > START + 1_000], [])
                kept = bytearray(26)
                kept[0] = kept[sentinel] = kept[5] = 1  # 3074 comes with each of them
                self.assertEqual(board.kept(), bytes(kept))

    def test_it_counts_its_resets_and_keeps_its_errors(self):
        board = self.board()
        for boots in (1, 2):
            code, sent, _ = board.boot([], end=2_600_000)
            self.assertEqual((code, [bus for _, bus, _, _ in sent if bus == 2]), (0, []))
            # The governor is not heard, nor after its start-up delay of 2 s: 3071, and 3074 with it; their sentinels are the second and the fifth.
            self.assertEqual(board.kept(), bytes([boots, 0, boots, 0, 0, boots]).ljust(26, b"\0"))

    def test_a_refused_image_keeps_it_off_the_bus(self):
        def erased(region):
            region[:] = b"\xff" * len(region)

        def zeros(region):
            region[:] = bytes(len(region))

        def not_ours(region):
            region[0] ^= 0x10

        def larger_than_the_region(region):
            region[14] |= 0x80

        def another_major(region):
            region[4] += 1

        def cut_off(region):
            region[12] -= 4

        def damaged(region):
            region[1000] ^= 0x10

        for code, change in ((1, erased), (1, zeros), (3, not_ours), (4, another_major), (6, larger_than_the_region),
                             (7, cut_off), (7, damaged)):
            with self.subTest(change.__name__):
                board = Board(self.programs["cmake"], self.directory / change.__name__)
                board.change_region(change)
                self.assertEqual(board.boot(self.governor), (code, [], ""))
                self.assertFalse((board.directory / "kept").exists())

    def image_of(self, parameters):
        image = self.directory / "image.bin"
        run(CGW, "emit", "image", parameters, "-o", image, "--no-labels")
        return image

    def refuses(self, code, image):
        """The sample with that image, which is valid, ends with this code and sends nothing."""
        run(CGW, "image", "verify", image)
        program = self.directory / "refusing.elf"
        run(CGW, "image", "embed", image, "--into", self.programs["cmake"], "--section", ".cgw_config", "-o", program)
        board = Board(program, self.directory / str(code))
        self.assertEqual(board.boot(self.governor), (code, [], ""))

    def test_an_image_that_does_not_suit_the_gateway_is_refused(self):
        image = self.image_of(self.minimal)
        original = image.read_bytes()
        self.assertEqual(with_objects(original, list), original)
        more = [(0x5000, sub, 7, 0, bytes(4)) for sub in range(255)]
        image.write_bytes(with_objects(original, lambda objects: objects + more))
        self.refuses(31, image)
        image.write_bytes(with_objects(original, lambda objects: [one for one in objects if one[0] != 0x2005]))
        self.refuses(32, image)

    def test_a_bit_timing_that_the_controllers_cannot_have_is_refused(self):
        for code, bus in ((41, 1), (42, 2)):
            plant = self.directory / "manual.toml"
            timing = "".join(f"\n{number} = 1" for number in (4406 + 10 * bus, *range(400 + 10 * bus, 406 + 10 * bus)))
            plant.write_text(re.sub(r"(?m)^429 = .*$", rf"\g<0>{timing}", self.minimal.read_text()))
            self.refuses(code, self.image_of(plant))

    def test_an_image_embedded_after_the_link_runs(self):
        program = self.directory / "embedded.elf"
        said = run(CGW, "image", "embed", self.image_of(self.minimal), "--into", self.programs["cmake"], "--section", ".cgw_config",
                   "-o", program)
        self.assertIn("replaces  an image", said)
        board = Board(program, self.directory / "embedded")
        self.speaks_as_the_eds_says(board, self.minimal, 1, governor_of(self.minimal, self.directory))


missing = [name for name in NEEDED if shutil.which(name) is None]
if missing:
    print(f"skipped: not installed: {', '.join(missing)}; .ci/install-packages test gets what is missing")
    sys.exit(77)
os.environ.pop("MAKEFLAGS", None)
unittest.main(argv=sys.argv[:1])
