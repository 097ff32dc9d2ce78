// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/profile.hpp"

#include <gtest/gtest.h>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/head.hpp"
#include "support/catalogue_heads.hpp"
#include "support/profiles.hpp"
#include "support/springs.hpp"

namespace hapticut::profile_test {
namespace {

using test::margin_at;
using test::NamedProfile;
using test::spring_at;
using units::deg;
using units::kPi;
using units::mm;

constexpr EdgeKind kSmooth = EdgeKind::smooth;

/// Calls `check(rho, z)` at random points in and around a head.
template <class Check>
void for_points(const ToolHead& head, int count, Check&& check) {
  test::RandomPoses random(5);
  const HeadBox box = head.bounding_box();
  const double slack = 0.05 * head.reach();
  for (int n = 0; n < count; ++n)
    check(random.between(0, box.max.x() + slack), random.between(box.min.z() - slack, box.max.z() + slack));
}

// --- the analytic heads are profiles too ---------------------------------------------------------------------------

struct Twins {
  const char* name;
  ToolHead analytic;
  Profile profile;
};

void PrintTo(const Twins& twins, std::ostream* out) { *out << twins.name; }

class ProfileOfAnAnalyticHead : public testing::TestWithParam<Twins> {};

// The closed forms and the curves of the table round differently, in double precision and at points of some
// millimetres.
constexpr double kRounding = 1e-12;

TEST_P(ProfileOfAnAnalyticHead, GivesTheSameDepthsAndDirections) {
  const ToolHead profile = ProfileHead(GetParam().profile);
  int inside = 0;
  for_points(profile, 100000, [&](double rho, double z) {
    const MeridianSpring<double> a = spring_at(GetParam().analytic, rho, z), p = spring_at(profile, rho, z);
    if (std::abs(margin_at(GetParam().analytic, rho, z)) < kRounding * mm) return;
    ASSERT_EQ(a.depth > 0, p.depth > 0) << rho << " " << z;
    if (a.depth <= 0) return;
    ++inside;
    ASSERT_NEAR(p.depth, a.depth, kRounding * mm);
    ASSERT_NEAR(p.smooth / (mm * mm), a.smooth / (mm * mm), kRounding);
    if (std::hypot(rho, z) < 1e-3 * mm) return;  // the centre of a ball has no direction
    ASSERT_NEAR(p.n_radial, a.n_radial, 1e-9);
    ASSERT_NEAR(p.n_axial, a.n_axial, 1e-9);
  });
  EXPECT_GT(inside, 10000);
}

TEST_P(ProfileOfAnAnalyticHead, HasTheSameMarginBoxReachAndVolume) {
  const ToolHead profile = ProfileHead(GetParam().profile);
  const ToolHead& analytic = GetParam().analytic;
  EXPECT_LT((profile.bounding_box().min - analytic.bounding_box().min).norm(), kRounding * mm);
  EXPECT_LT((profile.bounding_box().max - analytic.bounding_box().max).norm(), kRounding * mm);
  EXPECT_NEAR(profile.reach() / analytic.reach(), 1, kRounding);
  EXPECT_NEAR(profile.volume() / analytic.volume(), 1, kRounding);
  EXPECT_NEAR(profile.max_radius() / analytic.max_radius(), 1, kRounding);
  // Inside, the analytic margin is the exact distance; outside, it is a bound on the distance.
  for_points(profile, 20000, [&](double rho, double z) {
    const double exact = margin_at(profile, rho, z), bound = margin_at(analytic, rho, z);
    ASSERT_LE(exact, bound + kRounding * mm);
    ASSERT_TRUE(bound <= 0 || exact >= bound - kRounding * mm);
  });
}

INSTANTIATE_TEST_SUITE_P(
    Heads, ProfileOfAnAnalyticHead,
    testing::Values(Twins{"Ball", SphereHead{0.9 * mm}, test::ball_profile(0.9 * mm)},
                    Twins{"Flat", FlatHead{0.8 * mm, 2 * mm}, test::flat_profile(0.8 * mm, 2 * mm)},
                    Twins{"Disc", FlatHead{2 * mm, 0.4 * mm}, test::flat_profile(2 * mm, 0.4 * mm)},
                    Twins{"SlenderCone", ConeHead{12 * deg, 3 * mm}, test::cone_profile(12 * deg, 3 * mm)},
                    Twins{"BluntCone", ConeHead{70 * deg, 1 * mm}, test::cone_profile(70 * deg, 1 * mm)}),
    [](const auto& twins) { return std::string(twins.param.name); });

TEST(ProfileHead, WithSmoothSidesOrASmoothBottomHasTheDepthOfTheCuttingSurfaceUntilTheSmoothOneIsNearer) {
  constexpr double kR = 0.8 * mm, kTop = 2 * mm;
  for (const bool bottom_cuts : {true, false}) {
    const EdgeKind bottom = bottom_cuts ? EdgeKind::cutting : kSmooth, side = bottom_cuts ? kSmooth : EdgeKind::cutting;
    const ToolHead profile = ProfileHead({0, {{kR, 0, 0, bottom}, {kR, kTop, 0, side}, {0, kTop, 0, kSmooth}}});
    for_points(profile, 20000, [&](double rho, double z) {
      const double from_cutting = bottom_cuts ? z : kR - rho, from_smooth = bottom_cuts ? kR - rho : z;
      const double smooth = kSmoothScale * std::min(from_smooth, kTop - z);
      const MeridianSpring<double> s = spring_at(profile, rho, z);
      ASSERT_NEAR(std::max(0.0, s.depth), std::max(0.0, std::min(from_cutting, smooth)), kRounding * mm);
      if (s.depth <= 0) return;
      ASSERT_EQ(s.on_smooth(), smooth < from_cutting);
      const bool side_is_next = kSmoothScale * from_smooth < std::min(z, kSmoothScale * (kTop - z));
      ASSERT_TRUE(!bottom_cuts || std::abs(s.n_radial - (side_is_next ? 1 : 0)) <= kRounding);
      if (!s.on_smooth()) return;
      const double corner = std::hypot(kR - rho, bottom_cuts ? z : std::min(z, kTop - z));
      ASSERT_NEAR(std::sqrt(s.smooth), corner, kRounding * mm);
    });
  }
}

// --- any profile ---------------------------------------------------------------------------------------------------

class AnyProfile : public testing::TestWithParam<NamedProfile> {};

TEST_P(AnyProfile, TableIsWithinItsBoundAndItsBoundWithinTheTolerance) {
  for (const double tolerance : {0.03, 0.01, 0.003}) {
    const ProfileHead head(GetParam().profile, tolerance);
    const ProfileTable& table = head.table();
    ASSERT_LE(table.error, tolerance * std::min(table.radius, table.top - table.bottom));
    const ProfileSprings<double> springs(table);
    const double rounding = 1e-6 * mm;  // error by the circle that represents a hollow corner
    double sum = 0;
    constexpr int kPoints = 200000;
    for_points(head, kPoints, [&](double rho, double z) {
      const double exact = std::max(0.0, head.exact_spring(rho, z).depth);
      const double depth = std::max(0.0, springs.spring(rho, z).depth);
      const bool within = std::abs(depth - exact) <= table.error + rounding;
      ASSERT_TRUE(within || std::abs(springs.margin(rho, z)) <= table.error) << rho << " " << z << " " << depth - exact;
      sum += std::abs(depth - exact);
    });
    // Few cells have an error at all.
    EXPECT_LT(sum / kPoints, 1e-4 * table.radius);
  }
}

TEST_P(AnyProfile, DirectionIsMinusTheGradientOfTheDepth) {
  const ProfileHead head(GetParam().profile);
  const double step = 1e-7 * mm;
  int checked = 0, off = 0;
  for_points(head, 20000, [&](double rho, double z) {
    const MeridianSpring<double> s = spring_at(head, rho, z);
    if (s.depth <= 2 * step) return;
    const double d_rho = (spring_at(head, rho + step, z).depth - spring_at(head, rho - step, z).depth) / (2 * step);
    const double d_z = (spring_at(head, rho, z + step).depth - spring_at(head, rho, z - step).depth) / (2 * step);
    ++checked;
    // On a ridge or at the edge of a cell, the direction differs from the gradient.
    off += std::hypot(d_rho + s.scale() * s.n_radial, d_z + s.scale() * s.n_axial) > 1e-4;
  });
  EXPECT_GT(checked, 1000);
  EXPECT_LT(off, 0.002 * checked);
}

INSTANTIATE_TEST_SUITE_P(Profiles, AnyProfile, testing::ValuesIn(test::all_profiles()),
                         [](const auto& p) { return p.param.name; });

/// Points along a meridian, directly from its definition: edges are straight, or arcs of a radius to the left.
std::vector<Eigen::Vector2d> points_of(const Profile& profile, double spacing) {
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d from(0, profile.tip);
  for (const ProfileEdge& e : profile.edges) {
    const Eigen::Vector2d to(e.rho, e.z), chord = to - from;
    const int count = 2 + int(2 * chord.norm() / spacing);
    for (int n = 0; n <= count; ++n) {
      const double part = double(n) / count;
      Eigen::Vector2d p = from + part * chord;
      if (e.radius != 0) {
        const Eigen::Vector2d left = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
        const double half = chord.norm() / 2, R = std::abs(e.radius);
        const double bend = std::sqrt(std::max(0.0, R * R - half * half));
        const Eigen::Vector2d center = (from + to) / 2 + (e.radius > 0 ? bend : -bend) * left;
        const double angle = 2 * std::asin(std::min(1.0, half / R)) * part * (e.radius > 0 ? 1 : -1);
        p = center + Eigen::Rotation2Dd(angle) * (from - center);
      }
      points.push_back(p);
    }
    from = to;
  }
  return points;
}

class ClosedProfile : public testing::TestWithParam<NamedProfile> {};

TEST_P(ClosedProfile, DepthIsTheDistanceToTheNearestPointOfTheSurface) {
  const ToolHead head = ProfileHead(GetParam().profile, 0.002);
  const double spacing = 0.002 * mm;
  const std::vector<Eigen::Vector2d> surface = points_of(GetParam().profile, spacing);
  int inside = 0;
  for_points(head, 3000, [&](double rho, double z) {
    double nearest = 1;
    for (const Eigen::Vector2d& p : surface) nearest = std::min(nearest, (p - Eigen::Vector2d(rho, z)).norm());
    const MeridianSpring<double> s = spring_at(head, rho, z);
    const double error = 0.002 * mm;  // error of the table
    ASSERT_NEAR(std::abs(margin_at(head, rho, z)), nearest, spacing);
    if (s.depth <= 0) return;
    ++inside;
    ASSERT_NEAR(s.depth, nearest, spacing + error);
  });
  EXPECT_GT(inside, 500);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ClosedProfile, testing::ValuesIn(test::closed_profiles()),
                         [](const auto& p) { return p.param.name; });

class SmoothProfile : public testing::TestWithParam<NamedProfile> {};

TEST_P(SmoothProfile, DepthIsTheLesserOfTheDistancesFromTheTwoSurfaces) {
  const Profile& profile = GetParam().profile;
  const ToolHead head = ProfileHead(profile, 0.002);
  const double spacing = 0.002 * mm;
  // The points of each edge come from a profile that contains only this edge.
  std::vector<Eigen::Vector2d> cutting, smooth;
  for (std::size_t i = 0; i < profile.edges.size(); ++i) {
    const Profile begun = {profile.tip, {profile.edges.begin(), profile.edges.begin() + int(i) + 1}};
    const Profile before = {profile.tip, {profile.edges.begin(), profile.edges.begin() + int(i)}};
    const std::vector<Eigen::Vector2d> points = points_of(begun, spacing);
    auto& of_kind = profile.edges[i].kind == kSmooth ? smooth : cutting;
    of_kind.insert(of_kind.end(), points.begin() + int(points_of(before, spacing).size()), points.end());
  }
  const auto distance = [](const std::vector<Eigen::Vector2d>& surface, double rho, double z) {
    double nearest = 1;
    for (const Eigen::Vector2d& p : surface) nearest = std::min(nearest, (p - Eigen::Vector2d(rho, z)).norm());
    return nearest;
  };
  int inside = 0, on_smooth = 0;
  for_points(head, 3000, [&](double rho, double z) {
    const MeridianSpring<double> s = spring_at(head, rho, z);
    if (s.depth <= 0) return;
    const double expected = std::min(distance(cutting, rho, z), kSmoothScale * distance(smooth, rho, z));
    ++inside;
    on_smooth += s.on_smooth();
    // The head extends the line of a straight cutting edge, and this line is slightly nearer than the end of the edge.
    const double nearer = GetParam().name == "SafeTip" ? 0.1 * mm : 0;
    ASSERT_LT(s.depth, expected + kSmoothScale * spacing + 0.003 * mm) << rho << " " << z;
    ASSERT_GT(s.depth, expected - nearer - kSmoothScale * spacing - 0.003 * mm) << rho << " " << z;
  });
  EXPECT_GT(inside, 500);
  EXPECT_GT(on_smooth, 10);
}

INSTANTIATE_TEST_SUITE_P(Profiles, SmoothProfile, testing::ValuesIn(test::profiles_with_smooth_edges()),
                         [](const auto& p) { return p.param.name; });

TEST(ProfileHead, ASmoothPointCutsTheSideOffExactly) {
  // The slope passes through sample points of the table.
  const ProfileHead head({0, {{1 * mm, 0.6 * mm, 0, kSmooth}, {1 * mm, 5 * mm}, {0, 5 * mm, 0, kSmooth}}});
  EXPECT_NE(head.table().everywhere, 0U);
  for_points(head, 20000, [&](double rho, double z) {
    const double point = (z - 0.6 * rho) / std::hypot(1, 0.6), top = 5 * mm - z;
    const double expected = std::max(0.0, std::min({1 * mm - rho, kSmoothScale * point, kSmoothScale * top}));
    ASSERT_NEAR(std::max(0.0, spring_at(head, rho, z).depth), expected, kRounding * mm) << rho << " " << z;
  });
}

TEST(ProfileHead, VolumeIsThatOfPappusBodies) {
  // A torus of a half circle bulging out of a cylinder: 2 pi R A(centroid) and the cylinder.
  const double R = 1 * mm, r = 0.2 * mm;
  const ProfileHead head({0, {{R, 0}, {R, 2 * r, r}, {0, 2 * r, 0, kSmooth}}});
  const double half_disc = kPi * r * r / 2, centroid = 4 * r / (3 * kPi);
  EXPECT_NEAR(head.volume() / (kPi * R * R * 2 * r + 2 * kPi * (R + centroid) * half_disc), 1, 1e-12);
  EXPECT_NEAR(head.table().radius / (R + r), 1, 1e-12);

  const ProfileHead grooved({0, {{R, 0}, {R, r}, {R, 3 * r, -r}, {R, 4 * r}, {0, 4 * r, 0, kSmooth}}});
  EXPECT_NEAR(grooved.volume() / (kPi * R * R * 4 * r - 2 * kPi * (R - centroid) * half_disc), 1, 1e-12);
}

TEST_P(AnyProfile, SlabsHoldTheHeadAndLittleMore) {
  const ProfileHead head(GetParam().profile);
  const ProfileTable& t = head.table();
  const ProfileSprings<double> springs(t);
  const double height = (t.top - t.bottom) / ProfileTable::kSlabs;
  std::array<double, ProfileTable::kSlabs> max_rho = {};
  for_points(head, 200000, [&](double rho, double z) {
    if (springs.margin(rho, z) <= 0) return;
    const std::size_t slab = std::min<std::size_t>(std::size_t((z - t.bottom) / height), ProfileTable::kSlabs - 1);
    max_rho[slab] = std::max(max_rho[slab], rho);
    ASSERT_LT(rho * rho, t.slab_radius_squared[slab]);
  });
  for (std::size_t slab = 0; slab < ProfileTable::kSlabs; ++slab)
    EXPECT_NEAR(std::sqrt(double(t.slab_radius_squared[slab])), max_rho[slab], t.error + 0.03 * t.radius) << slab;
}

TEST(ProfileHead, TheRuleForEverywhereIsRightEverywhere) {
  std::vector<Profile> profiles;
  for (const NamedProfile& p : test::all_profiles()) profiles.push_back(p.profile);
  for (const test::CatalogueHead& head : test::catalogue_heads()) profiles.push_back(head.make().profile());
  int with_rule = 0;
  for (const Profile& profile : profiles) {
    const ProfileHead head(profile);
    const ProfileTable& table = head.table();
    if (table.everywhere == 0) continue;
    ++with_rule;
    const ProfileSprings<double> springs(table);
    for_points(head, 50000, [&](double rho, double z) {
      if (!(rho < table.radius && z > table.bottom && z < table.top)) return;
      if (std::abs(springs.margin(rho, z)) < kRounding * mm) return;
      const MeridianSpring<double> got = springs.decide(table.everywhere, rho, z).spring;
      const MeridianSpring<double> want = head.exact_spring(rho, z);
      // The table represents a corner by a circle.
      ASSERT_NEAR(std::max(0.0, got.depth), std::max(0.0, want.depth), 2e-7 * head.reach()) << rho << " " << z;
    });
  }
  EXPECT_GE(with_rule, 13);
}

TEST(ProfileHead, WhichHeadsNeedNoTable) {
  std::string need_one;
  for (const test::CatalogueHead& head : test::catalogue_heads())
    if (ProfileHead(head.make().profile()).table().everywhere == 0) need_one += head.name + " ";
  EXPECT_EQ(need_one, "wheel christmas_tree ");

  const auto rule_of = [](const Profile& profile) { return ProfileHead(profile).table().everywhere; };
  const auto expect_rule = [&](CellRule rule, const Profile& profile) {
    EXPECT_NE(rule_of(profile), 0U);
    EXPECT_EQ(ProfileCell::rule(rule_of(profile)), rule);
  };
  const Profile two_arcs_of_a_ball = {-1 * mm, {{1 * mm, 0, 1 * mm}, {0, 1 * mm, 1 * mm}}};
  expect_rule(CellRule::first, two_arcs_of_a_ball);
  expect_rule(CellRule::nearer, test::flat_profile(1 * mm, 2 * mm));
  expect_rule(CellRule::sides, pear_head(1.4 * mm, 2.6 * mm, 0.8 * mm).profile());
  // The chamfer at the rim is smaller than the distance between the samples of a cell.
  EXPECT_EQ(rule_of({0, {{0.992 * mm, 0}, {1 * mm, 0.008 * mm}, {1 * mm, 2 * mm}, {0, 2 * mm, 0, kSmooth}}}), 0U);
}

TEST(ProfileHead, CopiesShareOneTable) {
  const ToolHead head = ProfileHead(test::ball_profile(1 * mm));
  const ToolHead copy = head;  // NOLINT(performance-unnecessary-copy-initialization): the copy is what is tested
  EXPECT_EQ(&std::get<ProfileHead>(head.shape()).table(), &std::get<ProfileHead>(copy.shape()).table());
}

}  // namespace
}  // namespace hapticut::profile_test
