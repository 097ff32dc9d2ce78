#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the stubs of the compiled module from what it says about itself: write_stubs.py [OUTPUT]

Needs an installed hapticut that was built with pybind11 of the version given below, and pybind11-stubgen. The stubs in
hapticut/_hapticut.pyi are written with it, and a test does the same again and compares.
"""
import ast
import sys
import tempfile
from pathlib import Path

PYBIND11 = "3.1"
STUBGEN = "3.0"


def stubs() -> str:
    """The text of _hapticut.pyi."""
    from pybind11_stubgen import main

    with tempfile.TemporaryDirectory() as folder:
        arguments = sys.argv
        sys.argv = ["pybind11-stubgen", "--output-dir", folder, "--exit-code",
                    "--ignore-invalid-expressions", r"(?s)^(\w+\().*",
                    "--enum-class-locations", r"^Kind$:hapticut._hapticut.VdbImport",
                    "--enum-class-locations", ".*:hapticut._hapticut", "hapticut._hapticut"]
        try:
            main()
        finally:
            sys.argv = arguments
        text = (Path(folder) / "hapticut" / "_hapticut.pyi").read_text(encoding="utf-8")
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node) is not None:
            # Docstrings are those of the headers, and change with them; `help` shows them.
            node.body = node.body[1:] or [ast.Expr(ast.Constant(...))]
    return "# SPDX-License-Identifier: Apache-2.0\n# Written by write_stubs.py.\n" + ast.unparse(tree) + "\n"


if __name__ == "__main__":
    del sys.path[0]  # this folder, whose hapticut has no compiled part
    default = Path(__file__).parent / "hapticut" / "_hapticut.pyi"
    Path(sys.argv[1] if len(sys.argv) > 1 else default).write_text(stubs(), encoding="utf-8")
