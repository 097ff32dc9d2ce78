// SPDX-License-Identifier: Apache-2.0
// The closed forms where a hand presses: heads of R = 1 mm at rest with every setting at its default, 0.1 ... 5 N, at
// 25 places in the grid. The bounds are those of docs/validation.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hapticut/closed_forms.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::closed_forms_of_a_hand_test {
namespace {

using units::deg;
using units::mm;

constexpr double kRadius = 1 * mm, kHalfAngle = 30 * deg, kBlunt = 60 * deg;
constexpr int kPlaces = 25;

/// A head, its closed form, and the range of simulated over exact force in voxels of `voxel`.
struct Pressed {
  std::string name;
  ToolHead head;
  double (*exact)(double k_v, double depth);  // [N]
  double force;                               // [N]
  double voxel;                               // [m]
  double lowest, highest;                     // [1]
};

double ball(double k, double d) { return closed_forms::cap_force(k, kRadius, d); }
double flat(double k, double d) { return closed_forms::flat_bottom_force(k, kRadius, d); }
double flat_nearest(double k, double d) { return closed_forms::flat_nearest_force(k, kRadius, d); }
double cone(double k, double d) { return closed_forms::cone_force(k, kHalfAngle, d); }
double blunt_cone(double k, double d) { return closed_forms::cone_force(k, kBlunt, d); }

double depth_of(const Pressed& pressed, double k_v) {
  double low = 0, high = 0.5 * kRadius;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (low + high);
    (pressed.exact(k_v, middle) < pressed.force ? low : high) = middle;
  }
  return low;
}

/// Simulated over exact force at one place of the grid.
double ratio(const Pressed& pressed, int place) {
  const double l = pressed.voxel, k_v = stiffness_for_head(pressed.head), depth = depth_of(pressed, k_v);
  const Vec3 shift = l * Vec3(place * 7 % kPlaces, place * 11 % kPlaces, kPlaces - place) / kPlaces;
  const Vec3 corner(1.5 * kRadius, 1.5 * kRadius, 0);
  Simulation simulation(
      build_block({Vec3(-corner.x(), -corner.y(), -kRadius) - shift, corner}, l, presets::cortical_bone()),
      Tool(pressed.head));
  const double bottom = pressed.head.bounding_box().min.z();
  const StepResult& result = simulation.step(Pose::from_translation(Vec3(0, 0, -bottom - depth)), {}, 1e-3);
  EXPECT_FALSE(has_any(result.status, kRejected));
  return result.force.z() / pressed.exact(k_v, depth);
}

class AtRest : public testing::TestWithParam<Pressed> {};

TEST_P(AtRest, HasItsClosedFormWithinTheTolerance) {
  double low = 9, high = 0;
  for (int place = 0; place < kPlaces; ++place) {
    const double seen = ratio(GetParam(), place);
    low = std::min(low, seen);
    high = std::max(high, seen);
  }
  RecordProperty("ratios", std::to_string(low) + " ... " + std::to_string(high));
  EXPECT_GE(low, GetParam().lowest);
  EXPECT_LE(high, GetParam().highest);
}

const Pressed kPresses[] = {
    {"ball", SphereHead{kRadius}, ball, 0.17, 0.1 * mm, 0.98, 1.13},
    {"ball", SphereHead{kRadius}, ball, 2.5, 0.1 * mm, 0.99, 1.06},
    {"ball", SphereHead{kRadius}, ball, 0.17, 0.05 * mm, 0.98, 1.05},
    {"flat", FlatHead{kRadius, kRadius, FlatRule::bottom_only}, flat, 0.5, 0.1 * mm, 0.98, 1.02},
    {"flat", FlatHead{kRadius, kRadius, FlatRule::bottom_only}, flat, 3.1, 0.1 * mm, 0.98, 1.02},
    {"flatNearest", FlatHead{kRadius, kRadius}, flat_nearest, 0.5, 0.1 * mm, 0.9, 1.1},
    {"flatNearest", FlatHead{kRadius, kRadius}, flat_nearest, 3.1, 0.1 * mm, 0.9, 1.1},
    {"cone60", ConeHead{kHalfAngle, 1.5 * mm}, cone, 0.9, 0.1 * mm, 0.8, 1.45},
    {"cone60", ConeHead{kHalfAngle, 1.5 * mm}, cone, 0.9, 0.05 * mm, 0.8, 1.45},
    {"cone120", ConeHead{kBlunt, 0.6 * mm}, blunt_cone, 0.5, 0.1 * mm, 0.8, 1.45},
    {"cone120", ConeHead{kBlunt, 0.6 * mm}, blunt_cone, 2.5, 0.1 * mm, 0.8, 1.45},
};

INSTANTIATE_TEST_SUITE_P(ClosedFormsOfAHand, AtRest, testing::ValuesIn(kPresses), [](const auto& pressed) {
  const Pressed& p = pressed.param;
  return p.name + "_" + std::to_string(std::lround(1000 * p.force)) + "mN_" +
         std::to_string(std::lround(1e6 * p.voxel)) + "um";
});

// The table of docs/forces.md. Proves: what the stiffness of a material changes.
TEST(AMaterial, IsPressedInAsItsStiffnessSays) {
  struct Row {
    double stiffness, depth, felt;  // [1], [m] under 1 N, [N/m]
  };
  for (const Row& row : {Row{10, 0.017 * mm, 177e3}, Row{1, 0.037 * mm, 81e3}, Row{0.1, 0.080 * mm, 37e3},
                         Row{0.01, 0.177 * mm, 16e3}, Row{0.001, 0.410 * mm, 6.2e3}}) {
    Material material = presets::cortical_bone();
    material.relative_stiffness = row.stiffness;
    material.static_friction = material.dynamic_friction = 0;
    Simulation simulation(build_block({Vec3(-1.2, -1.2, -1) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.02 * mm, material),
                          Tool(SphereHead{kRadius}));
    const auto force_at = [&](double depth) {
      const Pose pose = Pose::from_translation(Vec3(0, 0, kRadius - depth));
      (void)simulation.step(pose, {}, 1e-3);
      return simulation.step(pose, {}, 1e-3).model.force.z();
    };
    const double step = 0.05 * row.depth, below = force_at(row.depth - step), at = force_at(row.depth),
                 above = force_at(row.depth + step);
    EXPECT_NEAR(at, 1, 0.06) << row.stiffness;
    EXPECT_NEAR((above - below) / (2 * step) / row.felt, 1, 0.06) << row.stiffness;
  }
}

// Proves: what acts when.
TEST(AMaterial, HidesItsDampingBehindTheEnergyOfACut) {
  const auto mean_force = [](Material material, const ToolHead& head, double damping) {
    material.damping = damping;
    Simulation simulation(build_block({Vec3(-1.2, -1.2, -1.2) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm, material),
                          Tool(head, RayHandle{0}, Spindle{40'000 * units::rpm}));
    double sum = 0;
    for (int tick = 0; tick < 200; ++tick) {  // down by 1 mm at 5 mm/s
      const Vec3 at(0, 0, -tick * 5e-6 - head.bounding_box().min.z());
      sum += simulation.step(Pose::from_translation(at), {Vec3(0, 0, -5e-3), Vec3::Zero()}, 1e-3).model.force.norm();
    }
    return sum;
  };
  for (const Material& material : {presets::enamel(), presets::cortical_bone(), presets::trabecular_bone()})
    for (const ToolHead& head : {ToolHead(SphereHead{kRadius}), ToolHead(ConeHead{kHalfAngle, 1.5 * mm}),
                                 ToolHead(FlatHead{kRadius, kRadius})}) {
      const double undamped = mean_force(material, head, 0);
      EXPECT_NEAR(mean_force(material, head, 20) / undamped, 1, 0.01) << material.name;
      EXPECT_NEAR(mean_force(material, head, 1000) / undamped, 1.05, 0.045) << material.name;
    }
}

// Default friction: a cone that goes down rubs upwards along its side, which adds mu_d cot(a) to the force of its
// springs.
TEST(AHeadThatGoesDown, FeelsTheFrictionOfItsSides) {
  const Material bone = presets::cortical_bone();
  const Pressed pressed{"cone60", ConeHead{kHalfAngle, 1.5 * mm}, cone, 1, 0.01 * mm, 0, 0};
  const double k_v = stiffness_for_head(pressed.head), depth = depth_of(pressed, k_v), speed = 1 * mm;
  Simulation simulation(build_block({Vec3(-0.233, -0.231, -0.232) * mm, Vec3(0.23, 0.23, 0) * mm}, pressed.voxel, bone),
                        Tool(pressed.head));
  const double bottom = pressed.head.bounding_box().min.z();
  double force = 0;
  for (double z = 0.01 * mm; z > -depth; z -= speed * 1e-3)
    force = simulation.step(Pose::from_translation(Vec3(0, 0, z - bottom)), {Vec3(0, 0, -speed), Vec3::Zero()}, 1e-3)
                .model.force.z();
  EXPECT_NEAR(force / pressed.force, 1 + bone.dynamic_friction / std::tan(kHalfAngle), 0.08);
}

}  // namespace
}  // namespace hapticut::closed_forms_of_a_hand_test
