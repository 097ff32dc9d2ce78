// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include <string>

#include "bindings.hpp"
#include "hapticut/core/errors.hpp"

PYBIND11_MODULE(_hapticut, m) {
  using namespace hapticut::python;
  namespace py = pybind11;
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

  py::list names;
  for (const py::handle name : py::module_::import("builtins").attr("dir")(m))
    if (!name.cast<std::string>().starts_with("_")) names.append(name);
  m.attr("__all__") = names;
}
