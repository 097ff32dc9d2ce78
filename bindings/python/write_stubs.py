#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the types of the compiled module: write_stubs.py MODULE FOLDER

MODULE is the file of the built module. Writes its stub _hapticut.pyi and py.typed, which tells type checkers about the
stub, to FOLDER. Needs pybind11-stubgen. Without it, or when the module cannot be imported (e.g. in a sanitizer build),
writes nothing, prints the reason, and the build continues: types are not needed at run time.
"""
import ast
import importlib
import re
import sys
import tempfile
import types
from pathlib import Path
from typing import Optional


def import_alone(module: Path) -> None:
    """Imports the compiled module without the package, which would move its names to other modules."""
    package = types.ModuleType("hapticut")
    package.__path__ = [str(module.parent)]
    sys.modules["hapticut"] = package
    importlib.import_module("hapticut._hapticut")


def mark_final(found: re.Match[str]) -> str:
    """The beginning of a class in the stub, with its mark when it cannot be derived."""
    may_be_derived = 1 << 10  # Py_TPFLAGS_BASETYPE
    kind = getattr(sys.modules["hapticut._hapticut"], found[1])
    return found[0] if kind.__flags__ & may_be_derived else f"@typing.final\n{found[0]}"


def stub() -> str:
    """The text of _hapticut.pyi for the imported module."""
    from pybind11_stubgen import main

    with tempfile.TemporaryDirectory() as folder:
        main(["--output-dir", folder, "--exit-code", "--ignore-invalid-expressions", r"(?s)^(\w+\().*",
              "--enum-class-locations", r"^Kind$:hapticut._hapticut.VdbImport",
              "--enum-class-locations", ".*:hapticut._hapticut", "hapticut._hapticut"])
        text = (Path(folder) / "hapticut" / "_hapticut.pyi").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^class (\w+)", mark_final, text)
    ast.parse(text)
    return "# SPDX-License-Identifier: Apache-2.0\n# Written by pybind11-stubgen.\n" + text


def write(module: Path, folder: Path) -> Optional[str]:
    """Writes both files. Returns the reason of a failure, or None."""
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
    reason = write(Path(sys.argv[1]), Path(sys.argv[2]))
    if reason is not None:
        print(f"hapticut for Python is built without types, because they could not be written ({reason}).",
              file=sys.stderr)
