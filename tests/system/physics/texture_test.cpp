// SPDX-License-Identifier: Apache-2.0
// How much the grain of a material makes the force of a cut vary: C44.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/refusal.hpp"

namespace hapticut::texture_test {
namespace {

using namespace test;
using namespace units;

constexpr double kDeep = 1 * mm, kFast = 10e-3;    // [m/s] feed
constexpr double kFrom = 2 * mm, kUpTo = 38 * mm;  // steady part of the slot
constexpr std::size_t kSeeds = 4;

Material grained(double variation, double length) {
  Material material = plain_material();
  material.grain = variation, material.grain_length = length;
  return material;
}

struct Slot {
  double mean = 0, variation = 0;  // [N], [1] of the force along the feed
  std::vector<double> force;       // [N] at each step
};

/// The force on the side of a cylinder that mills a slot.
Slot mill(const Material& material, std::size_t seed, double voxel = 0.1 * mm, double dt = kTick) {
  SimulationConfig config;
  config.grain = material.grain > 0, config.grain_seed = seed;
  Simulation simulation(build_block({Vec3(0, -1.5 * mm, -2 * mm), Vec3(40 * mm, 1.5 * mm, 0)}, voxel, material),
                        tool_of(cylinder_head(2 * kRadius, 4 * mm), kSpin), config);
  const Pose X_TH = simulation.tool().X_HT().inverse();
  Slot slot;
  double squares = 0;
  for (double x = -1.2 * mm; x < kUpTo; x += kFast * dt) {
    const Pose X_WT = Pose::from_translation(Vec3(x, 0.037 * mm, -kDeep));
    const StepResult& result = simulation.step(X_WT * X_TH, {Vec3(kFast, 0, 0), Vec3::Zero()}, dt);
    if (x < kFrom) continue;
    const double force = -result.force.x();
    slot.force.push_back(force);
    slot.mean += force, squares += force * force;
  }
  const auto count = double(slot.force.size());
  slot.mean /= count;
  slot.variation = std::sqrt(squares / count - slot.mean * slot.mean) / slot.mean;
  return slot;
}

TEST(Texture, VariesTheForceOfASlotAsC44Says) {
  const double even = mill(plain_material(), 1).mean;
  for (const double length : {0.4 * mm, 0.8 * mm})
    for (const double variation : {0.2, 0.4}) {
      double squares = 0, mean = 0;
      for (std::size_t seed = 1; seed <= kSeeds; ++seed) {
        const Slot slot = mill(grained(variation, length), seed);
        squares += slot.variation * slot.variation / kSeeds, mean += slot.mean / kSeeds;
      }
      const double area = closed_forms::cutting_area_of_a_slot(kRadius, kDeep);
      const double expected = closed_forms::grain_variation(variation, length, area);
      // The cells are not small beside the contact, and the layer in which it presses has a thickness.
      EXPECT_GT(std::sqrt(squares), 0.8 * expected) << variation << ", " << length;
      EXPECT_LT(std::sqrt(squares), 1.05 * expected) << variation << ", " << length;
      const double way = kSeeds * (kUpTo - kFrom);
      EXPECT_NEAR(mean / even, 1, 2 * expected * std::sqrt(length / way)) << variation << ", " << length;
    }
}

/// [1] Correlation of the forces along two slots of the same length.
double correlation(const Slot& a, const Slot& b) {
  const std::size_t count = 360;
  double sum = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const auto at = [&](const Slot& slot) { return slot.force[n * slot.force.size() / count] / slot.mean - 1; };
    sum += at(a) * at(b);
  }
  return sum / double(count) / (a.variation * b.variation);
}

TEST(Texture, IsInItsPlaceForEachVoxelSizeAndRate) {
  const Material material = grained(0.4, 0.8 * mm);
  const Slot slot = mill(material, 1);
  EXPECT_GT(correlation(slot, mill(material, 1, 0.2 * mm)), 0.95) << "voxels";
  EXPECT_GT(correlation(slot, mill(material, 1, 0.1 * mm, 2 * kTick)), 0.97) << "rate";
  EXPECT_LT(std::abs(correlation(slot, mill(material, 2))), 0.4) << "seeds";
}

TEST(Texture, BooksEachVolumeAtItsOwnEnergy) {
  SimulationConfig config;
  config.grain = true;
  const Material material = grained(0.4, 0.4 * mm);
  Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, material),
                        tool_of(ToolHead(SphereHead{kRadius}), kSpin), config);
  feed(simulation, {0.013 * mm, 0.021 * mm, 1.1 * mm}, {0, 0, -kFeed}, 1.5 * mm, kTick);
  const EnergyLedger& energy = simulation.last_result().energy;
  EXPECT_LT(unbooked(energy), 1e-6);
  const double even = material.specific_cutting_energy * simulation.totals().removed_volume[1];
  EXPECT_NEAR(energy.cutting / even, 1, 0.15);
  EXPECT_GT(std::abs(energy.cutting / even - 1), 1e-3) << "the cells that were cut are not the mean of all";
}

TEST(Texture, IsForTheDefaultLawOnly) {
  SimulationConfig config;
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  config.grain = true;
  test::expect_refused(
      [&] {
        Simulation(build_block({Vec3(0, 0, -2) * mm, Vec3(2, 2, 0) * mm}, 0.2 * mm, plain_material()),
                   tool_of(ToolHead(SphereHead{kRadius}), kSpin), config);
      },
      {"SimulationConfig::grain", "FoundationLaw"});
}

}  // namespace
}  // namespace hapticut::texture_test
