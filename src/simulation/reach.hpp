// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/block.hpp"

namespace hapticut {

/// The box of voxels that the head can reach, cut to `bounds`.
/// @param beyond  [voxels] how far outside the head the centre of a voxel may be
inline IndexBox reach_of(const HeadBox& box, const Pose& X_VT, double voxel_size, const IndexBox& bounds,
                         double beyond) noexcept {
  const Vec3 center = X_VT * Vec3(0.5 * (box.min + box.max)) / voxel_size;
  const Vec3 half = X_VT.rotation.cwiseAbs() * (0.5 * (box.max - box.min)) / voxel_size;
  IndexBox voxels;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::ceil(center[axis] - half[axis] - beyond);
    const double high = std::floor(center[axis] + half[axis] + beyond);
    voxels.min[axis] = int(std::clamp(low, double(bounds.min[axis]), bounds.max[axis] + 1.0));
    voxels.max[axis] = int(std::clamp(high, bounds.min[axis] - 1.0, double(bounds.max[axis])));
  }
  return voxels;
}

}  // namespace hapticut
