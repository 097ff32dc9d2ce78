// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hapticut/core/description.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/step.hpp"
#include "hapticut/workpiece/material_set.hpp"

namespace hapticut {

/// The effort of a tick.
struct TickEffort {
  int sub_ticks = 0;        ///< [1] steps of the simulation
  int newton_steps = 0;     ///< [1] Newton steps of the coupling, in all of them
  int level_of_detail = 1;  ///< [1] Contact::level_of_detail, the maximum over the steps
};

constexpr auto fields_of(Of<TickEffort>) {
  using E = TickEffort;
  return std::tuple{
      field("sub_ticks", &E::sub_ticks, "1", "steps of the simulation"),
      field("newton_steps", &E::newton_steps, "1", "Newton steps of the coupling, in all of them"),
      field("level_of_detail", &E::level_of_detail, "1", "Contact::level_of_detail, the maximum over the steps"),
  };
}

/// The state of a model's tool in the last tick.
struct ToolSnapshot {
  Vec3 force = Vec3::Zero();                ///< [N] force commanded for the hand, in W
  Vec3 torque = Vec3::Zero();               ///< [N m] torque commanded for the hand, about Ho, in W
  double removed_volume = 0;                ///< [m^3] volume removed since the loop began
  double dissipated = 0;                    ///< [J] EnergyLedger::losses since the loop began
  double contact_depth = 0;                 ///< [m] maximum depth below the cutting surface
  int contact_voxels = 0;                   ///< [1] voxels inside the head that are not empty
  Vec3 contact_point_W = Vec3::Zero();      ///< [m] Contact::point_W, in W; zero while the head touches nothing
  double spindle_speed = 0;                 ///< [rad/s] speed of the spindle about its axis
  StepStatus status = StepStatus::ok;       ///< bits of the last step
  StepStatus status_seen = StepStatus::ok;  ///< bits of all steps since the loop began
  std::uint64_t steps = 0;                  ///< [1] steps since the loop began
  TickEffort effort;                        ///< effort of the last tick
  TickEffort max_effort;                    ///< maximum of each value since the loop began
  std::size_t undo_marks = 0;               ///< [1] marks that `Undo` can return to
  std::size_t redo_marks = 0;               ///< [1] undone marks that `Redo` can restore
  /// Whether an undo is in progress; nothing is felt or cut then, and the values of a step are 0.
  bool undoing = false;
  bool redoing = false;     ///< whether a redo is in progress, with the same effect
  bool force_held = false;  ///< whether HoldForce holds the force
  /// Materials touched since the simulation was made or reset, SimulationTotals::touched; a new one is an event.
  MaterialSet touched;
  std::uint32_t workpiece = 0;  ///< [1] number of exchanges since the loop began: ChangedBlock::workpiece
};

constexpr auto fields_of(Of<ToolSnapshot>) {
  using T = ToolSnapshot;
  return std::tuple{
      field("force", &T::force, "N", "force commanded for the hand, in W"),
      field("torque", &T::torque, "N m", "torque commanded for the hand, about Ho, in W"),
      field("removed_volume", &T::removed_volume, "m^3", "volume removed since the loop began"),
      field("dissipated", &T::dissipated, "J", "EnergyLedger::losses since the loop began"),
      field("contact_depth", &T::contact_depth, "m", "maximum depth below the cutting surface"),
      field("contact_voxels", &T::contact_voxels, "1", "voxels inside the head that are not empty"),
      field("contact_point_W", &T::contact_point_W, "m", "Contact::point_W, in W; zero while the head touches nothing"),
      field("spindle_speed", &T::spindle_speed, "rad/s", "speed of the spindle about its axis"),
      field("status", &T::status, "bits of the last step"),
      field("status_seen", &T::status_seen, "bits of all steps since the loop began"),
      field("steps", &T::steps, "1", "steps since the loop began"),
      field("effort", &T::effort, "effort of the last tick"),
      field("max_effort", &T::max_effort, "maximum of each value since the loop began"),
      field("undo_marks", &T::undo_marks, "1", "marks that `Undo` can return to"),
      field("redo_marks", &T::redo_marks, "1", "undone marks that `Redo` can restore"),
      field("undoing", &T::undoing,
            "whether an undo is in progress; nothing is felt or cut then, and the values of a step are 0"),
      field("redoing", &T::redoing, "whether a redo is in progress, with the same effect"),
      field("force_held", &T::force_held, "whether HoldForce holds the force"),
      field(
          "touched", &T::touched,
          "materials touched since the simulation was made or reset, SimulationTotals::touched; a new one is an event"),
      field("workpiece", &T::workpiece, "1", "number of exchanges since the loop began: ChangedBlock::workpiece"),
  };
}

/// The state of a loop after its last tick, for a screen.
struct LoopSnapshot {
  std::uint64_t tick = 0;                 ///< [1] ticks since the loop began
  DeviceState device;                     ///< readings of the device, as admitted by the guard
  DeviceOutput output;                    ///< output of the previous tick
  double max_commanded = 0;               ///< [N] maximum commanded force since the loop was made
  double max_applied = 0;                 ///< [N] maximum applied force since the loop was made
  ArmingState arming = ArmingState::off;  ///< state of the guard
  std::uint64_t commands_dropped = 0;     ///< [1] commands that found the queue full
  std::uint64_t commands_refused = 0;     ///< [1] commands that did not suit the objects in place
  std::size_t blocks_waiting = 0;         ///< [1] changed blocks that are not yet sent
  /// [1] changes outside RealtimeLoopOptions::region, and the blocks of exchanged workpieces there; they are not sent
  std::uint64_t blocks_outside = 0;
  Pose X_WT;          ///< pose of the head; filled in by the model
  ToolSnapshot tool;  ///< state of the tool; filled in by the model
};

constexpr auto fields_of(Of<LoopSnapshot>) {
  using L = LoopSnapshot;
  return std::tuple{
      field("tick", &L::tick, "1", "ticks since the loop began"),
      field("device", &L::device, "readings of the device, as admitted by the guard"),
      field("output", &L::output, "output of the previous tick"),
      field("max_commanded", &L::max_commanded, "N", "maximum commanded force since the loop was made"),
      field("max_applied", &L::max_applied, "N", "maximum applied force since the loop was made"),
      field("arming", &L::arming, "state of the guard"),
      field("commands_dropped", &L::commands_dropped, "1", "commands that found the queue full"),
      field("commands_refused", &L::commands_refused, "1", "commands that did not suit the objects in place"),
      field("blocks_waiting", &L::blocks_waiting, "1", "changed blocks that are not yet sent"),
      field("blocks_outside", &L::blocks_outside, "1",
            "changes outside RealtimeLoopOptions::region, and the blocks of exchanged workpieces there; they are not "
            "sent"),
      field("X_WT", &L::X_WT, "pose of the head; filled in by the model"),
      field("tool", &L::tool, "state of the tool; filled in by the model"),
  };
}

}  // namespace hapticut
