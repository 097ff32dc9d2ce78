// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "hapticut/analysis/stability.hpp"

namespace hapticut::python {

/// A force model of the library: what a factory makes.
struct PythonForceModel {
  ForceModel model;
};

/// A factory of the library. It and its models run without the interpreter.
struct PythonModelFactory {
  ModelFactory make;
};

/// A factory of the library, or a function of Python
HAPTICUT_NAMED_ARGUMENT(
    AnyFactory, "ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]]");

/// What the closed loop works with. A LinearWall or a ForceModel that a function of Python returns runs in C++ from
/// then on; anything else that can be called is called at every tick, with the interpreter lock.
/// @throws Error when it cannot be called
[[nodiscard]] ModelFactory factory_from(const AnyFactory& given);

}  // namespace hapticut::python
