// SPDX-License-Identifier: Apache-2.0
// What others measured as trends, in cuts of the library (docs/measurements.md: B8, B15, DC8).
#include <gtest/gtest.h>

#include "support/cutting.hpp"

namespace hapticut::measured_trends_test {
namespace {

using units::kPi;
using units::mm;
using units::rpm;

/// Bone with an edge that rubs, as a drill of a millimetre sees it.
Material bone() {
  Material material = test::plain_material();
  material.edge_pressure = 3e5;
  return material;
}

SimulationConfig stiff() {
  SimulationConfig config;
  config.reference_stiffness = 2e14;
  return config;
}

test::SteadyState drill(double radius, double speed, double feed) {
  const double side = radius + 0.3 * mm;
  Simulation simulation(
      build_block({Vec3(-side, -side, -1 * mm), Vec3(side, side, 0)}, 0.05 * mm, bone()),
      Tool(FlatHead{radius, 3 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{speed * units::rad_per_s}), stiff());
  return test::feed(simulation, Vec3(0.013, 0.021, 0) * mm, Vec3(0, 0, -feed), 0.8 * mm, 1e-3);
}

// Sui & Sugita 2018. The web of a drill has no counterpart in a head of revolution.
TEST(MeasuredTrends, B8ThrustAndTorqueRiseWithFeedAndDiameter) {
  const auto thrust = [](double radius, double feed) { return drill(radius, 1000, feed).force.z(); };
  const auto torque = [](double radius, double feed) { return -drill(radius, 1000, feed).torque.z(); };
  double last_thrust = 0, last_torque = 0;
  for (const double feed : {0.5e-3, 1e-3, 2e-3}) {
    EXPECT_GT(thrust(0.6 * mm, feed), 1.05 * last_thrust);
    EXPECT_GT(torque(0.6 * mm, feed), 1.05 * last_torque);
    last_thrust = thrust(0.6 * mm, feed), last_torque = torque(0.6 * mm, feed);
  }
  last_thrust = last_torque = 0;
  for (const double radius : {0.4 * mm, 0.6 * mm, 0.8 * mm}) {
    EXPECT_GT(thrust(radius, 1e-3), 1.05 * last_thrust);
    EXPECT_GT(torque(radius, 1e-3), 1.05 * last_torque);
    last_thrust = thrust(radius, 1e-3), last_torque = torque(radius, 1e-3);
  }
}

/// Size of the mean force of a ball that cuts a groove, spindle across its surface.
double burr_force(double speed, double feed, double depth) {
  const double R = 1 * mm;
  Simulation simulation(build_block({Vec3(0, -1.3, -1) * mm, Vec3(2.5, 1.3, 0) * mm}, 0.05 * mm, bone()),
                        Tool(SphereHead{R}, RayHandle{0}, Spindle{speed * units::rad_per_s}), stiff());
  return test::feed(simulation, Vec3(-1.023 * mm, 0.011 * mm, R - depth), Vec3(feed, 0, 0), 2.2 * mm, 1e-3, 0.75)
      .force.norm();
}

// Babbar 2020: a burr on skull bone.
TEST(MeasuredTrends, B15TheForceOfABurrFallsWithSpeedAndRisesWithFeedAndDepth) {
  double last = 1e9;
  for (const double speed : {10000 * rpm, 30000 * rpm, 55000 * rpm}) {
    const double force = burr_force(speed, 4e-3, 0.4 * mm);
    EXPECT_LT(force, 0.95 * last) << speed;
    last = force;
  }
  last = 0;
  for (const double feed : {2e-3, 4e-3, 8e-3}) {
    const double force = burr_force(20000 * rpm, feed, 0.4 * mm);
    EXPECT_GT(force, 1.05 * last) << feed;
    last = force;
  }
  last = 0;
  for (const double depth : {0.2 * mm, 0.4 * mm, 0.6 * mm}) {
    const double force = burr_force(20000 * rpm, 4e-3, depth);
    EXPECT_GT(force, 1.05 * last) << depth;
    last = force;
  }
}

// Song, Peng, Lin, Yin 2013: dental ceramics, and in general what an edge pressure does.
TEST(MeasuredTrends, DC8ForceRisesWithTheChipAndTheEnergyOfAVolumeFalls) {
  const double R = 0.6 * mm, speed = 1000;
  double last_force = 0, last_energy = 1e30;
  for (const double feed : {0.25e-3, 0.5e-3, 1e-3, 2e-3}) {
    const auto cut = drill(R, speed, feed);
    const double energy = (-cut.torque.z() * speed + cut.force.z() * feed) / (kPi * R * R * feed);
    EXPECT_GT(cut.force.z(), 1.05 * last_force) << feed;
    EXPECT_LT(energy, 0.95 * last_energy) << feed;
    EXPECT_GT(energy, test::plain_material().specific_cutting_energy);
    last_force = cut.force.z(), last_energy = energy;
  }
}

}  // namespace
}  // namespace hapticut::measured_trends_test
