// SPDX-License-Identifier: Apache-2.0
// How much the grain of a material makes the force of a cut vary, C44, and how long a hole takes in it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/grain.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/simulation/coupling.hpp"
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

/// [s] Time in which a constant force drives a flat head through cells of 1.6 mm, each wider than the head.
/// @param expected  [s] from the speed of C36 with the energy of each cell
double time_of_a_hole(Material material, std::size_t seed, double& expected) {
  constexpr double kEdge = 1.6 * mm, kNarrow = 0.3 * mm, kForce = 3.6, kFirst = -1.6 * mm, kLast = -9.6 * mm;
  material.grain_length = kEdge;
  SimulationConfig config;
  config.grain = material.grain > 0, config.grain_seed = seed;
  config.contact_time = ContactTime::end;
  const Tool tool(ToolHead(FlatHead{kNarrow, 4 * mm}), RayHandle{0}, Spindle{80e3 * rpm});
  Simulation simulation(build_block({Vec3(0.2, 0.2, -11) * mm, Vec3(1.4, 1.4, 0) * mm}, kVoxel, material), tool,
                        config);
  Grain grain;
  grain.set(contact_materials(simulation.workpiece().materials(), 1e12), simulation.workpiece().frame(), seed);
  closed_forms::SteadyCut cut = {0, material.cutting_ratio, tool.spindle().speed, 1};
  cut.tooth_rate = tooth_rate(tool.cutter(), cut.spin), cut.size_length = material.size_length;
  expected = 0;
  for (double z = kFirst - kEdge / 2; z > kLast; z -= kEdge) {
    const Vec3 voxel = simulation.workpiece().frame().X_WV.inverse() * Vec3(0.8 * mm, 0.8 * mm, z) / kVoxel;
    const auto along = [&](int axis) { return int(std::lround(voxel[axis])); };
    cut.specific_cutting_energy =
        material.specific_cutting_energy * double(grain.at(1, {along(0), along(1), along(2)}));
    expected += kEdge / closed_forms::feed_with_chips_under(kForce, cut, kNarrow);
  }
  const CouplingGains gains;
  VirtualCoupling coupling(simulation, gains);
  double z = 0.01 * mm, time = 0;
  coupling.step(Pose::from_translation({0.813 * mm, 0.821 * mm, z}), {}, kTick);
  while (z > kLast && time < 10) {
    const Pose hand = Pose::from_translation({0.813 * mm, 0.821 * mm, z - kForce / gains.stiffness});
    z = coupling.step(hand, coupling.last_result().V_WH, kTick).X_WH.translation.z();
    if (z < kFirst) time += kTick;
  }
  return time;
}

TEST(Texture, MakesAHoleOfBladesLongerAsTheSquareOfTheEnergy) {
  Material blades = plain_material(), grains = plain_material();
  blades.specific_cutting_energy = 1e8, blades.size_length = 0.18 * mm;
  grains.specific_cutting_energy = 2e9;
  /// [1] Mean time of holes in grained over that in even material; each is compared with that of its cells.
  const auto longer = [](Material material, double error) {
    double expected_even = 0, sum = 0;
    const double even = time_of_a_hole(material, 1, expected_even);
    EXPECT_NEAR(even / expected_even, 1, 0.08) << "the layer in which it presses has a thickness";
    material.grain = 0.4;
    constexpr std::size_t kHoles = 4;
    for (std::size_t seed = 1; seed <= kHoles; ++seed) {
      double expected = 0;
      const double ratio = time_of_a_hole(material, seed, expected) / even;
      EXPECT_NEAR(ratio / (expected / expected_even), 1, error) << seed;
      sum += ratio;
    }
    return sum / kHoles;
  };
  EXPECT_GT(longer(blades, 0.08), 1.15 * longer(grains, 0.01));
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
