// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// [s] Wall time of the stages of one step, summed over its sub-steps. Each field has the name of its stage
/// (docs/step.md). All zero unless SimulationConfig::stage_times is set.
struct StageTimes {
  double check_input = 0;          ///< [s] check of the input
  double find_start = 0;           ///< [s] pose from which the tool moves
  double plan_sweep = 0;           ///< [s] number of sub-steps
  double plan_sub_step = 0;        ///< [s] pose and twist of a sub-step
  double find_blocks = 0;          ///< [s] search for the blocks that the head may touch
  double drive_spindle = 0;        ///< [s] speed of a motor with limits, under the load
  double press_and_cut = 0;        ///< [s] force, energies and new fills
  double remove_emptied = 0;       ///< [s] removal of voxels that became empty
  double tether_deep_ball = 0;     ///< [s] force on a ball pushed beyond its radius
  double add_friction = 0;         ///< [s] dry friction of a standing head
  double book_energy = 0;          ///< [s] work of hand and motor, and energies
  double transport_to_handle = 0;  ///< [s] force and torque about Ho
  double advance_spindle = 0;      ///< [s] ramp and inertia of the motor
  double give_output = 0;          ///< [s] output to the hand
};

constexpr auto fields_of(Of<StageTimes>) {
  using T = StageTimes;
  return std::tuple{
      field("check_input", &T::check_input, "s", "check of the input"),
      field("find_start", &T::find_start, "s", "pose from which the tool moves"),
      field("plan_sweep", &T::plan_sweep, "s", "number of sub-steps"),
      field("plan_sub_step", &T::plan_sub_step, "s", "pose and twist of a sub-step"),
      field("find_blocks", &T::find_blocks, "s", "search for the blocks that the head may touch"),
      field("drive_spindle", &T::drive_spindle, "s", "speed of a motor with limits, under the load"),
      field("press_and_cut", &T::press_and_cut, "s", "force, energies and new fills"),
      field("remove_emptied", &T::remove_emptied, "s", "removal of voxels that became empty"),
      field("tether_deep_ball", &T::tether_deep_ball, "s", "force on a ball pushed beyond its radius"),
      field("add_friction", &T::add_friction, "s", "dry friction of a standing head"),
      field("book_energy", &T::book_energy, "s", "work of hand and motor, and energies"),
      field("transport_to_handle", &T::transport_to_handle, "s", "force and torque about Ho"),
      field("advance_spindle", &T::advance_spindle, "s", "ramp and inertia of the motor"),
      field("give_output", &T::give_output, "s", "output to the hand"),
  };
}

}  // namespace hapticut
