// SPDX-License-Identifier: Apache-2.0
// The law of the thesis as printed. Its figures and its defects are rows of `hapticut validate`.
#include <gtest/gtest.h>

#include <cmath>

#include "support/laws.hpp"
#include "support/static_contact.hpp"

namespace hapticut::thesis_test {
namespace {

using units::mm;

constexpr double kSinglePrecision = 1e-4;  // [1] of sums of some thousand forces

// Proves: law of the thesis.
TEST(ThesisLaw, SpinTorqueIsLambdaTimesTheNormalForcesAndTheRadius) {
  for (const double spin : {100.0, -100.0}) {
    SimulationConfig config = test::static_config();
    ThesisLaw::Constants constants;
    constants.spin_torque = 0.2;
    constants.spin_exponent = 0.5;
    config.law = std::make_shared<ThesisLaw>(constants);
    Simulation simulation(
        test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm, Vec3::Zero()),
        Tool(FlatHead{1 * mm, 2 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    const StepResult& result = test::hold_well(simulation, Vec3(0, 0, -0.5 * mm));
    // All normal forces of the bottom are along the axis, so their sum is the force.
    EXPECT_NEAR(result.torque.z() / (-std::copysign(0.2 * 10 * 1 * mm * result.force.z(), spin)), 1, kSinglePrecision);
  }
}

// Proves: layers and grades; law of the thesis.
TEST(ThesisLaw, ForceFollowsTheStiffnessOfEachVoxel) {
  SimulationConfig config = test::static_config();
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  const auto layered = [&](double left, double right) {
    Simulation simulation(test::box_at_phase({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm,
                                             Vec3::Zero(), test::materials_of_stiffness({left, right}),
                                             [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); }),
                          Tool(SphereHead{1 * mm}), config);
    return test::hold_well(simulation, Vec3(0, 0, 0.6 * mm)).force;
  };
  const Vec3 equal = layered(0.5, 0.5), unequal = layered(0.3, 0.7);
  EXPECT_NEAR(unequal.z() / equal.z(), 1, kSinglePrecision) << "the halves weigh alike";
  EXPECT_LT(unequal.x(), -0.01 * equal.z()) << "the stiffer half pushes the tool away";
  EXPECT_NEAR(equal.x(), 0, kSinglePrecision * equal.z());
}

}  // namespace
}  // namespace hapticut::thesis_test
