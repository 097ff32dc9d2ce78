// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// A vector no longer than `longest`, in the same direction.
[[nodiscard]] inline Vec3 saturated(const Vec3& v, double longest) {
  const double length = v.norm();
  return length > longest ? Vec3(v * (longest / length)) : v;
}

/// One tick of a limit on growth: what `from` may become on its way to `target`.
///
/// A force may shrink along its own direction at once; from the shrunken one it moves towards the target by at most
/// `most`. A limit on shrinking would make a wall active (docs/devices.md).
[[nodiscard]] inline Vec3 growth_limited(const Vec3& from, const Vec3& target, double most) {
  const double squared = from.squaredNorm();
  const Vec3 start = squared > 0 ? Vec3(std::clamp(target.dot(from) / squared, 0.0, 1.0) * from) : from;
  return start + saturated(target - start, most);
}

}  // namespace hapticut
