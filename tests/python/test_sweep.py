# SPDX-License-Identifier: Apache-2.0
"""Sweeps: the same table from every executor, and nothing lost."""
from __future__ import annotations

import contextlib
import json
import os
import pickle
import re
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import runs

import hapticut

pd = pytest.importorskip("pandas", reason="pandas is not installed")
sweep = hapticut.sweep
HERE = Path(__file__).parent

SPACE = sweep.grid(feed=[2e-3, 4e-3], speed=[2000.0, 8000.0], material=["enamel", "dentin", "cortical_bone"])


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    out = tmp_path_factory.mktemp("serial")
    table = hapticut.sweep(SPACE, runs.drill, sweep.SerialExecutor(), out, units={"feed": "m/s", "peak_force": "N"})
    return table, out


def assert_same_bits(table, out, reference):
    expected, expected_out = reference
    pd.testing.assert_frame_equal(table, expected, check_exact=True)
    assert table.to_csv() == expected.to_csv()
    for run in range(len(table)):
        assert np.array_equal(sweep.load_traces(out, run)["force"], sweep.load_traces(expected_out, run)["force"])


def test_the_table_is_tidy(reference):
    table, out = reference
    assert list(table.columns) == ["run", "feed", "speed", "material", "peak_force", "removed_volume", "draw", "error"]
    assert len(table) == 12 and table["error"].isna().all() and (table["removed_volume"] > 0).all()
    assert table["draw"].nunique() == 12
    assert table.attrs["units"] == {"feed": "m/s", "peak_force": "N"}
    # Enamel is harder than dentin, and a faster feed presses harder.
    by = table.groupby("material")["peak_force"].mean()
    assert by["enamel"] > by["dentin"]
    assert sweep.load_traces(out, 3)["force"].shape == (60, 3)
    with pytest.raises(hapticut.Error, match="run 99"):
        sweep.load_traces(out, 99)


def test_the_table_lies_in_the_folder(reference):
    table, out = reference
    if (out / "table.parquet").exists():
        written = pd.read_parquet(out / "table.parquet")
    else:
        written = pd.read_csv(out / "table.csv", keep_default_na=False)
    pd.testing.assert_frame_equal(written, table, check_exact=True)


def test_without_pyarrow_the_table_is_csv(reference, tmp_path, monkeypatch):
    import importlib.util

    find = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name, *a: None if name == "pyarrow" else find(name, *a))
    table = hapticut.sweep(SPACE, runs.drill, sweep.SerialExecutor(), tmp_path)
    written = pd.read_csv(tmp_path / "table.csv")
    assert written["error"].isna().all() and table["error"].isna().all()  # of which CSV keeps no type
    pd.testing.assert_frame_equal(written.drop(columns="error"), table.drop(columns="error"), check_exact=True)


def test_a_pool_of_processes_gives_the_same_bits(reference, tmp_path):
    assert_same_bits(hapticut.sweep(SPACE, runs.drill, out=tmp_path, workers=2), tmp_path, reference)


def test_any_executor_serves(reference, tmp_path):
    with ThreadPoolExecutor(2) as executor:
        assert_same_bits(hapticut.sweep(SPACE, runs.drill, executor, tmp_path), tmp_path, reference)
        assert executor.submit(int, 3).result() == 3  # it stays open


@contextlib.contextmanager
def environment():
    """Workers find the module of the functions."""
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join([str(HERE), *filter(None, [before])])
    try:
        yield
    finally:
        os.environ.pop("PYTHONPATH")
        if before is not None:
            os.environ["PYTHONPATH"] = before


@pytest.mark.filterwarnings("ignore")  # of dask's own
def test_a_local_cluster_of_dask_gives_the_same_bits(reference, tmp_path):
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed")
    with environment(), distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None,
                                                 host="127.0.0.1") as cluster, distributed.Client(cluster) as client:
        assert_same_bits(hapticut.sweep(SPACE, runs.drill, client.get_executor(), tmp_path), tmp_path, reference)


@contextlib.contextmanager
def dask_over_tcp(folder):
    """A scheduler and two workers as processes of their own, on the loopback."""
    def start(name, *arguments):
        log = open(folder / f"{name}.log", "w")
        return subprocess.Popen([sys.executable, "-m", *arguments], stdout=log, stderr=subprocess.STDOUT, cwd=folder)

    processes = []
    with environment():
        try:
            address = folder / "scheduler.json"
            processes.append(start("scheduler", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
                                   "--no-dashboard", "--scheduler-file", str(address)))
            deadline = time.monotonic() + 60
            while not address.exists():
                log = (folder / "scheduler.log").read_text()
                assert processes[0].poll() is None and time.monotonic() < deadline, log
                time.sleep(0.05)
            time.sleep(0.1)
            where = json.loads(address.read_text())["address"]
            for number in range(2):
                processes.append(start(f"worker{number}", "distributed.cli.dask_worker", where, "--nthreads", "1",
                                       "--no-nanny", "--no-dashboard", "--host", "127.0.0.1",
                                       "--local-directory", str(folder)))
            yield where, processes
        finally:
            for process in processes:
                process.kill()
            for process in processes:
                process.wait(timeout=30)


@pytest.mark.filterwarnings("ignore")  # of dask's own
def test_a_scheduler_and_two_workers_over_tcp_give_the_same_bits(reference, tmp_path):
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed")
    with dask_over_tcp(tmp_path) as (where, _), distributed.Client(where) as client:
        assert where.startswith("tcp://127.0.0.1:")
        client.wait_for_workers(2, timeout=60)
        out = tmp_path / "out"
        assert_same_bits(hapticut.sweep(SPACE, runs.drill, client.get_executor(), out), out, reference)


MPI_STUDY = """
import sys
import hapticut, runs
from mpi4py.futures import MPIPoolExecutor
if __name__ == "__main__":
    space = hapticut.sweep.grid(feed=[2e-3, 4e-3], speed=[2000.0, 8000.0],
                                material=["enamel", "dentin", "cortical_bone"])
    units = {"feed": "m/s", "peak_force": "N"}
    with MPIPoolExecutor() as executor:
        hapticut.sweep(space, runs.drill, executor, sys.argv[1], units=units, progress=False)
"""


def test_a_pool_of_mpi_gives_the_same_bits(reference, tmp_path):
    pytest.importorskip("mpi4py", reason="mpi4py is not installed")
    mpiexec = shutil.which("mpiexec")
    if mpiexec is None:
        pytest.skip("there is no mpiexec; e.g. sudo apt-get install openmpi-bin")
    (tmp_path / "study.py").write_text(MPI_STUDY)
    # Open MPI's: more processes than processors, all of them on this machine, also for root (in a container).
    variables = {"OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl": "self,vader", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                 "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with environment():
        done = subprocess.run([mpiexec, "-n", "3", sys.executable, "-m", "mpi4py.futures", str(tmp_path / "study.py"),
                               str(tmp_path / "out")], env={**os.environ, **variables}, capture_output=True, text=True,
                              timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    made = sum(len(path.read_text().splitlines()) for path in (tmp_path / "out" / "chunks").glob("*.jsonl"))
    assert made == len(SPACE)  # so that what follows only reads the table
    table = hapticut.sweep(SPACE, runs.drill, sweep.SerialExecutor(), tmp_path / "out", progress=False,
                           units={"feed": "m/s", "peak_force": "N"})
    assert_same_bits(table, tmp_path / "out", reference)


@pytest.mark.filterwarnings("ignore")  # of dask's own
def test_a_worker_of_a_cluster_may_be_killed_in_the_middle(tmp_path):
    distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed")
    space = [{"x": x, "folder": str(tmp_path)} for x in range(50)]
    with dask_over_tcp(tmp_path) as (where, processes), distributed.Client(where) as client:
        client.wait_for_workers(2, timeout=60)
        table = hapticut.sweep(space, runs.kills_its_worker_once, client.get_executor(), tmp_path / "out")
        assert sorted(process.poll() is not None for process in processes) == [False, False, True]
    assert (tmp_path / "killed").exists()
    expected = hapticut.sweep(space, runs.kills_its_worker_once, sweep.SerialExecutor(), tmp_path / "serial")
    pd.testing.assert_frame_equal(table, expected, check_exact=True)


def test_a_worker_of_the_pool_may_be_killed_in_the_middle(tmp_path):
    space = [{"x": x, "folder": str(tmp_path)} for x in range(50)]
    table = hapticut.sweep(space, runs.kills_its_worker_once, out=tmp_path / "out", workers=2)
    assert (tmp_path / "killed").exists()
    expected = hapticut.sweep(space, runs.kills_its_worker_once, sweep.SerialExecutor(), tmp_path / "serial")
    pd.testing.assert_frame_equal(table, expected, check_exact=True)


def test_a_run_that_kills_its_worker_every_time_is_a_row_with_its_error(tmp_path):
    table = hapticut.sweep({"x": list(range(8))}, runs.always_kills_its_worker, out=tmp_path, workers=2)
    assert table["error"].notna().tolist() == [x == 5 for x in range(8)]
    assert "WorkerDied" in table["error"][5] and np.isnan(table["draw"][5])


def test_an_executor_that_dies_is_an_error_and_the_sweep_goes_on_with_another(tmp_path):
    space = [{"x": x, "folder": str(tmp_path)} for x in range(50)]
    with ProcessPoolExecutor(2) as executor:
        with pytest.raises(hapticut.Error, match="the executor died.*kept"):
            hapticut.sweep(space, runs.kills_its_worker_once, executor, tmp_path / "out", workers=2)
    done = list((tmp_path / "out" / "chunks").glob("*.jsonl"))
    assert done
    before = {path.name: path.stat().st_mtime_ns for path in done}
    table = hapticut.sweep(space, runs.kills_its_worker_once, sweep.SerialExecutor(), tmp_path / "out")
    assert table["error"].isna().all() and len(table) == 50
    assert all((tmp_path / "out" / "chunks" / name).stat().st_mtime_ns == time for name, time in before.items())


def test_a_run_that_took_none_of_its_steps_is_a_row_with_its_error(tmp_path):
    table = hapticut.sweep({"dt": [1e-3, 10.0]}, runs.takes_no_step, sweep.SerialExecutor(), tmp_path)
    assert pd.isna(table["error"][0]) and "none of the 3 steps was taken: dt_rejected" in table["error"][1]
    with pytest.warns(UserWarning, match="none of the 3 steps was taken: dt_rejected"):
        runs.takes_no_step({"dt": 10.0}, None)


def test_a_run_that_raises_is_a_row_with_its_error(tmp_path):
    table = hapticut.sweep({"x": [1, 2, 3, 4]}, runs.sometimes_raises, sweep.SerialExecutor(), tmp_path)
    assert table["error"].fillna("").tolist() == ["", "", "ValueError: three is too much", ""]
    assert table["square"].tolist()[:2] == [1, 4] and np.isnan(table["square"][2])
    table = hapticut.sweep({"x": list(range(5))}, runs.returns_nonsense, sweep.SerialExecutor(), tmp_path / "2")
    assert table["error"].notna().all()
    assert "named 'x'" in table["error"][0] and "must return a dict" in table["error"][1]
    assert "column y is None" in table["error"][2] and "named 'error'" in table["error"][4]


def test_a_killed_sweep_goes_on_where_it_was(reference, tmp_path):
    script = tmp_path / "study.py"
    script.write_text(
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "import hapticut, runs\n"
        "if __name__ == '__main__':\n"
        "    space = [{'x': x, 'seconds': 0.05} for x in range(200)]\n"
        "    hapticut.sweep(space, runs.sleeps, hapticut.sweep.SerialExecutor(), sys.argv[2], progress=False)\n")
    out = tmp_path / "out"
    process = subprocess.Popen([sys.executable, str(script), str(HERE), str(out)])
    deadline = time.monotonic() + 60
    while len(list((out / "chunks").glob("*.jsonl"))) < 2:
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    kept = sum(len(path.read_text().splitlines()) for path in (out / "chunks").glob("*.jsonl"))
    assert 0 < kept < 200
    calls = []
    space = [{"x": x, "seconds": 0.05} for x in range(200)]
    instantly = pickle.dumps(runs.sleeps_not)

    class Counting(sweep.SerialExecutor):
        def submit(self, function, /, pickled, seed, indices, parameters):
            calls.extend(indices)
            return super().submit(function, instantly, seed, indices, parameters)

    table = hapticut.sweep(space, runs.sleeps, Counting(), out)
    assert len(calls) == 200 - kept == len(set(calls))
    assert table["y"].tolist() == list(range(200)) and table["error"].isna().all()


@pytest.mark.parametrize("change", [{"space": {"x": [1, 2, 4]}}, {"seed": 1}, {"run": runs.sleeps}])
def test_the_folder_of_another_study_is_refused_and_left_alone(tmp_path, change):
    hapticut.sweep({"x": [1, 2]}, runs.sometimes_raises, sweep.SerialExecutor(), tmp_path)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    given = {"space": {"x": [1, 2]}, "run": runs.sometimes_raises, **change}
    with pytest.raises(hapticut.Error, match="another study, with another"):
        hapticut.sweep(executor=sweep.SerialExecutor(), out=tmp_path, **given)
    with pytest.raises(hapticut.Error, match="resume=True"):
        hapticut.sweep({"x": [1, 2]}, runs.sometimes_raises, sweep.SerialExecutor(), tmp_path, resume=False)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


def test_a_damaged_chunk_is_named(tmp_path):
    hapticut.sweep({"x": [1, 2]}, runs.sometimes_raises, sweep.SerialExecutor(), tmp_path)
    chunk = sorted((tmp_path / "chunks").glob("*.jsonl"))[0]
    chunk.write_text(chunk.read_text()[:5])
    with pytest.raises(hapticut.Error, match=f"{chunk.name} is damaged"):
        hapticut.sweep({"x": [1, 2]}, runs.sometimes_raises, sweep.SerialExecutor(), tmp_path)


def test_designs_fill_their_bounds_evenly():
    pytest.importorskip("scipy", reason="scipy is not installed")
    bounds = {"feed": (1e-3, 3e-3), "speed": (100.0, 10000.0, "log")}
    space = sweep.latin_hypercube(50, bounds, seed=3)
    assert space.digest() == sweep.latin_hypercube(50, bounds, seed=3).digest()
    assert space.digest() != sweep.latin_hypercube(50, bounds, seed=4).digest()
    feeds = np.sort([row["feed"] for row in space])
    assert (np.floor((feeds - 1e-3) / 2e-3 * 50) == np.arange(50)).all()  # one in each slice
    slices = np.floor(np.log10(np.sort([row["speed"] for row in space]) / 100) / 2 * 50)
    assert (slices == np.arange(50)).all()
    assert len(sweep.sobol(16, bounds)) == 16
    with pytest.raises(hapticut.Error, match="low < high"):
        sweep.latin_hypercube(4, {"x": (2.0, 1.0)})
    with pytest.raises(hapticut.Error, match="both > 0"):
        sweep.sobol(4, {"x": (0.0, 1.0, "log")})


def test_chunks_grow_to_about_a_second(tmp_path):
    hapticut.sweep({"x": list(range(4000)), "seconds": [0.0]}, runs.sleeps, sweep.SerialExecutor(), tmp_path)
    assert len(list((tmp_path / "chunks").glob("*.jsonl"))) < 40


def test_the_command_line_does_the_same(reference, tmp_path):
    study = tmp_path / "study.toml"
    study.write_text(f"""
run = "{HERE.as_posix()}/runs.py:drill"
out = "{(tmp_path / 'out').as_posix()}"
[grid]
feed = [2e-3, 4e-3]
speed = [2000.0, 8000.0]
material = ["enamel", "dentin", "cortical_bone"]
[units]
feed = "m/s"
peak_force = "N"
""")
    done = subprocess.run([sys.executable, "-m", "hapticut.sweep", str(study), "--quiet", "--workers", "2"],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "12 runs, 0 failed" in done.stdout
    done = subprocess.run([sys.executable, "-m", "hapticut.sweep", str(study), "--quiet", "--no-resume"],
                          capture_output=True, text=True)
    assert done.returncode == 1 and "resume" in done.stderr and "Traceback" not in done.stderr
    from hapticut.sweep.command import FunctionOf
    run = FunctionOf(f"{HERE.as_posix()}/runs.py", "drill", "", {})
    table = hapticut.sweep(SPACE, run, sweep.SerialExecutor(), tmp_path / "out", units=reference[0].attrs["units"])
    assert_same_bits(table, tmp_path / "out", reference)
