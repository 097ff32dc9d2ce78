# SPDX-License-Identifier: Apache-2.0
"""Finds and removes loose pieces; in a loop by ``SimulationModel(islands=...)``."""
from ._export import export
from ._hapticut import (
    Island as Island,
    IslandFinder as IslandFinder,
    IslandOptions as IslandOptions,
    IslandRemoval as IslandRemoval,
    IslandWatchOptions as IslandWatchOptions,
    find_islands as find_islands,
    remove_island as remove_island,
)

export(__name__)
