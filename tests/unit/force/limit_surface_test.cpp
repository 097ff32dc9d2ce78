// SPDX-License-Identifier: Apache-2.0
// Dry friction spread over a surface, against sums of Coulomb's law over the points.
#include "hapticut/force/limit_surface.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

#include "hapticut/core/units.hpp"

namespace hapticut::limit_surface_test {
namespace {

using units::kPi;
using units::mm;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kR = 1 * mm, kNormal = 3, kMu = 0.3;  // kNormal: [N] sum over all points
const DryFriction kFriction = {kMu, kMu, 1000};

struct Point {
  Vec3 r, n;
  double normal;  // [N]
};
using Points = std::vector<Point>;

Points distributed(Points points) {  // the weights become forces
  const double sum =
      std::accumulate(points.begin(), points.end(), 0.0, [](double all, const Point& p) { return all + p.normal; });
  for (Point& p : points) p.normal *= kNormal / sum;
  return points;
}
Points pin() {
  Points points;
  for (int level = 0; level < 20; ++level)
    for (int i = 0; i < 64; ++i) {
      const Vec3 n(std::cos(2 * kPi * i / 64), std::sin(2 * kPi * i / 64), 0);
      points.push_back({kR * n + Vec3(0, 0, level * 0.25 * mm), n, 1});
    }
  return distributed(points);
}
Points disc() {
  Points points;
  for (int ring = 0; ring < 40; ++ring)
    for (int i = 0; i < 64; ++i) {
      const double rho = (ring + 0.5) / 40 * kR;
      points.push_back({rho * Vec3(std::cos(2 * kPi * i / 64), std::sin(2 * kPi * i / 64), 0), -Vec3::UnitZ(), rho});
    }
  return distributed(points);
}
Points groove() {
  const Vec3 left = Vec3(-1, 0, -1).normalized(), right = Vec3(1, 0, -1).normalized();
  return distributed({{kR * left, left, 1}, {kR * right, right, 1}});
}
SpreadFriction contact_of(const Points& points) {
  SpreadFriction contact;
  for (const Point& p : points) contact.add(p.r, p.n, p.normal, kFriction);
  return contact;
}

/// [W] Dissipation of a twist by Coulomb's law.
double exact_power(const Points& points, const Vector6& twist) {
  double power = 0;
  for (const Point& p : points) {
    const Vec3 v = twist.head<3>() + Vec3(twist.tail<3>()).cross(p.r);
    power += kMu * p.normal * (v - v.dot(p.n) * p.n).norm();
  }
  return power;
}
/// Result of a long slide along a twist.
Wrench slid(const SpreadFriction& contact, const Vector6& twist) {
  LimitSurface anchor;
  Wrench wrench;
  for (int n = 0; n < 50; ++n) wrench = anchor.move(contact, {0.05 * twist.head<3>(), 0.05 * twist.tail<3>()}).wrench;
  EXPECT_TRUE(anchor.sliding());
  return wrench;
}
double power_of(const Wrench& wrench, const Vector6& twist) {
  return -wrench.force.dot(twist.head<3>()) - wrench.torque.dot(twist.tail<3>());
}
Vector6 twist_of(double x, double y, double z, double a, double b, double c) {
  Vector6 twist;
  twist << x, y, z, a, b, c;
  return twist;
}

// Friction is proportional to the sum of the normal forces. Their resultant is zero for a pin in its hole.
// Proves: slipping.
TEST(LimitSurface, IsExactWhereAllPointsSlipAlike) {
  const double pull = kMu * kNormal;
  EXPECT_NEAR(slid(contact_of(pin()), twist_of(0, 0, kR, 0, 0, 0)).force.z(), -pull, 1e-9);
  EXPECT_NEAR(slid(contact_of(pin()), twist_of(0, 0, 0, 0, 0, 1)).torque.z(), -pull * kR, 1e-12);
  const Vector6 screw = twist_of(0, 0, kR, 0, 0, 1);
  EXPECT_NEAR(power_of(slid(contact_of(pin()), screw), screw), exact_power(pin(), screw), 1e-9);
  EXPECT_NEAR(slid(contact_of(groove()), twist_of(0, kR, 0, 0, 0, 0)).force.y(), -pull, 1e-9);
  EXPECT_NEAR(slid(contact_of(disc()), twist_of(kR, 0, 0, 0, 0, 0)).force.x(), -pull, 1e-9);
}

TEST(LimitSurface, TakesLittleMorePowerThanTheSumOverItsPointsAndNeverLess) {
  const double torque = slid(contact_of(disc()), twist_of(0, 0, 0, 0, 0, 1)).torque.z();
  EXPECT_NEAR(torque / (-kMu * kNormal * 2 / 3 * kR), 1.061, 2e-3);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const Points& points : {pin(), disc(), groove()}) {
    const SpreadFriction contact = contact_of(points);
    double mean = 0;
    for (int n = 0; n < 200; ++n) {
      Vector6 twist;
      for (int i = 0; i < 6; ++i) twist[i] = normal(random) * (i < 3 ? kR : 1);
      const Stiffness shape = contact.directions / contact.static_limit;
      const double power = contact.static_limit * std::sqrt(twist.dot(shape * twist)),
                   exact = exact_power(points, twist);
      EXPECT_GE(power, exact * (1 - 1e-9));
      mean += power / exact / 200;
    }
    EXPECT_LT(mean, 1.14);
  }
}

// Each material has its own coefficient, here on its own wall.
TEST(LimitSurface, WeighsEachPointByItsOwnCoefficient) {
  const Points walls = groove();
  SpreadFriction contact;
  contact.add(walls[0].r, walls[0].n, walls[0].normal, {0.5, 0.4, 1000});
  contact.add(walls[1].r, walls[1].n, walls[1].normal, {0.1, 0.1, 1000});
  EXPECT_NEAR(slid(contact, twist_of(0, kR, 0, 0, 0, 0)).force.y(), -0.25 * kNormal, 1e-9);
}

// Proves: energy of the anchor.
TEST(LimitSurface, GivesBackTheWorkOfAClosedPathThatNeverSlid) {
  const SpreadFriction contact = contact_of(groove());
  LimitSurface anchor;
  double work = 0, turnover = 0;
  constexpr int kSteps = 400;
  for (int n = 0; n < kSteps; ++n) {
    const double phase = 2 * kPi * (n + 0.5) / kSteps, step = 2 * kPi / kSteps;
    const Twist move = {step * 0.05 * mm * Vec3(std::cos(phase), std::sin(2 * phase), std::sin(phase)),
                        step * 0.02 * Vec3(0, std::cos(phase), std::cos(2 * phase))};
    const Wrench wrench = anchor.move(contact, move).wrench;
    const double part = -wrench.force.dot(move.linear) - wrench.torque.dot(move.angular);
    work += part;
    turnover += std::abs(part);
  }
  EXPECT_FALSE(anchor.sliding());
  EXPECT_NEAR(work, 0, 1e-4 * turnover);
}

// A contact that comes and goes, rotates and slides never creates energy, except the error of finite rotations in a
// step.
TEST(LimitSurface, NeverGivesMoreThanItWasGiven) {
  const SpreadFriction in_groove = contact_of(groove()), on_disc = contact_of(disc());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int walk = 0; walk < 60; ++walk) {
    LimitSurface anchor;
    double work = 0, turnover = 0, dissipated = 0, min_work = 0;
    Vector6 direction = Vector6::Zero();
    for (int n = 0; n < 500; ++n) {
      if (n % 20 == 0)
        for (int i = 0; i < 6; ++i) direction[i] = uniform(random) * (i < 3 ? 0.05 * mm : 0.003);
      const double load = n % 50 < 3 ? 0.0 : 1 + uniform(random);
      SpreadFriction contact = n % 100 < 50 ? in_groove : on_disc;
      contact *= load;
      const Twist move = {direction.head<3>(), direction.tail<3>()};
      const auto outcome = anchor.move(contact, move, 1, walk % 2 == 0 ? 0 : 0.5);
      const double part = -outcome.wrench.force.dot(move.linear) - outcome.wrench.torque.dot(move.angular);
      work += part;
      turnover += std::abs(part);
      dissipated += outcome.dissipated;
      EXPECT_GE(outcome.dissipated, 0);
      min_work = std::min(min_work, work - anchor.stored());
      EXPECT_GE(direction.dot(outcome.stiffness * direction), -1e-9 * anchor.stiffness() * kR * kR);
    }
    EXPECT_GE(min_work, -1e-3 * turnover);
    EXPECT_NEAR(work, dissipated + anchor.stored(), 1e-3 * turnover);
  }
}

}  // namespace
}  // namespace hapticut::limit_surface_test
