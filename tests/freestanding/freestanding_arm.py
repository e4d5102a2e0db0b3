"""The freestanding rooms compile for a Cortex-M4 and need neither a heap, nor exceptions, nor streams.

Every source of a room that its CMakeLists.txt calls FREESTANDING, and every header of it alone, is compiled; the
object files' undefined symbols are then searched for what a firmware does not have. Ends with 77 (skipped) when
the ARM compiler is not installed."""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

COMPILER, NM = "arm-none-eabi-g++", "arm-none-eabi-nm"
FLAGS = ["-std=c++20", "-mcpu=cortex-m4", "-mthumb", "-Os", "-ffreestanding", "-fno-exceptions", "-fno-rtti",
         "-Wall", "-Wextra", "-Werror", "-c"]
FORBIDDEN = [
    (r"_Zn[wa]|_Zd[la]Pv|^(malloc|calloc|realloc|free)$|_malloc_r", "the heap"),
    (r"^__cxa_(throw|rethrow|allocate_exception|begin_catch)|^_Unwind_|_ZSt\d+__throw_", "exceptions"),
    (r"^_ZT[IV]N10__cxxabiv1|^__dynamic_cast", "run-time type information"),
    (r"^_ZSt4c(out|err|in|log)|^_ZN[SK]*[oi]|^_ZNSt8ios_base|^_ZNK?St7__cxx1112basic_string"
     r"|^(printf|puts|putchar|fopen|fwrite)$", "streams or strings"),
    (r"^__cxa_guard_", "guarded statics"),
]
EXPECTED_ROOMS = {"wire", "object", "frame", "image", "canopen", "device", "master"}

if not (shutil.which(COMPILER) and shutil.which(NM)):
    print(f"SKIPPED: {COMPILER} is not installed, so nothing was compiled for the ARM; on Debian: "
          "apt install gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib")
    sys.exit(77)

lib = pathlib.Path(sys.argv[1]) / "lib"
rooms = {path.parent.name for path in lib.glob("*/CMakeLists.txt")
         if re.search(r"cgw_room\(\s*\w+\s+FREESTANDING\b", path.read_text())}
problems = [f"lib/{room} is not FREESTANDING" for room in sorted(EXPECTED_ROOMS - rooms)]
sources = sorted(path for room in rooms for path in (lib / room).rglob("*.[ch]pp"))
scratch = tempfile.TemporaryDirectory()


def examine(path):
    """(problems, code size, symbols needed) of one source or header."""
    name = str(path.relative_to(lib.parent))
    target = pathlib.Path(scratch.name) / (name.replace("/", "_") + ".o")
    # Included by a line on standard input, a header is compiled like a source that begins with it.
    unit = f'#include "{path}"\n'
    run = subprocess.run([COMPILER, *FLAGS, f"-I{lib}", "-x", "c++", "-", "-o", str(target)], input=unit,
                         capture_output=True, text=True)
    if run.returncode != 0:
        return [f"{name} does not compile:\n{run.stderr}"], []
    symbols = undefined_symbols(target)
    found = [f"{name} needs {what}: {symbol}" for symbol in symbols for pattern, what in FORBIDDEN
             if re.search(pattern, symbol)]
    return found, symbols


def self_test():
    """A test that looks for symbols must be able to find them."""
    for code, what in (("int* f() { return new int(3); }", "the heap"),
                       ("#include <cstdlib>\nvoid* f() { return std::malloc(3); }", "the heap"),
                       ("#include <stdexcept>\nvoid f(); void g() { std::__throw_logic_error(\"\"); }", "exceptions"),
                       ("int f(); int g() { static int x = f(); return x; }", "guarded statics"),
                       ("#include <iostream>\nvoid f() { std::cout << 3; }", "streams or strings")):
        path = pathlib.Path(scratch.name) / "lib" / "probe.cpp"
        path.parent.mkdir(exist_ok=True)
        path.write_text(code)
        target = path.with_suffix(".o")
        subprocess.run([COMPILER, *FLAGS, str(path), "-o", str(target)], check=True)
        symbols = undefined_symbols(target)
        if not any(re.search(pattern, symbol) for symbol in symbols for pattern, name in FORBIDDEN if name == what):
            problems.append(f"this test does not recognise {what} in {symbols}")



def undefined_symbols(target):
    return subprocess.run([NM, "--undefined-only", "--format=just-symbols", str(target)], check=True,
                          capture_output=True, text=True).stdout.split()


self_test()
needed = set()
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    for found, symbols in pool.map(examine, sources):
        problems += found
        needed.update(symbols)
if not sources:
    problems.append("no sources found: this test looks in the wrong place")

runtime = sorted(symbol for symbol in needed if not symbol.startswith("_ZN3cgw") and not symbol.startswith("_ZNK3cgw"))
print("\n".join(problems) or f"{len(sources)} files of {len(rooms)} rooms compiled for the Cortex-M4; from outside "
      f"they need only {', '.join(runtime)}")
sys.exit(1 if problems else 0)
