// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "arrays.hpp"
#include "simulation.hpp"
#include "trace.hpp"

namespace hapticut::python {

/// What makes the steps: a simulation, or a recorder in its stead.
using Stepper = std::function<const StepResult&(const StepInput&)>;

/// The inputs of a run, checked before its first step.
struct RunInput {
  std::span<const double> poses, velocities, durations;
  double dt;
  std::size_t steps;

  /// @throws Error that names the argument, what was given and what is needed
  RunInput(const py::object& poses, const py::object& velocities, const py::object& dt);

  [[nodiscard]] StepInput operator[](std::size_t step) const;
};

/// The input of one step.
/// @throws Error as above
[[nodiscard]] StepInput step_input(const FewNumbers& pose, const FewNumbers& velocity, double dt);

/// What became of the steps of a run.
class TakenSteps {
 public:
  void note(StepStatus status) {
    seen_ = seen_ | status;
    ++all_;
    taken_ += has_any(status, kRejected | StepStatus::tool_waits) ? 0 : 1;
  }
  /// Warns when there were some, and none of them was taken.
  void tell() const;

 private:
  StepStatus seen_ = StepStatus::ok;
  std::size_t all_ = 0, taken_ = 0;
};

/// (n, 3) int32 and (n,) uint8 that look into a list of voxels which `owner` keeps alive.
[[nodiscard]] py::array voxel_indices(const std::vector<RemovedVoxel>& voxels, py::handle owner);
[[nodiscard]] py::array voxel_materials(const std::vector<RemovedVoxel>& voxels, py::handle owner);

/// (n, 3) int32, copied.
[[nodiscard]] py::array block_origins(std::span<const VoxelIndex> origins);

/// The way back.
/// @throws Error unless it is an (n, 3) array
[[nodiscard]] std::vector<VoxelIndex> origins_from(const py::array_t<std::int32_t, py::array::c_style>& given);

/// One step, its pose and velocity checked.
/// @throws Error as above
[[nodiscard]] PythonStepResult make_step(PythonSimulation& simulation, const FewNumbers& pose,
                                         const FewNumbers& velocity, double dt, const Stepper& step);

/// A step for every row, without the interpreter lock.
/// @throws Error as above, and when a number is not finite; then no step was made
[[nodiscard]] pybind11::array make_steps(PythonSimulation& simulation, const Float64Array& poses,
                                         const Float64Array& velocities, const Durations& dt, const Stepper& step);

}  // namespace hapticut::python
