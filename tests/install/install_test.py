"""The installed package: what is in it, that it may be moved, that a project finds and uses it, and that the Makefile
printed in docs/build-integration.md does what the page says."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import time

parser = argparse.ArgumentParser()
for option in ("source", "build", "cmake", "compiler", "work"):
    parser.add_argument(f"--{option}", required=True)
options = parser.parse_args()
source, here, work = pathlib.Path(options.source), pathlib.Path(__file__).parent, pathlib.Path(options.work)
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def check(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def run(*command, cwd=None):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=cwd)
    return done.returncode, done.stdout + done.stderr


def must(*command, cwd=None):
    code, output = run(*command, cwd=cwd)
    check(code == 0, f"{' '.join(map(str, command))} ended with {code}:\n{output}")
    return output


def installed_and_moved():
    """An installed prefix that was moved afterwards, and holds what the documentation lists."""
    must(options.cmake, "--install", options.build, "--prefix", work / "first")
    prefix = work / "prefix"
    (work / "first").rename(prefix)
    names = {str(path.relative_to(prefix)) for path in prefix.rglob("*") if path.is_file()}
    for name in ("bin/cgw", "bin/canopen-gateway", "share/man/man1/cgw.1", "share/man/man1/cgw-build.1",
                 "share/bash-completion/completions/cgw", "share/zsh/site-functions/_cgw",
                 "share/fish/vendor_completions.d/cgw.fish", "share/man/man1/canopen-gateway.1",
                 "share/bash-completion/completions/canopen-gateway", "share/cgw/rooms/image/image.hpp",
                 "share/cgw/rooms/device/CMakeLists.txt", "share/cgw/schemas/check-report.schema.json",
                 "share/cgw/samples/genset.toml", "share/cgw/samples/firmware/main.cpp", "include/cgw/cgw_image.h",
                 "share/doc/cgw/rulings.md", "share/doc/cgw/README.md"):
        check(name in names, f"{name} is not installed")
    check(any(re.fullmatch(r"lib/.*cmake/cgw/cgwConfig\.cmake|lib/cmake/cgw/cgwConfig\.cmake", n) for n in names),
          "cgwConfig.cmake is not installed")
    rooms = {name.split("/")[3] for name in names if name.startswith("share/cgw/rooms/")}
    freestanding = {path.parent.name for path in (source / "lib").glob("*/CMakeLists.txt")
                    if " FREESTANDING" in path.read_text()}
    check(rooms == freestanding, f"installed rooms are {sorted(rooms)}")
    for path in prefix.rglob("*.cmake"):
        check(str(source) not in path.read_text(), f"{path.name} names the source tree")
    return prefix


def a_project_finds_it(prefix):
    project, build = work / "consumer", work / "consumer-build"
    shutil.copytree(here / "consumer", project)
    shutil.copy(prefix / "share/cgw/samples/minimal.toml", project / "plant.toml")
    must(options.cmake, "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DCMAKE_CXX_COMPILER={options.compiler}", "-DCMAKE_BUILD_TYPE=Release")
    must(options.cmake, "--build", build)
    said = must(build / "consumer")
    expected = re.search(r"^(?:427|CanOpenMyNodeID)\s*=\s*(\d+)", (project / "plant.toml").read_text(), re.M)
    check(said == f"valid, node {expected.group(1)}\n", f"the consumer says {said}")
    code, output = run(options.cmake, "-S", project, "-B", work / "other", f"-DCMAKE_PREFIX_PATH={prefix}",
                       f"-DCMAKE_CXX_COMPILER={options.compiler}", "-DCMAKE_FIND_PACKAGE_PREFER_CONFIG=ON")
    check(code == 0, output)
    listing = project / "CMakeLists.txt"
    listing.write_text(listing.read_text().replace("cgw 0.1", "cgw 0.2"))
    code, output = run(options.cmake, "-S", project, "-B", work / "newer", f"-DCMAKE_PREFIX_PATH={prefix}")
    check(code != 0 and "0.2" in output, "a package of another minor version was taken")


def the_sample_firmware_is_built(prefix):
    """Where it is installed, and as a copy; without a cross compiler CMake gets as far as the link."""
    installed, copy = prefix / "share/cgw/samples/firmware", work / "firmware"
    shutil.copytree(installed, copy)
    plant = prefix / "share/cgw/samples/genset.toml"
    cross = shutil.which("arm-none-eabi-g++") is not None
    chosen = ["--toolchain", "cortex-m3.cmake"] if cross else [f"-DCMAKE_CXX_COMPILER={options.compiler}"]
    for name, project, found in (("installed", installed, []), ("copied", copy, [f"-DCMAKE_PREFIX_PATH={prefix}"])):
        build = work / f"firmware-{name}"
        must(options.cmake, "-S", project, "-B", build, *chosen, *found, f"-DCONFIG={plant}")
    code, output = run("make", cwd=copy)
    check(code != 0 and "LIB= says where they are" in output, f"make does not say what is missing: {output}")
    if cross:
        must(options.cmake, "--build", work / "firmware-copied")
        must("make", f"LIB={prefix}/share/cgw/rooms", f"CGW={prefix}/bin/cgw", f"CONFIG={plant}", cwd=copy)
        check((copy / "build/firmware.elf").exists(), "make built no firmware")


def the_printed_makefile_works(prefix):
    page = (source / "docs/build-integration.md").read_text()
    project = work / "make"
    project.mkdir()
    (project / "Makefile").write_text(re.search(r"```make\n(.*?)```", page, re.S).group(1))
    plant = project / "plant.toml"
    shutil.copy(prefix / "share/cgw/samples/minimal.toml", plant)
    make = ("make", f"CGW={prefix}/bin/cgw", f"CXX={options.compiler}")
    must(*make, cwd=project)
    check((project / "plant-image.o").exists() and (project / "artefacts/CANopenGateway.eds").exists(), "no outputs")
    check("Nothing to be done" in must(*make, cwd=project), "make builds again what is up to date")
    before = (project / "plant-image.cpp").read_bytes()
    time.sleep(1.1)
    plant.write_text(plant.read_text() + "\n# the same plant\n")
    must(*make, cwd=project)
    check((project / "plant-image.cpp").read_bytes() == before, "a comment changed the image")
    check("Nothing to be done" in must(*make, cwd=project), "an unchanged output is built again and again")
    for name in ("more.toml", "renamed.toml"):  # the old name stays in the dependency files until the next run
        time.sleep(1.1)
        for old in project.glob("more.toml"):
            old.unlink()
        (project / name).write_text('device = "governor"\n')
        text = re.sub(r"catalogue = .*\n", "", plant.read_text())
        plant.write_text(text.replace("format = 1\n", f'format = 1\ncatalogue = ["{name}"]\n', 1))
        must(*make, cwd=project)
        check(name in (project / "plant-image.d").read_text(), f"{name} is not in the dependency file")
        check("Nothing to be done" in must(*make, cwd=project), "make builds again after the rename")
    time.sleep(1.1)
    plant.write_text(plant.read_text().replace("format = 1", "format = 9"))
    code, output = run(*make, cwd=project)
    check(code != 0 and "plant.toml:" in output, f"a bad file does not stop make: {output}")
    check((project / "plant-image.cpp").read_bytes() == before, "a bad file changed an output")


def ninja_reads_the_dependency_file(prefix):
    """With and without deps = gcc: a renamed catalogue builds the image again, and once."""
    for deps in ("", "  deps = gcc\n"):
        project = work / f"ninja{len(deps)}"
        project.mkdir()
        (project / "build.ninja").write_text(
            f"rule cgw\n  command = {prefix}/bin/cgw emit image $in -o $out --depfile $out.d\n"
            f"  depfile = $out.d\n{deps}  restat = 1\nbuild plant.bin: cgw plant.toml\n")
        sample = (prefix / "share/cgw/samples/minimal.toml").read_text()
        for name in ("more.toml", "renamed.toml"):
            for old in project.glob("more.toml"):
                old.unlink()
            (project / name).write_text('device = "governor"\n')
            (project / "plant.toml").write_text(
                sample.replace("format = 1\n", f'format = 1\ncatalogue = ["{name}"]\n', 1))
            check("[1/1]" in must("ninja", cwd=project), f"{name} did not build the image")
            check("no work to do" in must("ninja", cwd=project), f"ninja builds again after {name}")
            time.sleep(1.1)
        (project / name).write_text('# changed\ndevice = "governor"\n')
        check("[1/1]" in must("ninja", cwd=project), "a changed catalogue did not build the image")


prefix = installed_and_moved()
a_project_finds_it(prefix)
the_sample_firmware_is_built(prefix)
the_printed_makefile_works(prefix)
ninja_reads_the_dependency_file(prefix)
print("the installed package works")
