# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C ends long calls, and what was done until then stays. Each call would take minutes; it gets SIGINT when it has
begun, and must end long before."""
from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import hapticut

PATIENCE = 20  # [s] time of a busy machine; the calls end within a second

BEGIN = """
import signal, threading, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have started the tests without it
import numpy as np
import hapticut
from hapticut.units import mm, ms, rpm

def begun():
    print("begun", flush=True)

def block(size=3 * mm, voxel=0.1 * mm):
    return hapticut.build_block(hapticut.Box([-size] * 3, [size, size, 0]), voxel, hapticut.presets.cortical_bone())
"""


def interrupted(code: str, folder: Path, said: str = "KeyboardInterrupt") -> str:
    """Runs a program, interrupts it when it says that it has begun, and returns what it printed afterwards."""
    with subprocess.Popen([sys.executable, "-c", BEGIN + code], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as program:
        try:
            assert program.stdout.readline() == "begun\n", program.stderr.read()
            time.sleep(0.5)  # until it is within the call
            program.send_signal(signal.SIGINT)
            printed, errors = program.communicate(timeout=PATIENCE)
        finally:
            program.kill()
    assert said in errors or said in printed, errors
    return printed


LONG = {
    "build_body": "hapticut.build_body(hapticut.BodyDescription(hapticut.Box([-1] * 3, [1] * 3), "
                  "lambda p: float(np.linalg.norm(p) - 1), lambda p: 1), 1 * mm, "
                  "hapticut.MaterialTable([hapticut.presets.enamel()]))",
    "build_molar": "hapticut.build_molar(0.006 * mm)",
    "build_sphere": "hapticut.build_sphere([0, 0, 0], 10 * mm, 0.01 * mm, hapticut.presets.enamel())",
    "build_from_mesh": "hapticut.build_from_mesh(mesh, hapticut.presets.enamel(), "
                       "hapticut.MeshImport(0.01 * mm, subsamples=16, large=True))",
    "from_intensity": "hapticut.Workpiece.from_intensity(grey, [1 * mm] * 3, "
                      "[hapticut.GreyRange(500, 1e9, hapticut.presets.enamel())], "
                      "options=hapticut.VolumeBuildOptions(voxel_size=0.06 * mm, subsamples=16, large=True))",
    "HeatField.advance": "hapticut.heat.HeatField(block()).advance(1e9)",
    "max_stable_stiffness": "analysis.max_stable_stiffness(loop, lambda k: analysis.LinearWall(k, one_sided=False), "
                            "analysis.StabilitySearch(settle=1e4))",
}
PREPARED = {
    "build_from_mesh": "mesh = hapticut.extract_surface(hapticut.build_molar(0.3 * mm)).mesh",
    "from_intensity": "grey = 1000.0 * np.random.default_rng(1).random((120, 120, 120))",
    "max_stable_stiffness": "from hapticut import analysis\nfrom hapticut.device import device_model, hand_model\n"
                            "loop = analysis.ClosedLoopConfig(device=device_model('touch'), "
                            "hand=hand_model('nominal'), delay=1)",
}


@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_ends(name, tmp_path):
    printed = interrupted(f"{PREPARED.get(name, '')}\nbegun()\n{LONG[name]}\nprint('not interrupted')", tmp_path)
    assert "not interrupted" not in printed


RUN = """
simulation = hapticut.Simulation(block(2.2 * mm, 0.04 * mm), hapticut.Tool(hapticut.SphereHead(1 * mm),
                                                                           spindle=hapticut.Spindle(40000 * rpm)))
n = 300_000
phase = np.arange(n) * 1e-3
hand = np.column_stack([1 * mm * np.cos(phase), 1 * mm * np.sin(phase), np.full(n, 0.5 * mm)])
poses = hapticut.Pose.from_translation(hand)
again = hapticut.Simulation(block(2.2 * mm, 0.04 * mm), simulation.tool)

def tell_when_it_is_in_use():
    while True:
        try:
            simulation.steps
        except hapticut.Error:
            return begun()

threading.Thread(target=tell_when_it_is_in_use, daemon=True).start()
try:
    simulation.run(poses, np.zeros((n, 6)), 1 * ms)
except KeyboardInterrupt:
    made = simulation.steps
    assert 0 < made < n, made
    assert simulation.removed_in_run["step"].max() < made
    assert np.array_equal(simulation.last_input.X_WH, poses[made - 1])
    # The steps that were made are those of a run of that length, and the next ones go on from there.
    again.run(poses[:made], np.zeros((made, 6)), 1 * ms)
    assert again.workpiece.hash() == simulation.workpiece.hash()
    more = slice(made, made + 100)
    traces = [each.run(poses[more], np.zeros((100, 6)), 1 * ms) for each in (simulation, again)]
    assert traces[0].tobytes() == traces[1].tobytes() and traces[0]["energy"]["cutting"][-1] > 0
    print("kept", made)
    raise
"""


def test_ctrl_c_ends_a_run_and_keeps_the_steps_that_were_made(tmp_path):
    assert "kept " in interrupted(RUN, tmp_path)


def test_a_handler_of_signals_that_returns_lets_the_run_go_on(tmp_path):
    code = RUN.split("begun()")[0] + """
import os
seen = []
signal.signal(signal.SIGUSR1, lambda *_: seen.append(1))
threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGUSR1)).start()
trace = simulation.run(poses[:60000], np.zeros((60000, 6)), 1 * ms)
assert len(trace) == 60000 and seen == [1]
print("begun", flush=True)
time.sleep(100)
"""
    interrupted(code, tmp_path)


LOOP = """
from hapticut.device import RunOptions, open_device
from hapticut.loop import RealtimeLoop, RealtimeLoopOptions, SimulationModel
config = hapticut.SimulationConfig(reference_stiffness=1e11)
simulation = hapticut.Simulation(block(), hapticut.Tool(hapticut.SphereHead(1 * mm)), config)
device = open_device("mock:press,hand=nominal")
model = SimulationModel(simulation, device)
loop = RealtimeLoop(model, RealtimeLoopOptions(run=RunOptions(seconds=1000, stop_on_signals=False)))
loop.start()
while loop.latest().tick == 0:
    time.sleep(1e-3)
begun()
try:
    loop.wait()
except KeyboardInterrupt:
    assert loop.is_running  # the hand still feels its force
    print("ticks", loop.stop().ticks)
    raise
"""


def test_ctrl_c_ends_the_wait_for_a_loop_but_not_the_loop(tmp_path):
    assert int(interrupted(LOOP, tmp_path).split("ticks ")[1]) > 0


SWEEP = """
from runs import takes_long
if __name__ == "__main__":
    import os
    space = [{"x": n, "seconds": 0.0 if n < 5 else 1000.0} for n in range(40)]
    hapticut.sweep(space, takes_long, out="out", workers=2, progress=False)
"""


BUSY_MACHINE = """
from concurrent.futures import ProcessPoolExecutor
shutdown = ProcessPoolExecutor.shutdown
def shutdown_later(*arguments, **keywords):  # when the pool has seen that its processes died
    time.sleep(0.5)
    shutdown(*arguments, **keywords)
ProcessPoolExecutor.shutdown = shutdown_later
"""


@pytest.mark.parametrize(("whole_group", "machine"), [(False, ""), (True, ""), (False, BUSY_MACHINE)],
                         ids=["program", "group", "busy"])
def test_ctrl_c_ends_a_sweep_with_its_workers_and_keeps_the_finished_runs(tmp_path, whole_group, machine):
    pytest.importorskip("pandas", reason="pandas is not installed")
    (tmp_path / "program.py").write_text(BEGIN + machine + SWEEP, encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}
    with subprocess.Popen([sys.executable, "program.py"], cwd=tmp_path, env=environment, stderr=subprocess.PIPE,
                          text=True, start_new_session=True) as program:
        try:
            study, marks = tmp_path / "out" / "runs.jsonl", tmp_path
            while len(list(marks.glob("worker-*"))) < 2 or len(study.read_text().splitlines()) < 6:
                assert program.poll() is None, program.stderr.read()
                time.sleep(0.05)
            workers = [int(path.name.split("-")[1]) for path in marks.glob("worker-*")]
            (os.killpg if whole_group else os.kill)(program.pid, signal.SIGINT)  # a terminal interrupts all of them
            errors = program.communicate(timeout=PATIENCE)[1]
        finally:
            program.kill()
    assert "KeyboardInterrupt" in errors
    assert errors.count("Traceback") == 1 + errors.count("During handling"), errors  # none of the workers
    rows = [json.loads(line) for line in study.read_text().splitlines()[1:]]
    assert sorted(row["run"] for row in rows) == list(range(5)) and not any(row["error"] for row in rows)
    for worker in workers:
        with pytest.raises(ProcessLookupError):
            os.kill(worker, 0)


def test_a_run_in_another_thread_is_left_alone(simulation, plunge):
    """Python raises KeyboardInterrupt in its main thread only."""
    import threading

    traces = []
    thread = threading.Thread(target=lambda: traces.append(simulation.run(*plunge, 1e-3)))
    thread.start()
    thread.join()
    assert len(traces[0]) == 600 and simulation.steps == 600


def test_the_docstring_of_run_says_what_is_left():
    assert "KeyboardInterrupt" in hapticut.Simulation.run.__doc__


def test_ctrl_c_within_the_reading_of_a_list_is_no_error_of_the_list(tmp_path):
    for _ in range(3):
        interrupted("""
begun()
try:
    while True:
        hapticut.Wrench([0, 0, 1], [0, 0, 0])
except hapticut.Error as error:
    print("an Error:", error)
""", tmp_path)
