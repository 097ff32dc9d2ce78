// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "hapticut/loop/commands.hpp"

/// @file
/// Random commands of every kind that a program makes of its fields alone. A new kind is drawn without a line here; a
/// field of a new type needs one.
namespace hapticut::test {

/// Sets fields of a command, by their types.
/// @tparam Between  draws a number: `between(low, high)`
template <class Between>
struct RandomFields {
  const Between& between;

  void set(AngularSpeed& speed) const { speed = between(-5000, 5000) * units::rad_per_s; }
  void set(double& number) const { number *= between(0.7, 1.4); }
  void set(bool& on) const { on = between(0, 4) < 1; }
  void set(RemovalLaw& removal) const { removal = between(0, 4) < 1 ? RemovalLaw::none : RemovalLaw::constant_energy; }
  void set(AxisMask& mask) const { mask.force = {between(0, 8) >= 1, true, between(0, 8) >= 1}; }
  void set(std::optional<DryFriction>& friction) const {
    if (between(0, 2) < 1) friction = DryFriction{0.4, 0.3, 1000};
  }
  void set(Effects& /*effects*/) const {}
};

/// The number of kinds of commands that have a description.
inline constexpr std::size_t kDescribedCommands = [] {
  std::size_t count = 0;
  find_alternative<LoopCommand>([&]<class Command>(std::size_t, Of<Command>) {
    count += Described<Command> ? 1 : 0;
    return false;
  });
  return count;
}();

/// The commands that tests with a case for each command draw without one: described ones behind ExchangeWorkpiece.
inline constexpr std::size_t kFirstWithoutACase = 12;  // of the described commands
inline constexpr int kCommandsWithoutACase = int(kDescribedCommands - kFirstWithoutACase);

/// A command with random fields.
/// @param n  0 ... kDescribedCommands - 1, in the order of LoopCommand
template <class Between>
[[nodiscard]] LoopCommand random_command(std::size_t n, const Between& between) {
  LoopCommand command;
  const RandomFields<Between> fields{between};
  find_alternative<LoopCommand>([&]<class Command>(std::size_t, Of<Command>) {
    if constexpr (Described<Command>) {
      if (n-- == 0) {
        Command& own = command.emplace<Command>();
        for_each_field<Command>([&](const auto& field) { fields.set(own.*field.member); });
        return true;
      }
    }
    return false;
  });
  return command;
}

}  // namespace hapticut::test
