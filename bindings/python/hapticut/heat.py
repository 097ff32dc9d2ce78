# SPDX-License-Identifier: Apache-2.0
"""Temperatures beside the steps: what cutting and rubbing bring in, how it spreads, what it does to the material."""
from ._export import export
from ._hapticut import (
    HeatBalance as HeatBalance,
    HeatConfig as HeatConfig,
    HeatField as HeatField,
    StructureHeat as StructureHeat,
    ThermalProperties as ThermalProperties,
    cem43 as cem43,

    # Out of the steps
    HeatCollector as HeatCollector,
    HeatCollectorOptions as HeatCollectorOptions,
    HeatPulse as HeatPulse,
    touching_point as touching_point,
)

export(__name__)
