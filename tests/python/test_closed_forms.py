# SPDX-License-Identifier: Apache-2.0
"""Closed forms beside a simulation."""
import numpy as np
import pytest

import hapticut
from hapticut import closed_forms
from hapticut.units import deg, mm

K_V = 1e12


def test_numbers_may_be_arrays():
    depths = np.linspace(0.1, 0.5, 5) * mm
    forces = closed_forms.cap_force(K_V, 1 * mm, depths)
    assert forces.shape == (5,) and np.all(np.diff(forces) > 0)
    assert closed_forms.cap_force(K_V, 1 * mm, 0.3 * mm) == pytest.approx(forces[2])


def test_a_simulation_agrees_with_theory():
    depth = 0.4 * mm
    box = hapticut.Box([-1.5 * mm, -1.5 * mm, -1.5 * mm], [1.5 * mm, 1.5 * mm, 0])
    block = hapticut.build_block(box, 0.05 * mm, hapticut.Material("plain"))
    tool = hapticut.Tool(hapticut.SphereHead(1 * mm))
    simulation = hapticut.Simulation(block, tool, hapticut.SimulationConfig(reference_stiffness=K_V))
    pose = hapticut.Pose.from_translation([0.01 * mm, 0.02 * mm, 1 * mm - depth])
    force = simulation.step(pose, np.zeros(6), 1e-3).model.force[2]
    assert force == pytest.approx(closed_forms.cap_force(K_V, 1 * mm, depth), rel=0.01)


def test_the_pressure_identity_holds_for_any_head():
    ball = hapticut.ToolHead(hapticut.SphereHead(1 * mm))
    pose = hapticut.Pose.from_translation([0, 0, 0.7 * mm])
    wrench = closed_forms.wrench_on_plane(K_V, ball, pose)
    assert wrench.force[2] == pytest.approx(closed_forms.cap_force(K_V, 1 * mm, 0.3 * mm), rel=1e-3)


def test_a_steady_cut():
    cut = closed_forms.SteadyCut(3e8, 0.5, 2000.0, 2e-3)
    radii = np.array([0.5, 1.0]) * mm
    forces = closed_forms.axial_cutting_force_of_a_flat_head(cut, radii)
    np.testing.assert_allclose(forces, 2 * np.pi * radii * 3e8 * 2e-3 / (0.5 * 2000))
    wrench = closed_forms.ball_plunge_wrench(cut, 1 * mm, 0.3 * mm)
    assert wrench.force[2] > 0 and wrench.torque[2] < 0


def test_springs_have_a_local_centre():
    cone = hapticut.ToolHead(hapticut.ConeHead(45 * deg, 1 * mm))
    center = cone.spring_center([0.2 * mm, 0, 0.5 * mm])
    np.testing.assert_allclose(center, [0, 0, 0.7 * mm], atol=1e-12)
    ball = hapticut.ToolHead(hapticut.SphereHead(1 * mm))
    np.testing.assert_allclose(ball.spring_center([0.2 * mm, 0.1 * mm, 0.5 * mm]), np.zeros(3), atol=1e-12)
    flat = hapticut.ToolHead(hapticut.FlatHead(1 * mm, 1 * mm))
    assert flat.spring_center([0.1 * mm, 0, 0.1 * mm]) is None
