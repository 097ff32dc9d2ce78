// SPDX-License-Identifier: Apache-2.0
// Trends of published measurements in cuts of the library (docs/validation.md: B8, B15, DC8).
#include <gtest/gtest.h>

#include <functional>

#include "experiments/setup/cutting.hpp"

namespace hapticut::measured_trends_test {
namespace {

using namespace test;
using units::kPi;
using units::mm;
using units::rpm;

/// Expects a rise by at least 5 % from each input to the next.
void expect_rise(const char* what, const std::vector<double>& inputs, const std::function<double(double)>& of,
                 double factor = 1.05) {
  double last = 0;
  for (const double input : inputs) {
    const double now = of(input);
    EXPECT_GT(now, factor * last) << what << ", " << input;
    last = now;
  }
}
void expect_fall(const char* what, const std::vector<double>& inputs, const std::function<double(double)>& of) {
  expect_rise(what, {inputs.rbegin(), inputs.rend()}, of, 1 / 0.95);
}

/// Bone with an edge pressure that suits a drill of a millimetre.
Material bone() {
  Material material = plain_material();
  material.edge_pressure = 3e5;
  return material;
}

SteadyState drill(double radius, double speed, double feed_speed) {
  const double side = radius + 0.3 * mm;
  Simulation simulation(build_block({Vec3(-side, -side, -1 * mm), Vec3(side, side, 0)}, 0.05 * mm, bone()),
                        tool_of(FlatHead{radius, 3 * mm, FlatRule::bottom_only}, speed), on_foundation(2e14));
  return feed(simulation, Vec3(0.013, 0.021, 0) * mm, Vec3(0, 0, -feed_speed), 0.8 * mm, kTick);
}

// Sui & Sugita 2018. The web of a drill has no counterpart in a head of revolution.
TEST(MeasuredTrends, B8ThrustAndTorqueRiseWithFeedAndDiameter) {
  const auto thrust = [](double radius, double speed) { return drill(radius, 1000, speed).force.z(); };
  const auto torque = [](double radius, double speed) { return -drill(radius, 1000, speed).torque.z(); };
  const std::vector<double> feeds = {0.5e-3, 1e-3, 2e-3}, radii = {0.4 * mm, 0.6 * mm, 0.8 * mm};
  expect_rise("thrust", feeds, [&](double speed) { return thrust(0.6 * mm, speed); });
  expect_rise("torque", feeds, [&](double speed) { return torque(0.6 * mm, speed); });
  expect_rise("thrust", radii, [&](double radius) { return thrust(radius, 1e-3); });
  expect_rise("torque", radii, [&](double radius) { return torque(radius, 1e-3); });
}

/// Size of the mean force of a ball that cuts a groove, spindle across its surface.
double burr_force(double speed, double feed_speed, double depth) {
  Simulation simulation(build_block({Vec3(0, -1.3, -1) * mm, Vec3(2.5, 1.3, 0) * mm}, 0.05 * mm, bone()),
                        tool_of(SphereHead{kRadius}, speed), on_foundation(2e14));
  return feed(simulation, Vec3(-1.023 * mm, 0.011 * mm, kRadius - depth), Vec3(feed_speed, 0, 0), 2.2 * mm, kTick, 0.75)
      .force.norm();
}

// Babbar 2020: a burr on skull bone.
TEST(MeasuredTrends, B15TheForceOfABurrFallsWithSpeedAndRisesWithFeedAndDepth) {
  expect_fall("force over speed", {10000 * rpm, 30000 * rpm, 55000 * rpm},
              [](double speed) { return burr_force(speed, 4e-3, 0.4 * mm); });
  expect_rise("force over feed", {2e-3, 4e-3, 8e-3},
              [](double speed) { return burr_force(20000 * rpm, speed, 0.4 * mm); });
  expect_rise("force over depth", {0.2 * mm, 0.4 * mm, 0.6 * mm},
              [](double depth) { return burr_force(20000 * rpm, 4e-3, depth); });
}

// Song, Peng, Lin, Yin 2013 measured dental ceramics. An edge pressure has this effect in every material.
TEST(MeasuredTrends, DC8ForceRisesWithTheChipAndTheEnergyOfAVolumeFalls) {
  const double R = 0.6 * mm, speed = 1000;
  const std::vector<double> feeds = {0.25e-3, 0.5e-3, 1e-3, 2e-3};
  expect_rise("force", feeds, [&](double feed_speed) { return drill(R, speed, feed_speed).force.z(); });
  expect_fall("energy", feeds, [&](double feed_speed) {
    const SteadyState cut = drill(R, speed, feed_speed);
    const double energy = (-cut.torque.z() * speed + cut.force.z() * feed_speed) / (kPi * R * R * feed_speed);
    EXPECT_GT(energy, plain_material().specific_cutting_energy);
    return energy;
  });
}

}  // namespace
}  // namespace hapticut::measured_trends_test
