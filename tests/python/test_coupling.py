# SPDX-License-Identifier: Apache-2.0
"""The links between a device and a simulation: probe, virtual coupling, stages of the guard."""
from __future__ import annotations


import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm


@pytest.fixture
def coupled(block, tool) -> h.Simulation:
    """A stiff simulation, which the implicit coupling needs. Its material has no size effect of thin chips."""
    block.set_materials(h.MaterialTable([h.Material("plain")]))
    return h.Simulation(block, tool, h.SimulationConfig(reference_stiffness=1e16, contact_time=h.ContactTime.end))


def test_a_probe_feels_what_a_step_would_and_changes_nothing(block):
    material = h.Material("smooth", cutting_ratio=0.0, static_friction=0.0, dynamic_friction=0.0)
    block.set_materials(h.MaterialTable([material]))
    config = h.SimulationConfig(reference_stiffness=1e12, contact_time=h.ContactTime.end, contact_damping=0.0)
    simulation = h.Simulation(block, h.Tool(h.SphereHead(1.5 * mm)), config)
    place = np.array([0.013, 0.007, 1.0]) * mm

    def probe(p):
        return simulation.probe(h.Pose.from_translation(p), np.zeros(6), 1e-3)

    there = probe(place)
    slope = -(probe(place + [0, 0, 1e-6]).wrench.force - probe(place - [0, 0, 1e-6]).wrench.force) / 2e-6
    assert there.stiffness.shape == (6, 6) and np.allclose(
        there.stiffness, there.stiffness.T, atol=1e-5 * np.abs(there.stiffness).max())
    # 5 %: voxels at the rim of the contact count fully or not at all.
    assert there.stiffness[2, 2] == pytest.approx(slope[2], rel=0.05)
    assert there.contact.voxels > 100 and there.contact.level_of_detail == 1 and simulation.steps == 0
    contact = there.contact
    assert np.allclose(contact.normal_W, [0, 0, 1], atol=0.02)
    assert np.allclose(contact.point_W[:2], place[:2], atol=0.05 * mm)
    assert contact.pressure == pytest.approx(there.wrench.force[2] / contact.area, rel=0.3)  # the normals differ
    felt = simulation.step(h.Pose.from_translation(place), np.zeros(6), 1e-3)
    assert np.allclose(there.wrench.force, felt.model.force, rtol=1e-5)
    assert there.sliding is False  # nothing rubs
    still, pose = np.zeros(6), h.Pose.from_translation(place)
    # Laws other than FoundationLaw are probed only along the requested motions.
    for law, has_rotations in ((h.FoundationLaw(), True), (h.ContactMechanicsLaw(2e6), False)):
        own = h.Simulation(block, h.Tool(h.SphereHead(1.5 * mm)), h.SimulationConfig(law=law))
        straight = own.probe(pose, still, 1e-3, h.ProbedMotions.translations)
        assert straight.stiffness[2, 2] > 0 and straight.stiffness[3:].any() == has_rotations
        assert own.probe(pose, still, 1e-3, motions=h.ProbedMotions.all).wrench.force[2] == straight.wrench.force[2]


def test_an_input_is_checked_before_the_step():
    config, pose, still = h.SimulationConfig(), np.eye(4), np.zeros(6)
    assert h.check_input(config, pose, still, 1e-3) == 0
    assert h.check_input(config, pose, still, 1.0) == int(h.StepStatus.dt_rejected)
    assert h.check_input(config, pose, [np.nan, 0, 0, 0, 0, 0], 1e-3) == int(h.StepStatus.velocity_rejected)
    pose[0, 0] = 2
    assert h.check_input(config, pose, still, 1e-3) == int(h.StepStatus.pose_rejected)


def test_a_tool_that_was_left_waits_for_its_hand(coupled, plunge):
    gains = h.coupling_gains(h.device.capabilities(h.device.device_model("touch")))
    coupling = h.VirtualCoupling(coupled, gains)
    coupling.run(*plunge, 1e-3)
    place, still = coupling.last_result.X_WH, np.zeros(6)
    near, far, free = (plunge[0][-1].copy() for _ in range(3))
    far[2, 3] -= 3e-3
    free[2, 3] += 30e-3
    coupling.park(h.VirtualCoupling.Rejoin.near)
    for pose, waits in ((far, True), (near, False), (far, False)):
        result = coupling.step(pose, still, 1e-3)
        assert bool(result.status & h.StepStatus.tool_waits) == waits
        assert (np.abs(result.X_WH - place).max() == 0) == waits
    coupling.park(h.VirtualCoupling.Rejoin.free)
    assert coupling.step(near, still, 1e-3).status & h.StepStatus.tool_waits
    assert not coupling.step(free, still, 1e-3).status & h.StepStatus.tool_waits

    world = h.loop.gains_in_world(gains, h.loop.WorkspaceMapOptions(scale=2.0, force_scale=0.5))
    assert world.stiffness == gains.stiffness and world.max_force == 2 * gains.max_force
    coupling.set_gains(world)
    assert coupling.gains.max_force == world.max_force
    with pytest.raises(h.Error):
        coupling.set_gains(h.CouplingGains(mass=-1.0))


def test_a_run_that_only_waits_says_so(coupled):
    coupling = h.VirtualCoupling(coupled, h.coupling_gains(h.device.capabilities(h.device.device_model("touch"))))
    inside = h.Pose.from_translation(np.tile([0, 0, 20 * mm], (20, 1)))  # the head is below the handle
    with pytest.warns(UserWarning, match="none of the 20 steps was made: tool_waits"):
        coupling.run(inside, np.zeros((20, 6)), 1e-3)


def test_a_coupling_holds_the_tool_on_stiff_material(coupled, block, tool, plunge):
    poses = np.concatenate([plunge[0], np.repeat(plunge[0][-1:], 1500, axis=0)])  # the hand then stays
    velocities = np.concatenate([plunge[1], np.zeros((1500, 6))])
    gains = h.coupling_gains(h.device.capabilities(h.device.device_model("touch")))
    h.validate(gains)
    coupling = h.VirtualCoupling(coupled, gains)
    trace = coupling.run(poses, velocities, 1e-3)
    assert coupling.simulation is coupled and coupling.gains.stiffness == gains.stiffness
    assert trace["X_WH"].shape == (2100, 4, 4) and trace["hand"]["force"].shape == (2100, 3)
    assert trace["hand"]["force"][-1, 2] > 0 and not (trace["status"] & h.kRejected).any()
    # The hand leads the tool by the deflection of the coupling's spring.
    behind = trace["X_WH"][-1, 2, 3] - poses[-1, 2, 3]
    assert 0 < behind * gains.stiffness == pytest.approx(trace["coupling"]["force"][-1, 2], rel=0.1)  # 10 %: the damper
    assert trace["removed_voxels"].sum() == len(coupled.removed_in_run) > 0

    other = h.VirtualCoupling(h.Simulation(block, tool, coupled.config), gains)
    removed = []
    for row, pose, velocity in zip(trace, poses, velocities):
        result = other.step(pose, velocity, 1e-3)
        assert np.array_equal(result.hand.force, row["hand"]["force"]) and np.array_equal(result.X_WH, row["X_WH"])
        removed += zip(result.removed_voxels.tolist(), result.removed_materials.tolist())
    assert [(r["index"].tolist(), r["material"]) for r in coupled.removed_in_run] == removed
    origins, complete = result.changed_blocks
    assert origins.shape[1] == 3 and complete and result.sub_ticks >= 1 and result.newton_steps >= 1
    assert result.level_of_detail == 1 and result.newton_steps + result.sub_ticks <= coupling.worst_case().contacts
    assert not result.status & h.kRejected and result.removed_volume > 0 and result.V_WH.shape == (6,)
    energy = coupling.last_result.energy
    # 1e-3: the remainder of the Newton iteration.
    assert energy.hand_work == other.last_result.energy.hand_work > 0 and abs(energy.closure()) < 1e-3
    assert energy.turnover >= energy.hand_work
    parts = energy.tool_work + energy.spring + energy.damper + energy.kinetic + energy.implicit
    assert energy.imbalance() == pytest.approx(energy.hand_work - parts, abs=1e-12)
    assert result.coupling.force.shape == (3,)
    other.reset()
    assert np.allclose(other.step(poses[0], velocities[0], 1e-3).X_WH, poses[0], atol=0.5 * 2e-6)  # starts again
    with pytest.raises(h.Error, match="contact_time"):
        h.VirtualCoupling(h.Simulation(block, tool), gains)
    with pytest.raises(h.Error, match="mass"):
        h.validate(h.CouplingGains(mass=-1.0))
    with pytest.raises(h.Error, match=r"poses.*float32"):
        coupling.run(poses.astype(np.float32), velocities, 1e-3)


def test_the_pressed_ball_runs_without_the_interpreter():
    touch = h.device.device_model("touch")
    config = h.analysis.ClosedLoopConfig(device=touch, hand=h.device.hand_model("nominal"))
    ball = h.analysis.PressedBall(coupling=h.coupling_gains(h.device.capabilities(touch)), voxel_size=0.2 * mm)
    models = h.analysis.contact_models(ball)
    wrench = models(1e12)(h.device.DeviceState(X_BS=h.Pose.from_translation([0, 0, 0.5 * mm])))
    assert isinstance(models, h.analysis.ModelFactory) and isinstance(models(1e12), h.analysis.ForceModel)
    assert wrench.force[2] >= 0
    search = h.analysis.pressed_search(ball)
    assert search.target[2, 3] < 0
    search.window, search.windows = 0.1, 2
    assert h.analysis.is_stable(config, models, 1e12, search)
    pressed = h.analysis.PressTest(height=ball.radius, seconds=0.3, measured=0.1)
    assert h.analysis.measure_buzz(config, models, 1e12, pressed).max_force > 0
    dropped = h.analysis.BounceTest(height=ball.radius, phases=1, time_limit=0.1)
    bounced = h.analysis.measure_bounce(config, models, 1e12, dropped)
    assert bounced.peak_force > 0
    with pytest.raises(h.Error, match="factory.*type int"):
        h.analysis.is_stable(config, 3, 1e12)
    with pytest.raises(h.Error, match="the factory returned.*type int"):
        h.analysis.is_stable(config, lambda stiffness: 3, 1e12)
    with pytest.raises(h.Error, match="radius"):
        h.analysis.contact_models(h.analysis.PressedBall(radius=-1.0))(1.0)
    seen = []
    loop = h.analysis.ClosedLoop(config)
    loop.reset(np.eye(4))
    loop.read()
    loop.write(h.Wrench([0, 0, 1], [0, 0, 0]), lambda plant, applied: seen.append(plant.pose[2, 3]))
    assert len(seen) > 1 and seen[-1] > seen[0] >= 0


def test_a_guard_counts_its_ticks_and_notes_what_happened():
    guard = h.safety.SafetyGuard(h.device.capabilities(h.device.device_model("touch")))
    guard.start()
    guard.admit(h.device.DeviceState(sequence=7))
    before = guard.heartbeat
    guard.limit(h.Wrench())
    guard.report_exception()
    assert guard.period == h.safety.GuardOptions().period == 1e-3
    exception = h.safety.SafetyEvent.exception
    assert guard.heartbeat == before + 1 and guard.log.count(exception) == 1 and guard.log.dropped == 0
    [entry] = [entry for entry in guard.drain_log() if entry.event == exception]
    assert entry.sequence == 7 and h.safety.sentence_of(entry) in h.device.describe(entry)
    assert not guard.log.drain()


def test_a_device_plays_readings_again():
    readings = [h.device.DeviceState(X_BS=h.Pose.from_translation([0, 0, 1e-5 * n]), time=1e-3 * n, sequence=n + 1)
                for n in range(50)]
    device = h.device.PlaybackDevice(readings, name="again")
    heights = []
    report = device.run(lambda s: heights.append(s.X_BS[2, 3]) or h.device.DeviceCommand(),
                        h.device.RunOptions(simulated_time=True))
    assert report.period == 1e-3 and not report.warnings
    assert device.size() == len(device) == report.ticks == 50 and device.name == "again"
    assert heights == pytest.approx([1e-5 * n for n in range(50)])
    with pytest.raises(h.Error):
        h.device.PlaybackDevice([])
    mock = h.device.open_device("mock:press")
    assert mock.plant.device.name == h.device.MockOptions().device.name or mock.plant.options.period == 1e-3
