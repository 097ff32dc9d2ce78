// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/shank.hpp"

#include <gtest/gtest.h>

#include "hapticut/tool/catalogue.hpp"
#include "support/catalogue_heads.hpp"
#include "support/refusal.hpp"
#include "support/springs.hpp"

namespace hapticut::shank_test {
namespace {

using test::CatalogueHead;
using test::margin_at;
using units::kPi;
using units::mm;

class OnShank : public testing::TestWithParam<CatalogueHead> {};

TEST_P(OnShank, CutsAsTheHeadAloneAndReachesToTheEndOfTheShank) {
  const ToolHead head = GetParam().make();
  const double neck = 0.5 * mm, begin = head.bounding_box().min.z(), end = head.bounding_box().max.z();
  const ToolHead bur = on_shank(head, standard_shank(ShankKind::friction_grip, neck));
  EXPECT_NEAR(bur.bounding_box().max.z(), begin + 19 * mm, 1e-12);
  EXPECT_NEAR(bur.bounding_box().min.z(), begin, 1e-12);
  EXPECT_NEAR(bur.max_radius(), std::max(head.max_radius(), 0.8 * mm), 1e-12);
  EXPECT_NEAR(bur.cutting_radius(), head.cutting_radius(), 1e-12);
  // Where the head cuts, the depth is unchanged: the distance below the nearest cutting surface.
  int cutting = 0;
  for (double rho = 0.003 * mm; rho < head.max_radius(); rho += 0.02 * mm)
    for (double z = begin + 0.003 * mm; z < end; z += 0.03 * mm) {
      const bool inside = margin_at(head, rho, z) > 0;
      if (inside) {
        ASSERT_GT(margin_at(bur, rho, z), 0) << rho << " " << z;
      }
      const Spring alone = head.spring_at({rho, 0, z}), held = bur.spring_at({rho, 0, z});
      if (!inside || alone.on_smooth() || held.on_smooth()) continue;
      ++cutting;
      ASSERT_GT(held.depth, alone.depth - 0.02 * mm) << rho << " " << z;
      if (z > (begin + end) / 2) continue;  // above, the neck may have replaced the nearest surface
      ASSERT_LT(held.depth, alone.depth + 0.02 * mm) << rho << " " << z;
    }
  EXPECT_GT(cutting, 100);
  // Neck, taper and shank.
  const auto expect_radius = [&](double z, double radius) {
    EXPECT_GT(margin_at(bur, radius - 1e-6 * mm, z), 0);
    EXPECT_LT(margin_at(bur, radius + 1e-6 * mm, z), 0);
    const Spring s = bur.spring_at({radius - 0.01 * mm, 0, z});
    EXPECT_TRUE(s.on_smooth());
  };
  expect_radius(end + 1 * mm, neck / 2);
  expect_radius(end + 4 * mm, (neck / 2 + 0.8 * mm) / 2);
  expect_radius(begin + 18 * mm, 0.8 * mm);
}

INSTANTIATE_TEST_SUITE_P(Heads, OnShank, testing::ValuesIn(test::catalogue_heads()),
                         [](const auto& named) { return named.param.name; });

TEST(OnShank, OfAConeAndAFlatHeadLeavesTheBaseAroundTheNeckSmooth) {
  const ToolHead bur = on_shank(cylinder_head(1.2 * mm, 4 * mm), {0.6 * mm, 1 * mm, 0, 0.6 * mm, 10 * mm});
  const Profile profile = bur.profile();
  ASSERT_EQ(profile.edges.size(), 5U);
  EXPECT_EQ(profile.edges[2].kind, EdgeKind::smooth);
  EXPECT_NEAR(profile.edges[2].rho, 0.3 * mm, 1e-15);
  EXPECT_NEAR(bur.volume() / (kPi * (0.36 * 4 + 0.09 * 6) * 1e-9), 1, 1e-9);
}

TEST(OnShank, RefusesWhatDoesNotFit) {
  const ToolHead ball = round_head(0.8 * mm);
  const auto expect = [&](const Shank& shank, const char* words) {
    test::expect_refused([&] { (void)on_shank(ball, shank); }, {words});
  };
  expect({0.9 * mm, 0, 1 * mm, 1.6 * mm, 19 * mm}, "neck_diameter = 0.9 mm; must be less");
  expect({0.5 * mm, 0, 0, 1.6 * mm, 19 * mm}, "taper_length = 0; must be > 0");
  expect({0.5 * mm, 1 * mm, 1 * mm, 1.6 * mm, 2 * mm}, "length = 2 mm; must be more");
  expect({0.5 * mm, -1 * mm, 1 * mm, 1.6 * mm, 9 * mm}, "neck_length");
}

TEST(WithBody, PutsTheNoseOfAHandpieceAroundAShank) {
  const ToolHead bur = on_shank(round_head(1 * mm), standard_shank(ShankKind::latch, 0.6 * mm));
  const Profile nose = {9 * mm, {{3 * mm, 9 * mm}, {5 * mm, 14 * mm}, {5 * mm, 25 * mm}, {0, 25 * mm}}};
  const ToolHead held = with_body(bur, nose);
  EXPECT_NEAR(held.max_radius(), 5 * mm, 1e-12);
  EXPECT_NEAR(held.cutting_radius(), 0.5 * mm, 1e-12);
  EXPECT_NEAR(held.bounding_box().max.z(), 25 * mm, 1e-12);
  const Spring s = held.spring_at({2.9 * mm, 0, 9.05 * mm});
  EXPECT_NEAR(s.depth, kSmoothScale * 0.05 * mm, 1e-9);
  EXPECT_LT((s.direction - Vec3(0, 0, -1)).norm(), 1e-9);
  test::expect_refused([&] { (void)with_body(bur, {30 * mm, {{3 * mm, 30 * mm}, {0, 35 * mm}}}); }, {"does not leave"});
}

}  // namespace
}  // namespace hapticut::shank_test
