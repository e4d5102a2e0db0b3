"""cgw_embed_config in a project of its own: a good file is compiled in and verified at start, a bad one fails the
build with file:line:column, and a change of the file or of its catalogue compiles it again."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import time

parser = argparse.ArgumentParser()
for option in ("source", "cgw", "cmake", "compiler", "objdump", "nm", "work"):
    parser.add_argument(f"--{option}", required=True)
options = parser.parse_args()
source, here = pathlib.Path(options.source), pathlib.Path(__file__).parent
checks = 0


def check(condition, message):
    global checks
    checks += 1
    if not condition:
        sys.exit(f"FAILED: {message}")


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def must(*command):
    code, output = run(*command)
    check(code == 0, f"{' '.join(map(str, command))} ended with {code}:\n{output}")
    return output


class Consumer:
    def __init__(self, generator):
        self.work = pathlib.Path(options.work) / generator.replace(" ", "-")
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        for name in ("plant.toml", "engine.toml"):
            shutil.copy(here / name, self.work)
        self.plant, self.catalogue = self.work / "plant.toml", self.work / "engine.toml"
        self.makefiles = generator == "Unix Makefiles"
        self.build_directory = self.work / "build"
        self.program = self.build_directory / "consumer"
        self.generated = self.build_directory / "cgw_embed/consumer_plant_image.cpp"
        self.configure = [options.cmake, "-S", here / "consumer", "-B", self.build_directory, "-G", generator,
                          f"-DCMAKE_CXX_COMPILER={options.compiler}", f"-DCGW_SOURCE={source}",
                          f"-DCONFIG_FILE={self.plant}", "-DCMAKE_BUILD_TYPE=Debug"]

    def build(self):
        return run(options.cmake, "--build", self.build_directory)

    def must_build(self):
        return must(options.cmake, "--build", self.build_directory)

    def edit(self, path, old, new):
        text = path.read_text()
        check(text.count(old) == 1, f"{path.name} does not hold '{old}' once")
        time.sleep(1.1)  # make compares time stamps, some file systems keep whole seconds
        path.write_text(text.replace(old, new))

    def id(self):
        output = must(self.program).split()
        check(output[1:] == ["aligned", "1"], f"the consumer says {output}")
        return output[0]

    def expected_id(self):
        image = self.work / "expected.bin"
        must(options.cgw, "emit", "image", self.plant, "-o", image)
        return re.search(r"configuration id ([0-9a-f]{16}),", must(options.cgw, "image", "verify", image)).group(1)


def good_file(consumer):
    must(*consumer.configure, f"-DCGW_EXECUTABLE={options.cgw}")
    consumer.must_build()
    check(consumer.id() == consumer.expected_id(), "the embedded image is another one")
    sections = must(options.objdump, "-h", consumer.program)
    section = re.search(r"\s\.engine_config\s+([0-9a-f]+)\s.*2\*\*(\d+)", sections)
    check(section, f"no section .engine_config:\n{sections}")
    check(int(section.group(2)) >= 6, f"alignment 2**{section.group(2)}")
    symbols = must(options.nm, "-S", consumer.program)
    symbol = re.search(r"^[0-9a-f]+ ([0-9a-f]+) [Rr] plant_image$", symbols, re.M)
    check(symbol, "no read-only symbol plant_image")
    image_size = (consumer.work / "expected.bin").stat().st_size
    check(int(symbol.group(1), 16) == image_size, "the symbol has another size than the image")
    check(re.search(r" [Rr] plant_image_size$", symbols, re.M), "no symbol plant_image_size")
    bare = re.search(r"^[0-9a-f]+ ([0-9a-f]+) [Rr] bare_image$", symbols, re.M)
    check(bare, "no symbol bare_image: the second image of the program is missing")
    check(int(bare.group(1), 16) < image_size, "NO_LABELS left the labels in")


def nothing_changed(consumer):
    before = consumer.generated.stat().st_mtime_ns
    check("Compiling configuration" not in consumer.must_build(), "compiled again although nothing changed")
    check(consumer.generated.stat().st_mtime_ns == before, "the generated file was touched")


def changed_catalogue(consumer):
    before = consumer.id()
    consumer.edit(consumer.catalogue, "signed = false", "signed = true")
    check("Compiling configuration" in consumer.must_build(), "a changed catalogue did not compile the file again")
    check(consumer.id() == consumer.expected_id() != before, "a changed catalogue did not reach the program")
    nothing_changed(consumer)


def renamed_catalogue(consumer):
    """The dependency file of the last build still names the old one, which nothing makes."""
    renamed = consumer.catalogue.with_name("renamed.toml")
    for old, new in ((consumer.catalogue, renamed), (renamed, consumer.catalogue)):
        old.rename(new)
        consumer.edit(consumer.plant, old.name, new.name)
        check("Compiling configuration" in consumer.must_build(), "a renamed catalogue did not compile the file again")
        if consumer.makefiles:  # CMake's own list keeps the old name until it is made anew, as the page says
            must(options.cmake, "--build", consumer.build_directory, "--target", "depend")
            consumer.must_build()
        nothing_changed(consumer)


def changed_comment(consumer):
    before = consumer.id()
    consumer.edit(consumer.plant, "format = 1\n", "# a comment\nformat = 1\n")
    consumer.must_build()
    check(consumer.id() == before, "a comment changed the configuration id")
    nothing_changed(consumer)


def bad_file(consumer):
    good = consumer.plant.read_text()
    consumer.edit(consumer.plant, "427 = 5", "427 = 500")
    line = consumer.plant.read_text().split("\n").index("427 = 500") + 1
    for attempt in ("first", "second"):
        code, output = consumer.build()
        check(code != 0, f"the {attempt} build of a bad file succeeded")
        place = re.escape(str(consumer.plant)) + rf":{line}:7: error: "
        check(re.search("^" + place, output, re.M), f"no '{consumer.plant}:{line}:7: error: ' in\n{output}")
    time.sleep(1.1)
    consumer.plant.write_text(good)
    consumer.must_build()
    check(consumer.id() == consumer.expected_id(), "the mended file did not reach the program")


def refused_arguments(consumer):
    """Mistakes in the call end the configuration, with the reason."""
    for broken, reason in (("CGW_EXECUTABLE=/nowhere/cgw", "which is no program"),
                           ("CGW_EXECUTABLE=", "neither CGW_EXECUTABLE is set")):
        code, output = run(*consumer.configure, f"-D{broken}")
        check(code != 0 and reason in " ".join(output.split()), f"-D{broken} was not refused with '{reason}':\n{output}")


generators = {"Ninja": "ninja", "Unix Makefiles": "make"}
present = [generator for generator, program in generators.items() if shutil.which(program)]
check(present, "neither ninja nor make is installed")
for generator in present:
    consumer = Consumer(generator)
    for step in (good_file, nothing_changed, changed_catalogue, renamed_catalogue, changed_comment, bad_file, refused_arguments):
        step(consumer)
print(f"{checks} checks with {', '.join(present)}")
