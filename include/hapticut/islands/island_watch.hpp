// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/islands/islands.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/realtime_loop.hpp"

namespace hapticut {

/// Options for the removal of pieces that were cut loose.
struct IslandWatchOptions {
  IslandOptions islands;  ///< definition of an island
  double period = 0.01;   ///< [s] time between two searches
  /// [blocks] maximum number of an island's blocks that a tick checks or removes; 1 us each
  std::size_t blocks_per_tick = 16;
  ChangeFeedOptions blocks;  ///< queue of changed blocks, to the search
};

constexpr auto fields_of(Of<IslandWatchOptions>) {
  using O = IslandWatchOptions;
  return std::tuple{
      field("islands", &O::islands, "definition of an island"),
      field("period", &O::period, "s", Range::between(1e-4, 10), "time between two searches"),
      field("blocks_per_tick", &O::blocks_per_tick, "blocks", Range::positive(),
            "maximum number of an island's blocks that a tick checks or removes; 1 us each"),
      field("blocks", &O::blocks, "queue of changed blocks, to the search"),
  };
}

/// Finds pieces that were cut loose, in its own thread, and removes them between the ticks of a loop, some blocks at a
/// time: see IslandFinder and remove_island. The moment of removal depends on the timing of that thread, so two runs
/// may differ in their bits. Steps of a recording end with the first removal.
///
/// After a replacement of the workpiece (SimulationTotals::replacements), the watch starts again: the bodies of the
/// new workpiece are separate from the beginning. Its search begins when all blocks were sent once. A workpiece that
/// spans too many blocks for IslandFinder is not watched; `fault` says so.
class IslandWatch {
 public:
  /// @param simulation  must outlive it and must not be moved
  /// @throws Error when an option is out of range, or as IslandFinder and ChangeFeed. Their conditions on the workpiece
  ///         apply to the present one
  explicit IslandWatch(Simulation& simulation, const IslandWatchOptions& options = {});
  ~IslandWatch();
  IslandWatch(const IslandWatch&) = delete;
  IslandWatch& operator=(const IslandWatch&) = delete;

  /// Continues the removal of pieces. To be called in the thread that makes the steps, between two steps.
  /// @realtime no allocation, no lock; O(blocks_per_tick)
  void tick() noexcept;

  /// Number of removed pieces. From any thread.
  [[nodiscard]] std::uint64_t count() const noexcept;

  /// Why the present workpiece is not watched. Empty while it is watched, or while its search is being prepared. After
  /// a replacement of the workpiece it refers to the former one for up to IslandWatchOptions::period. From any thread.
  [[nodiscard]] std::optional<std::string> fault() const;

  /// Pieces that were removed since the last call, at most the latest 64, for display as bodies. From any thread.
  [[nodiscard]] std::vector<Island> removed();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A model of a loop that removes pieces which are cut loose from its workpiece, between two ticks.
class IslandModel final : public LoopModel {
 public:
  /// @param model  drives a simulation, as SimulationModel does; both must outlive this
  /// @throws Error when the model drives no simulation, or as IslandWatch
  explicit IslandModel(LoopModel& model, const IslandWatchOptions& options = {});

  [[nodiscard]] IslandWatch& watch() noexcept { return watch_; }  ///< `tick` is the loop's

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override;
  [[nodiscard]] ModelContact contact() const noexcept override { return model_.contact(); }
  void check(const LoopCommand& command) const override { model_.check(command); }
  bool apply(LoopCommand& command) noexcept override { return model_.apply(command); }
  [[nodiscard]] Simulation* simulation() noexcept override { return model_.simulation(); }

 private:
  LoopModel& model_;
  IslandWatch watch_;
};

}  // namespace hapticut
