// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "hapticut/core/abi.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

class Simulation;

/// Earlier states of a simulation's workpiece, and the ways back to them, between two steps:
/// `simulation.history().undo(64)`. After each way back the next step is the first of the tool
/// (`Simulation::next_step_is_first`). `Simulation::workpiece()` has `snapshot`, and counts the marks.
class WorkpieceHistory {
 public:
  /// Restores a state that Workpiece::snapshot has saved.
  void restore(const WorkpieceSnapshot& snapshot);

  /// Reserves memory for `mark` and `undo`, also for workpieces of a later `Simulation::reset`: see
  /// Workpiece::reserve_undo.
  void reserve(std::size_t blocks);

  /// Marks the present state of the workpiece, for `undo`.
  /// @return false when there is no mark, because `reserve` was not called
  /// @realtime no allocation, no lock; O(1)
  bool mark() noexcept;

  /// Restores the state of the last mark, by up to `max_blocks` blocks a call (at least one), 0.3 us each;
  /// `Simulation::changed_blocks` then lists them. Call it until it returns true: the workpiece is then as at the mark,
  /// and the mark is gone. Removed volumes are not reduced.
  /// @return true when it is done, or there is no mark
  /// @realtime no allocation, no lock; O(max_blocks)
  bool undo(std::size_t max_blocks) noexcept;

  /// Redoes the last `undo`: restores the state before it, and its mark. Called as `undo` is. Needs no memory beyond
  /// that of `reserve`. Cutting discards all redo marks.
  /// @return true when it is done, or nothing was undone
  /// @realtime no allocation, no lock; O(max_blocks)
  bool redo(std::size_t max_blocks) noexcept;

 private:
  friend class Simulation;
  explicit WorkpieceHistory(Simulation& simulation) noexcept : simulation_(simulation) {}
  Simulation& simulation_;
};

}  // namespace hapticut
