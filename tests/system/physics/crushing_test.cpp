// SPDX-License-Identifier: Apache-2.0
// Material that a head presses harder than its strength is crushed, whether the
// spindle turns or not.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::crushing_test {
namespace {

namespace forms = closed_forms;
using namespace test;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kStrength = 100e6;  // [Pa]

Material brittle(double strength = kStrength) {
  Material material = plain_material();
  material.compressive_strength = strength;
  material.static_friction = material.dynamic_friction = 0;  // because friction would bear a part of the load
  return material;
}
double crushing_depth(double stiffness) { return std::sqrt(2 * kStrength / stiffness); }

/// A standing head on a block whose face is z = 0 in the tool's own axes, which have the orientation `R` in the grid.
struct Press {
  Press(const ToolHead& head, double stiffness, double voxel, const Mat3& R_WT = Mat3::Identity(),
        double thickness = 2 * mm, RemovalLaw removal = RemovalLaw::constant_energy, double spin = 0)
      : R(R_WT), simulation(block(R_WT, voxel, thickness), tool_of(head, spin), config(stiffness, removal)) {}

  static Workpiece block(const Mat3& R, double voxel, double thickness) {
    return body({Vec3::Constant(-3 * mm), Vec3::Constant(3 * mm)}, voxel, brittle(), [R, thickness](const Vec3& p) {
      const Vec3 q = R.transpose() * p;
      const double across = std::max(std::abs(q.x()), std::abs(q.y())) - 1.6 * mm;
      return std::max({q.z(), -thickness - q.z(), across});
    });
  }
  static SimulationConfig config(double stiffness, RemovalLaw removal = RemovalLaw::constant_energy) {
    SimulationConfig config = on_foundation(stiffness, false);
    config.removal = removal;
    return config;
  }
  [[nodiscard]] Pose at(double z) const { return {R, R * (kOffGrid + Vec3(0, 0, z))}; }
  /// Moves the lowest point from one depth to another, and returns the force along the axis at the end.
  double move(double from, double to, double lowest, double step = 2e-6) {
    const int steps = std::max(1, int(std::lround(std::abs(to - from) / step)));
    for (int n = 1; n <= steps; ++n) {
      const Vec3 velocity = R * Vec3(0, 0, -(to - from) / steps / kTick);
      const Pose pose = at(lowest - (from + (to - from) * n / steps));
      const Vec3 force_T = R.transpose() * simulation.step(pose, {velocity, Vec3::Zero()}, kTick).force;
      forces.push_back(force_T.z());
    }
    return forces.back();
  }
  [[nodiscard]] const EnergyLedger& energy() const { return simulation.last_result().energy; }
  [[nodiscard]] double crushed() const { return simulation.totals().removed_volume[1]; }

  Mat3 R;
  Simulation simulation;
  std::vector<double> forces;
};

std::vector<Orientation> orientations() {
  std::vector<Orientation> all = {{"along the grid", Mat3::Identity()}};
  all.insert(all.end(), kOrientations.begin(), kOrientations.end());
  return all;
}

// Proves: crushing.
TEST(Crushing, C39AFlatHeadGoesDownAtItsStrength) {
  const double expected = forms::flat_bottom_crushing_force(kStrength, kRadius);
  for (const Orientation& orientation : orientations())
    for (const double stiffness : {1e16, 1e17})
      for (const double voxel : {0.1 * mm, 0.05 * mm}) {
        SCOPED_TRACE(std::string(orientation.name) + ", k_v " + std::to_string(stiffness) + ", voxel " +
                     std::to_string(voxel / mm) + " mm");
        Press press(FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, stiffness, voxel, orientation.R_WT);
        const double depth = 0.6 * mm, begun = 1.2 * crushing_depth(stiffness);
        (void)press.move(-0.01 * mm, begun, 0);
        press.forces.clear();
        (void)press.move(begun, depth, 0);
        double mean = 0, square = 0;
        for (const double f : press.forces) mean += f / double(press.forces.size());
        for (const double f : press.forces) square += (f - mean) * (f - mean) / double(press.forces.size());
        EXPECT_NEAR(mean / expected, 1, 0.01);
        EXPECT_LT(std::sqrt(square) / mean, 0.01);
        EXPECT_NEAR(press.energy().crushed / (kStrength * press.crushed()), 1, 0.01);
        EXPECT_LT(unbooked(press.energy()), 1e-6);
        EXPECT_LT(std::abs(press.energy().entered), 1e-3 * press.energy().hand_work);
        EXPECT_EQ(press.energy().cutting, 0);
        EXPECT_TRUE(has_any(press.simulation.last_result().status, StepStatus::material_crushed));
      }
}

// Proves: crushing.
TEST(Crushing, C40ABallGoesDownAtItsStrengthTimesItsArea) {
  for (const Orientation& orientation : orientations())
    for (const double stiffness : {1e16, 1e17}) {
      Press press(SphereHead{kRadius}, stiffness, 0.1 * mm, orientation.R_WT);
      const double w0 = crushing_depth(stiffness);
      double depth = 0;
      for (const double next : {0.3 * mm, 0.45 * mm, 0.6 * mm}) {
        SCOPED_TRACE(std::string(orientation.name) + ", k_v " + std::to_string(stiffness) + ", depth " +
                     std::to_string(next / mm) + " mm");
        const double force = press.move(depth, next, kRadius), at = next - 1e-6;  // the mean of the last step
        depth = next;
        EXPECT_NEAR(force / forms::cap_crushing_force(kStrength, w0, kRadius, at), 1, 0.02);
      }
      EXPECT_NEAR(press.energy().crushed / (kStrength * press.crushed()), 1, 0.02);
      EXPECT_LT(unbooked(press.energy()), 1e-6);
    }
}

// The remaining material pushes back elastically, up to the depth to which it was pressed. Moving the head out and in
// again crushes nothing.
TEST(Crushing, RemainingMaterialIsElastic) {
  Press press(SphereHead{kRadius}, 1e16, 0.1 * mm);
  const double force = press.move(0, 0.5 * mm, kRadius), crushed = press.crushed();
  const double hand = press.energy().hand_work, elastic = press.energy().elastic;
  (void)press.move(0.5 * mm, 0.2 * mm, kRadius);
  EXPECT_NEAR(press.forces.back(), 0, 1e-3 * force);
  EXPECT_NEAR(press.energy().hand_work, hand - elastic, 1e-3 * hand);
  (void)press.move(0.2 * mm, 0.5 * mm, kRadius);
  EXPECT_NEAR(press.forces.back() / force, 1, 0.01);
  EXPECT_NEAR(press.crushed() / crushed, 1, 2e-3);
}

// A standing ball breaks through a plate and leaves a hole; the work of the hand is the strength times the hole.
TEST(Crushing, APlateIsPunchedThrough) {
  for (const double thickness : {0.2 * mm, 0.5 * mm}) {
    Press press(SphereHead{kRadius}, 1e17, 0.1 * mm, kOrientations[0].R_WT, thickness);
    (void)press.move(0, 2 * kRadius + 2 * thickness, kRadius);
    const double hole = kPi * std::pow(kRadius - crushing_depth(1e17), 2) * thickness;
    SCOPED_TRACE(std::to_string(thickness / mm) + " mm");
    EXPECT_NEAR(press.crushed() / hole, 1, 0.04);
    EXPECT_NEAR(press.energy().hand_work / (kStrength * press.crushed()), 1, 0.02);
    EXPECT_NEAR(press.energy().elastic, 0, 1e-4 * press.energy().hand_work);
  }
}

// The pin fills its hole through a plate. A smooth side is twice as stiff as a cutting one, and a damped contact is
// many times as stiff. A column of voxels still bears at most the strength, however many voxels divide it.
TEST(Crushing, AWallBearsItsStrengthEvenlyForAnySideAndDamping) {
  const double thickness = 1 * mm, speed = 10 * mm;  // [m], [m/s]
  const auto pin = [](EdgeKind side) {
    return ProfileHead({0, {{kRadius, 0}, {kRadius, 4 * mm, 0, side}, {0, 4 * mm, 0, EdgeKind::smooth}}});
  };
  for (const EdgeKind side : {EdgeKind::cutting, EdgeKind::smooth})
    for (const double damping : {0.0, 300.0})
      for (const double voxel : {0.2 * mm, 0.1 * mm}) {
        const Box box = {Vec3(-1.6, -1.6, -1.4) * mm, Vec3(2.4, 1.6, 0.4) * mm};
        Workpiece plate = body(box, voxel, brittle(), [&](const Vec3& p) {
          return std::max({p.z(), -thickness - p.z(), kRadius - p.head<2>().norm()});
        });
        SimulationConfig config = Press::config(2e16);
        config.contact_damping = damping;
        Simulation simulation(std::move(plate), Tool(pin(side)), config);
        double min_force = 1e9, max_force = 0;
        for (int n = 1; n <= 50; ++n) {
          const Vec3 at = kOffGrid + Vec3(n * speed * 1e-3, 0, -2 * mm);
          const double force = -step_to(simulation, at, Vec3(speed, 0, 0)).force.x();
          if (n > 25) min_force = std::min(min_force, force), max_force = std::max(max_force, force);
        }
        const double bears = kStrength * 2 * kRadius * thickness;
        const std::string scene = std::string(name_or_null(side)) + ", damping " + std::to_string(damping) +
                                  " s/m, voxels of " + std::to_string(1e3 * voxel) + " mm";
        EXPECT_GT(min_force, 0.8 * bears) << scene;
        EXPECT_LT(max_force, 1.03 * bears) << scene;
        EXPECT_LT(max_force - min_force, 0.1 * bears) << scene;
      }
}

TEST(Crushing, AStandingPointThinnerThanTheVoxelsSaysSo) {
  struct Case {
    ToolHead head;
    double voxel;  // [m]
    bool thin;
  };
  const ToolHead needle = ConeHead{8.5 * deg, 4 * mm};  // radius 0.03 mm at 0.2 mm above the tip
  for (const Case& c :
       {Case{needle, 0.1 * mm, true}, Case{needle, 0.01 * mm, false}, Case{SphereHead{0.5 * mm}, 0.1 * mm, false},
        Case{ConeHead{60 * deg, 1 * mm}, 0.1 * mm, false}}) {
    const double half = 4 * c.voxel;  // beyond the point
    const Box box = {Vec3(-half - 0.05 * mm, -half - 0.05 * mm, -0.4 * mm),
                     Vec3(half + 0.05 * mm, half + 0.05 * mm, 0)};
    Simulation simulation(build_block(box, c.voxel, brittle()), Tool(c.head), Press::config(1e16));
    StepStatus seen = StepStatus::ok;
    const double tip = -c.head.bounding_box().min.z();
    for (int n = 1; n <= 100; ++n) seen = step_to(simulation, Vec3(3e-6, 1e-6, tip - n * 2e-6)).status;
    EXPECT_EQ(has_any(seen, StepStatus::point_thin), c.thin) << c.head.description() << ", " << c.voxel;
  }
}

TEST(Crushing, NothingIsCrushedWhereNothingMayBeRemoved) {
  Press press(SphereHead{kRadius}, 1e16, 0.1 * mm, Mat3::Identity(), 2 * mm, RemovalLaw::none);
  (void)press.move(0, 0.5 * mm, kRadius);
  EXPECT_EQ(press.crushed(), 0);
  EXPECT_NEAR(press.forces.back() / forms::cap_force(1e16, kRadius, 0.5 * mm - 1e-6), 1, 0.01);
}

TEST(Crushing, IsAskedForTheSameByAProbe) {
  Press press(SphereHead{kRadius}, 1e16, 0.1 * mm, kOrientations[0].R_WT);
  (void)press.move(0, 0.4 * mm, kRadius);
  const Pose next = press.at(kRadius - 0.41 * mm);
  const Twist twist = {press.R * Vec3(0, 0, -0.01 * mm / 1e-3), Vec3::Zero()};
  const ContactProbe probed = press.simulation.probe(next, twist, 1e-3);
  const StepResult& stepped = press.simulation.step(next, twist, 1e-3);
  EXPECT_TRUE(has_any(stepped.status, StepStatus::material_crushed));
  EXPECT_EQ(probed.wrench.force, stepped.model.force);
}

// A turning head that is fed faster than it can cut also crushes material beyond its strength.
TEST(Crushing, ATurningHeadBearsNoMoreThanAStandingOne) {
  Press press(FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, 1e16, 0.1 * mm, kOrientations[0].R_WT, 2 * mm,
              RemovalLaw::constant_energy, 20);
  const double force = press.move(0, 0.6 * mm, 0, 1e-5);
  EXPECT_LE(force, 1.02 * forms::flat_bottom_crushing_force(kStrength, kRadius));
  EXPECT_GT(press.energy().cutting, 0);
  EXPECT_GT(press.energy().crushed, 0);
  EXPECT_LT(unbooked(press.energy()), 1e-5);
}

}  // namespace
}  // namespace hapticut::crushing_test
