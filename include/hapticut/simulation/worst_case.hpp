// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "hapticut/core/abi.hpp"
#include "hapticut/tool/head.hpp"

namespace hapticut {

/// Upper bound on the work of a step, known at set-up. The work is proportional to the voxels that it evaluates.
struct WorstCase {
  std::size_t blocks = 0;   ///< blocks visited in one sub-step
  std::size_t voxels = 0;   ///< voxels evaluated in one sub-step, level of detail considered
  int sub_steps = 0;        ///< sub-steps of the longest motion that is not rejected
  int level_of_detail = 1;  ///< 1: every voxel in every sub-step; n: one n-th of them, in turn
  int contacts = 1;         ///< evaluations of so many voxels; more than one in a tick of VirtualCoupling
};

/// Upper bound on the voxels that a head in any pose can touch: those whose cube may meet it.
/// @param voxel_size  [m] > 0
[[nodiscard]] std::size_t max_voxels(const ToolHead& head, double voxel_size);

/// Upper bound on the blocks that a head in any pose can touch.
/// @param voxel_size  [m] > 0
[[nodiscard]] std::size_t max_blocks(const ToolHead& head, double voxel_size);

}  // namespace hapticut
