// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hapticut/core/spatial.hpp"

/// Limits of the motion of a hand with a stylus. A larger motion is an error of the device or a new position.
namespace hapticut {

inline constexpr double kNear = 2e-3;               // [m] from the last pose
inline constexpr double kMaxHandSpeed = 6;          // [m/s] three times the speed of hands
inline constexpr double kMaxSlip = 0.1;             // [rad] error of a reading
inline constexpr double kMaxHandAngularSpeed = 40;  // [rad/s]

/// [rad] Angle of the rotation between two poses.
inline double rotation_between(const Pose& from, const Pose& to) {
  return vector_from_rotation(to.rotation * from.rotation.transpose()).norm();
}

/// Whether a rotation is larger than an angle [rad], from its trace. This is cheaper than the angle, and every step
/// needs it.
inline bool rotated_beyond(const Pose& from, const Pose& to, double angle) {
  return angle < std::numbers::pi && from.rotation.cwiseProduct(to.rotation).sum() < 1 + 2 * std::cos(angle);
}

inline bool is_rotation_of_a_hand(const Pose& from, const Pose& to, double dt) {
  return !rotated_beyond(from, to, std::max(kMaxSlip, kMaxHandAngularSpeed * dt));
}

inline bool is_path_of_a_hand(const Pose& from, const Pose& to, double dt) {
  return (to.translation - from.translation).norm() <= std::max(kNear, kMaxHandSpeed * dt);
}

}  // namespace hapticut
