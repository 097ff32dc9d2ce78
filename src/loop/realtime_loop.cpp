// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/realtime_loop.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/realtime/triple_buffer.hpp"
#include "realtime/handover_ring.hpp"

namespace hapticut {

struct RealtimeLoop::State {
  State(Device& a_device, LoopModel& a_model, const RealtimeLoopOptions& some_options)
      : device(a_device), model(a_model), options(some_options) {
    require_fields_within(options, "RealtimeLoopOptions::");
    Simulation* const simulation = model.simulation();
    if (simulation != nullptr && !options.region.empty())
      feed.emplace(*simulation, options.region, options.block_capacity);
  }

  DeviceCommand tick(const DeviceState& reading) noexcept;
  void apply_commands() noexcept;
  void free_replaced() noexcept;

  Device& device;
  LoopModel& model;
  RealtimeLoopOptions options;

  HandoverRing<LoopCommand> commands{kCommands};
  HandoverRing<LoopCommand> replaced{kCommands};  // applied commands with the replaced objects
  std::mutex freeing;                             // held by a thread that frees them; the loop never takes it
  std::atomic<std::uint64_t> dropped{0};
  std::uint64_t refused = 0;
  TripleBuffer<LoopSnapshot> snapshots;
  std::optional<ChangeFeed> feed;
  std::uint32_t workpiece = 0;  // ChangedBlock::workpiece

  std::uint64_t ticks = 0;
  double last_time = 0;
  double max_commanded = 0, max_applied = 0;

  std::thread thread;
  std::atomic<bool> running{false};
  RunReport report;
  std::exception_ptr exception;
};

void RealtimeLoop::State::apply_commands() noexcept {
  LoopCommand message;
  // If `replaced` is full, the next command waits, because nothing may be freed here.
  while (replaced.has_room() && commands.pop(message)) {
    if (!model.apply(message)) ++refused;
    replaced.push(std::move(message));
  }
}

void RealtimeLoop::State::free_replaced() noexcept {
  const std::unique_lock lock(freeing, std::try_to_lock);
  if (!lock) return;  // another thread frees them
  for (LoopCommand old; replaced.pop(old);) {
  }
}

DeviceCommand RealtimeLoop::State::tick(const DeviceState& reading) noexcept {
  DeviceCommand command;
  apply_commands();
  const double nominal = device.period();
  const double dt = ticks == 0 ? nominal : reading.time - last_time;
  last_time = reading.time;

  LoopSnapshot& snapshot = snapshots.writing();
  command.wrench = model.step(reading, dt > 0 ? dt : nominal, snapshot);
  command.contact = model.contact();
  if (feed) {
    workpiece = snapshot.tool.workpiece;
    feed->tick(options.blocks_per_tick, workpiece);
    snapshot.blocks_waiting = feed->waiting();
    snapshot.blocks_outside = feed->outside();
  }
  snapshot.tick = ++ticks;
  snapshot.device = reading;
  snapshot.output = device.last_output();
  snapshot.max_commanded = max_commanded = std::max(max_commanded, snapshot.output.commanded.force.norm());
  snapshot.max_applied = max_applied = std::max(max_applied, snapshot.output.applied.force.norm());
  snapshot.arming = device.last_arming();
  snapshot.commands_dropped = dropped.load(std::memory_order_relaxed);
  snapshot.commands_refused = refused;
  snapshots.publish();
  return command;
}

RealtimeLoop::RealtimeLoop(Device& device, LoopModel& model, const RealtimeLoopOptions& options)
    : state_(std::make_unique<State>(device, model, options)) {}

RealtimeLoop::~RealtimeLoop() {
  if (!state_->thread.joinable()) return;
  state_->device.stop();
  while (state_->running.load()) {  // a run ignores a stop from before its start
    state_->device.stop();
    std::this_thread::yield();
  }
  state_->thread.join();
}

void RealtimeLoop::start() {
  if (state_->thread.joinable()) throw Error("The loop already runs; call wait or stop before starting it again.");
  if (state_->feed) state_->feed->attach();
  state_->ticks = 0;
  state_->exception = nullptr;
  state_->running.store(true);
  state_->thread = std::thread([state = state_.get()] {
    try {
      state->report =
          state->device.run([state](const DeviceState& reading) { return state->tick(reading); }, state->options.run);
    } catch (...) {
      state->exception = std::current_exception();
    }
    state->running.store(false);
  });
}

RunReport RealtimeLoop::wait() {
  if (!state_->thread.joinable()) throw Error("The loop does not run; call start first.");
  state_->thread.join();
  if (state_->feed) {
    state_->feed->keep_rest(state_->workpiece);
    state_->feed->detach();
  }
  state_->free_replaced();
  if (state_->exception) std::rethrow_exception(std::exchange(state_->exception, nullptr));
  return std::move(state_->report);
}

RunReport RealtimeLoop::stop() {
  while (state_->running.load()) {
    state_->device.stop();
    std::this_thread::yield();
  }
  return wait();
}

bool RealtimeLoop::is_running() const noexcept { return state_->running.load(); }

Requests& RealtimeLoop::requests() noexcept { return state_->device.requests(); }

bool RealtimeLoop::send(LoopCommand&& command) {
  state_->model.check(command);
  state_->free_replaced();
  if (state_->commands.push(std::move(command))) return true;
  state_->dropped.fetch_add(1, std::memory_order_relaxed);
  return false;
}

const LoopSnapshot& RealtimeLoop::latest() noexcept {
  state_->free_replaced();
  return state_->snapshots.latest();
}

bool RealtimeLoop::receive(ChangedBlock& block) {
  state_->free_replaced();
  return state_->feed && state_->feed->receive(block);
}

}  // namespace hapticut
