// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "hapticut/simulation/config.hpp"

namespace hapticut {

/// Number of removed voxels that a list must contain; 0 when nobody wants it.
/// @param automatic  number when the configuration leaves it to the simulation
[[nodiscard]] inline std::size_t removed_list_size(const SimulationConfig& config, std::size_t automatic) {
  if (!config.list_removed_voxels) return 0;
  return config.removed_voxel_capacity > 0 ? config.removed_voxel_capacity : automatic;
}

}  // namespace hapticut
