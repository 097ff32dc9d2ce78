// SPDX-License-Identifier: Apache-2.0
// What every head must keep, whatever its shape: the step relies on it.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "support/random_pose.hpp"

namespace hapticut {
namespace {

using test::RandomPoses;
using units::deg;
using units::mm;

struct NamedHead {
  const char* name;
  ToolHead head;
};

void PrintTo(const NamedHead& named, std::ostream* out) { *out << named.name; }

class HeadContract : public testing::TestWithParam<NamedHead> {
 protected:
  const ToolHead& head() const { return GetParam().head; }

  /// Calls `check(rho, z)` for many points in and around the head.
  template <class Check>
  void for_points(Check&& check) {
    RandomPoses random(9);
    const double reach = 1.3 * head().reach();
    for (int n = 0; n < 20000; ++n) check(random.between(0, reach), random.between(-reach, reach));
  }

  template <class Real>
  Spring<Real> spring(double rho, double z) const {
    return head().visit_springs<Real>(
        [&](const auto& springs) -> Spring<Real> { return springs.spring(Real(rho), Real(z)); });
  }
  double margin(double rho, double z) const {
    return head().visit_springs<double>([&](const auto& springs) -> double { return springs.margin(rho, z); });
  }
};

TEST_P(HeadContract, DepthIsAtMostTheReach) {
  for_points([&](double rho, double z) { ASSERT_LE(spring<double>(rho, z).depth, head().reach()); });
}

TEST_P(HeadContract, DirectionIsAUnitVectorWhereThereIsASpring) {
  for_points([&](double rho, double z) {
    const Spring<double> s = spring<double>(rho, z);
    if (s.depth > 0) {
      ASSERT_NEAR(std::hypot(s.n_radial, s.n_axial), 1, 1e-12);
    }
  });
}

TEST_P(HeadContract, NoSpringReachesOutOfTheBox) {
  const HeadBox box = head().bounding_box();
  for_points([&](double rho, double z) {
    if (rho > box.max.x() || z < box.min.z() || z > box.max.z()) {
      ASSERT_LE(spring<double>(rho, z).depth, 0) << rho << " " << z;
    }
  });
}

TEST_P(HeadContract, SpringAndMarginAgreeOnWhatIsInside) {
  for_points([&](double rho, double z) {
    const double m = margin(rho, z);
    if (std::abs(m) > 1e-12) {
      ASSERT_EQ(m > 0, spring<double>(rho, z).depth > 0) << rho << " " << z;
    }
  });
}

// The hot loop is in single precision: its depth is that of double precision up to the rounding of coordinates as large
// as the head, a few units in the last place of the reach.
TEST_P(HeadContract, SinglePrecisionGivesTheSameAnswerWithinRounding) {
  const double rounding = 4 * double(std::numeric_limits<float>::epsilon()) * 1.3 * head().reach();
  for_points([&](double rho, double z) {
    const Spring<double> exact = spring<double>(rho, z);
    const Spring<float> fast = spring<float>(rho, z);
    if (std::abs(margin(rho, z)) < rounding) return;  // on the surface either answer is right
    ASSERT_EQ(exact.depth > 0, fast.depth > 0);
    if (exact.depth <= 0) return;
    ASSERT_NEAR(double(fast.depth), exact.depth, rounding);
    if (exact.depth < 100 * rounding || std::hypot(rho, z) < 100 * rounding) return;   // directions need a length
    const bool on_the_ridge = std::abs(exact.n_radial - double(fast.n_radial)) > 0.5;  // of a flat's `nearest`
    if (on_the_ridge) {
      ASSERT_NEAR(exact.depth, head().largest_radius() - rho, rounding);
      ASSERT_NEAR(exact.depth, z, rounding);
      return;
    }
    ASSERT_NEAR(double(fast.n_radial), exact.n_radial, 0.02);
    ASSERT_NEAR(double(fast.n_axial), exact.n_axial, 0.02);
  });
}

TEST_P(HeadContract, TheVectorAtAPointLiesInItsMeridianPlane) {
  RandomPoses random(10);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = random.vector(head().reach());
    const auto at = head().depth_at(p);
    if (!(at.depth > 0)) continue;
    ASSERT_NEAR(at.direction.cross(p).z(), 0, 1e-12 * head().reach());
    ASSERT_GE(at.direction.head<2>().dot(p.head<2>()), -1e-15) << "springs push away from the axis";
  }
}

TEST_P(HeadContract, NoBlockIsSkippedThatHoldsAPointOfTheHead) {
  RandomPoses random(11);
  int skipped = 0, touched = 0;
  for (int n = 0; n < 400; ++n) {
    const double size = random.between(0.02, 0.2) * mm;
    const Pose X_TV = {random.rotation(), random.vector(1.5 * head().reach())};
    const GridInHead grid(X_TV, size);
    const VoxelIndex origin = {0, 0, 0};
    const bool may =
        head().visit_springs<float>([&](const auto& springs) { return may_touch(springs, grid, origin, float(size)); });
    bool does = false;
    for (int v = 0; v < kBlockVoxels; ++v)
      does |= head().depth_at(grid.position({v >> 6, v >> 3 & 7, v & 7})).depth > 0;
    ASSERT_TRUE(may || !does);
    skipped += !may;
    touched += does;
  }
  EXPECT_GT(skipped, 0);
  EXPECT_GT(touched, 0);
}

INSTANTIATE_TEST_SUITE_P(Heads, HeadContract,
                         testing::Values(NamedHead{"Ball", SphereHead{1 * mm}},
                                         NamedHead{"SlenderCone", ConeHead{12 * deg, 3 * mm}},
                                         NamedHead{"BluntCone", ConeHead{70 * deg, 1 * mm}},
                                         NamedHead{"FlatNearest", FlatHead{0.8 * mm, 2 * mm}},
                                         NamedHead{"FlatBottomOnly", FlatHead{0.8 * mm, 2 * mm, FlatRule::bottom_only}},
                                         NamedHead{"FlatSideOnly", FlatHead{0.8 * mm, 2 * mm, FlatRule::side_only}},
                                         NamedHead{"FlatBoth", FlatHead{0.8 * mm, 2 * mm, FlatRule::both}},
                                         NamedHead{"FlatDisc", FlatHead{2 * mm, 0.4 * mm}}),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace hapticut
