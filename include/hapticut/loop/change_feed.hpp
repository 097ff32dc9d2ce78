// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hapticut/core/description.hpp"
#include "hapticut/loop/block_outbox.hpp"
#include "hapticut/simulation/observer.hpp"

namespace hapticut {

/// How changed blocks are fed to another thread.
struct ChangeFeedOptions {
  std::size_t block_capacity = 256;
  std::size_t blocks_per_step = 16;
};

constexpr auto fields_of(Of<ChangeFeedOptions>) {
  using O = ChangeFeedOptions;
  return std::tuple{
      field("block_capacity", &O::block_capacity, "blocks", Range::between(1, 1e6), "under way at once; 2.6 kB each"),
      field("blocks_per_step", &O::blocks_per_step, "blocks", Range::positive(), "sent at max_blocks; 0.5 us each"),
  };
}

/// Copies of the blocks that change, for one other thread that works beside any loop: an observer of the simulation.
/// Where nobody can list what has changed, as after another workpiece was put in place, every block is sent again, a
/// few at a time and after those that are known to have changed.
class ChangeFeed final : public StepObserver {
 public:
  /// Follows the simulation to its own end, and sends with each step. The blocks are those within the bounds that the
  /// workpiece has now: for a workpiece of other bounds make another feed.
  /// @param simulation  must outlive it, and stay where it is
  /// @throws Error as BlockOutbox, or when an option is out of range or the simulation has too many observers
  explicit ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options = {});

  /// For a loop that says from when on it is to `attach`, and sends by `tick` alone.
  /// @param region  voxels whose blocks are sent
  /// @throws Error as BlockOutbox
  ChangeFeed(Simulation& simulation, const IndexBox& region, std::size_t block_capacity);
  ~ChangeFeed() override;
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// From now on, until `detach`. While no step is made.
  /// @throws Error when the simulation has too many observers
  void attach();
  void detach() noexcept;

  /// Sends what has changed, with a step or without.
  /// @param max_blocks              blocks
  /// @param workpiece_number  ChangedBlock::workpiece
  /// @realtime no allocation, no lock; O(max_blocks)
  void tick(std::size_t max_blocks, std::uint32_t workpiece_number) noexcept;

  /// Blocks that are still to be sent. For the thread that makes the steps.
  [[nodiscard]] std::size_t waiting() const noexcept { return outbox_.marked() + all_ - swept_; }

  /// How often a block outside of the region has changed. For the thread that makes the steps.
  [[nodiscard]] std::uint64_t outside() const noexcept { return outbox_.outside(); }

  /// Takes one block. For the receiving thread.  @return false when there is none
  bool receive(ChangedBlock& block) { return outbox_.receive(block); }

  /// Sends a block again, whether it has changed or not. For the thread that makes the steps.
  /// @realtime no allocation, no lock; O(1)
  void mark(const VoxelIndex& origin) noexcept { outbox_.mark(origin); }

  /// @realtime no allocation, no lock; O(blocks_per_step)
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override { mark_changes(); }
  void on_removal(const BlockVoxels& removed) noexcept override { outbox_.mark(removed.origin); }

 private:
  void mark_changes() noexcept;

  Simulation& simulation_;
  BlockOutbox outbox_;
  std::size_t all_, swept_;   // blocks; of them marked since all were to be sent
  std::size_t per_step_ = 0;  // blocks
  bool is_observing_ = false;
};

}  // namespace hapticut
