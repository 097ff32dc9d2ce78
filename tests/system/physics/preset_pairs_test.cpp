// SPDX-License-Identifier: Apache-2.0
// How each cutter behaves in each material, as a hand meets it: behind the default coupling, with the motor of a usual
// handpiece. docs/measurements.md has the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/pairs.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::preset_pairs_test {
namespace {

using experiments::push;
using experiments::PushedCut;
using experiments::usual_tool;
using units::kPi;
using units::mm;
using units::rpm;
using enum CutterKind;

constexpr std::array kLoads = {0.2, 1.0, 2.0, 5.0, 10.0};  // [N]
constexpr double kNone = 1e-12;                            // [m^3/s] a rate that counts as none: 1e-3 mm^3/s
constexpr double kScatter = 0.05;                          // [1] of rates that have not settled
constexpr double kEqual = 0.01;                            // [1] of rates over the same way
constexpr double kUntilSteady = 10;                        // [s] longest

constexpr StepStatus kMotorAtLimit = StepStatus::power_limited | StepStatus::spindle_stalled;

const auto& kinds() {
  static const auto names = names_of(Of<CutterKind>{});
  return names;
}

bool has_blades(CutterKind kind) { return kind == carbide_bur || kind == mastoid_cutting_bur; }

double share_of(const std::string& material) {
  const PresetConstant* share = find_constant(material, "share");
  return share == nullptr ? 0 : share->typical;
}

/// A cut with the usual tool, computed once.
const PushedCut& cut_of(CutterKind kind, const std::string& material, double load) {
  static std::map<std::tuple<CutterKind, std::string, double>, PushedCut> cuts;
  const auto [found, fresh] = cuts.try_emplace({kind, material, load});
  if (fresh) found->second = push(usual_tool(kind), find_preset(material, kind), load);
  return found->second;
}

/// A cut of a spindle that keeps its speed.
PushedCut cut_at_speed(CutterKind kind, const std::string& material, double load, AngularSpeed speed = {}) {
  return push(usual_tool(kind, 1 * mm, speed, MotorKind::ideal), find_preset(material, kind), load, kUntilSteady);
}

std::string at(const char* kind, const std::string& material, double load) {
  return std::string(kind) + " in " + material + ", " + std::to_string(load) + " N";
}

// 1.
TEST(PresetPairs, KeepTheOrderOfTheMaterialsUnderEveryCutterAndLoad) {
  const std::vector<std::vector<std::string>> orders = {
      {"enamel", "amalgam", "dentin", "caries", "trabecular_bone", "pulp", "clay"},
      {"dentin", "cortical_bone"},
      {"cortical_bone", "dentin"},
      {"bone_d1", "bone_d2", "bone_d3", "bone_d4", "bone_d5"}};
  int compared = 0;
  for (const auto& kind : kinds())
    for (const double load : kLoads)
      for (const auto& order : orders)
        for (std::size_t n = 1; n < order.size(); ++n) {
          const PushedCut &harder = cut_of(kind.value, order[n - 1], load),
                          &softer = cut_of(kind.value, order[n], load);
          if (has_any(harder.status | softer.status, kMotorAtLimit)) continue;  // then the speeds differ
          ++compared;
          EXPECT_GE(softer.rate, (1 - kScatter) * harder.rate - kNone)
              << at(kind.name, order[n], load) << " after " << order[n - 1];
        }
  EXPECT_GT(compared, 250);
}

// 2.
TEST(PresetPairs, CutAsOneOverTheShareAtAFixedSpeed) {
  for (const auto& kind : kinds()) {
    if (kind.value == twist_drill) continue;
    const double dentin = cut_at_speed(kind.value, "dentin", 1).rate;
    for (const char* material : {"enamel", "amalgam", "caries", "bone_d2"})
      EXPECT_NEAR(cut_at_speed(kind.value, material, 1).rate * share_of(material), dentin, kEqual * dentin)
          << at(kind.name, material, 1);
  }
}

// 3.
TEST(PresetPairs, CutInProportionToTheSpeed) {
  for (const auto& kind : kinds()) {
    const AngularSpeed usual = usual_tool(kind.value).spindle().speed;
    const double load = kind.value == twist_drill ? 9 : 1;
    const double fast = cut_at_speed(kind.value, "dentin", load, usual).rate,
                 slow = cut_at_speed(kind.value, "dentin", load, 0.5 * usual).rate;
    EXPECT_NEAR(2 * slow, fast, kEqual * fast) << kind.name;
  }
}

// 4.
TEST(PresetPairs, LetADrillCutFromTheLoadThatItsEdgesCarry) {
  constexpr double kRadius = 1 * mm, kSpeed = 1500 * rpm;
  const struct {
    Sharpness sharpness;
    double threshold, edge;  // [N], [m]
  } grades[] = {{Sharpness::new_, 2, 6e-6}, {Sharpness::used, 6, 18e-6}, {Sharpness::worn, 15, 45e-6}};
  for (const auto& grade : grades) {
    const Material bone = presets::cortical_bone(twist_drill, grade.sharpness);
    EXPECT_NEAR(bone.specific_cutting_energy * kRadius * 2 * bone.edge_length / bone.cutting_ratio, grade.threshold,
                1e-9);
    const PushedCut below = push(usual_tool(twist_drill), bone, 0.8 * grade.threshold);
    EXPECT_LT(below.rate, kNone) << grade.threshold;
    EXPECT_TRUE(has_any(below.status, StepStatus::edges_carry_load)) << grade.threshold;
    EXPECT_NEAR(below.load_to_cut, grade.threshold, 1e-3 * grade.threshold);
    const PushedCut above = push(usual_tool(twist_drill), bone, 1.5 * grade.threshold, kUntilSteady);
    EXPECT_FALSE(has_any(above.status, StepStatus::edges_carry_load)) << grade.threshold;
    // The chip is thinner than the feed of a lip, because the point is a cone.
    const double chip = (above.force / grade.threshold - 1) * grade.edge;
    const double speed = chip / std::sin(kCommonDrillPoint / 2) * 2 * kSpeed / (2 * kPi);
    EXPECT_NEAR(above.speed, speed, 0.07 * speed) << grade.threshold;
  }
  const PushedCut bur = cut_of(carbide_bur, "cortical_bone", 1);
  EXPECT_EQ(bur.load_to_cut, 0);
  EXPECT_FALSE(has_any(bur.status, StepStatus::edges_carry_load));
}

// 5.
TEST(PresetPairs, GrowWithTheSquareOfTheLoadUnderBladesAndInProportionUnderGrains) {
  for (const auto& kind : kinds()) {
    if (kind.value == twist_drill) continue;
    for (const char* material : {"enamel", "dentin", "caries", "cortical_bone"}) {
      const double low = 0.5, high = 1;  // [N] the speed is constant, as that of a motor far from its limit
      const PushedCut light = cut_at_speed(kind.value, material, low), heavy = cut_at_speed(kind.value, material, high);
      const double exponent = std::log(heavy.rate / light.rate) / std::log(heavy.force / light.force);
      const bool blades = has_blades(kind.value);
      EXPECT_GE(exponent, blades ? 1.9 : 0.95) << at(kind.name, material, high);
      EXPECT_LE(exponent, blades ? 2.1 : 1.1) << at(kind.name, material, high);
    }
  }
}

// 6.
TEST(PresetPairs, LetACuttingBurThroughBoneFasterThanADiamondFromTwoNewtonsOn) {
  const auto rate = [](CutterKind kind, double radius, double load) {
    return push(usual_tool(kind, radius), presets::cortical_bone(kind), load).rate;
  };
  for (const double radius : {1 * mm, 1.75 * mm, 2.5 * mm}) {
    for (const double load : {2.0, 5.0})
      EXPECT_GT(rate(mastoid_cutting_bur, radius, load), rate(mastoid_diamond_bur, radius, load))
          << radius << " m, " << load << " N";
    EXPECT_LT(rate(mastoid_cutting_bur, radius, 0.25), rate(mastoid_diamond_bur, radius, 0.25)) << radius << " m";
  }
  const double faster = rate(mastoid_cutting_bur, 2.5 * mm, 5) / rate(mastoid_diamond_bur, 2.5 * mm, 5);
  EXPECT_GE(faster, 1.5);
  EXPECT_LE(faster, 4);
}

// 7.
TEST(PresetPairs, SayThatTheMotorIsAtItsLimitWhereMoreLoadRemovesLess) {
  int slower = 0;
  for (const auto& kind : kinds())
    for (const std::string_view material : preset_names())
      for (std::size_t n = 1; n < kLoads.size(); ++n) {
        const PushedCut& light = cut_of(kind.value, std::string(material), kLoads[n - 1]);
        const PushedCut& heavy = cut_of(kind.value, std::string(material), kLoads[n]);
        if (!(heavy.rate < (1 - kScatter) * light.rate)) continue;
        ++slower;
        EXPECT_TRUE(has_any(heavy.status, kMotorAtLimit))
            << at(kind.name, std::string(material), kLoads[n]) << ": " << describe(heavy.status);
      }
  EXPECT_GT(slower, 10) << "a turbine stalls below 10 N";
}

// 8.
TEST(PresetPairs, LetNoDrillTakeChipsThickerThanATenthOfItsDiameter) {
  constexpr double kFastest = 0.1 * 2 * mm * 2 * 1500 / 60;  // [m/s] .1 D z n/60
  for (const char* material : {"trabecular_bone", "bone_d4", "bone_d5", "pulp", "clay"}) {
    double last = 0;
    for (const double load : kLoads) {
      const PushedCut& cut = cut_of(twist_drill, material, load);
      EXPECT_GE(cut.speed, (1 - kScatter) * last) << load << " N in " << material;
      if (has_any(cut.status, StepStatus::material_crushed)) continue;  // pressed in, not cut
      EXPECT_LE(cut.speed, kFastest) << load << " N in " << material;
      last = cut.speed;
    }
  }
}

// 9.
TEST(PresetPairs, HoldABallInPulpAndClay) {
  for (const char* material : {"pulp", "clay"})
    for (const CutterKind kind : {carbide_bur, coarse_diamond, mastoid_cutting_bur}) {
      EXPECT_LT(cut_of(kind, material, 1).speed, 50 * mm) << material;
      EXPECT_LT(cut_of(kind, material, 2).speed, 100 * mm) << material;
      EXPECT_GT(cut_of(kind, material, 2).speed, 1.5 * cut_of(kind, material, 1).speed)
          << "the force grows with the speed";
    }
}

// 10.
TEST(PresetPairs, CutNoFasterThanThePowerOfTheMotorPaysFor) {
  for (const auto& kind : kinds())
    for (const std::string_view material : preset_names())
      for (const double load : kLoads) {
        const Spindle spindle = usual_tool(kind.value).spindle();
        const double speed = std::abs(spindle.speed);
        const double most = spindle.droop > 0 ? speed * speed / (4 * spindle.droop)
                                              : std::min(spindle.power_limit, speed * spindle.torque_limit);
        const double of_rotor = 0.5 * spindle.rotor_inertia * speed * speed;  // [J] while a tool falls through
        const PushedCut& cut = cut_of(kind.value, std::string(material), load);
        EXPECT_LE(cut.power * cut.time, 1.02 * (most * cut.time + of_rotor))
            << at(kind.name, std::string(material), load);
      }
}

}  // namespace
}  // namespace hapticut::preset_pairs_test
