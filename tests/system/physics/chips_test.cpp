// SPDX-License-Identifier: Apache-2.0
// Chips that are too thin for single precision (docs/decisions/0010-chips.md).
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::chips_test {
namespace {

using namespace test;
using units::mm;

/// On a soft foundation chips are so thin that single precision cannot represent the loss of a voxel in a step. The
/// work is then booked as rubbing.
TEST(Chips, LoseNoWorkWhereAStepTakesLessThanSinglePrecisionHolds) {
  for (const double dt : {1e-3, 1e-4}) {
    Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, kVoxel, presets::trabecular_bone()),
                          Tool(ConeHead{units::kPi / 6, 1.5 * mm}, RayHandle{0}, common_spindle(40000 * units::rpm)),
                          on_foundation(1.3e12));
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

}  // namespace
}  // namespace hapticut::chips_test
