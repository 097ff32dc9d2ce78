// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut::apps {

/// The material that the tip of a head is in, or the first one before it along its axis; kEmpty: none within 20 mm.
/// @realtime no allocation, no lock; O(voxels along 20 mm, of empty blocks one in eight)
[[nodiscard]] inline MaterialId material_under(const Workpiece& workpiece, const ToolHead& head,
                                               const Pose& X_WT) noexcept {
  constexpr double kLength = 0.02;  // [m]
  const auto hit = workpiece.first_hit(X_WT * Vec3(0, 0, head.tip()), X_WT.rotation * Vec3(0, 0, -1), kLength);
  return hit ? hit->material : kEmpty;
}

}  // namespace hapticut::apps
