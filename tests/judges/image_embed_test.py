"""cgw image embed judged by GNU binutils, on a firmware linked with the sample's linker script; exit codes and
both streams."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CGW, SAMPLES = os.environ["CGW"], pathlib.Path(os.environ["CGW_SAMPLES"])
GENSET, MINIMAL, SCRIPT = SAMPLES / "genset.toml", SAMPLES / "minimal.toml", SAMPLES / "firmware/board.ld"
CROSS = "arm-none-eabi-"
CPU = ["-mcpu=cortex-m3", "-mthumb"]
PLACE, ROOM = 0x0003E000, 8192

FIRMWARE = """
extern const unsigned char cgw_config_begin[], cgw_config_end[];
unsigned seen = 7;
static const unsigned char table[4] = {1, 2, 3, 4};
void unused(void) { seen = table[2]; }
void reset(void) { seen = (unsigned)(cgw_config_end - cgw_config_begin); while (1) { } }
__attribute__((section(".vectors"), used)) void (*const vectors[2])(void) = {0, reset};
"""


class Embed(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-image-embed-"))
        self.addCleanup(shutil.rmtree, self.dir)
        self.good(CGW, "emit", "image", GENSET, "-o", "image.bin")
        self.good(CGW, "emit", "image", MINIMAL, "-o", "small.bin")
        self.image = self.bytes_of("image.bin")
        self.link("fw.elf")

    def run_(self, *command):
        return subprocess.run([str(part) for part in command], cwd=self.dir, capture_output=True, text=True, timeout=120)

    def good(self, *command):
        done = self.run_(*command)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout

    def embed(self, image, into, *where):
        return self.good(CGW, "image", "embed", image, "--into", into, *where)

    def refused(self, reason, *arguments, code=1):
        before = self.everything()
        done = self.run_(CGW, "image", *arguments)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertIn(reason, " ".join(done.stderr.split()))
        self.assertEqual(self.everything(), before)

    def everything(self):
        return {path.name: path.read_bytes() for path in self.dir.iterdir()}

    def bytes_of(self, name):
        return (self.dir / name).read_bytes()

    def link(self, name, *parts):
        (self.dir / "fw.c").write_text(FIRMWARE)
        self.good(CROSS + "gcc", *CPU, "-nostdlib", "-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections",
                  "-Wl,--fatal-warnings", "-T", SCRIPT, "-g", "fw.c", *parts, "-o", name)

    def section(self, name):
        self.good(CROSS + "objcopy", "-O", "binary", "--only-section", ".cgw_config", name, "section.bin")
        return self.bytes_of("section.bin")

    def hex_of(self, elf, form):
        output = f"{elf}.{form}"
        self.good(CROSS + "objcopy", "-O", form, elf, output)
        return output

    def memory_of(self, path, form):
        self.good(CROSS + "objcopy", "-I", form, "-O", "binary", path, "memory.bin")
        return self.bytes_of("memory.bin")

    def test_linker_script_reserves_the_region_and_keeps_an_image(self):
        self.assertEqual(self.section("fw.elf"), b"\xff" * ROOM)
        self.good(CGW, "emit", "image-source", GENSET, "--format", "asm", "--incbin", "image.bin", "-o", "image.s")
        self.link("linked.elf", "image.s")
        self.assertEqual(self.section("linked.elf"), self.image + b"\xff" * (ROOM - len(self.image)))
        for name in ("fw.elf", "linked.elf"):
            self.assertRegex(self.good(CROSS + "readelf", "-SW", name),
                             rf"\.cgw_config +PROGBITS +{PLACE:08x} +[0-9a-f]+ +{ROOM:06x} +00 +A ")
            symbols = self.good(CROSS + "nm", name)
            for symbol, value in (("cgw_config_begin", PLACE), ("cgw_config_end", PLACE + ROOM)):
                self.assertRegex(symbols, rf"{value:08x} \w {symbol}\n")
            self.assertNotIn(" unused\n", symbols)  # --gc-sections has been at work
        self.assertIn(f"linked.elf at 0x{PLACE:08X}: valid", self.good(CGW, "image", "verify", "linked.elf"))
        large = self.dir / "large.s"
        large.write_text('.section .cgw_config, "a"\n.space 8193\n')
        done = self.run_(CROSS + "gcc", *CPU, "-nostdlib", "-T", SCRIPT, "fw.c", "large.s", "-o", "large.elf")
        self.assertNotEqual(done.returncode, 0)

    def test_elf_has_the_image_and_is_otherwise_the_same(self):
        said = self.embed("image.bin", "fw.elf", "--section", ".cgw_config", "-o", "new.elf")
        self.assertRegex(said, rf"^new\.elf at 0x0003E000: valid, format 1\.0, {len(self.image)} bytes, configuration id "
                               rf"[0-9a-f]{{16}}, CRC [0-9a-f]{{8}}\n  section   \.cgw_config, 8192 bytes\n"
                               rf"  filling   {ROOM - len(self.image)} bytes behind the image with 0xFF\n"
                               rf"  replaces  a reserved area\n$")
        self.assertEqual(self.section("new.elf"), self.image + b"\xff" * (ROOM - len(self.image)))
        old, new = self.bytes_of("fw.elf"), self.bytes_of("new.elf")
        self.assertEqual(len(old), len(new))
        changed = [i for i in range(len(old)) if old[i] != new[i]]
        self.assertLess(changed[-1] - changed[0], ROOM)
        for dump in ("-aW", "-wi"):
            said = [self.run_(CROSS + "readelf", dump, name).stdout.replace(name, "") for name in ("fw.elf", "new.elf")]
            self.assertEqual(said[0], said[1])
        self.embed("image.bin", "fw.elf", "--address", hex(PLACE), "-o", "address.elf")
        self.assertEqual(self.bytes_of("address.elf"), new)

    def test_a_program_of_this_machine_has_it_too(self):
        (self.dir / "host.c").write_text('__attribute__((section(".cgw_config"), aligned(8), used))\n'
                                         "const unsigned char reserved[8192] = {0};\n"
                                         "#include <stdio.h>\nint main(void) { return fwrite(reserved, 1, 8192, stdout) != 8192; }\n")
        for pie in ("-no-pie", "-pie"):
            self.good("gcc", pie, "host.c", "-o", "host")
            self.embed("image.bin", "host", "--section", ".cgw_config", "-o", "new-host", "--fill", "0x00")
            done = subprocess.run([self.dir / "new-host"], capture_output=True)
            self.assertEqual(done.stdout, self.image + bytes(8192 - len(self.image)))

    def test_hex_and_s_record_have_what_objcopy_makes_of_the_patched_elf(self):
        self.embed("image.bin", "fw.elf", "--section", ".cgw_config", "-o", "new.elf")
        for form in ("ihex", "srec"):
            self.embed("image.bin", self.hex_of("fw.elf", form), "--address", hex(PLACE), "-o", "ours.txt")
            theirs = self.hex_of("new.elf", form)
            self.assertEqual(self.memory_of("ours.txt", form), self.memory_of(theirs, form))
            ends = [self.bytes_of(name).splitlines(keepends=True)[-2 if form == "ihex" else -1:] for name in ("ours.txt", theirs)]
            self.assertEqual(*ends)  # start address and end
            self.assertIn("ours.txt at 0x0003E000: valid", self.good(CGW, "image", "verify", "ours.txt"))

    def test_hex_without_the_region_gets_it(self):
        for form in ("ihex", "srec"):
            self.good(CROSS + "objcopy", "-O", form, "--remove-section", ".cgw_config", "fw.elf", "bare.txt")
            said = self.embed("image.bin", "bare.txt", "--address", hex(PLACE), "-o", "ours.txt")
            self.assertIn("replaces  nothing, the file had no bytes there", said)
            self.good(CROSS + "objcopy", "-I", "binary", "-O", form, "--change-addresses", hex(PLACE), "image.bin", "image.txt")
            self.assertTrue(self.memory_of("ours.txt", form).endswith(self.image))
            self.assertEqual(self.memory_of("ours.txt", form)[:4], self.memory_of("bare.txt", form)[:4])

    def test_a_later_image_replaces_an_earlier_one_in_place(self):
        for name, where in (("fw.elf", ("--section", ".cgw_config")), (self.hex_of("fw.elf", "ihex"), ("--address", hex(PLACE)))):
            self.embed("image.bin", name, *where, "--in-place")
            said = self.embed("small.bin", name, *where, "--in-place")
            self.assertRegex(said, r"  replaces  an image, configuration id [0-9a-f]{16}\n$")
            said = self.good(CGW, "image", "verify", name, *where)
            self.assertEqual(said, self.good(CGW, "image", "verify", "small.bin").replace("small.bin", f"{name} at 0x0003E000"))
        self.assertEqual(self.section("fw.elf"), self.bytes_of("small.bin").ljust(ROOM, b"\xff"))

    def test_a_private_output_stays_private(self):
        where = ("--section", ".cgw_config", "-o")
        (self.dir / "fw.elf").chmod(0o755)
        for name, old, wanted in (("new", None, 0o755), ("private", 0o600, 0o700), ("team", 0o640, 0o750)):
            if old is not None:
                (self.dir / name).write_text("old")
                (self.dir / name).chmod(old)
            self.embed("image.bin", "fw.elf", *where, name)
            self.assertEqual((self.dir / name).stat().st_mode & 0o777, wanted)
        (self.dir / "fw.elf").chmod(0o600)
        for name, wanted in (("secret", 0o600), ("open", 0o755)):
            if name == "open":
                (self.dir / name).write_text("old")
                (self.dir / name).chmod(0o755)
            self.embed("image.bin", "fw.elf", *where, name)
            self.assertEqual((self.dir / name).stat().st_mode & 0o777, wanted)

    def test_refusals_write_nothing(self):
        (self.dir / "data.c").write_text("unsigned char settings[8192] = {1};\n")
        self.link("data.elf", "data.c", "-Wl,--undefined=settings")
        to = ("-o", "out")
        into = ("embed", "image.bin", "--into")
        (self.dir / "bad.bin").write_bytes(self.image[:100] + b"\0" + self.image[101:-1])
        self.refused("bad.bin: refused:", "embed", "bad.bin", "--into", "fw.elf", "--section", ".cgw_config", *to)
        self.refused("section .bss", *into, "fw.elf", "--section", ".bss", *to)
        self.refused("there is no section .config", *into, "fw.elf", "--section", ".config", *to)
        self.refused("[E0709 image-alignment]", *into, "fw.elf", "--address", hex(PLACE + 4), *to)
        self.refused("[E0710 image-room]", *into, "fw.elf", "--address", hex(PLACE + 4096), *to)
        self.refused("[E0708 firmware-address]", *into, "fw.elf", "--address", "0x09000000", *to)
        self.refused("[E0701 firmware-kind]", *into, "image.bin", "--address", hex(PLACE), *to)
        self.refused("section .data is writable", *into, "data.elf", "--section", ".data", *to)
        self.refused("section .data is writable", *into, "data.elf", "--address", "0x20000000", "--fill", "0x00", *to)
        path = self.dir / self.hex_of("fw.elf", "ihex")
        self.refused("has no sections", *into, path.name, "--section", ".cgw_config", *to)
        self.refused("[E0711 image-occupied]", *into, path.name, "--address", "0x00000000", *to)
        text = path.read_text()
        second = text.splitlines()[1]
        path.write_text(text.replace(second, second[:-1] + ("0" if second[-1] != "0" else "1"), 1), newline="")
        self.refused(f"{path.name}:2:42: error: the checksum is", *into, path.name, "--address", hex(PLACE), *to)
        self.refused("no configuration image is in this ELF file", "verify", "fw.elf")
        self.refused("at 0x0003E000: refused: erased, all bytes are 0xFF or 0x00 (status 1)", "verify", "fw.elf", "--section", ".cgw_config")
        self.refused("No such file", *into, "none.elf", "--section", ".x", *to, code=3)
        self.refused("cannot write", *into, "fw.elf", "--section", ".cgw_config", "-o", "no/such/directory", code=3)

    def test_wrong_usage(self):
        into = ("embed", "image.bin", "--into", "fw.elf")
        for reason, arguments in (("--in-place changes the file itself", (*into, "--address", "8")),
                                  ("one of them says where to write", (*into, "--address", "8", "-o", "x", "--in-place")),
                                  ("this is the file itself", (*into, "--address", "8", "-o", "./fw.elf")),
                                  ("image.bin", (*into, "--address", "8", "-o", "image.bin")),
                                  ("says where the image goes", (*into, "-o", "x")),
                                  ("says where the image goes", (*into, "-o", "x", "--address", "8", "--section", "y")),
                                  ("such as 0x08010000", (*into, "-o", "x", "--address", "-8")),
                                  ("power of two", (*into, "-o", "x", "--address", "8", "--align", "3")),
                                  ("--fill", (*into, "-o", "x", "--address", "8", "--fill", "7")),
                                  ("--output -", (*into, "-o", "-", "--address", "8")),
                                  ("one of them says where", ("verify", "fw.elf", "--address", "8", "--section", "y"))):
            self.refused(reason, *arguments, code=2)

    def test_verify_finds_damage_in_a_firmware(self):
        self.embed("image.bin", "fw.elf", "--section", ".cgw_config", "--in-place")
        damaged = bytearray(self.bytes_of("fw.elf"))
        damaged[damaged.index(self.image) + 500] ^= 1
        (self.dir / "damaged.elf").write_bytes(damaged)
        self.refused("damaged.elf at 0x0003E000: refused: the CRC-32 does not match (status 7)", "verify", "damaged.elf")
        self.refused("the image at 0x0003E000 is damaged", "embed", "small.bin", "--into", "damaged.elf", "--section", ".cgw_config", "-o", "x")


missing = [name for name in ("gcc", CROSS + "gcc", CROSS + "objcopy") if shutil.which(name) is None]
if missing:
    print(f"skipped: not installed: {', '.join(missing)}; .ci/install-packages test gets what is missing")
    sys.exit(77)
unittest.main()
