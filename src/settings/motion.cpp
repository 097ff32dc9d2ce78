// SPDX-License-Identifier: Apache-2.0
#include "hapticut/settings/motion.hpp"

#include <algorithm>

#include "hapticut/core/errors.hpp"

namespace hapticut::settings {

Motion::Motion(std::vector<TimedPose> poses) : poses_(std::move(poses)) {
  if (poses_.size() < 2)
    throw Error("a path has " + std::to_string(poses_.size()) + " pose; it needs at least two, at different places.");
  for (std::size_t i = 1; i < poses_.size(); ++i)
    if (!(poses_[i].t > poses_[i - 1].t))
      throw Error("the times of a path must increase; after " + format_number(poses_[i - 1].t, poses_[i].t) +
                  " s comes " + format_number(poses_[i].t, poses_[i - 1].t) + " s.");
}

Pose Motion::pose_at(double t) const {
  const double time = poses_.front().t + t;
  const auto after = std::upper_bound(poses_.begin(), poses_.end(), time,
                                      [](double value, const TimedPose& pose) { return value < pose.t; });
  if (after == poses_.begin()) return poses_.front().pose;
  if (after == poses_.end()) return poses_.back().pose;
  const TimedPose& before = *(after - 1);
  const double length = after->t - before.t;
  return advance(before.pose, twist_between(before.pose, after->pose, length), time - before.t);
}

}  // namespace hapticut::settings
