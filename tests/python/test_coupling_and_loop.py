# SPDX-License-Identifier: Apache-2.0
"""Between a device and a simulation: probe, virtual coupling, the stages of the guard, the loop in its own thread."""
from __future__ import annotations

import math
import time

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm

needs_io = pytest.mark.skipif(not h.kWithIo, reason="hapticut was built without file formats (HAPTICUT_WITH_IO)")
FACING = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]  # the device's y is up, the world's z


@pytest.fixture
def coupled(block, tool) -> h.Simulation:
    """A stiff simulation, as an implicit coupling wants it."""
    return h.Simulation(block, tool, h.SimulationConfig(reference_stiffness=1e14, contact_time=h.ContactTime.end))


def test_a_probe_feels_what_a_step_would_and_changes_nothing(block):
    material = h.Material("smooth", cutting_ratio=0.0, static_friction=0.0, dynamic_friction=0.0)
    block.set_materials(h.MaterialTable([material]))
    config = h.SimulationConfig(reference_stiffness=1e12, contact_time=h.ContactTime.end)
    simulation = h.Simulation(block, h.Tool(h.SphereHead(1.5 * mm)), config)
    place = np.array([0.013, 0.007, 1.0]) * mm

    def probe(p):
        return simulation.probe(h.Pose.from_translation(p), np.zeros(6), 1e-3)

    there = probe(place)
    slope = -(probe(place + [0, 0, 1e-6]).wrench.force - probe(place - [0, 0, 1e-6]).wrench.force) / 2e-6
    assert there.stiffness.shape == (6, 6) and np.allclose(there.stiffness, there.stiffness.T)
    # 5 %: the voxels at the rim of the contact count whole or not at all.
    assert there.stiffness[2, 2] == pytest.approx(slope[2], rel=0.05)
    assert there.contact.voxels > 100 and there.contact.turns == 1 and simulation.steps == 0
    felt = simulation.step(h.Pose.from_translation(place), np.zeros(6), 1e-3)
    assert np.allclose(there.wrench.force, felt.model.force, rtol=1e-5)
    assert there.sliding is False  # nothing rubs
    still, pose = np.zeros(6), h.Pose.from_translation(place)
    for law, turns in ((None, True), (h.ContactMechanicsLaw(2e6), False)):  # a law of one's own is asked for no more
        own = h.Simulation(block, h.Tool(h.SphereHead(1.5 * mm)), h.SimulationConfig(law=law))
        straight = own.probe(pose, still, 1e-3, h.ProbedMotions.translations)
        assert straight.stiffness[2, 2] > 0 and straight.stiffness[3:].any() == turns
        assert own.probe(pose, still, 1e-3, motions=h.ProbedMotions.all).wrench.force[2] == straight.wrench.force[2]


def test_an_input_is_checked_before_the_step():
    config, pose, still = h.SimulationConfig(), np.eye(4), np.zeros(6)
    assert h.check_input(config, pose, still, 1e-3) == 0
    assert h.check_input(config, pose, still, 1.0) == int(h.StepStatus.dt_rejected)
    assert h.check_input(config, pose, [np.nan, 0, 0, 0, 0, 0], 1e-3) == int(h.StepStatus.velocity_rejected)
    pose[0, 0] = 2
    assert h.check_input(config, pose, still, 1e-3) == int(h.StepStatus.pose_rejected)


def test_a_coupling_holds_the_tool_on_stiff_material(coupled, block, tool, plunge):
    poses = np.concatenate([plunge[0], np.repeat(plunge[0][-1:], 1500, axis=0)])  # and stays
    velocities = np.concatenate([plunge[1], np.zeros((1500, 6))])
    gains = h.coupling_gains(h.capabilities(h.device_model("touch")))
    h.validate(gains)
    coupling = h.VirtualCoupling(coupled, gains)
    trace = coupling.run(poses, velocities, 1e-3)
    assert coupling.simulation is coupled and coupling.gains.stiffness == gains.stiffness
    assert trace["X_WH"].shape == (2100, 4, 4) and trace["hand"]["force"].shape == (2100, 3)
    assert trace["hand"]["force"][-1, 2] > 0 and not (trace["status"] & h.kRejected).any()
    # The hand is ahead of the tool, by what the coupling's spring gives.
    behind = trace["X_WH"][-1, 2, 3] - poses[-1, 2, 3]
    assert 0 < behind * gains.stiffness == pytest.approx(trace["coupling"]["force"][-1, 2], rel=0.1)  # and the damper
    assert trace["removed_voxels"].sum() == len(coupled.removed_in_run) > 0

    other = h.VirtualCoupling(h.Simulation(block, tool, coupled.config), gains)
    removed = []
    for row, pose, velocity in zip(trace, poses, velocities):
        result = other.step(pose, velocity, 1e-3)
        assert np.array_equal(result.hand.force, row["hand"]["force"]) and np.array_equal(result.X_WH, row["X_WH"])
        removed += zip(result.removed_voxels.tolist(), result.removed_materials.tolist())
    assert [(r["index"].tolist(), r["material"]) for r in coupled.removed_in_run] == removed
    origins, complete = result.changed_blocks
    assert origins.shape[1] == 3 and complete and result.parts >= 1 and result.newton_steps >= 1
    assert not result.status & h.kRejected and result.removed_volume > 0 and result.velocity.shape == (6,)
    energy = coupling.last_result.energy
    assert energy.hand_work == other.last_result.energy.hand_work > 0 and abs(energy.closure()) < 1e-3  # Newton's rest
    parts = energy.tool_work + energy.spring + energy.damper + energy.kinetic + energy.implicit
    assert energy.imbalance() == pytest.approx(energy.hand_work - parts, abs=1e-12)
    assert result.coupling.force.shape == (3,)
    other.release()
    assert np.allclose(other.step(poses[0], velocities[0], 1e-3).X_WH, poses[0], atol=0.5 * 2e-6)  # afresh
    with pytest.raises(h.Error, match="contact_time"):
        h.VirtualCoupling(h.Simulation(block, tool), gains)
    with pytest.raises(h.Error, match="mass"):
        h.validate(h.CouplingGains(mass=-1.0))
    with pytest.raises(h.Error, match=r"poses.*float32"):
        coupling.run(poses.astype(np.float32), velocities, 1e-3)


def test_the_contact_bench_runs_without_the_interpreter():
    touch = h.device_model("touch")
    config = h.ClosedLoopConfig(device=touch, hand=h.hand_model("nominal"))
    bench = h.ContactBench(coupling=h.coupling_gains(h.capabilities(touch)), voxel_size=0.2 * mm)
    models = h.contact_models(bench)
    wrench = models(1e12)(h.DeviceState(X_BS=h.Pose.from_translation([0, 0, 0.5 * mm])))
    assert isinstance(models, h.ModelFactory) and isinstance(models(1e12), h.ForceModel) and wrench.force[2] >= 0
    search = h.pressed_search(bench)
    assert search.target[2, 3] < 0
    search.window, search.windows = 0.1, 2
    assert h.is_stable(config, models, 1e12, search)
    assert h.press(config, models, 1e12, h.PressTest(height=bench.radius, seconds=0.3, measured=0.1)).greatest_force > 0
    bounced = h.bounce(config, models, 1e12, h.BounceTest(height=bench.radius, phases=1, time_limit=0.1))
    assert bounced.peak_force > 0
    with pytest.raises(h.Error, match="factory.*type int"):
        h.is_stable(config, 3, 1e12)
    with pytest.raises(h.Error, match="the factory returned.*type int"):
        h.is_stable(config, lambda stiffness: 3, 1e12)
    with pytest.raises(h.Error, match="radius"):
        h.contact_models(h.ContactBench(radius=-1.0))(1.0)
    seen = []
    loop = h.ClosedLoop(config)
    loop.reset(np.eye(4))
    loop.read()
    loop.write(h.Wrench([0, 0, 1], [0, 0, 0]), lambda plant, applied: seen.append(plant.pose[2, 3]))
    assert len(seen) > 1 and seen[-1] > seen[0] >= 0


def test_the_stages_of_the_guard_by_themselves():
    log = h.SafetyLog()
    log.begin_tick(0.5, 7)
    log.report(h.SafetyEvent.saturated, 3.0)
    [entry] = log.drain()
    assert (entry.time, entry.sequence, entry.event, entry.value) == (0.5, 7, h.SafetyEvent.saturated, 3.0)
    assert log.count(h.SafetyEvent.saturated) == 1 and log.dropped == 0

    gate = h.PoseGate(h.capabilities(h.device_model("touch")))
    verdicts = [gate.check(h.DeviceState(sequence=1), 1e-3, log)]
    far = h.DeviceState(X_BS=h.Pose.from_translation([0.05, 0, 0]), sequence=2)
    verdicts.append(gate.check(far, 1e-3, log))
    assert verdicts == [h.PoseGate.Verdict.accepted, h.PoseGate.Verdict.held] and np.array_equal(gate.state.X_BS, np.eye(4))
    gate.restart()
    assert gate.check(far, 1e-3, log) == h.PoseGate.Verdict.accepted and gate.state.X_BS[0, 3] == 0.05

    arming = h.Arming(h.ArmingOptions(ramp=0.1))
    arming.start(log)
    shares = [arming.tick(1e-3, True, 0.0, 0.0, log) for _ in range(150)]
    assert arming.state == h.ArmingState.on and shares[0] == 0 and shares[-1] == 1 and sorted(shares) == shares
    arming.interrupt(h.SafetyEvent.reclutched, True, log, 1.0)
    assert arming.state == h.ArmingState.wait_free
    arming.fail(log, 2.0)
    assert arming.state == h.ArmingState.fault
    arming.reset(log)
    assert arming.state != h.ArmingState.fault
    arming.stop()
    assert arming.state == h.ArmingState.off

    # A force that pushes the hand along does work on it: the model generates, and is damped.
    passive = h.PassivityController(h.PassivityOptions(), 3.0)
    push, way = np.array([0, 0, 2.0]), np.array([0, 0, 1e-3])
    for _ in range(5):
        damped = passive.control(push, push, way, 1e-3)
    assert passive.stored < 0 < passive.taken and damped[2] < push[2]
    passive.restart()
    assert passive.stored == 0

    budget = h.ThermalBudget(3.3, 0.88)
    assert budget.limit == 3.3 and not budget.is_limiting
    for _ in range(3600):
        budget.tick(3.3, 0.0, 0.1)
    assert budget.is_limiting and budget.limit < 1

    watchdog = h.Watchdog()
    verdict = h.Watchdog.Verdict
    late = [watchdog.verdict(ticks * watchdog.options.period) for ticks in (1, 5, 20, 100)]
    assert late == [verdict.alive, verdict.late, verdict.fading, verdict.dead]
    assert watchdog.scale(0) == 1 and 0 < watchdog.scale(0.02) < 1 and watchdog.scale(1.0) == 0

    guard = h.SafetyGuard(h.capabilities(h.device_model("touch")))
    guard.start()
    guard.admit(h.DeviceState(sequence=1))
    before = guard.heartbeat
    guard.release(h.Wrench())
    guard.report_exception()
    assert guard.heartbeat == before + 1 and guard.log.count(h.SafetyEvent.exception) == 1
    for seconds in (1e-3, 5e-3, 20e-3, 100e-3):
        guard.report_silence(watchdog.verdict(seconds), watchdog.scale(seconds))
    guard.log.note(h.SafetyEvent.motors_warm, 0.8)
    said = [entry.event for entry in guard.drain_log()][-4:]
    assert said == [h.SafetyEvent.watchdog_late, h.SafetyEvent.watchdog_fading, h.SafetyEvent.watchdog_fault,
                    h.SafetyEvent.motors_warm]
    assert not h.WatchdogOptions().latch and h.WatchdogOptions(latch=True).latch


def test_a_device_plays_readings_again():
    readings = [h.DeviceState(X_BS=h.Pose.from_translation([0, 0, 1e-5 * n]), time=1e-3 * n, sequence=n + 1)
                for n in range(50)]
    device = h.PlaybackDevice(readings, name="again")
    heights = []
    report = device.run(lambda s: heights.append(s.X_BS[2, 3]) or h.DeviceCommand(), h.RunOptions(simulated_time=True))
    assert device.size() == len(device) == report.ticks == 50 and device.name == "again"
    assert heights == pytest.approx([1e-5 * n for n in range(50)])
    with pytest.raises(h.Error):
        h.PlaybackDevice([])
    mock = h.open_device("mock:press")
    assert mock.plant.device.name == h.MockOptions().device.name or mock.plant.options.period == 1e-3


def driven(simulation, device, **undo):
    """The device above the block, its y axis up."""
    X_WB, X_SH = np.eye(4), np.eye(4)
    X_WB[:3, :3] = FACING
    X_WB[2, 3] = (1.5 + 20) * mm + 8 * mm
    X_SH[:3, :3] = np.transpose(FACING)  # the tool stands upright
    options = h.SimulationModelOptions(map=h.WorkspaceMapOptions(X_WB=X_WB, X_SH=X_SH),
                                       coupling=h.coupling_gains(h.capabilities(h.device_model("touch"))), **undo)
    return h.SimulationModel(simulation, device, options)


def down_and_up(t):
    """12 mm downwards in 1.5 s, along the device's y axis."""
    return h.Pose.from_translation([0, -8e-3 * min(max(t - 0.3, 0.0), 1.5), 0])


def test_a_loop_drives_a_simulation_in_a_thread_of_its_own(coupled):
    device = h.MockDevice(h.MockOptions(path=down_and_up, device=h.device_model("touch")))
    model = driven(coupled, device)
    run = h.RunOptions(seconds=2.5, simulated_time=True)
    loop = h.RealtimeLoop(model, h.RealtimeLoopOptions(run=run, region=model.region))
    assert not loop.is_running and not model.region.empty()
    assert loop.send(h.commands.SetSpindleSpeed(500.0)) and loop.send(h.commands.SetScale(1.0))
    loop.start()
    refused, blocks, clutched = 0, {}, False
    while loop.is_running:
        if not clutched and loop.latest().tick > 0:  # lets go and takes it again, far above
            clutched = loop.send(h.commands.OpenClutch()) and loop.send(h.commands.CloseClutch())
        try:
            coupled.step(np.eye(4), np.zeros(6), 1e-3)
        except h.Error as error:
            assert "another thread" in str(error)
            refused += 1
        while (block := loop.receive()) is not None:
            blocks[tuple(block.origin)] = block
        time.sleep(1e-3)
    report = loop.wait()
    while (block := loop.receive()) is not None:
        blocks[tuple(block.origin)] = block
    assert refused > 0 and clutched and 2500 <= report.ticks <= 2501 and report.fault == h.DeviceFault.none, report.end
    snapshot = loop.latest()
    tool = snapshot.tool
    assert snapshot.tick >= 2499 and snapshot.device.valid and snapshot.arming == h.ArmingState.on
    assert snapshot.commands_dropped == 0 and snapshot.X_WT.shape == (4, 4) and snapshot.commands_refused == 0
    assert tool.steps == coupled.steps > 0 and tool.contact_voxels > 0 and tool.contact_depth > 0
    assert tool.removed_volume == pytest.approx(coupled.removed_volume_by_material.sum()) and tool.removed_volume > 0
    assert tool.force[2] > 0 and tool.torque.shape == (3,) and tool.spindle_speed > 0
    assert tool.status & h.kRejected == 0 == tool.seen & h.kRejected
    assert snapshot.output.applied.force.any() and snapshot.blocks_waiting >= 0
    assert coupled.last_input.dt > 0  # ours again
    assert blocks
    for block in blocks.values():
        assert block.version > 0 and block.material.shape == block.fill.shape == (8, 8, 8) and block.workpiece == 0
    if snapshot.blocks_waiting == 0:  # what was received last is what is there
        for block in blocks.values():
            box = h.IndexBox(block.origin, [i + 7 for i in block.origin])
            assert np.array_equal(block.material, coupled.workpiece.material_array(box)) and block.version > 0
            assert np.array_equal(block.fill, coupled.workpiece.fill_array(box))


def test_a_cut_is_undone_while_the_loop_goes_on(coupled):
    whole = coupled.workpiece.hash()
    device = h.MockDevice(h.MockOptions(path=down_and_up, device=h.device_model("touch")))
    model = driven(coupled, device, undo_blocks=4000, undo_blocks_per_tick=1)
    h.SimulationModel(coupled, device)  # reserves nothing, and takes nothing away
    assert coupled.workpiece.undo_blocks == 4000
    loop = h.RealtimeLoop(model, h.RealtimeLoopOptions(run=h.RunOptions(simulated_time=True)))
    assert loop.send(h.commands.SetUndoMark())
    loop.start()

    def wait_for(condition):
        deadline = time.monotonic() + 60
        while not condition(loop.latest().tool) and time.monotonic() < deadline:
            time.sleep(1e-3)
        tool = loop.latest().tool
        assert condition(tool)
        return tool

    assert wait_for(lambda tool: tool.removed_volume > 1e-9).undo_marks == 1
    loop.send(h.commands.SetSpindleSpeed(0.0))
    loop.send(h.commands.Undo())
    assert wait_for(lambda tool: tool.undo_marks == 0 and not tool.undoing).removed_volume > 1e-9
    assert loop.send(h.commands.Redo())
    assert wait_for(lambda tool: tool.undo_marks == 1 and not tool.redoing).redo_marks == 0
    loop.send(h.commands.Undo())
    assert wait_for(lambda tool: tool.undo_marks == 0 and not tool.undoing).redo_marks == 1
    report = loop.stop()
    assert report.events["model_swapped"] > 1 and report.fault == h.DeviceFault.none
    assert coupled.workpiece.hash() == whole


def test_everything_may_be_exchanged_while_the_loop_goes_on(coupled):
    device = h.MockDevice(h.MockOptions(path=down_and_up, device=h.device_model("touch")))
    model = driven(coupled, device, undo_blocks=1000)
    loop = h.RealtimeLoop(model, h.RealtimeLoopOptions(run=h.RunOptions(simulated_time=True), region=model.region))
    voxel, config = coupled.workpiece.voxel_size, coupled.config
    ball = h.Tool(h.SphereHead(2 * mm), spindle=h.Spindle(200.0))
    materials = h.MaterialTable(coupled.workpiece.materials.all())
    other = coupled.workpiece.clone()
    loop.start()
    commands = [h.commands.SetTool(ball, voxel, config), model.prepare_tool(ball), h.commands.SetMaterials(materials, config),
                model.prepare_materials(materials), h.commands.SetFriction(h.DryFriction(0.4, 0.3, 1000.0)),
                h.commands.SetFriction(), h.commands.SetEffects(h.Effects()),
                h.commands.SetForceMask(h.AxisMask(force=[True, True, False])), h.commands.SetForceMask(),
                h.commands.SetRemoval(h.RemovalLaw.none), h.commands.SetRemoval(h.RemovalLaw.constant_energy),
                h.commands.HoldForce(), h.commands.HoldForce(hold=False), h.commands.ExchangeWorkpiece(other, ball, config),
                model.prepare_workpiece(other, ball)]
    assert commands[-2].bounds == commands[-1].bounds and repr(h.commands.Undo()) == "commands.Undo()"
    for command in commands:
        assert loop.send(command)
    with pytest.raises(h.Error, match="sent already"):
        loop.send(commands[0])
    with pytest.raises(h.Error, match="SetScale"):
        loop.send(h.commands.SetScale(-1.0))
    with pytest.raises(TypeError):
        loop.send("stop")
    assert loop.send(h.commands.SetTool(ball, 2 * voxel, config)) and loop.send(h.commands.Redo())
    deadline = time.monotonic() + 60
    while loop.latest().commands_refused < 2 and time.monotonic() < deadline:
        time.sleep(1e-3)
    snapshot = loop.latest()
    assert snapshot.commands_refused == 2 and snapshot.tool.workpiece == 2 and not snapshot.tool.force_held
    assert snapshot.blocks_outside == 0
    assert loop.stop().events["model_swapped"] >= 1
    assert coupled.tool.head.largest_radius() == 2 * mm


def test_a_simulation_is_given_another_tool_and_other_materials(coupled):
    coupled.set_tool(h.Tool(h.SphereHead(2 * mm), spindle=h.Spindle(200.0)))
    assert coupled.tool.head.largest_radius() == 2 * mm and coupled.spindle_setting == 200.0
    with pytest.raises(h.Error):
        coupled.set_tool(h.Tool(h.SphereHead(1e-6)))
    coupled.set_materials(h.MaterialTable(coupled.workpiece.materials.all()))
    with pytest.raises(h.Error):
        coupled.set_materials(h.MaterialTable())
    coupled.set_friction(h.DryFriction(0.4, 0.3, 1000.0))
    assert coupled.config.friction.static_friction == 0.4
    coupled.set_friction(None)
    coupled.set_removal(h.RemovalLaw.none)
    coupled.halt_spindle()
    assert coupled.spindle_setting == 0 and coupled.workpiece_exchanges == 5
    assert coupled.redo_marks == 0 and coupled.redo(1)


def test_requests_are_a_mailbox():
    requests = h.Requests()
    requests.stop(), requests.reset_fault(), requests.emergency_stop()
    assert requests.stop_wanted and requests.emergency and not requests.reset_wanted
    assert not requests.take_reset()
    requests.reset_fault(), requests.forget_stop()
    assert requests.take_reset() and not requests.emergency and not requests.stop_wanted
    requests.interrupt(h.SafetyEvent.model_swapped)
    assert requests.take_interruption() == h.SafetyEvent.model_swapped


def test_a_loop_may_be_stopped_and_told_that_something_is_wrong(coupled):
    device = h.MockDevice(h.MockOptions(path=h.scripted_path("rest"), device=h.device_model("touch")))
    loop = h.RealtimeLoop(driven(coupled, device))
    loop.start()
    with pytest.raises(h.Error):
        loop.start()
    loop.requests.emergency_stop()
    deadline = time.monotonic() + 30
    while loop.latest().arming != h.ArmingState.fault and time.monotonic() < deadline:
        time.sleep(1e-3)
    report = loop.stop()
    assert report.events.get("emergency_stop", 0) > 0 and report.wake_up.count > 0 and report.missed >= 0
    assert report.guard in (h.ArmingState.fault, h.ArmingState.off)
    coupled.step(np.eye(4), np.zeros(6), 1e-3)  # ours again
    forgotten = h.RealtimeLoop(driven(coupled, device))
    forgotten.start()
    del forgotten  # stops, and lets go
    coupled.step(np.eye(4), np.zeros(6), 1e-3)


@needs_io
def test_a_recorded_loop_is_replayed_and_played_back(coupled, tmp_path):
    capabilities = h.capabilities(h.device_model("touch"))
    device = h.MockDevice(h.MockOptions(path=down_and_up, device=h.device_model("touch")))
    with h.Recorder(tmp_path / "loop.h5", coupled, h.RecorderOptions(wait_when_full=True), driven_by=device):
        run = h.RunOptions(seconds=1.5, simulated_time=True)
        loop = h.RealtimeLoop(driven(coupled, device), h.RealtimeLoopOptions(run=run))
        loop.start()
        report = loop.wait()
    recording = h.read_recording(tmp_path / "loop.h5")
    assert recording.has_device and recording.capabilities.peak_force == capabilities.peak_force
    info = recording.info
    assert info.device == "mock" and info.format == h.kRecordingFormat and info.lost == 0 and info.remarks == []
    assert info.version == h.build_info().version and info.commit == h.build_info().commit
    assert info.compiler and info.cpu and info.begun.endswith("Z") and not recording.effects[0].effects.vibration
    replayed = h.replay(recording)
    assert replayed.identical and replayed.largest_force_difference == 0
    again = h.open_device(f"replay:{tmp_path / 'loop.h5'}")
    assert isinstance(again, h.PlaybackDevice) and len(again) == len(recording) <= report.ticks
    assert again.run(lambda s: h.DeviceCommand(), h.RunOptions(simulated_time=True)).ticks == len(again)
    assert h.open_playback(tmp_path / "loop.h5").size() == len(again)
    assert len(h.open_playback(tmp_path / "loop.h5", h.PlaybackRange(100, 50))) == 50
    assert h.PlaybackRange().first == 0 and h.PlaybackRange().count >= h.kMostPlayedSteps >= 3_600_000  # an hour
    with pytest.raises(h.Error, match="none to play back"):
        h.open_playback(tmp_path / "loop.h5", h.PlaybackRange(first=len(recording)))
    with pytest.raises(h.Error, match="gone.h5"):
        h.open_device(f"replay:{tmp_path / 'gone.h5'}")


@needs_io
def test_a_coupled_tool_is_recorded_step_by_step(coupled, plunge, tmp_path):
    coupling = h.VirtualCoupling(coupled, h.CouplingGains())
    recorder = h.Recorder(tmp_path / "coupled.h5", coupled, h.RecorderOptions(wait_when_full=True))
    for pose, velocity in zip(*plunge):
        felt = coupling.step(pose, velocity, 1e-3).hand
    with pytest.raises(h.Error, match="observed already"):
        h.Recorder(tmp_path / "second.h5", h.Simulation(coupled.workpiece, coupled.tool, coupled.config))
        h.Recorder(tmp_path / "second.h5", coupled)
    recorder.close()
    recording = h.read_recording(tmp_path / "coupled.h5")
    assert recorder.recorded == len(plunge[0]) and h.replay(recording).identical
    last = recording.read(len(recording) - 1)["trace"]
    assert np.array_equal(last["force"][0], felt.force) and not np.array_equal(last["model"]["force"][0], felt.force)
    tick = h.DeviceTick(state=h.DeviceState(sequence=3), arming=h.ArmingState.on)
    assert tick.state.sequence == 3 and tick.output.limits == 0


@needs_io
def test_a_loop_of_ones_own_says_what_the_device_did(simulation, plunge, tmp_path):
    options = h.RecorderOptions(device="mine", wait_when_full=True)
    with h.Recorder(tmp_path / "own.h5", simulation, options) as recorder:
        recorder.set_device_tick(h.DeviceTick(state=h.DeviceState(sequence=3, time=7.0)))
        simulation.step(plunge[0][0], plunge[1][0], 1e-3)
    recording = h.read_recording(tmp_path / "own.h5")
    assert recording.has_device and recording.read()["trace"]["time"][0] == 7.0


@needs_io
def test_a_replay_by_another_law_says_where_it_leaves_the_recording(simulation, plunge, tmp_path):
    with h.Recorder(tmp_path / "a.h5", simulation, h.RecorderOptions(wait_when_full=True)) as recorder:
        recorder.run(*plunge, 1e-3)
    report = h.replay(h.read_recording(tmp_path / "a.h5"), h.ThesisLaw(h.ThesisLaw.Constants(damping=2.0)))
    difference = report.first_difference
    assert not report.identical and report.largest_force_difference > 0 and math.isfinite(difference.replayed)
    assert 0 <= difference.step < 600 and difference.column and difference.element >= 0
    assert difference.recorded != difference.replayed
