// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::cli {

/// A subcommand of the program: a function in <name>_command.cpp, which is declared and listed below. What makes a
/// workpiece calls `tell_on_stderr` for its settings and makes it in `with_bar`; what writes a file calls
/// `require_writable` before the work begins, so that hours are not lost. A name of the library that may come in an
/// error has its flag in the table of reports/flag_words.cpp. docs/command-line.md has the settings as they are here.
struct Command {
  std::string name;
  std::string summary;  ///< one line for the help
  /// What it can be told; a flag without dashes is given by its place.
  std::vector<hapticut::settings::Setting> settings;
  std::function<void()> run;  ///< does the work, once the settings are set; @throws Error when it was not done
};

/// @param component  "io", that this program was built without
/// @throws Error with how it comes in; begins with `what`, that cannot be done
[[noreturn]] inline void fail_without(const std::string& component, const std::string& what) {
  std::string option = "HAPTICUT_WITH_";
  for (const char letter : component) option += char(letter - 'a' + 'A');
  throw Error(what + ", because this program was built without its " + component + " component. Build it with " +
              option + "=ON.");
}

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

/// All of them, in the order of the help.
[[nodiscard]] inline std::vector<Command> all_commands() {
  return {drill_command(), inspect_command(), convert_command(), validate_command(),  calibrate_command(),
          loop_command(),  replay_command(),  export_command(),  stability_command(), view_command()};
}

}  // namespace hapticut::cli
