// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "hapticut/device/device.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "reports/delivery.hpp"

/// @file
/// Recordings for the subcommands, in programs with and without the io component.
namespace hapticut::apps {

/// Whether a hand makes the steps. A hand must not wait for the disk.
enum class Pace { own, of_a_hand };

/// The recorder of a run, an observer of the simulation; exists only if requested.
class RunRecorder {
 public:
  /// @param path    empty: no recording
  /// @param device  null: no device
  /// @throws Error when the recording cannot be written, or this program has no io component
  RunRecorder(const std::string& path, Simulation& simulation, Pace pace, const Device* device);
  ~RunRecorder();
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;

  /// Ends the recording. Stores a failure for `require_complete`, so a report can be written first.
  /// @return number of lost steps
  std::uint64_t close();

  /// Why the recording could not be written completely; empty if it could.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// @throws Error when the recording could not be written completely
  void require_complete() const;

 private:
  struct State;
  std::string failure_;
  std::unique_ptr<State> state_;
};

/// Starts the recording of a run, if it is wanted. A failure is told, and the run goes on without it.
/// @return never null
/// @throws AlreadyTold when the recording fails and the run has no other output
[[nodiscard]] std::unique_ptr<RunRecorder> start_recording(Delivery& delivery, const std::string& path,
                                                           Simulation& simulation, Pace pace, const Device* device);

/// Registers the device `replay:FILE` if this program can read recordings.
void use_recordings_if_possible();

}  // namespace hapticut::apps
