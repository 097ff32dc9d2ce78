#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the rooms (folders) of the library: includes go one way only, and no file is longer than 400 lines.

    rooms.py arrows    each room includes only rooms before it in the order ROOMS, which CONTRIBUTING.md lists too
    rooms.py lengths   no source of the repository has more than 400 lines
    rooms.py physics   the headers of physics.hpp include only each other, headers of core, formulas, tool, contact and
                       force, and Eigen
    rooms.py laws      physics.hpp and hapticut.hpp include every header of force/laws
    rooms.py kernels   the reading order in kernels.hpp names exactly the files of src/kernels
    rooms.py abi       each header outside hapticut::physics with a source in src includes core/abi.hpp
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ["core", "formulas", "tool", "closed_forms", "workpiece", "contact", "force", "safety", "kernels", "simulation",
         "realtime", "device", "loop", "build", "surface", "heat", "islands", "sound", "analysis", "io", "import",
         "settings", "c", "drivers", "experiments", "reports", "page", "cli"]
LONGEST = 400


def sources(*folders):
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".hpp", ".inl", ".cpp", ".h", ".c", ".cs", ".py") and path.is_file() \
                    and "node_modules" not in path.parts:
                yield path


def room_of(path):
    parts = path.relative_to(ROOT).parts
    if parts[0] == "drivers":
        return "drivers"
    if parts[0] == "apps":
        return parts[1]
    parts = parts[2:] if parts[0] == "include" else parts[1:]
    return parts[0] if len(parts) > 1 else None


def room_of_target(name):
    if name == "view":
        return "page"  # hapticut/view, public headers
    return "drivers" if (ROOT / "drivers" / name).is_dir() else name


def arrows():
    mistakes, seen = [], set()
    for path in sources("include", "src", "drivers", "apps"):
        room = room_of(path)
        if "tests" in path.relative_to(ROOT).parts:
            continue  # tests of a driver, next to it
        if room is None:
            continue  # an index header: hapticut.hpp, analysis.hpp
        if room not in ROOMS:
            mistakes.append(f"{path.relative_to(ROOT)}: the room {room} has no place in the order of rooms")
            continue
        for target in re.findall(r'^#include "(?:hapticut/)?(?!hapticut)(\w+)/', path.read_text(encoding="utf-8"), re.M):
            target = room_of_target(target)
            if target not in ROOMS:
                mistakes.append(f"{path.relative_to(ROOT)} includes {target}/, which is not a room")
            elif ROOMS.index(target) > ROOMS.index(room):
                mistakes.append(f"{path.relative_to(ROOT)} includes {target}/, which comes after {room}/")
            seen.add((room, target))
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    if re.findall(r"^\| `(\w+)` \|", page, re.M) != ROOMS:
        mistakes.append(f"CONTRIBUTING.md does not list the rooms in this order: {', '.join(ROOMS)}")
    if len(seen) < 30:
        mistakes.append(f"only {len(seen)} arrows were found; has the form of the includes changed?")
    return mistakes


def lengths():
    mistakes, count = [], 0
    for path in sources("include", "src", "drivers", "apps", "bindings", "tests", "examples", "benchmarks"):
        lines = len(path.read_text(encoding="utf-8").splitlines())
        count += 1
        if lines > LONGEST:
            mistakes.append(f"{path.relative_to(ROOT)} has {lines} lines; the limit is {LONGEST}: split the file")
    if count < 300:
        mistakes.append(f"only {count} files were found")
    return mistakes


def headers_in(path):
    return re.findall(r'^#include "(hapticut/[^"]+)"', path.read_text("utf-8"), re.M)


def physics():
    include = ROOT / "include"
    named = headers_in(include / "hapticut/physics.hpp")
    mistakes, seen, waiting = [], set(), [(name, "physics.hpp") for name in named]
    while waiting:
        name, by = waiting.pop()
        if name in seen:
            continue
        seen.add(name)
        if name not in named and name.split("/")[1] not in ("core", "formulas", "tool", "contact", "force"):
            mistakes.append(f"{by} includes {name}, which is no part of hapticut::physics")
            continue
        text = (include / name).read_text("utf-8")
        waiting += [(other, name) for other in headers_in(include / name)]
        for other in re.findall(r"^#include <(\w+/)", text, re.M):
            if other != "Eigen/":
                mistakes.append(f"{name} includes <{other}...>; hapticut::physics needs Eigen alone")
    if len(seen) < 35:
        mistakes.append(f"only {len(seen)} headers were found")
    return mistakes


def laws():
    include = ROOT / "include"
    every = [str(path.relative_to(include)) for path in sorted((include / "hapticut/force/laws").glob("*.hpp"))]
    mistakes = [f"{index} does not name {name}" for index in ("physics.hpp", "hapticut.hpp")
                for name in every if name not in headers_in(include / "hapticut" / index)]
    if len(every) < 7:
        mistakes.append(f"only {len(every)} laws were found")
    return mistakes


def kernels():
    folder = ROOT / "src/kernels"
    named = re.findall(r"^///     ([\w-]+\.[ch]pp) ", (folder / "kernels.hpp").read_text("utf-8"), re.M)
    files = [path.name for path in sorted(folder.glob("*.?pp"))]
    return ([f"the reading order in kernels.hpp does not name {name}" for name in files if name not in named] +
            [f"the reading order in kernels.hpp names {name}, which does not exist" for name in named
             if name not in files])


def abi():
    include, asks = ROOT / "include", "hapticut/core/abi.hpp"

    def all_of(name, seen):
        if name not in seen and (include / name).exists():
            seen.add(name)
            for other in headers_in(include / name):
                all_of(other, seen)
        return seen

    links_nothing = all_of("hapticut/physics.hpp", set()) | all_of("hapticut/closed_forms.hpp", set())
    compiled = [str(path.relative_to(include)) for path in sorted(include.rglob("*.hpp"))
                if (ROOT / "src" / path.relative_to(include / "hapticut")).with_suffix(".cpp").exists()]
    mistakes = [f"{name} is outside hapticut::physics and does not include {asks}"
                for name in compiled if name not in links_nothing and asks not in all_of(name, set())]
    if asks in links_nothing:
        mistakes.append(f"hapticut::physics includes {asks}, which needs the library")
    if len(compiled) < 50:
        mistakes.append(f"only {len(compiled)} headers with a source were found")
    return mistakes


def main():
    checks = (arrows, lengths, physics, laws, kernels, abi)
    mistakes = {check.__name__: check for check in checks}[sys.argv[1]]()
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
