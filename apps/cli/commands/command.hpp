// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::apps {

/// A subcommand of the program: a function in <name>_command.cpp, declared and listed below. A command that makes a
/// workpiece calls `tell_on_stderr` for its settings and makes the workpiece in `with_bar`. A command that writes
/// files makes a `Delivery` of them before the work begins, and prints and writes through it. docs/command-line.md
/// lists the settings defined here.
struct Command {
  std::string name;
  std::string summary;  ///< one line for the help
  /// The settings of the command; a flag without dashes is a positional argument.
  std::vector<hapticut::settings::Setting> settings;
  std::function<void()> run;  ///< runs the command, after the settings are applied; @throws Error when it fails
  std::set<std::string> ignored_tables{};  ///< tables to ignore in a settings file that other commands share
};

[[nodiscard]] Command drill_command();
[[nodiscard]] Command inspect_command();
[[nodiscard]] Command convert_command();
[[nodiscard]] Command validate_command();
[[nodiscard]] Command calibrate_command();
[[nodiscard]] Command loop_command();
[[nodiscard]] Command replay_command();
[[nodiscard]] Command export_command();
[[nodiscard]] Command stability_command();
[[nodiscard]] Command view_command();

/// All subcommands, in the order of the help.
[[nodiscard]] inline std::vector<Command> all_commands() {
  return {drill_command(), inspect_command(), convert_command(), validate_command(),  calibrate_command(),
          loop_command(),  replay_command(),  export_command(),  stability_command(), view_command()};
}

}  // namespace hapticut::apps
