"""What docs/firmware.md prints as code stands in a file that the tests build, and its table of refusals has every code.
   page_test.py SOURCES"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
page = (root / "docs/firmware.md").read_text()
BUILT = [*sorted(path for path in (root / "samples/firmware").iterdir() if path.is_file()),
         root / "tests/install/consumer/CMakeLists.txt",
         root / "tests/image/c_reader.c"]
problems = []


def lines(text):
    """Without indentation and comments in linker scripts, which the page explains itself."""
    return "\n".join(line for line in (re.sub(r"/\*.*?\*/", "", line).strip() for line in text.split("\n")) if line) + "\n"


built = ["\n" + lines(path.read_text()) for path in BUILT]
blocks = [text for language, text in re.findall(r"^```(\w*)\n(.*?)^```$", page, re.S | re.M) if language != "sh"]
for block in blocks:
    if not any("\n" + lines(block) in text for text in built):
        problems.append(f"not in any file that is built:\n{block}")
if len(blocks) < 10:
    problems.append(f"only {len(blocks)} blocks of code: this test looks at the wrong page")

header = (root / "lib/image/image.hpp").read_text()
status = {int(number) for number in re.findall(r"^    \w+ = (\d+),", header.split("enum class Status")[1].split("};")[0], re.M)}
table = {int(number) for row in re.findall(r"^\| (\d+(?:, \d+)*) \|", page, re.M) for number in row.split(", ")}
sample = {31, 32, 41, 42}
if table != (status - {0}) | sample:
    problems.append(f"the table of refusals has {sorted(table)}, the sources {sorted(status)}")

figures = (root / "docs/performance.md").read_text()
for figure in re.findall(r"^\| [^|]+ \| (\d+(?:,\d+)?) \|$", page, re.M):
    if f"| {figure} |" not in figures:
        problems.append(f"{figure} bytes are not in docs/performance.md")

print("\n".join(problems) or f"{len(blocks)} blocks of code, {len(table)} refusals")
sys.exit(1 if problems else 0)
