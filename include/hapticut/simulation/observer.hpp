// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "hapticut/simulation/step.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {

class Simulation;

/// What the hand is given where a coupling stands between it and the tool.
struct HandOutput {
  Pose X_WD;      ///< of the hand's handle
  Wrench wrench;  ///< about Ho of the hand, in W, on the hand; before effects and limits
  double dt = 0;  ///< [s] since it was last given something
};

/// Stands between the tool and the hand. A step asks it, once the force of the model is known, what the hand is to be
/// given instead of that force; the effects and limits then act on it.
class HandCoupling {
 public:
  virtual ~HandCoupling() = default;

  /// @param stepped  of this step; `force` and `torque` are still those of the last one
  /// @return nothing: the hand keeps what it has, as in all parts of a tick but the last
  /// @realtime no allocation, no lock
  [[nodiscard]] virtual std::optional<HandOutput> answer(const StepResult& stepped) noexcept = 0;
};

/// Which way the force of a step took to the hand.
enum class OutputPath : std::uint8_t {
  direct,   ///< the hand holds the tool
  coupled,  ///< through a coupling
  kept,     ///< the coupling left the hand what it had
};

/// A step that is complete, as an observer sees it.
struct ObservedStep {
  const Simulation& simulation;  ///< that made it
  std::uint64_t number;          ///< steps before it, since construction or `Simulation::reset`
  const StepInput& input;        ///< what it was given
  std::size_t free_blocks;       ///< reserved blocks that were left when it began
  bool hand_released;            ///< the hand had let go before it: see Simulation::release_hand
  bool halted;                   ///< the spindle had been made to stand before it: see Simulation::halt_spindle
  double spindle_setting;        ///< [rad/s] asked of the spindle in it; 0 while it is held
  OutputPath path;               ///< of its force
  const HandOutput& hand;        ///< of the coupling, where `path` is coupled
  const StepResult& result;      ///< what came of it
};

/// Is told of every step of a simulation, also of those that a loop or a coupling makes: see Simulation::add_observer.
class StepObserver {
 public:
  virtual ~StepObserver() = default;

  /// At the end of a step, in its thread; also of one whose input was rejected.
  /// @realtime no allocation, no lock beyond what the observer says
  virtual void on_step(const ObservedStep& step) noexcept = 0;

  /// Between two steps, when something else has changed what steps meet: see Simulation::workpiece_exchanges.
  virtual void on_exchange() noexcept {}

  /// Between two steps, when voxels were taken out that nothing has cut: see Simulation::remove_voxels.
  virtual void on_removal(const BlockVoxels& /*removed*/) noexcept {}
};

}  // namespace hapticut
