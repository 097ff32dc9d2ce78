# SPDX-License-Identifier: Apache-2.0
"""Distances from what is left of the workpiece, rays, and the event that a material is touched for the first time."""
from __future__ import annotations

import math

import hapticut
import numpy as np
import pytest
from hapticut.units import mm, rpm

VOXEL = 0.1 * mm


@pytest.fixture
def slab() -> hapticut.Workpiece:
    """Enamel, dentin and pulp, 0.5, 1 and 1 mm thick, from z = 0 down."""
    presets = hapticut.presets
    box = hapticut.Box([-2 * mm, -2 * mm, -2.5 * mm], [2 * mm, 2 * mm, 0.0])
    return hapticut.build_layered_slab(box, VOXEL, [hapticut.Layer(presets.enamel(), 0.5 * mm),
                                                    hapticut.Layer(presets.dentin(), 1 * mm),
                                                    hapticut.Layer(presets.pulp(), 1 * mm)])


@pytest.fixture
def drill(slab) -> hapticut.Simulation:
    return hapticut.Simulation(slab, hapticut.Tool(hapticut.SphereHead(0.5 * mm), spindle=hapticut.Spindle(40000 * rpm)))


def at(*z):
    return hapticut.Pose.from_translation(np.array([[0.01 * mm, 0.02 * mm, one] for one in z]))


def test_the_distance_is_that_of_a_material_by_name_by_id_or_of_any(drill):
    pose = at(1.3 * mm)[0]
    for material, distance in [("enamel", 0.8), ("dentin", 1.3), ("pulp", 2.3), (3, 2.3), (None, 0.8)]:
        assert drill.distance_to(material, pose) == pytest.approx(distance * mm, abs=0.2 * VOXEL), material
    assert drill.distance_to("enamel", at(0.0)[0]) == 0
    assert drill.distance_to("pulp", pose, max_distance=2 * mm) == math.inf


def test_many_distances_are_those_of_the_single_poses(drill):
    poses = at(*(1.3 * mm - 0.01 * mm * np.arange(100)))
    distances = drill.distances_to("dentin", poses)
    assert distances.shape == (100,) and np.all(np.diff(distances) < 0)
    assert distances.tolist() == [drill.distance_to("dentin", pose) for pose in poses]
    assert np.isinf(drill.distances_to(3, poses, max_distance=1 * mm)).all()


def test_a_distance_needs_a_pose_and_a_material(drill):
    pose = at(1 * mm)[0]
    with pytest.raises(hapticut.Error, match="there is no material 'caries'; the table has: enamel, dentin, pulp"):
        drill.distance_to("caries", pose)
    with pytest.raises(hapticut.Error, match="there is no material 4; the table has materials 1 to 3"):
        drill.distance_to(4, pose)
    with pytest.raises(hapticut.Error, match="X_WH is not a rigid transform"):
        drill.distance_to(1, np.diag([-1.0, 1.0, 1.0, 1.0]))
    with pytest.raises(hapticut.Error, match=r"poses\[1\] is not a rigid transform"):
        drill.distances_to(1, np.array([pose, np.diag([2.0, 1.0, 1.0, 1.0])]))
    with pytest.raises(hapticut.Error, match="max_distance"):
        drill.distance_to(1, pose, max_distance=-1.0)


def test_a_ray_meets_the_first_material_or_the_one_that_is_asked_for(slab, drill):
    for workpiece in (slab, drill.workpiece):
        hit = workpiece.first_hit([0.1 * mm, 0, 2 * mm], [0, 0, -3])
        assert hit.distance == pytest.approx(2 * mm, abs=0.15 * VOXEL) and hit.material == 1
        assert hit.point_W[2] == pytest.approx(0, abs=0.15 * VOXEL)
        assert np.allclose(hit.normal_W, [0, 0, 1])
        pulp = workpiece.first_hit([0.1 * mm, 0, 2 * mm], [0, 0, -3], material="pulp")
        assert pulp.distance == pytest.approx(3.5 * mm, abs=0.5 * VOXEL) and pulp.material == 3
        assert workpiece.first_hit([0, 0, 2 * mm], [0, 0, 1]) is None
        assert workpiece.first_hit([0, 0, 2 * mm], [0, 0, -1], max_length=1 * mm) is None
    with pytest.raises(hapticut.Error, match="direction of zero"):
        slab.first_hit([0, 0, 0], [0, 0, 0])


def test_many_rays_are_those_of_the_single_ones(slab):
    rng = np.random.default_rng(3)
    origins = np.ascontiguousarray(rng.uniform(-3, 3, (50, 3)) * mm)
    directions = np.ascontiguousarray(rng.normal(size=(50, 3)))
    hits = slab.first_hits(origins, directions, material="dentin")
    for origin, direction, row in zip(origins, directions, hits):
        hit = slab.first_hit(origin, direction, material="dentin")
        assert (row["material"] == 0) == (hit is None) == bool(np.isinf(row["distance"]))
        if hit is not None:
            assert row["distance"] == hit.distance and np.array_equal(row["point_W"], hit.point_W)
            assert np.array_equal(row["normal_W"], hit.normal_W)
    assert 0 < np.count_nonzero(hits["material"]) < 50
    with pytest.raises(hapticut.Error, match="the ray 7 has"):
        directions[7] = 0
        slab.first_hits(origins, directions)
    with pytest.raises(hapticut.Error, match="give as many of both"):
        slab.first_hits(origins, directions[:5])


def test_a_first_touch_is_an_event_of_one_step_and_a_number_of_a_run(slab, drill):
    assert drill.touched == set() and drill.first_touched == set()
    z = 0.55 * mm - 2e-6 * np.arange(600)
    velocities = np.tile([0, 0, -2 * mm, 0, 0, 0], (600, 1))
    trace = drill.run(at(*z), velocities, 1e-3)
    assert drill.touched == {1, 2}
    first = drill.first_touch_by_material
    assert first.shape == (256,) and first[3] == 0
    assert first[1] == np.flatnonzero(trace["contact"]["voxels"])[0] + 1
    depth = -(z[int(first[2]) - 1] - 0.5 * mm)
    assert depth == pytest.approx(0.5 * mm, abs=VOXEL), "where the dentin begins"

    other = hapticut.Simulation(slab, drill.tool)
    events = {}
    for n, pose in enumerate(at(*z)):
        other.step(pose, velocities[n], 1e-3)
        for material in other.first_touched:
            assert material not in events
            events[material] = n + 1
    assert events == {1: first[1], 2: first[2]}
    drill.reset(slab)
    assert drill.touched == set() and not drill.first_touch_by_material.any()


def test_a_coupling_tells_the_first_touches_of_its_ticks(slab):
    tool = hapticut.Tool(hapticut.SphereHead(0.5 * mm))
    simulation = hapticut.Simulation(slab, tool, hapticut.SimulationConfig(contact_time=hapticut.ContactTime.end))
    coupling = hapticut.VirtualCoupling(simulation)
    events = []
    for pose in at(*(0.6 * mm - 5e-6 * np.arange(60))):
        events += coupling.step(pose, [0, 0, -5 * mm, 0, 0, 0], 1e-3).first_touched
    assert events == [1]


def test_rays_of_any_length_and_equal_rows_have_equal_bytes(slab):
    lengths = [1e-300, 1e-160, 1, 1e160, 1e300]
    origins, directions = np.tile([0, 0, 5 * mm], (5, 1)), np.outer(lengths, [0, 0, -1])
    hits = slab.first_hits(origins, directions)
    assert len({row.tobytes() for row in hits}) == 1 and np.all(np.isfinite(hits["distance"]))
    assert slab.first_hit(origins[0], directions[0]).distance == hits["distance"][0]
