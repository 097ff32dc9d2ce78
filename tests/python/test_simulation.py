# SPDX-License-Identifier: Apache-2.0
"""Steps and runs give the same forces as in C++. Concurrent calls and invalid arguments are refused."""
from __future__ import annotations

import threading
import time

import hapticut
import numpy as np
import pytest
from hapticut.units import mm


def test_run_gives_the_same_bits_as_the_same_steps(simulation, block, tool, plunge):
    poses, velocities = plunge
    trace = simulation.run(poses, velocities, 1e-3)
    other = hapticut.Simulation(block, tool, hapticut.SimulationConfig(reference_stiffness=1e16))
    removed = []
    for i in range(len(poses)):
        result = other.step(poses[i], velocities[i], 1e-3)
        assert np.array_equal(result.force, trace["force"][i])
        assert np.array_equal(result.torque, trace["torque"][i])
        assert result.energy.cutting == trace["energy"]["cutting"][i]
        assert len(result.removed_voxels) == trace["removed_voxels"][i]
        removed += [(i, *index, material) for index, material in zip(result.removed_voxels.tolist(),
                                                                    result.removed_materials.tolist())]
    assert simulation.workpiece.hash() == other.workpiece.hash()
    recorded = simulation.removed_in_run
    assert removed == [(int(r["step"]), *r["index"].tolist(), int(r["material"])) for r in recorded]


def test_the_force_of_a_still_ball_is_the_closed_form(block):
    # C1: F = k_v (pi/12) d^3 (4 R - 3 d); 2 % for the quadrature at d = 5 voxels.
    k, R, d = 1e10, 1.5 * mm, 0.5 * mm
    material = hapticut.Material("unit", cutting_ratio=0.0)
    block.set_materials(hapticut.MaterialTable([material]))
    simulation = hapticut.Simulation(block, hapticut.Tool(hapticut.SphereHead(R)),
                                     hapticut.SimulationConfig(reference_stiffness=k))
    result = simulation.step(hapticut.Pose.from_translation([0, 0, R - d]), np.zeros(6), 1e-3)
    assert result.force[2] == pytest.approx(k * np.pi / 12 * d**3 * (4 * R - 3 * d), rel=0.02)


def test_dt_may_change_from_step_to_step(simulation, plunge):
    poses, velocities = plunge
    dt = np.full(len(poses), 1e-3)
    dt[10] = 0.5  # above SimulationConfig.max_dt
    trace = simulation.run(poses, velocities, dt)
    assert trace["status"][10] & hapticut.StepStatus.dt_rejected
    assert np.flatnonzero(trace["status"] & hapticut.StepStatus.dt_rejected).tolist() == [10]
    assert trace["time"][-1] == pytest.approx(dt.sum())


def test_a_result_stays_as_it_is_when_further_steps_are_made(simulation, plunge):
    poses, velocities = plunge
    results = [simulation.step(pose, velocity, 1e-3) for pose, velocity in zip(poses, velocities)]
    result = max(results[:-1], key=lambda r: len(r.removed_voxels))
    voxels, materials, before = result.removed_voxels, result.removed_materials, result.removed_voxels.tolist()
    assert len(before) > 0 and len({tuple(voxel) for voxel in before}) == len(before)
    del result, results
    simulation.run(poses[::-1].copy(), velocities, 1e-3)
    assert voxels.tolist() == before and set(materials.tolist()) == {1}
    assert not voxels.flags.writeable


@pytest.mark.parametrize("change, message", [
    (lambda p, v: (p.astype(np.float32), v), r"poses.*dtype float32.*\(n, 4, 4\) and dtype float64"),
    (lambda p, v: (np.asfortranarray(p), v), r"poses.*not in C order.*C-contiguous"),
    (lambda p, v: (p[:, :3], v), r"poses.*shape \(600, 3, 4\).*\(n, 4, 4\)"),
    (lambda p, v: (p.tolist(), v), r"poses.*type list"),
    (lambda p, v: (p, v[:, :3]), r"velocities.*\(600, 3\).*\(n, 6\)"),
    (lambda p, v: (p, v[:10].copy()), r"poses has 600 rows, but velocities has 10"),
    (lambda p, v: (p.swapaxes(1, 2).copy(), v), r"last row.*transposed"),
    (lambda p, v: (p.astype(">f8"), v), r"poses.*>f8"),
])
def test_arrays_of_another_shape_or_type_are_refused_before_anything_happens(simulation, plunge, change, message):
    before = simulation.workpiece.hash()
    with pytest.raises(hapticut.Error, match=message):
        simulation.run(*change(*plunge), 1e-3)
    assert simulation.workpiece.hash() == before
    assert simulation.last_result.sub_steps == 0


def test_a_run_refuses_numbers_that_are_not_finite_and_says_where(simulation, plunge):
    poses, velocities = plunge
    poses[17, 0, 3] = np.nan
    with pytest.raises(hapticut.Error, match=r"poses\[17\] contains nan"):
        simulation.run(poses, velocities, 1e-3)
    assert simulation.last_result.sub_steps == 0
    with pytest.raises(hapticut.Error, match="dt.*nan"):
        simulation.run(*plunge[:0], np.eye(4)[None], np.zeros((1, 6)), np.nan)
    with pytest.raises(hapticut.Error, match=r"dt.*type str.*number"):
        simulation.run(np.eye(4)[None], np.zeros((1, 6)), "fast")


def test_a_step_reports_a_bad_pose_by_its_status(simulation):
    before = simulation.workpiece.hash()
    pose = np.eye(4)
    pose[0, 3] = np.inf
    result = simulation.step(pose, np.zeros(6), 1e-3)
    assert hapticut.has_any(result.status, hapticut.StepStatus.pose_rejected)
    assert result.status & hapticut.kRejected
    assert not result.force.any() and simulation.workpiece.hash() == before


def test_a_step_takes_lists_but_no_float32(simulation):
    simulation.step(np.eye(4).tolist(), [0, 0, 0, 0, 0, 0], 1e-3)
    with pytest.raises(hapticut.Error, match=r"pose.*float32.*\(4, 4\)"):
        simulation.step(np.eye(4, dtype=np.float32), np.zeros(6), 1e-3)
    with pytest.raises(hapticut.Error, match=r"velocity.*\(3,\).*\(6,\)"):
        simulation.step(np.eye(4), np.zeros(3), 1e-3)
    with pytest.raises(hapticut.Error, match="pose.*NoneType"):
        simulation.step(None, np.zeros(6), 1e-3)


def test_the_ledger_closes(simulation, plunge):
    simulation.run(*plunge, 1e-3)
    energy = simulation.last_result.energy
    assert energy.cutting > 0
    assert simulation.last_result.contact.volume > 0
    assert abs(energy.closure()) < 1e-3  # single precision in the hot loop


def test_a_simulation_works_on_a_copy_of_the_workpiece(block, tool, plunge):
    before = block.hash()
    simulation = hapticut.Simulation(block, tool)
    simulation.run(*plunge, 1e-3)
    assert block.hash() == before != simulation.workpiece.hash()


def test_a_look_at_the_workpiece_follows_a_reset_and_outlives_the_simulation(simulation, block, plunge):
    look = simulation.workpiece
    simulation.run(*plunge, 1e-3)
    assert look.hash() != block.hash()
    simulation.reset(block)
    assert look.hash() == block.hash()
    del simulation
    assert look.solid_voxels() == block.solid_voxels()


def test_a_workpiece_of_a_simulation_cannot_be_changed_from_outside(simulation):
    with pytest.raises(hapticut.Error, match="only its Simulation"):
        simulation.workpiece.set_materials(hapticut.MaterialTable([hapticut.presets.clay()]))
    copy = simulation.workpiece.clone()
    copy.set_materials(hapticut.MaterialTable([hapticut.presets.clay()]))


def test_snapshots_bring_back_every_voxel(simulation, plunge):
    before = simulation.workpiece.hash()
    snapshot = simulation.snapshot()
    simulation.run(*plunge, 1e-3)
    simulation.restore(snapshot)
    assert simulation.workpiece.hash() == before


def test_undo_goes_back_to_a_mark_in_small_parts(simulation, plunge):
    with pytest.raises(hapticut.Error, match="reserve_undo"):
        simulation.set_undo_mark()
    assert simulation.undo_marks == 0
    simulation.reserve_undo(2000)
    assert simulation.workpiece.undo_blocks == 2000
    states = []
    for half in (slice(0, 300), slice(300, 600)):
        states.append(simulation.workpiece.hash())
        simulation.set_undo_mark()
        simulation.run(plunge[0][half], plunge[1][half], 1e-3)
    assert simulation.undo_marks == 2 and len({*states, simulation.workpiece.hash()}) == 3
    for state in reversed(states):
        calls, done = 0, False
        while not done:
            done = simulation.undo(5)
            origins, complete = simulation.changed_blocks()
            assert len(origins) <= 5 and complete
            calls += 1
        assert calls > 1 and simulation.workpiece.hash() == state
    assert simulation.undo_marks == 0 and simulation.undo(5)
    simulation.set_undo_mark()
    simulation.reset(simulation.workpiece)
    assert simulation.undo_marks == 0 and simulation.workpiece.undo_blocks == 2000
    with pytest.raises(hapticut.Error, match="Reserve"):
        simulation.reserve_undo(10**12)


def test_a_run_releases_the_interpreter_lock_and_no_other_thread_can_step_meanwhile(simulation, plunge):
    poses = np.repeat(plunge[0], 200, axis=0)
    velocities = np.zeros((len(poses), 6))
    ended = threading.Event()

    def run() -> None:
        simulation.run(poses, velocities, 1e-3)
        ended.set()

    thread = threading.Thread(target=run)
    thread.start()
    counted, refused = 0, 0
    while not ended.is_set():
        counted += 1  # possible only while the run has released the interpreter lock
        try:
            simulation.step(poses[0], velocities[0], 1e-3)
        except hapticut.Error as error:
            assert "another thread" in str(error)
            refused += 1
        time.sleep(0)
    thread.join()
    assert counted > 1 and refused > 0


class StartsARun:
    """A number whose conversion lets another thread begin a run."""

    def __init__(self, simulation, *run):
        self.simulation, self.run, self.thread, self.has_begun = simulation, run, None, False

    def __float__(self):
        self.thread = threading.Thread(target=self.simulation.run, args=self.run)
        self.thread.start()
        while not self.has_begun and self.thread.is_alive():
            try:
                self.simulation.steps
            except hapticut.Error:
                self.has_begun = True
            time.sleep(0)
        return 1e-3


def test_a_run_that_begins_while_the_arguments_of_another_are_read_comes_first(simulation, plunge):
    poses = np.repeat(plunge[0], 200, axis=0)
    long_run = (poses, np.zeros((len(poses), 6)), 1e-3)
    dt = StartsARun(simulation, *long_run)
    with pytest.raises(hapticut.Error, match="another thread"):
        simulation.run(*plunge, dt)
    dt.thread.join()
    assert dt.has_begun and simulation.steps == len(poses)


def test_effects_and_spindle_speed_change_between_steps(simulation, plunge):
    poses, velocities = plunge
    simulation.run(poses, velocities, 1e-3)
    simulation.set_spindle_speed(0.0)
    assert simulation.step(poses[-1], velocities[-1], 1e-3).removed_volume == 0
    limits = hapticut.effects.OutputLimits(max_force=0.01)
    simulation.set_effects(hapticut.effects.Effects(limits=limits))
    assert np.linalg.norm(simulation.step(poses[-1], velocities[-1], 1e-3).force) <= 0.01 * (1 + 1e-12)
    with pytest.raises(hapticut.Error, match="max_force"):
        simulation.set_effects(hapticut.effects.Effects(limits=hapticut.effects.OutputLimits(max_force=-1)))
    with pytest.raises(hapticut.Error, match="speed"):
        simulation.set_spindle_speed(np.nan)


def test_another_law_gives_another_force(block, plunge):
    burr = hapticut.Tool(hapticut.SphereHead(1.5 * mm), hapticut.RayHandle(20 * mm))
    forces = []
    thesis = hapticut.ThesisLaw(hapticut.ThesisLaw.Constants(damping=0.0))
    for law in (hapticut.FoundationLaw(), hapticut.HertzianBurrLaw(1e7), thesis):
        config = hapticut.SimulationConfig(reference_stiffness=1e12, law=law)
        assert config.law is law
        forces.append(hapticut.Simulation(block, burr, config).run(*plunge, 1e-3)["force"][-1, 2])
    assert len(set(forces)) == 3 and min(forces) > 0
    with pytest.raises(hapticut.Error, match="TwistDrillLaw"):
        law = hapticut.TwistDrillLaw(hapticut.TwistDrillLaw.Constants())
        hapticut.Simulation(block, burr, hapticut.SimulationConfig(law=law))
