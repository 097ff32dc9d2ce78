// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "c/handles.hpp"
#include "hapticut/islands/island_watch.hpp"
#include "hapticut/settings/scene.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::c {

/// A simulation. Either a thread with its handle, in the first lane, or a loop works on it.
class SimulationObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::simulation;

  /// @param scene  whose workpiece, tool and configuration `a_simulation` has
  SimulationObject(Simulation a_simulation, settings::Scene&& scene);

  Simulation simulation;
  const std::optional<settings::Motion> motion;  ///< X_WT
  const std::optional<HeatConfig> heat;          ///< [heat] of the scene
  const Tool first_tool;                         ///< the tool of the scene, to which `motion` refers
  const RemovalLaw removal;                      ///< removal law of the scene
  const Box box;                                 ///< [m] box around the workpiece at its creation, in W
  const IndexBox bounds;                         ///< bounds of the workpiece at its creation
  const double rate;                             ///< [Hz]

  /// The number of exchanges of the tool. A coupling is valid for one tool.
  std::atomic<std::uint32_t> tool_exchanges{0};

  /// Whether a loop drives it. Then no other thread may access it.
  std::atomic<bool> driven{false};

  /// Removes pieces that are cut loose; null: they stay. Whoever takes it from here then destroys or retires it.
  std::atomic<IslandWatch*> watch{nullptr};
  std::unique_ptr<IslandWatch> watch_of_scene;  ///< while the scene demands the removal, and no handle does

  /// Continues the removal of loose pieces. To be called in the thread that makes the steps, between two steps.
  /// @realtime no allocation, no lock
  void remove_loose_pieces() noexcept {
    if (IslandWatch* const present = watch.load(std::memory_order_acquire)) present->tick();
  }

  /// @return HAPTICUT_OK, or the code of an error when a loop drives it
  [[nodiscard]] int require_idle() const noexcept;

  /// Destroys an observer of the simulation: at once if the simulation is idle, otherwise as soon as it is idle.
  void retire(std::shared_ptr<void> observer);

  /// Destroys the retired observers.  @pre the caller is in the first lane, and no loop drives the simulation
  void sweep();

 private:
  std::mutex mutex_;
  std::vector<std::shared_ptr<void>> retired_;  // after `simulation`, so destroyed before it
};

/// Gives a call access to a simulation that it may step or change: in its first lane, and not driven by a loop.
/// @realtime like Use
class IdleSimulation {
 public:
  explicit IdleSimulation(hapticut_simulation handle) noexcept : use_(handle) {
    code_ = use_ ? use_->require_idle() : use_.code();
  }
  explicit operator bool() const noexcept { return code_ == HAPTICUT_OK; }
  [[nodiscard]] int code() const noexcept { return code_; }
  SimulationObject* operator->() const noexcept { return use_.operator->(); }
  [[nodiscard]] std::shared_ptr<SimulationObject> pointer() const { return use_.pointer(); }

 private:
  Use<SimulationObject> use_;
  int code_;
};

/// Gives a call access to an idle simulation that another object owns.
class IdleStay {
 public:
  explicit IdleStay(SimulationObject& object) noexcept : stay_(object) {
    code_ = stay_ ? object.require_idle()
                  : fail(HAPTICUT_ERROR_BUSY, "Another thread is in a call with the simulation; try again.");
  }
  explicit operator bool() const noexcept { return code_ == HAPTICUT_OK; }
  [[nodiscard]] int code() const noexcept { return code_; }

 private:
  Stay stay_;
  int code_;
};

/// @throws Refusal when the workpiece has no material with the id, which counts from 1
void require_material(const Workpiece& workpiece, std::uint32_t id);

/// Makes a tool from a text in TOML with a table [tool]. The cutter is that of `before`, because the materials depend
/// on it.
/// @throws Error like settings::from_toml, and for another cutter
[[nodiscard]] Tool tool_from_toml(const char* text, const Tool& before);

/// Fills in all fields except the wrench and the pose.
void put_step(const StepResult& stepped, hapticut_step_result& result) noexcept;

}  // namespace hapticut::c
