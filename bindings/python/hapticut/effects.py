# SPDX-License-Identifier: Apache-2.0
"""Effects added to the model's force before a hand feels it, in the order of the step."""
from ._export import export
from ._hapticut import (
    Effects as Effects,
    EffectsInput as EffectsInput,
    Output as Output,

    # Gravity, vibration, teeth, delta filter, axis mask
    AxisMask as AxisMask,
    CutterAngle as CutterAngle,
    DeltaFilter as DeltaFilter,
    Gravity as Gravity,
    ToothPassing as ToothPassing,
    Vibration as Vibration,
    VibrationPhase as VibrationPhase,
    filtered as filtered,
    gravity_wrench as gravity_wrench,
    masked as masked,

    # Limits of the output
    OutputLimits as OutputLimits,
    growth_limited as growth_limited,
    min_force_growth as min_force_growth,
    saturated as saturated,
)

export(__name__)
