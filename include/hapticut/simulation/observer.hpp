// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hapticut/simulation/step.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {

class Simulation;

/// The wrench that a coupling renders to the hand.
struct HandOutput {
  Pose X_WD;      ///< pose of the hand's handle
  Wrench wrench;  ///< about Ho of the hand, in W, on the hand; before effects and limits
  double dt = 0;  ///< [s] since the last output
};

/// Maps the tool's wrench to the hand's. Once the force of the model is known, a step asks it for the wrench to render
/// instead of that force; effects and limits then act on this wrench.
class HandCoupling {
 public:
  virtual ~HandCoupling() = default;

  /// @param stepped  result of this step; `force` and `torque` are still those of the last step
  /// @return empty: the hand keeps its last output, as in all sub-ticks of a tick except the last
  /// @realtime no allocation, no lock
  [[nodiscard]] virtual std::optional<HandOutput> answer(const StepResult& stepped) noexcept = 0;
};

/// Which path the force of a step took to the hand.
enum class OutputPath : std::uint8_t {
  direct,   ///< the hand holds the tool
  coupled,  ///< through a coupling
  kept,     ///< a coupling moves the tool, and kept the last output, or the step was rejected
};

/// A step that is complete, as an observer sees it.
struct ObservedStep {
  const Simulation& simulation;  ///< that took the step
  std::uint64_t number;          ///< steps before it, since construction or `Simulation::reset`
  const StepInput& input;        ///< pose, velocity and dt of the step
  std::size_t free_blocks;       ///< reserved blocks that were left when the step began
  bool hand_released;            ///< the hand had released the tool before it: see Simulation::release_hand
  bool halted;                   ///< the spindle had been halted before it: see SpindleDrive::halt
  bool spindle_set;              ///< its speed had been set before it, after the last halt, perhaps to the same value
  bool spindle_held;             ///< it is held at standstill: see SpindleDrive::hold
  double spindle_setting;        ///< [rad/s] speed setting of the spindle; 0 while it is held
  OutputPath path;               ///< path of the force
  const HandOutput& hand;        ///< output of the coupling, when `path` is coupled
  const StepResult& result;      ///< result of the step
};

/// Observes every step of a simulation, including those that a loop or a coupling takes: see Simulation::observers.
class StepObserver {
 public:
  virtual ~StepObserver() = default;

  /// Called at the end of a step, in its thread, also when the input was rejected.
  /// @realtime no allocation, no lock, unless the observer documents them
  virtual void on_step(const ObservedStep& step) noexcept = 0;

  /// Called between two steps, when something other than a step has changed the workpiece, tool or materials: see
  /// SimulationTotals::exchanges.
  virtual void on_exchange() noexcept {}

  /// Called between two steps, when voxels were removed without cutting: see Simulation::remove_voxels.
  virtual void on_removal(const BlockVoxels& /*removed*/) noexcept {}
};

/// The observers of a simulation, in the order in which they are told of a step.
class StepObservers {
 public:
  static constexpr std::size_t kMax = 8;

  /// Adds an observer, which is told of every step from now on. It must live until it is removed.
  /// @throws Error when it was added already, or there are kMax
  void add(StepObserver& observer);

  void remove(StepObserver& observer) noexcept;  ///< does nothing if it was not added
  [[nodiscard]] std::span<StepObserver* const> all() const noexcept { return {observers_.data(), count_}; }

 private:
  std::array<StepObserver*, kMax> observers_ = {};
  std::size_t count_ = 0;
};

}  // namespace hapticut
