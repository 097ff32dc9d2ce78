// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/workpiece/block_grid.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "support/named_material.hpp"

/// @file
/// Queries and changes of a workpiece in tests.
namespace hapticut::test {

/// [m^3] Volume of all materials.
inline double solid_volume(const Workpiece& workpiece) {
  double sum = 0;
  for (const MaterialAmount& amount : workpiece.amounts()) sum += amount.volume;
  return sum;
}

/// [voxels] from the centre of a voxel to that of its filled part
inline Vec3 centroid_of(const Workpiece& workpiece, const VoxelIndex& at) {
  const auto steps = workpiece.centroid_at(at).steps;
  return Vec3(steps[0], steps[1], steps[2]) / CentroidOffset::kSteps;
}

/// Empties one voxel with the functions of the step.  @return false: the pool is exhausted
inline bool cut_voxel(Workpiece& workpiece, const VoxelIndex& at) {
  const VoxelIndex origin = {block_start(at[0]), block_start(at[1]), block_start(at[2])};
  if (workpiece.writable_fill(origin) == nullptr) return false;
  BlockMask emptied;
  emptied.add(block_offset(at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]));
  workpiece.empty_voxels(origin, emptied);
  return true;
}

}  // namespace hapticut::test
