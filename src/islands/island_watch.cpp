// SPDX-License-Identifier: Apache-2.0
#include "hapticut/islands/island_watch.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "realtime/handover_ring.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kIslands = 256;    // number in the rings at once; more wait in the watching thread
constexpr std::size_t kMaxRemoved = 64;  // kept for `removed`
constexpr std::size_t kWorkpieces = 4;   // number in the rings at once

Simulation& simulation_of(LoopModel& model) {
  Simulation* const simulation = model.simulation();
  if (simulation == nullptr)
    throw Error("The model of an IslandModel drives no simulation; pass a model whose simulation() is not null.");
  return *simulation;
}

}  // namespace

struct IslandWatch::State final : StepObserver {
  /// Changed blocks of one workpiece, from the loop to the search.
  struct Feed {
    std::uint64_t workpiece = 0;  // SimulationTotals::replacements
    std::shared_ptr<ChangeFeed> blocks;
  };
  /// A workpiece that needs another search.
  struct Replaced {
    std::uint64_t workpiece = 0;
    IndexBox bounds;
    GridFrame frame;
  };
  struct Search {
    IslandFinder finder;
    Feed feed;
  };
  struct Tagged {
    IslandRemoval removal;
    std::uint64_t workpiece;
    bool is_marked = false;  // its blocks are to be sent again, because it stays
    std::size_t resent = 0;  // [blocks] sent again
  };
  using Removal = std::unique_ptr<Tagged>;

  State(Simulation& a_simulation, const IslandWatchOptions& some_options)
      : simulation(a_simulation), options(some_options), exchanges(simulation.totals().exchanges) {
    feed = {simulation.totals().replacements, new_feed(simulation.first_bounds())};
    asked_for = feed.workpiece;
    search.emplace(Search{IslandFinder(simulation.workpiece(), simulation.first_bounds(), options.islands), feed});
    simulation.observers().add(*this);
  }
  ~State() override { simulation.observers().remove(*this); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[nodiscard]] std::shared_ptr<ChangeFeed> new_feed(const IndexBox& bounds) const {
    return std::make_shared<ChangeFeed>(simulation, bounds, options.blocks.block_capacity);
  }

  // In the watching thread.
  void watch();
  void find();
  void begin_anew(const Replaced& replaced);

  // In the thread of the loop.
  [[nodiscard]] bool is_current() const noexcept { return feed.workpiece == simulation.totals().replacements; }
  [[nodiscard]] bool follow_workpiece() noexcept;
  [[nodiscard]] bool has_resent(Tagged& stays) noexcept;
  void on_step(const ObservedStep& step) noexcept override {
    if (!is_current()) return;
    feed.blocks->on_step(step);
    feed.blocks->tick(options.blocks.blocks_per_step, 0);
  }
  void on_exchange() noexcept override {
    if (is_current()) feed.blocks->on_exchange();
  }
  void on_removal(const BlockVoxels& voxels) noexcept override {
    if (is_current()) feed.blocks->on_removal(voxels);
  }

  Simulation& simulation;
  IslandWatchOptions options;

  // The watching thread's side.
  std::optional<Search> search;  // empty: the workpiece cannot be watched
  Feed to_send;                  // while its ring is full
  std::vector<Removal> waiting;  // found, while the ring is full
  std::size_t under_way = 0;     // islands that were found and are not over
  std::mutex mutex;              // guards the members below; the loop never locks it
  std::condition_variable wake;
  bool stopping = false;
  std::vector<Island> removed;
  std::optional<std::string> fault;  // why the present workpiece is not watched

  // Between the two. Finished removals and old feeds are freed in the watching thread.
  HandoverRing<Replaced> replaced{kWorkpieces};
  HandoverRing<Feed> feeds{kWorkpieces}, old_feeds{kWorkpieces};
  HandoverRing<Removal> to_remove{kIslands}, over{kIslands};

  // The loop's side.
  Feed feed;
  std::uint64_t asked_for = 0;  // the last workpiece for which a search was asked
  std::uint64_t exchanges;      // SimulationTotals::exchanges at the last tick
  Removal current;
  std::atomic<std::uint64_t> count = 0;

  std::thread thread;
};

IslandWatch::IslandWatch(Simulation& simulation, const IslandWatchOptions& options) {
  require_fields_within(options, "IslandWatchOptions::");
  require_fields_within(options.blocks, "ChangeFeedOptions::");
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
    find();
    lock.lock();
  }
}

/// Begins a search in another workpiece, whose bodies as they are now are the reference.
void IslandWatch::State::begin_anew(const Replaced& next) {
  search.reset();
  to_send = {};
  std::optional<std::string> reason;
  try {
    search.emplace(
        Search{IslandFinder(next.bounds, next.frame, options.islands), {next.workpiece, new_feed(next.bounds)}});
    to_send = search->feed;
  } catch (const std::bad_alloc&) {
    search.reset();
    reason = "There is not enough memory to search the workpiece for loose pieces; crop it.";
  } catch (const std::exception& error) {  // too large a workpiece, or one without voxels
    search.reset();
    reason = error.what();
  }
  const std::lock_guard lock(mutex);
  fault = std::move(reason);
}

void IslandWatch::State::find() {
  std::optional<Replaced> last;
  for (Replaced next; replaced.pop(next);) last = next;
  if (last) begin_anew(*last);
  if (to_send.blocks && feeds.push(Feed(to_send))) to_send = {};
  for (Feed old; old_feeds.pop(old);) {
  }
  for (Removal done; over.pop(done);) {
    --under_way;
    if (done->removal.joined) continue;
    const std::lock_guard lock(mutex);
    if (removed.size() == kMaxRemoved) removed.erase(removed.begin());
    removed.push_back(std::move(done->removal.island));
  }
  if (search) {
    for (ChangedBlock block; search->feed.blocks->receive(block);)
      search->finder.update(block.origin, block.fill.data());
    // The finder treats an island as removed. If it stays, its neighbours would be found as islands and stay, too, and
    // so on in turn: the next search begins when it is known which islands stay.
    if (under_way == 0)
      for (Island& island : search->finder.find()) {
        waiting.push_back(std::make_unique<Tagged>(Tagged{IslandRemoval{std::move(island)}, search->feed.workpiece}));
        ++under_way;
      }
  }
  std::size_t sent = 0;
  while (sent < waiting.size() && to_remove.push(std::move(waiting[sent]))) ++sent;
  waiting.erase(waiting.begin(), waiting.begin() + std::ptrdiff_t(sent));
}

/// After a replacement of the workpiece, asks for another search and takes its feed.
/// @return false while the present workpiece is not watched
bool IslandWatch::State::follow_workpiece() noexcept {
  if (is_current()) return true;
  while (old_feeds.has_room()) {
    Feed next;
    if (!feeds.pop(next)) break;
    std::swap(feed, next);
    old_feeds.push(std::move(next));
  }
  const std::uint64_t workpiece = simulation.totals().replacements;
  if (is_current())
    feed.blocks->send_all();
  else if (asked_for != workpiece &&
           replaced.push({workpiece, simulation.first_bounds(), simulation.workpiece().frame()}))
    asked_for = workpiece;
  return is_current();
}

/// Sends the blocks of an island that stays again, because the search treats it as removed.
/// @return whether each was sent; a tool that goes on cutting may have changed it since
bool IslandWatch::State::has_resent(Tagged& stays) noexcept {
  const std::vector<BlockVoxels>& island = stays.removal.island.blocks;
  if (!std::exchange(stays.is_marked, true))
    for (const BlockVoxels& block : island) feed.blocks->mark(block.origin);
  while (stays.resent < island.size() && !feed.blocks->is_waiting(island[stays.resent].origin)) ++stays.resent;
  return stays.resent == island.size();
}

void IslandWatch::tick() noexcept {
  State& s = *state_;
  const bool is_watched = s.follow_workpiece();
  // Between two parts of an undo, a piece may be loose that the undo will join again.
  const std::uint64_t exchanges = s.simulation.totals().exchanges;
  if (std::exchange(s.exchanges, exchanges) != exchanges) return;
  if (!s.current && !(s.over.has_room() && s.to_remove.pop(s.current))) return;
  IslandRemoval& removal = s.current->removal;
  const bool is_of_workpiece = s.current->workpiece == s.simulation.totals().replacements;
  if (!is_of_workpiece)
    removal.joined = true;
  else if (!remove_island(s.simulation, removal, s.options.blocks_per_tick))
    return;
  if (!removal.joined) {
    ++s.count;
  } else if (is_of_workpiece && is_watched && !s.has_resent(*s.current)) {
    return;
  }
  s.over.push(std::move(s.current));
}

std::uint64_t IslandWatch::count() const noexcept { return state_->count; }

std::optional<std::string> IslandWatch::fault() const {
  const std::lock_guard lock(state_->mutex);
  return state_->fault;
}

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
