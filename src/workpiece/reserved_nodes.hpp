// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// What a `.vdb` file does not have of a workpiece that is being cut, but on which the bits and the reports of the next
/// steps depend.
namespace hapticut {

/// Number of free nodes of each kind, and the last count that was asked for.
struct ReservedNodes {
  std::size_t material_leaves = 0, fill_leaves = 0, fill_branches = 0, target = 0;
};

[[nodiscard]] ReservedNodes reserved_nodes(const Workpiece& workpiece);
void set_reserved_nodes(Workpiece& workpiece, const ReservedNodes& nodes);

/// The ids of a block with fills. Voxels that were cut away keep their id, and the kernels compute strips of one id in
/// another order.
struct BlockIds {
  VoxelIndex origin;
  std::array<MaterialId, kBlockVoxels> ids;
};

/// The blocks that have fills, with the ids of all their voxels.
[[nodiscard]] std::vector<BlockIds> ids_of_cut_blocks(const Workpiece& workpiece);

/// Gives these blocks fills if they have none, and the ids to their empty voxels.
void set_ids_of_cut_blocks(Workpiece& workpiece, const std::vector<BlockIds>& blocks);

}  // namespace hapticut
