// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/sentence.hpp"
#include "hapticut/simulation/simulation.hpp"

/// @file
/// What the reports of `drill` and `loop` both warn of.
namespace hapticut::apps {

/// Names of the materials, by the kind of cutter that their constants are for; without those that suit every cutter.
using NamesByCutter = std::map<CutterKind, std::vector<std::string>>;
[[nodiscard]] NamesByCutter names_by_cutter(const MaterialTable& materials);

/// "dentin, enamel", or the number of names if they are many.
[[nodiscard]] std::string text_of_names(const std::vector<std::string>& names);

/// Warnings of a cutter that is unusual for the head, and of touched materials with constants for another cutter.
[[nodiscard]] std::vector<Sentence> warnings_of_cutter(const Simulation& simulation);

/// Warning of a force that no hand gives; nullopt below it.
/// @param force  [N] maximum of the run
[[nodiscard]] std::optional<Sentence> warning_of_force(double force);

/// What a drill does to the touched materials, of the dearest one.
struct BluntEdges {
  double load = 0;              ///< [N] that the edges carry without a chip
  double feed = 0;              ///< [m/s] twice that above which StepStatus::edges_carry_load ends
  bool can_be_sharper = false;  ///< whether tool.sharpness would change a material
};
[[nodiscard]] BluntEdges blunt_edges(const Simulation& simulation);

/// ", or take a sharper drill (--sharpness new)"; empty if that changes nothing.
[[nodiscard]] Sentence sharper_drill(const BluntEdges& edges);

struct MotorAdvice {
  Sentence limits;  ///< "the motor gives at most 4 Nmm and 60 W, which are 1.9 Nmm at 300000 rpm"
  Sentence cure;    ///< ", or raise tool.power_limit_W"
};
[[nodiscard]] MotorAdvice advice_on_motor(const Spindle& spindle);

inline constexpr const char* kCureOfCrushing = "press less, feed slower, or let the head turn faster.";

}  // namespace hapticut::apps
