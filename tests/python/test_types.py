# SPDX-License-Identifier: Apache-2.0
"""Programs of users pass `mypy --strict` on the installed package: the examples, and the Python code of the pages."""
from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import REPOSITORY

import hapticut

EXAMPLES = REPOSITORY / "examples" / "python"
PAGES = [REPOSITORY / "README.md", *sorted((REPOSITORY / "docs").glob("*.md"))]

# What the text around the code of a page has made before.
BEFORE = """
from typing import Any

import hapticut
import numpy as np
from hapticut.units import mm, ms, rpm
from numpy.typing import NDArray

workpiece: hapticut.Workpiece
tool: hapticut.Tool
simulation: hapticut.Simulation
poses: NDArray[np.float64]
velocities: NDArray[np.float64]
array: NDArray[np.float64]
dt: float
X_WH: NDArray[np.float64]
origin: NDArray[np.float64]
direction: NDArray[np.float64]
"""


def errors_of_mypy(folder: Path, programs: list[Path]) -> str:
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--config-file",
                           str(REPOSITORY / "pyproject.toml"), *map(str, programs)], cwd=folder, capture_output=True,
                          text=True, env={"MYPYPATH": str(EXAMPLES), "PATH": "", "PYTHONPATH": ":".join(sys.path)})
    return "" if done.returncode == 0 else done.stdout + done.stderr


@pytest.fixture(autouse=True)
def types() -> None:
    pytest.importorskip("mypy", reason="mypy is not installed")
    if not (Path(hapticut.__file__).parent / "py.typed").exists():
        pytest.skip("built with CMake where pybind11-stubgen is not installed")


def test_the_examples_have_the_types_that_they_say(tmp_path):
    errors = errors_of_mypy(tmp_path, sorted(EXAMPLES.glob("*.py")))
    assert not errors, errors


def programs_of_the_pages() -> dict[str, str]:
    """The Python code of each page by its name and line."""
    found = {}
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for code in re.finditer(r"^```python\n(.*?)^```", text, re.M | re.S):
            found[f"{page.stem.replace('-', '_')}_{text[:code.start()].count(chr(10)) + 2}"] = code[1]
    return found


def test_the_code_of_the_pages_has_the_types_that_it_says(tmp_path):
    programs = programs_of_the_pages()
    assert len(programs) >= 8
    paths = []
    for name, code in programs.items():
        paths.append(tmp_path / f"{name}.py")
        # The README's program stands alone.
        paths[-1].write_text(("" if name.startswith("README") else BEFORE) + code, encoding="utf-8")
    errors = errors_of_mypy(tmp_path, paths)
    assert not errors, errors


WRONG = """
import hapticut
import numpy as np

hapticut.Tool("a ball")
hapticut.sweep.grid(feed=3)
hapticut.sweep(3, 4)
simulation = hapticut.Simulation(hapticut.build_molar(1e-4), hapticut.Tool(hapticut.SphereHead(1e-3)))
simulation.run([[1, 2, 3]], np.zeros((1, 6)), 1e-3)
simulation.step(np.eye(4), np.zeros(6))
simulation.stop()
hapticut.SimulationConfig(stiffness=1e12)
hapticut.presets.enamel().colour
"""


def test_the_types_refuse_what_the_library_refuses(tmp_path):
    """Types that accept everything would pass the tests above too."""
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    errors = errors_of_mypy(tmp_path, [tmp_path / "wrong.py"])
    lines = WRONG.splitlines()
    refused = {lines[int(line) - 1] for line in re.findall(r"wrong\.py:(\d+): error", errors)}
    assert refused == {line for line in lines if line and not line.startswith(("import", "simulation = "))}
