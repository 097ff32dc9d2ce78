// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "c/handles.hpp"
#include "hapticut/settings/motion.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::c {

/// A simulation, and who works on it: threads with its handle in the first lane, or a loop.
class SimulationObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::simulation;

  SimulationObject(Simulation a_simulation, std::optional<settings::Motion> a_motion);

  Simulation simulation;
  const std::optional<settings::Motion> motion;  ///< X_WT
  const Tool first_tool;                         ///< with the places of `motion`
  const RemovalLaw removal;                      ///< of the scene
  const Box box;                                 ///< [m] in W, of the workpiece in the beginning
  const IndexBox bounds;                         ///< the same in voxels
  const double rate;                             ///< [Hz]

  /// How often it got another tool: a coupling is made for one.
  std::atomic<std::uint32_t> tools{0};

  /// A loop drives it, and no thread may touch it.
  std::atomic<bool> driven{false};

  /// Says so when a loop drives it.
  [[nodiscard]] int require_idle() const noexcept;

  /// Ends what observes the simulation: at once where nobody works on it, else as soon as that is over.
  void retire(std::shared_ptr<void> observer);

  /// Ends what has retired.  @pre the first lane is the caller's, and no loop drives
  void sweep();

 private:
  std::mutex mutex_;
  std::vector<std::shared_ptr<void>> retired_;  // behind `simulation`: ends before it
};

/// A simulation that a call may step or change: in its first lane, and not driven by a loop.
/// @realtime as Use
class IdleSimulation {
 public:
  explicit IdleSimulation(hapticut_simulation handle) noexcept : use_(handle) {
    code_ = use_ ? use_->require_idle() : use_.code();
  }
  explicit operator bool() const noexcept { return code_ == HAPTICUT_OK; }
  [[nodiscard]] int code() const noexcept { return code_; }
  SimulationObject* operator->() const noexcept { return use_.operator->(); }
  [[nodiscard]] std::shared_ptr<SimulationObject> share() const { return use_.share(); }

 private:
  Use<SimulationObject> use_;
  int code_;
};

/// The same of a simulation that another object holds.
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

/// What a text in TOML with a table [tool] describes, with the cutter that the materials are for, that of `before`.
/// @throws Error as settings::from_toml, and for another cutter
[[nodiscard]] Tool tool_from_toml(const char* text, const Tool& before);

/// Fills in all but the wrench and the pose.
void put_step(const StepResult& stepped, hapticut_step_result& result) noexcept;

}  // namespace hapticut::c
