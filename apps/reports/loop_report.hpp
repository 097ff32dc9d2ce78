// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/loop/simulation_model.hpp"
#include "reports/beside_report.hpp"
#include "reports/json_file.hpp"
#include "reports/report.hpp"

namespace hapticut::apps {

/// Data of a loop that a screen received.
struct LoopWatch {
  std::uint64_t frames = 0, blocks = 0;  ///< number of frames and of received changed blocks
  std::size_t max_blocks_waiting = 0;
  LoopSnapshot last;  ///< snapshot of the last tick
};

struct LoopReport {
  WorkpieceSummary workpiece;  ///< workpiece before cutting
  const Device& device;
  const Simulation& simulation;
  bool coupled;  ///< true: by a virtual coupling
  LoopWatch seen;
  RunReport run;
  std::uint64_t steps_lost;            ///< steps that the recorder lost
  std::string recording_failure = {};  ///< why the recording ended before the run, as a sentence; empty: it did not
  BesideReport beside = {};
};

/// Warnings about the forces, as sentences.
[[nodiscard]] std::vector<std::string> warnings_of(const LoopReport& report);

[[nodiscard]] Json to_json(const LoopReport& report);
[[nodiscard]] std::string to_table(const LoopReport& report);

}  // namespace hapticut::apps
