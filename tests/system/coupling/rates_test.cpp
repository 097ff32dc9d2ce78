// SPDX-License-Identifier: Apache-2.0
// A hand removes the same volume at any rate of the loop, as long as its cut is not much thinner than a voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"

namespace hapticut::rates_test {
namespace {

using namespace test;
using namespace units;

/// The path of a hand that is pressed down, as a distance along it.
struct Motion {
  ToolHead head;
  Mat3 rotation;  // rotation of the head
  Vec3 (*at)(double distance);
};

Vec3 to_and_fro(double distance) {
  constexpr double kLength = 5 * mm;
  const double way = std::fmod(distance + kLength, 4 * kLength);
  return {way < 2 * kLength ? way - kLength : 3 * kLength - way, 0, 0};
}

Vec3 in_circles(double distance) {
  constexpr double kCircle = 1 * mm;
  return {kCircle * std::sin(distance / kCircle), kCircle * (1 - std::cos(distance / kCircle)), 0};
}

Motion strokes_of_a_ball() { return {round_head(2 * mm), Mat3::Identity(), to_and_fro}; }
Motion circles_with_a_side() {
  return {cylinder_head(2 * mm, 4 * mm), rotation_from_vector(Vec3(std::numbers::pi / 2, 0, 0)), in_circles};
}

/// [m^3] that a hand on a Touch removes in a second.
/// @param beside  [m] how far beside the motion it starts
double removed(const Motion& motion, const Material& material, double force, double speed, double rate, double beside) {
  const Tool tool(motion.head, RayHandle{30 * mm}, common_spindle(40000 * rpm));
  Simulation simulation(build_block({Vec3(-8, -3, -3) * mm, Vec3(8, 3, 0) * mm}, 0.1 * mm, material), tool,
                        implicit(0, std::nullopt));
  VirtualCoupling coupling(simulation, touch_gains());
  const double dt = 1 / rate, above = 0.3 * mm, landing = 0.1;  // [s], [m], [s]
  const auto hand = [&](double t) {
    const double down = std::min(1.0, t / landing) * (above + force / coupling.gains().stiffness);
    const Vec3 p =
        motion.at(std::max(0.0, t - landing) * speed) + Vec3(0.017 * mm + beside, 0.006 * mm, 1 * mm + above - down);
    return Pose{motion.rotation, p} * tool.X_HT().inverse();
  };
  double volume = 0;
  for (double t = dt; t < 1; t += dt)
    volume += coupling.step(hand(t), twist_between(hand(t - dt), hand(t), dt), dt).removed_volume;
  return volume;
}

/// [1] Most that the removed volume changes with the rate, from 0.5 to 4 kHz. The means of five starts that are a
/// nanometre apart are compared, because chance makes the volumes of such starts differ by up to 2 %.
double change_with_rate(const Motion& motion, const Material& material, double force, double speed) {
  constexpr int kStarts = 5;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
    double volume = 0;
    for (int start = 0; start < kStarts; ++start)
      volume += removed(motion, material, force, speed, rate, start * 1e-9) / kStarts;
    least = std::min(least, volume), most = std::max(most, volume);
  }
  return most / least - 1;
}

TEST(RemovedVolume, DoesNotDependOnTheRate) {
  constexpr double kFast = 40e-3;  // [m/s]
  EXPECT_LT(change_with_rate(strokes_of_a_ball(), presets::trabecular_bone(), 1, kFast), 0.02);
  EXPECT_LT(change_with_rate(strokes_of_a_ball(), presets::trabecular_bone(), 0.3, kFast), 0.07);
  EXPECT_LT(change_with_rate(circles_with_a_side(), presets::trabecular_bone(), 0.3, kFast), 0.06);
  EXPECT_LT(change_with_rate(circles_with_a_side(), presets::dentin(), 1, kFast), 0.02);
}

// The limit: what this hand cuts in a second is a fifteenth of a voxel deep. Dentin: 14.8 % in the mean of thirty
// starts; that of five is within 0.5 % of it, one standard deviation.
TEST(RemovedVolume, DependsOnTheRateByAThirdWhereTheCutIsMuchThinnerThanAVoxel) {
  EXPECT_LT(change_with_rate(circles_with_a_side(), presets::dentin(), 0.3, 5e-3), 0.165);
  EXPECT_LT(change_with_rate(circles_with_a_side(), presets::trabecular_bone(), 0.1, 5e-3), 0.3);
}

}  // namespace
}  // namespace hapticut::rates_test
