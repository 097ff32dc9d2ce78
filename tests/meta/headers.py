#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every header of include/, src/, drivers/ and apps/ compiles alone, except those that are included
repeatedly: -inl.hpp and .inl.

    headers.py COMPILER BUILD_FOLDER [--jobs 2] [--only PART_OF_A_NAME]

The compiler runs once for each header, without other includes before it. Two measures keep the 200 runs short. Neither
can hide a missing include:

* If a header includes core/spatial.hpp, directly or indirectly, the compiler first reads that file and Eigen, both
  precompiled. The header includes that file anyway, and the headers that it includes earlier have separate runs.
* A static assertion after the header stops each run. Any other error is a mistake of the header. At the assertion the
  header is parsed, but the compiler has not instantiated the templates at the end of the file (half of the time).

The flags are those of the build, with every include folder of its compile_commands.json. Public headers may include
only public headers with quotes.
"""
import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
BASE = "hapticut/core/spatial.hpp"  # the header that includes Eigen
WRITTEN_BY_THE_BUILD = {"hapticut/version.hpp"}
DEFINITIONS = ("-DITK_USE_SYSTEM_EIGEN", "-DLINUX", "-Dlinux=1")  # third-party headers need these to compile
END = "the header was read to its end"


class Headers:
    """The headers of this project, by the names that #include lines use."""

    def __init__(self):
        self.path = {}
        public = [ROOT / "include", *sorted(ROOT.glob("*/*/include"))]
        for folder in [*public, ROOT / "src", ROOT / "drivers", ROOT / "apps"]:
            for path in sorted([*folder.rglob("*.hpp"), *folder.rglob("*.inl")]):
                inside = path.relative_to(folder).parts
                if folder not in public and ("tests" in inside or "include" in inside):
                    continue  # tests of a driver, and its public header
                self.path[str(path.relative_to(folder))] = path
        self.public = {name for name, path in self.path.items() if name.startswith("hapticut/")}
        self.names = [name for name in self.path if not name.endswith(("-inl.hpp", ".inl"))]
        self.closures = {}

    def includes(self, name):
        return INCLUDE.findall(self.path[name].read_text("utf-8"))

    def closure(self, name):
        """The headers of this project that a header includes, directly or indirectly."""
        if name not in self.closures:
            self.closures[name] = set()  # stops the recursion in a cycle of includes
            for other in self.includes(name):
                if other in self.path:
                    self.closures[name] |= {other} | self.closure(other)
        return self.closures[name]

    def mistakes(self):
        """Mistakes of public headers: they include a header that is not installed or does not exist."""
        for name in self.names:
            if name in self.public:
                for other in self.includes(name):
                    if not other.startswith("hapticut/"):
                        yield f'include/{name} includes "{other}", which is not installed'
                    elif other not in self.path and other not in WRITTEN_BY_THE_BUILD:
                        yield f'include/{name} includes "{other}", which does not exist'


def flags_of(build):
    """The C++ standard, the include folders and the DEFINITIONS of all compile commands of the build."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text("utf-8")):
        words = shlex.split(entry["command"])
        for place, word in enumerate(words):
            if word == "-isystem":
                flags[word, words[place + 1]] = None
            elif word.startswith(("-I", "-std=")) or word in DEFINITIONS:
                flags[word,] = None
    return [word for flag in flags for word in flag] + ["-w", "-Wfatal-errors"]


class Compiler:
    def __init__(self, program, build, folder):
        self.command = [program, *flags_of(build)]
        self.folder = folder
        self.base = folder / "base.hpp"

    def read_base(self):
        self.base.write_text(f'#include "{BASE}"\n', "utf-8")
        subprocess.run([*self.command, "-x", "c++-header", str(self.base), "-o", f"{self.base}.gch"], check=True)

    def complaint(self, number, name, base):
        """The errors of the compiler in a header, empty without errors. `base`: the future of read_base, or None for a
        header that does not include BASE."""
        first = []
        if base is not None:
            base.result()
            first = ["-include", str(self.base)]
        source = self.folder / f"{number}.cpp"
        source.write_text(f'#include "{name}"\nstatic_assert(false, "{END}");\n', "utf-8")
        done = subprocess.run([*self.command, *first, "-fsyntax-only", str(source)], capture_output=True, text=True)
        if done.returncode != 0 and END in done.stderr:
            return ""
        return f"{name} does not compile alone:\n{done.stderr}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("compiler")
    parser.add_argument("build", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="check only headers whose names contain this")
    arguments = parser.parse_args()
    start = time.monotonic()

    headers = Headers()
    wrong = list(headers.mistakes())
    if len(headers.names) < 200:
        wrong.append(f"only {len(headers.names)} headers were found")
    names = [name for name in headers.names if arguments.only in name]
    with tempfile.TemporaryDirectory(dir=arguments.build) as folder:
        compiler = Compiler(arguments.compiler, arguments.build, Path(folder))
        with ThreadPoolExecutor(arguments.jobs) as pool:
            base = pool.submit(compiler.read_base)
            # Headers that do not need the precompiled base come first.
            names.sort(key=lambda name: BASE in headers.closure(name))
            done = [pool.submit(compiler.complaint, number, name, base if BASE in headers.closure(name) else None)
                    for number, name in enumerate(names)]
            wrong += filter(None, (one.result() for one in done))
    for one in wrong:
        print(one, file=sys.stderr)
    print(f"{len(names)} headers, {time.monotonic() - start:.0f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
