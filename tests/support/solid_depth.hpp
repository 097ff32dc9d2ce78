// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/block_grid.hpp"

/// @file
/// The depth of solid material in a head, and its allowed depth.
namespace hapticut::test {

/// [Pa] Strength at which a material is crushed; a material without one counts as cortical bone.
[[nodiscard]] inline double strength_of(const Material& material) {
  return material.compressive_strength > 0 ? material.compressive_strength : 150e6;
}

/// [m] Depth at which the pressure k w^2/2 of the foundation reaches a strength.
[[nodiscard]] inline double crushing_depth(double k_v, double strength) { return std::sqrt(2 * strength / k_v); }

/// [m] 1.1 times the maximum crushing depth over all materials of a workpiece. Deeper material is crushed.
[[nodiscard]] inline double allowed_depth(const Simulation& simulation) {
  double deepest = 0;
  for (const Material& material : simulation.workpiece().materials().all()) {
    const double k = simulation.config().reference_stiffness * material.relative_stiffness;
    deepest = std::max(deepest, crushing_depth(k, strength_of(material)));
  }
  return 1.1 * deepest;
}

/// [m] Depth of the centre of a voxel that is at least half full below the surface of the head, smooth or cutting.
[[nodiscard]] inline double solid_depth(const Simulation& simulation, const Pose& X_WT) {
  const Workpiece& workpiece = simulation.workpiece();
  const GridFrame& frame = workpiece.frame();
  const HeadBox box = simulation.tool().head().bounding_box();
  const Pose X_VT = frame.X_WV.inverse() * X_WT, X_TV = X_VT.inverse();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.max.x() : box.min.x(), (corner & 2) != 0 ? box.max.y() : box.min.y(),
                 (corner & 4) != 0 ? box.max.z() : box.min.z());
    low = low.cwiseMin(X_VT * p);
    high = high.cwiseMax(X_VT * p);
  }
  const IndexBox bounds = workpiece.bounds();
  VoxelIndex first, last;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = std::size_t(axis);
    first[a] = std::max(bounds.min[a], int(std::floor(low[axis] / frame.voxel_size)));
    last[a] = std::min(bounds.max[a], int(std::ceil(high[axis] / frame.voxel_size)));
  }
  double deepest = 0;
  simulation.tool().head().visit_springs<double>([&](const auto& springs) {
    for_each_block_origin({first, last}, [&](const VoxelIndex& origin) {
      const BlockView block = workpiece.block(origin);
      if (block.empty()) return;
      for (int n = 0; n < kBlockVoxels; ++n) {
        if (block.fill_of(n) < 0.5F) continue;
        const VoxelIndex at = voxel_at(origin, n);
        const Vec3 p = X_TV * Vec3(frame.voxel_size * Vec3(at[0], at[1], at[2]));
        deepest = std::max(deepest, double(springs.margin(std::hypot(p.x(), p.y()), p.z())));
      }
    });
    return 0;
  });
  return deepest;
}

}  // namespace hapticut::test
