// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/block.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut::block_test {
namespace {

TEST(Block, PlacesAndOffsetsAreInverse) {
  for (int n = 0; n < kBlockVoxels; ++n) {
    const auto [x, y, z] = place_in_block(n);
    EXPECT_EQ(block_offset(x, y, z), n);
    EXPECT_EQ(voxel_at({-8, 0, 16}, n), (VoxelIndex{x - 8, y, z + 16}));
  }
}

TEST(Block, EmptyVoxelsAreEmptyWithAnyContentOfTheirArrays) {
  BlockContent content, copy;
  content.material.fill(3);
  content.fill.fill(0.5F);
  BlockMask solid;
  for (int n = 0; n < kBlockVoxels; n += 7) solid.add(n);
  BlockView view;
  view.material = content.material.data();
  view.solid = solid.words.data();
  view.fill = content.fill.data();
  view.copy_to(copy.material, copy.fill);
  EXPECT_EQ(view.solid_voxels(), solid);
  EXPECT_EQ(solid.count(), 74);
  for (int n = 0; n < kBlockVoxels; ++n) {
    EXPECT_EQ(view.material_of(n), n % 7 == 0 ? 3 : kEmpty);
    EXPECT_EQ(copy.material[std::size_t(n)], view.material_of(n));
    EXPECT_EQ(copy.fill[std::size_t(n)], n % 7 == 0 ? 0.5F : 0.0F);
  }
}

TEST(BlockGrid, NumbersTheBlocksOfABoxInTheirOrderAndNoOthers) {
  const IndexBox box = {{-9, 3, 8}, {7, 17, 15}};
  const BlockGrid grid(box);
  std::size_t number = 0;
  for_each_block_origin(box, [&](const VoxelIndex& origin) {
    EXPECT_EQ(grid.number_of(origin), number);
    EXPECT_EQ(grid.origin_of(number++), origin);
  });
  EXPECT_EQ(number, 3U * 3U * 1U);
  EXPECT_EQ(grid.count(), 9);
  constexpr int kFar = std::numeric_limits<int>::max();
  for (const VoxelIndex& outside : {VoxelIndex{-24, 0, 8}, {8, 0, 8}, {0, 24, 8}, {0, 0, 0}, {kFar, kFar, kFar}})
    EXPECT_FALSE(grid.number_of(outside).has_value());
  EXPECT_EQ(BlockGrid(IndexBox{}).count(), 0);
}

}  // namespace
}  // namespace hapticut::block_test
