// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/head.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "support/profiles.hpp"
#include "support/refusal.hpp"
#include "support/usual_heads.hpp"

namespace hapticut::head_test {
namespace {

using units::deg;
using units::kPi;
using units::mm;

struct Expected {
  const char* name;
  ToolHead head;
  Vec3 min, max;            // [m] corners of the box
  double volume, reach;     // [m^3], [m]
  double rounding = 1e-14;  // [1]
};

void PrintTo(const Expected& e, std::ostream* out) { *out << e.name; }

class Heads : public testing::TestWithParam<Expected> {};

TEST_P(Heads, BoxVolumeReachAndRadiusAreExact) {
  const Expected& e = GetParam();
  EXPECT_LT((e.head.bounding_box().min - e.min).norm(), e.rounding * e.reach);
  EXPECT_LT((e.head.bounding_box().max - e.max).norm(), e.rounding * e.reach);
  EXPECT_NEAR(e.head.volume() / e.volume, 1, e.rounding);
  EXPECT_NEAR(e.head.reach() / e.reach, 1, e.rounding);
  EXPECT_NEAR(e.head.max_radius() / e.max.x(), 1, e.rounding);
  EXPECT_NEAR(e.head.cutting_radius() / ProfileHead(e.head.profile()).cutting_radius(), 1, 1e-12);
}

// The volume is the fraction of random points of the box that have a spring. 4e5 points give it to 0.1 %; four standard
// deviations are 0.4 %. The points with a spring reach the sides of the box to within 2 %.
TEST_P(Heads, SpringsFillTheVolumeAndTouchTheBox) {
  const Expected& e = GetParam();
  test::RandomPoses random(3);
  constexpr int kPoints = 400000;
  int inside = 0;
  const double margin = 0.2 * e.reach;
  Vec3 low = Vec3::Constant(1), high = Vec3::Constant(-1);
  double farthest = 0;
  const Vec3 edges = e.max - e.min + Vec3::Constant(2 * margin);
  for (int n = 0; n < kPoints; ++n) {
    const Vec3 p = e.min - Vec3::Constant(margin) +
                   edges.cwiseProduct(Vec3(random.between(0, 1), random.between(0, 1), random.between(0, 1)));
    if (!(e.head.spring_at(p).depth > 0)) continue;
    ++inside;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    farthest = std::max(farthest, p.norm());
  }
  const double fraction = double(inside) / kPoints;
  const double deviation = std::sqrt((1 - fraction) / (fraction * kPoints));
  EXPECT_NEAR(fraction * edges.prod() / e.volume, 1, 4 * deviation);
  EXPECT_TRUE((low.array() >= e.min.array()).all() && (high.array() <= e.max.array()).all());
  EXPECT_LT((low - e.min).maxCoeff(), 0.05 * e.reach);
  EXPECT_LT((e.max - high).maxCoeff(), 0.05 * e.reach);
  EXPECT_LE(farthest, e.reach);
  EXPECT_GT(farthest, 0.95 * e.reach);
}

const double kTan30 = std::tan(30 * deg);
INSTANTIATE_TEST_SUITE_P(
    Shapes, Heads,
    testing::Values(Expected{"Ball", SphereHead{1.5 * mm}, Vec3(-1.5, -1.5, -1.5) * mm, Vec3(1.5, 1.5, 1.5) * mm,
                             4 * kPi / 3 * 3.375e-9, 1.5 * mm},
                    Expected{"Cone", ConeHead{30 * deg, 3 * mm}, Vec3(-3 * kTan30, -3 * kTan30, 0) * mm,
                             Vec3(3 * kTan30, 3 * kTan30, 3) * mm, kPi / 3 * 9 * kTan30* kTan30 * 3 * 1e-9,
                             3 * mm / std::cos(30 * deg)},
                    Expected{"Flat", FlatHead{1 * mm, 2 * mm}, Vec3(-1, -1, 0) * mm, Vec3(1, 1, 2) * mm, 2 * kPi * 1e-9,
                             std::sqrt(5.0) * mm},
                    Expected{"FlatBoth", FlatHead{2 * mm, 1 * mm, FlatRule::both}, Vec3(-2, -2, 0) * mm,
                             Vec3(2, 2, 1) * mm, 4 * kPi * 1e-9, std::sqrt(5.0) * mm},
                    // cylinder 0.5 x 1.2 mm and ball of 0.5 mm
                    Expected{"Capsule", ProfileHead(test::closed_profiles()[1].profile), Vec3(-0.5, -0.5, 0) * mm,
                             Vec3(0.5, 0.5, 2.2) * mm, kPi*(0.3 + 0.5 / 3) * 1e-9, 2.2 * mm},
                    // frusta of a tree
                    Expected{"Tree", ProfileHead(test::closed_profiles()[3].profile), Vec3(-0.8, -0.8, 0) * mm,
                             Vec3(0.8, 0.8, 2) * mm,
                             kPi / 3 * 1e-9 *
                                 (0.7 * 0.16 + 0.1 * (0.16 + 0.1 + 0.0625) + 0.5 * (0.0625 + 0.15 + 0.36) +
                                  0.1 * (0.36 + 0.27 + 0.2025) + 0.5 * (0.2025 + 0.36 + 0.64) + 0.1 * 0.64),
                             std::hypot(0.8, 1.9) * mm}),
    [](const auto& e) { return std::string(e.param.name); });

/// Each shape, with the numbers of the profile that has its edges.
std::vector<Expected> usual_heads() {
  std::vector<Expected> heads;
  for (const ToolHead& head : test::usual_heads()) {
    const ToolHead twin(ProfileHead(head.profile()));
    const HeadBox box = twin.bounding_box();
    heads.push_back({"", head, box.min, box.max, twin.volume(), twin.reach(), 1e-12});
  }
  return heads;
}

INSTANTIATE_TEST_SUITE_P(Usual, Heads, testing::ValuesIn(usual_heads()),
                         [](const auto& e) { return test::word_of(e.param.head); });

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ToolHead, RefusesDimensionsThatAreNotPositiveOrFinite) {
  for_each_shape([]<class Shape>(Of<Shape>) {
    if constexpr (Described<Shape>)
      for_each_number<Shape>([]<class T>(const Field<Shape, T>& field) {
        for (const double bad : {0.0, -1e-3, kNan, kInfinity}) {
          if (!std::is_same_v<T, double> || field.range.contains(bad)) continue;
          Shape shape = Shape::usual();
          shape.*field.member = T(bad);
          EXPECT_THROW((void)ToolHead(shape), Error) << Shape::kName << "::" << field.name << " = " << bad;
        }
      });
  });
  EXPECT_THROW(ToolHead(ConeHead{kPi / 2, 1 * mm}), Error);
  test::expect_refused([] { (void)ToolHead(SphereHead{-0.5}); }, {"SphereHead::radius", "-0.5"});
}

}  // namespace
}  // namespace hapticut::head_test
