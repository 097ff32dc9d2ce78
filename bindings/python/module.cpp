// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include <cstring>
#include <string>

#include "bindings.hpp"
#include "hapticut/core/errors.hpp"

namespace {

namespace py = pybind11;

/// pybind11 hands None as a null pointer to methods that are member functions of C++ and name no argument: says of one
/// that its object may not be None.
void refuse_none_as_self(py::handle function) {
  if (function && PyInstanceMethod_Check(function.ptr())) function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  if (!function || !PyCFunction_Check(function.ptr())) return;
  PyObject* self = PyCFunction_GET_SELF(function.ptr());
  if (self == nullptr) return;
#if PYBIND11_VERSION_HEX >= 0x03000000
  py::detail::function_record* record = py::detail::function_record_ptr_from_PyObject(self);
#else
  if (!PyCapsule_CheckExact(self)) return;
  auto* record = py::reinterpret_borrow<py::capsule>(self).get_pointer<py::detail::function_record>();
#endif
  for (; record != nullptr; record = record->next)
    if (record->is_method && record->args.empty())  // the name is freed with the record
      record->args.emplace_back(strdup("self"), nullptr, py::handle(), true, false);
}

/// Does so for all methods and properties of the classes in a module or class.
void refuse_none_in(py::handle scope) {
  for (const auto& entry : scope.attr("__dict__").attr("copy")().cast<py::dict>()) {
    const py::handle value = entry.second;
    if (PyType_Check(value.ptr())) {
      if (value.attr("__module__").cast<std::string>() == "hapticut._hapticut") refuse_none_in(value);
    } else if (PyObject_TypeCheck(value.ptr(), &PyProperty_Type) != 0) {
      refuse_none_as_self(value.attr("fget"));
      refuse_none_as_self(value.attr("fset"));
    } else {
      refuse_none_as_self(value);
    }
  }
}

}  // namespace

PYBIND11_MODULE(_hapticut, m) {
  using namespace hapticut::python;
  m.doc() = "The compiled part of hapticut.";
  const auto error = py::register_exception<hapticut::Error>(m, "Error", PyExc_RuntimeError);
  error.attr("__doc__") =
      "Something that was asked for cannot be done. The message says what was given, what is allowed and what to do.";
  m.attr("_pybind11_version") = PYBIND11_TOSTRING(PYBIND11_VERSION_MAJOR) "." PYBIND11_TOSTRING(PYBIND11_VERSION_MINOR);
  bind_core(m);
  bind_tool(m);
  bind_materials(m);
  bind_workpiece(m);
  bind_builders(m);
  bind_force(m);
  bind_effects(m);
  bind_results(m);
  bind_simulation(m);
  bind_io(m);
  bind_guard(m);
  bind_guard_stages(m);
  bind_coupling(m);
  bind_device(m);
  bind_bench(m);
  bind_recordings(m);
  bind_loop(m);

  refuse_none_in(m);

  py::list names;
  for (const py::handle name : py::module_::import("builtins").attr("dir")(m))
    if (!name.cast<std::string>().starts_with("_")) names.append(name);
  m.attr("__all__") = names;
}
