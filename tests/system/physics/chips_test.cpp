// SPDX-License-Identifier: Apache-2.0
// Cutting energy that depends on the chip: forces, pushes and the ledger against closed forms, in every direction of
// the grid and for layers thick and thin (docs/decisions/0010-chips.md).
#include <gtest/gtest.h>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/cutting.hpp"
#include "support/fed_tool.hpp"

namespace hapticut::chips_test {
namespace {

namespace forms = closed_forms;
using test::Fed;
using test::feed_along;
using test::kWays;
using test::push_down;
using test::Pushed;
using test::Way;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kVoxel = 0.1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
constexpr double kSpin = 2000;    // [rad/s]
constexpr Cutter kCutter{CutterKind::carbide_bur, 2};

// Measured, [1]: what is left of each is in docs/decisions/0010-chips.md.
constexpr double kMean = 0.03;     // of the closed form
constexpr double kSlot = 0.035;    // the same for walls, where the layer is thickest at 1e15
constexpr double kLayer = 0.1;     // the same in the layer of the default foundation under the pressure of bone
constexpr double kRipple = 0.013;  // standard deviation over mean
constexpr double kPushed = 0.04;   // of the speed under a push

struct Lengths {
  const char* name;
  double edge, size;  // [m] that cost about as much as the chip itself
};
const double kChip = kFeed / tooth_rate(kCutter, kSpin);  // [m] h of the feed
const std::vector<Lengths> kLengths = {{"edge", 2 * kChip, 0}, {"size", 0, 4 * kChip}, {"both", kChip, 2 * kChip}};

Material material_with(const Lengths& lengths) {
  Material material = test::plain_material();
  material.edge_length = lengths.edge;
  material.size_length = lengths.size;
  return material;
}

forms::SteadyCut cut_of(const Material& m) {
  forms::SteadyCut cut{m.specific_cutting_energy, m.cutting_ratio, kSpin, kFeed, m.edge_pressure};
  cut.tooth_rate = tooth_rate(kCutter, kSpin);
  cut.edge_length = m.edge_length;
  cut.size_length = m.size_length;
  return cut;
}

SimulationConfig stiff(double stiffness) {
  SimulationConfig config;
  config.reference_stiffness = stiffness;
  return config;
}

/// Drilled down its axis in a hole of its own radius.
Fed drill(const Way& way, double stiffness, const Material& material) {
  const Vec3 axis = way.R_WT.col(2);
  Simulation simulation(
      build_block({Vec3::Constant(-2.2 * mm), Vec3::Constant(2.2 * mm)}, kVoxel, material),
      Tool(FlatHead{kRadius, 8 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}, kCutter),
      stiff(stiffness));
  const Vec3 deep = axis * 0.3 * mm + Vec3(0.017, 0.006, 0.003) * mm;
  (void)feed_along(simulation, way.R_WT, deep + axis * 4 * mm, -axis * 20 * mm, 4 * mm, 1);
  return feed_along(simulation, way.R_WT, deep, -axis * kFeed, 0.5 * mm, 0.3);
}

/// On a soft foundation chips are so thin that a step takes less of a voxel than single precision tells from nothing:
/// there the work that is done is rubbed.
TEST(Chips, LoseNoWorkWhereAStepTakesLessThanSinglePrecisionHolds) {
  for (const double dt : {1e-3, 1e-4}) {
    Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, kVoxel, presets::trabecular_bone()),
                          Tool(ConeHead{units::kPi / 6, 1.5 * mm}, RayHandle{0}, common_spindle(40000 * units::rpm)),
                          stiff(1.3e12));
    const double feed = 4 * mm, deep = 0.8 * mm;
    const int ticks = int(0.4 / dt);
    for (int tick = 1; tick <= ticks; ++tick) {
      const double depth = std::min(feed * tick * dt, deep);
      const Twist down{Vec3(0, 0, depth < deep ? -feed : 0), Vec3::Zero()};
      (void)simulation.step(Pose::from_translation(Vec3(0, 0, -depth)), down, dt);
    }
    const EnergyLedger& energy = simulation.last_result().energy;
    EXPECT_GT(energy.turnover, 1e-4);
    EXPECT_LT(std::abs(energy.closure()), 1e-4) << dt;
    EXPECT_LT(energy.credited, 1e-4 * energy.turnover) << dt;
  }
}

// Proves: chips; energy ledger.
TEST(Chips, C35DrillingInEveryDirectionOfTheGridAtAnyStiffness) {
  for (const Lengths& lengths : kLengths)
    for (const Way& way : kWays)
      for (const double stiffness : {1e15, 1e16, 1e17}) {
        const Material material = material_with(lengths);
        const Fed s = drill(way, stiffness, material);
        const Wrench expected = forms::axial_chip_wrench(cut_of(material), kRadius);
        SCOPED_TRACE(std::string(lengths.name) + ", " + way.name + ", k_v " + std::to_string(stiffness));
        EXPECT_NEAR(s.force_T.z() / expected.force.z(), 1, kMean);
        EXPECT_NEAR(s.torque_T.z() / expected.torque.z(), 1, kMean);
        EXPECT_LT(s.ripple_T.z() / expected.force.z(), kRipple);
        EXPECT_LT(fixtures::unbooked(s.energy), 1e-5);
      }
}

// Proves: chips.
TEST(Chips, C37Slotting) {
  const double height = 0.4 * mm;
  for (const Lengths& lengths : kLengths)
    for (const double angle : {0.0, 29.0, 45.0})
      for (const double stiffness : {1e15, 1e16, 1e17}) {
        const Vec3 way(std::cos(angle * units::deg), std::sin(angle * units::deg), 0);
        const Mat3 R = Eigen::AngleAxisd(angle * units::deg, Vec3::UnitZ()).toRotationMatrix();
        const Material material = material_with(lengths);
        Simulation simulation(build_block({Vec3(-3, -3, -height / mm) * mm, Vec3(3, 3, 0) * mm}, kVoxel, material),
                              Tool(FlatHead{kRadius, 4 * mm, FlatRule::side_only}, RayHandle{0},
                                   Spindle{kSpin * units::rad_per_s}, kCutter),
                              stiff(stiffness));
        const Vec3 start = Vec3(0.017, 0.006, -1.503) * mm - 0.5 * mm * way;
        (void)feed_along(simulation, R, start - way * 4 * mm, way * 20 * mm, 4 * mm, 1);
        const Fed s = feed_along(simulation, R, start, way * kFeed, 1.6 * mm, 0.4);
        const Wrench expected = forms::slotting_chip_wrench(cut_of(material), kRadius, height);
        SCOPED_TRACE(std::string(lengths.name) + ", " + std::to_string(angle) + " deg, k_v " +
                     std::to_string(stiffness));
        EXPECT_NEAR(s.force_T.x() / expected.force.x(), 1, kSlot);
        EXPECT_NEAR(s.force_T.y() / expected.force.y(), 1, kSlot);
        // Behind the middle the slot's walls press with what is too little to cut them, a layer of w0, and rub.
        const double rubs = lengths.edge > 0 ? 0.07 : kMean;
        EXPECT_NEAR(s.torque_T.z() / expected.torque.z(), 1, stiffness < 1e17 ? rubs : kSlot);
        EXPECT_LT(s.ripple_T.x() / std::abs(expected.force.x()), kRipple);
      }
}

// Proves: chips.
TEST(Chips, C38PlungingABall) {
  for (const Lengths& lengths : kLengths)
    for (const double stiffness : {1e16, 1e17}) {
      const Material material = material_with(lengths);
      Simulation simulation(build_block({Vec3(-1.6, -1.6, -3.5) * mm, Vec3(1.6, 1.6, 0) * mm}, kVoxel, material),
                            Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}, kCutter),
                            stiff(stiffness));
      const Vec3 start = Vec3(0.017, 0.006, 1.003) * mm;
      (void)feed_along(simulation, Mat3::Identity(), start, Vec3(0, 0, -20 * mm), 2.4 * mm, 1);
      const Fed s =
          feed_along(simulation, Mat3::Identity(), start - Vec3(0, 0, 2.4 * mm), Vec3(0, 0, -kFeed), 0.6 * mm, 0.4);
      const Wrench expected = forms::ball_plunge_chip_wrench(cut_of(material), kRadius);
      SCOPED_TRACE(std::string(lengths.name) + ", k_v " + std::to_string(stiffness));
      EXPECT_NEAR(s.force_T.z() / expected.force.z(), 1, kMean);
      EXPECT_NEAR(s.torque_T.z() / expected.torque.z(), 1, lengths.edge > 0 ? 0.06 : kMean);  // the wall rubs, as above
    }
}

// Presets of blades have a size length: what they take of a groove is far from C26.
// Proves: chips.
TEST(Chips, C42AGrooveInBoneIsManyTimesTheOneAtAConstantEnergy) {
  const double depth = 0.5 * mm;
  const Cutter bur = Cutter{CutterKind::carbide_bur};
  for (const double spin : {2000.0, 8000.0}) {
    const Material bone = presets::cortical_bone();
    Simulation simulation(build_block({Vec3(-3.4, -1.6, -1.1) * mm, Vec3(2.6, 1.6, 0) * mm}, kVoxel, bone),
                          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{spin * units::rad_per_s}, bur), {});
    const Vec3 start = Vec3(-3.517 * mm, 0.006 * mm, kRadius - depth);
    const Fed s = feed_along(simulation, Mat3::Identity(), start, Vec3(kFeed, 0, 0), 4 * mm, 0.3);
    forms::SteadyCut cut{bone.specific_cutting_energy, bone.cutting_ratio, spin, kFeed};
    cut.tooth_rate = tooth_rate(bur, spin);
    cut.size_length = bone.size_length;
    const Wrench expected = forms::groove_chip_wrench(cut, kRadius, depth);
    SCOPED_TRACE(spin);
    EXPECT_LT((s.force_T - expected.force).norm(), kLayer * expected.force.norm());
    EXPECT_NEAR(s.torque_T.z() / expected.torque.z(), 1, kSlot);
    EXPECT_GT(expected.force.norm(), 9 * forms::groove_wrench(cut, kRadius, depth).force.norm());
    // The words of EnergyLedger: both hold what thin chips take, without an edge pressure and with removal on.
    const EnergyLedger& spent = s.energy;
    EXPECT_GT(spent.cutting, 5 * bone.specific_cutting_energy * 4 * mm * kRadius * kRadius * 0.5);
    EXPECT_GT(spent.rubbing, 0.2 * spent.motor_work);
  }
}

Simulation pushed_bur(const Material& material, double stiffness) {
  return Simulation(
      build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, kVoxel, material),
      Tool(FlatHead{kRadius, 4 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}, kCutter),
      stiff(stiffness));
}

// Proves: chips.
TEST(Chips, C36APushedToolGoesAsFastAsItsChipsAllow) {
  for (const Lengths& lengths : kLengths)
    for (const double stiffness : {1e15, 1e16, 1e17}) {
      const Material material = material_with(lengths);
      Simulation simulation = pushed_bur(material, stiffness);
      const double hand = forms::axial_chip_wrench(cut_of(material), kRadius).force.z() * 0.9;
      const Pushed s = push_down(simulation, hand);
      const double expected = forms::feed_with_chips_under(s.force, cut_of(material), kRadius);
      SCOPED_TRACE(std::string(lengths.name) + ", k_v " + std::to_string(stiffness));
      EXPECT_NEAR(s.speed / expected, 1, kPushed);
    }
}

// The edges of lips plough with a force of their own: below it nothing is cut, at any speed of the spindle.
TEST(Chips, C36BelowTheForceOfTheEdgesItStands) {
  const Material material = material_with(kLengths[0]);
  forms::SteadyCut edges = cut_of(material);
  edges.feed_speed = 0;
  const double threshold = forms::axial_chip_wrench(edges, kRadius).force.z();
  Simulation simulation = pushed_bur(material, 1e16);
  EXPECT_LT(push_down(simulation, 0.9 * threshold).speed, 0.02 * mm);
}

}  // namespace
}  // namespace hapticut::chips_test
