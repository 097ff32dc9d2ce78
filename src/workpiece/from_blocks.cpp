// SPDX-License-Identifier: Apache-2.0
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "core/interruption.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

using openvdb::Coord;

constexpr std::int64_t kMaxDomainVoxels = std::int64_t(1) << 34;  // 2580^3; mixed material of that size needs 20 GB
constexpr int kMaxIndex = 1 << 30;
constexpr int kBranchBlocks = kBranchEdge / kBlockEdge;  // 16 along an edge
constexpr int kBlocksPerBranch = kBranchBlocks * kBranchBlocks * kBranchBlocks;

void validate(const IndexBox& domain, const GridFrame& frame, const MaterialTable& materials) {
  require_positive(frame.voxel_size, "voxel size [m]");
  if (!is_finite(frame.X_WV) || !is_rotation(frame.X_WV.rotation, 1e-6))
    throw Error("GridFrame::X_WV"_name +
                " is not a pose; its rotation must be orthonormal and right-handed and all numbers finite.");
  if (materials.size() == 0) throw Error("a workpiece needs at least one material; add one to its MaterialTable.");
  if (domain.empty()) return;
  double voxels = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.min[axis] < -kMaxIndex || domain.max[axis] > kMaxIndex)
      throw Error("the workpiece reaches beyond voxel index +-2^30; move it closer to the grid's origin.");
    voxels *= double(domain.max[axis]) - domain.min[axis] + 1;
  }
  if (voxels > double(kMaxDomainVoxels))
    throw Error("the workpiece would have " + format_number(voxels) + " voxels; at most " +
                format_number(double(kMaxDomainVoxels)) +
                " are allowed. Choose a larger voxel size or crop the input.");
}

/// The result of the filler for one block, as tree nodes.
struct BuiltBlock {
  BlockKind kind;
  std::unique_ptr<Leaf<MaterialTree>> material;
  std::unique_ptr<Leaf<FillTree>> fill;
  std::unique_ptr<Leaf<CentroidTree>> centroid;
};

void clip_to(const IndexBox& domain, const VoxelIndex& origin, BlockContent& content) {
  const IndexBox kept = overlap(voxels_of_block(origin), domain);
  if (kept.voxels() == kBlockVoxels) return;
  for (int n = 0; n < kBlockVoxels; ++n) {
    const VoxelIndex at = voxel_at(origin, n);
    for (int axis = 0; axis < 3; ++axis)
      if (at[axis] < kept.min[axis] || at[axis] > kept.max[axis]) content.material[n] = kEmpty;
  }
}

void check_voxel(MaterialId id, float fill, const MaterialTable& materials) {
  if (!materials.contains(id))
    throw Error("a voxel has material id " + std::to_string(int(id)) + ", but the workpiece has only materials 1 to " +
                std::to_string(materials.size()) + ". Add the material to the table or map the id to an existing one.");
  if (!(fill >= 0 && fill <= 1))
    throw Error("a voxel has fill " + format_number(double(fill), fill > 1 ? 1 : 0) +
                "; a filled fraction must be within 0 ... 1.");
}

BuiltBlock make_block(const VoxelIndex& origin, const BlockContent& content, const MaterialTable& materials) {
  bool any_solid = false;
  bool any_partial = false;
  bool any_centroid = false;
  bool uniform = true;
  const MaterialId first = content.material[0];
  for (int n = 0; n < kBlockVoxels; ++n) {
    const MaterialId id = content.material[n];
    uniform &= id == first;
    if (id == kEmpty) continue;
    check_voxel(id, content.fill[n], materials);
    if (content.fill[n] <= 0) {
      uniform = false;
      continue;
    }
    any_solid = true;
    any_partial |= content.fill[n] < 1;
    any_centroid |= !(content.centroid[n] == CentroidOffset{});
  }
  if (!any_solid) return {BlockKind::empty(), nullptr, nullptr, nullptr};
  if (uniform && !any_partial && !any_centroid) return {BlockKind::solid(first), nullptr, nullptr, nullptr};

  BuiltBlock block{BlockKind::mixed(), nullptr, nullptr, nullptr};
  const Coord at = to_coord(origin);
  block.material = std::make_unique<Leaf<MaterialTree>>(at, kEmpty, false);
  if (any_partial) block.fill = std::make_unique<Leaf<FillTree>>(at, 1.0F, true);
  if (any_centroid) block.centroid = std::make_unique<Leaf<CentroidTree>>(at, 0, true);
  for (openvdb::Index n = 0; n < kBlockVoxels; ++n) {
    const bool solid = content.material[n] != kEmpty && content.fill[n] > 0;
    if (solid) block.material->setValueOn(n, content.material[n]);
    if (block.fill) block.fill->setValueOnly(n, solid ? content.fill[n] : 0.0F);
    if (block.centroid && solid) block.centroid->setValueOnly(n, std::int32_t(content.centroid[n].packed()));
  }
  return block;
}

BuiltBlock build_block(const VoxelIndex& origin, const IndexBox& domain, const MaterialTable& materials,
                       const Workpiece::BlockFiller& fill_block, BlockContent& content) {
  const BlockKind kind = fill_block(origin, content);
  if (kind.uniform) {
    if (kind.material == kEmpty) return {};
    content.material.fill(kind.material);
    content.fill.fill(1.0F);
    content.centroid.fill({});
  }
  clip_to(domain, origin, content);
  return make_block(origin, content, materials);
}

/// Puts the blocks of one branch into the trees, in their order.
void insert(std::vector<BuiltBlock>& blocks, const BlockGrid& branch, VoxelTrees& trees) {
  const MaterialId first = blocks[0].kind.material;
  if (std::ranges::all_of(blocks, [&](const BuiltBlock& b) { return b.kind.uniform && b.kind.material == first; })) {
    if (first != kEmpty) trees.material.addTile(2, to_coord(branch.first()), first, true);
    return;
  }
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    BuiltBlock& block = blocks[n];
    if (block.kind.uniform) {
      if (block.kind.material != kEmpty)
        trees.material.addTile(1, to_coord(branch.origin_of(n)), block.kind.material, true);
      continue;
    }
    trees.material.addLeaf(block.material.release());
    if (block.fill) trees.fill.addLeaf(block.fill.release());
    if (block.centroid) trees.centroid.addLeaf(block.centroid.release());
  }
}

}  // namespace

Workpiece Workpiece::from_blocks(const IndexBox& domain, const GridFrame& frame, MaterialTable materials,
                                 const BlockFiller& fill_block) {
  validate(domain, frame, materials);
  auto trees = std::make_unique<VoxelTrees>();
  std::vector<BuiltBlock> blocks(kBlocksPerBranch);
  // Works branch by branch (128^3 voxels). The blocks of a branch are filled in parallel and inserted in order, so the
  // result does not depend on the number of threads.
  const auto add_branch = [&](int x, int y, int z) {
    constexpr int kLast = kBranchEdge - 1;
    const BlockGrid branch({{x, y, z}, {x + kLast, y + kLast, z + kLast}});
    const tbb::blocked_range<std::size_t> all(0, blocks.size(), 8);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
      BlockContent content;
      for (std::size_t n = range.begin(); n != range.end(); ++n) {
        look_for_interruption();
        const VoxelIndex origin = branch.origin_of(n);
        const bool is_outside = overlap(voxels_of_block(origin), domain).empty();
        blocks[n] = is_outside ? BuiltBlock{} : build_block(origin, domain, materials, fill_block, content);
      }
    });
    insert(blocks, branch, *trees);
  };
  if (!domain.empty())
    for (int x = branch_start(domain.min[0]); x <= domain.max[0]; x += kBranchEdge)
      for (int y = branch_start(domain.min[1]); y <= domain.max[1]; y += kBranchEdge)
        for (int z = branch_start(domain.min[2]); z <= domain.max[2]; z += kBranchEdge) add_branch(x, y, z);
  return WorkpieceAccess::make(frame, std::move(materials), std::move(trees));
}

}  // namespace hapticut
