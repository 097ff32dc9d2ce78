#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the requirements of the Python tests and of a build by CMake, one per line, without hapticut itself. It reads
them from pyproject.toml, and needs Python 3.11."""
import re
import tomllib
from pathlib import Path

project = tomllib.loads((Path(__file__).resolve().parents[2] / "pyproject.toml").read_text("utf-8"))
extras = project["project"]["optional-dependencies"]


def plain(requirements):
    """Expands the extras of hapticut itself."""
    for requirement in requirements:
        own = re.fullmatch(r"hapticut\[(.+)\]", requirement)
        for extra in own.group(1).split(",") if own else ():
            yield from plain(extras[extra])
        if not own:
            yield requirement


needed = [*project["build-system"]["requires"], *project["project"]["dependencies"], *plain(extras["test"])]
print("\n".join(one for one in dict.fromkeys(needed) if not one.startswith("scikit-build-core")))
