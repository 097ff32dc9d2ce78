// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// Angular velocity as the filtered difference of orientations, for devices that report none that can be relied on.
/// @realtime no allocation, no lock
class TurningEstimate {
 public:
  void restart() noexcept {
    started_ = false;
    angular_velocity_.setZero();
  }

  /// @param period [s] > 0 since the last orientation
  /// @return [rad/s] in B
  const Vec3& update(const Mat3& R_BS, double period) noexcept {
    if (!started_ || !R_BS_last_.allFinite()) R_BS_last_ = R_BS;
    started_ = true;
    const Vec3 turn = vector_from_rotation(R_BS * R_BS_last_.transpose());
    R_BS_last_ = R_BS;
    const double memory = std::exp(-2 * units::kPi * kFilter * period);
    angular_velocity_ = memory * angular_velocity_ + (1 - memory) / period * turn;
    if (!angular_velocity_.allFinite()) angular_velocity_.setZero();
    return angular_velocity_;
  }

 private:
  static constexpr double kFilter = 30;  // [Hz]

  bool started_ = false;
  Mat3 R_BS_last_ = Mat3::Identity();
  Vec3 angular_velocity_ = Vec3::Zero();
};

}  // namespace hapticut
