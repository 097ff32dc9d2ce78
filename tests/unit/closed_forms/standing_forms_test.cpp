// SPDX-License-Identifier: Apache-2.0
// The closed forms C1-C19 of docs/model.md against integrals of their equations, without voxels and steps. The tests
// integrate the springs of all points in the head.
#include <gtest/gtest.h>

#include <functional>

#include "hapticut/closed_forms.hpp"
#include "hapticut/tool/head.hpp"

namespace hapticut::standing_forms_test {
namespace {

namespace forms = closed_forms;
using units::deg;
using units::mm;

constexpr double kStiffness = 1e12;  // [N/m^4]
constexpr double kR = 1 * mm;

// [1] error of a volume integral with 120 points across, where some springs end at a face
constexpr double kVolume = 4e-3;
constexpr double kLine = 1e-5;  // [1] error of an integral over a line with thousands of points
constexpr double kRounding = 1e-12;

/// A head with its springs, and the stiffness of the material around it. All are in T, whose axes here are those of W.
struct Contact {
  std::function<MeridianSpring<double>(double rho, double z)> spring;
  std::function<double(const Vec3& p)> stiffness;                         // [N/m^4]; 0: no material
  std::function<double(double n_z)> damped = [](double) { return 1.0; };  // factor of the normal force
  Vec3 low, high;                                                         // [m] a box around the springs in material
};

struct Springs {
  Wrench wrench;
  double energy = 0;  // [J]
};

/// Integrates `F = -Int k_v w n dV`, its torque and the energy by the midpoint rule over small boxes.
Springs integrate(const Contact& contact) {
  constexpr int kAcross = 120;
  const Vec3 size = (contact.high - contact.low) / kAcross;
  const double volume = size.prod();
  Springs sum;
  for (int i = 0; i < kAcross; ++i)
    for (int j = 0; j < kAcross; ++j)
      for (int k = 0; k < kAcross; ++k) {
        const Vec3 p = contact.low + size.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
        const double rho = std::hypot(p.x(), p.y());
        const MeridianSpring<double> s = contact.spring(rho, p.z());
        if (s.depth <= 0) continue;
        const double k_v = contact.stiffness(p);
        const Vec3 n(s.n_radial * p.x() / rho, s.n_radial * p.y() / rho, s.n_axial);
        const Vec3 force = -k_v * s.depth * contact.damped(s.n_axial) * volume * n;
        sum.wrench.force += force;
        sum.wrench.torque += p.cross(force);
        sum.energy += k_v * s.depth * s.depth / 2 * volume;
      }
  return sum;
}

/// A head upright in the half space below `surface` in T.
Contact in_half_space(const std::function<MeridianSpring<double>(double, double)>& spring, double reach, double low,
                      double surface) {
  return {spring, [](const Vec3&) { return kStiffness; }, [](double) { return 1.0; }, Vec3(-reach, -reach, low),
          Vec3(reach, reach, surface)};
}

Contact ball(double depth) {
  const SphereSprings<double> springs(SphereHead{kR});
  return in_half_space([=](double rho, double z) { return springs.spring(rho, z); }, kR, -kR, depth - kR);
}

template <FlatRule kRule>
Contact flat(double depth) {
  const FlatSprings<double, kRule> springs(FlatHead{kR, 3 * kR});
  return in_half_space([=](double rho, double z) { return springs.spring(rho, z); }, kR, 0, depth);
}

TEST(StandingForms, C1C3C14OfABallAreTheSumOfItsSprings) {
  for (const double depth : {0.5 * kR, 1.0 * kR, 1.5 * kR}) {
    const Springs springs = integrate(ball(depth));
    EXPECT_NEAR(springs.wrench.force.z() / forms::cap_force(kStiffness, kR, depth), 1, kVolume);
    EXPECT_LT((springs.wrench.torque - forms::ball_torque(Vec3::Zero(), springs.wrench.force)).norm(),
              kRounding * kR * springs.wrench.force.norm());
    if (depth > kR) continue;
    EXPECT_NEAR(springs.energy / forms::cap_energy(kStiffness, kR, depth), 1, kVolume);
  }
  EXPECT_EQ(forms::cap_force(kStiffness, kR, -0.1 * mm), 0);
  EXPECT_EQ(forms::cap_force(kStiffness, kR, 2.1 * mm), 0);
}

TEST(StandingForms, C2C3AreTheSlopeAndTheWorkOfC1) {
  const double d = 0.4 * kR, h = 1e-4 * kR;
  const auto force = [](double depth) { return forms::cap_force(kStiffness, kR, depth); };
  EXPECT_NEAR((force(d + h) - force(d - h)) / (2 * h) / forms::cap_stiffness(kStiffness, kR, d), 1, kLine);
  EXPECT_NEAR(forms::cap_stiffness(kStiffness, kR, 2 * kR / 3) / forms::max_cap_stiffness(kStiffness, kR), 1,
              kRounding);
  EXPECT_LT(forms::cap_stiffness(kStiffness, kR, 0.66 * kR), forms::max_cap_stiffness(kStiffness, kR));
  EXPECT_LT(forms::cap_stiffness(kStiffness, kR, 0.67 * kR), forms::max_cap_stiffness(kStiffness, kR));
  double work = 0;
  for (int i = 0; i < 1000; ++i) work += force(d * (i + 0.5) / 1000) * d / 1000;
  EXPECT_NEAR(work / forms::cap_energy(kStiffness, kR, d), 1, kLine);
}

TEST(StandingForms, C4OfAConeIsTheSumOfItsSprings) {
  for (const double angle : {20 * deg, 45 * deg, 60 * deg}) {
    const double d = 0.8 * mm;
    const ConeSprings<double> springs(ConeHead{angle, 2 * mm});
    const Contact contact =
        in_half_space([=](double rho, double z) { return springs.spring(rho, z); }, d * std::tan(angle), 0, d);
    EXPECT_NEAR(integrate(contact).wrench.force.z() / forms::cone_force(kStiffness, angle, d), 1, kVolume);
  }
}

TEST(StandingForms, C5C6OfAFlatHeadAreTheSumOfItsSprings) {
  const double d = 0.6 * kR;
  EXPECT_NEAR(integrate(flat<FlatRule::bottom_only>(d)).wrench.force.z() / forms::flat_bottom_force(kStiffness, kR, d),
              1, kVolume);
  EXPECT_NEAR(integrate(flat<FlatRule::nearest>(d)).wrench.force.z() / forms::flat_nearest_force(kStiffness, kR, d), 1,
              kVolume);
}

TEST(StandingForms, C7C8OfASideInAWallAreTheSumOfItsSprings) {
  const double d = 0.3 * kR, z0 = 0.4 * mm, z1 = 1 * mm, z_r = 1.5 * mm;
  const FlatSprings<double, FlatRule::side_only> springs(FlatHead{kR, 3 * kR});
  Contact wall = in_half_space([=](double rho, double z) { return springs.spring(rho, z); }, kR, z0, z1);
  wall.low.x() = kR - d;
  const Wrench wrench = integrate(wall).wrench;
  EXPECT_NEAR(wrench.force.x() / forms::side_wall_force(kStiffness, kR, d, z1 - z0), 1, kVolume);
  const Vec3 torque = wrench.torque - Vec3(0, 0, z_r).cross(wrench.force);
  EXPECT_NEAR(torque.y() / forms::side_wall_torque(kStiffness, kR, d, z0, z1, z_r), 1, kVolume);
}

TEST(StandingForms, C9OverAnEdgeIsTheSumOfItsSprings) {
  const double d = 0.3 * kR;
  for (const double x0 : {-0.4 * kR, 0.3 * kR}) {
    Contact edge = flat<FlatRule::bottom_only>(d);
    edge.high.x() = x0;
    const Wrench wrench = integrate(edge).wrench;
    EXPECT_NEAR(wrench.force.z() / forms::edge_force(kStiffness, kR, d, x0), 1, kVolume);
    EXPECT_NEAR(wrench.torque.y() / forms::edge_torque(kStiffness, kR, d, x0), 1, kVolume);
  }
}

TEST(StandingForms, C10C12OfLayersAndGradesAreTheSumOfTheirSprings) {
  const double d = 0.8 * kR, t = 0.32 * kR, surface = d - kR;  // the layers meet on the face of a box
  Contact layers = ball(d);
  layers.stiffness = [=](const Vec3& p) { return p.z() > surface - t ? kStiffness : 0.3 * kStiffness; };
  EXPECT_NEAR(integrate(layers).wrench.force.z() / forms::layered_cap_force(kStiffness, 0.3 * kStiffness, t, kR, d), 1,
              kVolume);
  const Vec3 gradient = Vec3(0.3, -0.2, -0.5) * kStiffness / mm;
  Contact graded = ball(d);
  graded.stiffness = [=](const Vec3& p) { return kStiffness + gradient.dot(p - Vec3(0, 0, surface)); };
  const Vec3 expected = forms::graded_cap_force(kStiffness, gradient, kR, d);
  EXPECT_LT((integrate(graded).wrench.force - expected).norm(), kVolume * expected.norm());
}

TEST(StandingForms, C11OfTheSurfaceOfAHalfSpaceIsC1) {
  const double d = 0.7 * kR;
  const Pose X_WT = Pose::from_translation(Vec3(0.2 * mm, 0.1 * mm, kR - d));
  const auto depth = [](double rho, double z) { return kR - std::hypot(rho, z); };
  const Wrench wrench = forms::wrench_on_plane(kStiffness, depth, X_WT, {}, Vec3::Zero(), kR, 400);
  EXPECT_NEAR(wrench.force.z() / forms::cap_force(kStiffness, kR, d), 1, 2e-4);
  EXPECT_LT(wrench.torque.norm(), 1e-9 * wrench.force.norm() * kR);
}

TEST(StandingForms, C15IsWhatDampingAddsToTheSprings) {
  const double d = 0.6 * kR, chi = 5, speed = 0.05;
  Contact moving = ball(d);
  moving.damped = [=](double n_z) { return std::max(0.0, 1 - chi * speed * n_z); };  // w_dot = V . n, V = -speed z
  const double added = integrate(moving).wrench.force.z() - integrate(ball(d)).wrench.force.z();
  EXPECT_NEAR(added / forms::ball_damping_force(kStiffness, chi, kR, d, speed), 1, kVolume);
}

TEST(StandingForms, C16GivesC1C4AndC6) {
  const double d = 0.5 * kR, a = 50 * deg;
  EXPECT_NEAR(forms::section_force(
                  kStiffness, [&](double rho) { return kR - std::hypot(rho, kR - d); }, kR) /
                  forms::cap_force(kStiffness, kR, d),
              1, kLine);
  EXPECT_NEAR(forms::section_force(
                  kStiffness, [&](double rho) { return d * std::sin(a) - rho * std::cos(a); }, d * std::tan(a)) /
                  forms::cone_force(kStiffness, a, d),
              1, kLine);
  EXPECT_NEAR(forms::section_force(
                  kStiffness, [&](double rho) { return std::min(d, kR - rho); }, kR) /
                  forms::flat_nearest_force(kStiffness, kR, d),
              1, kLine);
}

TEST(StandingForms, C17IsTheWorkOfASpringThatSlips) {
  const double mu_s = 0.45, mu_d = 0.3, k_t = 500, normal = 2, length = 10 * mm;
  double work = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double force = k_t * length * (i + 0.5) / kSteps;
    const bool sticks = force <= forms::drag_peak(mu_s, normal);
    work += (sticks ? force : forms::drag_plateau(mu_d, normal)) * length / kSteps;
  }
  EXPECT_NEAR(work / forms::drag_work(mu_s, mu_d, k_t, normal, length), 1, 1e-4);
}

TEST(StandingForms, C18IsTheDifferenceOverTheRate) { EXPECT_EQ(forms::growth_time(5, 500), 0.01); }

TEST(StandingForms, C19PowerIsTheSameAtEveryPointOfABody) {
  const Wrench wrench{Vec3(1, -2, 3), Vec3(0.1, 0.4, -0.2)};
  const Twist twist{Vec3(0.02, -0.01, -0.03), Vec3(0.4, 1.1, -0.7)};
  const Vec3 arm(0.05, -0.02, 0.01);
  EXPECT_NEAR(forms::power({wrench.force, wrench.torque - arm.cross(wrench.force)},
                           {twist.linear + twist.angular.cross(arm), twist.angular}),
              forms::power(wrench, twist), kRounding);
}

}  // namespace
}  // namespace hapticut::standing_forms_test
