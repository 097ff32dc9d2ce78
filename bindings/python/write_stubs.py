#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the types of the compiled module from what it says about itself: write_stubs.py MODULE FOLDER

MODULE is the file of the module as it was built. Its stub _hapticut.pyi goes to FOLDER, and with it py.typed, which tells
type checkers that there is one. Needs pybind11-stubgen. Without it, or where the module cannot be imported (because it
waits for a sanitizer, say), nothing is written, a sentence says why, and the build goes on: types are no part of what
runs.
"""
import ast
import importlib
import sys
import tempfile
import types
from pathlib import Path
from typing import Optional


def import_alone(module: Path) -> None:
    """Imports the compiled module without the package around it, which tells of each name where the user finds it."""
    package = types.ModuleType("hapticut")
    package.__path__ = [str(module.parent)]
    sys.modules["hapticut"] = package
    importlib.import_module("hapticut._hapticut")


def stub() -> str:
    """The text of _hapticut.pyi, of the module that was imported."""
    from pybind11_stubgen import main

    with tempfile.TemporaryDirectory() as folder:
        main(["--output-dir", folder, "--exit-code", "--ignore-invalid-expressions", r"(?s)^(\w+\().*",
              "--enum-class-locations", r"^Kind$:hapticut._hapticut.VdbImport",
              "--enum-class-locations", ".*:hapticut._hapticut", "hapticut._hapticut"])
        text = (Path(folder) / "hapticut" / "_hapticut.pyi").read_text(encoding="utf-8")
    ast.parse(text)
    return "# SPDX-License-Identifier: Apache-2.0\n# Written by pybind11-stubgen.\n" + text


def why_none(module: Path, folder: Path) -> Optional[str]:
    """Writes both files. @return why they could not be written, or None"""
    for name in ("_hapticut.pyi", "py.typed"):
        (folder / name).unlink(missing_ok=True)
    try:
        import_alone(module)
        text = stub()
    except (Exception, SystemExit) as error:
        return f"{type(error).__name__}: {error}"
    (folder / "_hapticut.pyi").write_text(text, encoding="utf-8")
    (folder / "py.typed").touch()
    return None


if __name__ == "__main__":
    reason = why_none(Path(sys.argv[1]), Path(sys.argv[2]))
    if reason is not None:
        print(f"hapticut for Python is built without types, because they could not be written ({reason}).",
              file=sys.stderr)
