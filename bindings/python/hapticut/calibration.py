# SPDX-License-Identifier: Apache-2.0
"""Constants of a material from drilling tests, and drilling forces from constants."""
from ._export import export
from ._hapticut import (
    AxialCutForce as AxialCutForce,
    Calibration as Calibration,
    ChipTerm as ChipTerm,
    DrillingTest as DrillingTest,
    advice_on as advice_on,
    axial_cut_force as axial_cut_force,
    calibrate as calibrate,
    presets_beside as presets_beside,
)

export(__name__)
