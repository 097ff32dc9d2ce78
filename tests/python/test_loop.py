# SPDX-License-Identifier: Apache-2.0
"""The loop in its own thread: commands while it runs, exchanges, requests, recordings."""
from __future__ import annotations

import math
import time

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm

needs_io = pytest.mark.skipif(not h.io.kWithIo, reason="hapticut was built without file formats (HAPTICUT_WITH_IMPORT)")
FACING = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]  # the device's y axis points up, along z of the world


@pytest.fixture
def coupled(block, tool) -> h.Simulation:
    """A stiff simulation, which the implicit coupling needs."""
    return h.Simulation(block, tool, h.SimulationConfig(reference_stiffness=1e16, contact_time=h.ContactTime.end))


def driven(simulation, device, **undo):
    """A model whose device is above the block, with the device's y axis up."""
    X_WB, X_SH = np.eye(4), np.eye(4)
    X_WB[:3, :3] = FACING
    X_WB[2, 3] = (1.5 + 20) * mm + 8 * mm
    X_SH[:3, :3] = np.transpose(FACING)  # the tool stands upright
    gains = h.coupling_gains(h.device.capabilities(h.device.device_model("touch")))
    workspace = h.loop.WorkspaceMapOptions(X_WB=X_WB, X_SH=X_SH)
    options = h.loop.SimulationModelOptions(map=workspace, coupling=gains, **undo)
    return h.loop.SimulationModel(simulation, device, options)


def down_and_up(t):
    """12 mm downwards in 1.5 s, along the device's y axis."""
    return h.Pose.from_translation([0, -8e-3 * min(max(t - 0.3, 0.0), 1.5), 0])


def test_a_loop_drives_a_simulation_in_a_thread_of_its_own(coupled):
    device = h.device.MockDevice(h.device.MockOptions(path=down_and_up, device=h.device.device_model("touch")))
    model = driven(coupled, device)
    run = h.device.RunOptions(seconds=2.5, simulated_time=True)
    loop = h.loop.RealtimeLoop(model, h.loop.RealtimeLoopOptions(run=run, region=model.region))
    assert not loop.is_running and not model.region.empty()
    assert loop.send(h.loop.commands.SetSpindleSpeed(500.0)) and loop.send(h.loop.commands.SetScale(1.0))
    loop.start()
    refused, blocks, clutched = 0, {}, False
    while loop.is_running:
        if not clutched and loop.latest().tick > 0:  # opens and closes the clutch, far above the block
            clutched = loop.send(h.loop.commands.OpenClutch()) and loop.send(h.loop.commands.CloseClutch())
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
    assert refused > 0 and clutched and 2500 <= report.ticks <= 2501
    assert report.fault == h.device.DeviceFault.none, report.end
    snapshot = loop.latest()
    tool = snapshot.tool
    assert snapshot.tick >= 2499 and snapshot.device.valid and snapshot.arming == h.safety.ArmingState.on
    assert snapshot.commands_dropped == 0 and snapshot.X_WT.shape == (4, 4) and snapshot.commands_refused == 0
    assert tool.steps == coupled.steps > 0 and tool.contact_voxels > 0 and tool.contact_depth > 0
    assert tool.removed_volume == pytest.approx(coupled.removed_volume_by_material.sum()) and tool.removed_volume > 0
    most, now = tool.max_effort, tool.effort
    assert tool.contact_point_W.shape == (3,) and tool.contact_point_W.any()
    assert most.sub_ticks >= now.sub_ticks >= 1 and most.newton_steps >= now.newton_steps >= 1 == most.level_of_detail
    assert tool.force[2] > 0 and tool.torque.shape == (3,) and tool.spindle_speed > 0
    assert tool.status & h.kRejected == 0 == tool.status_seen & h.kRejected
    assert snapshot.output.applied.force.any() and snapshot.blocks_waiting >= 0
    assert 0 < np.linalg.norm(snapshot.output.applied.force) <= snapshot.max_applied
    assert 0 < snapshot.max_applied <= snapshot.max_commanded
    assert coupled.last_input.dt > 0  # the loop has released the simulation
    assert blocks
    for block in blocks.values():
        assert block.version > 0 and block.material.shape == block.fill.shape == (8, 8, 8) and block.workpiece == 0
    if snapshot.blocks_waiting == 0:  # the last received blocks show the present state
        for block in blocks.values():
            box = h.IndexBox(block.origin, [i + 7 for i in block.origin])
            assert np.array_equal(block.material, coupled.workpiece.material_array(box)) and block.version > 0
            assert np.array_equal(block.fill, coupled.workpiece.fill_array(box))


def test_a_cut_is_undone_while_the_loop_goes_on(coupled):
    whole = coupled.workpiece.hash()
    device = h.device.MockDevice(h.device.MockOptions(path=down_and_up, device=h.device.device_model("touch")))
    model = driven(coupled, device, undo_blocks=4000, undo_blocks_per_tick=1)
    with pytest.raises(h.Error, match="driven directly"):
        h.loop.SimulationModel(coupled, device)
    assert coupled.workpiece.undo_blocks == 4000
    loop = h.loop.RealtimeLoop(model, h.loop.RealtimeLoopOptions(run=h.device.RunOptions(simulated_time=True)))
    assert loop.send(h.loop.commands.SetUndoMark())
    loop.start()

    def wait_for(condition):
        deadline = time.monotonic() + 60
        while not condition(loop.latest().tool) and time.monotonic() < deadline:
            time.sleep(1e-3)
        tool = loop.latest().tool
        assert condition(tool)
        return tool

    assert wait_for(lambda tool: tool.removed_volume > 1e-9).undo_marks == 1
    loop.send(h.loop.commands.SetSpindleSpeed(0.0))
    loop.send(h.loop.commands.Undo())
    assert wait_for(lambda tool: tool.undo_marks == 0 and not tool.undoing).removed_volume > 1e-9
    assert loop.send(h.loop.commands.Redo())
    assert wait_for(lambda tool: tool.undo_marks == 1 and not tool.redoing).redo_marks == 0
    loop.send(h.loop.commands.Undo())
    assert wait_for(lambda tool: tool.undo_marks == 0 and not tool.undoing).redo_marks == 1
    report = loop.stop()
    assert report.events["model_swapped"] > 1 and report.fault == h.device.DeviceFault.none
    assert coupled.workpiece.hash() == whole


def test_a_loop_of_ones_own_cuts_nothing_before_there_is_a_force(coupled):
    interlock = h.loop.SpindleInterlock()
    states, speed = h.safety.ArmingState, coupled.spindle_setting
    interlock.update(coupled, states.wait_free)
    assert coupled.spindle_is_held and coupled.spindle_setting == speed != 0
    assert not interlock.admits(states.ramp, True) and interlock.admits(states.ramp, False)
    interlock.update(coupled, states.on)
    assert not coupled.spindle_is_held
    interlock.interrupt()
    assert not interlock.admits(states.on, True)
    coupled.hold_spindle(True)
    coupled.set_spindle_speed(100.0)
    assert coupled.spindle_is_held and coupled.spindle_setting == 100


def test_everything_may_be_exchanged_while_the_loop_goes_on(coupled):
    device = h.device.MockDevice(h.device.MockOptions(path=down_and_up, device=h.device.device_model("touch")))
    model = driven(coupled, device, undo_blocks=1000)
    options = h.loop.RealtimeLoopOptions(run=h.device.RunOptions(simulated_time=True), region=model.region)
    loop = h.loop.RealtimeLoop(model, options)
    voxel, config = coupled.workpiece.voxel_size, coupled.config
    ball = h.Tool(h.SphereHead(2 * mm), spindle=h.Spindle(200.0))
    materials = h.MaterialTable(coupled.workpiece.materials.all())
    other = coupled.workpiece.clone()
    loop.start()
    c = h.loop.commands
    commands = [c.SetTool(ball, voxel, config), model.prepare_tool(ball), c.SetMaterials(materials, config),
                model.prepare_materials(materials), c.SetFriction(h.DryFriction(0.4, 0.3, 1000.0)), c.SetFriction(),
                c.SetEffects(h.effects.Effects()), c.SetForceMask(h.effects.AxisMask(force=[True, True, False])),
                c.SetForceMask(), c.SetRemoval(h.RemovalLaw.none), c.SetRemoval(h.RemovalLaw.constant_energy),
                c.HoldForce(), c.HoldForce(hold=False), c.ExchangeWorkpiece(other, ball, config),
                model.prepare_workpiece(other, ball)]
    assert str(commands[-2].bounds) == str(commands[-1].bounds) and repr(c.Undo()) == "commands.Undo()"
    of_other_tests = {"SetSpindleSpeed", "OpenClutch", "CloseClutch", "SetScale", "SetUndoMark", "Undo", "Redo"}
    unsent = {name for name in dir(c) if name[0].isupper()} - {type(one).__name__ for one in commands} - of_other_tests
    commands += [getattr(c, name)() for name in sorted(unsent)]
    for command in commands:  # one at a time: the tick of an exchange has no force
        assert loop.send(command)
        after = loop.latest().tick + 2
        while loop.latest().tick < after:
            time.sleep(1e-4)
    with pytest.raises(h.Error, match="already sent"):
        loop.send(commands[0])
    with pytest.raises(h.Error, match="SetScale"):
        loop.send(h.loop.commands.SetScale(-1.0))
    with pytest.raises(TypeError):
        loop.send("stop")
    assert loop.send(h.loop.commands.SetTool(ball, 2 * voxel, config)) and loop.send(h.loop.commands.Redo())
    deadline = time.monotonic() + 60
    while loop.latest().commands_refused < 2 and time.monotonic() < deadline:
        time.sleep(1e-3)
    snapshot = loop.latest()
    assert snapshot.commands_refused == 2 and snapshot.tool.workpiece == 2 and not snapshot.tool.force_held
    assert snapshot.blocks_outside == 0
    assert loop.stop().events["model_swapped"] >= 1
    assert coupled.tool.head.max_radius() == 2 * mm


def test_a_simulation_is_given_another_tool_and_other_materials(coupled):
    coupled.set_tool(h.Tool(h.SphereHead(2 * mm), spindle=h.Spindle(200.0)))
    assert coupled.tool.head.max_radius() == 2 * mm and coupled.spindle_setting == 200.0
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
    requests = h.safety.Requests()
    requests.stop(), requests.reset_fault(), requests.emergency_stop()
    assert requests.stop_wanted and requests.emergency and not requests.reset_wanted
    requests.reset_fault()
    assert requests.reset_wanted and requests.emergency  # the emergency stop stays until the guard reads the reset


def test_a_loop_may_be_stopped_and_told_that_something_is_wrong(coupled):
    device = h.device.MockDevice(h.device.MockOptions(path=h.device.scripted_path("rest"),
                                                      device=h.device.device_model("touch")))
    loop = h.loop.RealtimeLoop(driven(coupled, device))
    loop.start()
    with pytest.raises(h.Error):
        loop.start()
    loop.requests.emergency_stop()
    deadline = time.monotonic() + 30
    while loop.latest().arming != h.safety.ArmingState.fault and time.monotonic() < deadline:
        time.sleep(1e-3)
    report = loop.stop()
    assert report.events.get("emergency_stop", 0) > 0 and report.wake_up.count > 0 and report.missed >= 0
    assert report.arming in (h.safety.ArmingState.fault, h.safety.ArmingState.off)
    coupled.step(np.eye(4), np.zeros(6), 1e-3)  # the loop has released the simulation
    forgotten = h.loop.RealtimeLoop(driven(coupled, device))
    forgotten.start()
    del forgotten  # stops the loop and releases the simulation
    coupled.step(np.eye(4), np.zeros(6), 1e-3)


@needs_io
def test_a_recorded_loop_is_replayed_and_played_back(coupled, tmp_path):
    capabilities = h.device.capabilities(h.device.device_model("touch"))
    device = h.device.MockDevice(h.device.MockOptions(path=down_and_up, device=h.device.device_model("touch")))
    with h.io.Recorder(tmp_path / "loop.h5", coupled, h.io.RecorderOptions(wait_when_full=True), driven_by=device):
        run = h.device.RunOptions(seconds=1.5, simulated_time=True)
        loop = h.loop.RealtimeLoop(driven(coupled, device), h.loop.RealtimeLoopOptions(run=run))
        loop.start()
        report = loop.wait()
    recording = h.io.read_recording(tmp_path / "loop.h5")
    assert recording.has_device and recording.capabilities.peak_force == capabilities.peak_force
    info = recording.info
    assert info.device == "mock" and info.format == h.io.kRecordingFormat and info.lost == 0 and info.remarks == []
    assert info.version == h.build_info().version and info.commit == h.build_info().commit
    assert info.compiler and info.cpu and info.begun.endswith("Z") and not recording.effects[0].effects.vibration
    replayed = h.io.replay(recording)
    assert replayed.identical and replayed.max_force_difference == 0
    again = h.device.open_device(f"replay:{tmp_path / 'loop.h5'}")
    assert isinstance(again, h.device.PlaybackDevice) and len(again) == len(recording) <= report.ticks
    assert again.run(lambda s: h.device.DeviceCommand(), h.device.RunOptions(simulated_time=True)).ticks == len(again)
    assert h.io.open_playback(tmp_path / "loop.h5").size() == len(again)
    assert len(h.io.open_playback(tmp_path / "loop.h5", h.io.PlaybackRange(100, 50))) == 50
    assert h.io.PlaybackRange().first == 0
    assert h.io.PlaybackRange().count >= h.io.kMaxPlayedSteps >= 3_600_000  # an hour
    with pytest.raises(h.Error, match="none to play back"):
        h.io.open_playback(tmp_path / "loop.h5", h.io.PlaybackRange(first=len(recording)))
    with pytest.raises(h.Error, match="gone.h5"):
        h.device.open_device(f"replay:{tmp_path / 'gone.h5'}")


@needs_io
def test_a_coupled_tool_is_recorded_step_by_step(coupled, plunge, tmp_path):
    coupling = h.VirtualCoupling(coupled, h.CouplingGains())
    recorder = h.io.Recorder(tmp_path / "coupled.h5", coupled, h.io.RecorderOptions(wait_when_full=True))
    for pose, velocity in zip(*plunge):
        felt = coupling.step(pose, velocity, 1e-3).hand
    recorder.close()
    fresh = h.Simulation(coupled.workpiece, coupled.tool, coupled.config)
    first = h.io.Recorder(tmp_path / "first.h5", fresh)
    with pytest.raises(h.Error, match="already observes"):
        h.io.Recorder(tmp_path / "second.h5", fresh)
    first.close()
    recording = h.io.read_recording(tmp_path / "coupled.h5")
    assert recorder.recorded == len(plunge[0]) and h.io.replay(recording).identical
    last = recording.read(len(recording) - 1)["trace"]
    assert np.array_equal(last["force"][0], felt.force) and not np.array_equal(last["model"]["force"][0], felt.force)
    tick = h.loop.DeviceTick(state=h.device.DeviceState(sequence=3), arming=h.safety.ArmingState.on)
    assert tick.state.sequence == 3 and tick.output.changes == 0


@needs_io
def test_a_loop_of_ones_own_says_what_the_device_did(simulation, plunge, tmp_path):
    options = h.io.RecorderOptions(device="mine", wait_when_full=True)
    with h.io.Recorder(tmp_path / "own.h5", simulation, options) as recorder:
        recorder.set_device_tick(h.loop.DeviceTick(state=h.device.DeviceState(sequence=3, time=7.0)))
        simulation.step(plunge[0][0], plunge[1][0], 1e-3)
    recording = h.io.read_recording(tmp_path / "own.h5")
    assert recording.has_device and recording.read()["trace"]["time"][0] == 7.0


@needs_io
def test_a_replay_by_another_law_says_where_it_leaves_the_recording(simulation, plunge, tmp_path):
    with h.io.Recorder(tmp_path / "a.h5", simulation, h.io.RecorderOptions(wait_when_full=True)) as recorder:
        recorder.run(*plunge, 1e-3)
    report = h.io.replay(h.io.read_recording(tmp_path / "a.h5"), h.ThesisLaw(h.ThesisLaw.Constants(damping=2.0)))
    difference = report.first_difference
    assert not report.identical and report.max_force_difference > 0 and math.isfinite(difference.replayed)
    assert 0 <= difference.step < 600 and difference.column and difference.element >= 0
    assert difference.recorded != difference.replayed
