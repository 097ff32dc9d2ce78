// SPDX-License-Identifier: Apache-2.0
// The pages of a workpiece after cuts, undos and restores in any order equal those
// of a new stream of its final state.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "hapticut/core/units.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "support/ball_cuts.hpp"
#include "support/generators.hpp"
#include "support/mesh_measures.hpp"
#include "support/surface_pages.hpp"
#include "support/workpieces.hpp"

namespace hapticut::streamed_cuts_test {
namespace {

using test::are_equal;
using test::Pages;
using test::pages_of;
using test::take_pages;
using units::mm;
using units::ms;

constexpr double kVoxel = 0.1 * mm;

/// A block with random cuts, undos, redos and restored snapshots, and the stream that follows it.
class FollowedBlock {
 public:
  explicit FollowedBlock(double edge)
      : voxels_(edge / kVoxel), block_(test::two_materials(edge, kVoxel)), stream_(block_) {
    block_.reserve_undo(1000);
    block_.reserve_blocks(1500);
    kept_ = block_.snapshot();
  }

  void cut(const Vec3& place, double radius) { follow(test::cut_ball(block_, voxels_ * place, radius)); }
  void set_mark() { block_.set_mark(); }
  void undo() {
    std::vector<VoxelIndex> changed;
    while (const auto origin = block_.undo_block()) changed.push_back(*origin);
    follow(changed);
  }
  void redo() {
    std::vector<VoxelIndex> changed;
    while (const auto origin = block_.redo_block()) changed.push_back(*origin);
    follow(changed);
  }
  void keep() { kept_ = block_.snapshot(); }
  void restore() {
    block_.restore(kept_);
    block_.reserve_undo(1000);
    block_.reserve_blocks(1500);
    // The changed blocks are unknown, so all blocks are sent once more, as ChangeFeed does.
    std::vector<VoxelIndex> all;
    const int last = int(voxels_) + kBlockEdge;
    for_each_block_origin({{-1, -1, -1}, {last, last, last}}, [&](const VoxelIndex& at) { all.push_back(at); });
    (void)stream_.update(block_, all);
  }
  void receive() { take_pages(stream_, pages_); }

  [[nodiscard]] const Workpiece& workpiece() const { return block_; }
  [[nodiscard]] const Pages& pages() const { return pages_; }
  [[nodiscard]] std::uint64_t blocks_meshed() const { return stream_.blocks_meshed(); }

  /// Pages of a new stream of the present workpiece; its bounds may be smaller, so it has fewer empty pages.
  [[nodiscard]] bool is_as_rebuilt() {
    receive();
    return are_equal(pages_, pages_of(block_));
  }

 private:
  void follow(const std::vector<VoxelIndex>& changed) { EXPECT_TRUE(stream_.update(block_, changed)); }

  double voxels_;
  Workpiece block_;
  SurfaceStream stream_;
  WorkpieceSnapshot kept_;
  Pages pages_;
};

RC_GTEST_PROP(StreamedCuts, AnySequenceOfCutsUndoAndRestoreGivesThePagesOfARebuild, ()) {
  FollowedBlock block(3.53 * mm);
  const int count = *rc::gen::inRange(1, 30);
  for (int n = 0; n < count; ++n) {
    switch (*rc::gen::inRange(0, 10)) {
      case 0:
        block.set_mark();
        break;
      case 1:
        block.undo();
        break;
      case 2:
        block.redo();
        break;
      case 3:
        block.keep();
        break;
      case 4:
        block.restore();
        break;
      case 5:
        block.receive();  // at any time, so that some pages are older than others
        break;
      default:
        block.cut(
            {*test::number_between(-0.1, 1.1), *test::number_between(-0.1, 1.1), *test::number_between(-0.1, 1.1)},
            *test::number_between(1, 9));
    }
  }
  RC_ASSERT(block.is_as_rebuilt());
  const TriangleMesh mesh = test::welded(block.pages(), block.workpiece().frame());
  RC_ASSERT(test::count_edges(mesh).balanced);
}

TEST(StreamedCuts, TenThousandCutsGiveThePagesOfARebuild) {
  FollowedBlock block(6.4 * mm);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.05, 1.05), radius(0.7, 3);
  int restored = 0;
  for (int n = 1; n <= 10'000; ++n) {
    block.cut({place(random), place(random), place(random)}, radius(random));
    if (n % 16 == 0) block.receive();
    if (n % 100 == 0) block.set_mark();
    if (n % 230 == 0) block.undo();
    if (n % 460 == 0) block.redo();
    if (n % 1000 == 0 && n != 10'000) block.restore(), ++restored;  // else nothing would be left to cut
    if (n % 999 == 0) {
      EXPECT_TRUE(block.is_as_rebuilt()) << n;
    }
  }
  EXPECT_EQ(restored, 9);
  EXPECT_TRUE(block.is_as_rebuilt());
  EXPECT_GT(block.pages().size(), 8U);
  const TriangleMesh mesh = test::welded(block.pages(), block.workpiece().frame());
  EXPECT_TRUE(test::count_edges(mesh).balanced);
  // The rest is a sponge whose walls are one voxel thick.
  EXPECT_NEAR(test::signed_volume(mesh) / test::solid_volume(block.workpiece()), 1, 0.03);
}

TEST(StreamedCuts, ASimulationIsFollowedThroughItsFeedBesideTheSteps) {
  SimulationConfig config;
  config.reserved_blocks = 1000;
  Simulation simulation(test::two_materials(5 * mm, kVoxel),
                        Tool(SphereHead{0.7 * mm}, RayHandle{0}, Spindle{3000 * units::rad_per_s}), config);
  simulation.history().reserve(500);
  ChangeFeed feed(simulation);
  SurfaceStream stream(simulation.workpiece());
  Pages pages;
  take_pages(stream, pages);
  const auto follow = [&] {
    ChangedBlock block;
    while (feed.receive(block)) {
      EXPECT_TRUE(stream.update(block.origin, block.material.data(), block.fill.data()));
    }
    take_pages(stream, pages);
  };
  const auto cut = [&](double x, double deepest) {
    for (int n = 0; n < 300; ++n) {
      const double z = 2.5 * mm + 0.7 * mm - deepest * n / 300;
      (void)simulation.step(Pose::from_translation({x, 0.1 * mm, z}), {{0, 0, -deepest / 0.3}, Vec3::Zero()}, 1 * ms);
      if (n % 16 == 0) follow();
    }
    // The tool retracts in small steps until the feed has sent all blocks.
    for (int n = 0; n < 300; ++n) {
      (void)simulation.step(Pose::from_translation({x, 0.1 * mm, 2.5 * mm + 0.7 * mm - deepest + n * 0.01 * mm}), {},
                            1 * ms);
      follow();
    }
  };
  const Pages whole = pages;
  simulation.history().mark();
  cut(0.4 * mm, 1 * mm);
  ASSERT_GT(simulation.last_result().energy.cutting, 0);
  EXPECT_FALSE(are_equal(pages, whole));
  EXPECT_TRUE(are_equal(pages, pages_of(simulation.workpiece())));
  while (!simulation.history().undo(100)) {
  }
  cut(-0.8 * mm, 0.6 * mm);  // the feed sends the undone blocks while the next hole is cut
  EXPECT_TRUE(are_equal(pages, pages_of(simulation.workpiece())));
}

}  // namespace
}  // namespace hapticut::streamed_cuts_test
