// SPDX-License-Identifier: Apache-2.0
// Materials whose crushing depth is far thinner than a voxel: what can be cut is not crushed, and no energy appears.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/catalogue_heads.hpp"

namespace hapticut::soft_material_test {
namespace {

using namespace units;

struct Plunge {
  EnergyLedger energy;
  double force = 0;  // [N] mean after half of the depth
};

/// A head that is driven straight down into a block.
/// @param spindle  [rpm]
Plunge plunge(const ToolHead& head, const Material& material, double speed, double spindle, ContactTime time,
              double voxel, double rate, double depth = 1.5 * mm) {
  SimulationConfig config;
  config.contact_time = time;
  config.max_sweep = 256;
  Simulation simulation(build_block({Vec3(-2.5, -2.5, -3.5) * mm, Vec3(2.5, 2.5, 0) * mm}, voxel, material),
                        Tool(head, RayHandle{30 * mm}, common_spindle(spindle * rpm)), config);
  const Pose X_TH = simulation.tool().X_HT().inverse();
  const double dt = 1 / rate;
  double height = head.reach() + 0.1 * mm, down = 0;  // height of the tool's origin; way since the first contact
  Plunge seen;
  int ticks = 0;
  while (down < depth) {
    height -= speed * dt;
    const Twist V_WH{Vec3(0, 0, -speed), Vec3::Zero()};
    const StepResult& result = simulation.step(Pose::from_translation(Vec3(0, 0, height)) * X_TH, V_WH, dt);
    if (down > 0 || result.contact.voxels > 0) down += speed * dt;
    if (down < depth / 2) continue;
    seen.force += result.force.z();
    ++ticks;
  }
  seen.force /= std::max(1, ticks);
  seen.energy = simulation.last_result().energy;
  return seen;
}

struct Soft {
  const char* name;
  Material material;
};
std::vector<Soft> soft_materials() {
  return {{"clay", presets::clay()}, {"pulp", presets::pulp()}, {"trabecular bone", presets::trabecular_bone()}};
}

TEST(SoftMaterial, GivesNoEnergyToAnyHead) {
  std::vector<test::CatalogueHead> heads = test::catalogue_heads();
  heads.push_back({"sphere", [] { return ToolHead(SphereHead{1 * mm}); }});
  heads.push_back({"flat", [] { return ToolHead(FlatHead{1 * mm, 3 * mm}); }});
  for (const test::CatalogueHead& head : heads) {
    const ToolHead made = head.make();
    for (const Soft& soft : soft_materials())
      for (const double spindle : {0.0, 5000.0, 40000.0})
        for (const double voxel : {0.2 * mm, 0.1 * mm}) {
          const Plunge seen = plunge(made, soft.material, 20 * mm, spindle, ContactTime::end, voxel, 1000);
          EXPECT_LE(std::abs(seen.energy.entered), 1e-3 * seen.energy.turnover)
              << head.name << " in " << soft.name << ", " << spindle << " rpm, voxels of " << voxel;
        }
  }
}

// A step of 1 ms takes the head farther than the crushing depth; at 100 mm/s by a voxel, and then the material beside
// the pole, of which a part is cut and the rest crushed, presses up to a fifth less than in short steps.
TEST(SoftMaterial, PressesAsInShortSteps) {
  struct Case {
    double speed, spindle, tolerance;
  };
  for (const Soft& soft : soft_materials())
    for (const Case& c : {Case{20 * mm, 1000, 0.1}, Case{20 * mm, 40000, 0.1}, Case{100 * mm, 5000, 0.2}})
      for (const ContactTime time : {ContactTime::end, ContactTime::middle}) {
        const auto at = [&](double rate) {
          return plunge(SphereHead{1 * mm}, soft.material, c.speed, c.spindle, time, 0.1 * mm, rate).force;
        };
        const double fine = at(40000);
        EXPECT_NEAR(at(1000), fine, c.tolerance * fine)
            << soft.name << ", " << c.speed << " m/s, " << c.spindle << " rpm";
      }
}

// Where the head cuts, only the cap around the pole of the ball is crushed, which large voxels do not resolve.
TEST(SoftMaterial, IsCrushedAsMuchInSmallVoxelsAsInLargeOnes) {
  for (const Soft& soft : soft_materials())
    for (const double spindle : {0.0, 1000.0, 5000.0, 40000.0}) {
      const auto energy = [&](double voxel) {
        return plunge(SphereHead{1 * mm}, soft.material, 20 * mm, spindle, ContactTime::end, voxel, 1000).energy;
      };
      const EnergyLedger fine = energy(0.05 * mm);
      // Of clay under a slow spindle the cap has a radius of 0.25 mm.
      for (const auto& [voxel, of_all] : {std::pair(0.2 * mm, 0.05), std::pair(0.1 * mm, 0.02)})
        EXPECT_NEAR(energy(voxel).crushed, fine.crushed, 0.1 * fine.crushed + of_all * (fine.crushed + fine.cutting))
            << soft.name << ", " << spindle << " rpm, voxels of " << voxel;
    }
}

TEST(SoftMaterial, IsCutAndNotCrushedByAFastSpindle) {
  for (const Soft& soft : {Soft{"clay", presets::clay()}, Soft{"pulp", presets::pulp()}}) {
    const EnergyLedger energy =
        plunge(SphereHead{1 * mm}, soft.material, 20 * mm, 40000.0, ContactTime::end, 0.2 * mm, 1000).energy;
    EXPECT_GT(energy.cutting, 0) << soft.name;
    EXPECT_LT(energy.crushed, 0.01 * energy.cutting) << soft.name;
  }
}

/// [m^3] What the rim of a standing cylinder crushes that slides over clay, at 0.8 of the crushing depth and 20 mm/s.
double crushed_by_rim(double rate) {
  const double speed = 20 * mm, dt = 1 / rate;
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  const Material clay = presets::clay();
  Simulation simulation(build_block({Vec3(-2, -1.5, -0.5) * mm, Vec3(3, 1.5, 0) * mm}, 0.1 * mm, clay),
                        Tool(cylinder_head(2 * mm, 3 * mm), RayHandle{0}, Spindle{}), config);
  const double depth = 0.8 * std::sqrt(2 * clay.compressive_strength /
                                       (clay.relative_stiffness * simulation.config().reference_stiffness));
  double crushed = 0;
  Pose at = Pose::from_translation(Vec3(-0.7 * mm, 0, 0.1 * mm));
  const auto go = [&](const Vec3& by) {
    const int steps = int(std::lround(by.norm() / (speed * dt)));
    for (int n = 0; n < steps; ++n) {
      at.translation += by / steps;
      crushed += simulation.step(at, {by / (steps * dt), Vec3::Zero()}, dt).removed_volume;
    }
  };
  go(Vec3(0, 0, -0.1 * mm - depth));
  go(Vec3(2 * mm, 0, 0));
  return crushed;
}

// At 1 kHz the rim moves by the depth at which it crushes. Without sub-steps it crushed 0.42, 0.70 and 0.90 of it.
TEST(SoftMaterial, IsCrushedByARimAsInShortSteps) {
  const double fine = crushed_by_rim(4000);
  EXPECT_GT(fine, 0.05 * mm * mm * mm);
  EXPECT_NEAR(crushed_by_rim(500), fine, 0.12 * fine);
  EXPECT_NEAR(crushed_by_rim(1000), fine, 0.03 * fine);
  EXPECT_NEAR(crushed_by_rim(2000), fine, 0.03 * fine);
  EXPECT_NEAR(crushed_by_rim(32000), fine, 0.12 * fine);
}

}  // namespace
}  // namespace hapticut::soft_material_test
