# SPDX-License-Identifier: Apache-2.0
"""Laws, calibration and effects: arguments from Python have the same effect as in C++."""
from __future__ import annotations

import math

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm


def test_laws_give_their_closed_forms():
    hertz = h.ContactMechanicsLaw(1e6)
    assert hertz.force(h.SphereHead(1e-3), 1e-4) == pytest.approx(4 / 3 * 1e6 * math.sqrt(1e-3) * 1e-4**1.5)
    assert hertz.energy(h.FlatHead(1e-3, 1e-3), 1e-4) == pytest.approx(1e-3 * 1e6 * 1e-8)
    assert h.ContactMechanicsLaw.depth_of(h.SphereHead(1e-3), 2 / 3 * math.pi * 1e-9) == pytest.approx(1e-3)
    burr = h.HertzianBurrLaw(1e6)
    assert burr.energy(1e-3, 1e-4) == pytest.approx(burr.force(1e-3, 1e-4) * 1e-4 / 2.5)
    assert burr.needs_moments() and not h.FoundationLaw().needs_moments()
    assert h.FoundationLaw().tethers_deep_ball() and not burr.tethers_deep_ball()
    with pytest.raises(h.Error, match="a cone of half angle .* round burr only"):
        burr.require_head(h.ConeHead(0.5, 1e-3))
    drill = h.TwistDrillLaw(h.TwistDrillLaw.Constants(specific_energy=2e8))
    assert drill.thrust(2e-3, 1e-4, math.pi) == pytest.approx(2e8 * 1e-4 * 1e-3)
    assert drill.torque(2e-3, 1e-4) == pytest.approx(2e8 * 1e-4 * 4e-6 / 8)
    assert h.TwistDrillLaw.point_angle(h.ConeHead(0.5, 1e-3)) == pytest.approx(1.0)
    assert h.ThesisLaw(h.ThesisLaw.Constants(damping=2.0)).constants.damping == 2.0
    mode = h.thesis_mode(h.ThesisMode(h.ThesisLaw.Constants(damping=2.0), tool_mass=0.1, update_rate=2000.0))
    assert mode.law.constants.damping == 2.0
    assert mode.effects.gravity.mass == 0.1 and mode.effects.vibration.frequency == 500
    assert h.thesis_mode().effects.vibration is None and mode.handle_torque == h.HandleTorque.thesis
    with pytest.raises(h.Error, match="resistance"):
        h.DampingMatrixLaw(h.DampingMatrixLaw.Constants(resistance=-1.0))


def test_stiffness_and_calibration_give_back_what_they_were_given():
    head = h.SphereHead(1 * mm)
    assert h.stiffness_for_device(head, 1000.0) == pytest.approx(1000 * 27 / (4 * math.pi) / 1e-9, rel=0.01)
    known = h.calibration.Calibration(specific_cutting_energy=3e8, cutting_ratio=0.6, edge_pressure=1e5)
    tests = []
    for feed in (1e-3, 4e-3):
        force = h.calibration.axial_cut_force(known, 1.25 * mm, 100.0, feed)
        tests.append(h.calibration.DrillingTest(1.25 * mm, 100.0, feed, thrust=force.thrust, torque=force.torque))
    found = h.calibration.calibrate(tests, h.calibration.ChipTerm.edge_pressure)
    assert found.edge_identified and found.checked and not found.edge_assumed
    assert found.specific_cutting_energy == pytest.approx(3e8, rel=1e-4)
    assert found.cutting_ratio == pytest.approx(0.6, rel=1e-4) and found.thrust_residual < 1e-4
    assert found.cutter == h.CutterKind.twist_drill and found.term == h.calibration.ChipTerm.edge_pressure
    assert h.calibration.presets_beside(found, "cutting_ratio").of == "twist_drill"
    bur = h.calibration.calibrate(tests, cutter=h.CutterKind.carbide_bur)
    assert bur.term == h.calibration.ChipTerm.size_length and h.calibration.advice_on(bur).startswith("These constants")


def test_a_stiffness_goes_to_another_point():
    spring = np.diag([1000.0, 2000, 3000, 0, 0, 0])  # at To, along the axes of T
    arm = np.array([0.0, 0.0, -0.1])  # from Ho to To
    about = h.transport(spring, np.eye(3), arm)
    assert np.allclose(about, about.T) and np.allclose(about[:3, :3], spring[:3, :3])
    rotation = np.array([1e-3, 0, 0])  # moves To by rotation x arm
    moved = np.cross(rotation, arm)
    force = -spring[:3, :3] @ moved
    assert np.allclose(-about[:3, 3:] @ rotation, force) and np.allclose(-about[3:, 3:] @ rotation, np.cross(arm, force))
    with pytest.raises(h.Error, match=r"a stiffness.*\(3, 3\).*\(6, 6\)"):
        h.transport(np.eye(3), np.eye(3), arm)


def test_effects_are_added_and_limited():
    assert np.allclose(h.effects.gravity_wrench(h.effects.Gravity(mass=2.0), np.eye(3)).force, [0, 0, -2 * 9.80665])
    wrench = h.Wrench([1, 2, 3], [4, 5, 6])
    assert h.effects.masked(h.effects.AxisMask(force=[True, False, True]), wrench).force.tolist() == [1, 0, 3]
    assert np.allclose(h.effects.filtered(h.effects.DeltaFilter(), [0, 0, 0], [1, 0, 0]), [0.005, 0, 0])
    assert np.allclose(h.effects.saturated([3, 4, 0], 1.0), [0.6, 0.8, 0])
    assert np.allclose(h.effects.growth_limited([1, 0, 0], [0, 2, 0], 0.5), [0, 0.5, 0])
    output = h.effects.Output()
    effects = h.effects.Effects(vibration=h.effects.Vibration(frequency=100.0, amplitude=0.4))
    moved = output.give(effects, h.effects.EffectsInput(touching=True, dt=1e-3), h.Wrench())
    assert np.linalg.norm(moved.force) == pytest.approx(0.4 * math.sin(2 * math.pi * 0.1))
    limits = h.effects.Effects(limits=h.effects.OutputLimits(max_force=1.0))
    limited = output.give(limits, h.effects.EffectsInput(dt=1e-3), wrench)
    assert np.array_equal(output.given.force, limited.force)
    assert np.allclose(limited.force, np.array([1, 2, 3]) / 14**0.5)
    with pytest.raises(h.Error, match="frequency"):
        h.validate(h.effects.Vibration(frequency=460.0), 1000.0)


def test_a_law_of_python_is_refused_where_it_is_made():
    for law in (h.FoundationLaw, h.ThesisLaw, h.ContactMechanicsLaw, h.HertzianBurrLaw, h.DampingMatrixLaw,
                h.TwistDrillLaw):
        with pytest.raises(TypeError, match="not an acceptable base type"):
            type("Mine", (law,), {})


def test_messages_have_the_names_and_the_cures_of_python():
    with pytest.raises(h.Error, match=r"SimulationConfig\.") as refused:
        h.validate(h.SimulationConfig(update_rate=-1.0))
    assert "::" not in str(refused.value)


def test_an_array_of_a_wrong_shape_is_told_a_cure_that_cures(simulation):
    pose, rest = np.eye(4), np.zeros(6)
    pose[2, 3] = 30 * mm
    with pytest.raises(h.Error, match=r"shape \(n, 4, 4\).*write x\[numpy.newaxis\]"):
        simulation.run(pose, rest[None], 1e-3)
    simulation.run(pose[np.newaxis], rest[None], 1e-3)
    with pytest.raises(h.Error, match="shape .4, 4.") as refused:
        simulation.step(np.eye(3), rest, 1e-3)
    assert "makes one" not in str(refused.value)
    with pytest.raises(h.Error, match="makes one"):
        simulation.run(pose[None].astype(np.float32), rest[None], 1e-3)
    for no_number in (None, 10**400, "x"):
        with pytest.raises(h.Error, match="a vector"):
            h.Wrench([1, 2, no_number], [0, 0, 0])
    with pytest.raises(ValueError, match="must be"):
        h.Pose.inverse(np.eye(3))
    with pytest.raises(ValueError, match="not a rigid transform"):
        h.Pose.inverse(2 * np.eye(4))
    assert np.allclose(h.Pose.inverse(pose) @ pose, np.eye(4))
    with pytest.raises(h.Error, match="dt"):
        h.twist_between(pose, pose, 0)


def test_an_object_of_a_wrong_type_is_a_type_error(simulation):
    with pytest.raises(TypeError):
        h.loop.RealtimeLoop(simulation)
