// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hapticut/core/device_state.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/simulation/step.hpp"

namespace hapticut {

/// How much there was to do in a tick.
struct TickEffort {
  int parts = 0;            ///< steps of the simulation
  int newton_steps = 0;     ///< of the coupling, in all of them
  int level_of_detail = 1;  ///< Contact::level_of_detail, the largest of them
};

/// What a model shows of its tool in its last tick.
struct ToolSnapshot {
  Vec3 force = Vec3::Zero();   ///< [N] what the hand is meant to feel, in W
  Vec3 torque = Vec3::Zero();  ///< [N·m] about Ho, in W
  double removed_volume = 0;   ///< [m^3] since the loop began
  double dissipated = 0;       ///< [J] EnergyLedger::losses since the loop began
  double contact_depth = 0;    ///< [m]
  int contact_voxels = 0;
  Vec3 contact_point_W = Vec3::Zero();  ///< [m] Contact::point_W, in W; zero while the head touches nothing
  double spindle_speed = 0;             ///< [rad/s]
  StepStatus status = StepStatus::ok;   ///< of the last step
  StepStatus seen = StepStatus::ok;     ///< of all steps since the loop began
  std::uint64_t steps = 0;              ///< since the loop began
  TickEffort effort;                    ///< in the last tick
  TickEffort max_effort;                ///< the most of each since the loop began
  std::size_t undo_marks = 0;           ///< that can be returned to
  std::size_t redo_marks = 0;           ///< undone ones that can be gone forth over
  bool undoing = false;         ///< on the way back to a mark: nothing is felt or cut, and what is of a step is 0
  bool redoing = false;         ///< on the way forth: the same
  bool force_held = false;      ///< by HoldForce
  std::uint32_t workpiece = 0;  ///< how often it was exchanged since the loop began: ChangedBlock::workpiece
};

/// What the loop shows of its last tick, for a screen.
struct LoopSnapshot {
  std::uint64_t tick = 0;
  DeviceState device;        ///< as the guard let it through
  DeviceOutput output;       ///< of the tick before
  double max_commanded = 0;  ///< [N] of the outputs of all ticks since the loop was made
  double max_applied = 0;    ///< [N] likewise, by the guard
  ArmingState arming = ArmingState::off;
  std::uint64_t commands_dropped = 0;  ///< that found the queue full
  std::uint64_t commands_refused = 0;  ///< that did not suit what was in place when they were to be obeyed
  std::size_t blocks_waiting = 0;      ///< changed and not yet sent
  std::uint64_t blocks_outside = 0;    ///< changed outside of RealtimeLoopOptions::region, so not sent
  Pose X_WT;                           ///< the tool as the model sees it; filled in by the model
  ToolSnapshot tool;                   ///< filled in by the model
};

}  // namespace hapticut
