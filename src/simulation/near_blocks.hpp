// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "kernels/kernels.hpp"

namespace hapticut {

/// A block that the head may touch, and its voxels that may be inside the head.
struct FoundBlock : CuttableBlock {
  kernels::ReachedVoxels reached;  // not listed when there are too many, or nobody needs them
};

/// The blocks near the head and their voxels, found once for all places of the head within a small distance: a tick
/// with a coupling evaluates the contact a few times, and in the next tick the head is still near. What is found for a
/// place does not depend on what was found before. Finding the same place again costs nothing.
class NearBlocks {
 public:
  /// [voxels] Motion of the head for which they are found. A larger one lists more voxels in vain; a head at 2 mm/s
  /// moves so far in 12 ticks for voxels of 0.1 mm.
  static constexpr double kMotion = 0.25;

  NearBlocks() = default;
  /// @param max_blocks  that the head may touch
  /// @param max_voxels  that may be inside it
  NearBlocks(std::size_t max_blocks, std::size_t max_voxels);

  /// The blocks that the head may touch, in the order of `for_each_block_origin`; valid until the next call.
  /// @param bounds  voxels that were ever solid
  /// @param beyond  [voxels] how far outside the head the centre of a voxel may be
  /// @param lists   whether the voxels are needed
  [[nodiscard]] std::span<const FoundBlock> find(Workpiece& workpiece, const kernels::ContactJob& job, const Pose& X_VT,
                                                 const IndexBox& bounds, double beyond, bool lists) noexcept;

  void forget() noexcept { known_ = false; }

 private:
  [[nodiscard]] bool is_near(const HeadBox& box, const Pose& X_VT, double voxel_size) const noexcept;
  void list_voxels(const kernels::ContactJob& job) noexcept;

  std::vector<FoundBlock> near_, found_;
  std::vector<std::uint16_t> voxels_;  // memory of their lists
  bool known_ = false;                 // there are some
  Pose X_VT_near_, X_VT_found_;        // where they were found
  std::uint64_t layout_ = 0;           // layout of the workpiece then
  bool listed_ = false;                // whether their voxels were listed
};

}  // namespace hapticut
