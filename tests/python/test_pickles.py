# SPDX-License-Identifier: Apache-2.0
"""Copies and pickles: a scene that was built once goes to other processes, and continues there with the same bits."""
from __future__ import annotations

import copy
import inspect
import multiprocessing
import pickle
import types
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
from runs import steps_of
from test_structs import GIVEN, classes

import hapticut as h
from hapticut.units import mm, rpm

WAYS = {"copy": copy.copy, "deepcopy": copy.deepcopy, "pickle": lambda thing: pickle.loads(pickle.dumps(thing))}

# Objects of one process: devices, threads, files, and what grows with a running simulation.
OF_ONE_PROCESS = {
    "ClosedLoop", "Device", "DrillSound", "ExchangeWorkpiece", "ForceLaw", "ForceModel", "HeatCollector",
    "HeatField", "Island", "IslandFinder", "IslandRemoval", "LoopListener", "MockDevice", "ModelFactory",
    "MouseDevice", "Output", "Plant", "PlaybackDevice", "RealtimeLoop", "Recorder", "Recording", "Requests",
    "SafetyGuard", "SafetyLog", "SetMaterials", "SetTool", "SimulationModel", "SpindleInterlock", "SurfacePage",
    "SurfaceStream", "VirtualCoupling", "WorkpieceSnapshot", "WorkspaceMap", "Error", "commands",
}


def pickles(cls: type) -> bool:
    return "__setstate__" in vars(cls) or "__reduce__" in vars(cls) or hasattr(cls, "__members__")


def test_every_class_pickles_or_belongs_to_one_process():
    refusing = {cls.__name__ for cls in classes() if not pickles(cls)}
    assert refusing - OF_ONE_PROCESS == set()
    assert OF_ONE_PROCESS - refusing == set(), "remove these from the list"


def same(a, b) -> bool:
    """Whether two values are equal, array by array and attribute by attribute."""
    if isinstance(a, np.ndarray) and a.dtype.names:  # not the bytes between the fields
        return a.dtype == b.dtype and all(same(a[name], b[name]) for name in a.dtype.names)
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if type(a) is not type(b):
        return False
    if not type(a).__module__.startswith("hapticut") or hasattr(type(a), "__members__"):
        return bool(a == b) or (a != a and b != b)
    names = [name for name in dir(a) if not name.startswith("_") and not inspect.isclass(getattr(type(a), name))]
    values = [(getattr(a, name), getattr(b, name)) for name in names]
    return all(same(x, y) for x, y in values if not isinstance(x, types.MethodType)
               and not inspect.isroutine(x))


def full_values(simulation, plunge):
    """One object of each class that is no plain struct, with numbers in all its fields."""
    simulation.run(plunge[0][:400], plunge[1][:400], 1e-3)
    spindle = h.Spindle(3000.0, power_limit=40.0)
    profile = h.catalogue.wheel_head(4 * mm, 2 * mm, 1.5 * mm)
    mesh = h.mesh_of_revolution(profile.profile(), 24)
    grey = h.volume.GreyVolume(np.arange(24.0).reshape(2, 3, 4), [1e-3, 2e-3, 3e-3],
                               h.Pose.from_translation([1.0, 2.0, 3.0]))
    labels = h.volume.LabelVolume(np.arange(24).reshape(2, 3, 4).T, [1e-3] * 3)
    motor = h.catalogue.SpindleMotor(spindle)
    motor.drive(0.01, 1e-3)
    tool = h.Tool(profile, h.LHandle(length=20 * mm, neck=10 * mm), spindle, h.Cutter())
    law = h.ThesisLaw(h.ThesisLaw.Constants(reference_voxel_size=1e-4))
    vibration = h.effects.Vibration(frequency=120.0, amplitude=0.3)
    config = h.SimulationConfig(law=law, effects=h.effects.Effects(vibration=vibration))
    laws = [law, h.FoundationLaw(), h.ContactMechanicsLaw(1e6), h.HertzianBurrLaw(2e6),
            h.DampingMatrixLaw(h.DampingMatrixLaw.Constants(resistance=1e9, friction=0.2)),
            h.TwistDrillLaw(h.TwistDrillLaw.Constants(specific_energy=1e9, max_feed_per_revolution=1e-3))]
    surface = h.extract_surface(simulation.workpiece)
    device = h.device.open_device("mock:press,hand=nominal")
    options = h.device.RunOptions(seconds=0.2, simulated_time=True)
    report = device.run(lambda state: h.device.DeviceCommand(h.Wrench([0, 0, 0.1], [0, 0, 0])), options)
    head = h.ToolHead(h.SphereHead(1 * mm))
    return [simulation.last_result, simulation.last_result.contact, simulation.last_result.energy,
            simulation.worst_case(), simulation.stage_times, simulation.last_input, simulation.workpiece.amounts(),
            simulation.tool,
            simulation.config, simulation.workpiece.materials, simulation.workpiece.frame, tool, config, profile,
            profile.shape, head, head.spring_at([0, 0, 0.5 * mm]), head.bounding_box(), mesh, grey, labels, motor,
            surface, report, report.wake_up, device.output, device.state, h.build_info(), *laws,
            h.ColoredMesh(mesh, [h.Color(1, 2, n % 256) for n in range(len(mesh.vertices))]),
            h.profile_from_mesh(mesh), simulation.probe(plunge[0][400], plunge[1][400], 1e-3), *GIVEN]


def test_every_value_is_equal_after_it_was_copied_and_pickled(simulation, plunge):
    values = full_values(simulation, plunge)
    for value in values:
        if type(value).__name__ == "BodyDescription":  # holds functions
            continue
        for way, made in WAYS.items():
            assert same(made(value), value), (way, value)
    assert not same(values[0], simulation.step(np.eye(4), np.zeros(6), 1e-3))  # `same` sees differences


@pytest.mark.parametrize("way", WAYS)
def test_a_workpiece_is_the_same_voxel_by_voxel(way, simulation, plunge):
    simulation.run(*plunge, 1e-3)
    for workpiece in (simulation.workpiece, h.build_molar(0.5 * mm)):
        made = WAYS[way](workpiece)
        assert made.hash() == workpiece.hash() and same(made.frame, workpiece.frame)
        assert same(made.materials.all(), workpiece.materials.all())
        voxel = list(workpiece.bounds().min)
        assert same(made.centroid_at(voxel), workpiece.centroid_at(voxel))
        made.reserve_blocks(4)  # its own, not a view of a simulation


def hard_simulation(case):
    """Simulations that keep much from step to step, and the way that their hand goes."""
    block = h.build_block(h.Box([-3 * mm, -3 * mm, -4 * mm], [3 * mm, 3 * mm, 0]), 0.1 * mm, h.presets.cortical_bone())
    config = h.SimulationConfig()
    spindle = h.common_spindle(40000 * rpm)
    if case == "effects":
        config.effects = h.effects.Effects(vibration=h.effects.Vibration(frequency=120.0, amplitude=0.3),
                                           gravity=h.effects.Gravity(), delta_filter=h.effects.DeltaFilter(),
                                           limits=h.effects.OutputLimits(max_force=5.0, force_growth=100.0))
    if case == "standing":  # dry friction has an anchor
        spindle = h.Spindle()
        config.friction = h.DryFriction(0.4, 0.3, 1e5)
    if case == "ramp":
        spindle = h.Spindle(4000.0, acceleration_limit=5000.0, rotor_inertia=1e-7, torque_limit=0.03)
    if case == "budget":
        config.voxel_budget = 4096
    if case == "few_blocks":
        config.reserved_blocks = 40
    head = h.SphereHead(1.5 * mm) if case != "profile" else h.catalogue.pear_head(2 * mm, 4 * mm, 1.2 * mm)
    simulation = h.Simulation(block, h.Tool(head, h.RayHandle(20 * mm), spindle), config)
    if case == "undo":
        simulation.reserve_undo(256)
    ticks = np.arange(1, 801)
    hand = np.zeros((800, 3))
    lowest = 1.5 * mm if case != "profile" else 0.0
    hand[:, 2] = 20 * mm + lowest - np.minimum(0.002 * mm * ticks, 0.9 * mm)
    hand[:, 0] = 0.8 * mm * np.sin(ticks * 0.01)
    velocities = np.zeros((800, 6))
    velocities[:, :3] = np.gradient(hand, 1e-3, axis=0)
    return simulation, h.Pose.from_translation(hand), velocities


@pytest.mark.parametrize("case", ["plain", "effects", "standing", "ramp", "budget", "few_blocks", "profile", "undo"])
@pytest.mark.parametrize("way", WAYS)
def test_a_copy_of_a_simulation_goes_on_with_the_same_bits(way, case):
    simulation, poses, velocities = hard_simulation(case)
    for made in (0, 200, 500):
        done = simulation.steps
        simulation.run(poses[done:made], velocities[done:made], 1e-3)
        if made == 500:
            simulation.set_spindle_speed(simulation.spindle_setting / 2)
            simulation.hold_spindle(True)
        other = WAYS[way](simulation)
        assert other.steps == simulation.steps == made and other.next_step_is_first == simulation.next_step_is_first
        assert same(other.last_result, simulation.last_result) and same(other.removed_in_run, simulation.removed_in_run)
        assert same(other.removed_volume_by_material, simulation.removed_volume_by_material)
        assert same(other.changed_blocks(), simulation.changed_blocks())
        assert other.spindle_is_held == simulation.spindle_is_held
        expected, rows = [], slice(made, made + 150)
        for each in (simulation, other):
            first = each.run(poses[rows], velocities[rows], 1e-3)
            each.hold_spindle(False)
            rest = each.run(poses[made + 150:made + 200], velocities[made + 150:made + 200], 1e-3)
            expected.append((first.tobytes(), rest.tobytes(), each.workpiece.hash(), each.workpiece.reserved_blocks()))
        assert expected[0] == expected[1]
        # Exchanges too: a stiffness that was left to the simulation is chosen again.
        tool = h.Tool(h.SphereHead(0.8 * mm))
        other.set_tool(tool)
        assert other.config.reference_stiffness != simulation.config.reference_stiffness


def test_a_copy_is_separate_and_is_not_recorded(simulation, plunge):
    collector = h.heat.HeatCollector(simulation)
    other = copy.copy(simulation)
    other.run(*plunge, 1e-3)
    assert simulation.steps == 0 and simulation.workpiece.hash() != other.workpiece.hash()
    assert collector.receive() is None


def test_a_simulation_of_which_nothing_is_left_is_copied_too():
    material = h.presets.clay()
    speck = h.build_block(h.Box([-0.2 * mm] * 3, [0.2 * mm] * 3), 0.1 * mm, material)
    simulation = h.Simulation(speck, h.Tool(h.SphereHead(1 * mm), spindle=h.Spindle(40000 * rpm)))
    for z in np.linspace(1.5 * mm, -1.5 * mm, 3000):
        simulation.step(h.Pose.from_translation([0, 0, z]), np.zeros(6), 1e-3)
    assert simulation.workpiece.empty()
    for made in WAYS.values():
        assert made(simulation).workpiece.empty()


def test_marks_for_undo_are_refused_and_the_cure_cures(simulation, plunge):
    simulation.reserve_undo(64)
    simulation.set_undo_mark()
    simulation.run(*plunge, 1e-3)
    for made in WAYS.values():
        with pytest.raises(h.Error, match="1 mark for undo and redo, which a copy cannot have.*reserve_undo"):
            made(simulation)
    simulation.reserve_undo(64)
    for made in WAYS.values():
        other = made(simulation)
        other.set_undo_mark()  # the memory for marks was reserved
        assert other.undo_marks == 1


def test_a_pickle_of_another_version_and_a_damaged_one_are_refused_by_a_sentence(simulation):
    function, state = simulation.__reduce_ex__(4)[0], simulation.__getstate__()
    other = type(simulation).__new__(type(simulation))
    with pytest.raises(h.Error, match="was pickled by hapticut 0.0.1 abc, but this is .*Pickle it again"):
        other.__setstate__(("0.0.1 abc", *state[1:]))
    with pytest.raises(h.Error, match="another version of hapticut"):
        other.__setstate__(state[:3])
    with pytest.raises(h.Error, match="the pickled workpiece cannot be read: it"):
        other.__setstate__((state[0], state[1][:100], *state[2:]))
    with pytest.raises(h.Error, match="the memory of the pickled simulation cannot be read: it"):
        other.__setstate__((*state[:4], state[4][:-1], state[5]))
    assert callable(function)


def test_what_belongs_to_one_process_says_that_it_cannot_be_pickled(simulation):
    for thing in (h.device.open_device("mock:press"), simulation.snapshot(), h.safety.Requests()):
        with pytest.raises(TypeError, match="cannot pickle"):
            pickle.dumps(thing)


def test_a_spawned_process_receives_a_simulation_and_makes_the_same_steps(simulation, plunge):
    simulation.run(plunge[0][:300], plunge[1][:300], 1e-3)
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        there = pool.submit(steps_of, simulation, plunge[0][300:], plunge[1][300:]).result()
    here = steps_of(simulation, plunge[0][300:], plunge[1][300:])
    assert same(there, here) and there[0]["removed_volume"].sum() > 0
