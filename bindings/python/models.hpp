// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "hapticut/analysis/stability.hpp"

namespace hapticut::python {

/// A force model made by a factory of the library.
struct PythonForceModel {
  ForceModel model;
};

/// A factory of the library. The factory and its models run without the interpreter lock.
struct PythonModelFactory {
  ModelFactory make;
};

/// A factory of the library, or a Python function
HAPTICUT_NAMED_ARGUMENT(
    AnyFactory, "ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]]");

/// A Python function that is a force model
HAPTICUT_NAMED_ARGUMENT(AnyModel, "collections.abc.Callable[[DeviceState], Wrench]");

/// A model that calls a Python object with the interpreter lock.
/// @throws Error when the object is not callable; the model throws one when the object returns no Wrench
[[nodiscard]] ForceModel calling(py::object function);

/// Converts the result of a factory to a model of the closed loop. A LinearWall or ForceModel returned by a Python
/// function runs in C++. Any other callable is called in every tick with the interpreter lock.
/// @throws Error when the result is not callable
[[nodiscard]] ModelFactory factory_from(const AnyFactory& given);

}  // namespace hapticut::python
