// SPDX-License-Identifier: Apache-2.0
#include "hapticut/islands/island_watch.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "realtime/handover_ring.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kIslands = 256;  // under way at once; more wait in the watching thread
constexpr std::size_t kMaxLeft = 64;   // that are kept for `left`

Simulation& simulation_of(LoopModel& model) {
  Simulation* const simulation = model.simulation();
  if (simulation == nullptr)
    throw Error("The model of an IslandModel drives no simulation; give it one whose simulation() is not null.");
  return *simulation;
}

}  // namespace

struct IslandWatch::State {
  using Removal = std::unique_ptr<IslandRemoval>;

  State(Simulation& a_simulation, const IslandWatchOptions& some_options)
      : simulation(a_simulation),
        options(some_options),
        finder(simulation.workpiece(), options.islands),
        feed(simulation, options.blocks) {}

  void watch();
  void look();

  Simulation& simulation;
  IslandWatchOptions options;

  // The watching thread's side.
  IslandFinder finder;
  std::vector<Removal> waiting;  // found, and without room in the ring
  std::mutex mutex;              // of what stands below; the loop never takes it
  std::condition_variable wake;
  bool stopping = false;
  std::vector<Island> left;

  // Between the two. What has left is freed in the watching thread.
  ChangeFeed feed;
  HandoverRing<Removal> to_leave{kIslands}, over{kIslands};

  // The loop's side.
  Removal current;
  std::atomic<std::uint64_t> count = 0;

  std::thread thread;
};

IslandWatch::IslandWatch(Simulation& simulation, const IslandWatchOptions& options) {
  require_fields_within(options, "IslandWatchOptions::");
  state_ = std::make_unique<State>(simulation, options);
  state_->thread = std::thread([state = state_.get()] { state->watch(); });
}

IslandWatch::~IslandWatch() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

void IslandWatch::State::watch() {
  std::unique_lock lock(mutex);
  while (!wake.wait_for(lock, std::chrono::duration<double>(options.period), [this] { return stopping; })) {
    lock.unlock();
    look();
    lock.lock();
  }
}

void IslandWatch::State::look() {
  for (ChangedBlock block; feed.receive(block);) finder.update(block.origin, block.fill.data());
  for (Island& island : finder.find())
    waiting.push_back(std::make_unique<IslandRemoval>(IslandRemoval{std::move(island)}));
  std::size_t sent = 0;
  while (sent < waiting.size() && to_leave.push(std::move(waiting[sent]))) ++sent;
  waiting.erase(waiting.begin(), waiting.begin() + std::ptrdiff_t(sent));
  for (Removal done; over.pop(done);) {
    if (done->joined) continue;
    const std::lock_guard lock(mutex);
    if (left.size() == kMaxLeft) left.erase(left.begin());
    left.push_back(std::move(done->island));
  }
}

void IslandWatch::tick() noexcept {
  State& s = *state_;
  if (!s.current && !(s.over.has_room() && s.to_leave.pop(s.current))) return;
  IslandRemoval& removal = *s.current;
  const bool is_over = remove_island(s.simulation, removal, s.options.blocks_per_tick);
  if (!is_over) return;
  if (removal.joined)  // it is still there: the search must hear of it
    for (const BlockVoxels& block : removal.island.blocks) s.feed.mark(block.origin);
  else
    ++s.count;
  s.over.push(std::move(s.current));
}

std::uint64_t IslandWatch::count() const noexcept { return state_->count; }

std::vector<Island> IslandWatch::left() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->left, {});
}

IslandModel::IslandModel(LoopModel& model, const IslandWatchOptions& options)
    : model_(model), watch_(simulation_of(model), options) {}

Wrench IslandModel::step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept {
  Wrench wrench = model_.step(state, dt, snapshot);
  watch_.tick();
  return wrench;
}

}  // namespace hapticut
