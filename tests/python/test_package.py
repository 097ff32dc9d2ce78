# SPDX-License-Identifier: Apache-2.0
"""The installed package: version, stubs, import time, and calls of all functions."""
from __future__ import annotations

import inspect
import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import hapticut
from conftest import REPOSITORY

PACKAGE = Path(hapticut.__file__).parent


def test_the_version_is_that_of_the_project():
    text = (REPOSITORY / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"project\(hapticut VERSION ([0-9.]+)", text)[1]
    assert hapticut.__version__ == hapticut.build_info().version == version
    installed = pytest.importorskip("importlib.metadata")
    try:
        assert installed.version("hapticut") == version
    except installed.PackageNotFoundError:
        assert "build" in PACKAGE.parts, "neither installed nor from a build folder"


def test_types_are_marked_and_there():
    there = [(PACKAGE / name).exists() for name in ("py.typed", "_hapticut.pyi")]
    if "site-packages" not in str(PACKAGE) and not any(there):
        pytest.skip("built with CMake where pybind11-stubgen is not installed")
    assert all(there)
    stub = (PACKAGE / "_hapticut.pyi").read_text(encoding="utf-8")
    # The stub contains the docstrings that an editor shows.
    assert "class Spindle:" in stub and stub.count('"""') > 2000


SIGNATURE = re.compile(r"(?:\d+\. )?\w+\(.*\) ->.*|Overloaded function\.")


def members(owner=hapticut._hapticut, prefix=""):
    """Every class, function and method of the compiled module by its name."""
    for name, thing in vars(owner).items():
        if name.startswith("_") or (isinstance(thing, type) and not thing.__module__.startswith("hapticut")):
            continue
        yield prefix + name, getattr(thing, "__func__", thing)
        if isinstance(thing, type) and not hasattr(thing, "__members__"):
            yield from members(thing, f"{prefix}{name}.")


def test_every_class_function_and_method_has_a_docstring_and_says_no_cpp_type():
    undocumented, leaked = [], []
    for name, thing in members():
        if not (inspect.isclass(thing) or inspect.isroutine(thing)):
            continue
        text = inspect.getdoc(thing) or ""
        if not SIGNATURE.sub("", text).strip():
            undocumented.append(name)
        if "::" in re.sub(r"``[^`]*``|std::|\b\w+::\w+", "", text.split("\n")[0]):
            leaked.append(name)
    assert not leaked
    assert not undocumented


def test_an_overload_has_its_own_text_and_not_that_of_the_first():
    text = hapticut.validate.__doc__
    assert text.count("Checks the parameters") == 1  # of a molar
    assert "Naming the material" in text
    assert "for a speed" in hapticut.common_spindle.__doc__


SHAPE = re.compile(r"\((?:n|m|nx|\d+)(?:, ?(?:n|m|ny|nz|\d+))*,?\)")


def test_every_docstring_of_what_takes_or_gives_arrays_says_their_shape():
    import hapticut._hapticut as core

    missing, found = [], 0
    for name, thing in members():
        text = inspect.getdoc(thing) or ""
        lines = [line for line in text.splitlines() if re.match(r"(\d+\. )?\w+\(.*\) ->", line)]
        signature = (thing.fget.__doc__ or "") if isinstance(thing, property) else "\n".join(lines)
        if "ArrayLike" in signature or "NDArray" in signature:
            found += 1
            if not SHAPE.search("\n".join(line for line in text.splitlines() if line not in lines)):
                missing.append(name)
    assert found > 80 and not missing
    assert "valid until" not in str([thing.__doc__ for thing in vars(core.Simulation).values()])


def test_docstrings_describe_only_parameters_that_the_function_has():
    wrong, found = [], 0
    for name, thing in members():
        text = inspect.getdoc(thing.__init__ if isinstance(thing, type) else thing) or ""
        signature = "\n".join(re.findall(r"^(?:\d+\. )?\w+\(.*\) ->.*$", text, re.M))
        for section in re.findall(r"^Parameters\n-+\n((?:.+\n?)*)", text, re.M) if signature else []:
            described = re.findall(r"^(\w+(?:, \w+)*)(?: :.*)?$", section, re.M)
            for parameter in ", ".join(described).split(", "):
                found += 1
                if not re.search(rf"\b{parameter}\b[:=]", signature):
                    wrong.append(f"{name}: {parameter}")
    assert found > 140 and not wrong


CALL_ALL_WITH_NONE = """
import hapticut._hapticut as core

def look(scope):
    calls = 0
    for name, value in list(vars(scope).items()):
        if isinstance(value, type):
            calls += look(value) if value.__module__.startswith("hapticut") else 0
            continue
        functions = [value.fget, value.fset] if isinstance(value, property) else [getattr(value, "__func__", value)]
        for function in filter(callable, functions):
            for given in ((None,), (None, None)):
                try:
                    function(*given)
                except Exception:
                    calls += 1
    return calls

print(look(core))
"""


def test_nothing_that_is_given_none_ends_the_interpreter():
    done = subprocess.run([sys.executable, "-X", "faulthandler", "-c", CALL_ALL_WITH_NONE], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 2000  # number of refused calls


def test_importing_is_quick_and_leaves_the_large_libraries_alone():
    code = ("import numpy, sys, time; t = time.process_time(); import hapticut; print(time.process_time() - t); "
            "print([m for m in ('matplotlib', 'pandas', 'scipy', 'dask', 'tqdm') if m in sys.modules])")
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    output = done.stdout.splitlines()
    assert float(output[0]) < 0.3  # [s] processor time, without the import of numpy
    assert output[1] == "[]"


def test_the_modules_of_python_are_found_when_they_are_used():
    assert callable(hapticut.sweep) and hapticut.sweep.grid(a=[1, 2])[1] == {"a": 2}
    with pytest.raises(AttributeError, match="nonsense"):
        hapticut.nonsense


def test_where_the_types_cannot_be_written_there_are_none_and_a_sentence_says_why(tmp_path):
    for name in ("_hapticut.pyi", "py.typed"):
        (tmp_path / name).touch()  # files of an earlier build
    (tmp_path / "pybind11_stubgen.py").write_text("raise ImportError('as if it were not installed')", encoding="utf-8")
    script = REPOSITORY / "bindings" / "python" / "write_stubs.py"
    done = subprocess.run([sys.executable, str(script), hapticut._hapticut.__file__, str(tmp_path)], check=True,
                          capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert "built without types" in done.stderr and "as if it were not installed" in done.stderr
    assert [path.name for path in tmp_path.iterdir() if path.is_file()] == ["pybind11_stubgen.py"]


def test_mypy_finds_nothing(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    result = subprocess.run([sys.executable, "-m", "mypy", "-p", "hapticut", "--config-file",
                             str(REPOSITORY / "pyproject.toml")], cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr


# Properties of pybind11's classes that stubs cannot express: the metaclass, and the constructor of `object` in classes
# whose objects only the library makes.
ARTEFACTS = re.compile(r"is inconsistent, metaclass differs$"
                       r'|__init__ is inconsistent, stub does not have \*args parameter "args"$')


def test_stubtest_finds_nothing(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    result = subprocess.run([sys.executable, "-m", "mypy.stubtest", "hapticut._hapticut", "--concise",
                             "--mypy-config-file", str(REPOSITORY / "pyproject.toml")], cwd=tmp_path,
                            capture_output=True, text=True)
    found = [line for line in (result.stdout + result.stderr).splitlines() if not ARTEFACTS.search(line)]
    assert not found, "\n".join(found)


OTHER = Path("/usr/bin/python3")


def test_the_python_of_the_system_gives_the_first_force_too(tmp_path):
    """The system's Python uses its own NumPy, which is older than the one from pip."""
    ask = "import sysconfig, sys; print(sysconfig.get_config_var('SOABI'), sys.executable); import numpy"
    if not OTHER.exists() or OTHER.resolve() == Path(sys.executable).resolve():
        pytest.skip(f"there is no second Python: {OTHER} is missing, or is {sys.executable}")
    other = subprocess.run([OTHER, "-s", "-c", ask], capture_output=True, text=True, cwd=tmp_path)
    if other.returncode != 0:
        pytest.skip(f"{OTHER} has no NumPy; sudo apt-get install python3-numpy")
    if other.stdout.split()[0] != sysconfig.get_config_var("SOABI"):
        pytest.skip(f"{OTHER} cannot load modules for {sys.implementation.cache_tag}; build with it: docs/python.md")
    shutil.copytree(PACKAGE, tmp_path / "hapticut", ignore=shutil.ignore_patterns("__pycache__"))
    example = REPOSITORY / "examples" / "python" / "01_first_force.py"
    environment = {**{name: value for name, value in os.environ.items() if not name.startswith("PYTHON")},
                   "PYTHONPATH": str(tmp_path)}
    outputs = [subprocess.run([python, "-s", str(example)], env=environment, capture_output=True, text=True,
                              check=True, cwd=tmp_path).stdout for python in (str(OTHER), sys.executable)]
    assert outputs[0] == outputs[1] and "voxels removed" in outputs[0]


def test_cmake_installs_the_same_tree(tmp_path):
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    builds = sorted((REPOSITORY / "build").glob(f"python-{tag}-{tag}-*/cmake_install.cmake"))
    if not builds or "site-packages" not in str(PACKAGE):
        pytest.skip("the package was not installed by pip from this folder")
    subprocess.run(["cmake", "--install", str(builds[0].parent), "--component", "python", "--prefix", str(tmp_path)],
                   check=True, capture_output=True)

    def tree(folder):
        return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*")
                if path.is_file() and path.suffix != ".pyc"}

    by_cmake, by_pip = tree(tmp_path / "hapticut"), tree(PACKAGE)
    assert sorted(by_cmake) == sorted(by_pip)
    # pip strips debugger symbols from the module and the programs. All other files are identical.
    assert all(content == by_pip[name] for name, content in by_cmake.items()
               if not name.endswith((".so", "hapticut-decoder", "hapticut-recording-reader")))
