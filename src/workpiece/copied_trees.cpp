// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "workpiece/state.hpp"

namespace hapticut {
namespace {

/// Whether each solid voxel of a block is full.
bool is_full(const Leaf<FillTree>& fill, const Leaf<MaterialTree>& material) {
  for (auto voxel = material.cbeginValueOn(); voxel; ++voxel)
    if (fill.getValue(voxel.pos()) != 1) return false;
  return true;
}

}  // namespace

std::unique_ptr<VoxelTrees> copy_of(const VoxelTrees& trees) {
  // NOLINTNEXTLINE(modernize-make-unique): trees cannot be assigned, and clang 14 makes no aggregate of arguments
  auto copy = std::unique_ptr<VoxelTrees>(new VoxelTrees{trees.material, FillTree(1.0F), trees.centroid});
  for (auto leaf = copy->material.beginLeaf(); leaf; ++leaf)
    for (auto voxel = leaf->beginValueOff(); voxel; ++voxel) voxel.setValue(kEmpty);
  for (auto fill = trees.fill.cbeginLeaf(); fill; ++fill) {
    const auto* material = trees.material.probeConstLeaf(fill->origin());
    if (material == nullptr || !is_full(*fill, *material)) copy->fill.addLeaf(new Leaf<FillTree>(*fill));
  }
  return copy;
}

}  // namespace hapticut
