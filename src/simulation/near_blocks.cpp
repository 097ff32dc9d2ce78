// SPDX-License-Identifier: Apache-2.0
#include "simulation/near_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/reserve.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "simulation/reach.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kMostVoxels = 1 << 16;  // that are listed at once: 128 kB

}  // namespace

NearBlocks::NearBlocks(std::size_t max_blocks, std::size_t max_voxels) {
  reserve_touched(near_, max_blocks);
  reserve_touched(found_, max_blocks);
  voxels_.resize(std::min(max_voxels, kMostVoxels) + kernels::ReachedVoxels::kCapacity);
}

std::span<const FoundBlock> NearBlocks::find(Workpiece& workpiece, const kernels::ContactJob& job, const Pose& X_VT,
                                             const IndexBox& bounds, double beyond, bool lists) noexcept {
  const double size = workpiece.voxel_size();
  const HeadBox box = job.head.bounding_box();
  const bool current = known_ && layout_ == workpiece.layout() && (listed_ || !lists);
  if (current && X_VT.rotation == X_VT_found_.rotation && X_VT.translation == X_VT_found_.translation) return found_;
  found_.clear();
  job.head.visit_springs<float>([&](const auto& springs) {
    if (!current || !is_near(box, X_VT, size)) {
      near_.clear();
      for_each_block_origin(reach_of(box, X_VT, size, bounds, beyond + kMotion), [&](const VoxelIndex& origin) {
        if (!may_touch(springs, job.grid, origin, float(size), float(kMotion * size))) return;
        const CuttableBlock block = workpiece.cuttable_block(origin);
        if (!block.view.empty()) near_.push_back({block, {}});
      });
      known_ = true, X_VT_near_ = X_VT, layout_ = workpiece.layout(), listed_ = lists;
      if (lists) list_voxels(job);
    }
    const IndexBox reach = reach_of(box, X_VT, size, bounds, beyond);
    for (const FoundBlock& block : near_) {
      const VoxelIndex& origin = block.view.origin;
      bool reached = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        reached = reached && reach.min[axis] <= reach.max[axis] && origin[axis] <= reach.max[axis] &&
                  origin[axis] + kBlockEdge > reach.min[axis];
      if (reached && may_touch(springs, job.grid, origin, float(size))) found_.push_back(block);
    }
  });
  X_VT_found_ = X_VT;
  return found_;
}

/// Whether no point of the head has moved too far since the blocks were found.
bool NearBlocks::is_near(const HeadBox& box, const Pose& X_VT, double voxel_size) const noexcept {
  const Pose moved = X_VT_near_.inverse() * X_VT;
  const Vec3 center = 0.5 * (box.min + box.max);
  const double chord = (moved.rotation - Mat3::Identity()).norm() / std::sqrt(2.0);  // [1] 2 sin(angle/2)
  return (moved * center - center).norm() + 0.5 * chord * (box.max - box.min).norm() <= kMotion * voxel_size;
}

void NearBlocks::list_voxels(const kernels::ContactJob& job) noexcept {
  std::size_t used = 0;
  for (FoundBlock& block : near_) {
    if (used + kernels::ReachedVoxels::kCapacity > voxels_.size()) return;  // the kernels find those of the others
    block.reached =
        kernels::find_voxels(job, block.view, float(kMotion * double(job.motion.voxel_size)), voxels_.data() + used);
    used += std::size_t(block.reached.count) + kernels::ReachedVoxels::kEnd;
  }
}

}  // namespace hapticut
