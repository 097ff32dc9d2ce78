// SPDX-License-Identifier: Apache-2.0
#include "models.hpp"

#include <memory>
#include <utility>

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::python {

namespace {

/// A Python object that may be released without the interpreter lock.
using Kept = std::shared_ptr<py::object>;

Kept kept(py::object object) {
  return {new py::object(std::move(object)), [](const py::object* given) {
            const py::gil_scoped_acquire lock;
            delete given;
          }};
}

ForceModel model_from(py::object given) {
  if (py::isinstance<PythonForceModel>(given)) return given.cast<const PythonForceModel&>().model;
  if (py::isinstance<LinearWall>(given)) return given.cast<const LinearWall&>();
  if (PyCallable_Check(given.ptr()) == 0)
    throw Error("the factory returned " + describe_given(given) +
                "; it must return a LinearWall or a function from a DeviceState to a Wrench.");
  return calling(std::move(given));
}

}  // namespace

ForceModel calling(py::object function) {
  if (PyCallable_Check(function.ptr()) == 0)
    throw Error("model: " + describe_given(function) +
                " was given; it must be a LinearWall or a function from a DeviceState to a Wrench.");
  return [model = kept(std::move(function))](const DeviceState& state) {
    const py::gil_scoped_acquire lock;
    const py::object wrench = (*model)(state);
    if (!py::isinstance<Wrench>(wrench))
      throw Error("the force model returned " + describe_given(wrench) + "; it must return a Wrench.");
    return wrench.cast<Wrench>();
  };
}

ModelFactory factory_from(const AnyFactory& given) {
  if (py::isinstance<PythonModelFactory>(given)) return given.cast<const PythonModelFactory&>().make;
  if (PyCallable_Check(given.ptr()) == 0)
    throw Error("factory: " + describe_given(given) +
                " was given; it must be a function from a stiffness to a model, or contact_models.");
  return [factory = kept(given)](double stiffness) {
    const py::gil_scoped_acquire lock;
    return model_from((*factory)(stiffness));
  };
}

}  // namespace hapticut::python
