// SPDX-License-Identifier: Apache-2.0
// Contract of every head, on which the step relies.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/contact/contact.hpp"
#include "hapticut/core/units.hpp"
#include "support/catalogue_heads.hpp"
#include "support/profiles.hpp"
#include "support/springs.hpp"
#include "support/usual_heads.hpp"

namespace hapticut::head_contract_test {
namespace {

using test::RandomPoses;
using units::deg;
using units::mm;

/// A head, made on demand, because heads from profiles take time to make.
struct NamedHead {
  std::string name;
  std::function<ToolHead()> make;
  bool springs_push_out = true;  ///< false: the head has hollows whose walls face the axis
};

NamedHead profile(const test::NamedProfile& p) {
  return {"Profile" + p.name, [p] { return ToolHead(ProfileHead(p.profile)); }, p.name != "Hollow"};
}

std::vector<NamedHead> heads() {
  const auto of = [](const auto& shape) { return [shape] { return ToolHead(shape); }; };
  std::vector<NamedHead> all = {{"SlenderCone", of(ConeHead{12 * deg, 3 * mm})},
                                {"BluntCone", of(ConeHead{70 * deg, 1 * mm})},
                                {"FlatNearest", of(FlatHead{0.8 * mm, 2 * mm})},
                                {"FlatBottomOnly", of(FlatHead{0.8 * mm, 2 * mm, FlatRule::bottom_only})},
                                {"FlatSideOnly", of(FlatHead{0.8 * mm, 2 * mm, FlatRule::side_only})},
                                {"FlatBoth", of(FlatHead{0.8 * mm, 2 * mm, FlatRule::both})},
                                {"FlatDisc", of(FlatHead{2 * mm, 0.4 * mm})}};
  for (const ToolHead& head : test::usual_heads()) all.push_back({"Usual_" + test::word_of(head), of(head)});
  for (const auto& p : test::closed_profiles()) all.push_back(profile(p));
  for (const auto& p : test::profiles_with_smooth_edges()) all.push_back(profile(p));
  for (const test::CatalogueHead& head : test::catalogue_heads()) all.push_back({"Catalogue_" + head.name, head.make});
  return all;
}

void PrintTo(const NamedHead& named, std::ostream* out) { *out << named.name; }

class HeadContract : public testing::TestWithParam<NamedHead> {
 protected:
  const ToolHead& head() const { return head_; }

  /// Calls `check(rho, z)` for many points in and around the head.
  template <class Check>
  void for_points(Check&& check) {
    RandomPoses random(9);
    const double reach = 1.3 * head().reach();
    for (int n = 0; n < 20000; ++n) check(random.between(0, reach), random.between(-reach, reach));
  }

  /// Whether the exact head has this direction at a point or next to it. On a ridge between two surfaces, rounding
  /// decides which surface gives the direction.
  bool is_direction_near(const MeridianSpring<float>& fast, double rho, double z, double step) const {
    for (int n = 0; n < 9; ++n) {
      const MeridianSpring<double> s = spring<double>(rho + (n % 3 - 1) * step, z + (n / 3 - 1) * step);
      if (std::hypot(s.n_radial - double(fast.n_radial), s.n_axial - double(fast.n_axial)) < 0.02) return true;
    }
    return false;
  }
  /// [m] Distance from the surface beyond which inside and outside can be distinguished.
  double surface_error() const {
    const auto* profile = std::get_if<ProfileHead>(&head().shape());
    return profile == nullptr ? 1e-12 : 1e-12 + profile->table().error;
  }
  template <class Real>
  MeridianSpring<Real> spring(double rho, double z) const {
    return test::spring_at<Real>(head(), rho, z);
  }
  double margin(double rho, double z) const { return test::margin_at(head(), rho, z); }

 private:
  ToolHead head_ = GetParam().make();
};

TEST_P(HeadContract, DepthIsAtMostTheReach) {
  for_points([&](double rho, double z) { ASSERT_LE(spring<double>(rho, z).depth, head().reach()); });
}

TEST_P(HeadContract, DirectionIsAUnitVectorWhereThereIsASpring) {
  for_points([&](double rho, double z) {
    const MeridianSpring<double> s = spring<double>(rho, z);
    if (s.depth > 0) {
      ASSERT_NEAR(std::hypot(s.n_radial, s.n_axial), 1, 1e-12);
    }
  });
}

TEST_P(HeadContract, DepthIsZeroAllOverItsSurfaceSoThatForcesMakeNoEnergy) {
  const auto* flat = std::get_if<FlatHead>(&head().shape());
  if (flat != nullptr && flat->rule != FlatRule::nearest) GTEST_SKIP() << "these rules are not conservative";
  for_points([&](double rho, double z) {
    const double m = margin(rho, z);
    if (m <= 0) return;
    ASSERT_LE(spring<double>(rho, z).depth, kSmoothScale * m + surface_error()) << rho << " " << z;
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
    if (std::abs(m) <= surface_error()) return;
    if (spring<double>(rho, z).depth > 0) {
      ASSERT_GT(m, 0) << rho << " " << z;
    } else {
      ASSERT_LT(m, 0) << rho << " " << z;
    }
  });
}

// The hot loop uses single precision. Its depth equals that of double precision up to the rounding of coordinates of
// the size of the head: a few units in the last place of the reach.
TEST_P(HeadContract, SinglePrecisionGivesTheSameAnswerWithinRounding) {
  const double rounding = 4 * kSmoothScale * double(std::numeric_limits<float>::epsilon()) * 1.3 * head().reach();
  for_points([&](double rho, double z) {
    const MeridianSpring<double> exact = spring<double>(rho, z);
    const MeridianSpring<float> fast = spring<float>(rho, z);
    if (std::abs(margin(rho, z)) < rounding + surface_error()) return;  // on the surface both results are right
    ASSERT_EQ(exact.depth > 0, fast.depth > 0);
    if (exact.depth <= 0) return;
    ASSERT_NEAR(double(fast.depth), exact.depth, rounding);
    if (exact.depth < 100 * rounding || std::hypot(rho, z) < 100 * rounding) return;  // directions need a length
    ASSERT_TRUE(is_direction_near(fast, rho, z, rounding)) << rho << " " << z;
  });
}

TEST_P(HeadContract, TheVectorAtAPointLiesInItsMeridianPlane) {
  RandomPoses random(10);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = random.vector(head().reach());
    const auto at = head().spring_at(p);
    if (!(at.depth > 0)) continue;
    ASSERT_NEAR(at.direction.cross(p).z(), 0, 1e-12 * head().reach());
    if (GetParam().springs_push_out) {
      ASSERT_GE(at.direction.head<2>().dot(p.head<2>()), -1e-15) << "springs push away from the axis";
    }
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
    for (int v = 0; v < kBlockVoxels; ++v) does |= head().spring_at(grid.position(place_in_block(v))).depth > 0;
    ASSERT_TRUE(may || !does);
    skipped += !may;
    touched += does;
  }
  EXPECT_GT(skipped, 0);
  EXPECT_GT(touched, 0);
}

INSTANTIATE_TEST_SUITE_P(Heads, HeadContract, testing::ValuesIn(heads()),
                         [](const auto& named) { return named.param.name; });

}  // namespace
}  // namespace hapticut::head_contract_test
