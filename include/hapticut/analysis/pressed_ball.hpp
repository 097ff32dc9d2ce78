// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hapticut/analysis/stability.hpp"
#include "hapticut/simulation/coupling.hpp"

namespace hapticut {

/// A ball that is pressed into a half space of voxels: the library's model for the closed loop, where `LinearWall` is
/// the textbook's. The ball is at the handle; it touches when the device is `radius` above z = 0.
struct PressedBall {
  double radius = 1e-3;                   ///< [m] > 0 of the ball
  double voxel_size = 1e-4;               ///< [m] > 0
  std::optional<CouplingGains> coupling;  ///< empty: the device feels the material directly
};

/// Makes models whose stiffness parameter is k_v [N/m^4] of the material.
/// @throws Error when a model is made with a number out of range
[[nodiscard]] ModelFactory contact_models(const PressedBall& ball);

/// Settings to search for the maximum stable k_v: the hand presses 5 mm deep, and is nudged once it is at rest.
[[nodiscard]] StabilitySearch pressed_search(const PressedBall& ball);

}  // namespace hapticut
