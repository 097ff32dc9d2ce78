// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/reports/json_file.hpp"
#include "cli/reports/report.hpp"
#include "hapticut/loop/simulation_model.hpp"

namespace hapticut::cli {

/// What a screen saw of a loop.
struct LoopWatch {
  std::uint64_t frames = 0, blocks = 0;  ///< looks, and changed blocks that were received
  std::size_t max_blocks_waiting = 0;
  LoopSnapshot last;  ///< of the last tick
};

struct LoopReport {
  WorkpieceSummary workpiece;  ///< before cutting
  const Device& device;
  const Simulation& simulation;
  bool coupled;  ///< by a virtual coupling
  LoopWatch seen;
  RunReport run;
  std::uint64_t steps_lost;  ///< by the recorder
};

/// What a user should know before trusting what was felt, as sentences.
[[nodiscard]] std::vector<std::string> warnings_of(const LoopReport& report);

[[nodiscard]] Json to_json(const LoopReport& report);
[[nodiscard]] std::string to_table(const LoopReport& report);

}  // namespace hapticut::cli
