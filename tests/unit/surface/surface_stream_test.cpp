// SPDX-License-Identifier: Apache-2.0
// Properties of the pages of a surface: closed, with the right volume and normals,
// however the surface is divided.
#include "hapticut/surface/surface_stream.hpp"

#include <gtest/gtest.h>

#include <random>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "support/ball_cuts.hpp"
#include "support/mesh_measures.hpp"
#include "support/surface_pages.hpp"
#include "support/workpieces.hpp"

namespace hapticut::surface_stream_test {
namespace {

using test::count_edges;
using test::named;
using test::Pages;
using test::pages_of;
using test::take_pages;
using test::welded;
using units::mm;

constexpr double kVoxel = 0.1 * mm;

std::size_t triangles_of(const Pages& pages) {
  std::size_t count = 0;
  for (const auto& [origin, page] : pages) count += page.indices.size() / 3;
  return count;
}

TEST(SurfaceStream, PagesPutTogetherAreClosedAndHoldTheVolumeOfTheWorkpiece) {
  Workpiece ball = build_sphere(Vec3(0.3, -0.2, 0.1) * mm, 4 * mm, kVoxel, named("clay"));
  Workpiece drilled = test::two_materials(9.13 * mm, kVoxel);
  drilled.reserve_blocks(4000);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 92), radius(4, 14);
  for (int n = 0; n < 30; ++n)
    (void)test::cut_ball(drilled, {place(random), place(random), place(random)}, radius(random));
  Workpiece molar = build_molar(0.15 * mm);
  for (const Workpiece* workpiece : {&ball, &drilled, &molar}) {
    const Pages pages = pages_of(*workpiece);
    EXPECT_GT(pages.size(), 8U);
    const TriangleMesh mesh = welded(pages, workpiece->frame());
    const test::EdgeCount edges = count_edges(mesh);
    EXPECT_TRUE(edges.balanced);
    // Four triangles meet where two pieces touch along an edge: nowhere on a ball, but at some places of a broken
    // block.
    EXPECT_LE(double(edges.more_often), workpiece == &ball ? 0.0 : 1e-3 * double(edges.twice));
    EXPECT_NEAR(test::signed_volume(mesh) / test::solid_volume(*workpiece), 1, 0.01);
  }
}

/// [deg] Maximum and mean angle between the normals of all vertices and the exact normals.
struct NormalError {
  double maximum = 0, mean = 0;
};
template <class TrueNormal>
NormalError normal_error(const Workpiece& workpiece, const TrueNormal& true_normal) {
  NormalError error;
  double count = 0;
  for (const auto& [origin, page] : pages_of(workpiece))
    for (const SurfaceVertex& vertex : page.vertices) {
      const Vec3 exact = true_normal(vertex_position(workpiece.frame(), page, vertex));
      if (exact.isZero()) continue;  // near an edge, where there is no normal
      const double cosine = std::clamp(exact.dot(vertex_normal(workpiece.frame(), vertex)), -1.0, 1.0);
      const double angle = std::acos(cosine) / units::deg;
      error.maximum = std::max(error.maximum, angle);
      error.mean += angle, count += 1;
    }
  error.mean /= count;
  return error;
}

// Below three degrees a lit surface looks smooth; the rounding to 1/127 alone is a third of a degree.
TEST(SurfaceStream, NormalsOfBallsAreWithinThreeDegrees) {
  for (const double radius : {0.8, 1.5, 4.0}) {
    const Vec3 center = Vec3(0.31, -0.17, 0.23) * mm;
    const Workpiece ball = build_sphere(center, radius * mm, kVoxel, named("clay"));
    const NormalError error = normal_error(ball, [&](const Vec3& p) { return (p - center).normalized(); });
    EXPECT_LT(error.maximum, 3) << radius;
    EXPECT_LT(error.mean, 1.5) << radius;
    RecordProperty("ball " + std::to_string(radius), std::to_string(error.mean) + " " + std::to_string(error.maximum));
  }
}

TEST(SurfaceStream, NormalsOfPlanesAreWithinThreeDegrees) {
  test::RandomPoses poses(3);
  for (int n = 0; n < 30; ++n) {
    const Vec3 normal = poses.rotation().col(0);
    const Workpiece half = build_body({{Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)},
                                       [&](const Vec3& p) { return p.dot(normal) - 0.013 * mm; },
                                       [](const Vec3&) { return MaterialId(1); }},
                                      kVoxel, MaterialTable({named("clay")}));
    const NormalError error = normal_error(
        half, [&](const Vec3& p) { return p.cwiseAbs().maxCoeff() > 1.7 * mm ? Vec3(Vec3::Zero()) : normal; });
    EXPECT_LT(error.maximum, 3) << normal.transpose();
    EXPECT_LT(error.mean, 1.5) << normal.transpose();
  }
}

TEST(SurfaceStream, VerticesLieOnTheSurface) {
  const Vec3 center = Vec3(0.31, -0.17, 0.23) * mm;
  const Workpiece ball = build_sphere(center, 4 * mm, kVoxel, named("clay"));
  double squares = 0, count = 0;
  for (const auto& [origin, page] : pages_of(ball))
    for (const SurfaceVertex& vertex : page.vertices) {
      const double off = ((vertex_position(ball.frame(), page, vertex) - center).norm() - 4 * mm) / kVoxel;
      EXPECT_LT(std::abs(off), 0.15);
      squares += off * off, count += 1;
    }
  EXPECT_LT(std::sqrt(squares / count), 0.07);
}

TEST(SurfaceStream, RoundingOpensNoSeamBetweenPages) {
  Workpiece drilled = test::two_materials(9.13 * mm, kVoxel);
  drilled.reserve_blocks(4000);
  (void)test::cut_ball(drilled, {31.7, 32.2, 63.9}, 17.3);
  // Each cell has one vertex, which is equal in all pages that contain it.
  std::map<VoxelIndex, std::pair<VoxelIndex, SurfaceVertex>> by_cell;
  std::size_t shared = 0;
  for (const auto& [origin, page] : pages_of(drilled))
    for (SurfaceVertex vertex : page.vertices) {
      const VoxelIndex at = test::grid_position(page, vertex);
      const VoxelIndex cell = {at[0] >> 9, at[1] >> 9, at[2] >> 9};
      vertex.position = {};
      const auto [place, is_new] = by_cell.try_emplace(cell, at, vertex);
      EXPECT_EQ(place->second.first, at);
      EXPECT_EQ(place->second.second, vertex);
      if (!is_new) ++shared;
    }
  EXPECT_GT(shared, 1000U);
}

TEST(SurfaceStream, WallsOfACavityShowWhatIsInThem) {
  Workpiece block = test::two_materials(6 * mm, kVoxel);
  block.reserve_blocks(1000);
  (void)test::cut_ball(block, {30, 30, 58}, 20);
  int upper = 0, lower = 0;
  for (const auto& [origin, page] : pages_of(block))
    for (const SurfaceVertex& vertex : page.vertices) {
      const Vec3 p_WQ = vertex_position(block.frame(), page, vertex);
      const double above = p_WQ.dot(Vec3(1, 2, 5)) / Vec3(1, 2, 5).norm();
      if (std::abs(above) < kVoxel) continue;  // within a voxel of the seam either is right
      EXPECT_EQ(vertex.material, above > 0 ? 1 : 2) << p_WQ.transpose();
      ++(above > 0 ? upper : lower);
    }
  EXPECT_GT(upper, 1000);
  EXPECT_GT(lower, 1000);
}

TEST(SurfaceStream, PagesNearestToThePointLookedAtComeFirst) {
  const Workpiece ball = build_sphere(Vec3::Zero(), 8 * mm, kVoxel, named("clay"));
  SurfaceStream stream(ball);
  const Vec3 looked_at = Vec3(6, -3, 2) * mm;
  stream.look_at(looked_at);
  SurfacePage page;
  double before = 0;
  int pages = 0;
  for (; stream.next_page(page); ++pages) {
    const double half = 0.5 * (SurfacePage::kEdge - 1);
    const Vec3 middle(page.origin[0] + half, page.origin[1] + half, page.origin[2] + half);
    const double distance = (ball.frame().X_WV * (kVoxel * middle) - looked_at).norm();
    EXPECT_GE(distance, before - 1e-9);
    before = distance;
  }
  EXPECT_GT(pages, 50);
  EXPECT_EQ(stream.waiting(), 0U);
  EXPECT_THROW(stream.look_at({std::nan(""), 0, 0}), Error);
}

TEST(SurfaceStream, ANewReaderGetsAllPages) {
  const Workpiece ball = build_sphere(Vec3::Zero(), 4 * mm, kVoxel, named("clay"));
  SurfaceStream stream(ball);
  Pages first, second;
  take_pages(stream, first);
  const std::uint64_t meshed = stream.blocks_meshed();
  stream.resend();
  EXPECT_EQ(stream.waiting(), first.size());
  take_pages(stream, second);
  EXPECT_TRUE(test::are_equal(first, second));
  EXPECT_EQ(stream.blocks_meshed(), meshed) << "nothing has changed, so nothing is meshed again";
}

TEST(SurfaceStream, CompletelyRemovedMaterialLeavesEmptyPages) {
  Workpiece ball = build_sphere(Vec3::Zero(), 2 * mm, kVoxel, named("clay"));
  ball.reserve_blocks(1000);
  SurfaceStream stream(ball);
  Pages pages;
  take_pages(stream, pages);
  const std::size_t before = pages.size();
  const Vec3 middle = (ball.frame().X_WV.inverse() * Vec3::Zero()) / kVoxel;
  const std::vector<VoxelIndex> changed = test::cut_ball(ball, middle, 30);
  ASSERT_TRUE(ball.empty());
  EXPECT_TRUE(stream.update(ball, changed));
  SurfacePage page;
  std::size_t emptied = 0;
  for (; stream.next_page(page); ++emptied) EXPECT_TRUE(page.vertices.empty() && page.indices.empty());
  EXPECT_EQ(emptied, before);
}

TEST(SurfaceStream, OfNothingHasNoPages) {
  const Workpiece nothing = Workpiece::from_blocks({{0, 0, 0}, {7, 7, 7}}, GridFrame{}, MaterialTable({named("clay")}),
                                                   [](const VoxelIndex&, BlockContent&) { return BlockKind::empty(); });
  SurfaceStream stream(nothing);
  SurfacePage page;
  EXPECT_FALSE(stream.next_page(page));
  EXPECT_FALSE(stream.update(nothing, std::vector<VoxelIndex>{{0, 0, 0}})) << "it has no bounds";
}

TEST(SurfaceStream, AVoxelInTheMiddleOfABlockDirtiesItAloneAndOneInACornerItsEightNeighbours) {
  Workpiece block = build_block({Vec3::Zero(), Vec3(6.4, 6.4, 6.4) * mm}, kVoxel, named("clay"));
  block.reserve_blocks(100);
  SurfaceStream stream(block);
  Pages pages;
  take_pages(stream, pages);
  const auto meshed_by = [&](const VoxelIndex& voxel) {
    const std::uint64_t before = stream.blocks_meshed();
    const VoxelIndex origin = {block_start(voxel[0]), block_start(voxel[1]), block_start(voxel[2])};
    float* fill = block.writable_fill(origin);
    fill[block_offset(voxel[0] - origin[0], voxel[1] - origin[1], voxel[2] - origin[2])] = 0.25F;
    EXPECT_TRUE(stream.update(block, std::vector{origin}));
    take_pages(stream, pages);
    EXPECT_TRUE(test::are_equal(pages, pages_of(block)));
    return stream.blocks_meshed() - before;
  };
  EXPECT_EQ(meshed_by({28, 28, 28}), 1U);
  EXPECT_EQ(meshed_by({24, 24, 24}), 8U);
  EXPECT_EQ(meshed_by({24, 24, 24}), 0U) << "the same block again";
}

TEST(SurfaceStream, TheLargestPageHasRoomInSixteenBits) {
  // A checkerboard: each cell has a vertex, each edge a quadrilateral.
  const Workpiece board = Workpiece::from_blocks({{0, 0, 0}, {63, 63, 63}}, GridFrame{}, MaterialTable({named("clay")}),
                                                 [](const VoxelIndex&, BlockContent& content) {
                                                   for (int n = 0; n < kBlockVoxels; ++n) {
                                                     const bool full = ((n >> 6) + (n >> 3) + n) % 2 == 0;
                                                     content.material[std::size_t(n)] = full ? MaterialId(1) : kEmpty;
                                                     content.fill[std::size_t(n)] = full ? 1.0F : 0.0F;
                                                     content.centroid[std::size_t(n)] = {};
                                                   }
                                                   return BlockKind::mixed();
                                                 });
  const Pages pages = pages_of(board);
  std::size_t max_vertices = 0;
  for (const auto& [origin, page] : pages) {
    max_vertices = std::max(max_vertices, page.vertices.size());
    EXPECT_LE(page.vertices.size(), SurfacePage::kMaxVertices);
    EXPECT_LE(page.indices.size(), SurfacePage::kMaxIndices);
    for (const std::uint16_t index : page.indices) ASSERT_LT(index, page.vertices.size());
  }
  EXPECT_GT(max_vertices, 40'000U);
  EXPECT_TRUE(count_edges(welded(pages, board.frame())).balanced);
}

TEST(SurfaceStream, MemoryIsWhatTheHeaderSays) {
  const Workpiece ball = build_sphere(Vec3::Zero(), 8 * mm, kVoxel, named("clay"));
  SurfaceStream stream(ball);
  Pages pages;
  take_pages(stream, pages);
  std::size_t with_surface = 0;
  ball.for_each_block([&](const BlockView& block) { with_surface += block.fill != nullptr ? 1 : 0; });
  EXPECT_GT(triangles_of(pages), 100'000U);
  EXPECT_LT(double(stream.memory_bytes()) / double(with_surface), 6000);
}

}  // namespace
}  // namespace hapticut::surface_stream_test
