// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/block_outbox.hpp"
#include "hapticut/simulation/observer.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// How changed blocks are sent to another thread.
struct ChangeFeedOptions {
  std::size_t block_capacity = 256;  ///< [blocks] length of the queue; 2.6 kB a block
  std::size_t blocks_per_step = 16;  ///< [blocks] sent per step at most; 0.5 us each
};

constexpr auto fields_of(Of<ChangeFeedOptions>) {
  using O = ChangeFeedOptions;
  return std::tuple{
      field("block_capacity", &O::block_capacity, "blocks", Range::between(1, 1e6),
            "length of the queue; 2.6 kB a block"),
      field("blocks_per_step", &O::blocks_per_step, "blocks", Range::positive(), "sent per step at most; 0.5 us each"),
  };
}

/// An observer of the simulation that sends copies of changed blocks to one other thread. When the changes are unknown,
/// for example after an exchange of the workpiece, it sends all blocks again: a few at a time, in half of the places
/// that are free, and in those that changed blocks leave free.
class ChangeFeed final : public StepObserver {
 public:
  /// Attaches to the simulation for the lifetime of the feed, and sends with each step. Covers the blocks within
  /// Simulation::first_bounds; a workpiece of other bounds needs another feed. ChangedBlock::workpiece counts the
  /// replacements of the workpiece since then (SimulationTotals::replacements).
  /// @param simulation  must outlive the feed, and must not be moved
  /// @throws Error as BlockOutbox, or when an option is out of range or the simulation has too many observers
  explicit ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options = {});

  /// For a loop that calls `attach`, and `tick` in every tick. Sends only in `tick`.
  /// @param region  voxels whose blocks are sent
  /// @throws Error as BlockOutbox
  ChangeFeed(Simulation& simulation, const IndexBox& region, std::size_t block_capacity);
  ~ChangeFeed() override;
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// Observes the simulation from now on, until `detach`. Not during a step. Sends all blocks again when the workpiece
  /// may have changed since `detach`.
  /// @throws Error when the simulation has too many observers
  void attach();

  /// Ends the observation. Not during a step.
  void detach() noexcept;

  /// Sends changed blocks, also in a tick without a step.
  /// @param max_blocks        [blocks] to be sent at most
  /// @param workpiece_number  ChangedBlock::workpiece
  /// @realtime no allocation, no lock; O(max_blocks)
  void tick(std::size_t max_blocks, std::uint32_t workpiece_number) noexcept;

  /// Keeps all blocks that are not yet sent for `receive`, in memory beyond the queue: for the end of a loop. `attach`
  /// sends those that were not received until then again. For the thread that uses the simulation.
  /// @param workpiece_number  ChangedBlock::workpiece
  void keep_rest(std::uint32_t workpiece_number);

  /// The number of blocks that are not yet sent. For the thread that makes the steps.
  [[nodiscard]] std::size_t waiting() const noexcept { return outbox_.marked() + all_ - swept_; }

  /// The number of changes of blocks outside the region, and of blocks outside it of workpieces that came later. For
  /// the thread that makes the steps.
  [[nodiscard]] std::uint64_t outside() const noexcept { return outbox_.outside(); }

  /// Receives one block. For the receiving thread.  @return false when the queue is empty
  bool receive(ChangedBlock& block) { return outbox_.receive(block); }

  /// Marks a block to be sent, whether it has changed or not. For the thread that makes the steps.
  /// @realtime no allocation, no lock; O(1)
  void mark(const VoxelIndex& origin) noexcept { outbox_.mark(origin); }

  /// Whether a marked or changed block is not yet sent. For the thread that makes the steps.
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] bool is_waiting(const VoxelIndex& origin) const noexcept { return outbox_.is_marked(origin); }

  /// Sends all blocks again. For the thread that makes the steps.
  /// @realtime no allocation, no lock; O(1)
  void send_all() noexcept { swept_ = 0; }

  /// @realtime no allocation, no lock; O(blocks_per_step)
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override;
  void on_removal(const BlockVoxels& removed) noexcept override { outbox_.mark(removed.origin); }

 private:
  /// Counts that differ when the workpiece may have changed.
  struct Counts {
    std::uint64_t steps, exchanges;
    ByMaterial<double> detached;
    [[nodiscard]] bool operator==(const Counts&) const = default;
  };

  void mark_changes() noexcept;
  void note_replacement() noexcept;
  [[nodiscard]] Counts counts() const noexcept;

  Simulation& simulation_;
  BlockOutbox outbox_;
  std::size_t all_, swept_;            // [blocks] number in the region; [blocks] marked since all must be sent
  std::size_t per_step_ = 0;           // [blocks]
  bool sweeps_more_ = false;           // the sweep gets the odd place
  std::uint64_t workpiece_ = 0;        // SimulationTotals::replacements when it was last looked at
  std::uint64_t first_workpiece_ = 0;  // SimulationTotals::replacements
  std::optional<Counts> at_detach_;    // empty before the first `detach`
  bool is_observing_ = false;
};

}  // namespace hapticut
