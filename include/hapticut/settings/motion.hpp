// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut::settings {

/// Where something is at a time.
struct TimedPose {
  double t;  ///< [s]
  Pose pose;
};

/// A pose at every time between the first and the last of a list: positions in between are interpolated linearly,
/// rotations along the shortest turn (slerp).
class Motion {
 public:
  /// @param poses  at least two, times increasing
  /// @throws Error otherwise
  explicit Motion(std::vector<TimedPose> poses);

  [[nodiscard]] double duration() const { return poses_.back().t - poses_.front().t; }  ///< [s]
  [[nodiscard]] const std::vector<TimedPose>& poses() const { return poses_; }

  /// @param t  [s] since the first pose; before it and after the last the motion stands still
  [[nodiscard]] Pose pose_at(double t) const;

 private:
  std::vector<TimedPose> poses_;
};

}  // namespace hapticut::settings
