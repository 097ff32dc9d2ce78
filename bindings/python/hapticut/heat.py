# SPDX-License-Identifier: Apache-2.0
"""Temperatures: heat from cutting and rubbing, its conduction, and its effect on the material."""
from ._export import export
from ._hapticut import (
    HeatBalance as HeatBalance,
    HeatConfig as HeatConfig,
    HeatField as HeatField,
    StructureHeat as StructureHeat,
    WarmestPlace as WarmestPlace,
    cem43 as cem43,

    # Properties of known materials
    KnownThermalProperties as KnownThermalProperties,
    ThermalProperties as ThermalProperties,
    known_thermal_properties as known_thermal_properties,
    thermal_properties_of as thermal_properties_of,

    # Heat from the steps
    HeatCollector as HeatCollector,
    HeatCollectorOptions as HeatCollectorOptions,
    HeatPulse as HeatPulse,
    touching_point as touching_point,
)

export(__name__)
