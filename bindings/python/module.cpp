// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include <cstring>
#include <optional>
#include <string>

#include "bindings.hpp"
#include "hapticut/core/errors.hpp"
#include "interruption.hpp"

namespace {

namespace py = pybind11;

/// pybind11's record of a function, property or method; null for other objects.
py::detail::function_record* record_of(py::handle function) {
  if (function && PyInstanceMethod_Check(function.ptr())) function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  if (!function || !PyCFunction_Check(function.ptr())) return nullptr;
  PyObject* self = PyCFunction_GET_SELF(function.ptr());
  if (self == nullptr) return nullptr;
#if PYBIND11_VERSION_HEX >= 0x03000000
  return py::detail::function_record_ptr_from_PyObject(self);
#else
  if (!PyCapsule_CheckExact(self)) return nullptr;
  return py::reinterpret_borrow<py::capsule>(self).get_pointer<py::detail::function_record>();
#endif
}

/// Calls a function for each record (one per overload) of the functions, methods and properties in a module or class.
void for_each_record(py::handle scope, void (*change)(py::detail::function_record&)) {
  const auto change_all = [change](py::handle function) {
    for (auto* record = record_of(function); record != nullptr; record = record->next) change(*record);
  };
  for (const auto& entry : scope.attr("__dict__").attr("copy")().cast<py::dict>()) {
    const py::handle value = entry.second;
    if (PyType_Check(value.ptr())) {
      if (value.attr("__module__").cast<std::string>() == "hapticut._hapticut") for_each_record(value, change);
    } else if (PyObject_TypeCheck(value.ptr(), &PyProperty_Type) != 0) {
      change_all(value.attr("fget"));
      change_all(value.attr("fset"));
    } else if (PyObject_TypeCheck(value.ptr(), &PyStaticMethod_Type) != 0) {
      change_all(value.attr("__func__"));
    } else {
      change_all(value);
    }
  }
}

/// pybind11 passes None as a null pointer to methods that are C++ member functions without named arguments. Marks the
/// object of such a method as not None.
void refuse_none_as_self(py::detail::function_record& record) {
  if (record.is_method && record.args.empty())  // pybind11 frees the name with the record
    record.args.emplace_back(strdup("self"), nullptr, py::handle(), true, false);
}

/// Removes the name of this module from a text, in place.
void leave_out_module(char* text) {
  constexpr const char* kModule = "hapticut._hapticut.";
  for (char* found = text; found != nullptr && (found = std::strstr(found, kModule)) != nullptr;) {
    const char* rest = found + std::strlen(kModule);
    std::memmove(found, rest, std::strlen(rest) + 1);
  }
}

/// Writes `Box` instead of `hapticut._hapticut.Box` in the signature that `help` and errors show.
void shorten_signature(py::detail::function_record& record) {
  leave_out_module(record.signature);
  if (record.def != nullptr) leave_out_module(const_cast<char*>(record.def->ml_doc));  // pybind11's own copy
}

/// The message of an error with the names of Python: `SimulationConfig.contact_time`.
std::string in_words_of_python(const hapticut::Error& error) {
  return error.sentence().written([](const hapticut::Name& name) {
    return std::optional(std::string(name.scope()) + (name.scope().empty() ? "" : ".") + std::string(name.member()));
  });
}

/// Makes errors of the library and failed conversions errors of Python.
void translate_errors(const py::handle& error) {
  static PyObject* const kind = error.ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const hapticut::Error& refused) {
      PyErr_SetString(kind, in_words_of_python(refused).c_str());
    } catch (const py::cast_error&) {
      PyErr_SetString(PyExc_TypeError, "an object of a wrong type was given or returned; see the types in the help.");
    }
  });
}

}  // namespace

PYBIND11_MODULE(_hapticut, m) {
  using namespace hapticut::python;
  m.doc() = "The compiled part of hapticut.";
  const auto error = py::register_exception<hapticut::Error>(m, "Error", PyExc_RuntimeError);
  error.attr("__doc__") =
      "A request cannot be fulfilled. The message says what was given, what is allowed and what to do.";
  translate_errors(error);
  translate_interruptions();
  bind_core(m);
  bind_tool(m);
  bind_materials(m);
  bind_workpiece(m);
  bind_builders(m);
  bind_force(m);
  bind_closed_forms(m);
  bind_effects(m);
  bind_results(m);
  bind_changed_block(m);
  bind_surface(m);
  bind_simulation(m);
  bind_copies(m);
  bind_islands(m);
  bind_io(m);
  bind_guard(m);
  bind_distances(m);
  bind_coupling(m);
  bind_device(m);
  bind_analysis(m);
  bind_recordings(m);
  bind_loop(m);
  bind_heat(m);
  bind_sound(m);

  for_each_record(m, &refuse_none_as_self);
  // The package calls it after the import of this module, because the stub needs the full names.
  m.def("_shorten_signatures", [] { for_each_record(py::module_::import("hapticut._hapticut"), &shorten_signature); });

  py::list names;
  for (const py::handle name : py::module_::import("builtins").attr("dir")(m))
    if (!name.cast<std::string>().starts_with("_")) names.append(name);
  m.attr("__all__") = names;
}
