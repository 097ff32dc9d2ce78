// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/workpiece.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/refusal.hpp"
#include "support/workpieces.hpp"

namespace hapticut::workpiece_test {
namespace {

using test::cut_voxel;
using test::named;
using units::mm;

TEST(Workpiece, ASolidBlockOf256MillionVoxelsFitsIn16MegabytesUntilItIsCut) {
  Workpiece workpiece = build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, 0.05 * mm, named("clay"));
  EXPECT_EQ(workpiece.solid_voxels(), std::int64_t(800) * 800 * 400);
  workpiece.reserve_blocks(2048);
  RecordProperty("tree_bytes", int(workpiece.memory_bytes()));
  RecordProperty("pool_bytes", int(workpiece.pool_bytes()));
  EXPECT_LT(workpiece.memory_bytes() + workpiece.pool_bytes(), 16'000'000U);
}

TEST(Workpiece, CuttingOneVoxelOfATileChangesThatVoxelOnly) {
  Workpiece workpiece = build_block({Vec3::Zero(), Vec3(40, 40, 40) * mm}, 0.1 * mm, named("clay"));
  workpiece.reserve_blocks(4);
  const std::int64_t before = workpiece.solid_voxels();
  ASSERT_TRUE(cut_voxel(workpiece, {200, 201, 202}));
  EXPECT_EQ(workpiece.solid_voxels(), before - 1);
  EXPECT_EQ(workpiece.material_at({200, 201, 202}), kEmpty);
  EXPECT_EQ(workpiece.material_at({200, 201, 203}), 1);
  EXPECT_EQ(workpiece.fill_at({200, 201, 202}), 0.0);
  EXPECT_EQ(workpiece.fill_at({200, 201, 203}), 1.0);
  EXPECT_EQ(workpiece.reserved_blocks(), 3U);
}

TEST(Workpiece, ABlockCutEmptyGoesBackToThePool) {
  Workpiece workpiece = build_block({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.1 * mm, named("clay"));
  workpiece.reserve_blocks(1);
  for (int n = 0; n < kBlockVoxels; ++n) ASSERT_TRUE(cut_voxel(workpiece, voxel_at({8, 8, 8}, n)));
  EXPECT_TRUE(workpiece.block({8, 8, 8}).empty());
  EXPECT_EQ(workpiece.reserved_blocks(), 1U);
  EXPECT_TRUE(cut_voxel(workpiece, {16, 16, 16}));
}

TEST(Workpiece, TakesOtherConstantsButNotAnotherNumberOfMaterials) {
  Workpiece workpiece = build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, 0.1 * mm, named("clay"));
  const std::uint64_t before = workpiece.hash();
  Material heavy = named("clay");
  heavy.density *= 2;
  const double mass = workpiece.amounts()[0].mass;
  workpiece.set_materials(MaterialTable({heavy}));
  EXPECT_DOUBLE_EQ(workpiece.amounts()[0].mass, 2 * mass);
  EXPECT_EQ(workpiece.hash(), before);
  EXPECT_THROW(workpiece.set_materials(MaterialTable()), Error);
}

TEST(Workpiece, AnExhaustedPoolLeavesTheBlockAsItIs) {
  Workpiece workpiece = build_block({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.1 * mm, named("clay"));
  workpiece.reserve_blocks(1);
  ASSERT_TRUE(cut_voxel(workpiece, {8, 8, 8}));
  const std::uint64_t before = workpiece.hash();
  EXPECT_FALSE(cut_voxel(workpiece, {16, 16, 16}));
  EXPECT_EQ(workpiece.hash(), before);
}

TEST(Workpiece, RestoreBringsBackTheSnapshotBitByBit) {
  Workpiece workpiece = build_sphere(Vec3::Zero(), 2 * mm, 0.1 * mm, named("clay"));
  workpiece.reserve_blocks(8);
  const WorkpieceSnapshot snapshot = workpiece.snapshot();
  const std::uint64_t before = workpiece.hash();
  ASSERT_TRUE(cut_voxel(workpiece, {20, 20, 20}));
  EXPECT_NE(workpiece.hash(), before);
  workpiece.restore(snapshot);
  EXPECT_EQ(workpiece.hash(), before);
  EXPECT_TRUE(cut_voxel(workpiece, {20, 20, 20}));
}

TEST(Workpiece, RestoreRefusesTheSnapshotOfAnotherWorkpiece) {
  const auto block = [](double x, double size) {
    return build_block({Vec3(x, 0, 0), Vec3(x, 0, 0) + Vec3(4, 4, 4) * mm}, size, named("clay"));
  };
  Workpiece workpiece = block(0, 0.1 * mm);
  const std::uint64_t before = workpiece.hash();
  const std::vector<Layer> layers = {{named("clay"), 2 * mm}, {named("stone"), 2 * mm}};
  const std::pair<WorkpieceSnapshot, const char*> others[] = {
      {block(0, 0.2 * mm).snapshot(),
       "it has 1 material in voxels of 0.2 mm, and the present one has 1 material in voxels of 0.1"},
      {block(1 * mm, 0.1 * mm).snapshot(), "or lies elsewhere"},
      {build_layered_slab({Vec3::Zero(), Vec3(4, 4, 4) * mm}, 0.1 * mm, layers).snapshot(), "it has 2 materials"}};
  for (const auto& other : others) test::expect_refused([&] { workpiece.restore(other.first); }, other.second);
  EXPECT_EQ(workpiece.hash(), before);
  Workpiece clone = workpiece.clone();
  ASSERT_NO_THROW(clone.restore(workpiece.snapshot()));
}

TEST(Workpiece, ACloneIsEqualAndIndependent) {
  Workpiece original = build_sphere(Vec3::Zero(), 1 * mm, 0.1 * mm, named("clay"));
  Workpiece copy = original.clone();
  EXPECT_EQ(copy.hash(), original.hash());
  copy.reserve_blocks(1);
  ASSERT_TRUE(cut_voxel(copy, {10, 10, 10}));
  EXPECT_NE(copy.hash(), original.hash());
}

TEST(Workpiece, TheHashDoesNotDependOnHowAUniformBlockIsStored) {
  const auto build = [](bool as_tiles) {
    return Workpiece::from_blocks({{0, 0, 0}, {15, 15, 15}}, GridFrame{}, MaterialTable({named("clay")}),
                                  [&](const VoxelIndex&, BlockContent& content) {
                                    if (as_tiles) return BlockKind::solid(1);
                                    content.material.fill(1);
                                    content.fill.fill(1);
                                    content.centroid.fill({});
                                    return BlockKind::mixed();
                                  });
  };
  EXPECT_EQ(build(true).hash(), build(false).hash());
}

TEST(Workpiece, RefusesAMaterialIdThatIsNotInTheTable) {
  const auto fill_block = [](const VoxelIndex&, BlockContent&) { return BlockKind::solid(2); };
  EXPECT_THROW(
      (void)Workpiece::from_blocks({{0, 0, 0}, {7, 7, 7}}, GridFrame{}, MaterialTable({named("clay")}), fill_block),
      Error);
}

TEST(Workpiece, RefusesATrillionVoxels) {
  EXPECT_THROW((void)build_block({Vec3::Zero(), Vec3(1, 1, 1)}, 0.1 * mm, named("clay")), Error);
}

}  // namespace
}  // namespace hapticut::workpiece_test
