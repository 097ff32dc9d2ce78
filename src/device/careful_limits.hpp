// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Limits for a device of unknown capabilities.
namespace hapticut {

inline constexpr double kCarefulForce = 1;       ///< [N]
inline constexpr double kCarefulTorque = 0.048;  ///< [N·m] the weakest axis of a Phantom Premium 6-DOF

}  // namespace hapticut
