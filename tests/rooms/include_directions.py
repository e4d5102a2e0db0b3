"""Dependencies run one way: every include must be covered by the ROOMS of the including room's CMakeLists.txt
(directly or through them), freestanding rooms use freestanding rooms only, rooms stand in lib/CMakeLists.txt
in the order in which they may include each other, heavy libraries are included by exactly one file, and
ARCHITECTURE.md shows the same table."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
problems = []

order = re.findall(r"add_subdirectory\((\w+)\)", (root / "lib/CMakeLists.txt").read_text())
rooms, freestanding = {}, set()
for name in order:
    text = re.sub(r"#.*", "", (root / "lib" / name / "CMakeLists.txt").read_text())
    call = re.search(r"cgw_room\(\s*" + name + r"\b(.*?)\)", text, re.S)
    if not call:
        problems.append(f"lib/{name}/CMakeLists.txt does not call cgw_room({name} …)")
        continue
    words = call.group(1).split()
    if "FREESTANDING" in words:
        freestanding.add(name)
    allowed, inside = [], False
    for word in words:
        if word in ("SOURCES", "LIBRARIES", "FREESTANDING", "ROOMS"):
            inside = word == "ROOMS"
        elif inside:
            allowed.append(word)
    rooms[name] = allowed

for path in (root / "lib").iterdir():
    if path.is_dir() and path.name not in rooms:
        problems.append(f"lib/{path.name} is not listed in lib/CMakeLists.txt")

for name, allowed in rooms.items():
    for other in allowed:
        if other not in rooms:
            problems.append(f"{name} uses {other}, which is no room")
        elif order.index(other) >= order.index(name):
            problems.append(f"{name} uses {other}, which stands after it in lib/CMakeLists.txt")
        if name in freestanding and other not in freestanding:
            problems.append(f"{name} is freestanding and uses the host room {other}")


def reachable(name):
    seen, todo = {name}, [name]
    while todo:
        for other in rooms.get(todo.pop(), []):
            if other not in seen:
                seen.add(other)
                todo.append(other)
    return seen


sources = [p for d in ("lib", "cli") for p in (root / d).rglob("*") if p.suffix in (".hpp", ".cpp", ".h", ".c")]
includes = 0
for path in sources:
    parts = path.relative_to(root).parts
    text = path.read_text()
    for line, target in [(n + 1, m) for n, l in enumerate(text.split("\n"))
                         for m in re.findall(r'^\s*#\s*include\s+"([^"]+)"', l)]:
        includes += 1
        first = target.split("/")[0]
        if parts[0] == "lib" and first not in reachable(parts[1]):
            problems.append(f"{'/'.join(parts)}:{line} includes {target}; room {parts[1]} may not")
        if parts[0] == "cli" and first != "cli" and first not in rooms:
            problems.append(f"{'/'.join(parts)}:{line} includes {target}, which is no room")
    if parts[0] == "lib" and parts[1] in freestanding:
        for header in re.findall(r"^\s*#\s*include\s+<([^>]+)>", text, re.M):
            if header in ("string", "vector", "map", "memory", "iostream", "functional", "fmt/format.h"):
                problems.append(f"{'/'.join(parts)} is freestanding and includes <{header}>")

for header, only in (("toml.hpp", "lib/toml/"), ("CLI/CLI.hpp", "cli/cgw/"), ("pugixml.hpp", "lib/xdd/")):
    users = ["/".join(p.relative_to(root).parts) for p in sources if f"#include <{header}>" in p.read_text()]
    if len(users) > 1 or any(not user.startswith(only) for user in users):
        problems.append(f"<{header}> is included by {users}; one file of {only} may")

page = (root / "ARCHITECTURE.md").read_text()
for name, allowed in rooms.items():
    row = re.search(r"^\|\s*`" + name + r"/?`[ \t]*\|.*\|[ \t]*([^|]*?)[ \t]*\|[ \t]*$", page, re.M)
    if not row:
        problems.append(f"ARCHITECTURE.md has no row for {name}")
    elif sorted(re.findall(r"`(\w+)`", row.group(1))) != sorted(allowed):
        problems.append(f"ARCHITECTURE.md lists {row.group(1)!r} for {name}, its CMakeLists.txt {sorted(allowed)}")

if includes < 100:
    problems.append(f"only {includes} includes found: this test looks in the wrong place")
print("\n".join(problems) or f"{len(rooms)} rooms, {includes} includes, all in the allowed directions")
sys.exit(1 if problems else 0)
