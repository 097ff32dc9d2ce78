# SPDX-License-Identifier: Apache-2.0
"""Temperatures: heat from cutting and rubbing, its conduction, and its effect on the material."""
from ._export import export
from ._hapticut import (
    HeatBalance as HeatBalance,
    HeatConfig as HeatConfig,
    HeatField as HeatField,
    StructureHeat as StructureHeat,
    ThermalProperties as ThermalProperties,
    cem43 as cem43,

    # Heat from the steps
    HeatCollector as HeatCollector,
    HeatCollectorOptions as HeatCollectorOptions,
    HeatPulse as HeatPulse,
    touching_point as touching_point,
)

export(__name__)
