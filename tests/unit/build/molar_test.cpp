// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/molar.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <set>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "support/refusal.hpp"
#include "support/workpieces.hpp"

namespace hapticut::molar_test {
namespace {

using units::mm;

constexpr double kCoarse = 0.2 * mm;

const Workpiece& coarse_molar() {
  static const Workpiece molar = build_molar(kCoarse);
  return molar;
}

/// [mm^3]
double volume_of(const Workpiece& molar, MaterialId id) { return molar.amounts().at(id - 1U).volume / units::mm3; }

/// Number of pieces, connected over faces, of the voxels of a box that satisfy `belongs`.
int pieces(const IndexBox& box, const std::function<bool(const VoxelIndex&)>& belongs) {
  std::set<VoxelIndex> left;
  for_each_voxel(box, [&](const VoxelIndex& index) {
    if (belongs(index)) left.insert(index);
  });
  int count = 0;
  for (; !left.empty(); ++count) {
    std::deque<VoxelIndex> front = {*left.begin()};
    left.erase(left.begin());
    for (; !front.empty(); front.pop_front())
      for (const int axis : {0, 1, 2})
        for (const int step : {-1, 1}) {
          VoxelIndex next = front.front();
          next[std::size_t(axis)] += step;
          if (left.erase(next) > 0) front.push_back(next);
        }
  }
  return count;
}

IndexBox slice(const Workpiece& molar, double z) {
  IndexBox box = molar.bounds();
  const int k = int(std::lround((z - molar.frame().X_WV.translation.z()) / molar.voxel_size()));
  box.min[2] = box.max[2] = k;
  return box;
}

/// Height of the surface above (x, y), found from above; NaN beside the tooth.
double height_above(const BodyDescription& body, double x, double y) {
  for (double z = body.box.max.z(); z > 0;) {
    const double gap = body.distance({x, y, z});
    if (gap < 1e-8) return z;
    z -= gap;
  }
  return std::nan("");
}

/// Tips: points of the chewing surface that are the highest within a millimetre.
std::vector<Vec3> cusp_tips(const BodyDescription& body) {
  constexpr double kStep = 0.1 * mm;
  constexpr int kReach = 10;
  const int columns = int((body.box.max.x() - body.box.min.x()) / kStep);
  const int rows = int((body.box.max.y() - body.box.min.y()) / kStep);
  const auto point = [&](int i, int j) { return Vec3(body.box.min.x() + i * kStep, body.box.min.y() + j * kStep, 0); };
  std::vector<double> heights(std::size_t(columns * rows));
  const auto at = [&](int i, int j) -> double& { return heights[std::size_t(i * rows + j)]; };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) at(i, j) = height_above(body, point(i, j).x(), point(i, j).y());
  std::vector<Vec3> tips;
  for (int i = kReach; i < columns - kReach; ++i)
    for (int j = kReach; j < rows - kReach; ++j) {
      bool highest = at(i, j) > 5 * mm;
      for (int a = -kReach; a <= kReach && highest; ++a)
        for (int b = -kReach; b <= kReach && highest; ++b)
          highest = (a == 0 && b == 0) || !(at(i + a, j + b) > at(i, j)) || a * a + b * b > kReach * kReach;
      if (highest) tips.push_back(point(i, j) + Vec3(0, 0, at(i, j)));
    }
  return tips;
}

/// The default, a small and a large molar.
std::vector<MolarParameters> molars() {
  return {{},
          {.crown_mesiodistal = 9.5 * mm,
           .crown_buccolingual = 9 * mm,
           .crown_height = 6 * mm,
           .cervix_mesiodistal = 7.5 * mm,
           .cervix_buccolingual = 7.5 * mm,
           .mesial_root_length = 10 * mm,
           .distal_root_length = 9 * mm,
           .furcation_depth = 2.5 * mm,
           .distal_cusp = false,
           .caries_depth = 2 * mm},
          {.crown_mesiodistal = 13 * mm,
           .crown_buccolingual = 11 * mm,
           .crown_height = 8.5 * mm,
           .mesial_root_length = 17 * mm,
           .distal_root_length = 16 * mm,
           .fissure_depth = 0.8 * mm,
           .fissure_half_width = 0.2 * mm}};
}

// Ranges: two labelled micro-CT molars of unstated origin have 113 and 188 mm^3 of enamel, 539 and 512 of dentin and,
// after closing, 22 and 26 of pulp; both are smaller than the default crown. The upper limits are assumptions.
TEST(Molar, HasTheVolumesOfARealTooth) {
  const Workpiece& molar = coarse_molar();
  EXPECT_GT(volume_of(molar, kMolarEnamel), 180);
  EXPECT_LT(volume_of(molar, kMolarEnamel), 300);
  EXPECT_GT(volume_of(molar, kMolarDentin), 500);
  EXPECT_LT(volume_of(molar, kMolarDentin), 750);
  EXPECT_GT(volume_of(molar, kMolarPulp), 20);
  EXPECT_LT(volume_of(molar, kMolarPulp), 60);
}

TEST(Molar, KeepsItsVolumesWhenTheVoxelsHalve) {
  const Workpiece fine = build_molar(kCoarse / 2);
  for (const MaterialId id : {kMolarEnamel, kMolarDentin, kMolarPulp})
    // Inner boundaries are decided voxel by voxel, which affects the thin canals most.
    EXPECT_NEAR(volume_of(coarse_molar(), id) / volume_of(fine, id), 1, id == kMolarPulp ? 0.04 : 0.01) << int(id);
  // The outer surface is antialiased.
  EXPECT_NEAR(test::solid_volume(coarse_molar()) / test::solid_volume(fine), 1, 5e-4);
}

TEST(Molar, IsTheSameBitByBitEveryTime) {
  EXPECT_EQ(build_molar(kCoarse).hash(), coarse_molar().hash());
  MolarParameters other;
  other.fossa_depth = 2.7 * mm;
  EXPECT_NE(build_molar(kCoarse, other).hash(), coarse_molar().hash());
}

TEST(Molar, HasTheRequestedSizes) {
  constexpr double kTolerance = 0.15 * mm;  // rounded seams between lobes and strands move the outline by up to this
  for (const MolarParameters& p : molars()) {
    const Workpiece molar = build_molar(kCoarse, p);
    const IndexBox bounds = molar.bounds();
    const double h = molar.voxel_size();
    const Vec3 low = molar.frame().center(bounds.min) - Vec3::Constant(h / 2);
    const Vec3 high = molar.frame().center(bounds.max) + Vec3::Constant(h / 2);
    EXPECT_NEAR(high.x() - low.x(), p.crown_mesiodistal, h + 2 * kTolerance);
    EXPECT_NEAR(high.y() - low.y(), p.crown_buccolingual, h + 2 * kTolerance);
    EXPECT_NEAR(high.z(), p.crown_height, h + kTolerance);
    EXPECT_NEAR(-low.z(), p.mesial_root_length, h + kTolerance);
  }
}

Vec3 anywhere(const Box& box, test::RandomPoses& random) {
  const double x = random.between(0, 1), y = random.between(0, 1), z = random.between(0, 1);
  return box.min + Vec3(x, y, z).cwiseProduct(box.max - box.min);
}

TEST(Molar, LiesWithinItsBox) {
  for (const MolarParameters& p : molars()) {
    const BodyDescription body = describe_molar(p);
    test::RandomPoses random(1);
    for (int n = 0; n < 20000; ++n) {
      Vec3 q = anywhere(body.box, random);
      q[n % 3] = n % 2 == 0 ? body.box.min[n % 3] : body.box.max[n % 3];
      ASSERT_GT(body.distance(q), 0) << q.transpose();
    }
  }
}

// build_body requires that the function changes by at most one per unit of length.
TEST(Molar, IsBoundedByTheDistanceToItsSurface) {
  constexpr double kRounding = 1e-12;  // [m]
  for (const MolarParameters& p : molars()) {
    const BodyDescription body = describe_molar(p);
    test::RandomPoses random(2);
    for (int n = 0; n < 100000; ++n) {
      const Vec3 a = anywhere(body.box, random);
      const Vec3 b = a + std::pow(10, random.between(-7, -3)) * random.vector(2);
      ASSERT_LE(std::abs(body.distance(a) - body.distance(b)), (a - b).norm() + kRounding) << a.transpose();
    }
  }
}

TEST(Molar, IsOnePieceAndSoAreItsDentinAndItsPulp) {
  const Workpiece& molar = coarse_molar();
  EXPECT_EQ(pieces(molar.bounds(), [&](const VoxelIndex& i) { return molar.material_at(i) != kEmpty; }), 1);
  EXPECT_EQ(pieces(molar.bounds(), [&](const VoxelIndex& i) { return molar.material_at(i) == kMolarDentin; }), 1);
  EXPECT_EQ(pieces(molar.bounds(), [&](const VoxelIndex& i) { return molar.material_at(i) == kMolarPulp; }), 1);
}

TEST(Molar, KeepsItsPulpClosedIn) {
  for (const MolarParameters& p : molars()) {
    const Workpiece molar = build_molar(kCoarse, p);
    int pulp = 0;
    for_each_voxel(molar.bounds(), [&](const VoxelIndex& i) {
      if (molar.material_at(i) != kMolarPulp) return;
      ++pulp;
      for (const int axis : {0, 1, 2})
        for (const int step : {-1, 1}) {
          VoxelIndex next = i;
          next[std::size_t(axis)] += step;
          EXPECT_NE(molar.material_at(next), kEmpty);
          EXPECT_NE(molar.material_at(next), kMolarEnamel);
        }
    });
    EXPECT_GT(pulp, 1000);
  }
}

TEST(Molar, HasEnamelOnItsCrownOnly) {
  const Workpiece& molar = coarse_molar();
  int outside = 0, enamel_outside = 0;
  for_each_voxel(molar.bounds(), [&](const VoxelIndex& i) {
    const double z = molar.frame().center(i).z();
    if (molar.material_at(i) == kMolarEnamel) {
      EXPECT_GT(z, -kCoarse);
    }
    if (molar.fill_at(i) <= 0 || molar.fill_at(i) >= 1 || z < 1.5 * mm) return;  // above the curved junction
    ++outside;
    enamel_outside += molar.material_at(i) == kMolarEnamel;
  });
  EXPECT_GT(outside, 1000);
  EXPECT_EQ(enamel_outside, outside);
}

TEST(Molar, HasFiveCuspsOrFour) {
  const std::vector<Vec3> five = cusp_tips(describe_molar());
  ASSERT_EQ(five.size(), 5u);
  EXPECT_LT(five[0].x(), -3 * mm);  // the distal cusp is the lowest
  for (const Vec3& tip : five) EXPECT_GE(tip.z(), five[0].z());
  MolarParameters p;
  p.distal_cusp = false;
  EXPECT_EQ(cusp_tips(describe_molar(p)).size(), 4u);
}

TEST(Molar, HasTheRequestedEnamelThicknessAtEveryCusp) {
  constexpr double kTolerance = 0.3 * mm;  // cusps lean, and the boundary between two thicknesses is gradual
  for (const double thickness : {1.6 * mm, 2.2 * mm, 2.6 * mm}) {
    MolarParameters p;
    p.enamel_at_cusps = thickness;
    const BodyDescription body = describe_molar(p);
    for (const Vec3& tip : cusp_tips(body)) {
      double depth = 1e-6;
      while (body.material(tip - Vec3(0, 0, depth)) == kMolarEnamel) depth += 0.01 * mm;
      EXPECT_NEAR(depth, thickness, kTolerance) << tip.transpose();
    }
  }
}

TEST(Molar, StandsOnTwoRootsWithThreeCanals) {
  const Workpiece molar = build_molar(0.1 * mm);
  const auto solid = [&](const VoxelIndex& i) { return molar.fill_at(i) > 0.5; };
  const auto pulp = [&](const VoxelIndex& i) { return molar.material_at(i) == kMolarPulp; };
  EXPECT_EQ(pieces(slice(molar, -2 * mm), solid), 1);
  EXPECT_EQ(pieces(slice(molar, -5 * mm), solid), 2);
  EXPECT_EQ(pieces(slice(molar, -9 * mm), solid), 2);
  for (const double z : {-4 * mm, -6 * mm, -8 * mm, -10 * mm}) EXPECT_EQ(pieces(slice(molar, z), pulp), 3) << z;
  EXPECT_EQ(pieces(slice(molar, -13.5 * mm), solid), 1);  // the distal root is shorter
  EXPECT_EQ(pieces(slice(molar, -13.5 * mm), pulp), 0);   // the canals end in dentin
}

TEST(Molar, HasALesionUnderTheFossaOnDemand) {
  EXPECT_EQ(coarse_molar().materials().size(), 3);
  MolarParameters p;
  p.caries_depth = 2.5 * mm;
  p.caries_width = 2 * mm;
  const Workpiece molar = build_molar(kCoarse, p);
  ASSERT_EQ(molar.materials().size(), 4);
  const double spheroid = units::kPi / 6 * 2.5 * 2 * 2;  // [mm^3] minus the part above the fossa
  EXPECT_GT(volume_of(molar, kMolarCaries), 0.75 * spheroid);
  EXPECT_LT(volume_of(molar, kMolarCaries), 1.02 * spheroid);
  EXPECT_NEAR(test::solid_volume(molar) / test::solid_volume(coarse_molar()), 1, 1e-12) << "the shape is unchanged";
}

TEST(Molar, RefusesSizesThatNoMolarHasAndNamesThem) {
  struct Case {
    const char* field;
    double MolarParameters::*member;
    double value;
  };
  const double nan = std::nan("");
  for (const Case& c : {Case{"crown_mesiodistal", &MolarParameters::crown_mesiodistal, 0},
                        Case{"crown_buccolingual", &MolarParameters::crown_buccolingual, nan},
                        Case{"crown_height", &MolarParameters::crown_height, 7.5},
                        Case{"cervix_mesiodistal", &MolarParameters::cervix_mesiodistal, 12 * mm},
                        Case{"cervix_buccolingual", &MolarParameters::cervix_buccolingual, 1 * mm},
                        Case{"cervical_curvature", &MolarParameters::cervical_curvature, -1 * mm},
                        Case{"mesial_root_length", &MolarParameters::mesial_root_length, 3 * mm},
                        Case{"distal_root_length", &MolarParameters::distal_root_length, 30 * mm},
                        Case{"furcation_depth", &MolarParameters::furcation_depth, 0},
                        Case{"fossa_depth", &MolarParameters::fossa_depth, 6 * mm},
                        Case{"fissure_depth", &MolarParameters::fissure_depth, 2 * mm},
                        Case{"fissure_half_width", &MolarParameters::fissure_half_width, 0},
                        Case{"enamel_at_cusps", &MolarParameters::enamel_at_cusps, 0},
                        Case{"enamel_on_walls", &MolarParameters::enamel_on_walls, 5 * mm},
                        Case{"enamel_in_fossa", &MolarParameters::enamel_in_fossa, nan},
                        Case{"chamber_mesiodistal", &MolarParameters::chamber_mesiodistal, 8 * mm},
                        Case{"chamber_buccolingual", &MolarParameters::chamber_buccolingual, 0},
                        Case{"chamber_roof", &MolarParameters::chamber_roof, 5 * mm},
                        Case{"chamber_height", &MolarParameters::chamber_height, 0},
                        Case{"horn_height", &MolarParameters::horn_height, 4 * mm},
                        Case{"canal_radius", &MolarParameters::canal_radius, 2 * mm},
                        Case{"canal_radius_at_apex", &MolarParameters::canal_radius_at_apex, 0.5 * mm},
                        Case{"apical_dentin", &MolarParameters::apical_dentin, 0},
                        Case{"caries_depth", &MolarParameters::caries_depth, -1 * mm},
                        Case{"caries_width", &MolarParameters::caries_width, 0}}) {
    MolarParameters p;
    p.*c.member = c.value;
    test::expect_refused([&] { (void)build_molar(kCoarse, p); }, {("::" + std::string(c.field) + " ").c_str()});
  }
  EXPECT_THROW((void)build_molar(0), Error);
}

}  // namespace
}  // namespace hapticut::molar_test
