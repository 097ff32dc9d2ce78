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
  return [model = kept(std::move(given))](const DeviceState& state) {
    const py::gil_scoped_acquire lock;
    return (*model)(state).cast<Wrench>();
  };
}

}  // namespace

ModelFactory factory_from(const AnyFactory& given) {
  if (py::isinstance<PythonModelFactory>(given)) return given.cast<const PythonModelFactory&>().make;
  if (PyCallable_Check(given.ptr()) == 0)
    throw Error("factory: " + describe_given(given) +
                " was given; required is a function from a stiffness to a model, or contact_models.");
  return [factory = kept(given)](double stiffness) {
    const py::gil_scoped_acquire lock;
    return model_from((*factory)(stiffness));
  };
}

}  // namespace hapticut::python
