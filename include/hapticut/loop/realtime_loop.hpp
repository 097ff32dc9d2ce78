// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/commands.hpp"
#include "hapticut/loop/snapshot.hpp"

namespace hapticut {

/// What computes the force: the simulation, with its coupling and its map from hand to world. All of it but `check` is
/// called in the thread of the loop and must not allocate or wait.
class LoopModel {
 public:
  virtual ~LoopModel() = default;

  /// One tick.
  /// @param state     the guarded reading; `valid` false: the pose is the last good one and no force will be felt
  /// @param dt        [s] since the last tick
  /// @param snapshot  `X_WT` and `tool` to be filled in
  /// @return [N], [N·m] on the stylus about its point, in B
  virtual Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept = 0;

  /// What is known of the contact behind the wrench of the last `step`, for the guard.
  [[nodiscard]] virtual ModelContact contact() const noexcept { return {}; }

  /// Whether a command makes sense; in the thread that sends it, before it is sent.
  /// @throws Error naming what is out of range; then it is not sent
  virtual void check(const LoopCommand& /*command*/) const {}

  /// A command that was checked; before the step of the same tick. What it brings is swapped with what was in place,
  /// which goes back in it.
  /// @return false when it does not suit what is in place, or the model does not know it; it is then counted
  virtual bool obey(LoopCommand& /*command*/) noexcept { return false; }

  /// Whose changed blocks the loop sends; null: of none.
  [[nodiscard]] virtual Simulation* simulation() noexcept { return nullptr; }
};

/// How the loop exchanges data.
struct RealtimeLoopOptions {
  RunOptions run;
  IndexBox region;
  std::size_t block_capacity = 256;
  std::size_t blocks_per_tick = 16;
};

constexpr auto fields_of(Of<RealtimeLoopOptions>) {
  using O = RealtimeLoopOptions;
  return std::tuple{
      field("run", &O::run, "of the device"),
      field("region", &O::region, "voxels whose changes are sent; empty: no changes are"),
      field("block_capacity", &O::block_capacity, "blocks", Range::between(1, 1e6), "under way at once"),
      field("blocks_per_tick", &O::blocks_per_tick, "blocks", Range::not_negative(), "sent at most"),
  };
}

/// A device, a model and the exchange of both with other threads: commands in by a bounded queue, the latest state out
/// by a triple buffer, changed blocks out by a bounded queue. The loop never waits for any of them. Stop, emergency
/// stop and reset come by the device's mailbox, whatever the queue of commands is full of.
///
/// One thread sends commands, one looks at snapshots, one receives blocks; they may be the same. Each of these calls
/// also frees what commands have replaced.
class RealtimeLoop {
 public:
  /// None of device, model and simulation may go away before the loop.
  RealtimeLoop(Device& device, LoopModel& model, const RealtimeLoopOptions& options);

  /// Stops, and waits until the run has ended.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Begins a run in a thread of its own.
  /// @throws Error when one runs already, or the simulation has too many observers
  void start();

  /// Waits until the run has ended.  @throws what Device::run threw
  RunReport wait();

  /// Ends the run and waits.
  RunReport stop();

  [[nodiscard]] bool is_running() const noexcept;

  /// Stop, emergency stop, reset: those of the device. From any thread, also in a signal handler.
  [[nodiscard]] Requests& requests() noexcept;

  /// Sends a command to be obeyed at the next tick.
  /// @return false when the queue is full: that is counted, and `command` is as it was, to be sent again
  /// @throws Error when it is out of range: see LoopModel::check
  bool send(LoopCommand&& command);

  /// The latest snapshot; the reference is good until the next call.
  [[nodiscard]] const LoopSnapshot& latest() noexcept;

  /// Takes one changed block.  @return false when there is none
  bool receive(ChangedBlock& block);

  /// Commands that may be under way at once.
  static constexpr std::size_t kCommands = 256;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
