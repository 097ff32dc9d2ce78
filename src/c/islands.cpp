// SPDX-License-Identifier: Apache-2.0
// The removal of pieces that were cut loose.
#include "hapticut/islands/islands.hpp"

#include <deque>
#include <iterator>
#include <string>
#include <vector>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"
#include "hapticut/islands/island_watch.hpp"

namespace hapticut::c {
namespace {

class IslandsObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::islands;

  /// @pre the simulation is idle and removes no loose pieces
  IslandsObject(std::shared_ptr<SimulationObject> a_simulation, const IslandWatchOptions& options)
      : simulation(std::move(a_simulation)), watch(std::make_shared<IslandWatch>(simulation->simulation, options)) {
    simulation->watch.store(watch.get(), std::memory_order_release);
  }
  ~IslandsObject() override {
    SimulationObject& owner = *simulation;
    owner.watch.store(nullptr, std::memory_order_release);
    owner.retire(std::move(watch));
  }

  const std::shared_ptr<SimulationObject> simulation;
  std::shared_ptr<IslandWatch> watch;
  std::deque<Island> removed;  // not yet polled
};

constexpr std::size_t kMaxKept = 64;  // pieces that were not polled

IslandWatchOptions options_of(const hapticut_islands_options& given) {
  if (given.has_fixed > 1)
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, "has_fixed = " + std::to_string(given.has_fixed) + "; it must be 0 or 1.");
  IslandWatchOptions options;
  if (given.has_fixed == 1) options.islands.fixed = Box{vector_of(given.fixed_min), vector_of(given.fixed_max)};
  set_if_given(given.min_fill, options.islands.min_fill);
  set_if_given(given.period, options.period);
  set_if_given(given.blocks_per_tick, options.blocks_per_tick);
  return options;
}

/// [m] The mean of the centres of its voxels, in W.
Vec3 center_of(const Island& island, const GridFrame& frame) {
  Vec3 sum = Vec3::Zero();
  for (const BlockVoxels& block : island.blocks)
    block.voxels.for_each([&](int voxel) { sum += frame.center(voxel_at(block.origin, voxel)); });
  return sum / double(island.voxels);
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_islands_open(hapticut_simulation simulation, const hapticut_islands_options* options,
                          hapticut_islands* islands) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    require_argument(islands, "islands");
    hapticut_islands_options own;
    if (const int code = read_struct_if_given(options, "options", own); code != HAPTICUT_OK) return code;
    if (use->watch.load() != use->watch_of_scene.get())
      return fail(HAPTICUT_ERROR_REFUSED, "Another handle removes the loose pieces of this simulation; release it.");
    use.pointer()->sweep();
    const std::shared_ptr<IslandsObject> object = std::make_shared<IslandsObject>(use.pointer(), options_of(own));
    use->watch_of_scene = nullptr;
    *islands = add_object(Kind::islands, object);
    return HAPTICUT_OK;
  });
}

int hapticut_islands_count(hapticut_islands islands, uint64_t* count) {
  return within(Use<IslandsObject>(islands), [&](const auto& use) {
    require_argument(count, "count");
    *count = use->watch->count();
  });
}

int hapticut_islands_poll(hapticut_islands islands, hapticut_island_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<IslandsObject>(islands), [&](const auto& use) -> int {
    std::ranges::move(use->watch->removed(), std::back_inserter(use->removed));
    while (use->removed.size() > kMaxKept) use->removed.pop_front();
    if (use->removed.empty()) return HAPTICUT_NOTHING;
    const Island& island = use->removed.front();
    hapticut_island_info own{};
    own.voxels = std::uint64_t(island.voxels);
    put(center_of(island, use->simulation->simulation.workpiece().frame()), own.center_W);  // the frame never changes
    use->removed.pop_front();
    write_struct(own, info);
    return HAPTICUT_OK;
  });
}

}  // extern "C"
