// SPDX-License-Identifier: Apache-2.0
#include "steps.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut::python {

namespace {

void require_finite(std::span<const double> numbers, std::size_t per_row, const char* what) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      throw Error(std::string(what) + "[" + std::to_string(i / per_row) + "] contains " + format_number(numbers[i]) +
                  "; every number must be finite. Nothing was simulated.");
}

}  // namespace

RunInput::RunInput(const py::object& given_poses, const py::object& given_velocities, const py::object& given_dt)
    : poses(numbers_of(given_poses, "poses", {-1, 4, 4})),
      velocities(numbers_of(given_velocities, "velocities", {-1, 6})),
      dt(0),
      steps(poses.size() / 16) {
  if (velocities.size() / 6 != steps)
    throw Error("poses has " + std::to_string(steps) + " rows, but velocities has " +
                std::to_string(velocities.size() / 6) + "; they must be equal.");
  if (py::isinstance<py::array>(given_dt) && py::reinterpret_borrow<py::array>(given_dt).ndim() > 0) {
    durations = numbers_of(given_dt, "dt", {-1});
    if (durations.size() != steps)
      throw Error("poses has " + std::to_string(steps) + " rows, but dt has " + std::to_string(durations.size()) +
                  "; give one number, or one for each step.");
    require_finite(durations, 1, "dt");
  } else {
    dt = PyFloat_AsDouble(given_dt.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw Error("dt: " + describe_given(given_dt) +
                  " was given; it must be a number, or an array of shape (n,) and dtype float64.");
    }
    require_finite({&dt, 1}, 1, "dt");
  }
  require_finite(poses, 16, "poses");
  require_finite(velocities, 6, "velocities");
  for (std::size_t i = 0; i < steps; ++i) (void)(*this)[i];
}

StepInput RunInput::operator[](std::size_t step) const {
  const double* v = velocities.data() + 6 * step;
  return {pose_from(poses.data() + 16 * step, "a row of poses"),
          {Vec3(v), Vec3(v + 3)},
          durations.empty() ? dt : durations[step]};
}

StepInput step_input(const FewNumbers& pose, const FewNumbers& velocity, double dt) {
  std::array<double, 16> matrix;
  std::array<double, 6> twist;
  if (!read_numbers(pose, "pose", {4, 4}, matrix.data())) (void)numbers_of(pose, "pose", {4, 4});
  if (!read_numbers(velocity, "velocity", {6}, twist.data())) (void)numbers_of(velocity, "velocity", {6});
  return {pose_from(matrix.data(), "pose"), {Vec3(twist.data()), Vec3(twist.data() + 3)}, dt};
}

py::array voxel_indices(const std::vector<RemovedVoxel>& voxels, py::handle owner) {
  static_assert(sizeof(RemovedVoxel) == 16 && sizeof(int) == 4);
  return view(py::dtype::of<std::int32_t>(), {py::ssize_t(voxels.size()), 3}, {sizeof(RemovedVoxel), 4},
              voxels.empty() ? nullptr : voxels.data()->index.data(), owner);
}

py::array voxel_materials(const std::vector<RemovedVoxel>& voxels, py::handle owner) {
  return view(py::dtype::of<std::uint8_t>(), {py::ssize_t(voxels.size())}, {sizeof(RemovedVoxel)},
              voxels.empty() ? nullptr : &voxels.data()->material, owner);
}

py::array block_origins(std::span<const VoxelIndex> origins) {
  py::array_t<std::int32_t> array({py::ssize_t(origins.size()), py::ssize_t(3)});
  for (std::size_t i = 0; i < origins.size(); ++i)
    std::copy_n(origins[i].data(), 3, array.mutable_data(py::ssize_t(i)));
  return array;
}

std::vector<VoxelIndex> origins_from(const py::array_t<std::int32_t, py::array::c_style>& given) {
  if (given.ndim() != 2 || given.shape(1) != 3)
    throw Error("origins are " + describe_given(given) + "; they must be int32 of shape (n, 3), as changed_blocks().");
  std::vector<VoxelIndex> origins;
  for (py::ssize_t n = 0; n < given.shape(0); ++n) origins.push_back({given.at(n, 0), given.at(n, 1), given.at(n, 2)});
  return origins;
}

void TakenSteps::tell() const {
  if (taken_ == 0 && all_ > 0)
    py::module_::import("hapticut._runs")
        .attr("warn_no_steps")("none of the " + std::to_string(all_) + " steps was made: " + describe(seen_));
}

PythonStepResult make_step(PythonSimulation& simulation, const FewNumbers& pose, const FewNumbers& velocity, double dt,
                           const Stepper& step) {
  const StepInput input = step_input(pose, velocity, dt);
  simulation.occupancy.require_writable(
      "The simulation");  // checked last, because reading the input may let other threads run
  return PythonStepResult(step(input));
}

py::array make_steps(PythonSimulation& simulation, const Float64Array& poses, const Float64Array& velocities,
                     const Durations& dt, const Stepper& step) {
  return make_rows(simulation, RunInput(poses, velocities, dt), trace_type(), step, write_trace_row);
}

}  // namespace hapticut::python
