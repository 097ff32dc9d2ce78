// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/builders.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "hapticut/core/units.hpp"
#include "support/refusal.hpp"
#include "support/workpieces.hpp"

namespace hapticut::builders_test {
namespace {

using test::named;
using units::kPi;
using units::mm;

TEST(BuildBlock, FillsAPartlyCoveredLastRowByItsFraction) {
  const Workpiece workpiece = build_block({Vec3::Zero(), Vec3(1, 1, 0.96) * mm}, 0.1 * mm, named("clay"));
  EXPECT_NEAR(workpiece.amounts()[0].volume, 0.96e-9, 1e-16);
  EXPECT_LT((workpiece.amounts()[0].center - Vec3(0.5, 0.5, 0.48) * mm).norm(), 1e-4 * mm);
  EXPECT_NEAR(workpiece.fill_at({3, 3, 9}), 0.6, 1e-6);
  EXPECT_EQ(workpiece.centroid_at({3, 3, 9}), CentroidOffset::from_offset({0, 0, -0.2}));
}

TEST(BuildLayeredSlab, GivesEachLayerItsVolume) {
  const Workpiece workpiece = build_layered_slab({Vec3::Zero(), Vec3(2, 2, 3) * mm}, 0.1 * mm,
                                                 {{named("enamel"), 1 * mm}, {named("dentin"), 1.5 * mm}});
  const auto amounts = workpiece.amounts();
  EXPECT_NEAR(amounts[0].volume, 4e-9, 1e-15);
  EXPECT_NEAR(amounts[1].volume, 6e-9, 1e-15);
  EXPECT_LT((amounts[0].center - Vec3(1, 1, 2.5) * mm).norm(), 1e-4 * mm);
  EXPECT_LT((amounts[1].center - Vec3(1, 1, 1.25) * mm).norm(), 1e-4 * mm);
}

TEST(BuildLayeredSlab, RefusesALayerThatFillsNoVoxel) {
  const auto slab = [](double enamel) {
    return build_layered_slab({Vec3::Zero(), Vec3(2, 2, 3) * mm}, 0.1 * mm,
                              {{named("dentin"), 1.01 * mm}, {named("enamel"), enamel}, {named("pulp"), 1 * mm}});
  };
  EXPECT_NEAR(slab(0.2 * mm).amounts()[1].volume, 0.8e-9, 1e-15);
  test::expect_refused(
      [&] { return slab(0.02 * mm); },
      {"layer 2 of the slab, 'enamel', is 0.02 mm thick; no row of voxels of 0.1 mm lies mostly in it.",
       "Choose smaller voxels."});
}

TEST(MaterialAmount, HasNoCentreWithoutVoxels) {
  const Workpiece slab = build_layered_slab({Vec3::Zero(), Vec3(2, 2, 1) * mm}, 0.1 * mm,
                                            {{named("enamel"), 1 * mm}, {named("dentin"), 1 * mm}});
  EXPECT_TRUE(slab.amounts()[0].center.allFinite());
  ASSERT_EQ(slab.amounts()[1].voxels, 0);
  EXPECT_TRUE(slab.amounts()[1].center.array().isNaN().all());
}

TEST(BuildSphere, ConvergesToItsVolume) {
  for (const auto& [voxel, tolerance] : {std::pair{0.2 * mm, 1e-4}, {0.1 * mm, 3e-5}}) {
    const Workpiece ball = build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, voxel, named("clay"));
    EXPECT_NEAR(test::solid_volume(ball) / (4 * kPi / 3 * 8e-9), 1, tolerance);
    EXPECT_LT((ball.amounts()[0].center - Vec3(1, 2, 3) * mm).norm(), 1e-3 * mm);
  }
}

constexpr int kPoints = 32;  // per voxel edge

/// Counts a lattice of points in a voxel one by one.
double counted_fill(const BodyDescription& body, const Workpiece& workpiece, const VoxelIndex& index) {
  const Vec3 center = workpiece.frame().center(index);
  const double distance = body.distance(center);
  if (std::abs(distance) > 0.9 * workpiece.voxel_size()) return distance < 0 ? 1 : 0;
  int inside = 0;
  for (int n = 0; n < kPoints * kPoints * kPoints; ++n) {
    const Vec3 offset =
        (Vec3(n / (kPoints * kPoints), n / kPoints % kPoints, n % kPoints).array() + 0.5) / kPoints - 0.5;
    inside += body.distance(center + workpiece.voxel_size() * offset) < 0;
  }
  return inside / double(kPoints * kPoints * kPoints);
}

/// Largest difference between the fill of a voxel and the counted one.
double worst_fill(const BodyDescription& body, const Workpiece& workpiece) {
  double worst = 0;
  for_each_voxel(workpiece.bounds(), [&](const VoxelIndex& at) {
    worst = std::max(worst, std::abs(workpiece.fill_at(at) - counted_fill(body, workpiece, at)));
  });
  return worst;
}

MaterialId only_material(const Vec3&) { return 1; }

// Counting locates a face along the grid to half the spacing of its points. The builder's own error is smaller.
constexpr double kMiscounted = 0.5 / kPoints + 0.005;

TEST(BuildBody, AntialiasesASmoothSurfaceLikeItsDefinition) {
  const BodyDescription ball = {{Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)},
                                [](const Vec3& p) { return (p - Vec3(0.03, 0.02, 0.01) * mm).norm() - 1.9 * mm; },
                                only_material};
  for (const double h : {0.1 * mm, 0.23 * mm, 0.5 * mm})
    EXPECT_LE(worst_fill(ball, build_body(ball, h, MaterialTable({named("clay")}))), kMiscounted) << h;
}

TEST(BuildBody, PutsFacesAlongTheGridWhereTheyAre) {
  // The function of the box is its true distance: it is smooth at faces, but not at edges and corners.
  for (const double shift : {0.0, 0.013, 0.05, 0.0777, 0.099}) {
    const Vec3 low = Vec3(-1 + shift, -0.9 - shift / 2, -1.1 + shift / 3) * mm, high = Vec3(1, 0.8, 0.9) * mm;
    const BodyDescription box = {{Vec3::Constant(-1.5 * mm), Vec3::Constant(1.5 * mm)},
                                 [&](const Vec3& p) {
                                   const Vec3 q = (p - (low + high) / 2).cwiseAbs() - (high - low) / 2;
                                   return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
                                 },
                                 only_material};
    const Workpiece workpiece = build_body(box, 0.1 * mm, MaterialTable({named("clay")}));
    const Vec3 first = (low - box.box.min) / (0.1 * mm), last = (high - box.box.min) / (0.1 * mm);
    const double kPacked = 2e-3;  // centroids are packed with 10 bits for each axis
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const double at = upper ? last[axis] : first[axis], fraction = at - std::floor(at);
        VoxelIndex index = {15, 15, 15};
        index[std::size_t(axis)] = int(std::floor(at));
        const double fill = upper ? fraction : 1 - fraction;
        EXPECT_NEAR(workpiece.fill_at(index), fill, 1e-5) << "axis " << axis << " shift " << shift;
        Vec3 middle = Vec3::Zero();
        middle[axis] = fill > 1e-6 && fill < 1 - 1e-6 ? (upper ? -1 : 1) * (1 - fill) / 2 : 0;
        EXPECT_LT((test::centroid_of(workpiece, index) - middle).norm(), kPacked) << "axis " << axis;
      }
    const double kEdges = 1e-4;  // cells that two faces cut
    EXPECT_NEAR(workpiece.amounts()[0].volume / (high - low).prod(), 1, kEdges) << shift;
  }
}

TEST(BuildBody, KeepsEdgesCornersAndThinSheets) {
  const Mat3 rotation = rotation_from_vector({0.3, 0.5, -0.2});
  const auto box = [rotation](const Vec3& p, const Vec3& half) {
    const Vec3 q = (rotation * p).cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  };
  const Box around = {Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)};
  for (const Vec3& half : {Vec3(1, 1, 1), Vec3(1, 0.9, 0.02), Vec3(1, 0.03, 0.04)}) {
    const BodyDescription body = {around, [&](const Vec3& p) { return box(p, half * mm); }, only_material};
    EXPECT_LE(worst_fill(body, build_body(body, 0.1 * mm, MaterialTable({named("clay")}))), kMiscounted) << half;
  }
}

TEST(BuildBody, KeepsASheetInTheMiddleOfAVoxelAsThinAsItIs) {
  const BodyDescription sheet = {{Vec3::Constant(-0.5 * mm), Vec3::Constant(0.5 * mm)},
                                 [](const Vec3& p) { return std::abs(p.x() - 0.05 * mm) - 0.0125 * mm; },
                                 only_material};
  const Workpiece workpiece = build_body(sheet, 0.1 * mm, MaterialTable({named("clay")}));
  EXPECT_NEAR(workpiece.amounts()[0].volume, 0.025e-9, 1e-15);
}

TEST(BuildBody, AsksTheFunctionOfASmoothBodyOnlyAFewTimesForEachVoxelOfItsSurface) {
  std::atomic<long> calls = 0;
  const BodyDescription ball = {{Vec3::Constant(-5 * mm), Vec3::Constant(5 * mm)},
                                [&](const Vec3& p) {
                                  ++calls;
                                  return p.norm() - 4.9 * mm;
                                },
                                only_material};
  (void)build_body(ball, 0.1 * mm, MaterialTable({named("clay")}));
  const double surface_voxels = 4 * kPi * 49 * 49;
  // The calls include the centres of whole blocks. Point by point there would be 900 calls for each surface voxel.
  EXPECT_LT(double(calls), 30 * surface_voxels);
}

TEST(CentroidOffset, SurvivesPacking) {
  for (const Vec3& v : {Vec3(0, 0, 0), Vec3(-0.5, 0.25, 0.49), Vec3(0.1, -0.37, -0.001)}) {
    const CentroidOffset offset = CentroidOffset::from_offset(v);
    EXPECT_EQ(CentroidOffset::unpacked(offset.packed()), offset);
  }
}

}  // namespace
}  // namespace hapticut::builders_test
