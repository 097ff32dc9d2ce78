// SPDX-License-Identifier: Apache-2.0
// Cones and flat heads pressed into half spaces, walls and edges, with the spindle standing: closed forms C4-C9.
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "support/static_contact.hpp"

namespace hapticut::static_cone_flat_test {
namespace {

namespace forms = closed_forms;
using test::box_at_phase;
using test::converge;
using test::Convergence;
using test::expect_convergence;
using test::half_space;
using test::hold;
using test::kStiffness;
using test::static_config;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kHeight = 1.2 * mm;
constexpr double kTall = 3 * kHeight;  // so that the smooth end is farther than what cuts
constexpr double kCoarsest = 0.1 * mm;

// Orders of root mean squares over twelve phases are known to about 0.2.
constexpr double kSecondOrder = 1.7;
constexpr double kRimOrder = 1.25;

/// [1] Relative error of the lattice points in a disk of radius R: 0.82 sqrt(R/l) of pi (R/l)^2, in the root mean
/// square (Kendall). What is summed has this error where the spring does not vanish at the rim of the bottom.
double rim_error(double l) { return 0.26 * std::pow(l / kRadius, 1.5); }

/// [m^2] Error of the integral of z from 0 on a lattice: l^2/2 times the second Bernoulli polynomial of the place of
/// the first point, 0.0745 in the root mean square. The springs of a bottom end at z = 0 with this error.
double kink_error(double l) { return 0.0745 / 2 * l * l; }

// Predictions are for all phases; twelve of them come within a factor of 1.5, and sums of two errors within 2.
constexpr double kPhaseFactor = 2;

// --- cone -------------------------------------------------------------------------------------------------------

class ConeAngle : public testing::TestWithParam<double> {};

// Proves: normal force.
TEST_P(ConeAngle, C4ForceGrowsWithTheFourthPowerOfDepth) {
  const double angle = GetParam() * deg;
  const ConeHead head = {angle, kHeight};
  const double depth = 0.8 * mm;
  const double expected = forms::cone_force(kStiffness, angle, depth);
  const auto press = [&](double l, const Vec3& phase) {
    Simulation simulation(box_at_phase(half_space(kHeight * std::tan(angle), depth, l), l, phase), Tool(head),
                          static_config());
    return hold(simulation, Vec3(0, 0, -depth)).force;
  };
  // A whole voxel has the spring of its centre, without -l^2/24 of its Laplacian: 1/(2 tan(a)^2) (l/d)^2, of which the
  // parts at the surface, taken to lie across n, give (1 - sin a)/sin(a) back; and some more by their fills.
  expect_convergence(
      converge(depth / 8, [&](double l, const Vec3& phase) { return press(l, phase).z() / expected - 1; }),
      kSecondOrder, 0.5 / std::pow(std::tan(angle), 2) + 0.2, depth);
  // Sideways the springs change their direction on the axis, where they are deepest: per layer an error l^2 w cos(a)
  // that depends on the phase, in all (l/d)^2/tan(a)^3 of the small axial force.
  expect_convergence(
      converge(depth / 8, [&](double l, const Vec3& phase) { return press(l, phase).head<2>().norm() / expected; }),
      kSecondOrder, 1.1 / std::pow(std::tan(angle), 3), depth);
}

INSTANTIATE_TEST_SUITE_P(HalfAngles, ConeAngle, testing::Values(15, 30, 45),
                         [](const auto& angle) { return std::to_string(int(angle.param)) + "Degrees"; });

// --- flat head, along its axis ------------------------------------------------------------------------------------

/// Force of a flat head at depth d below the surface of a half space.
Vec3 press_flat(FlatRule rule, double depth, double l, const Vec3& phase) {
  Simulation simulation(box_at_phase(half_space(kRadius, depth, l), l, phase), Tool(FlatHead{kRadius, kTall, rule}),
                        static_config());
  return hold(simulation, Vec3(0, 0, -depth)).force;
}

class FlatDepth : public testing::TestWithParam<double> {
 protected:
  const double depth_ = GetParam() * mm;
};

// Proves: normal force.
TEST_P(FlatDepth, C5BottomOnlyIsTheDiskTimesTheDepthSquared) {
  const double expected = forms::flat_bottom_force(kStiffness, kRadius, depth_);
  const Convergence c = converge(kCoarsest, [&](double l, const Vec3& phase) {
    return press_flat(FlatRule::bottom_only, depth_, l, phase).z() / expected - 1;
  });
  expect_convergence(c, kRimOrder, [&](double l) {
    return kPhaseFactor * std::hypot(rim_error(l), kink_error(l) / (depth_ * depth_ / 2));
  });
}

TEST_P(FlatDepth, C5BothSpringsPushUpLikeTheBottomAloneAndCancelSideways) {
  const Vec3 bottom = press_flat(FlatRule::bottom_only, depth_, kCoarsest / 2, test::phase(1));
  const Vec3 both = press_flat(FlatRule::both, depth_, kCoarsest / 2, test::phase(1));
  // A voxel that the bottom crosses has the section across the sum of both springs: second order.
  EXPECT_NEAR(both.z() / bottom.z(), 1, 0.2 * std::pow(kCoarsest / 2 / depth_, 2));
  const Vec3 fine_bottom = press_flat(FlatRule::bottom_only, depth_, kCoarsest / 4, test::phase(1));
  const Vec3 fine_both = press_flat(FlatRule::both, depth_, kCoarsest / 4, test::phase(1));
  EXPECT_NEAR(fine_both.z() / fine_bottom.z(), 1, 0.2 * std::pow(kCoarsest / 4 / depth_, 2));
  // Sideways the wall's springs cancel up to the lattice's asymmetry, of the order of the error of C5.
  EXPECT_LT(std::hypot(both.x(), both.y()), 0.01 * both.z());
}

TEST_P(FlatDepth, C5SideOnlyDoesNotPushUp) {
  EXPECT_EQ(press_flat(FlatRule::side_only, depth_, kCoarsest / 2, test::phase(2)).z(), 0);
}

// Proves: normal force.
TEST_P(FlatDepth, C6NearestLosesWhatIsNearerToTheWall) {
  const double R = kRadius, d = depth_;
  const double expected = forms::flat_nearest_force(kStiffness, R, d);
  const Convergence c = converge(kCoarsest, [&](double l, const Vec3& phase) {
    return press_flat(FlatRule::nearest, depth_, l, phase).z() / expected - 1;
  });
  // The direction jumps where wall and bottom are equally near: lattice points in a cone, whose normals meet those of
  // the lattice's planes, so that its order is that of a disk (measured: 0.2 to 0.5 (l/R)^1.5).
  const double share =
      forms::flat_bottom_force(kStiffness, R, d) / expected;  // [1] of the disk's force that is left, inverse
  expect_convergence(c, kRimOrder,
                     [&](double l) { return 0.6 * std::pow(l / R, 1.5) + 1.5 * kink_error(l) / (d * d / 2) * share; });
}

INSTANTIATE_TEST_SUITE_P(Depths, FlatDepth, testing::Values(0.2, 0.6, 1.0), [](const auto& depth) {
  return std::to_string(int(depth.param * 1000 + 0.5)) + "Micrometres";
});

// --- flat head, sideways into a wall --------------------------------------------------------------------------------

/// A wall x > R - d beside the head, that reaches from z0 to z1 above its bottom.
struct Wall {
  double depth;                           // [m] d
  double z0 = 0.35 * mm, z1 = 0.85 * mm;  // [m]

  [[nodiscard]] Box box(double l) const {
    const double reach = kRadius + 2 * l;
    return {Vec3(kRadius - depth, -reach, z0), Vec3(reach, reach, z1)};
  }
  [[nodiscard]] double area() const { return forms::disk_area_before(kRadius, depth - kRadius); }  // of the segment

  /// [1] of the force, over (l/d)^2. At the wall's ends n lies in their faces, and a part that is taken to lie across n
  /// is l/12 too shallow in the mean over all fills: k_v l^2/6 times the integral of n_x over the segment.
  [[nodiscard]] double error() const {
    const double c = kRadius - depth, a = std::sqrt(kRadius * kRadius - c * c);
    const double along = kRadius * a - c * c * std::log((kRadius + a) / c);
    const double force = std::abs(forms::side_wall_force(kStiffness, kRadius, depth, z1 - z0));
    return 1.3 * kStiffness * along / 6 * depth * depth / force + 0.1;
  }
};

StepResult press_into_wall(const Wall& wall, FlatRule rule, double l, const Vec3& phase, double handle_length) {
  Simulation simulation(box_at_phase(wall.box(l), l, phase),
                        Tool(FlatHead{kRadius, kTall, rule}, RayHandle{handle_length}), static_config());
  return hold(simulation, Vec3(0, 0, handle_length));
}

class WallDepth : public testing::TestWithParam<double> {
 protected:
  const Wall wall_ = {GetParam() * mm};
};

// Proves: normal force.
TEST_P(WallDepth, C7ForceOfTheSideWall) {
  const double expected = forms::side_wall_force(kStiffness, kRadius, wall_.depth, wall_.z1 - wall_.z0);
  const Convergence c = converge(kCoarsest / 2, [&](double l, const Vec3& phase) {
    return (press_into_wall(wall_, FlatRule::side_only, l, phase, 0).force - Vec3(expected, 0, 0)).norm() /
           std::abs(expected);
  });
  expect_convergence(c, kSecondOrder, wall_.error(), wall_.depth);
}

// Proves: torque.
TEST_P(WallDepth, C8TorqueOfTheSideWallAboutAPointOfTheHandle) {
  const double zr = 1.5 * mm, z0 = wall_.z0, z1 = wall_.z1;
  const double expected = forms::side_wall_torque(kStiffness, kRadius, wall_.depth, z0, z1, zr);
  const Convergence c = converge(kCoarsest / 2, [&](double l, const Vec3& phase) {
    return press_into_wall(wall_, FlatRule::side_only, l, phase, zr).torque.y() / expected - 1;
  });
  expect_convergence(c, kSecondOrder, wall_.error(), wall_.depth);
}

TEST_P(WallDepth, C7BothSpringsAddTheBottomsPushOverTheSegment) {
  const double l = kCoarsest / 8;
  const Vec3 side = press_into_wall(wall_, FlatRule::side_only, l, test::phase(3), 0).force;
  const Vec3 both = press_into_wall(wall_, FlatRule::both, l, test::phase(3), 0).force;
  EXPECT_NEAR(both.x() / side.x(), 1, 0.5 * std::pow(l / wall_.depth, 2));  // as C5 with both
  const double z0 = wall_.z0, z1 = wall_.z1;
  // lattice points in a circular segment, which is at least 0.1 mm = 8 voxels deep here
  EXPECT_NEAR(both.z() / (kStiffness * wall_.area() * (z1 * z1 - z0 * z0) / 2), 1, 0.02);
}

TEST_P(WallDepth, C7NearestIsTheSideWallWhereTheBottomIsFarther) {
  // A thin ledge, so high above the bottom that the wall is nearer at all of these depths.
  Wall ledge = wall_;
  ledge.z0 = 0.95 * mm, ledge.z1 = 1.1 * mm;
  const double l = kCoarsest / 4;
  const StepResult side = press_into_wall(ledge, FlatRule::side_only, l, test::phase(4), 0);
  const StepResult nearest = press_into_wall(ledge, FlatRule::nearest, l, test::phase(4), 0);
  EXPECT_GT(side.force.norm(), 0);
  EXPECT_EQ(side.force, nearest.force);
  EXPECT_EQ(side.torque, nearest.torque);
}

TEST_P(WallDepth, C7BottomOnlyDoesNotPushSideways) {
  const Vec3 force = press_into_wall(wall_, FlatRule::bottom_only, kCoarsest / 2, test::phase(5), 0).force;
  EXPECT_EQ(force.x(), 0);
  EXPECT_EQ(force.y(), 0);
}

INSTANTIATE_TEST_SUITE_P(Depths, WallDepth, testing::Values(0.1, 0.3, 0.6, 0.9), [](const auto& depth) {
  return std::to_string(int(depth.param * 1000 + 0.5)) + "Micrometres";
});

// --- flat head over an edge ---------------------------------------------------------------------------------------

class EdgePlace : public testing::TestWithParam<double> {};

// Proves: normal force.
TEST_P(EdgePlace, C9ForceAndTorqueOfAPartlyCoveredBottom) {
  const double R = kRadius, x0 = GetParam() * mm, d = 0.3 * mm;
  const double area = forms::disk_area_before(R, x0);
  const double force = forms::edge_force(kStiffness, R, d, x0);
  const double torque = forms::edge_torque(kStiffness, R, d, x0);
  const auto press = [&](double l, const Vec3& phase) {
    Box box = half_space(R, d, l);
    box.max.x() = x0;
    Simulation simulation(box_at_phase(box, l, phase), Tool(FlatHead{R, kHeight, FlatRule::bottom_only}),
                          static_config());
    return hold(simulation, Vec3(0, 0, -d));
  };
  // The rim counts lattice points as in C5, over an area that may be a fifth of the disk.
  const auto bound = [&](double covered) {
    return [&, covered](double l) {
      return kPhaseFactor * std::hypot(rim_error(l) * kPi * R * R / covered, kink_error(l) / (d * d / 2));
    };
  };
  expect_convergence(
      converge(kCoarsest, [&](double l, const Vec3& phase) { return press(l, phase).force.z() / force - 1; }),
      kRimOrder, bound(area));
  // Half of the rim at most, and its mean square lever is R^2/2.
  const double moment = 2.0 / 3 * std::pow(R * R - x0 * x0, 1.5);  // [m^3] of the area about the axis
  expect_convergence(
      converge(kCoarsest, [&](double l, const Vec3& phase) { return press(l, phase).torque.y() / torque - 1; }),
      kRimOrder, bound(2 * moment / R));
}

INSTANTIATE_TEST_SUITE_P(Edges, EdgePlace, testing::Values(-0.5, 0.0, 0.4), [](const auto& place) {
  return std::string(place.param < 0 ? "ShortOfTheAxis" : place.param > 0 ? "BeyondTheAxis" : "AtTheAxis");
});

}  // namespace
}  // namespace hapticut::static_cone_flat_test
