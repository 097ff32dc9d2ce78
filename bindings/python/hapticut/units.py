# SPDX-License-Identifier: Apache-2.0
"""Factors from common units to SI: ``0.6 * units.mm`` is a length in metres."""
import math

from ._export import export

__all__ = ["N_mm", "N_per_mm3_per_mm", "deg", "kPi", "mN_m", "mm", "mm3", "mm_per_s", "ms", "rad_per_s", "rpm", "um"]

kPi = math.pi
mm = 1e-3  #: [m]
um = 1e-6  #: [m]
ms = 1e-3  #: [s]
mm_per_s = 1e-3  #: [m/s]
rpm = 2 * math.pi / 60  #: [rad/s]
rad_per_s = 1.0  #: [rad/s]
deg = math.pi / 180  #: [rad]
mN_m = 1e-3  #: [N·m]
N_mm = 1e-3  #: [N·m]
mm3 = 1e-9  #: [m^3]
N_per_mm3_per_mm = 1e12  #: [N/m^4] stiffness of the volumetric foundation

export(__name__)
