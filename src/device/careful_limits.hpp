// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// What is asked of a device that neither says nor is known for what it can.
namespace hapticut {

inline constexpr double kCarefulForce = 1;       ///< [N]
inline constexpr double kCarefulTorque = 0.048;  ///< [N·m] the weakest axis of a Phantom Premium 6-DOF

}  // namespace hapticut
