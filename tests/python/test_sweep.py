# SPDX-License-Identifier: Apache-2.0
"""Sweeps: the same table from every executor, no lost runs, and clear errors."""
from __future__ import annotations

import contextlib
import functools
import os
import re
import resource
import shutil
import subprocess
import sys
import types
from concurrent.futures import Executor, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import runs

import hapticut

pd = pytest.importorskip("pandas", reason="pandas is not installed")
sweep = hapticut.sweep
HERE = Path(__file__).parent
SPACE = sweep.grid(feed=[2e-3, 4e-3], speed=[2000.0, 8000.0], material=["enamel", "dentin", "cortical_bone"])
UNITS = {"feed": "m/s", "peak_force": "N"}


@pytest.fixture(scope="module")
def serial():
    with ThreadPoolExecutor(1) as executor:
        yield executor


@pytest.fixture(scope="module")
def reference(serial, tmp_path_factory):
    out = tmp_path_factory.mktemp("serial")
    return hapticut.sweep(SPACE, runs.drill, serial, out, units=UNITS), out


def assert_same_bits(table, out, reference):
    expected, expected_out = reference
    pd.testing.assert_frame_equal(table, expected, check_exact=True)
    assert (out / "table.csv").read_bytes() == (expected_out / "table.csv").read_bytes()
    for run in range(len(table)):
        assert np.array_equal(sweep.load_traces(out, run)["force"], sweep.load_traces(expected_out, run)["force"])


@pytest.mark.parametrize("package, call", [
    ("pandas", lambda out: sweep([{"feed": 1.0}], runs.drill, out=out)),
    ("scipy.stats", lambda out: sweep.sobol(4, {"feed": (1.0, 2.0)})),
])
def test_a_missing_package_is_named_with_its_extra(package, call, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(hapticut.Error, match=r"install the extra `sweep`, e\.g\. pip install '\.\[sweep\]' in"):
        call(tmp_path)


def test_the_table_is_tidy(reference):
    table, out = reference
    assert list(table.columns) == ["run", "feed", "speed", "material", "peak_force", "removed_volume", "draw", "error"]
    assert len(table) == 12 and table["error"].isna().all() and (table["removed_volume"] > 0).all()
    assert table["draw"].nunique() == 12 and table.attrs["units"] == UNITS
    by = table.groupby("material")["peak_force"].mean()
    assert by["enamel"] > by["dentin"]
    written = pd.read_csv(out / "table.csv")
    pd.testing.assert_frame_equal(written.drop(columns="error"), table.drop(columns="error"), check_exact=True)
    assert sweep.load_traces(out, 3)["force"].shape == (60, 3)
    with pytest.raises(hapticut.Error, match="run 99"):
        sweep.load_traces(out, 99)


def test_a_pool_of_processes_gives_the_same_bits(reference, tmp_path):
    assert_same_bits(hapticut.sweep(SPACE, runs.drill, out=tmp_path, workers=2, units=UNITS), tmp_path, reference)


def test_an_executor_that_was_given_stays_open(reference, tmp_path):
    with ThreadPoolExecutor(2) as executor:
        assert_same_bits(hapticut.sweep(SPACE, runs.drill, executor, tmp_path, units=UNITS), tmp_path, reference)
        assert executor.submit(int, 3).result() == 3


@contextlib.contextmanager
def found_by_workers():
    """Lets worker processes import the module of the functions."""
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join([str(HERE), *filter(None, [before])])
    try:
        yield
    finally:
        os.environ.pop("PYTHONPATH")
        if before is not None:
            os.environ["PYTHONPATH"] = before


@pytest.mark.filterwarnings("ignore")  # dask warns about itself
def test_a_cluster_of_dask_gives_the_same_bits(reference, tmp_path):
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed")
    with found_by_workers(), distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1") as cluster, \
            distributed.Client(cluster) as client:
        table = hapticut.sweep(SPACE, runs.drill, client.get_executor(), tmp_path, units=UNITS)
        assert_same_bits(table, tmp_path, reference)


MPI_STUDY = """
import sys
import hapticut, runs, test_sweep
from mpi4py.futures import MPIPoolExecutor
if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        hapticut.sweep(test_sweep.SPACE, runs.drill, executor, sys.argv[1], units=test_sweep.UNITS, progress=False)
"""


def test_a_pool_of_mpi_gives_the_same_bits(reference, serial, tmp_path):
    pytest.importorskip("mpi4py", reason="mpi4py is not installed")
    mpiexec = shutil.which("mpiexec")
    if mpiexec is None:
        pytest.skip("there is no mpiexec; e.g. sudo apt-get install openmpi-bin")
    (tmp_path / "study.py").write_text(MPI_STUDY)
    # For Open MPI: allow more processes than processors, keep all on this machine, allow root (in a container).
    variables = {"OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl": "self,vader", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                 "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    out = tmp_path / "out"
    with found_by_workers():
        done = subprocess.run([mpiexec, "-n", "3", sys.executable, "-m", "mpi4py.futures", str(tmp_path / "study.py"),
                               str(out)], env={**os.environ, **variables}, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    finished = (out / "runs.jsonl").read_bytes()
    assert_same_bits(hapticut.sweep(SPACE, runs.drill, serial, out, units=UNITS), out, reference)
    assert (out / "runs.jsonl").read_bytes() == finished  # no run was repeated


def test_a_sweep_whose_process_was_killed_goes_on_where_it_was(serial, tmp_path):
    space = [{"x": x, "folder": str(tmp_path)} for x in range(50)]
    with pytest.raises(hapticut.Error, match="the executor failed.*BrokenProcessPool.*kept"):
        hapticut.sweep(space, runs.kills_its_process_once, out=tmp_path / "out", workers=2)
    finished = (tmp_path / "out" / "runs.jsonl").read_bytes()
    assert finished.count(b"\n") > 10
    with open(tmp_path / "out" / "runs.jsonl", "ab") as file:
        file.write(b'{"run": 49, "summ')  # the incomplete line of a killed process
    table = hapticut.sweep(space, runs.kills_its_process_once, serial, tmp_path / "out")
    assert (tmp_path / "out" / "runs.jsonl").read_bytes().startswith(finished)
    expected = hapticut.sweep(space, runs.kills_its_process_once, serial, tmp_path / "at_once")
    pd.testing.assert_frame_equal(table, expected, check_exact=True)


def test_a_run_that_took_none_of_its_steps_is_a_row_with_its_error(serial, tmp_path):
    table = hapticut.sweep({"dt": [1e-3, 10.0]}, runs.takes_no_step, serial, tmp_path)
    assert pd.isna(table["error"][0]) and "none of the 3 steps was made: dt_rejected" in table["error"][1]
    with pytest.warns(UserWarning, match="none of the 3 steps was made: dt_rejected"):
        runs.takes_no_step({"dt": 10.0}, None)


def test_a_run_that_raises_is_a_row_with_its_error_and_is_not_made_again(serial, tmp_path):
    for _ in range(2):
        table = hapticut.sweep({"x": [1, 2, 3, 4]}, runs.squares, serial, tmp_path)
        assert table["error"].fillna("").tolist() == ["", "", "ValueError: three is too much", ""]
        assert table["square"].tolist()[:2] == [1, 4] and np.isnan(table["square"][2])
    assert (tmp_path / "runs.jsonl").read_bytes().count(b"\n") == 5


@pytest.mark.parametrize("number, message", list(enumerate([
    "SystemExit: 3", "must return a dict", "column y is None", "dtype object", "names must be texts", "named 'error'",
    "named 'x'"])))
def test_what_cannot_be_kept_of_a_run_is_its_error(number, message, serial, tmp_path):
    table = hapticut.sweep({"x": [number, 7]}, runs.returns_what_cannot_be_kept, serial, tmp_path)
    assert message in table["error"][0] and pd.isna(table["error"][1])


def test_traces_may_have_any_name(serial, tmp_path):
    hapticut.sweep({"x": [3]}, runs.returns_traces_of_odd_names, serial, tmp_path)
    traces = sweep.load_traces(tmp_path, 0)
    assert sorted(traces) == ["a/b", "allow_pickle", "file", "force.npy"]
    assert all(values.tolist() == [3, 4] for values in traces.values())


@pytest.mark.parametrize("change", [{"space": {"x": [1, 2, 4]}}, {"seed": 1}, {"run": runs.takes_no_step}])
def test_the_folder_of_another_study_is_refused_and_left_alone(serial, tmp_path, change):
    hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    given = {"space": {"x": [1, 2]}, "run": runs.squares, **change}
    with pytest.raises(hapticut.Error, match="another study, with another"):
        hapticut.sweep(executor=serial, out=tmp_path, **given)
    with pytest.raises(hapticut.Error, match="resume=True"):
        hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path, resume=False)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


def scaled_in_a_closure(factor):
    return lambda parameters, rng: {"y": factor * parameters["x"]}


def function_of_another_module():
    module = types.ModuleType("other_runs")
    exec("def squares(parameters, rng): return {'y': parameters['x'] ** 2}", vars(module))
    return module.squares


@pytest.mark.parametrize("first, second", [
    (runs.squares, function_of_another_module()),
    (lambda parameters, rng: {"y": 1.0}, lambda parameters, rng: {"y": 2.0}),
    (scaled_in_a_closure(2), scaled_in_a_closure(3)),
    (functools.partial(runs.scaled, factor=2), functools.partial(runs.scaled, factor=3)),
    (runs.Scaled(2), runs.Scaled(3)), (runs.Scaled(2).__call__, runs.Scaled(3).__call__)])
def test_another_function_of_the_same_name_is_another_study(serial, tmp_path, first, second):
    hapticut.sweep({"x": [1, 2]}, first, serial, tmp_path)
    hapticut.sweep({"x": [1, 2]}, first, serial, tmp_path)
    with pytest.raises(hapticut.Error, match="another study, with another .*function"):
        hapticut.sweep({"x": [1, 2]}, second, serial, tmp_path)


CODE_OF = """
import functools, runs
from hapticut.sweep.function import code_of
for run in (runs.drill, runs.Scaled({"b": {"x", "y", "z"}, "a": 1.5}), functools.partial(runs.scaled, factor=[2])):
    print(code_of(run))
"""


def test_a_function_is_the_same_in_every_process(tmp_path):
    codes = set()
    with found_by_workers():
        for seed in ("1", "2"):
            codes.add(subprocess.run([sys.executable, "-c", CODE_OF], env={**os.environ, "PYTHONHASHSEED": seed},
                                     check=True, capture_output=True, text=True).stdout)
    assert len(codes) == 1 and len(set(codes.pop().split())) == 3


def test_a_run_that_kills_its_process_is_named(tmp_path):
    for _ in range(2):
        with pytest.raises(hapticut.Error, match="probably in run 2: call run with those parameters alone"):
            hapticut.sweep({"x": [0, 1, 2, 3]}, runs.kills_its_process, out=tmp_path, workers=1)


@pytest.mark.parametrize("number, line", [
    (1, b"[]"), (1, b"7"), (2, b"[]"), (2, b"null"), (2, b'{"run": 0}'), (2, b'{"run": 7, "summary": {}, "error": ""}'),
    (3, b'{"run": 1, "summary": [], "error": ""}')])
def test_a_damaged_line_is_named(serial, tmp_path, number, line):
    hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path)
    file = tmp_path / "runs.jsonl"
    lines = file.read_bytes().splitlines()
    lines[number - 1] = line
    file.write_bytes(b"\n".join(lines) + b"\n")
    with pytest.raises(hapticut.Error, match=f"runs.jsonl is damaged: line {number}"):
        hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path)


def test_a_damaged_folder_is_named(serial, tmp_path):
    hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path)
    file = tmp_path / "runs.jsonl"
    file.write_bytes(file.read_bytes().replace(b"summary", b'"'))
    with pytest.raises(hapticut.Error, match="runs.jsonl is damaged"):
        hapticut.sweep({"x": [1, 2]}, runs.squares, serial, tmp_path)


def test_designs_fill_their_bounds_evenly():
    pytest.importorskip("scipy", reason="scipy is not installed")
    bounds = {"feed": (1e-3, 3e-3), "speed": (100.0, 10000.0, "log")}
    space = sweep.latin_hypercube(50, bounds, seed=3)
    assert space == sweep.latin_hypercube(50, bounds, seed=3) != sweep.latin_hypercube(50, bounds, seed=4)
    feeds = np.sort([row["feed"] for row in space])
    assert (np.floor((feeds - 1e-3) / 2e-3 * 50) == np.arange(50)).all()  # one in each slice
    slices = np.floor(np.log10(np.sort([row["speed"] for row in space]) / 100) / 2 * 50)
    assert (slices == np.arange(50)).all()
    assert len(sweep.sobol(16, bounds)) == 16


@pytest.mark.parametrize("space, message", [
    ([], "give a dict"), ({}, "without axes"), ({"x": []}, "axis x"), ({"x": "abc"}, "axis x"), (3, "the space is 3"),
    ([{"x": 1}, {"y": 1}], "run 1 has the parameters"), ([{"x": [1]}], "parameter x of run 0"), ([1, 2], "one dict"),
    ({"run": [1]}, "other than run and error"), ({1: [1]}, "names must be non-empty texts")])
def test_spaces_that_make_no_sense_are_refused(space, message, serial, tmp_path):
    with pytest.raises(hapticut.Error, match=message):
        hapticut.sweep(space, runs.squares, serial, tmp_path)


@pytest.mark.parametrize("n, bounds, message", [
    (0, {"x": (0, 1)}, "n = 0"), (2.5, {"x": (0, 1)}, "n = 2.5"), (2, {}, "bounds are {}"), (2, 5, "bounds are 5"),
    (2, {"x": 5}, "bounds of x are 5"), (2, {"x": ("a", "b")}, "bounds of x"), (2, {"x": (0, 1, "ln")}, "bounds of x"),
    (4, {"x": (2.0, 1.0)}, "low < high"), (4, {"x": (0.0, 1.0, "log")}, "both > 0")])
def test_designs_that_make_no_sense_are_refused(n, bounds, message):
    pytest.importorskip("scipy", reason="scipy is not installed")
    for design in (sweep.latin_hypercube, sweep.sobol):
        with pytest.raises(hapticut.Error, match=message):
            design(n, bounds)
    with pytest.raises(hapticut.Error, match="the sampler is 3"):
        sweep.design(3, 4, {"x": (0, 1)})


class LooksLikeAClient:
    def get_executor(self): ...


@pytest.mark.parametrize("given, message", [
    ({"seed": -1}, "seed = -1"), ({"seed": None}, "seed = None"), ({"seed": 0.5}, "seed = 0.5"),
    ({"workers": 0}, "workers = 0"), ({"workers": "two"}, "workers = 'two'"), ({"units": "N"}, "units are 'N'"),
    ({"run": 3}, "run is 3"), ({"executor": "dask"}, "executor is 'dask'"),
    ({"executor": LooksLikeAClient()}, r"get_executor\(\)")])
def test_arguments_that_make_no_sense_are_refused_before_anything_is_written(given, message, tmp_path):
    with pytest.raises(hapticut.Error, match=message):
        hapticut.sweep(**{"space": {"x": [1]}, "run": runs.squares, "out": tmp_path / "out", **given})
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_written_is_said_before_the_first_run(serial, tmp_path):
    (tmp_path / "file").write_text("in the way")
    for out in (tmp_path / "file", tmp_path / "file" / "below", Path("/proc/hapticut")):
        with pytest.raises(hapticut.Error, match=f"cannot write.*{re.escape(str(out))}.*Choose another"):
            hapticut.sweep({"x": [1]}, runs.squares, serial, out)


def test_a_disk_that_becomes_full_is_an_error_and_what_was_finished_is_kept(serial, tmp_path):
    space = {"x": list(range(20))}
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (37_000, hard))  # simulates a full disk
    try:
        with pytest.raises(hapticut.Error, match="cannot write.*Finished runs are kept"):
            hapticut.sweep(space, runs.returns_more_and_more, serial, tmp_path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    finished = (tmp_path / "runs.jsonl").read_bytes()
    table = hapticut.sweep(space, runs.returns_more_and_more, serial, tmp_path)
    assert table["error"].isna().all() and len(table) == 20
    assert (tmp_path / "runs.jsonl").read_bytes().startswith(finished)
    assert len(sweep.load_traces(tmp_path, 19)["values"]) == 9500


def test_an_executor_that_takes_no_more_work_is_an_error(tmp_path):
    class Closed(Executor):
        def submit(self, function, /, *args, **kwargs):
            raise LookupError("the client is closed")  # like dask's error, which is not a RuntimeError

    with pytest.raises(hapticut.Error, match="the executor failed.*LookupError.*kept"):
        hapticut.sweep({"x": [1, 2]}, runs.squares, Closed(), tmp_path)
