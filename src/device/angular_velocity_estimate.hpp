// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// Angular velocity as the filtered difference of orientations, for devices without a reliable angular velocity.
/// @realtime no allocation, no lock
class AngularVelocityEstimate {
 public:
  void restart() noexcept {
    started_ = false;
    angular_velocity_.setZero();
  }

  /// @param time [s] of the orientation; readings may come at an unexpected rate, and some may be missing
  /// @return [rad/s] in B
  const Vec3& update(const Mat3& R_BS, double time) noexcept {
    const bool has_last = started_ && R_BS_last_.allFinite();
    if (has_last && !(time > time_last_)) return angular_velocity_;
    const double elapsed = time - time_last_;
    const Vec3 rotation = has_last ? vector_from_rotation(R_BS * R_BS_last_.transpose()) : Vec3::Zero();
    started_ = true;
    time_last_ = time;
    R_BS_last_ = R_BS;
    if (!has_last) return angular_velocity_;
    const double memory = std::exp(-2 * units::kPi * kFilter * elapsed);
    angular_velocity_ = memory * angular_velocity_ + (1 - memory) / elapsed * rotation;
    if (!angular_velocity_.allFinite()) angular_velocity_.setZero();
    return angular_velocity_;
  }

 private:
  static constexpr double kFilter = 30;  // [Hz]

  bool started_ = false;
  double time_last_ = 0;
  Mat3 R_BS_last_ = Mat3::Identity();
  Vec3 angular_velocity_ = Vec3::Zero();
};

}  // namespace hapticut
