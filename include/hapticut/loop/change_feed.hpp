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
      field("blocks_per_step", &O::blocks_per_step, "blocks", Range::positive(), "sent at most; 0.5 us each"),
  };
}

/// Copies of the blocks that change, for one other thread that works beside any loop: an observer of the simulation,
/// from its construction to its end. After an exchange, an undo or a redo, and where a step cannot list what it has
/// changed, every block is sent again, a few with each step.
///
/// The blocks are those within the bounds that the workpiece had in the beginning: for a workpiece of other bounds make
/// another feed.
class ChangeFeed final : public StepObserver {
 public:
  /// @param simulation  must outlive it, and stay where it is
  /// @throws Error as BlockOutbox, or when an option is out of range or the simulation has too many observers
  explicit ChangeFeed(Simulation& simulation, const ChangeFeedOptions& options = {});
  ~ChangeFeed() override;
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// Takes one block. For the receiving thread.  @return false when there is none
  bool receive(ChangedBlock& block) { return outbox_.receive(block); }

  /// Sends a block again, whether it has changed or not. For the thread that makes the steps.
  /// @realtime no allocation, no lock; O(1)
  void mark(const VoxelIndex& origin) noexcept { outbox_.mark(origin); }

  /// @realtime no allocation, no lock; O(blocks_per_step)
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override { swept_ = 0; }
  void on_removal(const BlockVoxels& removed) noexcept override { outbox_.mark(removed.origin); }

 private:
  void sweep() noexcept;

  Simulation& simulation_;
  std::size_t per_step_;
  BlockOutbox outbox_;
  BlockOutbox::Copy copy_;
  std::size_t all_, swept_;  // blocks; of them marked since the last exchange
};

}  // namespace hapticut
