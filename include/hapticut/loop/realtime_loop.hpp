// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "hapticut/device/device.hpp"
#include "hapticut/loop/block_outbox.hpp"

namespace hapticut {

/// A message into the loop. What it means is the model's affair, but for the first kinds, which the loop knows.
struct LoopCommand {
  enum class Kind : std::uint8_t {
    stop,            ///< end the run
    emergency_stop,  ///< no force until `reset_fault`
    reset_fault,     ///< leave the fault state
    model,           ///< for LoopModel::obey
  };
  Kind kind = Kind::model;
  std::int32_t code = 0;           ///< the model's own number of the command
  std::array<double, 8> values{};  ///< what belongs to it
};

/// What the loop shows of its last tick, for a screen.
struct LoopSnapshot {
  std::uint64_t tick = 0;
  DeviceState device;   ///< as the guard let it through
  DeviceOutput output;  ///< of the tick before
  ArmingState arming = ArmingState::off;
  std::uint64_t commands_dropped = 0;  ///< that found the queue full
  std::size_t blocks_waiting = 0;      ///< changed and not yet sent
  Pose X_WT;                           ///< the tool as the model sees it; filled in by the model
  std::array<double, 16> values{};     ///< whatever else the model wants to show
};

/// What computes the force: the simulation, with its coupling and its map from hand to world. All of it is called in
/// the thread of the loop and must not allocate or wait.
class LoopModel {
 public:
  virtual ~LoopModel() = default;

  /// One tick.
  /// @param state     the guarded reading; `valid` false: the pose is the last good one and no force will be felt
  /// @param dt        [s] since the last tick
  /// @param snapshot  `X_WT` and `values` to be filled in
  /// @return [N], [N·m] on the stylus about its point, in B
  virtual Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept = 0;

  /// A command; before the step of the same tick.
  virtual void obey(const LoopCommand& /*command*/) noexcept {}

  /// Marks the blocks that this tick has changed.
  virtual void mark_changes(BlockOutbox& /*outbox*/) noexcept {}

  /// Copies a block for the outbox.
  virtual void copy(ChangedBlock& /*block*/) noexcept {}
};

/// How the loop exchanges data.
struct RealtimeLoopOptions {
  RunOptions run;
  IndexBox region;                   ///< voxels whose changes are sent; empty: none are
  std::size_t block_capacity = 256;  ///< [blocks] under way at once
  std::size_t blocks_per_tick = 16;  ///< sent at most
};

/// A device, a model and the exchange of both with other threads: commands in by a bounded queue, the latest state out
/// by a triple buffer, changed blocks out by a bounded queue. The loop never waits for any of them.
///
/// One thread sends commands, one looks at snapshots, one receives blocks; they may be the same.
class RealtimeLoop {
 public:
  /// Neither the device nor the model may go away before the loop.
  RealtimeLoop(Device& device, LoopModel& model, const RealtimeLoopOptions& options);

  /// Stops, and waits until the run has ended.
  ~RealtimeLoop();
  RealtimeLoop(const RealtimeLoop&) = delete;
  RealtimeLoop& operator=(const RealtimeLoop&) = delete;

  /// Begins a run in a thread of its own.  @throws Error when one runs already
  void start();

  /// Waits until the run has ended.  @throws what Device::run threw
  RunReport wait();

  /// Ends the run and waits.
  RunReport stop();

  [[nodiscard]] bool is_running() const noexcept;

  /// No force from the next tick on, until `reset_fault` is sent. From any thread, also in a signal handler, and
  /// whatever the queue of commands is full of.
  void emergency_stop() noexcept;

  /// Sends a command to be obeyed at the next tick.  @return false when the queue is full: it is dropped and counted
  bool send(const LoopCommand& command) noexcept;

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
