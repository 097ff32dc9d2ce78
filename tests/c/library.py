#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the exported symbols and the dependencies of the library of the C interface.

    library.py symbols LIBRARY HEADER   its symbols are exactly the functions of the header
    library.py needs LIBRARY            it needs only libraries that docs/embedding.md names
"""
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs/embedding.md"


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(library, header):
    shown = {line.split()[-1].split("@")[0] for line in output_of("nm", "-D", "--defined-only", library).splitlines()}
    declared = set(re.findall(r"^HAPTICUT_C_API [\w ]+\*? ?\b(hapticut_\w+)\(", Path(header).read_text("utf-8"), re.M))
    if len(declared) < 40:
        sys.exit(f"only {len(declared)} functions were found in {header}")
    if shown != declared:
        sys.exit(f"exported only: {sorted(shown - declared)}; declared only: {sorted(declared - shown)}")
    print(f"{len(shown)} symbols")


def needs(library):
    needed = re.findall(r"\(NEEDED\).*\[(?:lib)?(.+?)(?:-[\d_]+)?\.so", output_of("readelf", "-d", library))
    page = PAGE.read_text("utf-8")
    named = set(re.findall(r"`lib(\w[\w+-]*)`", page[page.index("## What it needs"):].split("\n## ")[0]))
    unknown = {name for name in needed if name not in named and not name.startswith(("asan", "ubsan", "tsan", "ld-linux"))}
    if unknown or not needed:
        sys.exit(f"{library} needs {sorted(unknown)}, which docs/embedding.md does not name")
    print(f"{len(needed)} libraries: {' '.join(needed)}")


if __name__ == "__main__":
    {"symbols": symbols, "needs": needs}[sys.argv[1]](*sys.argv[2:])
