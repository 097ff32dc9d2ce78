# SPDX-License-Identifier: Apache-2.0
"""Ready-made materials. ``docs/materials.md`` names the source of every number.

All but ``enamel_with_diamond`` hold for a carbide round or fissure burr of 1 ... 4 mm that takes chips from a few micrometres to some tens of
micrometres; for a tool of another kind set ``specific_cutting_energy``, ``cutting_ratio`` and ``edge_pressure`` again.
"""
from ._hapticut import Material, find_preset


def enamel() -> Material:
    """Human enamel."""
    return find_preset("enamel")


def enamel_with_diamond() -> Material:
    """Human enamel under a diamond bur."""
    return find_preset("enamel_with_diamond")


def dentin() -> Material:
    """Human dentin."""
    return find_preset("dentin")


def pulp() -> Material:
    """Dental pulp, a soft tissue."""
    return find_preset("pulp")


def caries() -> Material:
    """Decayed hard tissue."""
    return find_preset("caries")


def amalgam() -> Material:
    """Set high-copper amalgam."""
    return find_preset("amalgam")


def cortical_bone() -> Material:
    """Cortical bone."""
    return find_preset("cortical_bone")


def trabecular_bone() -> Material:
    """Trabecular (cancellous) bone with its marrow, as a continuum."""
    return find_preset("trabecular_bone")


def clay() -> Material:
    """Modelling clay, for exercises and for comparing devices."""
    return find_preset("clay")
