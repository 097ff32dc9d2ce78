// SPDX-License-Identifier: Apache-2.0
#include "workpiece/reserved_nodes.hpp"

#include <algorithm>

#include "workpiece/state.hpp"

namespace hapticut {

ReservedNodes reserved_nodes(const Workpiece& workpiece) {
  const BlockPool& pool = WorkpieceAccess::pool(workpiece);
  return {pool.material_leaves.size(), pool.fill_leaves.size(), pool.fill_branches.size(), pool.target};
}

void set_reserved_nodes(Workpiece& workpiece, const ReservedNodes& nodes) {
  workpiece.reserve_blocks(std::max({nodes.material_leaves, nodes.fill_leaves, nodes.target}));
  BlockPool& pool = WorkpieceAccess::pool(workpiece);
  const auto shrink = [](auto& free, std::size_t count) { free.resize(std::min(free.size(), count)); };
  shrink(pool.material_leaves, nodes.material_leaves);
  shrink(pool.fill_leaves, nodes.fill_leaves);
  shrink(pool.fill_branches, nodes.fill_branches);
  pool.target = nodes.target;
}

std::vector<BlockIds> ids_of_cut_blocks(const Workpiece& workpiece) {
  const VoxelTrees& trees = WorkpieceAccess::trees(workpiece);
  std::vector<BlockIds> blocks;
  for (auto leaf = trees.fill.cbeginLeaf(); leaf; ++leaf) {
    const auto* material = trees.material.probeConstLeaf(leaf->origin());
    if (material == nullptr) continue;
    BlockIds& block = blocks.emplace_back();
    block.origin = to_index(leaf->origin());
    std::copy_n(material->buffer().data(), kBlockVoxels, block.ids.begin());
  }
  return blocks;
}

void set_ids_of_cut_blocks(Workpiece& workpiece, const std::vector<BlockIds>& blocks) {
  workpiece.reserve_blocks(blocks.size() + 1);
  for (const BlockIds& block : blocks) {
    (void)workpiece.writable_fill(block.origin);
    auto* leaf = WorkpieceAccess::trees(workpiece).material.probeLeaf(to_coord(block.origin));
    if (leaf == nullptr) continue;
    for (openvdb::Index n = 0; n < kBlockVoxels; ++n)
      if (!leaf->isValueOn(n)) leaf->buffer().setValue(n, block.ids[n]);
  }
}

}  // namespace hapticut
