# SPDX-License-Identifier: Apache-2.0
"""Sweeps that cannot be made as asked for: a sentence that says why, and nothing lost."""
from __future__ import annotations

import re
import resource
from pathlib import Path

import numpy as np
import pytest
import runs

import hapticut

pd = pytest.importorskip("pandas", reason="pandas is not installed")
sweep = hapticut.sweep
SERIAL = sweep.SerialExecutor()


@pytest.mark.parametrize("space, message", [
    ([], "no runs"), ({}, "without axes"), ({"x": []}, "axis x"), ({"x": "abc"}, "axis x"),
    ([{"x": 1}, {"y": 1}], "run 1 has the parameters"), ([{"x": [1]}], "parameter x of run 0"), (3, "over int"),
    ([1, 2], "one dict"), ({"run": [1]}, "neither run nor error"), ({1: [1]}, "names must be texts"),
    ({"x": [10**30]}, "fit in 64 bits"), ({"x": ["\ud800"]}, "UTF-8 cannot hold"),
])
def test_spaces_that_make_no_sense_are_refused(space, message, tmp_path):
    with pytest.raises(hapticut.Error, match=message):
        hapticut.sweep(space, runs.sometimes_raises, SERIAL, tmp_path)


class LooksLikeAClient:
    def get_executor(self): ...


@pytest.mark.parametrize("given, message", [
    ({"seed": -1}, "seed = -1"), ({"seed": None}, "seed = None"), ({"seed": 0.5}, "seed = 0.5"),
    ({"workers": 0}, "workers = 0"), ({"workers": "two"}, "workers = 'two'"), ({"units": "N"}, "units are 'N'"),
    ({"run": 3}, "run is 3"), ({"executor": "dask"}, "executor is 'dask'"),
    ({"executor": LooksLikeAClient()}, r"get_executor\(\)"),
])
def test_arguments_that_make_no_sense_are_refused_before_anything_is_written(given, message, tmp_path):
    arguments = {"space": {"x": [1]}, "run": runs.sometimes_raises, "executor": SERIAL, "out": tmp_path / "out", **given}
    with pytest.raises(hapticut.Error, match=message):
        hapticut.sweep(**arguments)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("n, bounds, message", [
    (0, {"x": (0, 1)}, "n = 0"), (2.5, {"x": (0, 1)}, "n = 2.5"), (2, {}, "without bounds"), (2, 5, "bounds are 5"),
    (2, {"x": 5}, "bounds of x are 5"), (2, {"x": ("a", "b")}, "bounds of x"), (2, {"x": (0, 1, "ln")}, "bounds of x"),
])
def test_designs_that_make_no_sense_are_refused(n, bounds, message):
    pytest.importorskip("scipy", reason="scipy is not installed")
    for design in (sweep.latin_hypercube, sweep.sobol):
        with pytest.raises(hapticut.Error, match=message):
            design(n, bounds)
    with pytest.raises(hapticut.Error, match="the sampler is 3"):
        sweep.design(3, 4, {"x": (0, 1)})


def test_a_folder_that_cannot_be_written_is_said_before_the_first_run(tmp_path):
    (tmp_path / "file").write_text("in the way")
    for out in (tmp_path / "file", tmp_path / "file" / "below", Path("/proc/hapticut")):
        with pytest.raises(hapticut.Error, match=f"cannot write.*{re.escape(str(out))}.*Choose another"):
            hapticut.sweep({"x": [1]}, runs.sometimes_raises, SERIAL, out)


def test_a_disk_that_becomes_full_is_an_error_and_what_was_finished_is_kept(tmp_path):
    space = {"x": list(range(20))}
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, hard))  # stands for the disk
    try:
        with pytest.raises(hapticut.Error, match="cannot write.*What was finished is kept"):
            hapticut.sweep(space, runs.returns_more_and_more, SERIAL, tmp_path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    before = {path: path.stat().st_mtime_ns for path in (tmp_path / "chunks").iterdir()}
    assert before and not list(tmp_path.rglob("*.part"))
    table = hapticut.sweep(space, runs.returns_more_and_more, SERIAL, tmp_path)
    assert table["error"].isna().all() and len(table) == 20
    assert all(path.stat().st_mtime_ns == time for path, time in before.items())
    assert len(sweep.load_traces(tmp_path, 19)["values"]) == 9500


def test_an_executor_that_takes_no_more_work_is_an_error(tmp_path):
    class Closed(sweep.SerialExecutor):
        def submit(self, function, /, *args, **kwargs):
            raise LookupError("the client is closed")  # as dask's own, which is no RuntimeError

    with pytest.raises(hapticut.Error, match="the executor died.*LookupError.*kept"):
        hapticut.sweep({"x": [1, 2]}, runs.sometimes_raises, Closed(), tmp_path)


@pytest.mark.parametrize("number, message", list(enumerate([
    "SystemExit: 3", "dtype object", "names must be texts", "UTF-8 cannot hold", "fit in 64 bits", "parameter or column",
])))
def test_what_cannot_be_kept_of_a_run_is_its_error(number, message, tmp_path):
    table = hapticut.sweep({"x": [number, -1]}, runs.returns_what_cannot_be_kept, SERIAL, tmp_path)
    assert message in table["error"][0] and pd.isna(table["error"][1])


def test_traces_may_have_any_name(tmp_path):
    names = ["file", "allow_pickle", "a/b", "force.npy"]
    hapticut.sweep({"x": [3]}, runs.returns_traces_of_odd_names, SERIAL, tmp_path)
    traces = sweep.load_traces(tmp_path, 0)
    assert sorted(traces) == sorted(names) and all(values.tolist() == [3, 4] for values in traces.values())


def test_a_column_of_texts_and_numbers_makes_the_table_csv_with_a_warning(tmp_path):
    pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    with pytest.warns(UserWarning, match="column kind holds texts and numbers"):
        table = hapticut.sweep({"kind": ["a", 1]}, runs.counts, SERIAL, tmp_path)
    assert table["kind"].tolist() == ["a", 1] and table["one"].tolist() == [1, 1]
    assert (tmp_path / "table.csv").exists() and not list(tmp_path.glob("*.parquet*"))


@pytest.mark.parametrize("text, message", [
    ("run = 'a", "not TOML"), ("runn = 'a:b'", "unknown keys"), ("run = 'nowhere.py:f'\n[grid]\nx=[1]", "nowhere.py"),
    ("run = 'math:nothing'\n[grid]\nx=[1]", "no function"), ("run = 'math:sqrt'", "no space"),
    ("run = 'no.such:f'\n[grid]\nx=[1]", "no.such|'no'"), ("run = 'math:sqrt'\n[sobol]\nn=4", "bounds"),
    ("run = 3", "run = 3 in .*; it must be a text"), ("seed = 'a'", "seed = 'a' in .*; it must be a whole number"),
    ("grid = [1]", "grid = .* a table"), ("run = 'math:sqrt'\nruns = [1]", "one dict"),
    ("run = 'math:sqrt'\n[constants]\nx=1\n[grid]\nx=[1]", r"\['x'\] both in"),
    ("run = 'math:sqrt'\nseed = -1\n[grid]\nx=[1]", "seed = -1"),
])
def test_the_command_line_says_what_is_wrong_with_a_study(text, message, tmp_path, capsys):
    study = tmp_path / "study.toml"
    study.write_text(text)
    assert sweep.main([str(study), "--executor", "serial", "--out", str(tmp_path / "out")]) == 1
    assert re.search(message, capsys.readouterr().err)
    assert sweep.main([str(tmp_path / "none.toml")]) == 1


def study_of(text, folder):
    (folder / "functions.py").write_text("""
from __future__ import annotations
from dataclasses import dataclass

@dataclass
class Answer:
    y: float

def times(parameters, rng):
    return vars(Answer(parameters["x"] * parameters["factor"]))
""")
    (folder / "study.toml").write_text(text)
    return str(folder / "study.toml")


def test_a_study_with_other_constants_is_another_study(tmp_path, capsys):
    text = "run = 'functions.py:times'\n[grid]\nx = [1, 2]\n[constants]\nfactor = {}\n"
    arguments = ["--executor", "serial", "--quiet", "--out", str(tmp_path / "out")]
    assert sweep.main([study_of(text.format(2), tmp_path), *arguments]) == 0
    assert sweep.main([study_of(text.format(2), tmp_path), *arguments]) == 0
    assert sweep.main([study_of(text.format(3), tmp_path), *arguments]) == 1
    assert "another study" in capsys.readouterr().err


def test_a_file_of_functions_that_cannot_be_imported_is_named(tmp_path, capsys):
    study = study_of("run = 'functions.py:times'\n[grid]\nx = [1]\n", tmp_path)
    (tmp_path / "functions.py").write_text("import no_such_module\n")
    assert sweep.main([study, "--executor", "serial"]) == 1
    assert re.search(r"functions\.py cannot be imported.*no_such_module", capsys.readouterr().err)
    Path(study).write_bytes(b"\xff\xfe")
    assert sweep.main([study]) == 1 and "not TOML" in capsys.readouterr().err
