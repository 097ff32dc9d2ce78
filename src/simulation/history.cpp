// SPDX-License-Identifier: Apache-2.0
// The ways back to earlier states of the workpiece.
#include "hapticut/simulation/simulation.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {

void WorkpieceHistory::restore(const WorkpieceSnapshot& snapshot) {
  Simulation::State& s = *simulation_.state_;
  s.workpiece.restore(snapshot);
  s.contact_stages.restart();
  ++s.totals.replacements;
  s.forget_pose();
}

void WorkpieceHistory::reserve(std::size_t blocks) { simulation_.state_->workpiece.reserve_undo(blocks); }

bool WorkpieceHistory::mark() noexcept { return simulation_.state_->workpiece.set_mark(); }

bool WorkpieceHistory::undo(std::size_t max_blocks) noexcept {
  Simulation::State& s = *simulation_.state_;
  s.contact_stages.forget_changes();
  const std::size_t marks = s.workpiece.marks();
  if (marks == 0) return true;
  s.totals.altered = true;
  s.contact_stages.undo(max_blocks);
  s.forget_pose();
  return s.workpiece.marks() < marks;
}

bool WorkpieceHistory::redo(std::size_t max_blocks) noexcept {
  Simulation::State& s = *simulation_.state_;
  s.contact_stages.forget_changes();
  if (s.workpiece.redo_marks() == 0) return true;
  s.totals.altered = true;
  const bool done = s.contact_stages.redo(max_blocks);
  s.forget_pose();
  return done;
}

}  // namespace hapticut
