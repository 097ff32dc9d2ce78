# SPDX-License-Identifier: Apache-2.0
"""Ready-made materials, and the table of their numbers, each with its range and source: `preset_constants`.

The constants depend on the kind of cutter, by default a carbide bur, and on its sharpness:
``presets.cortical_bone(CutterKind.twist_drill, Sharpness.worn)``. ``material.with_(Estimate.low)`` is the same preset at
the lower end of its ranges.
"""
from __future__ import annotations

from typing import TYPE_CHECKING

from . import _hapticut
from ._export import export, move
from ._hapticut import Material, PresetConstant, find_preset, preset_constants

if TYPE_CHECKING:
    from ._hapticut import CutterKind, Sharpness

_BUR, _USED = _hapticut.CutterKind.carbide_bur, _hapticut.Sharpness.used

__all__ = ["PresetConstant", "amalgam", "bone_d1", "bone_d2", "bone_d3", "bone_d4", "bone_d5", "caries", "clay",
           "cortical_bone", "dentin", "enamel", "preset_constants", "pulp", "trabecular_bone"]


def enamel(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Human enamel."""
    return find_preset("enamel", cutter, sharpness)


def dentin(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Human dentin."""
    return find_preset("dentin", cutter, sharpness)


def pulp(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Dental pulp, a soft tissue, which every cutter cuts alike."""
    return find_preset("pulp", cutter, sharpness)


def caries(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Decayed hard tissue."""
    return find_preset("caries", cutter, sharpness)


def amalgam(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Set high-copper amalgam."""
    return find_preset("amalgam", cutter, sharpness)


def cortical_bone(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Cortical bone."""
    return find_preset("cortical_bone", cutter, sharpness)


def trabecular_bone(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Trabecular (cancellous) bone with its marrow, as a continuum."""
    return find_preset("trabecular_bone", cutter, sharpness)


def bone_d1(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Bone of class 1: almost only compact bone."""
    return find_preset("bone_d1", cutter, sharpness)


def bone_d2(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Bone of class 2: a thick compact layer on dense trabeculae."""
    return find_preset("bone_d2", cutter, sharpness)


def bone_d3(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Bone of class 3: a thin compact layer on dense trabeculae."""
    return find_preset("bone_d3", cutter, sharpness)


def bone_d4(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Bone of class 4: a thin compact layer on loose trabeculae."""
    return find_preset("bone_d4", cutter, sharpness)


def bone_d5(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Bone of class 5: loose trabeculae."""
    return find_preset("bone_d5", cutter, sharpness)


def clay(cutter: CutterKind = _BUR, sharpness: Sharpness = _USED) -> Material:
    """Modelling clay, for exercises and for comparing devices, which every cutter cuts alike."""
    return find_preset("clay", cutter, sharpness)


move(PresetConstant, __name__)
move(preset_constants, __name__)
export(__name__)
