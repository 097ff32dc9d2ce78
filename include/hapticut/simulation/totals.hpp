// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/material_set.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// Sums since construction or `Simulation::reset`, and counters.
struct SimulationTotals {
  const ByMaterial<double>& removed_volume;   ///< [m^3] cut, by MaterialId
  const ByMaterial<double>& detached_volume;  ///< [m^3] removed by Simulation::remove_voxels, by MaterialId

  /// The materials that were touched, by steps that were not rejected.
  const MaterialSet& touched;

  /// By MaterialId, the value of `Simulation::steps` after the step that touched a material for the first time; 0: not
  /// yet.
  const ByMaterial<std::uint64_t>& first_touch;

  /// How often something other than a step has changed the workpiece, tool or materials: WorkpieceHistory::restore,
  /// `undo` and `redo`, Simulation::reset, `set` and `exchange`. Effects do not count. Observers are told of each.
  /// `reset` keeps this number.
  std::uint64_t exchanges;

  /// How often the workpiece as a whole was replaced: by `restore`, `reset` and the exchange of a simulation. Also
  /// counted in `exchanges`. `reset` keeps this number.
  std::uint64_t replacements;
};

}  // namespace hapticut
