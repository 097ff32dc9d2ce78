# SPDX-License-Identifier: Apache-2.0
"""hapticut reads valid files with the same result as pydicom, nibabel, SimpleITK and trimesh. A comparison is skipped
if its file is missing."""
from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import nibabel
import numpy as np
import pydicom
import pytest
import SimpleITK as sitk
import trimesh

import hapticut as h
from hapticut.units import mm

DATA = Path(os.environ.get("HAPTICUT_TEST_DATA", Path(__file__).resolve().parents[3] / "shared" / "data"))
pytestmark = pytest.mark.skipif(not h.io.kWithIo, reason="hapticut was built without file formats (HAPTICUT_WITH_IMPORT)")


def existing(*names: str) -> list[object]:
    """Parameters of a test: one data file each. The test of a missing file is skipped, and names the file."""
    absent = pytest.mark.skip(reason="needs real input files, which are not on this machine")
    return [pytest.param(DATA / n, id=n, marks=[] if (DATA / n).exists() else [absent]) for n in names]


def compare(volume: h.volume.GreyVolume, value_at: Callable[[np.ndarray], float], tolerance: float) -> None:
    """Checks that samples at random places have the value that another reader finds there.

    value_at: the value of the other reader at a place (3,) [mm] in LPS
    """
    random = np.random.default_rng(1)
    for _ in range(200):
        index = random.integers(0, volume.dims)
        place = volume.position(*index)
        ours = float(volume.values[tuple(index)])
        theirs = value_at(place / mm)
        assert ours == pytest.approx(theirs, rel=tolerance, abs=tolerance, nan_ok=True), index


@pytest.mark.parametrize("path", existing(
    "formats/example_ct_sm.nii.gz", "formats/example_seg.nii.gz", "formats/BallBinary30x30x30.nii.gz", "teeth/tooth_2.nii.gz",
    "hostile/nifti-sform-qform.nii", "hostile/nifti-slope0.nii", "hostile/nifti-nan.nii", "hostile/nifti2.nii"))
def test_nifti_is_what_nibabel_reads(path: Path) -> None:
    image = nibabel.load(path)
    if not (image.header["sform_code"] > 0 or image.header["qform_code"] > 0):
        pytest.skip("the file has no position: nibabel puts its centre at the origin, hapticut its first sample")
    data, to_index = image.get_fdata(), np.linalg.inv(image.affine)

    def value_at(p: np.ndarray) -> float:
        index = to_index @ np.array([-p[0], -p[1], p[2], 1])
        return float(data[tuple(np.rint(index[:3]).astype(int))])

    compare(h.io.read_grey_volume(path), value_at, 1e-6)


# Not compared: files that ITK reads differently, for reasons in docs/files.md (`left-anterior-superior`, a slope of 0,
# the quaternion before the affine map, MONOCHROME1).
@pytest.mark.parametrize("path", existing(
    "formats/BallBinary30x30x30.nrrd", "formats/BallBinary30x30x30_gz.nrrd", "formats/BallBinary30x30x30.nhdr",
    "formats/tooth_closed.mhd", "formats/frogtissue.mhd", "formats/example_ct_sm.nii.gz", "teeth/tooth.mhd"))
def test_volumes_are_what_simpleitk_reads(path: Path) -> None:
    image = sitk.ReadImage(str(path))

    def value_at(p: np.ndarray) -> float:
        return float(image[image.TransformPhysicalPointToIndex([float(c) for c in p])])

    compare(h.io.read_grey_volume(path), value_at, 1e-6)


@pytest.mark.parametrize("path", existing("formats/example_ct_dicom", "hostile/mono1", "hostile/rtdose-bigendian32.dcm"))
def test_dicom_is_what_pydicom_reads(path: Path) -> None:
    files = [pydicom.dcmread(f) for f in (sorted(path.iterdir()) if path.is_dir() else [path])]
    values = np.concatenate([f.pixel_array.ravel() * float(f.get("RescaleSlope", 1)) + float(f.get("RescaleIntercept", 0))
                             for f in files])
    ours = h.io.read_grey_volume(path)
    assert ours.values.size == values.size
    assert np.array_equal(np.sort(ours.values.ravel()), np.sort(values.astype(np.float32)))
    row, column = (float(s) for s in files[0].PixelSpacing)
    assert np.allclose(np.asarray(ours.spacing)[:2] / mm, [column, row])


@pytest.mark.parametrize("path", existing(
    "meshes/box.STL", "meshes/burr.stl", "meshes/molar_chai3d.obj", "meshes/handpiece_chai3d.obj", "teeth/URI1_tooth_mesh1.ply"))
def test_meshes_are_what_trimesh_reads(path: Path) -> None:
    def area_and_volume(corners: np.ndarray) -> np.ndarray:  # of an open mesh: the volume closed at the origin
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        return np.array([0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum(),
                         np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6])

    ours = sum(area_and_volume(np.asarray(named.mesh.vertices)[np.asarray(named.mesh.triangles)] / mm)
               for named in h.io.read_mesh(path))
    theirs = area_and_volume(np.asarray(trimesh.load(path, force="mesh", process=False).triangles))
    assert ours == pytest.approx(theirs, rel=1e-6, abs=1e-6 * theirs[0])
