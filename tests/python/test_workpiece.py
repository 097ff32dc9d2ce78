# SPDX-License-Identifier: Apache-2.0
"""Workpieces from arrays, shapes and files, and back."""
from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import hapticut
from hapticut.units import mm

ENAMEL, DENTIN = hapticut.presets.enamel(), hapticut.presets.dentin()


def labels() -> np.ndarray:
    array = np.zeros((12, 10, 8), dtype=np.uint8)
    array[2:10, 2:8, 1:5] = 3
    array[4:8, 3:7, 1:3] = 7
    return array


@pytest.mark.parametrize("order", ["C", "F"])
def test_labels_become_materials_voxel_by_voxel(order):
    array = np.array(labels(), order=order)
    workpiece = hapticut.Workpiece.from_labels(array, [0.2 * mm] * 3, {3: ENAMEL, 7: DENTIN})
    assert [material.name for material in workpiece.materials.all()] == ["enamel", "dentin"]
    box = hapticut.IndexBox(min=[0, 0, 0], max=[11, 9, 7])
    found = workpiece.material_array(box)
    assert np.array_equal(found == 1, labels() == 3) and np.array_equal(found == 2, labels() == 7)
    assert workpiece.solid_voxels() == np.count_nonzero(labels())


def test_several_labels_may_be_one_material():
    workpiece = hapticut.Workpiece.from_labels(labels(), [1 * mm] * 3, {(3, 7): ENAMEL})
    assert [amount.voxels for amount in workpiece.amounts()] == [np.count_nonzero(labels())]


@pytest.mark.parametrize("array, spacing, materials, message", [
    (labels(), [1 * mm] * 3, {3: ENAMEL}, "no material claims: 7"),
    (labels(), [1 * mm, -1 * mm, 1 * mm], {3: ENAMEL, 7: DENTIN}, "spacing"),
    (labels(), [1 * mm, np.nan, 1 * mm], {3: ENAMEL, 7: DENTIN}, "spacing"),
    (labels(), [1 * mm] * 2, {3: ENAMEL, 7: DENTIN}, r"shape \(2,\).*\(3,\)"),
    (labels().astype(float), [1 * mm] * 3, {3: ENAMEL}, "float64.*whole-number dtype"),
    (labels()[0], [1 * mm] * 3, {3: ENAMEL}, r"shape \(10, 8\).*\(nx, ny, nz\)"),
    (labels().astype(np.int16) - 1, [1 * mm] * 3, {3: ENAMEL}, "-1.*0 ... 65535"),
    (labels(), [1 * mm] * 3, {3: "enamel"}, "type str.*must be a Material"),
    (labels(), [1 * mm] * 3, {"three": ENAMEL}, "'three' is neither"),
    (labels()[:0], [1 * mm] * 3, {3: ENAMEL}, "dims"),
])
def test_what_is_wrong_with_labels_is_said(array, spacing, materials, message):
    with pytest.raises(hapticut.Error, match=message):
        hapticut.Workpiece.from_labels(array, spacing, materials)


def test_grey_values_become_a_workpiece():
    i, j, k = np.indices((20, 20, 20))
    ball = 8 - np.sqrt((i - 9.5) ** 2 + (j - 9.5) ** 2 + (k - 9.5) ** 2)
    ranges = [hapticut.GreyRange(0.0, np.inf, DENTIN)]
    for dtype in (np.float32, np.float64):
        workpiece = hapticut.Workpiece.from_intensity(ball.astype(dtype), [0.1 * mm] * 3, ranges)
        # 1 %: the ball has a radius of 8 samples, and its surface is interpolated.
        assert workpiece.amounts()[0].volume == pytest.approx(4 / 3 * np.pi * (0.8 * mm) ** 3, rel=0.01)
    grade = hapticut.Grade(0.0, 8.0, ENAMEL, DENTIN, steps=4)
    assert len(hapticut.Workpiece.from_intensity(ball, [0.1 * mm] * 3, grade).materials) == 4
    assert [m.name for m in hapticut.materials_of(grade)][0].startswith("enamel")
    shell = [hapticut.GreyRange(0.0, 1.0, ENAMEL), hapticut.GreyRange(1.0, np.inf, DENTIN)]
    by_ranges = hapticut.VolumeBuildOptions(partial_volume=False)
    with pytest.warns(UserWarning, match="no voxel is 'enamel', grey values 0 ... 1; .* or set partial_volume to false"):
        hard = hapticut.Workpiece.from_intensity(ball, [0.1 * mm] * 3, shell)
    soft = hapticut.Workpiece.from_intensity(ball, [0.1 * mm] * 3, shell, options=by_ranges)
    assert hard.amounts()[0].voxels == 0 < soft.amounts()[0].voxels
    ball[0, 0, 0] = np.nan
    with pytest.raises(hapticut.Error, match="finite"):
        hapticut.Workpiece.from_intensity(ball, [0.1 * mm] * 3, ranges)


def test_arrays_of_voxels_go_in_and_out_exactly(block):
    material, fill = block.material_array(), block.fill_array()
    again = hapticut.Workpiece.from_arrays(material, fill, block.frame, block.materials, block.bounds().min)
    assert again.hash() == block.hash()
    assert again.material_at(block.bounds().min) == 1 and again.fill_at([10**6, 0, 0]) == 0
    with pytest.raises(hapticut.Error, match="int64.*uint8"):
        hapticut.Workpiece.from_arrays(material.astype(int), fill, block.frame, block.materials)
    with pytest.raises(hapticut.Error, match="shape of material"):
        hapticut.Workpiece.from_arrays(material, fill[1:], block.frame, block.materials)
    with pytest.raises(hapticut.Error, match="id"):
        hapticut.Workpiece.from_arrays(material + np.uint8(4), fill, block.frame, block.materials)


def test_boxes_and_indices_at_the_end_of_all_numbers_are_safe(block):
    low, high = -(2**31), 2**31 - 1
    for box in (hapticut.IndexBox([low] * 3, [high] * 3), hapticut.IndexBox([low, 0, 0], [high, 0, 1])):
        for array in (block.material_array, block.fill_array):
            with pytest.raises(hapticut.Error, match="too large"):
                array(box)
    for corner in (low, high):
        assert block.material_array(hapticut.IndexBox([corner] * 3, [corner] * 3)).tolist() == [[[0]]]
        assert block.material_at([corner] * 3) == 0
    bounds = block.bounds()
    wider = hapticut.IndexBox([n - 1 for n in bounds.min], [n + 2 for n in bounds.max])
    assert np.array_equal(block.material_array(wider), np.pad(block.material_array(), [(1, 2)] * 3))
    two = np.ones((2, 2, 2), dtype=np.uint8)
    with pytest.raises(hapticut.Error, match="origin = 2147483647.*outside the range of indices"):
        hapticut.Workpiece.from_arrays(two, None, block.frame, block.materials, [high] * 3)
    with pytest.raises(hapticut.Error, match=r"2\^30"):
        hapticut.Workpiece.from_arrays(two, None, block.frame, block.materials, [low] * 3)
    with pytest.raises(hapticut.Error, match="reserve_blocks.*1e"):
        block.reserve_blocks(2**62)


def test_a_body_may_be_described_in_python():
    body = hapticut.BodyDescription(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3),
                                    lambda p: float(np.linalg.norm(p) - 0.8 * mm), lambda p: 1 if p[2] > 0 else 2)
    table = hapticut.MaterialTable([ENAMEL, DENTIN])
    workpiece = hapticut.build_body(body, 0.2 * mm, table, subsamples=4)
    upper, lower = workpiece.amounts()
    assert upper.volume + lower.volume == pytest.approx(4 / 3 * np.pi * (0.8 * mm) ** 3, rel=0.02)  # 8 voxels across

    def fails(p: np.ndarray) -> float:
        raise KeyError("from Python")

    body.distance = fails
    with pytest.raises(KeyError, match="from Python"):
        hapticut.build_body(body, 0.2 * mm, table)


def test_the_surface_of_a_block_is_a_closed_box(block):
    surface = hapticut.extract_surface(block)
    vertices, triangles = surface.mesh.vertices, surface.mesh.triangles
    a, b, c = (vertices[triangles[:, corner]] for corner in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(6 * 6 * 4 * mm**3, rel=0.01)
    assert len(surface.materials) == len(vertices) and set(surface.materials.tolist()) == {1}
    assert not vertices.flags.writeable and not triangles.flags.writeable
    del surface
    assert np.isfinite(vertices).all()  # the array keeps the mesh alive
    with pytest.raises(hapticut.Error):
        hapticut.extract_surface(block, 9)


def test_a_mesh_becomes_a_workpiece():
    mesh = hapticut.mesh_of_revolution(hapticut.catalogue.round_head(2 * mm).profile(), 48)
    workpiece = hapticut.build_from_mesh(mesh, DENTIN, hapticut.MeshImport(voxel_size=0.1 * mm))
    assert workpiece.amounts()[0].volume == pytest.approx(4 / 3 * np.pi * mm**3, rel=0.02)  # 48 facets around
    again = hapticut.TriangleMesh(np.array(mesh.vertices), np.array(mesh.triangles))
    assert np.array_equal(again.triangles, mesh.triangles)
    for dtype in (np.uint64, np.int16):
        assert len(hapticut.TriangleMesh(np.array(mesh.vertices), mesh.triangles.astype(dtype)).triangles) > 100
    with pytest.raises(hapticut.Error, match="names vertex 9999"):
        hapticut.TriangleMesh(np.array(mesh.vertices), np.array([[0, 1, 9999]]))
    with pytest.raises(hapticut.Error, match=r"vertices.*float32.*\(n, 3\)"):
        hapticut.TriangleMesh(np.array(mesh.vertices, dtype=np.float32), np.array(mesh.triangles))
    with pytest.raises(hapticut.Error, match="triangles.*float64"):
        hapticut.TriangleMesh(np.array(mesh.vertices), np.array(mesh.triangles, dtype=float))


def test_vdb_files_bring_back_every_bit(block, tmp_path):
    hapticut.io.save_vdb(block, tmp_path / "block.vdb")
    assert hapticut.io.load_vdb(str(tmp_path / "block.vdb")).hash() == block.hash()
    with pytest.raises(hapticut.Error, match="nothing.vdb"):
        hapticut.io.load_vdb(tmp_path / "nothing.vdb")


def test_volumes_go_through_files(tmp_path):
    if not hapticut.io.kWithIo:
        pytest.skip("hapticut was built without file formats (HAPTICUT_WITH_IMPORT)")
    volume = hapticut.volume.LabelVolume(labels(), [0.2 * mm, 0.3 * mm, 0.4 * mm],
                                         hapticut.Pose.from_translation([1 * mm, 0, 0]))
    hapticut.io.write_nrrd(volume, tmp_path / "labels.nrrd")
    again = hapticut.io.read_label_volume(tmp_path / "labels.nrrd")
    assert np.array_equal(again.values, labels()) and again.dims == labels().shape
    assert again.padding == 0  # only DICOM files have a padding value
    assert np.allclose(again.spacing, volume.spacing) and np.allclose(again.X_WG, volume.X_WG)
    assert np.allclose(again.position(1, 0, 0), [1.2 * mm, 0, 0])
    assert hapticut.volume.box_around(again, [7]).min == [4, 3, 1]
    with pytest.raises(hapticut.Error, match="gone.nrrd"):
        hapticut.io.read_grey_volume(tmp_path / "gone.nrrd")


def test_structs_copy_pickle_and_print(block):
    import copy
    import pickle

    material = hapticut.presets.enamel()
    assert repr(pickle.loads(pickle.dumps(material))) == repr(material) == repr(copy.deepcopy(material))
    config = hapticut.SimulationConfig(effects=hapticut.effects.Effects(gravity=hapticut.effects.Gravity(mass=0.1)))
    assert pickle.loads(pickle.dumps(config)).effects.gravity.mass == 0.1
    config.effects.limits.max_force = 3.0
    assert config.effects.limits.max_force == 3.0
    assert copy.copy(block).hash() == block.hash()
    with pytest.raises(TypeError, match="stiffnes"):
        hapticut.Material("typo", stiffnes=1.0)


def test_poses_come_as_matrices_and_twists_as_six_numbers():
    v = np.array([0.1, -0.2, 0.3])
    R = hapticut.rotation_from_vector(v)
    assert np.allclose(hapticut.vector_from_rotation(R), v) and hapticut.is_rotation(R, 1e-12)
    X = hapticut.advance(np.eye(4), np.concatenate([[1, 2, 3], v]), 1.0)
    assert np.allclose(X[:3, :3], R) and np.allclose(X[:3, 3], [1, 2, 3])
    assert np.allclose(hapticut.twist_between(np.eye(4), X, 1.0), [1, 2, 3, *v])
    assert np.allclose(hapticut.Pose.inverse(X) @ X, np.eye(4))
    assert np.allclose(hapticut.Pose.inverse(np.stack([X, X]))[1] @ X, np.eye(4))
    wrench = hapticut.transport(hapticut.Wrench(force=[0, 0, 1], torque=[0, 0, 0]), [1, 0, 0])
    assert np.allclose(wrench.torque, [0, -1, 0])
    assert np.allclose(hapticut.transport(np.array([0.0, 0, 0, 0, 0, 1]), [1, 0, 0]), [0, 1, 0, 0, 0, 1])
    with pytest.raises(hapticut.Error, match=r"a twist.*\(3,\).*\(6,\)"):
        hapticut.advance(np.eye(4), np.zeros(3), 1.0)
    with pytest.raises(hapticut.Error, match="a vector.*float32"):
        hapticut.rotation_from_vector(v.astype(np.float32))
    with pytest.raises(ValueError, match="shape"):
        hapticut.Pose.from_translation([1, 2])


def test_units_are_those_of_the_header():
    import re

    from conftest import REPOSITORY

    text = (REPOSITORY / "include/hapticut/core/units.hpp").read_text(encoding="utf-8")
    found = dict(re.findall(r"constexpr \w+ (\w+) = (?:AngularSpeed::in_rad_per_s\()?([^;)]+)\)?;", text))
    assert len(found) >= 10
    for name, value in found.items():
        expected = eval(value, {"kPi": np.pi})  # arithmetic from the project's header
        assert getattr(hapticut.units, name) == pytest.approx(expected, rel=1e-15), name


def test_presets_are_those_of_the_library():
    for name in hapticut.preset_names():
        assert repr(getattr(hapticut.presets, name)()) == repr(hapticut.find_preset(name))
        kind = hapticut.CutterKind.fine_diamond
        assert hapticut.find_preset(name, kind).cutter == (None if name in ("pulp", "clay") else kind)
    with pytest.raises(hapticut.Error, match="enamel"):
        hapticut.find_preset("unobtainium")


def test_the_constants_of_presets_have_ranges_and_sources():
    constants = hapticut.presets.preset_constants()
    assert len(constants) > 60 and all(c.low <= c.typical <= c.high and c.source for c in constants)
    edge = next(c for c in constants if (c.of, c.number) == ("twist_drill", "edge_length"))
    assert (edge.unit, edge.wears, edge.at(hapticut.Estimate.high)) == ("m", True, edge.high)
    kind = hapticut.CutterKind.twist_drill
    bone = hapticut.presets.cortical_bone(kind)
    assert bone.with_(hapticut.Estimate.high, "edge_length").edge_length == edge.high
    assert hapticut.presets.cortical_bone(kind, hapticut.Sharpness.new).edge_length == edge.low
    assert bone.with_(hapticut.Estimate.low).specific_cutting_energy < bone.specific_cutting_energy
    with pytest.raises(hapticut.Error, match="hardness"):
        bone.with_(hapticut.Estimate.low, "hardness")


def test_a_material_has_every_field_of_the_table_of_the_documentation():
    page = Path(__file__).resolve().parents[2] / "docs" / "heads-and-materials.md"
    head = next(line for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("| name"))
    columns = re.findall(r"(\w+) \[([^\]]+)\]", head)
    assert len(columns) > 8
    for name, unit in columns:
        assert getattr(hapticut.Material, name).__doc__.startswith(f"[{unit}] "), name
        material = hapticut.Material("clay", **{name: 0.25})
        assert getattr(material, name) == 0.25 and f"{name}=0.25" in repr(material)


def test_a_table_of_materials_is_a_container():
    table = hapticut.MaterialTable([hapticut.presets.enamel()])
    assert table.add(hapticut.presets.dentin()) == 2 and table.size() == len(table) == 2
    assert 2 in table and 3 not in table and [material.name for material in table] == ["enamel", "dentin"]
    assert table[2].name == "dentin" and table.id_of("dentin") == 2
    with pytest.raises(hapticut.Error):
        table[9]
    with pytest.raises(hapticut.Error, match=r"damping.*= -1"):
        hapticut.validate(hapticut.Material("x", damping=-1.0))


def test_builders_give_the_volumes_that_were_asked_for():
    clay = hapticut.presets.clay()
    molar = hapticut.build_molar(0.4 * mm, hapticut.MolarParameters(caries_depth=2 * mm))
    assert [m.name for m in molar.materials] == ["enamel", "dentin", "pulp", "caries"]
    assert hapticut.kMolarCaries == 4 and hapticut.describe_molar().material(np.zeros(3)) in (2, 3)
    ball = hapticut.build_sphere([0, 0, 0], 1 * mm, 0.1 * mm, clay)
    assert ball.amounts()[0].volume == pytest.approx(4 / 3 * np.pi * mm**3, rel=1e-3)
    layers = [hapticut.Layer(clay, 0.5 * mm), hapticut.Layer(hapticut.presets.pulp(), 1 * mm)]
    slab = hapticut.build_layered_slab(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3), 0.1 * mm, layers)
    assert [a.volume for a in slab.amounts()] == pytest.approx([2e-9, 4e-9], rel=1e-6)
    values = np.full((4, 4, 4), 2, np.uint16)
    labels = hapticut.volume.LabelVolume(values, [1 * mm] * 3)
    assert hapticut.build_from_labels(labels, [hapticut.LabelMaterial([2], clay)]).solid_voxels() == 64
    with pytest.raises(hapticut.Error, match="no material claims"):
        hapticut.build_from_labels(labels, [hapticut.LabelMaterial([1], clay)],
                                   unclaimed=hapticut.UnclaimedLabels.refuse)
    grey = hapticut.volume.GreyVolume(values.astype(float), [1 * mm] * 3)
    assert np.allclose(grey.position(1, 2, 3), [1 * mm, 2 * mm, 3 * mm]) and np.array_equal(grey.X_WG, np.eye(4))
    assert not hapticut.build_from_grey(grey, hapticut.Grade(1.0, 3.0, clay, hapticut.presets.pulp())).empty()
    shells = [hapticut.MeshShell(hapticut.mesh_of_revolution(hapticut.catalogue.round_head(2 * mm).profile(), 24), 1)]
    table = hapticut.MaterialTable([clay])
    assert hapticut.build_from_shells(shells, table, hapticut.MeshImport(0.2 * mm)).solid_voxels() > 0


def test_labels_that_are_too_thin_for_the_voxels_are_a_warning():
    array = np.zeros((20, 20, 10), np.uint8)
    array[3:17, 3:17, 1:7] = 1
    array[3:17, 3:17, 7] = 2
    materials = {1: hapticut.presets.dentin(), 2: hapticut.presets.enamel()}
    with pytest.warns(UserWarning, match="voxels of 0.3 mm are too coarse for the labels: .*'enamel' fills .* its labels 0.196 mm"):
        hapticut.Workpiece.from_labels(array, [0.1 * mm] * 3, materials,
                                       options=hapticut.VolumeBuildOptions(voxel_size=0.3 * mm))
    hapticut.Workpiece.from_labels(array, [0.1 * mm] * 3, materials)  # warnings are errors here


def test_an_open_mesh_is_a_warning():
    mesh = hapticut.mesh_of_revolution(hapticut.catalogue.round_head(2 * mm).profile(), 24)
    hapticut.build_from_mesh(mesh, DENTIN, hapticut.MeshImport(0.2 * mm))  # warnings are errors here
    mesh = hapticut.TriangleMesh(np.array(mesh.vertices), np.array(mesh.triangles)[:-1])
    with pytest.warns(UserWarning, match="is open: 3 of its edges have one face"):
        hapticut.build_from_mesh(mesh, DENTIN, hapticut.MeshImport(0.2 * mm))


def test_a_workpiece_tells_what_it_is(block):
    bounds = block.bounds()
    assert bounds.voxels() == block.solid_voxels() == 60 * 60 * 40 and block.voxel_size == block.frame.voxel_size
    assert np.allclose(block.centroid_at(bounds.min), 0) and block.material_at([-5, 0, 0]) == 0
    assert np.allclose(block.frame.center([0, 0, 0]), block.frame.X_WV[:3, 3])
    [amount] = block.amounts()
    assert amount.material == 1 and amount.mass == pytest.approx(amount.volume * block.materials[1].density)
    middle = ((np.array(bounds.min) + bounds.max) // 2).tolist()
    assert amount.center == pytest.approx(block.frame.center(middle), abs=0.1 * mm)
    block.reserve_undo(10)
    block.set_mark()
    assert block.marks == 1 and block.undo_block() is None and block.marks == 0  # nothing was cut since
    assert block.redo_marks == 1 and block.redo_block() is None and block.marks == 1
    with pytest.raises(hapticut.Error, match="empty"):
        block.material_array(hapticut.IndexBox())
