// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/workpiece/material_set.hpp"

namespace hapticut {

/// The effort of a tick.
struct TickEffort {
  int parts = 0;            ///< steps of the simulation
  int newton_steps = 0;     ///< Newton steps of the coupling, in all of them
  int level_of_detail = 1;  ///< Contact::level_of_detail, the maximum over the steps
};

/// The state of a model's tool in the last tick.
struct ToolSnapshot {
  Vec3 force = Vec3::Zero();   ///< [N] commanded for the hand, in W
  Vec3 torque = Vec3::Zero();  ///< [N·m] about Ho, in W
  double removed_volume = 0;   ///< [m^3] since the loop began
  double dissipated = 0;       ///< [J] EnergyLedger::losses since the loop began
  double contact_depth = 0;    ///< [m]
  int contact_voxels = 0;
  Vec3 contact_point_W = Vec3::Zero();      ///< [m] Contact::point_W, in W; zero while the head touches nothing
  double spindle_speed = 0;                 ///< [rad/s]
  StepStatus status = StepStatus::ok;       ///< bits of the last step
  StepStatus status_seen = StepStatus::ok;  ///< bits of all steps since the loop began
  std::uint64_t steps = 0;                  ///< since the loop began
  TickEffort effort;                        ///< values of the last tick
  TickEffort max_effort;                    ///< maximum of each value since the loop began
  std::size_t undo_marks = 0;               ///< marks that `Undo` can return to
  std::size_t redo_marks = 0;               ///< undone marks that `Redo` can restore
  bool undoing = false;     ///< an undo is in progress: nothing is felt or cut, and the values of a step are 0
  bool redoing = false;     ///< a redo is in progress, with the same effect
  bool force_held = false;  ///< by HoldForce
  MaterialSet touched;  ///< since the simulation was made or reset: SimulationTotals::touched. A new one is an event
  std::uint32_t workpiece = 0;  ///< number of exchanges since the loop began: ChangedBlock::workpiece
};

/// The state of a loop after its last tick, for a screen.
struct LoopSnapshot {
  std::uint64_t tick = 0;
  DeviceState device;        ///< as admitted by the guard
  DeviceOutput output;       ///< output of the previous tick
  double max_commanded = 0;  ///< [N] maximum commanded force since the loop was made
  double max_applied = 0;    ///< [N] maximum applied force since the loop was made
  ArmingState arming = ArmingState::off;
  std::uint64_t commands_dropped = 0;  ///< commands that found the queue full
  std::uint64_t commands_refused = 0;  ///< commands that did not suit the objects in place
  std::size_t blocks_waiting = 0;      ///< changed blocks that are not yet sent
  std::uint64_t blocks_outside = 0;    ///< changes outside RealtimeLoopOptions::region, and the blocks of exchanged
                                       ///< workpieces there; they are not sent
  Pose X_WT;                           ///< pose of the head; filled in by the model
  ToolSnapshot tool;                   ///< filled in by the model
};

}  // namespace hapticut
