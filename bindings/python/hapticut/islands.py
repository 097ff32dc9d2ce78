# SPDX-License-Identifier: Apache-2.0
"""Pieces that were cut loose: found, and let go by Simulation.remove_island."""
from ._export import export
from ._hapticut import (
    Island as Island,
    IslandFinder as IslandFinder,
    IslandOptions as IslandOptions,
    IslandRemoval as IslandRemoval,
    find_islands as find_islands,
)

export(__name__)
