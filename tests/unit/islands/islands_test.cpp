// SPDX-License-Identifier: Apache-2.0
// Pieces that are cut loose: a search around the removed voxels finds the same pieces as a search over all voxels.
#include "hapticut/islands/islands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <set>

#include "hapticut/core/units.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"

namespace hapticut::islands_test {
namespace {

using units::mm;

constexpr double kVoxel = 0.1 * mm;

/// [s] Processor time of this program.
double cpu_time() { return double(std::clock()) / double(CLOCKS_PER_SEC); }

/// A block of voxels from 0 on.
Workpiece block_of(int x, int y, int z) {
  Workpiece block = build_block({Vec3::Zero(), kVoxel * Vec3(x, y, z)}, kVoxel, test::named("bone"));
  block.reserve_blocks(20000);
  return block;
}

bool holds(const IndexBox& box, const VoxelIndex& at) {
  bool inside = true;
  for (std::size_t a = 0; a < 3; ++a) inside = inside && at[a] >= box.min[a] && at[a] <= box.max[a];
  return inside;
}

/// Removes the voxels of a box, ends included, that a predicate selects.  @return the changed blocks
template <class Choose>
std::vector<VoxelIndex> cut(Workpiece& workpiece, const IndexBox& box, const Choose& choose) {
  std::vector<VoxelIndex> changed;
  for_each_block_origin(box, [&](const VoxelIndex& origin) {
    BlockMask emptied;
    for (int n = 0; n < kBlockVoxels; ++n) {
      const VoxelIndex at = voxel_at(origin, n);
      if (holds(box, at) && workpiece.material_at(at) != kEmpty && choose(at)) emptied.add(n);
    }
    if (emptied.empty()) return;
    EXPECT_NE(workpiece.writable_fill(origin), nullptr);
    workpiece.empty_voxels(origin, emptied);
    changed.push_back(origin);
  });
  return changed;
}
std::vector<VoxelIndex> cut(Workpiece& workpiece, const IndexBox& box) {
  return cut(workpiece, box, [](const VoxelIndex&) { return true; });
}

/// Removes a shell around a box, `width` voxels thick.  @return the changed blocks
std::vector<VoxelIndex> undercut(Workpiece& workpiece, const IndexBox& piece, int width = 2) {
  IndexBox around = piece;
  for (std::size_t a = 0; a < 3; ++a) around.min[a] -= width, around.max[a] += width;
  return cut(workpiece, around, [&](const VoxelIndex& at) { return !holds(piece, at); });
}

using Sizes = std::vector<std::int64_t>;
Sizes sizes_of(const std::vector<Island>& islands) {
  Sizes sizes;
  for (const Island& island : islands) sizes.push_back(island.voxels);
  std::ranges::sort(sizes);
  return sizes;
}

std::set<VoxelIndex> voxels_of(const Island& island) {
  std::set<VoxelIndex> voxels;
  for (const BlockVoxels& block : island.blocks)
    block.voxels.for_each([&](int voxel) { voxels.insert(voxel_at(block.origin, voxel)); });
  return voxels;
}

TEST(IslandFinder, FindsAFreeCubeWithAllItsVoxels) {
  Workpiece block = block_of(40, 40, 40);
  IslandFinder finder(block);
  const IndexBox cube = {{11, 12, 13}, {20, 21, 22}};
  finder.update(block, undercut(block, cube));
  const std::vector<Island> islands = finder.find();
  ASSERT_EQ(sizes_of(islands), Sizes{1000});
  const std::set<VoxelIndex> voxels = voxels_of(islands[0]);
  EXPECT_EQ(voxels.size(), 1000U);
  EXPECT_EQ(*voxels.begin(), cube.min);
  EXPECT_EQ(*voxels.rbegin(), cube.max);
  EXPECT_EQ(find_islands(block), islands);
  EXPECT_TRUE(finder.find().empty()) << "each is found once";
}

TEST(IslandFinder, LeavesAPieceThatABridgeOfOneVoxelHolds) {
  Workpiece block = block_of(40, 40, 40);
  IslandFinder finder(block);
  const auto changed = cut(block, {{9, 10, 11}, {22, 23, 24}}, [&](const VoxelIndex& at) {
    return !holds({{11, 12, 13}, {20, 21, 22}}, at) && !(at[0] > 20 && at[1] == 15 && at[2] == 16);
  });
  finder.update(block, changed);
  EXPECT_TRUE(finder.find().empty());
  EXPECT_TRUE(find_islands(block).empty());
  finder.update(block, cut(block, {{21, 15, 16}, {21, 15, 16}}));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{1000});
}

TEST(IslandFinder, FindsSeveralPiecesAtOnceInAnyOrderOfTheBlocks) {
  Workpiece block = block_of(64, 48, 32);
  const IslandFinder fresh(block);
  std::vector<VoxelIndex> changed = undercut(block, {{5, 5, 5}, {9, 9, 9}});
  for (const IndexBox& piece : {IndexBox{{30, 10, 8}, {45, 12, 20}}, IndexBox{{20, 35, 3}, {22, 40, 27}}})
    for (const VoxelIndex& origin : undercut(block, piece)) changed.push_back(origin);
  std::vector<Island> first;
  std::mt19937 random(7);
  for (int run = 0; run < 5; ++run) {
    IslandFinder finder = fresh;
    for (const VoxelIndex& origin : changed) finder.update(block, {&origin, 1});
    const std::vector<Island> islands = finder.find();
    ASSERT_EQ(islands.size(), 3U);
    if (run == 0) first = islands;
    EXPECT_EQ(islands, first);
    std::ranges::shuffle(changed, random);
  }
  EXPECT_EQ(first, find_islands(block));
  EXPECT_EQ(sizes_of(first), (Sizes{125, 3 * 6 * 25, 16 * 3 * 13}));
}

TEST(IslandFinder, DoesNotTakeAnEdgeOrACornerForAJoint) {
  Workpiece block = block_of(16, 16, 16);
  IslandFinder finder(block);
  // The rest of the upper half touches the lower half only at edges.
  const auto changed = cut(block, {{0, 0, 6}, {15, 15, 15}}, [](const VoxelIndex& at) {
    return !holds({{4, 4, 7}, {9, 9, 9}}, at) && !(at[0] == 3 && at[1] >= 4 && at[2] == 6);
  });
  finder.update(block, changed);
  EXPECT_EQ(sizes_of(finder.find()), Sizes{6 * 6 * 3});
}

TEST(IslandFinder, FindsNothingWhereNothingWasCutAndLeavesBodiesThatWereApart) {
  Workpiece block = block_of(40, 40, 40);
  (void)cut(block, {{20, 0, 0}, {21, 39, 39}});  // two bodies from the beginning
  IslandFinder finder(block);
  EXPECT_TRUE(finder.find().empty());
  // One cut removes voxels of both bodies.
  finder.update(block, cut(block, {{16, 5, 5}, {25, 10, 10}}));
  EXPECT_TRUE(finder.find().empty());
  EXPECT_EQ(find_islands(block).size(), 1U) << "as a whole, one of the two bodies is an island";
  // A piece of the smaller body comes loose.
  finder.update(block, undercut(block, {{30, 30, 30}, {33, 33, 33}}));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{64});
}

TEST(IslandFinder, KeepsFixedPiecesOfAnySize) {
  Workpiece block = block_of(60, 16, 16);
  IslandOptions options;
  options.fixed = Box{Vec3::Zero(), kVoxel * Vec3(2, 16, 16)};
  IslandFinder finder(block, options), other(block);
  const auto changed = cut(block, {{20, 0, 0}, {20, 15, 15}});
  finder.update(block, changed);
  other.update(block, changed);
  const std::vector<Island> far = finder.find();
  EXPECT_EQ(sizes_of(far), Sizes{39 * 16 * 16});
  EXPECT_EQ(sizes_of(other.find()), Sizes{20 * 16 * 16});
  EXPECT_EQ(find_islands(block, options), far);
}

TEST(IslandFinder, FindsAPieceWhoseFixedVoxelsWereCutAway) {
  Workpiece block = block_of(24, 24, 16);
  IslandOptions options;
  options.fixed = Box{Vec3::Zero(), kVoxel * Vec3(24, 24, 1)};
  IslandFinder finder(block, options);
  finder.update(block, cut(block, {{12, 0, 0}, {12, 23, 15}}));  // into two halves; the lowest layer fixes both
  EXPECT_TRUE(finder.find().empty());
  finder.update(block, cut(block, {{0, 0, 0}, {11, 23, 0}}));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{12 * 24 * 15});
  finder.update(block, cut(block, {{0, 0, 1}, {11, 23, 15}}));  // the piece leaves
  EXPECT_TRUE(finder.find().empty());
  finder.update(block, cut(block, {{13, 0, 0}, {23, 23, 0}}));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{11 * 24 * 15}) << "nothing is fixed any more";
}

TEST(IslandFinder, FindsAPieceAgainThatAnUndoBringsBackLoose) {
  Workpiece block = block_of(40, 40, 40);
  block.reserve_undo(1000);
  IslandFinder finder(block);
  const IndexBox cube = {{10, 10, 10}, {19, 19, 19}};
  finder.update(block, undercut(block, cube));
  ASSERT_EQ(sizes_of(finder.find()), Sizes{1000});
  block.set_mark();
  finder.update(block, cut(block, cube));
  EXPECT_TRUE(finder.find().empty());
  std::vector<VoxelIndex> back;
  while (const auto origin = block.undo_block()) back.push_back(*origin);
  finder.update(block, back);
  EXPECT_EQ(sizes_of(finder.find()), Sizes{1000});
}

TEST(IslandFinder, LeavesABodyThatWasApartAndThatAnUndoBringsBack) {
  Workpiece block = block_of(40, 40, 40);
  block.reserve_undo(2000);
  (void)cut(block, {{20, 0, 0}, {29, 39, 39}});  // two bodies from the beginning
  IslandFinder finder(block);
  block.set_mark();
  finder.update(block, undercut(block, {{33, 10, 10}, {36, 13, 13}}));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{64});
  finder.update(block, cut(block, {{30, 0, 0}, {39, 39, 39}}));
  EXPECT_TRUE(finder.find().empty());
  std::vector<VoxelIndex> back;
  while (const auto origin = block.undo_block()) back.push_back(*origin);
  finder.update(block, back);
  EXPECT_TRUE(finder.find().empty());
}

TEST(IslandFinder, FindsAPieceOfMaterialThatCameBackAndWasCutOutBeforeASearch) {
  Workpiece block = block_of(40, 40, 40);
  block.reserve_undo(1000);
  IslandFinder finder(block);
  block.set_mark();
  finder.update(block, cut(block, {{5, 5, 5}, {30, 30, 30}}));
  EXPECT_TRUE(finder.find().empty());
  while (block.undo_block()) {
  }
  const IndexBox cube = {{10, 10, 10}, {14, 14, 14}};
  (void)undercut(block, cube);
  std::vector<VoxelIndex> all;
  for_each_block_origin(block.bounds(), [&](const VoxelIndex& origin) { all.push_back(origin); });
  finder.update(block, all);
  EXPECT_EQ(sizes_of(finder.find()), Sizes{125});
}

TEST(IslandFinder, BeginsWithTheBlocksThatAreListedFirst) {
  Workpiece block = block_of(40, 40, 40);
  (void)undercut(block, {{30, 30, 30}, {33, 33, 33}});  // a body that is apart from the beginning
  IslandFinder finder(block.bounds(), block.frame(), IslandOptions{});
  std::vector<VoxelIndex> all;
  for_each_block_origin(block.bounds(), [&](const VoxelIndex& origin) { all.push_back(origin); });
  finder.update(block, std::span(all).first(all.size() - 1));
  finder.update(block, undercut(block, {{4, 4, 4}, {7, 7, 7}}));
  EXPECT_TRUE(finder.find().empty()) << "a block is not known yet";
  finder.update(block, std::span(all).last(1));
  EXPECT_EQ(sizes_of(finder.find()), Sizes{64}) << "the piece is found now, and the separate body stays";
}

TEST(IslandOptions, RefuseAFixedBoxThatIsNoBoxOrHoldsNothing) {
  const Workpiece block = block_of(16, 16, 16);
  const auto refuses = [&](const Vec3& min, const Vec3& max, const char* why) {
    IslandOptions options;
    options.fixed = Box{min, max};
    test::expect_refused([&] { (void)find_islands(block, options); }, {"IslandOptions::fixed", why});
    test::expect_refused([&] { IslandFinder finder(block, options); }, {"IslandOptions::fixed", why});
  };
  refuses(Vec3::Constant(1 * mm), Vec3(2, 0, 2) * mm, "min that is larger than its max");
  refuses(Vec3::Constant(std::nan("")), Vec3::Constant(1 * mm), "not finite");
  refuses(Vec3::Constant(50 * mm), Vec3::Constant(60 * mm), "no voxel");
}

TEST(IslandFinder, TakesThinVoxelsForAirAndTheirSkinWithTheIsland) {
  Workpiece block = block_of(24, 24, 24);
  IslandFinder finder(block);
  const auto changed = cut(block, {{7, 7, 7}, {15, 15, 15}}, [&](const VoxelIndex& at) {
    return !holds({{9, 9, 9}, {13, 13, 13}}, at) && !(at[0] > 13 && at[1] == 10 && at[2] == 10);
  });
  const VoxelIndex origin = {8, 8, 8};
  float* fill = block.writable_fill(origin);
  ASSERT_NE(fill, nullptr);
  const int skin = block_offset(14 & 7, 2, 2), beyond = block_offset(15 & 7, 2, 2);  // the bridge that is left
  fill[skin] = fill[beyond] = 0.03F;
  finder.update(block, changed);
  const std::vector<Island> islands = finder.find();
  ASSERT_EQ(sizes_of(islands), Sizes{125});
  std::size_t here = 0;
  while (islands[0].blocks.at(here).origin != origin) ++here;
  const BlockVoxels removed = with_skin(islands[0], here, block);
  EXPECT_TRUE(removed.voxels.has(skin));
  EXPECT_FALSE(removed.voxels.has(beyond));
}

TEST(IslandFinder, JoinsAPieceAgainAfterAnUndo) {
  Workpiece block = block_of(32, 32, 32);
  block.reserve_undo(1000);
  IslandFinder finder(block);
  const IndexBox cube = {{10, 10, 10}, {14, 14, 14}};
  block.set_mark();
  const auto changed = undercut(block, cube);
  finder.update(block, changed);
  std::vector<VoxelIndex> back;
  while (const auto origin = block.undo_block()) back.push_back(*origin);
  finder.update(block, back);
  EXPECT_TRUE(finder.find().empty());
  finder.update(block, undercut(block, cube));
  EXPECT_EQ(finder.find().size(), 1U);
}

TEST(IslandFinder, AgreesWithALookAtEveryVoxelInRandomCuts) {
  std::mt19937 random(11);
  const auto any_of = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
  int found = 0;
  for (int run = 0; run < 40; ++run) {
    Workpiece block = block_of(17, 18, 19);
    IslandFinder finder(block);
    std::size_t pieces = 0;
    for (int cuts = 0; cuts < 12; ++cuts) {
      std::vector<VoxelIndex> changed;
      for (int plates = any_of(1, 3); plates > 0; --plates) {
        IndexBox plate = {{any_of(0, 12), any_of(0, 12), any_of(0, 12)}, {}};
        for (std::size_t a = 0; a < 3; ++a) plate.max[a] = plate.min[a] + any_of(6, 20);
        const auto axis = std::size_t(any_of(0, 2));
        plate.max[axis] = plate.min[axis];
        for (const VoxelIndex& origin : cut(block, plate)) changed.push_back(origin);
      }
      finder.update(block, changed);
      const std::vector<Island> islands = finder.find();
      EXPECT_EQ(islands, find_islands(block)) << "run " << run << ", cut " << cuts;
      for (const Island& island : islands) {
        const std::set<VoxelIndex> voxels = voxels_of(island);
        (void)cut(block, {{0, 0, 0}, {23, 23, 23}}, [&](const VoxelIndex& at) { return voxels.contains(at); });
      }
      pieces += islands.size();
    }
    found += int(pieces);
  }
  EXPECT_GT(found, 30) << "the cuts must make islands, else the test proves nothing";
}

TEST(IslandFinder, NeedsMillisecondsForAToothOfTwoMillionVoxels) {
  // 10 x 10 x 20 mm in voxels of 0.1 mm. The limit of 50 ms is acceptable for a waiting hand; measured times are far
  // shorter. Sanitizers and assertions are slow, so with them only the result is checked.
#if defined(NDEBUG)
  constexpr double limit = 0.05;
#else
  constexpr double limit = 10;
#endif
  Workpiece tooth = block_of(100, 100, 200);
  IslandFinder finder(tooth);
  const auto expect_one = [&](const std::vector<VoxelIndex>& changed, std::int64_t voxels) {
    const double begin = cpu_time();
    finder.update(tooth, changed);
    const std::vector<Island> islands = finder.find();
    EXPECT_LT(cpu_time() - begin, limit);
    EXPECT_EQ(sizes_of(islands), Sizes{voxels});
  };
  expect_one(undercut(tooth, {{40, 40, 90}, {59, 59, 109}}), 8000);
  // The worst case: cut through in the middle, so that each part has a million voxels.
  expect_one(cut(tooth, {{0, 0, 80}, {99, 99, 80}}), 100 * 100 * 80);
}

TEST(IsLoose, SeesWhatTouchesAPartOfABodyInABlockThatItDoesNotList) {
  Workpiece ball = block_of(16, 16, 16);
  (void)cut(ball, {{0, 0, 0}, {15, 15, 15}}, [](const VoxelIndex& at) { return !holds({{4, 4, 4}, {11, 7, 7}}, at); });
  Island half;
  half.min_fill = 0.05;
  half.blocks = {{{0, 0, 0}, ball.block({0, 0, 0}).filled_voxels(0.05F)}};
  EXPECT_FALSE(is_loose(half, 0, ball));
  (void)cut(ball, {{8, 0, 0}, {15, 15, 15}});
  EXPECT_TRUE(is_loose(half, 0, ball));
}

TEST(IsLoose, SeesWhatTouchesAnIslandSinceItWasFound) {
  Workpiece block = block_of(32, 32, 32);
  block.reserve_undo(1000);
  IslandFinder finder(block);
  const IndexBox cube = {{10, 10, 10}, {14, 14, 17}};
  block.set_mark();
  finder.update(block, undercut(block, cube));
  const std::vector<Island> islands = finder.find();
  ASSERT_EQ(islands.size(), 1U);
  const auto loose = [&] {
    bool all = true;
    for (std::size_t n = 0; n < islands[0].blocks.size(); ++n) all = all && is_loose(islands[0], n, block);
    return all;
  };
  EXPECT_TRUE(loose());
  while (block.undo_block()) {
  }
  EXPECT_FALSE(loose());
}

}  // namespace
}  // namespace hapticut::islands_test
