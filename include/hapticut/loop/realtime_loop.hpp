// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/commands.hpp"
#include "hapticut/loop/snapshot.hpp"

namespace hapticut {

/// The model that computes the force: the simulation with its coupling and its map from hand to world. The thread of
/// the loop calls all functions except `check`; they must not allocate or wait.
class LoopModel {
 public:
  virtual ~LoopModel() = default;

  /// Computes the wrench for a new reading.
  /// @param state     the admitted reading; if `valid` is false, the pose is the last good one and no force is rendered
  /// @param dt        [s] since the last reading
  /// @param snapshot  its `X_WT` and `tool` must be filled in
  /// @return [N], [N·m] on the stylus about its point, in B
  virtual Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept = 0;

  /// What is known about the contact that causes the wrench of the last `step`, for the guard.
  [[nodiscard]] virtual ModelContact contact() const noexcept { return {}; }

  /// Checks a command before it is sent, in the sending thread.
  /// @throws Error naming the value that is out of range; the command is then not sent
  virtual void check(const LoopCommand& /*command*/) const {}

  /// Applies a checked command, before the step of the same tick. Swaps the objects of the command with those in place.
  /// @return false when the command does not suit the objects in place, or the model does not know it. The loop counts
  ///         refused commands
  virtual bool apply(LoopCommand& /*command*/) noexcept { return false; }

  /// The simulation whose changed blocks the loop sends; null: no blocks are sent.
  [[nodiscard]] virtual Simulation* simulation() noexcept { return nullptr; }
};

/// Options of a loop.
struct RealtimeLoopOptions {
  RunOptions run;                    ///< the run of the device
  IndexBox region;                   ///< voxels whose changes are sent; empty: no changes are sent
  std::size_t block_capacity = 256;  ///< [blocks] length of the queue
  std::size_t blocks_per_tick = 16;  ///< [blocks] sent per tick at most
};

constexpr auto fields_of(Of<RealtimeLoopOptions>) {
  using O = RealtimeLoopOptions;
  return std::tuple{
      field("run", &O::run, "the run of the device"),
      field("region", &O::region, "voxels whose changes are sent; empty: no changes are sent"),
      field("block_capacity", &O::block_capacity, "blocks", Range::between(1, 1e6), "length of the queue"),
      field("blocks_per_tick", &O::blocks_per_tick, "blocks", Range::not_negative(), "sent per tick at most"),
  };
}

/// Runs a device with a model, and exchanges data with other threads. Commands come in through a bounded queue, the
/// latest state goes out through a triple buffer, and changed blocks go out through a bounded queue. The loop never
/// waits for any of them. Stop, emergency stop and reset come through the device's mailbox, so a full queue of commands
/// does not delay them.
///
/// One thread sends commands, one reads snapshots, one receives blocks; they may be the same thread. Each of these
/// calls also frees the objects that commands have replaced.
class RealtimeLoop {
 public:
  /// Device, model and simulation must outlive the loop.
  RealtimeLoop(Device& device, LoopModel& model, const RealtimeLoopOptions& options);

  /// Stops, and waits until the run has ended.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Begins a run in a new thread. If the workpiece may have changed since the last run, all blocks are sent again.
  /// @throws Error when a run is in progress, or the simulation has too many observers
  void start();

  /// Waits until the run has ended. Changed blocks that were not yet sent can then be received too.
  /// @throws what Device::run threw
  RunReport wait();

  /// Ends the run and waits.
  RunReport stop();

  [[nodiscard]] bool is_running() const noexcept;

  /// The requests of the device: stop, emergency stop, reset. From any thread, also in a signal handler.
  [[nodiscard]] Requests& requests() noexcept;

  /// Sends a command, which the loop applies at the next tick.
  /// @return false when the queue is full. The loop counts it, and `command` is unchanged and can be sent again
  /// @throws Error when a value is out of range: see LoopModel::check
  bool send(LoopCommand&& command);

  /// The latest snapshot. The reference is valid until the next call.
  [[nodiscard]] const LoopSnapshot& latest() noexcept;

  /// Receives one changed block.  @return false when the queue is empty
  bool receive(ChangedBlock& block);

  /// [commands] The capacity of the queue.
  static constexpr std::size_t kCommands = 256;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
