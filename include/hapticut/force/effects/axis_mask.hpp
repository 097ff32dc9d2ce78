// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Which components of the output are on (thesis Table 6.2, "Force & Torque Outputs"), in the axes of W.
struct AxisMask {
  std::array<bool, 3> force = {true, true, true};   ///< which components are on, along x, y, z
  std::array<bool, 3> torque = {true, true, true};  ///< which components are on, about x, y, z
};

constexpr auto fields_of(Of<AxisMask>) {
  return std::tuple{
      field("force", &AxisMask::force, "which components are on, along x, y, z"),
      field("torque", &AxisMask::torque, "which components are on, about x, y, z"),
  };
}

/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Wrench masked(const AxisMask& mask, const Wrench& wrench) {
  Wrench out = wrench;
  for (int axis = 0; axis < 3; ++axis) {
    if (!mask.force[std::size_t(axis)]) out.force[axis] = 0;
    if (!mask.torque[std::size_t(axis)]) out.torque[axis] = 0;
  }
  return out;
}

}  // namespace hapticut
