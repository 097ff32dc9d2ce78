# SPDX-License-Identifier: Apache-2.0
"""Nothing is left out: all of C++ is bound or named in not_bound.txt, and all that is bound is used by a test."""
from __future__ import annotations

import fnmatch
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import hapticut
import usage
from public_names import public_names

HERE = Path(__file__).parent
SPECIAL = {"operator()": "__call__", "operator[]": "__getitem__", "operator==": "__eq__", "size": "__len__"}


def excluded_patterns() -> list[str]:
    lines = (HERE / "not_bound.txt").read_text(encoding="utf-8").splitlines()
    patterns = []
    for line in filter(None, lines):
        names, _, reason = line.partition("#")
        assert reason.strip(), f"not_bound.txt gives no reason for {names.strip()}"
        patterns += names.split()
    return patterns


def is_excluded(name: str, patterns: list[str]) -> bool:
    """Whether the name, or a type that it is a member of, is in the list."""
    parts = name.split("::")
    owners = ["::".join(parts[: n + 1]) for n in range(len(parts))]
    return any(fnmatch.fnmatchcase(owner, pattern) for owner in owners for pattern in patterns)


def in_python(name: str) -> object | None:
    """What Python calls the same, or None."""
    owner: object = next((module for module in usage.MODULES if name.split("::")[0] in module.__all__), hapticut)
    for number, part in enumerate(parts := name.split("::")):
        if number and part == parts[number - 1]:
            return owner.__init__ if usage.has_constructor(owner) else None
        found = None
        for spelling in (part, part + "_", SPECIAL.get(part, part)):
            found = getattr(owner, spelling, None) if found is None else found
        if found is None:
            return None
        owner = found
    return owner


def overloads_of(bound: object) -> int:
    """How many functions of C++ a function of Python stands for."""
    text = inspect.getdoc(bound) or ""
    return len(re.findall(r"^\d+\. \w+\(", text, re.M)) if "Overloaded function." in text else 1


def test_the_reader_of_the_headers_sees_what_they_declare():
    names = public_names()
    assert names["Simulation::step"].kind == "function" and "Simulation::state_" not in names
    assert names["StepStatus::jump_rejected"].kind == "enumerator" and names["PoseGate::Verdict::held"]
    assert names["SimulationConfig::voxel_budget"].kind == "field" and names["kRejected"].kind == "field"
    assert names["BodyDescription::distance"].kind == "field" and names["ThesisLaw::Constants"].kind == "type"
    assert names["transport"].overloads == 3 and "detail::Meridian" not in names
    assert len(names) > 1500


def test_every_public_name_of_cpp_is_bound_or_excluded_with_a_reason():
    if not hapticut.io.kWithIo:
        pytest.skip("hapticut was built without file formats (HAPTICUT_WITH_IO)")
    patterns = excluded_patterns()
    missing = []
    for name, found in public_names().items():
        if found.kind == "alias" or is_excluded(name, patterns):
            continue
        bound = in_python(name)
        only_moves = found.kind == "function" and found.overloads == 0 and len(set(name.split("::")[-2:])) == 1
        if bound is None and not only_moves:
            missing.append(f"{name} ({found.header})")
        elif bound is not None and found.kind == "function" and inspect.isroutine(bound) and overloads_of(bound) < found.overloads:
            missing.append(f"{name} ({found.header}): {overloads_of(bound)} of {found.overloads} overloads")
    assert not missing, "bind these in bindings/python, or name them in tests/python/not_bound.txt with a reason:\n" + \
        "\n".join(sorted(missing))


def test_the_list_of_what_is_not_bound_names_nothing_that_is_gone():
    names = public_names()
    unused = [pattern for pattern in excluded_patterns()
              if not any(fnmatch.fnmatchcase(name, pattern) for name in names)]
    assert not unused, f"tests/python/not_bound.txt names what C++ does not have: {unused}"
    bound = [pattern for pattern in excluded_patterns() if "*" not in pattern
             and hasattr(hapticut._hapticut, pattern)]
    assert not bound, f"tests/python/not_bound.txt names what is bound by now: {bound}"


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
    assert int(done.stdout) > 2000  # calls that were refused


@pytest.mark.last
def test_everything_that_is_bound_was_called_by_a_test(request):
    if not request.config.all_tests_run:
        pytest.skip("only some of the tests are run")
    if not hapticut.io.kWithIo:
        pytest.skip("hapticut was built without file formats (HAPTICUT_WITH_IO)")
    unused = sorted(usage.bound - usage.used)
    assert len(usage.bound) > 1000
    assert not unused, "no test in tests/python calls these:\n" + "\n".join(unused)


def test_every_enumeration_and_constant_is_named_by_a_test():
    text = "\n".join(path.read_text(encoding="utf-8") for path in HERE.glob("*.py"))

    def names(owner, prefix=""):
        for name, thing in vars(owner).items():
            if name.startswith("_"):
                continue
            if inspect.isclass(thing):
                if hasattr(thing, "__members__"):
                    yield prefix + name
                yield from names(thing, f"{prefix}{name}.")
            elif not callable(thing) and isinstance(thing, (bool, int, float, str)):
                yield prefix + name

    found = [name for name in names(hapticut._hapticut) if not hasattr(hapticut.units, name)]
    assert len(found) > 20
    assert not [name for name in found if not re.search(rf"\b{re.escape(name)}\b", text)]
