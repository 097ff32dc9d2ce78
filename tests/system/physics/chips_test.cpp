// SPDX-License-Identifier: Apache-2.0
// Chips in the presets of bone, and where they are too thin for single precision (docs/decisions/0010-chips.md).
#include <gtest/gtest.h>

#include "hapticut/closed_forms.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/cutting.hpp"

namespace hapticut::chips_test {
namespace {

namespace forms = closed_forms;
using test::feed;
using test::SteadyState;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kVoxel = 0.1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
// Measured, [1]: what is left of each is in docs/decisions/0010-chips.md.
constexpr double kSlot = 0.035;  // of a torque
constexpr double kLayer = 0.1;   // of the force in the layer of the default foundation under the pressure of bone

SimulationConfig stiff(double stiffness) {
  SimulationConfig config;
  config.reference_stiffness = stiffness;
  return config;
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
    const SteadyState s = feed(simulation, start, Vec3(kFeed, 0, 0), 4 * mm, 1e-3, 0.3);
    forms::SteadyCut cut{bone.specific_cutting_energy, bone.cutting_ratio, spin, kFeed};
    cut.tooth_rate = tooth_rate(bur, spin);
    cut.size_length = bone.size_length;
    const Wrench expected = forms::groove_chip_wrench(cut, kRadius, depth);
    SCOPED_TRACE(spin);
    EXPECT_LT((s.force - expected.force).norm(), kLayer * expected.force.norm());
    EXPECT_NEAR(s.torque.z() / expected.torque.z(), 1, kSlot);
    EXPECT_GT(expected.force.norm(), 9 * forms::groove_wrench(cut, kRadius, depth).force.norm());
    // The words of EnergyLedger: both hold what thin chips take, without an edge pressure and with removal on.
    const EnergyLedger& spent = s.energy;
    EXPECT_GT(spent.cutting, 5 * bone.specific_cutting_energy * 4 * mm * kRadius * kRadius * 0.5);
    EXPECT_GT(spent.rubbing, 0.2 * spent.motor_work);
  }
}

}  // namespace
}  // namespace hapticut::chips_test
