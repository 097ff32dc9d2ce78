# SPDX-License-Identifier: Apache-2.0
"""Smooth surfaces, necks and shanks; handles and spindles."""
import math

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm, rpm


def test_a_bur_on_a_shank_keeps_what_cuts():
    ball = h.catalogue.round_head(1 * mm)
    for kind, length in ((h.catalogue.ShankKind.friction_grip, 19), (h.catalogue.ShankKind.latch, 22), (h.catalogue.ShankKind.handpiece, 44.5)):
        shank = h.catalogue.standard_shank(kind, 0.6 * mm)
        bur = h.catalogue.on_shank(ball, shank)
        assert bur.bounding_box().max[2] == pytest.approx(length * mm - 0.5 * mm)
        assert bur.max_radius() == pytest.approx(shank.diameter / 2)
        assert bur.cutting_radius() == bur.shape.cutting_radius == pytest.approx(0.5 * mm)
    with pytest.raises(h.Error, match="neck_diameter"):
        h.catalogue.on_shank(ball, h.catalogue.Shank(neck_diameter=2 * mm, diameter=2 * mm, length=10 * mm))


def test_the_neck_is_smooth_and_the_ball_cuts():
    bur = h.catalogue.on_shank(
        h.catalogue.round_head(1 * mm),
        h.catalogue.Shank(neck_diameter=0.6 * mm, neck_length=1 * mm, taper_length=2 * mm, diameter=1.6 * mm, length=12 * mm))
    ball: h.MeridianSpring = bur.shape.exact_spring(0, -0.3 * mm)
    neck: h.MeridianSpring = bur.shape.exact_spring(0.2 * mm, 1 * mm)
    assert ball.depth == pytest.approx(0.2 * mm) and not ball.on_smooth and ball.scale == 1 and ball.smooth == 0
    assert neck.depth == pytest.approx(2 * 0.1 * mm) and neck.on_smooth and neck.scale == 2
    assert neck.smooth == pytest.approx((0.1 * mm) ** 2 + (0.6 * mm) ** 2, rel=1e-6)
    at = bur.spring_at([0.2 * mm, 0, 1 * mm])
    assert at.on_smooth and at.scale == 2 and at.smooth == pytest.approx(neck.smooth, rel=1e-6)


def test_the_nose_of_a_handpiece_is_a_body():
    bur = h.catalogue.on_shank(h.catalogue.round_head(1 * mm),
                               h.catalogue.standard_shank(h.catalogue.ShankKind.latch, 0.6 * mm))
    edge = h.ProfileEdge
    nose = h.Profile(tip=9 * mm, edges=[edge(rho=3 * mm, z=9 * mm), edge(rho=3 * mm, z=25 * mm), edge(z=25 * mm)])
    held = h.catalogue.with_body(bur, nose)
    assert held.max_radius() == pytest.approx(3 * mm)
    assert held.cutting_radius() == pytest.approx(0.5 * mm)


def test_a_handle_must_say_how_long_it_is():
    with pytest.raises(TypeError, match="length"):
        h.RayHandle()
    handle = h.RayHandle(10 * mm)
    handle.length = 20 * mm
    assert handle.length == 20 * mm
    with pytest.raises(h.Error, match="LHandle.length .m. must be given"):
        h.Tool(h.SphereHead(1 * mm), h.LHandle())


def test_a_spindle_that_no_motor_turns_is_refused(block):
    assert h.Tool(h.SphereHead(1 * mm), spindle=h.Spindle(-h.kMaxSpindleSpeed)).spindle.speed == -h.kMaxSpindleSpeed
    assert h.common_spindle(40000 * rpm).speed == h.Spindle(40000 * rpm).speed == pytest.approx(40000 * math.pi / 30)
    for turns_a_minute in ((40000,), (h.MotorKind.electric, 40000), (h.MotorKind.electric, 40000.0)):
        with pytest.raises(h.Error, match="units.?.?rpm"):
            h.common_spindle(*turns_a_minute)
    simulation = h.Simulation(block, h.Tool(h.SphereHead(1 * mm)))
    for give in (h.Spindle, h.loop.commands.SetSpindleSpeed, simulation.set_spindle_speed):
        with pytest.raises(h.Error, match="40000 . hapticut.units.rpm"):
            give(40000)
        with pytest.raises(h.Error, match="40000"):
            give(np.int64(40000))
        give(0)
        give(100.0)
    assert simulation.spindle_setting == 100.0 and h.Spindle(speed=0).speed == 0
    assert h.catalogue.max_speed(h.MotorKind.electric) == 250e3 * rpm
    assert h.describe_status(h.StepStatus.blocks_low | h.StepStatus.power_limited) == "blocks_low | power_limited"
    assert h.describe_status(0) == "ok" and h.safety.sentences_of(0) == ""
    assert "bring it out of the material" in h.safety.sentences_of(h.StepStatus.tool_waits)
    with pytest.raises(h.Error, match="a million rpm"):
        h.Tool(h.SphereHead(1 * mm), spindle=h.Spindle(2 * h.kMaxSpindleSpeed))
