// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace hapticut::python {

/// Each function binds a part of the library. The module calls them in this order, because default arguments need the
/// types of earlier bindings.
void bind_core(pybind11::module_& m);
void bind_tool(pybind11::module_& m);
void bind_materials(pybind11::module_& m);
void bind_workpiece(pybind11::module_& m);
void bind_builders(pybind11::module_& m);
void bind_closed_forms(pybind11::module_& m);
void bind_force(pybind11::module_& m);
void bind_effects(pybind11::module_& m);
void bind_results(pybind11::module_& m);
void bind_simulation(pybind11::module_& m);
void bind_distances(pybind11::module_& m);
void bind_copies(pybind11::module_& m);
void bind_coupling(pybind11::module_& m);
void bind_io(pybind11::module_& m);
void bind_device(pybind11::module_& m);
void bind_guard(pybind11::module_& m);
void bind_analysis(pybind11::module_& m);
void bind_recordings(pybind11::module_& m);
void bind_changed_block(pybind11::module_& m);
void bind_surface(pybind11::module_& m);
void bind_islands(pybind11::module_& m);
void bind_loop(pybind11::module_& m);
void bind_heat(pybind11::module_& m);
void bind_sound(pybind11::module_& m);

}  // namespace hapticut::python
