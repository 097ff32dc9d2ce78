# SPDX-License-Identifier: Apache-2.0
"""Ready-made materials. ``docs/heads-and-materials.md`` names the source of every number.

The constants depend on the kind of cutter, by default a carbide bur: ``presets.dentin(CutterKind.twist_drill)``.
"""
from __future__ import annotations

from typing import TYPE_CHECKING

from . import _hapticut
from ._export import export
from ._hapticut import Material, find_preset

if TYPE_CHECKING:
    from ._hapticut import CutterKind

__all__ = ["amalgam", "caries", "clay", "cortical_bone", "dentin", "enamel", "pulp", "trabecular_bone"]


def enamel(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Human enamel."""
    return find_preset("enamel", cutter)


def dentin(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Human dentin."""
    return find_preset("dentin", cutter)


def pulp(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Dental pulp, a soft tissue."""
    return find_preset("pulp", cutter)


def caries(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Decayed hard tissue."""
    return find_preset("caries", cutter)


def amalgam(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Set high-copper amalgam."""
    return find_preset("amalgam", cutter)


def cortical_bone(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Cortical bone."""
    return find_preset("cortical_bone", cutter)


def trabecular_bone(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Trabecular (cancellous) bone with its marrow, as a continuum."""
    return find_preset("trabecular_bone", cutter)


def clay(cutter: CutterKind = _hapticut.CutterKind.carbide_bur) -> Material:
    """Modelling clay, for exercises and for comparing devices."""
    return find_preset("clay", cutter)


export(__name__)
