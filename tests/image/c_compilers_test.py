"""The plain-C reader compiles without a warning as C99 and as C++, with every compiler that is installed, and calls
nothing but what the compiler itself needs.   c_compilers_test.py SOURCES"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

LIB = pathlib.Path(sys.argv[1]) / "lib"
READER = pathlib.Path(__file__).parent / "c_reader.c"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Werror"]
C, CPP = ["-std=c99", "-x", "c"], ["-std=c++11", "-x", "c++"]
CORTEX_M0 = ["-mcpu=cortex-m0", "-mthumb", "-ffreestanding"]
WAYS = [("gcc", C), ("gcc", ["-std=c17", "-x", "c"]), ("g++", CPP), ("clang", C), ("clang++", ["-std=c++20", "-x", "c++"]),
        ("arm-none-eabi-gcc", C + CORTEX_M0), ("arm-none-eabi-g++", CPP + CORTEX_M0 + ["-fno-exceptions"])]
OWN_OF_THE_COMPILER = ("mem", "__aeabi_", "__gnu_", "c_reader_")
problems, done = [], 0

with tempfile.TemporaryDirectory(prefix="cgw-c-reader-") as scratch:
    target = str(pathlib.Path(scratch) / "reader.o")
    for compiler, options in WAYS:
        if shutil.which(compiler) is None:
            continue
        done += 1
        for level in ("-O0", "-Os"):
            made = subprocess.run([compiler, *options, level, *WARNINGS, f"-I{LIB}", "-c", str(READER), "-o", target],
                                  capture_output=True, text=True)
            if made.returncode != 0:
                problems.append(f"{compiler} {' '.join(options)} {level}:\n{made.stderr}")
        if compiler.startswith("arm") and made.returncode == 0:
            listed = subprocess.run(["arm-none-eabi-nm", "-u", target], capture_output=True, text=True, check=True).stdout
            problems += [f"{compiler}: {name} is needed" for name in listed.split()
                         if name != "U" and not name.startswith(OWN_OF_THE_COMPILER)]
    header = pathlib.Path(scratch) / "reader.cpp"
    header.write_text('#include "image/c/cgw_image.h"\n')
    made = subprocess.run(["g++", "-std=c++20", "-Wold-style-cast", *WARNINGS, f"-I{LIB}", "-fsyntax-only", str(header)],
                          capture_output=True, text=True)
    problems += [f"-Wold-style-cast:\n{made.stderr}"] if made.returncode != 0 else []
if done < 2:
    problems.append("neither gcc nor g++ found")
print("\n".join(problems) or f"{done} compilers")
sys.exit(1 if problems else 0)
