// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/head_outline.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "support/catalogue_heads.hpp"
#include "support/profiles.hpp"
#include "support/usual_heads.hpp"

namespace hapticut::head_outline_test {
namespace {

using units::deg;
using units::mm;

struct NamedHead {
  std::string name;
  ToolHead head;
};

void PrintTo(const NamedHead& named, std::ostream* out) { *out << named.name; }

std::vector<NamedHead> all_heads() {
  std::vector<NamedHead> heads = {{"FlatThatCutsWithItsSide", FlatHead{0.7 * mm, 2 * mm, FlatRule::side_only}}};
  for (const ToolHead& head : test::usual_heads()) heads.push_back({"Usual_" + test::word_of(head), head});
  for (const test::NamedProfile& named : test::closed_profiles())
    heads.push_back({named.name, ProfileHead(named.profile)});
  for (const test::CatalogueHead& named : test::catalogue_heads()) heads.push_back({named.name, named.make()});
  return heads;
}

constexpr int kPoints = 2000;  // number on an edge

/// Points of the meridian, close to each other.
std::vector<Eigen::Vector2d> points_of(const Profile& profile) {
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d from(0, profile.tip);
  for (const ProfileEdge& edge : profile.edges) {
    const Eigen::Vector2d to(edge.rho, edge.z), chord = to - from;
    const Eigen::Vector2d left = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    const double radius = std::abs(edge.radius), half = chord.norm() / 2;
    const double to_center = radius > 0 ? std::sqrt(std::max(0.0, radius * radius - half * half)) : 0;
    const Eigen::Vector2d center = (from + to) / 2 + (edge.radius > 0 ? 1 : -1) * to_center * left;
    for (int n = 0; n <= kPoints; ++n) {
      const double s = double(n) / kPoints;
      Eigen::Vector2d p = from + s * chord;
      if (radius > 0) {  // an arc of at most half a circle: turned about its centre by a part of its angle
        const double angle = 2 * std::asin(std::min(1.0, half / radius)) * (edge.radius > 0 ? s : -s);
        p = center + Eigen::Rotation2Dd(angle) * (from - center);
      }
      points.push_back(p);
    }
    from = to;
  }
  return points;
}

class Outline : public testing::TestWithParam<NamedHead> {};

TEST_P(Outline, DistanceIsThatOfTheNearestPointOfTheMeridian) {
  const ToolHead& head = GetParam().head;
  const HeadOutline outline(head);
  const std::vector<Eigen::Vector2d> meridian = points_of(head.profile());
  double spacing = 0;
  for (std::size_t n = 1; n < meridian.size(); ++n) spacing = std::max(spacing, (meridian[n] - meridian[n - 1]).norm());
  test::RandomPoses random(5);
  const HeadBox box = head.bounding_box();
  int outside = 0;
  for (int n = 0; n < 200; ++n) {
    const double rho = random.between(0, 2 * box.max.x());
    const double z = random.between(box.min.z() - box.max.x(), box.max.z() + box.max.x());
    double nearest = 1;
    for (const Eigen::Vector2d& p : meridian) nearest = std::min(nearest, (p - Eigen::Vector2d(rho, z)).norm());
    const HeadOutline::Place place = outline.place(rho, z);
    EXPECT_NEAR(std::abs(place.distance), nearest, spacing) << rho << " " << z;
    EXPECT_EQ(outline.distance(rho, z), place.distance);
    outside += place.distance > 0 ? 1 : 0;
    EXPECT_NEAR(std::hypot(place.n_radial, place.n_axial), 1, 1e-12);
    // Back along the direction by the distance lies the surface.
    const double back_rho = rho - place.distance * place.n_radial, back_z = z - place.distance * place.n_axial;
    EXPECT_LT(std::abs(outline.distance(std::abs(back_rho), back_z)), 1e-12) << rho << " " << z;
  }
  EXPECT_GT(outside, 50);
  EXPECT_LT(outside, 199);
}

INSTANTIATE_TEST_SUITE_P(Heads, Outline, testing::ValuesIn(all_heads()),
                         [](const auto& named) { return named.param.name; });

class ClosedOutline : public testing::TestWithParam<test::NamedProfile> {};

TEST_P(ClosedOutline, DistanceInsideIsMinusTheDepth) {
  const ProfileHead profile(GetParam().profile);
  const ToolHead head(profile);
  const HeadOutline outline(head);
  test::RandomPoses random(6);
  const HeadBox box = head.bounding_box();
  int inside = 0;
  for (int n = 0; n < 2000; ++n) {
    const double rho = random.between(0, box.max.x()), z = random.between(box.min.z(), box.max.z());
    const HeadOutline::Place place = outline.place(rho, z);
    if (place.distance >= 0) continue;
    ++inside;
    EXPECT_NEAR(place.distance, -profile.exact_spring(rho, z).depth, 1e-12) << rho << " " << z;
  }
  EXPECT_GT(inside, 500);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ClosedOutline, testing::ValuesIn(test::closed_profiles()),
                         [](const auto& named) { return named.param.name; });

/// A shape with arcs that ToolHead does not have: one that passes its largest rho, one that passes its highest and a
/// hollow one that passes its lowest point.
struct Bowl {
  [[nodiscard]] static double tip() { return 0; }
  [[nodiscard]] static std::array<ProfileEdge, 3> edges() {
    return {{{0.6 * mm, 1.2 * mm, 0.8 * mm}, {0.2 * mm, 1.2 * mm, 0.3 * mm}, {0, 1.2 * mm, -0.3 * mm}}};
  }
};

/// A ball as any shape: an arc of half a circle.
struct HalfCircle {
  [[nodiscard]] static double tip() { return -1 * mm; }
  [[nodiscard]] static std::array<ProfileEdge, 1> edges() { return {{{0, 1 * mm, 1 * mm}}}; }
};

TEST(Outline, OfAShapeWithArcsIsThatOfTheProfileWithTheseEdges) {
  const auto check = []<class Shape>(const Shape& shape) {
    const auto edges = shape.edges();
    const ToolHead twin(ProfileHead({shape.tip(), {edges.begin(), edges.end()}}));
    const HeadOutline outline(shape), expected(twin);
    test::RandomPoses random(7);
    const HeadBox box = twin.bounding_box();
    for (int n = 0; n < 2000; ++n) {
      const double rho = random.between(0, 1.5 * box.max.x());
      const double z = random.between(box.min.z() - box.max.x(), box.max.z() + box.max.x());
      ASSERT_NEAR(outline.distance(rho, z), expected.distance(rho, z), 1e-15) << rho << " " << z;
    }
  };
  check(Bowl{});
  check(HalfCircle{});
}

TEST(Outline, OfASphereConeAndFlatHeadIsTheClosedForm) {
  const ToolHead cone(ConeHead{30 * deg, 2 * mm}), flat(FlatHead{1 * mm, 2 * mm});
  const HeadOutline of_cone(cone), of_flat(flat);
  EXPECT_NEAR(of_cone.distance(0, -1 * mm), 1 * mm, 1e-15) << "below the apex";
  EXPECT_NEAR(of_cone.distance(1 * mm, 1 * mm), (std::cos(30 * deg) - std::sin(30 * deg)) * mm, 1e-15);
  EXPECT_NEAR(of_cone.distance(0.2 * mm, 3 * mm), 1 * mm, 1e-15) << "above the base";
  EXPECT_NEAR(of_flat.distance(1.3 * mm, -0.4 * mm), 0.5 * mm, 1e-15) << "at the edge";
  EXPECT_NEAR(of_flat.distance(1.5 * mm, 1 * mm), 0.5 * mm, 1e-15) << "beside the wall";
  EXPECT_NEAR(of_flat.distance(0.5 * mm, 0.25 * mm), -0.25 * mm, 1e-15) << "inside";
  const HeadOutline::Place on_bottom = of_flat.place(0.3 * mm, 0);
  EXPECT_EQ(on_bottom.distance, 0);
  EXPECT_EQ(on_bottom.n_axial, -1) << "the normal, where the difference vanishes";
}

}  // namespace
}  // namespace hapticut::head_outline_test
