// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hapticut/workpiece/block_grid.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Cuts balls out of a workpiece without a simulation, with the functions of the step: fast enough for thousands of
/// cuts.
namespace hapticut::test {

/// Cuts a ball. Voxels at its surface keep the part outside a tangent plane.
/// @param center, radius  [voxels]
/// @return the blocks that were changed
inline std::vector<VoxelIndex> cut_ball(Workpiece& workpiece, const Vec3& center, double radius) {
  std::vector<VoxelIndex> changed;
  VoxelIndex low, high;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = int(std::floor(center[Eigen::Index(axis)] - radius - 1));
    high[axis] = int(std::ceil(center[Eigen::Index(axis)] + radius + 1));
  }
  workpiece.forget_redo();
  for_each_block_origin({low, high}, [&](const VoxelIndex& origin) {
    const BlockView before = workpiece.block(origin);
    if (before.empty()) return;
    std::array<float, kBlockVoxels> left;
    BlockMask emptied;
    bool cuts = false;
    for (int n = 0; n < kBlockVoxels; ++n) {
      const VoxelIndex at = voxel_at(origin, n);
      const double distance = (Vec3(at[0], at[1], at[2]) - center).norm() - radius;
      left[std::size_t(n)] = std::min(before.fill_of(n), float(std::clamp(distance + 0.5, 0.0, 1.0)));
      cuts = cuts || left[std::size_t(n)] < before.fill_of(n);
      if (left[std::size_t(n)] == 0 && before.fill_of(n) > 0) emptied.add(n);
    }
    if (!cuts) return;
    workpiece.remember(before);
    float* fill = workpiece.writable_fill(origin);
    if (fill == nullptr) return;  // the pool is exhausted: the block stays as it is
    std::copy(left.begin(), left.end(), fill);
    workpiece.empty_voxels(origin, emptied);
    changed.push_back(origin);
  });
  return changed;
}

/// A block of two materials whose faces lie within voxels, with a tilted seam between them.
inline Workpiece two_materials(double edge, double voxel_size) {
  Material upper, lower;
  upper.name = "upper", lower.name = "lower";
  const double h = 0.5 * edge;
  const auto distance = [h](const Vec3& p) {
    return std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) - h;
  };
  return build_body({{Vec3::Constant(-h), Vec3::Constant(h)},
                     distance,
                     [](const Vec3& p) { return MaterialId(p.dot(Vec3(1, 2, 5)) < 0 ? 2 : 1); }},
                    voxel_size, MaterialTable({upper, lower}));
}

}  // namespace hapticut::test
