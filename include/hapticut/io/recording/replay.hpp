// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hapticut/io/recording/recording.hpp"

namespace hapticut {

/// The first difference between a replay and its recording.
struct ReplayDifference {
  std::uint64_t step = 0;   ///< number of the step
  std::string column;       ///< column of the recording, or "workpiece" for its hash at the end
  std::size_t element = 0;  ///< index within the row of the column, row-major
  double recorded = 0, replayed = 0;
};

/// Result of a replay.
struct ReplayReport {
  std::uint64_t steps = 0;  ///< number of repeated steps
  bool identical = false;   ///< every bit of every result is equal, and the hash of the workpiece at the end, if known
  std::optional<ReplayDifference> first_difference;
  double max_force_difference = 0;  ///< [N] maximum over all steps
  std::uint64_t skipped = 0;        ///< recorded steps after the first lost one, which cannot be repeated
  std::uint64_t workpiece_hash = 0;
};

/// Options of a replay.
struct ReplayOptions {
  /// Force law of the replay. Required if the recorded law was not FoundationLaw. Another law than the recorded one
  /// shows how the two differ.
  std::shared_ptr<const ForceLaw> law;

  /// Called from time to time with the number of steps done.
  std::function<void(std::uint64_t steps)> progress;

  /// Called after each step, e.g. to draw the simulation.
  std::function<void(const Simulation& simulation, const RecordedStep& step)> on_step;
};

/// Repeats all steps of a recording and compares the results bit by bit with the recorded ones.
/// @throws Error when the recording cannot be read, its workpiece is missing, or it needs a force law that was not
///         passed
[[nodiscard]] ReplayReport replay(const Recording& recording, const ReplayOptions& options = {});

/// The simulation of a recording before its first step.
/// @throws Error when the recording cannot be read, its workpiece is missing, or it needs a force law that was not
///         passed
[[nodiscard]] Simulation simulation_of(const Recording& recording, std::shared_ptr<const ForceLaw> law = nullptr);

}  // namespace hapticut
