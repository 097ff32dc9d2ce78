// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/simulation/step.hpp"

/// @file
/// One row of the structured array that Simulation.run returns: StepResult with the same names, as plain numbers.
namespace hapticut::python {

struct ContactRow {
  std::int64_t voxels;
  double volume, depth;
  std::int64_t turns;
};

struct WrenchRow {
  double force[3], torque[3];
};

struct SpindleRow {
  double speed, torque;
};

struct EnergyRow {
  double hand_work, motor_work, elastic, cutting, released, damping, rubbing, anchored, sliding, credited, entered;
};

struct TraceRow {
  double time;  ///< [s] at the end of the step, since the run began
  double force[3], torque[3];
  std::int64_t removed_voxels;  ///< how many
  double removed_volume;
  ContactRow contact;
  WrenchRow model;
  EnergyRow energy;
  SpindleRow spindle;
  std::int32_t sub_steps;
  std::uint32_t status;
};

[[nodiscard]] TraceRow trace_row(const StepResult& result, double time);

}  // namespace hapticut::python
