// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/catalogue_heads.hpp"
#include "support/composed_invariants.hpp"
#include "support/sanitizers.hpp"

/// Pieces, tools, gains and configurations drawn from a seed, for random sequences, and the number of sequences to run.
namespace hapticut::test {

inline int below(int n, RandomPoses& random) { return std::min(n - 1, int(random.between(0, n))); }

inline MaterialTable some_materials(RandomPoses& random) {
  const auto one_of = [&](std::vector<Material> some) { return some[std::size_t(below(int(some.size()), random))]; };
  std::vector<Material> table;  // drawn in this order
  table.push_back(one_of({presets::cortical_bone(), presets::enamel(), presets::clay()}));
  table.push_back(presets::dentin());
  table.push_back(one_of({presets::trabecular_bone(), presets::pulp()}));
  for (Material& material : table) {
    material.relative_stiffness *= random.between(0.5, 2);
    material.cutting_ratio *= random.between(0.5, 1.5);
  }
  return MaterialTable(table);
}

/// Plates of three materials with a step 1 mm deep, with edges, corners and thin parts.
inline Workpiece some_piece(double voxel, RandomPoses& random) {
  const double step = random.between(-1, 1) * units::mm;
  return build_body({{Vec3(-4.03 * units::mm, -4.01 * units::mm, -4.07 * units::mm),
                      Vec3(4.02 * units::mm, 4.04 * units::mm, 0.03 * units::mm)},
                     [=](const Vec3& p) {
                       const double block = std::max({std::abs(p.x()) - 4 * units::mm, std::abs(p.y()) - 4 * units::mm,
                                                      std::abs(p.z() + 2 * units::mm) - 2 * units::mm});
                       const double cut_out = std::min(p.x() - step, p.z() + 1 * units::mm);
                       return std::max(block, cut_out);
                     },
                     [](const Vec3& p) {
                       return MaterialId(p.z() > -0.7 * units::mm ? 1 : p.y() > 0 ? 2 : 3);
                     }},
                    voxel, some_materials(random), 2);
}

inline Spindle some_spindle(RandomPoses& random) {
  switch (below(5, random)) {
    case 0:
      return common_spindle(random.between(100e3, 400e3) * units::rpm);
    case 1:
      return common_spindle(MotorKind::surgical_drill, random.between(5e3, 80e3) * units::rpm);
    case 2: {
      Spindle weak{random.between(2e3, 40e3) * units::rpm};
      weak.power_limit = random.between(0.02, 2);
      weak.torque_limit = random.between(0.1, 2) * units::N_mm;
      return weak;
    }
    case 3: {
      Spindle ideal{random.between(-40e3, 40e3) * units::rpm};
      if (below(2, random) == 0) ideal.acceleration_limit = 1e4;
      return ideal;
    }
    default:
      return common_spindle(random.between(1e3, 60e3) * units::rpm);
  }
}

/// A head of the catalogue with its usual dimensions.
inline const ToolHead& usual_head(RandomPoses& random) {
  static const std::vector<ToolHead> all = [] {
    std::vector<ToolHead> heads;
    for (const CatalogueHead& head : catalogue_heads()) heads.push_back(head.make());
    heads.emplace_back(FlatHead{1 * units::mm, 3 * units::mm});
    return heads;
  }();
  return all[std::size_t(below(int(all.size()), random))];
}

inline Tool some_tool(RandomPoses& random) {
  const Handle handle =
      below(2, random) == 0 ? Handle(RayHandle{0}) : Handle(RayHandle{random.between(0, 25) * units::mm});
  const double diameter = random.between(1.2, 3) * units::mm;
  const auto head = [&]() -> ToolHead {
    switch (below(9, random)) {
      case 0:
        return cylinder_head(diameter, 4 * units::mm);
      case 1:
        return round_end_tapered_head(0.6 * diameter, diameter, 4 * units::mm);
      case 2:
        return twist_drill_head(diameter, 5 * units::mm);
      case 3:
        return pear_head(diameter, 2 * diameter, 0.6 * diameter);
      case 4:
        return round_head(diameter);
      case 5:
        return SphereHead{diameter / 2};
      default:
        return usual_head(random);
    }
  };
  return Tool{head(), handle, some_spindle(random)};  // braces: every compiler keeps this order of evaluation
}

inline CouplingGains some_gains(bool turns, RandomPoses& random) {
  const char* const kFour[] = {"touch", "premium15", "premium6dof", "omega"};
  CouplingGains gains = coupling_gains(capabilities(device_model(kFour[below(4, random)])));
  gains.angular_stiffness = turns ? random.between(0.5, 3) : 0;
  gains.angular_damping = turns ? 2 * std::sqrt(gains.angular_stiffness * gains.inertia) : 0;
  if (turns) gains.max_torque = random.between(0.05, 0.3);
  if (below(4, random) == 0) gains.max_force = random.between(0.5, 40);
  if (below(4, random) == 0) gains.newton_steps = 8;
  return gains;
}

inline SimulationConfig some_config(RandomPoses& random) {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  if (below(3, random) == 0) config.reference_stiffness = std::pow(10, random.between(13, 15));
  if (below(3, random) == 0) config.contact_damping = random.between(0, 500);
  if (below(5, random) == 0) config.voxel_budget = 4096;
  config.reserved_blocks = 4096;
  return config;
}

inline std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

inline const std::uint64_t kFewTicks = kWithAddressSanitizer ? 2500 : 5000;
inline std::uint64_t many_ticks() {
  return number_from("HAPTICUT_COMPOSED_TICKS", kWithAddressSanitizer ? 100000 : 1000000);
}

/// Runs sequences with different seeds until a number of ticks is reached.
/// @tparam Run    constructed from a seed; run(ticks) tells whether the invariants hold, what_is_broken() names a
/// broken one
template <class Run>
Margins compose(std::uint64_t ticks) {
  constexpr std::uint64_t kTicks = 2500;  // ticks of one sequence
  Margins margins;
  int failures = 0;
  std::uint64_t seed = number_from("HAPTICUT_COMPOSED_SEED", 1);
  for (std::uint64_t done = 0; done < ticks && failures < 10; done += kTicks, ++seed) {
    Run run(seed);
    if (!run.run(int(std::min(kTicks, ticks - done)))) {
      ++failures;
      ADD_FAILURE() << "seed " << seed << ": " << run.what_is_broken();
    }
    margins.add(run.margins());
  }
  testing::Test::RecordProperty("composed", margins.in_words());
  std::cout << margins.in_words() << "\n";
  EXPECT_LE(margins.all_entered, 1e-3 * margins.all_turnover) << "energy from nothing";
  EXPECT_GT(margins.cutting * 100, margins.ticks) << "too few ticks cut to test the invariants";
  return margins;
}

/// Runs the sequence of a seed twice.
template <class Run>
void expect_the_same_bits(std::uint64_t seed, int ticks) {
  Run once(seed), again(seed);
  once.run(ticks);
  again.run(ticks);
  EXPECT_EQ(once.hash(), again.hash()) << "seed " << seed;
}

}  // namespace hapticut::test
