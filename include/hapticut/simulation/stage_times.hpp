// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut {

/// [s] Wall time of the stages of one step, summed over its sub-steps; each is named like its stage (docs/step.md). All
/// zero unless SimulationConfig::stage_times is set.
struct StageTimes {
  double check_input = 0;
  double plan_sweep = 0;
  double plan_sub_step = 0;
  double find_blocks = 0;
  double press_and_cut = 0;
  double remove_emptied = 0;
  double hold_deep_contact = 0;
  double add_friction = 0;
  double book_energy = 0;
  double transport_to_handle = 0;
  double give_output = 0;
};

}  // namespace hapticut
