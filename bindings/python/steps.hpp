// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "arrays.hpp"
#include "interruption.hpp"
#include "simulation.hpp"
#include "trace.hpp"

namespace hapticut::python {

/// Source of the steps: a simulation, or a recorder for it.
using Stepper = std::function<const StepResult&(const StepInput&)>;

/// The inputs of a run, checked before its first step.
struct RunInput {
  std::span<const double> poses, velocities, durations;
  double dt;
  std::size_t steps;

  /// @throws Error that names the argument, the given and the required value
  RunInput(const py::object& poses, const py::object& velocities, const py::object& dt);

  [[nodiscard]] StepInput operator[](std::size_t step) const;
};

/// The input of one step.
/// @throws Error that names the argument, the given and the required value
[[nodiscard]] StepInput step_input(const FewNumbers& pose, const FewNumbers& velocity, double dt);

/// Counts the steps that a run has made.
class TakenSteps {
 public:
  void note(StepStatus status) {
    seen_ = seen_ | status;
    ++all_;
    taken_ += has_any(status, kRejected | StepStatus::tool_waits) ? 0 : 1;
  }
  /// Warns when the run has made no step.
  void tell() const;

 private:
  StepStatus seen_ = StepStatus::ok;
  std::size_t all_ = 0, taken_ = 0;
};

/// Makes a step and a row of numbers for every input, without the interpreter lock.
/// @param step  makes a step from an input and returns its result
/// @param write  `write(result, time, row)`
/// @throws Error while another thread uses the simulation
template <class Step, class Write>
py::array make_rows(PythonSimulation& simulation, const RunInput& input, const py::dtype& type, const Step& step,
                    const Write& write) {
  py::array all = empty_rows(type, input.steps);
  auto* row = static_cast<std::byte*>(all.mutable_data());
  simulation.occupancy.require_writable(
      "The simulation");  // checked last, because the code above may let other threads run
  simulation.removed.clear();
  TakenSteps taken;
  {
    const std::shared_ptr<void> recorder = simulation.recorder.lock();
    const ReleasedWriting released(simulation.occupancy);
    double time = 0;
    for (std::size_t i = 0; i < input.steps; ++i, row += type.itemsize()) {
      look_for_interruption();  // the steps before stay made
      const StepInput now = input[i];
      const auto& result = step(now);
      time += now.dt;
      taken.note(result.status);
      write(result, time, row);
      simulation.remember(result.removed_voxels, i);
    }
  }
  taken.tell();
  return all;
}

/// (n, 3) int32 and (n,) uint8 views of a list of voxels that `owner` keeps alive.
[[nodiscard]] py::array voxel_indices(const std::vector<RemovedVoxel>& voxels, py::handle owner);
[[nodiscard]] py::array voxel_materials(const std::vector<RemovedVoxel>& voxels, py::handle owner);

/// (n, 3) int32, copied.
[[nodiscard]] py::array block_origins(std::span<const VoxelIndex> origins);

/// Converts an (n, 3) int32 array to indices.
/// @throws Error for any other array
[[nodiscard]] std::vector<VoxelIndex> origins_from(const py::array_t<std::int32_t, py::array::c_style>& given);

/// Checks pose and velocity and makes one step.
/// @throws Error that names the argument, the given and the required value
[[nodiscard]] PythonStepResult make_step(PythonSimulation& simulation, const FewNumbers& pose,
                                         const FewNumbers& velocity, double dt, const Stepper& step);

/// Makes a step for every row, without the interpreter lock.
/// @throws Error that names a wrong argument, or when a number is not finite; then no step was made
[[nodiscard]] pybind11::array make_steps(PythonSimulation& simulation, const Float64Array& poses,
                                         const Float64Array& velocities, const Durations& dt, const Stepper& step);

}  // namespace hapticut::python
