// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hapticut/io/recording/recording.hpp"

namespace hapticut {

/// Where a replay leaves its recording.
struct ReplayDifference {
  std::uint64_t step = 0;   ///< number of the step
  std::string column;       ///< of the recording, or "workpiece" for its hash at the end
  std::size_t element = 0;  ///< of the column, counted through its rows
  double recorded = 0, replayed = 0;
};

/// What came of a replay.
struct ReplayReport {
  std::uint64_t steps = 0;  ///< that were made again
  bool identical = false;   ///< every bit of every result, and of the workpiece at the end where it is known
  std::optional<ReplayDifference> first_difference;
  double max_force_difference = 0;  ///< [N] over all steps
  std::uint64_t left_out = 0;       ///< recorded steps after the first lost one, which cannot be made again
  std::uint64_t workpiece_hash = 0;
};

/// How a recording is run again.
struct ReplayOptions {
  /// Needed where the recorded one was not FoundationLaw: the same one. Another than the recorded one, where it shall
  /// be seen how the two differ.
  std::shared_ptr<const ForceLaw> law;

  /// Called now and then with the steps that are done.
  std::function<void(std::uint64_t steps)> progress;

  /// Called after each step with the simulation as it is then, for pictures.
  std::function<void(const Simulation& simulation, const RecordedStep& step)> stepped;
};

/// Makes all steps of a recording again and compares them bit by bit with what was recorded.
/// @throws Error when the recording cannot be read, its workpiece is missing, or it needs a law that was not given
[[nodiscard]] ReplayReport replay(const Recording& recording, const ReplayOptions& options = {});

/// The simulation of a recording before its first step.
/// @throws Error as above
[[nodiscard]] Simulation simulation_of(const Recording& recording, std::shared_ptr<const ForceLaw> law = nullptr);

}  // namespace hapticut
