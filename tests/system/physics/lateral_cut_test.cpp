// SPDX-License-Identifier: Apache-2.0
// Closed forms of steady lateral cutting and of plunging: C24-C30.
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/force/stiffness.hpp"
#include "support/cutting.hpp"

namespace hapticut::lateral_cut_test {
namespace {

namespace forms = closed_forms;
using test::feed;
using test::plain_material;
using test::SteadyState;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kFeed = 5 * mm;  // [m/s]
constexpr double kSpin = 1000;    // [rad/s]; the rim is 200 times faster than the feed

constexpr double kThinLayer = 0.02;        // [1] of a layer of R/40 (docs/model.md, accuracy)
constexpr double kBall = 0.06;             // [1] an engaged layer that meets a ball at all angles
constexpr double kNearTheEquator = 0.14;   // [1] plunges, near d = R (docs/model.md, accuracy)
constexpr double kSinglePrecision = 1e-4;  // [1] of sums of forces
constexpr double kClosure = 1e-4;          // [1] of the ledger

forms::SteadyCut cut_at(double feed_speed) {
  const Material m = plain_material();
  return {m.specific_cutting_energy, m.cutting_ratio, kSpin, feed_speed};
}

/// k_v for an engaged layer `delta` at the rim.
double stiffness_for_layer(double delta) { return forms::stiffness_for_layer(cut_at(kFeed), delta, kRadius); }

// Measured for the layer of R/40 on voxels of half of it: 0.4 % against the feed, 1.2 % across, 0.2 % of the torque.
// Proves: tangential force of the spin.
TEST(LateralCut, C24SlottingWithACylinder) {
  const double height = 0.5 * mm;
  SimulationConfig config;
  config.reference_stiffness = stiffness_for_layer(kRadius / 40);
  Simulation simulation(
      build_block({Vec3(0, -1.3, -height / mm) * mm, Vec3(3.5, 1.3, 0) * mm}, kRadius / 80, plain_material()),
      Tool(FlatHead{kRadius, 4 * mm, FlatRule::side_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}), config);
  const SteadyState s = feed(simulation, Vec3(-1.023, 0.011, -1.5) * mm, Vec3(kFeed, 0, 0), 3.3 * mm, 1e-3, 0.7);
  const Wrench expected = forms::slotting_wrench(cut_at(kFeed), kRadius, height);
  EXPECT_NEAR(s.force.x() / expected.force.x(), 1, kThinLayer);
  EXPECT_NEAR(s.force.y() / expected.force.y(), 1, kThinLayer);
  EXPECT_NEAR(s.torque.z() / expected.torque.z(), 1, kThinLayer);
}

// Proves: tangential force of the spin.
TEST(LateralCut, C24SpinTheOtherWayMirrorsTheSideForce) {
  const auto run = [](double spin) {
    SimulationConfig config;
    config.reference_stiffness = stiffness_for_layer(0.1 * mm);
    Simulation simulation(
        build_block({Vec3(0, -1.3, -0.5) * mm, Vec3(3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
        Tool(FlatHead{kRadius, 4 * mm, FlatRule::side_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    return feed(simulation, Vec3(-1.023, 0, -1.5) * mm, Vec3(kFeed, 0, 0), 2.5 * mm, 1e-3, 0.7);
  };
  const SteadyState right = run(kSpin), left = run(-kSpin);
  EXPECT_NEAR(right.force.x() / left.force.x(), 1, kSinglePrecision);
  EXPECT_NEAR(right.force.y() / left.force.y(), -1, kSinglePrecision);
  EXPECT_NEAR(right.torque.z() / left.torque.z(), -1, kSinglePrecision);
}

/// A buried ball fed sideways through a block: C27.
SteadyState buried_sphere(double layer, double voxel) {
  SimulationConfig config;
  config.reference_stiffness = stiffness_for_layer(layer);
  Simulation simulation(build_block({Vec3(0, -1.3, -1.3) * mm, Vec3(3.4, 1.3, 1.3) * mm}, voxel, plain_material()),
                        Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}), config);
  return feed(simulation, Vec3(-1.023, 0.011, 0.017) * mm, Vec3(kFeed, 0, 0), 3.2 * mm, 1e-3, 0.75);
}

// Proves: removal by law A.
TEST(LateralCut, C27ABuriedSphereConvergesAsTheEngagedLayerThins) {
  const Wrench expected = forms::buried_ball_wrench(cut_at(kFeed), kRadius);
  const double tz = expected.torque.z();
  const SteadyState thick = buried_sphere(0.1 * mm, 0.1 * mm);
  const SteadyState thin = buried_sphere(0.05 * mm, 0.05 * mm);
  EXPECT_NEAR(thin.force.x() / expected.force.x(), 1, kBall);
  EXPECT_NEAR(thin.force.y() / expected.force.y(), 1, kBall);
  EXPECT_NEAR(thin.torque.z() / tz, 1, kBall);
  EXPECT_LT(std::abs(thin.torque.z() / tz - 1), std::abs(thick.torque.z() / tz - 1));
}

// Proves: removal by law A.
TEST(LateralCut, C28C29PlungesApproachTheirClosedFormsAsTheLayerThins) {
  struct Case {
    const char* name;
    ToolHead head;
    Wrench expected;  // at depth d
  };
  const double depth = 0.9 * mm;
  const double alpha = 45 * units::deg;
  const double speed = 1 * mm;
  const std::vector<Case> cases = {
      {"C28", SphereHead{kRadius}, forms::ball_plunge_wrench(cut_at(speed), kRadius, depth)},
      {"C29", ConeHead{alpha, 2 * mm}, forms::cone_plunge_wrench(cut_at(speed), alpha, depth)}};
  for (const Case& c : cases) {
    const auto error_of = [&](double stiffness, double voxel, double expected, bool torque) {
      SimulationConfig config;
      config.reference_stiffness = stiffness;
      Simulation simulation(build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, voxel, plain_material()),
                            Tool(c.head, RayHandle{0}, Spindle{kSpin * units::rad_per_s}), config);
      const double tip = c.name == std::string("C28") ? kRadius : 0;
      // The last 0.06 mm before the depth, centred on it.
      const SteadyState s = feed(simulation, Vec3(0.029 * mm, 0.013 * mm, tip), Vec3(0, 0, -speed), depth + 0.03 * mm,
                                 1e-3, 1 - 0.06 * mm / (depth + 0.03 * mm));
      return 1 - (torque ? s.torque.z() : s.force.z()) / expected;
    };
    const double stiffness = forms::stiffness_for_layer(cut_at(speed), 0.1 * mm, kRadius);
    const double thick = error_of(stiffness, 0.05 * mm, c.expected.torque.z(), true);
    const double thin = error_of(4 * stiffness, 0.05 * mm, c.expected.torque.z(), true);
    EXPECT_NEAR(thin, 0, kNearTheEquator) << c.name;
    EXPECT_GT(thick / thin, 1.4) << c.name << ": half the layer, about half the error";
    EXPECT_NEAR(error_of(4 * stiffness, 0.05 * mm, c.expected.force.z(), false), 0, kNearTheEquator) << c.name;
    const double layers = std::sqrt(4 * stiffness / stiffness_for_head(c.head));  // the default's over the thin one
    for (const bool torque : {true, false}) {
      const double expected = torque ? c.expected.torque.z() : c.expected.force.z();
      const double thin_error = error_of(4 * stiffness, 0.05 * mm, expected, torque);
      const double seen = error_of(0, 0.1 * mm, expected, torque);
      EXPECT_LT(std::abs(seen), layers * std::abs(thin_error) + 0.01) << c.name << (torque ? ", torque" : ", force");
    }
  }
}

TEST(LateralCut, C30PowerPaysForTheRemovedVolumeAndTheLosses) {
  const SteadyState s = buried_sphere(0.1 * mm, 0.1 * mm);
  EXPECT_LT(fixtures::unbooked(s.energy), kClosure);
  EXPECT_NEAR(s.energy.cutting / (plain_material().specific_cutting_energy * s.removed_volume), 1, kSinglePrecision);
}

}  // namespace
}  // namespace hapticut::lateral_cut_test
