// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/islands/islands.hpp"
#include "hapticut/loop/change_feed.hpp"
#include "hapticut/loop/realtime_loop.hpp"

namespace hapticut {

/// How pieces that were cut loose leave.
struct IslandWatchOptions {
  IslandOptions islands;
  double period = 0.01;
  std::size_t blocks_per_tick = 16;
  ChangeFeedOptions blocks;
};

constexpr auto fields_of(Of<IslandWatchOptions>) {
  using O = IslandWatchOptions;
  return std::tuple{
      field("islands", &O::islands, "what is an island"),
      field("period", &O::period, "s", Range::between(1e-4, 10), "between two searches"),
      field("blocks_per_tick", &O::blocks_per_tick, "blocks", Range::positive(),
            "of an island that are looked at or leave in a tick at most; 1 us each"),
      field("blocks", &O::blocks, "the blocks that change, on their way to the search"),
  };
}

/// Finds pieces that were cut loose in a thread of its own, and lets them leave between the ticks of a loop, some
/// blocks at a time: see IslandFinder and remove_island. When a piece leaves depends on when that thread
/// gets its turn, so two runs need not leave the same bits; steps of a recording end with the first piece.
class IslandWatch {
 public:
  /// @param simulation  must outlive it, and stay where it is
  /// @throws Error when an option is out of range, or as IslandFinder and ChangeFeed
  explicit IslandWatch(Simulation& simulation, const IslandWatchOptions& options = {});
  ~IslandWatch();
  IslandWatch(const IslandWatch&) = delete;
  IslandWatch& operator=(const IslandWatch&) = delete;

  /// Goes on with what is to leave. In the thread that makes the steps, between two of them.
  /// @realtime no allocation, no lock; O(blocks_per_tick)
  void tick() noexcept;

  /// Pieces that have left. From any thread.
  [[nodiscard]] std::uint64_t count() const noexcept;

  /// What has left since the last call, at most the latest 64 pieces: to be shown as bodies. From any thread.
  [[nodiscard]] std::vector<Island> left();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A model of a loop from whose workpiece pieces that are cut loose leave, between two of its ticks.
class IslandModel final : public LoopModel {
 public:
  /// @param model  of a simulation, as a SimulationModel; both must outlive this
  /// @throws Error when the model drives no simulation, or as IslandWatch
  explicit IslandModel(LoopModel& model, const IslandWatchOptions& options = {});

  [[nodiscard]] IslandWatch& watch() noexcept { return watch_; }  ///< `tick` is the loop's

  Wrench step(const DeviceState& state, double dt, LoopSnapshot& snapshot) noexcept override;
  [[nodiscard]] ModelContact contact() const noexcept override { return model_.contact(); }
  void check(const LoopCommand& command) const override { model_.check(command); }
  bool obey(LoopCommand& command) noexcept override { return model_.obey(command); }
  [[nodiscard]] Simulation* simulation() noexcept override { return model_.simulation(); }

 private:
  LoopModel& model_;
  IslandWatch watch_;
};

}  // namespace hapticut
