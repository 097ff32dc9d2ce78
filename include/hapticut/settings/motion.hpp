// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut::settings {

/// A pose at one time.
struct TimedPose {
  double t;  ///< [s]
  Pose pose;
};

/// A motion through a list of timed poses. Between two poses, the position is interpolated linearly and the rotation by
/// slerp.
class Motion {
 public:
  /// @param poses  at least two, with increasing times
  /// @throws Error otherwise
  explicit Motion(std::vector<TimedPose> poses);

  [[nodiscard]] double duration() const { return poses_.back().t - poses_.front().t; }  ///< [s]
  [[nodiscard]] const std::vector<TimedPose>& poses() const { return poses_; }

  /// @param t  [s] since the first pose; clamped to 0 ... duration
  [[nodiscard]] Pose pose_at(double t) const;

 private:
  std::vector<TimedPose> poses_;
};

}  // namespace hapticut::settings
