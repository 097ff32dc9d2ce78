# SPDX-License-Identifier: Apache-2.0
"""Heads of the catalogue, profiles, handles and spindles."""
from __future__ import annotations

import math
import re

import numpy as np
import pytest

import hapticut as h
from conftest import REPOSITORY
from hapticut.units import deg, mm, rpm

HEADS = {
    "round_head": h.catalogue.round_head(2 * mm),
    "inverted_cone_head": h.catalogue.inverted_cone_head(2 * mm, 1 * mm, 2 * mm),
    "cylinder_head": h.catalogue.cylinder_head(1 * mm, 4 * mm),
    "round_end_cylinder_head": h.catalogue.round_end_cylinder_head(1 * mm, 4 * mm),
    "tapered_head": h.catalogue.tapered_head(0.8 * mm, 1.2 * mm, 4 * mm),
    "round_end_tapered_head": h.catalogue.round_end_tapered_head(0.8 * mm, 1.2 * mm, 4 * mm),
    "needle_head": h.catalogue.needle_head(1 * mm, 6 * mm),
    "flame_head": h.catalogue.flame_head(1.2 * mm, 5 * mm, 0.8 * mm, 2 * mm),
    "pear_head": h.catalogue.pear_head(1.2 * mm, 3 * mm, 0.8 * mm),
    "wheel_head": h.catalogue.wheel_head(4 * mm, 0.8 * mm, 1 * mm),
    "christmas_tree_head": h.catalogue.christmas_tree_head(1.6 * mm, 5 * mm, 4),
    "twist_drill_head": h.catalogue.twist_drill_head(2.5 * mm, 8 * mm),
}


def test_every_head_of_the_catalogue_is_bound_and_tested():
    page = (REPOSITORY / "docs" / "command-line.md").read_text(encoding="utf-8")
    [row] = re.findall(r"^\| `head` \| .* \| (.*) \|$", page, re.M)
    names = row.split(", ")
    of_shapes = [name for name in names if hasattr(h, name.title().replace("_", "") + "Head")]  # heads with a class
    assert of_shapes[:3] == ["sphere", "cone", "flat"] and of_shapes[-1] == "profile"
    assert [f"{name}_head" for name in names if name not in of_shapes] == list(HEADS)


@pytest.mark.parametrize("name", HEADS)
def test_heads_have_an_extent_a_profile_and_a_depth(name):
    head = HEADS[name]
    box = head.bounding_box()
    assert (box.max > box.min).all() and 0 < head.cutting_radius() <= head.max_radius() <= head.reach()
    inside = head.spring_at([0.1 * head.max_radius(), 0, 0.45 * box.min[2] + 0.55 * box.max[2]])
    assert inside.depth > 0 and np.linalg.norm(inside.direction) == pytest.approx(1)
    assert inside.scale == (2 if inside.on_smooth else 1) and head.spring_at(box.max + 1 * mm).depth <= 0
    profile = head.profile()
    assert {edge.kind for edge in profile.edges} <= {h.EdgeKind.cutting, h.EdgeKind.smooth}
    again = h.ToolHead(h.ProfileHead(profile))
    assert again.volume() == pytest.approx(head.volume(), rel=1e-6)
    if isinstance(again.shape, h.ProfileHead):
        spring = again.shape.exact_spring(0.1 * head.max_radius(), 0.45 * box.min[2] + 0.55 * box.max[2])
        assert math.hypot(spring.n_radial, spring.n_axial) == pytest.approx(1)
        # The table has a tolerance of 1 % of the head.
        assert spring.depth == pytest.approx(inside.depth, abs=0.011 * max(box.max - box.min))
    assert "mm" in head.description() and "Head" in repr(head)
    assert h.max_voxels(head, 0.1 * mm) > h.max_blocks(head, 0.1 * mm) > 0


def test_meshes_are_recognized_as_profiles():
    mesh = h.mesh_of_revolution(h.catalogue.cylinder_head(1 * mm, 3 * mm).profile(), 64)
    found = h.profile_from_mesh(mesh, [0, 0, 1])
    assert found.deviation < 0.05 * mm and found.X_MT.shape == (4, 4)
    assert h.ProfileHead(found.profile).volume == pytest.approx(math.pi * (0.5 * mm) ** 2 * 3 * mm, rel=0.02)


def test_a_tool_is_what_it_was_made_of():
    bent = h.LHandle(length=20 * mm, neck=5 * mm, bend=90 * deg)
    assert np.allclose(h.head_in_handle(bent)[:3, 3], [-5 * mm, 0, -20 * mm])
    tool = h.Tool(h.FlatHead(1 * mm, 2 * mm, h.FlatRule.both), bent, h.Spindle(100.0, power_limit=1.0))
    assert tool.head.shape.rule == h.FlatRule.both and tool.handle.neck == 5 * mm and tool.spindle.power_limit == 1.0
    assert np.allclose(tool.X_HT, h.head_in_handle(bent))
    drill = h.catalogue.twist_drill_head(2 * mm, 5 * mm)
    assert h.catalogue.usual_cutter(drill).kind == h.Tool(drill).cutter.kind == h.CutterKind.twist_drill
    assert h.Tool(drill).cutter.lips == 2 and h.Tool(h.SphereHead(1 * mm)).cutter.lips == 6
    assert h.catalogue.tooth_rate(h.Cutter(lips=2), 2 * math.pi) == pytest.approx(2)
    with pytest.raises(h.Error, match="ConeHead"):
        h.Tool(h.ConeHead(120 * deg, 1 * mm))


def test_a_motor_ramps_and_stalls():
    motor = h.catalogue.SpindleMotor(h.Spindle(100.0, acceleration_limit=10.0))
    motor.set(50.0)
    motor.advance(0.0, 1.0)
    assert motor.speed == pytest.approx(90) and motor.setting == 50.0 and not motor.loaded
    turbine = h.common_spindle(350e3 * rpm)
    assert turbine.is_limited() and not h.common_spindle(h.MotorKind.ideal, 350e3 * rpm).is_limited()
    motor = h.catalogue.SpindleMotor(turbine)
    assert motor.has_reserve(1e-4) and not motor.has_reserve(1e-3) and motor.stall_torque == pytest.approx(1.5e-3)
    for _ in range(1000):
        motor.drive(2e-3, 1e-3)
        motor.advance(2e-3, 1e-3)
    assert motor.stalled and motor.loaded and motor.speed == 0
