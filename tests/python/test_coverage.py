# SPDX-License-Identifier: Apache-2.0
"""Every bound function, method and attribute is used once, and gives what its name says."""
from __future__ import annotations

import inspect
import math

import numpy as np
import pytest

import hapticut as h
from hapticut.units import deg, mm, rpm

core = h._hapticut


def use_attributes(thing):
    """Reads every attribute of an object; a getter that fails, fails the test."""
    return {name: getattr(thing, name) for name in dir(thing) if not name.startswith("_")}


def classes(owner=core):
    """All classes of the module, those inside of others as well."""
    for _, cls in inspect.getmembers(owner, inspect.isclass):
        if cls.__module__.startswith("hapticut") and cls is not owner:
            yield cls
            yield from classes(cls)


# What has no defaults.
GIVEN = [h.calibration.DrillingTest(1.25 * mm, 100.0, 1e-3, thrust=20.0, torque=0.04), h.GreyRange(1.0, 2.0, h.presets.clay()),
         h.Grade(1.0, 2.0, h.presets.clay(), h.presets.pulp(), steps=3), h.Layer(h.presets.clay(), 1 * mm),
         h.LabelMaterial([1, 2], h.presets.clay()), h.MeshShell(h.TriangleMesh(np.eye(3), np.array([[0, 1, 2]])), 1),
         h.SphereHead(1 * mm), h.ConeHead(0.5, 1 * mm), h.FlatHead(1 * mm, 2 * mm), h.io.VdbImport(h.presets.clay()),
         h.BodyDescription(h.Box([0] * 3, [1 * mm] * 3), lambda p: 1.0, lambda p: 1),
         h.Box([0] * 3, [1 * mm] * 3)]


def test_every_struct_is_made_with_its_defaults_copied_changed_and_printed():
    import copy
    import pickle

    things = list(GIVEN)
    for cls in classes():
        try:
            things.append(cls())
        except TypeError:
            pass  # needs arguments, or is only made by the library
    assert len(things) > 75
    for thing in things:
        cls, name = type(thing), type(thing).__name__
        values = use_attributes(thing)
        assert name in repr(thing) or "object" in repr(thing)
        if not hasattr(cls, "__setstate__"):
            for attribute, value in values.items():
                if getattr(getattr(cls, attribute), "fset", None):
                    setattr(thing, attribute, value)  # what was read can be written
            continue
        for attribute, value in values.items():
            if not callable(value) or isinstance(value, h.ForceLaw) or name == "BodyDescription":
                setattr(thing, attribute, value)  # what was read can be written
        if name not in ("MockOptions", "BodyDescription"):  # hold functions
            assert repr(pickle.loads(pickle.dumps(thing))) == repr(copy.deepcopy(thing)) == repr(copy.copy(thing))


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


@pytest.mark.parametrize("name", HEADS)
def test_heads_have_an_extent_a_profile_and_a_depth(name):
    head = HEADS[name]
    box = head.bounding_box()
    assert (box.max > box.min).all() and 0 < head.largest_radius() <= head.reach() and head.volume() > 0
    assert "mm" in head.description()
    inside: h.Spring = head.spring_at([0.1 * head.largest_radius(), 0, 0.45 * box.min[2] + 0.55 * box.max[2]])
    assert inside.depth > 0 and np.linalg.norm(inside.direction) == pytest.approx(1)
    assert head.spring_at(box.max + 1 * mm).depth <= 0
    assert inside.scale == (2 if inside.on_smooth else 1) and inside.on_smooth == (inside.smooth > 0)
    assert 0 < head.cutting_radius() <= head.largest_radius()
    profile = head.profile()
    again = h.ToolHead(h.ProfileHead(profile))
    assert again.volume() == pytest.approx(head.volume(), rel=1e-6)
    if isinstance(again.shape, h.ProfileHead):
        assert again.shape.tolerance == 0.01
        spring = again.shape.exact_spring(0.1 * head.largest_radius(), 0.45 * box.min[2] + 0.55 * box.max[2])
        assert math.hypot(spring.n_radial, spring.n_axial) == pytest.approx(1)
        # The table may be off by its tolerance of 1 % of the head.
        assert spring.depth == pytest.approx(inside.depth, abs=0.011 * max(box.max - box.min))
        assert again.shape.reach > 0 and again.shape.volume > 0 and again.shape.table_error >= 0
        assert len(again.shape.profile.edges) == len(profile.edges)
    assert name in dir(h.catalogue) and "Head" in repr(head)
    assert h.most_voxels(head, 0.1 * mm) > 0 and h.most_blocks(head, 0.1 * mm) > 0
    assert h.largest_contact_stiffness(head) > 0


def test_meshes_are_recognized_as_profiles():
    mesh = h.mesh_of_revolution(h.catalogue.cylinder_head(1 * mm, 3 * mm).profile(), 64)
    found = h.profile_from_mesh(mesh, [0, 0, 1])
    assert found.deviation < 0.05 * mm and found.X_MT.shape == (4, 4)
    assert h.ProfileHead(found.profile).volume == pytest.approx(math.pi * (0.5 * mm) ** 2 * 3 * mm, rel=0.02)


def test_rotations_are_made_exact_again():
    skewed = np.eye(3)
    skewed[0, 1] = 1e-4
    assert not h.is_rotation(skewed, 1e-6) and h.is_rotation(h.orthonormalized(skewed), 1e-12)
    info = h.build_info()
    assert info.version and info.compiler and info.cpu and isinstance(info.commit, str)


def test_a_stiffness_goes_to_another_point():
    spring = np.diag([1000.0, 2000, 3000, 0, 0, 0])  # at To, along the axes of T
    arm = np.array([0.0, 0.0, -0.1])  # from Ho to To
    about = h.transport(spring, np.eye(3), arm)
    assert np.allclose(about, about.T) and np.allclose(about[:3, :3], spring[:3, :3])
    turn = np.array([1e-3, 0, 0])  # moves To by turn x arm
    moved = np.cross(turn, arm)
    force = -spring[:3, :3] @ moved
    assert np.allclose(-about[:3, 3:] @ turn, force) and np.allclose(-about[3:, 3:] @ turn, np.cross(arm, force))
    with pytest.raises(h.Error, match=r"a stiffness.*\(3, 3\).*\(6, 6\)"):
        h.transport(np.eye(3), np.eye(3), arm)


def test_handles_and_tools():
    bent = h.LHandle(length=20 * mm, neck=5 * mm, bend=90 * deg)
    assert np.allclose(h.head_in_handle(bent)[:3, 3], [-5 * mm, 0, -20 * mm])
    tool = h.Tool(h.FlatHead(1 * mm, 2 * mm, h.FlatRule.both), bent, h.Spindle(100.0, power_limit=1.0))
    assert tool.head.shape.rule == h.FlatRule.both and tool.handle.neck == 5 * mm and tool.spindle.power_limit == 1.0
    assert np.allclose(tool.X_HT, h.head_in_handle(bent))
    assert h.thesis_handle_torque(bent, [0, 0, 1], 0.1, 1.0).shape == (3,)
    motor = h.catalogue.SpindleMotor(h.Spindle(100.0, acceleration_limit=10.0))
    motor.set(50.0)
    motor.advance(0.0, 1.0)
    assert motor.speed == pytest.approx(90) and motor.setting == 50.0 and not motor.loaded
    motor.halt()
    assert motor.speed == motor.setting == 0
    turbine = h.common_spindle(350e3 * rpm)
    assert turbine.is_limited() and not h.common_spindle(h.MotorKind.ideal, 350e3 * rpm).is_limited()
    assert h.catalogue.common_motor(350e3 * rpm) == h.MotorKind.air_turbine
    motor = h.catalogue.SpindleMotor(turbine)
    assert motor.is_limited() and motor.stall_torque == pytest.approx(1.5e-3)
    assert motor.has_reserve(1e-4) and not motor.has_reserve(1e-3)
    for _ in range(1000):
        motor.drive(2e-3, 1e-3)
        motor.advance(2e-3, 1e-3)
    assert motor.stalled and motor.loaded and motor.speed == 0
    assert h.catalogue.lips_of(h.Cutter(h.CutterKind.twist_drill)) == 2
    drill = h.catalogue.twist_drill_head(2 * mm, 5 * mm)
    assert h.catalogue.usual_cutter(drill).kind == h.Tool(drill).cutter.kind == h.CutterKind.twist_drill
    assert h.Tool(drill).cutter.lips == 2 and h.Tool(h.SphereHead(1 * mm)).cutter.lips == 6
    assert h.catalogue.tooth_rate(h.Cutter(lips=2), 2 * math.pi) == pytest.approx(2)
    h.validate(h.Spindle())
    with pytest.raises(h.Error, match="ConeHead"):
        h.Tool(h.ConeHead(120 * deg, 1 * mm))


def test_materials_and_their_table():
    table = h.MaterialTable([h.presets.enamel()])
    assert table.add(h.presets.dentin()) == 2 and table.size() == len(table) == 2
    assert table.contains(2) and 2 in table and not table.contains(3)
    assert table[2].name == "dentin" and table.id_of("dentin") == 2 and [m.name for m in table][0] == "enamel"
    assert h.preset_color("enamel") == h.Color(240, 236, 222)
    h.validate(h.presets.pulp())
    with pytest.raises(h.Error, match=r"damping.*= -1"):
        h.validate(h.Material("x", damping=-1.0))
    with pytest.raises(h.Error):
        table[9]


def test_builders():
    molar = h.build_molar(0.4 * mm, h.MolarParameters(caries_depth=2 * mm))
    assert [m.name for m in molar.materials] == ["enamel", "dentin", "pulp", "caries"]
    assert (h.kMolarEnamel, h.kMolarDentin, h.kMolarPulp, h.kMolarCaries) == (1, 2, 3, 4)
    description = h.describe_molar()
    assert description.distance(np.zeros(3)) < 0 and description.material(np.zeros(3)) in (2, 3)
    h.validate(h.MolarParameters())
    ball = h.build_sphere([0, 0, 0], 1 * mm, 0.1 * mm, h.presets.clay())
    assert ball.amounts()[0].volume == pytest.approx(4 / 3 * np.pi * mm**3, rel=1e-3)
    slab = h.build_layered_slab(h.Box([-1 * mm] * 3, [1 * mm] * 3), 0.1 * mm,
                                [h.Layer(h.presets.enamel(), 0.5 * mm), h.Layer(h.presets.dentin(), 1 * mm)])
    assert [a.volume for a in slab.amounts()] == pytest.approx([2e-9, 4e-9], rel=1e-6)
    values = np.full((4, 4, 4), 2, np.uint16)
    labels = h.volume.LabelVolume(values, [1 * mm] * 3)
    assert h.build_from_labels(labels, [h.LabelMaterial([2], h.presets.clay())]).solid_voxels() == 64
    with pytest.raises(h.Error, match="no material claims"):
        h.build_from_labels(labels, [h.LabelMaterial([1], h.presets.clay())], unclaimed=h.UnclaimedLabels.refuse)
    grey = h.volume.GreyVolume(values.astype(float), [1 * mm] * 3)
    assert np.allclose(grey.position(1, 2, 3), [1 * mm, 2 * mm, 3 * mm]) and np.array_equal(grey.X_WG, np.eye(4))
    assert not h.build_from_grey(grey, [h.GreyRange(1.0, 3.0, h.presets.clay())]).empty()
    assert not h.build_from_grey(grey, h.Grade(1.0, 3.0, h.presets.clay(), h.presets.pulp())).empty()
    mesh = h.mesh_of_revolution(h.catalogue.round_head(2 * mm).profile(), 24)
    shells = [h.MeshShell(mesh, 1)]
    assert shells[0].material == 1 and len(shells[0].mesh.vertices) == len(mesh.vertices)
    assert h.build_from_shells(shells, h.MaterialTable([h.presets.clay()]), h.MeshImport(0.2 * mm)).solid_voxels() > 0


def test_a_workpiece_tells_what_it_is(block):
    assert block.voxel_size == block.frame.voxel_size == 0.1 * mm and not block.empty()
    assert block.memory_bytes() > 0 and block.pool_bytes() == 0
    block.reserve_blocks(3)
    assert block.reserved_blocks() == 3 and block.pool_bytes() > 0
    bounds = block.bounds()
    assert bounds.voxels() == block.solid_voxels() == 60 * 60 * 40 and not bounds.empty()
    assert np.allclose(block.centroid_at(bounds.min), 0) and block.material_at([-5, 0, 0]) == 0
    snapshot = block.snapshot()
    block.restore(snapshot)
    assert block.undo_blocks == 0
    block.reserve_undo(10)
    block.set_mark()
    assert block.undo_blocks == 10 and block.marks == 1
    assert block.undo_block() is None and block.marks == 0  # nothing was cut since
    assert block.redo_marks == 1 and block.redo_block() is None and block.marks == 1
    [amount] = block.amounts()
    assert amount.material == 1 and amount.mass == pytest.approx(amount.volume * block.materials[1].density)
    assert np.allclose(block.frame.center([0, 0, 0]), block.frame.X_WV[:3, 3])
    assert h.extract_surface(block, 1).vertices.shape[1] == 3
    with pytest.raises(h.Error, match="empty"):
        block.material_array(h.IndexBox())


def test_friction_and_deep_contact_by_themselves():
    friction = h.DryFriction(0.4, 0.2, 1000.0)
    h.validate(friction)
    anchor = h.LimitSurface()
    contact = h.SpreadFriction.at_point([0, 0, 1], friction)
    stuck = anchor.move(contact, [1e-4, 0, 0, 0, 0, 0])
    assert anchor.anchored and not anchor.sliding and stuck.dissipated < 1e-18 and stuck.wrench.force[0] < 0
    assert np.allclose(stuck.stiffness[:3, :3], np.diag([500, 500, 0]))  # it is a mean: the anchor stretches on the way
    slid = anchor.move(contact, [1e-2, 0, 0, 0, 0, 0])
    assert anchor.sliding and np.linalg.norm(slid.wrench.force) == pytest.approx(0.2)
    assert anchor.stored > 0 and anchor.stiffness == pytest.approx(1000)
    ring = h.SpreadFriction()
    for x, y in [(1e-3, 0), (0, 1e-3), (-1e-3, 0), (0, -1e-3)]:
        ring.add([x, y, 0], [0, 0, 1], 0.25, friction)
    assert ring.static_limit == pytest.approx(0.4) and ring.dynamic_limit == pytest.approx(0.2) and ring.anchors > 0
    turned = h.LimitSurface().move(ring, [0, 0, 0, 0, 0, 1.0])
    assert turned.wrench.torque[2] == pytest.approx(-0.2e-3) and ring.directions.shape == (6, 6)
    anchor.release()
    assert not anchor.anchored
    assert h.standing_share(0.0, 1e-3) == 1 and h.standing_share(1e3, 1e-3) == 0 and h.kFullSpinSpeed == 0.01
    deep = h.DeepContact()
    deep.move([0, 0, 1e-3], [0, 0, 0], 0.3, [0, 0, 2.0], 1e-3)
    assert deep.wants_normal_force(0.9) and not deep.wants_normal_force(0.3)
    out = deep.move([0, 0, 0], [0, 0, -1e-3], 0.9, [0, 0, 1.0], 1e-3)
    assert deep.stiffness > 0 and np.allclose(abs(deep.normal), [0, 0, 1])
    assert deep.held and out.force[2] > 0 and out.stored == deep.stored > 0 and out.stored_before == out.released == 0
    deep.release()
    assert not deep.held


def test_laws_by_themselves():
    hertz = h.ContactMechanicsLaw(1e6)
    assert hertz.force(h.SphereHead(1e-3), 1e-4) == pytest.approx(4 / 3 * 1e6 * math.sqrt(1e-3) * 1e-4**1.5)
    assert hertz.energy(h.FlatHead(1e-3, 1e-3), 1e-4) == pytest.approx(1e-3 * 1e6 * 1e-8)
    assert h.ContactMechanicsLaw.depth_of(h.SphereHead(1e-3), 2 / 3 * math.pi * 1e-9) == pytest.approx(1e-3)
    burr = h.HertzianBurrLaw(1e6)
    assert burr.energy(1e-3, 1e-4) == pytest.approx(burr.force(1e-3, 1e-4) * 1e-4 / 2.5)
    assert burr.needs_moments() and not h.FoundationLaw().needs_moments()
    assert h.FoundationLaw().holds_deep_contact() and not burr.holds_deep_contact()
    with pytest.raises(h.Error, match="a cone of half angle .* round burr only"):
        burr.require_head(h.ConeHead(0.5, 1e-3))
    drill = h.TwistDrillLaw(h.TwistDrillLaw.Constants(specific_energy=2e8))
    assert drill.thrust(2e-3, 1e-4, math.pi) == pytest.approx(2e8 * 1e-4 * 1e-3)
    assert drill.torque(2e-3, 1e-4) == pytest.approx(2e8 * 1e-4 * 4e-6 / 8)
    assert h.TwistDrillLaw.point_angle(h.ConeHead(0.5, 1e-3)) == pytest.approx(1.0)
    assert h.ThesisLaw(h.ThesisLaw.Constants(damping=2.0)).constants.damping == 2.0
    mode = h.thesis_mode(h.ThesisMode(h.ThesisLaw.Constants(damping=2.0), tool_mass=0.1, update_rate=2000.0))
    assert mode.law.constants.damping == 2.0 and mode.effects.gravity.mass == 0.1 and mode.effects.vibration.frequency == 500
    assert h.thesis_mode().effects.vibration is None and mode.handle_torque == h.HandleTorque.thesis
    with pytest.raises(h.Error, match="resistance"):
        h.DampingMatrixLaw(h.DampingMatrixLaw.Constants(resistance=-1.0))


def test_stiffness_and_calibration():
    head, bone = h.SphereHead(1 * mm), h.presets.cortical_bone()
    assert h.stiffness_for_accuracy(head, bone, 2000.0, 2e-3) > 0
    assert h.stiffness_for_device(head, 1000.0) == pytest.approx(1000 * 27 / (4 * math.pi) / 1e-9, rel=0.01)
    known = h.calibration.Calibration(specific_cutting_energy=3e8, cutting_ratio=0.6, edge_pressure=1e5)
    tests = []
    for feed in (1e-3, 4e-3):
        force = h.calibration.axial_cut_force(known, 1.25 * mm, 100.0, feed)
        tests.append(h.calibration.DrillingTest(1.25 * mm, 100.0, feed, thrust=force.thrust, torque=force.torque))
    found = h.calibration.calibrate(tests, h.calibration.ChipTerm.edge_pressure)
    assert found.edge_identified and found.chip_identified and found.checked and not found.edge_assumed
    assert found.specific_cutting_energy == pytest.approx(3e8, rel=1e-4)
    assert found.cutting_ratio == pytest.approx(0.6, rel=1e-4) and found.thrust_residual < 1e-4


def test_effects_by_themselves():
    assert np.allclose(h.effects.gravity_wrench(h.effects.Gravity(mass=2.0), np.eye(3)).force, [0, 0, -2 * 9.80665])
    wrench = h.Wrench([1, 2, 3], [4, 5, 6])
    assert h.effects.masked(h.effects.AxisMask(force=[True, False, True]), wrench).force.tolist() == [1, 0, 3]
    assert np.allclose(h.effects.filtered(h.effects.DeltaFilter(), [0, 0, 0], [1, 0, 0]), [0.005, 0, 0])
    assert h.effects.least_force_growth(1000.0, 0.5) == 625
    assert np.allclose(h.effects.saturated([3, 4, 0], 1.0), [0.6, 0.8, 0])
    assert np.allclose(h.effects.growth_limited([1, 0, 0], [0, 2, 0], 0.5), [0, 0.5, 0])
    output = h.effects.Output()
    effects = h.effects.Effects(vibration=h.effects.Vibration(frequency=100.0, amplitude=0.4))
    moved = output.give(effects, h.effects.EffectsInput(touching=True, dt=1e-3), h.Wrench())
    assert np.linalg.norm(moved.force) == pytest.approx(0.4 * math.sin(2 * math.pi * 0.1))
    limits = h.effects.Effects(limits=h.effects.OutputLimits(largest_force=1.0))
    limited = output.give(limits, h.effects.EffectsInput(dt=1e-3), wrench)
    assert np.array_equal(output.given.force, limited.force)
    assert np.allclose(limited.force, np.array([1, 2, 3]) / 14**0.5)
    output.drop()
    output.restart()
    shaking = h.effects.VibrationPhase()
    assert shaking.advance(effects.vibration, True, 0.0, 1e-3) == pytest.approx(0.4 * math.sin(2 * math.pi * 0.1))
    assert shaking.advance(effects.vibration, False, 0.0, 1e-3) == 0
    for value in (h.effects.Gravity(), h.effects.DeltaFilter(), h.effects.OutputLimits()):
        h.validate(value)
    h.validate(h.effects.Vibration(), 1000.0)
    h.validate(h.effects.Effects(), 1000.0)
    with pytest.raises(h.Error, match="frequency"):
        h.validate(h.effects.Vibration(frequency=460.0), 1000.0)
    assert h.effects.kFastestVibration == 0.45


def test_a_simulation_tells_what_it_is(simulation, plunge):
    simulation.run(*plunge, 1e-3)
    values = use_attributes(simulation)
    assert values["steps"] == 600 and values["workpiece_exchanges"] == 0
    assert values["spindle_setting"] == values["tool"].spindle.speed and values["config"].reference_stiffness == 1e16
    assert values["removed_volume_by_material"].sum() > 0
    origins, complete = simulation.changed_blocks()
    assert origins.shape[1] == 3 and complete
    worst = simulation.worst_case()
    assert worst.voxels >= simulation.last_result.contact.voxels and worst.level_of_detail == worst.contacts == 1
    assert worst.blocks * h.kBlockVoxels >= worst.voxels and worst.sub_steps >= 1
    given = values["last_input"]
    assert np.array_equal(given.pose, plunge[0][-1]) and np.array_equal(given.velocity, plunge[1][-1])
    last = simulation.last_result
    assert given.dt == 1e-3 and last.contact.level_of_detail == 1 and last.spindle.speed > 0 and last.spindle.torque > 0
    energy = use_attributes(last.energy)
    terms = ("elastic", "cutting", "damping", "rubbing", "anchored", "sliding", "credited", "entered", "released")
    assert all(math.isfinite(energy[term]) for term in terms) and energy["hand_work"] > 0 < energy["motor_work"]
    assert last.energy.stored() == pytest.approx(energy["elastic"] + energy["anchored"])
    assert last.energy.losses() > energy["cutting"]
    assert last.energy.imbalance() == pytest.approx(0, abs=1e-3 * energy["cutting"])  # single precision in the loop
    simulation.reserve_blocks(4000)
    assert use_attributes(simulation.last_result)["contact"].depth > 0
    assert use_attributes(simulation.stage_times)["check_input"] == 0
    h.validate(h.SimulationConfig())


def test_enumerations_have_the_names_of_cpp():
    assert h.StepStatus.jump_rejected | h.StepStatus.dt_rejected == 0b1100
    assert 0b1100 & h.StepStatus.dt_rejected == 4 and h.StepStatus.ok ^ 3 == 3
    assert h.kRejected == 15 and not h.has_any(0, h.StepStatus.pose_rejected)
    assert h.device.describe(int(h.device.OutputChange.ramped)).strip()
    assert h.device.describe(h.device.DeviceFault.disconnected).strip()
    assert h.has_any(int(h.device.OutputChange.cooled), h.device.OutputChange.cooled)
    assert not h.has_any(0, h.device.OutputChange.cooled)
    assert h.ContactTime.middle != h.ContactTime.end and h.RemovalLaw.none != h.RemovalLaw.elastic_release
    assert h.SimulationConfig().quadrature in h.Quadrature.__members__.values()
    assert h.SimulationConfig().handle_torque == h.HandleTorque.full_wrench
    kinds = {edge.kind for head in HEADS.values() for edge in head.profile().edges}
    assert kinds == {h.EdgeKind.cutting, h.EdgeKind.smooth}
    for cls in classes():
        if hasattr(cls, "__members__"):
            assert cls.__members__, cls


def test_constants_are_those_of_cpp():
    assert (h.kEmpty, h.kMaxMaterials, h.kBlockEdge, h.kBlockVoxels) == (0, 255, 8, 512)
    assert h.safety.kSafetyEvents == len(h.safety.SafetyEvent.__members__)
    assert 0 < h.catalogue.kTreeWaist < 1 and 0 < h.kSmallestFill < 1e-2
    histogram = h.loop.LatencyHistogram
    assert (histogram.kBuckets, histogram.kBucketWidth) == (2000, 1e-6)
    deep, law = h.DeepContact, h.FoundationLaw
    assert (deep.kDeep, deep.kFree) == (0.52, 0.25) and h.loop.RealtimeLoop.kCommands == 256
    assert law.kSlipRegularization == pytest.approx(1e-3) and law.kLargestExponent == pytest.approx(1e30)
    assert law.kLeastEnergyShare == pytest.approx(1e-6) and law.kAxisZone == 2
    assert law.kSmallestPart == pytest.approx(1e-6) and law.kSmallestLoss == pytest.approx(1e-5)
    assert law.kAxisSlip == pytest.approx(1 / (4 * math.asinh(1)), rel=1e-3)


def test_colors_and_meshes():
    red = h.Color(255, 0, 0)
    assert red == h.Color(255, 0, 0) != h.Color(0, 255, 0) and red != "red" and hash(red) == 0xFF0000
    mesh = h.TriangleMesh(np.eye(3), np.array([[0, 1, 2]]))
    colored = h.ColoredMesh(mesh, [red] * 3)
    assert colored.colors.tolist() == [[255, 0, 0]] * 3 and len(colored.mesh.vertices) == 3
