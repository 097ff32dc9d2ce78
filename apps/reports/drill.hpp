// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/settings/motion.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "reports/beside_steps.hpp"

namespace hapticut::apps {

/// One row of the per-step file.
struct StepRow {
  double t;        ///< [s] at the end of the step
  Pose X_WT;       ///< pose of the head
  Vec3 force;      ///< [N] on the tool, in W
  Vec3 torque;     ///< [N·m] about Ho, in W
  double removed;  ///< [m^3] removed volume
  int contact_voxels;
  StepStatus status;
};

/// Processor time of the steps, in microseconds.
struct StepTimes {
  double p50 = 0, p99 = 0, p999 = 0, max = 0;
  std::size_t deadline_misses = 0;  ///< steps longer than a millisecond
};

/// Result of moving a tool through a workpiece.
struct DrillResult {
  std::size_t steps = 0;
  std::size_t steps_in_contact = 0;
  std::size_t steps_cutting = 0;   ///< that removed volume
  std::size_t steps_too_soft = 0;  ///< those of them with a turning spindle and StepStatus::engaged_layer_thick
  std::size_t steps_rejected = 0;  ///< with a bit of kRejected
  std::size_t first_rejected = 0;  ///< number of the first of these, from 1; 0: none
  std::size_t removed_voxels = 0;
  double removed_volume = 0;               ///< [m^3]
  double max_force = 0, mean_force = 0;    ///< [N]; mean over the steps in contact
  double max_torque = 0, mean_torque = 0;  ///< [N·m] about Ho; mean over the steps in contact
  bool starts_in_contact = false;
  bool blocks_refilled = false;
  ByMaterial<double> pressed = {};  ///< [N] sum over the steps of Simulation::normal_forces
  double max_feed = 0;              ///< [m/s] largest speed of the hand in steps that cut
  double blunt_feed = 0;            ///< [m/s] speed of the hand, sum over the steps with StepStatus::edges_carry_load
  EnergyLedger energy;
  StepTimes times;
  std::array<std::size_t, 32> status_counts = {};  ///< number of steps, by bit of StepStatus
  std::vector<StepRow> rows;                       ///< empty unless requested

  [[nodiscard]] std::size_t count(StepStatus bit) const;
};

/// Moves the head of the simulation's tool along `motion`, with one step every 1/rate seconds.
/// @param rate       [Hz]
/// @param keep_rows  true: keeps every step for the per-step file
/// @param beside     computes beside the steps; told of each
/// @throws Error when the motion needs more than ten million steps
[[nodiscard]] DrillResult drill(Simulation& simulation, const settings::Motion& motion, double rate, bool keep_rows,
                                BesideSteps& beside);

}  // namespace hapticut::apps
