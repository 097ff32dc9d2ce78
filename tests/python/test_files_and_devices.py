# SPDX-License-Identifier: Apache-2.0
"""Files, recordings, devices and the closed loop."""
from __future__ import annotations

import math
import struct

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm

needs_io = pytest.mark.skipif(not h.io.kWithIo, reason="hapticut was built without file formats (HAPTICUT_WITH_IMPORT)")


@needs_io
def test_meshes_and_pictures_go_to_files(block, tmp_path):
    surface = h.extract_surface(block)
    h.io.write_stl(surface.mesh, tmp_path / "a.stl")
    h.io.write_ply(surface.mesh, tmp_path / "a.ply")
    colored = h.io.colored(surface, block.materials)
    h.io.write_ply(colored, tmp_path / "b.ply")
    h.io.write_obj(surface.mesh, tmp_path / "a.obj")
    [named] = h.io.read_mesh(tmp_path / "a.ply")
    h.io.write_obj([named, named], tmp_path / "two.obj")
    assert [n.name for n in h.io.read_mesh(tmp_path / "two.obj")] == ["object 1", "object 2"]
    assert np.array_equal(h.io.read_mesh(tmp_path / "a.obj")[0].mesh.triangles, named.mesh.triangles)
    assert isinstance(named.name, str) and np.allclose(named.mesh.vertices.max(axis=0), [3 * mm, 3 * mm, 0], atol=1e-6)
    h.io.write_picture([colored], h.io.PictureOptions(width=200, height=150), tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG"
    assert isinstance(h.io.material_color("enamel"), h.Color)


@needs_io
def test_what_a_file_does_not_say_is_a_remark_and_a_warning(tmp_path):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, 2, 2, 2, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 2, 8)  # unsigned bytes
    struct.pack_into("<4f", header, 76, 1, 1, 1, 1)
    struct.pack_into("<f", header, 108, 352)
    header[344:347] = b"n+1"
    (tmp_path / "a.nii").write_bytes(bytes(header) + bytes(8))
    with pytest.warns(UserWarning, match="does not say how its axes lie in the patient"):
        volume = h.io.read_label_volume(tmp_path / "a.nii")
    assert len(volume.remarks) == 1


@needs_io
def test_volumes_are_worked_on(tmp_path, block):
    grey = h.volume.GreyVolume(np.arange(8 * 9 * 10, dtype=np.float32).reshape(8, 9, 10), [1 * mm] * 3)
    h.io.write_nrrd(grey, tmp_path / "grey.nrrd")
    again = h.io.read_grey_volume(tmp_path / "grey.nrrd", h.io.VolumeReadOptions(spacing=[2 * mm] * 3))
    assert np.array_equal(again.values, grey.values) and np.allclose(again.spacing, 2 * mm) and again.padding == 0
    assert np.allclose(h.volume.with_spacing(grey, [3 * mm] * 3).spacing, 3 * mm)
    assert h.volume.crop_to_samples(grey, h.IndexBox([1, 1, 1], [3, 4, 5])).dims == (3, 4, 5)
    assert h.volume.box_around(grey, 700.0).max == [7, 8, 9]
    assert h.volume.grey_range(grey) == [0, 719] and h.volume.count_from(grey, 700) == 20
    assert h.volume.count_labels(grey) == {}
    assert np.allclose(h.volume.box_of_volume(grey).max, [7.5 * mm, 8.5 * mm, 9.5 * mm])
    assert h.volume.crop_to_box(grey, h.Box([3 * mm] * 3, [4 * mm] * 3)).dims == (6, 6, 6)
    assert h.volume.count_from(h.volume.keep_largest_component(grey, 700), 700) == 20
    labels = h.volume.label_range(grey, 100.0, 200.0, 5)
    assert h.volume.count_labels(labels) == {0: 620, 5: 100} and h.volume.unused_label(labels) == 6
    assert set(np.unique(labels.values)) == {0, 5} and np.count_nonzero(labels.values) == 100
    assert h.volume.resample(grey, 2 * mm).dims == (4, 5, 5)
    assert h.volume.resample(labels, 0.5 * mm, h.volume.LabelInterpolation.smooth).dims == (16, 18, 20)
    shell = np.zeros((9, 9, 9), np.uint8)
    shell[1:8, 1:8, 1:8] = 1
    shell[3:6, 3:6, 3:6] = 0
    shell[0, 0, 0] = 1
    volume = h.volume.keep_largest_component(h.volume.LabelVolume(shell, [1 * mm] * 3))
    assert volume.values[0, 0, 0] == 0
    assert np.count_nonzero(h.volume.fill_cavities(volume, 2).values == 2) == 27
    assert np.count_nonzero(h.volume.close_gaps(volume, 1 * mm, 2).values == 2) > 0
    assert np.allclose(h.volume.with_spacing(volume, [2 * mm] * 3).spacing, 2 * mm)
    assert h.volume.crop_to_samples(volume, h.volume.box_around(volume)).dims == (7, 7, 7)
    h.io.write_nrrd(block, tmp_path / "work.nrrd")
    assert (tmp_path / "work_density.nrrd").exists()
    (tmp_path / "raw").write_bytes(bytes(range(24)))
    layout = h.io.RawLayout(dims=[2, 3, 4], spacing=[1 * mm] * 3, type=h.io.ValueType.uint8)
    assert h.io.read_raw_grey_volume(tmp_path / "raw", layout).values[1, 2, 3] == 23
    assert h.io.read_raw_label_volume(tmp_path / "raw", layout).values[1, 0, 0] == 1
    with pytest.raises(h.Error):
        h.io.read_color_slices(tmp_path / "nothing", {(1, 2, 3): 4}, [1 * mm] * 3)
    assert h.io.kMaxVolumeSamples > 0


def test_vdb_files_of_others_need_to_say_what_they_are(block, tmp_path):
    h.io.save_vdb(block, tmp_path / "a.vdb")
    with pytest.raises(h.Error, match="hapticut wrote it"):
        h.io.load_vdb(tmp_path / "a.vdb", h.io.VdbImport(h.presets.clay(), grid="density"))
    bytes_ = (tmp_path / "a.vdb").read_bytes()
    # The file then looks like one of another program.
    (tmp_path / "a.vdb").write_bytes(bytes_.replace(b"hapticut_format", b"Hapticut_format"))
    how = h.io.VdbImport(h.presets.clay(), grid="density", kind=h.io.VdbImport.Kind.fog_volume)
    assert h.io.load_vdb(tmp_path / "a.vdb", how).solid_voxels() == block.solid_voxels()
    assert (how.material.name, how.grid, how.unit_mm, how.kind.name) == ("clay", "density", 1.0, "fog_volume")
    how.grid = "nowhere"
    with pytest.raises(h.Error, match="nowhere"):
        h.io.load_vdb(tmp_path / "a.vdb", how)


@needs_io
def test_recordings_are_replayed_bit_by_bit(simulation, plunge, tmp_path):
    poses, velocities = plunge
    options = h.io.RecorderOptions(note="test", wait_when_full=True)
    with h.io.Recorder(tmp_path / "a.h5", simulation, options) as recorder:
        first = recorder.step(poses[0], velocities[0], 1e-3)
        trace = recorder.run(poses[1:].copy(), velocities[1:].copy(), 1e-3)
        assert recorder.lost == 0 and not recorder.failed
    assert recorder.recorded == len(poses)
    recording = h.io.read_recording(tmp_path / "a.h5")
    assert len(recording) == len(poses) and recording.info.note == "test" and recording.info.closed
    assert not recording.has_device and recording.default_law and recording.path.name == "a.h5"
    assert recording.info.workpiece_hash_at_end == simulation.workpiece.hash()
    assert repr(recording.tool) == repr(simulation.tool) and recording.config.reference_stiffness == 1e16
    assert recording.effects[0].first_step == 0
    columns = recording.read()
    assert np.array_equal(columns["poses"], poses) and np.array_equal(columns["trace"]["force"][1:], trace["force"])
    assert np.array_equal(columns["trace"]["force"][0], first.force) and len(recording.read(590)["dt"]) == 10
    seen = []
    report = h.io.replay(recording, progress=seen.append)
    assert report.identical and report.steps == len(poses) and report.first_difference is None
    assert report.workpiece_hash == simulation.workpiece.hash() and report.skipped == 0
    other = h.io.simulation_of(recording)
    again = other.run(columns["poses"], columns["velocities"], columns["dt"])
    assert np.array_equal(again["force"][1:], trace["force"])
    assert recording.workpiece().hash() != other.workpiece.hash()
    h.io.write_csv(recording, tmp_path / "a.csv")
    h.io.write_npz(recording, tmp_path / "a.npz")
    h.io.write_wav(recording, tmp_path / "a.wav", 8000)
    assert (tmp_path / "a.wav").stat().st_size == pytest.approx(44 + 2 * 8 * len(poses), abs=2)
    assert len((tmp_path / "a.csv").read_text().splitlines()) == len(poses) + 1
    assert len(np.load(tmp_path / "a.npz")["force"]) == len(poses) and h.io.kRecordingFormat >= 1
    with pytest.raises(h.Error, match="another recorder"):
        h.io.Recorder(tmp_path / "b.h5", simulation)
    with pytest.raises(h.Error):
        h.io.read_recording(tmp_path / "a.csv")


@needs_io
def test_a_second_recorder_of_a_file_is_refused(simulation, plunge, tmp_path):
    poses, velocities = plunge
    other = h.Simulation(simulation.workpiece.clone(), simulation.tool, simulation.config)
    options = h.io.RecorderOptions(wait_when_full=True)
    (tmp_path / "link.h5").symlink_to(tmp_path / "a.h5")
    for _ in range(2):  # a new file, then over an older recording
        with h.io.Recorder(tmp_path / "a.h5", simulation, options) as recorder:
            for name in ("a.h5", "link.h5"):
                with pytest.raises(h.Error, match="still writing"):
                    h.io.Recorder(tmp_path / name, other, options)
            recorder.run(poses, velocities, 1e-3)
        del recorder
        assert len(h.io.read_recording(tmp_path / "a.h5")) == len(poses)
        simulation.reset(simulation.workpiece.clone())
    with h.io.Recorder(tmp_path / "link.h5", other, options) as recorder:
        recorder.step(poses[0], velocities[0], 1e-3)
    assert len(h.io.read_recording(tmp_path / "a.h5")) == 1


@needs_io
def test_a_held_spindle_is_recorded(simulation, plunge, tmp_path):
    poses, velocities = plunge
    simulation.hold_spindle(True)
    assert simulation.is_fresh
    with h.io.Recorder(tmp_path / "a.h5", simulation, h.io.RecorderOptions(wait_when_full=True)) as recorder:
        for n, (pose, velocity) in enumerate(zip(poses, velocities)):
            if n % 100 == 50:
                simulation.hold_spindle(not simulation.spindle_is_held)
            recorder.step(pose, velocity, 1e-3)
    assert not simulation.is_fresh
    assert h.io.replay(h.io.read_recording(tmp_path / "a.h5")).identical


def test_a_mock_device_runs_a_function_of_python():
    device = h.device.open_device("mock:press,device=touch,hand=nominal")
    assert device.capabilities.peak_force > 0 and device.name.startswith("mock")
    wall = h.analysis.LinearWall(stiffness=300.0)
    ticks = []

    def tick(state):
        assert state.valid and state.X_BS.shape == (4, 4) and not state.pressed(0)
        ticks.append(state.time)
        return h.device.DeviceCommand(wall(state))

    report = device.run(tick, h.device.RunOptions(seconds=5, simulated_time=True))
    assert report.ticks == len(ticks) and report.end and report.fault == h.device.DeviceFault.none
    assert device.output.commanded.force[2] > 0 and device.output.changes >= 0
    assert report.compute.count == report.ticks and report.compute.quantile(0.5) <= report.compute.max
    assert report.compute.buckets.shape == (2000,) and report.compute.min <= report.compute.mean
    assert "engaged" in report.events and device.count(h.safety.SafetyEvent.engaged) == report.events["engaged"]
    assert any(entry.event == h.safety.SafetyEvent.engaged for entry in report.log) and h.device.describe(report.log[0])
    assert h.safety.sentence_of(report.log[0]) in h.device.describe(report.log[0])
    assert not device.is_running and isinstance(report.warnings, list)
    assert device.state.X_BS.shape == (4, 4) and device.arming == h.safety.ArmingState.off
    device.stop(), device.emergency_stop(), device.reset_fault(), device.interrupt(h.safety.SafetyEvent.reclutched)
    assert isinstance(device.drain_log(), list)


def test_a_tick_that_gives_no_command_says_what_it_must_give():
    device = h.device.open_device("mock:rest")
    for what in (None, h.Wrench()):
        with pytest.raises(TypeError, match="return DeviceCommand"):
            device.run(lambda state, what=what: what, h.device.RunOptions(seconds=1, simulated_time=True))


def test_an_exception_in_a_tick_comes_out_of_the_run():
    device = h.device.MockDevice(h.device.MockOptions(path=h.device.scripted_path("rest")))

    def tick(state):
        raise KeyError("in the loop")

    with pytest.raises(KeyError, match="in the loop"):
        device.run(tick, h.device.RunOptions(seconds=1, simulated_time=True))
    with pytest.raises(h.Error, match="mock"):
        h.device.open_device("nonsense")
    assert {driver["scheme"] for driver in h.device.device_drivers()} >= {"mock", "mouse"}


@pytest.mark.parametrize("path", [lambda t: {}["gone"], lambda t: np.zeros(3)])
def test_a_path_that_fails_takes_the_force_away_and_says_so(path, monkeypatch):
    import sys

    errors = []
    monkeypatch.setattr(sys, "unraisablehook", lambda what: errors.append(what.exc_value))
    device = h.device.MockDevice(h.device.MockOptions(path=path))
    forces = []
    push = h.device.DeviceCommand(h.Wrench([1, 0, 0]))
    report = device.run(lambda s: forces.append(device.output.applied.force.any()) or push,
                        h.device.RunOptions(seconds=0.2, simulated_time=True))
    assert errors and "pose_not_finite" in report.events and not any(forces)


def test_a_path_and_a_mouse_may_come_from_python():
    options = h.device.MockOptions(path=lambda t: h.Pose.from_translation([0, 0, 1e-3 * t]), end=0.1)
    assert options.path(2.0)[2, 3] == 2e-3 and h.device.MockOptions().path is None
    heights = []
    h.device.MockDevice(options).run(lambda s: heights.append(s.X_BS[2, 3]) or h.device.DeviceCommand(),
                                     h.device.RunOptions(simulated_time=True))
    assert heights[-1] == pytest.approx(1e-4, rel=0.05)
    mouse = h.device.MouseDevice(h.device.MouseOptions(hand="firm"))
    mouse.pointer_moved(20.0, 0.0), mouse.wheel_turned(1.0), mouse.button(0, True)
    mouse.key(h.device.MoveKey.left, True)
    mouse.key(h.device.MoveKey.left, False)
    mouse.run(lambda s: h.device.DeviceCommand(), h.device.RunOptions(seconds=0.2, simulated_time=True))
    assert mouse.set_point.shape == (3,)
    assert isinstance(h.device.open_mock("rest"), h.device.MockDevice)


def test_models_maps_and_the_guard():
    assert "touch" in [model.name for model in h.device.device_models()] and h.device.hand_model("firm").mass > 0
    assert "nominal" in [model.name for model in h.device.hand_models()]
    touch = h.device.device_model("touch")
    touch.name = "mine"
    assert touch.name == "mine" and h.device.device_model("touch").name == "touch"
    assert h.device.capabilities(touch).peak_force == touch.peak_force
    options = h.loop.WorkspaceMapOptions(scale=2.0)
    mapped = h.loop.WorkspaceMap(options)
    X = h.Pose.from_translation([1e-3, 0, 0])
    mapped.place(np.eye(4), np.eye(4))
    assert np.allclose(mapped.to_world(X)[0, 3], 2e-3) and mapped.engaged and mapped.scale == 2.0
    assert np.allclose(mapped.to_world(X, np.array([1.0, 0, 0, 0, 0, 0])), [2, 0, 0, 0, 0, 0])
    assert mapped.to_device(X, h.Wrench([1, 0, 0], [0, 0, 0])).force[0] == 1 and mapped.felt_stiffness(10.0) == 20.0
    mapped.disengage(X)
    assert not mapped.engaged
    mapped.engage(X)
    assert mapped.set_scale(3.0, X) and not mapped.set_scale(-1.0, X)

    limits = h.safety.output_limits(h.device.capabilities(h.device.device_model("touch")), max_contact_speed=0.5)
    assert limits.max_force == 3.3 and limits.force_growth == 437.5 and np.isinf(limits.max_torque)
    config = h.SimulationConfig.for_device(h.device.capabilities(h.device.device_model("touch")))
    assert config.device_stiffness == 700 and config.effects.limits.max_force == limits.max_force
    with pytest.raises(h.Error, match="states no stiffness"):
        h.SimulationConfig.for_device(h.device.DeviceCapabilities())
    guard = h.safety.SafetyGuard(h.device.capabilities(h.device.device_model("touch")))
    guard.start()
    for n in range(40):
        admitted = guard.admit(h.device.DeviceState(time=1e-3 * n, sequence=n))
        applied = guard.limit(h.Wrench())
    assert admitted.valid and not applied.force.any() and not guard.repeats
    guard.admit(admitted), guard.limit(h.Wrench())
    assert guard.repeats
    assert guard.state in (h.safety.ArmingState.ramp, h.safety.ArmingState.on)
    guard.report_applied(applied), guard.requests.emergency_stop(), guard.requests.reset_fault()
    guard.requests.interrupt(h.safety.SafetyEvent.reclutched)
    assert guard.count(h.safety.SafetyEvent.armed) >= 1 and guard.drain_log()
    assert guard.slew > 0 and guard.max_force > 0
    assert guard.output.changes >= 0
    guard.stop()
    histogram = h.loop.LatencyHistogram()
    histogram.add(5e-6)
    assert histogram.count == 1 and histogram.longer == 0 and histogram.max == 5e-6
    assert histogram.at_least(4e-6) == 1 and histogram.at_least(6e-6) == 0


def test_the_closed_loop_finds_the_limit_of_colgate_and_schenkel():
    config = h.analysis.ClosedLoopConfig(device=h.device.device_model("premium15"), hand=h.device.hand_model("released"))

    def wall(stiffness):
        return h.analysis.LinearWall(stiffness=stiffness, one_sided=False)

    found = h.analysis.max_stable_stiffness(config, wall, h.analysis.StabilitySearch(low=50, high=200))
    # 2 %: the windows of the search are finite.
    assert found == pytest.approx(2 * config.device.damping / config.period, rel=0.02)
    assert h.analysis.is_stable(config, wall, 0.5 * found) and not h.analysis.is_stable(config, wall, 1.2 * found)
    one_sided = lambda stiffness: h.analysis.LinearWall(stiffness=stiffness)  # noqa: E731
    bounced = h.analysis.measure_bounce(config, one_sided, 500.0, h.analysis.BounceTest(phases=2))
    assert bounced.penetration > 0 and bounced.generated_energy >= 0 and bounced.peak_force > 0
    assert bounced.restitution >= bounced.mean_restitution
    held = h.analysis.ClosedLoopConfig(device=h.device.device_model("touch"), hand=h.device.hand_model("nominal"))
    buzz = h.analysis.measure_buzz(held, one_sided, 200.0, h.analysis.PressTest(seconds=1.0, measured=0.5))
    assert buzz.position_rms < 50e-6 and buzz.frequency >= 0 and buzz.generated_power < 5e-3
    assert not buzz.buzzes() and math.isfinite(buzz.force_peak_to_peak)
    options = h.safety.GuardOptions(stiffness=300.0)
    assert len(h.analysis.injected_faults()) == len(h.analysis.InjectedFault.__members__)
    response = h.analysis.measure_fault_response(held, one_sided, 300.0, options, h.analysis.InjectedFault.unplugged)
    assert 0 <= response.time_to_zero < 0.1 and response.oldest_force <= 0.05 and response.max_growth >= 0
    assert response.max_force <= held.device.peak_force
    guard = h.safety.SafetyGuard(h.device.capabilities(held.device), options)
    assert h.analysis.obeys_the_rules(response, guard, 1e-3)
    assert response.end in list(h.safety.ArmingState.__members__.values())


def test_a_plant_and_a_closed_loop_step_by_step():
    plant = h.device.Plant(h.device.device_model("touch"), h.device.hand_model("released"))
    plant.reset(np.eye(4)), plant.set_target(np.eye(4)), plant.set_velocity([0.1, 0, 0])
    assert plant.kinetic_energy > 0 and np.allclose(plant.target, np.eye(4))
    plant.advance(h.Wrench()), plant.advance_fine(h.Wrench())
    assert plant.pose[0, 3] > 0 and np.allclose(plant.measured_pose, plant.pose) and plant.velocity.shape == (6,)
    assert plant.device.name == "touch" and plant.hand.name == "released" and plant.options.period == 1e-3
    loop = h.analysis.ClosedLoop(h.analysis.ClosedLoopConfig(device=plant.device, hand=plant.hand))
    loop.reset(np.eye(4))
    loop.read()
    loop.write(h.Wrench([1, 0, 0], [0, 0, 0]))
    loop.miss_tick(0.5)
    loop.tick(lambda state: h.Wrench())
    assert loop.plant.pose[0, 3] > 0 and loop.generated_energy > 0 and loop.device_dissipation > 0
    with pytest.raises(h.Error, match="model: an object of type NoneType was given; it must be a LinearWall or"):
        loop.tick(None)
    with pytest.raises(h.Error, match="the force model returned an object of type NoneType; it must return a Wrench"):
        loop.tick(lambda state: None)
    with pytest.raises(h.Error, match="it must return a Wrench"):
        h.analysis.is_stable(loop.config, lambda stiffness: lambda state: None, 100.0)
    with pytest.raises(ZeroDivisionError):
        loop.tick(lambda state: 1 / 0)
    assert loop.applied.force.shape == (3,) and loop.config.delay == 0
    wall = h.analysis.LinearWall(stiffness=1.0)
    wall.stiffness, wall.damping, wall.filter, wall.one_sided, wall.height = 2.0, 0.0, 0.0, True, 0.1
    assert wall(h.device.DeviceState()).force[2] == pytest.approx(0.2)
