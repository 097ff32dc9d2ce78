// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "hapticut/device/device.hpp"
#include "hapticut/simulation/simulation.hpp"

/// @file
/// Recordings as the subcommands need them, in programs with and without the io component.
namespace hapticut::cli {

/// Whether steps are made by a hand, which must not wait for the disk.
enum class Pace { own, of_a_hand };

/// The recorder of a run, which observes the simulation; made only where one was asked for.
class RunRecorder {
 public:
  /// @param path    empty: nothing is recorded
  /// @param device  null: no device is involved
  /// @throws Error when it cannot be written, or this program has no io component
  RunRecorder(const std::string& path, Simulation& simulation, Pace pace, const Device* device);
  ~RunRecorder();
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;

  /// Ends the recording; what goes wrong is kept for `require_complete`, so that a report can be written first.
  /// @return steps that were lost
  std::uint64_t close();

  /// @throws Error when something could not be written
  void require_complete() const;

 private:
  struct State;
  std::string failure_;
  std::unique_ptr<State> state_;
};

/// Makes `replay:FILE` a device, where this program can read recordings.
void use_recordings_if_possible();

}  // namespace hapticut::cli
