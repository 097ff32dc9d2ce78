// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "arrays.hpp"
#include "simulation.hpp"

namespace hapticut::python {

/// What makes the steps: a simulation, or a recorder in its stead.
using Stepper = std::function<const StepResult&(const StepInput&)>;

/// One step, its pose and velocity checked.
/// @throws Error that names the argument, what was given and what is needed
[[nodiscard]] PythonStepResult make_step(PythonSimulation& simulation, const FewNumbers& pose,
                                         const FewNumbers& velocity, double dt, const Stepper& step);

/// A step for every row, without the interpreter lock.
/// @throws Error as above, and when a number is not finite; then no step was made
[[nodiscard]] pybind11::array make_steps(PythonSimulation& simulation, const Float64Array& poses,
                                         const Float64Array& velocities, const Durations& dt, const Stepper& step);

}  // namespace hapticut::python
