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

constexpr std::size_t kIslands = 256;    // in the rings at once; more wait in the watching thread
constexpr std::size_t kMaxRemoved = 64;  // kept for `removed`

Simulation& simulation_of(LoopModel& model) {
  Simulation* const simulation = model.simulation();
  if (simulation == nullptr)
    throw Error("The model of an IslandModel drives no simulation; pass a model whose simulation() is not null.");
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
  void search();

  Simulation& simulation;
  IslandWatchOptions options;

  // The watching thread's side.
  IslandFinder finder;
  std::vector<Removal> waiting;  // found, while the ring is full
  std::mutex mutex;              // of the members below; the loop never locks it
  std::condition_variable wake;
  bool stopping = false;
  std::vector<Island> removed;

  // Between the two. Finished removals are freed in the watching thread.
  ChangeFeed feed;
  HandoverRing<Removal> to_remove{kIslands}, over{kIslands};

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
    search();
    lock.lock();
  }
}

void IslandWatch::State::search() {
  for (ChangedBlock block; feed.receive(block);) finder.update(block.origin, block.fill.data());
  for (Island& island : finder.find())
    waiting.push_back(std::make_unique<IslandRemoval>(IslandRemoval{std::move(island)}));
  std::size_t sent = 0;
  while (sent < waiting.size() && to_remove.push(std::move(waiting[sent]))) ++sent;
  waiting.erase(waiting.begin(), waiting.begin() + std::ptrdiff_t(sent));
  for (Removal done; over.pop(done);) {
    if (done->joined) continue;
    const std::lock_guard lock(mutex);
    if (removed.size() == kMaxRemoved) removed.erase(removed.begin());
    removed.push_back(std::move(done->island));
  }
}

void IslandWatch::tick() noexcept {
  State& s = *state_;
  if (!s.current && !(s.over.has_room() && s.to_remove.pop(s.current))) return;
  IslandRemoval& removal = *s.current;
  const bool is_over = remove_island(s.simulation, removal, s.options.blocks_per_tick);
  if (!is_over) return;
  if (removal.joined)  // it stays, so the search must know its blocks again
    for (const BlockVoxels& block : removal.island.blocks) s.feed.mark(block.origin);
  else
    ++s.count;
  s.over.push(std::move(s.current));
}

std::uint64_t IslandWatch::count() const noexcept { return state_->count; }

std::vector<Island> IslandWatch::removed() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->removed, {});
}

IslandModel::IslandModel(LoopModel& model, const IslandWatchOptions& options)
    : model_(model), watch_(simulation_of(model), options) {}

Wrench IslandModel::step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept {
  Wrench wrench = model_.step(state, dt, snapshot);
  watch_.tick();
  return wrench;
}

}  // namespace hapticut
