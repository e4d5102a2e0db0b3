"""The output forms of the image, read by GNU binutils and compiled by GCC, for this machine and for a Cortex-M."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CGW, SAMPLES = os.environ["CGW"], pathlib.Path(os.environ["CGW_SAMPLES"])
GENSET = SAMPLES / "genset.toml"
CROSS = "arm-none-eabi-"
CPU = ["-mcpu=cortex-m3", "-mthumb"]
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
BASE = 0x0800FF00  # the image crosses a bank of 64 KiB


def run(*command, directory):
    done = subprocess.run([str(part) for part in command], cwd=directory, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))} ended with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Forms(unittest.TestCase):
    def setUp(self):
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-image-forms-"))
        self.addCleanup(shutil.rmtree, self.dir)
        self.emit("image", "gateway-config.bin")
        self.image = (self.dir / "gateway-config.bin").read_bytes()

    def emit(self, name, output, *options):
        run(CGW, "emit", name, GENSET, "-o", output, *options, directory=self.dir)

    def run_(self, *command):
        return run(*command, directory=self.dir)

    def bytes_of(self, name):
        return (self.dir / name).read_bytes()

    def test_objcopy_reads_hex_and_s_record(self):
        for form in ("ihex", "srec"):
            for base in (0, BASE, 0xFFFF0000):
                with self.subTest(form=form, base=hex(base)):
                    self.emit("image", "image.txt", "--format", form, "--base", hex(base))
                    self.run_(CROSS + "objcopy", "-I", form, "-O", "binary", "image.txt", "back.bin")
                    self.assertEqual(self.bytes_of("back.bin"), self.image)
                    self.assertIn(f"{base:08x}", self.run_(CROSS + "objdump", "-b", form, "-h", "image.txt"))

    def test_objcopy_writes_the_same_data_records(self):
        for form, kind, start in (("ihex", b":", b":04000005"), ("srec", b"S3", b"S0")):
            self.emit("image", "ours.txt", "--format", form, "--base", hex(BASE))
            self.run_(CROSS + "objcopy", "-I", "binary", "-O", form, "--change-addresses", hex(BASE), "gateway-config.bin",
                      "theirs.txt")
            ours, theirs = ([line for line in self.bytes_of(name).split() if line.startswith(kind) and not line.startswith(start)]
                            for name in ("ours.txt", "theirs.txt"))
            self.assertEqual(ours, theirs, form)

    def check_program(self, *parts):
        """The parts and a main file that knows the header only: the bytes are in the program."""
        (self.dir / "main.c").write_text('#include "plant.h"\n#include <stdio.h>\nint main(void) {\n'
                                         "    return fwrite(plant, 1, plant_size, stdout) == PLANT_SIZE ? 0 : 1;\n}\n")
        self.run_("gcc", "-std=c99", *STRICT, "main.c", *parts, "-o", "program")
        self.assertEqual(subprocess.run([self.dir / "program"], capture_output=True).stdout, self.image)

    def check_object(self, name):
        """Section and alignment as asked for, and nothing but the image in it."""
        sections = self.run_(CROSS + "readelf", "-SW", name)
        line = next(line for line in sections.splitlines() if ".engine-config" in line)
        self.assertEqual((line.split()[-1], line.split("]")[1].split()[1], line.split("]")[1].split()[6]), ("64", "PROGBITS", "A"))
        self.run_(CROSS + "objcopy", "-O", "binary", "--only-section", ".engine-config", name, "back.bin")
        self.assertEqual(self.bytes_of("back.bin"), self.image)

    def test_header_is_c99_and_cpp(self):
        names = ["--symbol", "plant", "--section", ".engine-config", "--align", "64"]
        self.emit("image-source", "plant.h", "--format", "h", *names)
        (self.dir / "image.c").write_text('#define PLANT_DEFINE\n#include "plant.h"\n')
        for language in (["-xc", "-std=c99"], ["-xc++", "-std=c++11"], ["-xc++", "-std=c++20"]):
            self.run_("gcc", *language, *STRICT, "-c", "image.c", "-o", "image.o")
            self.check_program("image.o")
            self.run_(CROSS + "gcc", *CPU, *language, *STRICT, "-c", "image.c", "-o", "cross.o")
            self.check_object("cross.o")

    def test_assembler_file_fits_the_header(self):
        names = ["--symbol", "plant", "--section", ".engine-config", "--align", "64"]
        self.emit("image-source", "plant.h", "--format", "h", *names)
        self.emit("image-source", "plant.s", "--format", "asm", *names)
        self.run_("as", "--noexecstack", "plant.s", "-o", "image.o")
        self.check_program("image.o", "-Wl,--fatal-warnings")
        self.run_(CROSS + "as", "plant.s", "-o", "cross.o")
        self.check_object("cross.o")
        (self.dir / "plant.s").rename(self.dir / "plant.S")
        self.run_("gcc", "-c", "plant.S", "-o", "image.o")
        self.check_program("image.o", "-Wl,--fatal-warnings")
        self.run_(CROSS + "gcc", *CPU, "-c", "plant.S", "-o", "cross.o")
        self.check_object("cross.o")
        self.assertNotIn("GNU-stack", self.run_(CROSS + "readelf", "-SW", "cross.o"))


missing = [name for name in ("gcc", "as", CROSS + "gcc", CROSS + "objcopy") if shutil.which(name) is None]
if missing:
    print(f"skipped: not installed: {', '.join(missing)}; .ci/install-packages test gets what is missing")
    sys.exit(77)
unittest.main()
