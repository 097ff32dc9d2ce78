// SPDX-License-Identifier: Apache-2.0
// include/hapticut/workpiece/material.hpp and material_presets.hpp
#include "bindings.hpp"
#include "hapticut/workpiece/material.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "structs.hpp"

namespace hapticut::python {

void bind_materials(py::module_& m) {
  m.attr("kEmpty") = kEmpty;
  m.attr("kMaxMaterials") = kMaxMaterials;
  bind_enum<Estimate>(m, "Estimate");
  bind_enum<Sharpness>(m, "Sharpness");
  bind_described_result<PresetConstant>(m, "PresetConstant")
      .def("at", &PresetConstant::at, py::arg("estimate"), doc("PresetConstant::at"));
  bind_described<Material>(m, "Material")
      .def("with_", py::overload_cast<Estimate>(&Material::with, py::const_), py::arg("estimate"),
           doc("Material::with(Estimate)"))
      .def("with_", py::overload_cast<Estimate, std::string_view>(&Material::with, py::const_), py::arg("estimate"),
           py::arg("number"), doc("Material::with(Estimate, string_view)"));
  m.def("validate", py::overload_cast<const Material&>(&validate), py::arg("material"), doc("validate(Material)"));

  py::class_<MaterialTable>(m, "MaterialTable", doc("MaterialTable"))
      .def(py::init<>())
      .def(py::init<std::vector<Material>>(), py::arg("materials"), doc("MaterialTable::MaterialTable"))
      .def("add", &MaterialTable::add, py::arg("material"), doc("MaterialTable::add"))
      .def("size", &MaterialTable::size, "Number of materials.")
      .def("contains", &MaterialTable::contains, py::arg("id"), "Whether there is a material of this id.")
      .def("id_of", &MaterialTable::id_of, py::arg("name"), doc("MaterialTable::id_of"))
      .def("all", &MaterialTable::all, py::return_value_policy::copy, doc("MaterialTable::all"))
      .def("__getitem__", &MaterialTable::operator[], py::return_value_policy::copy, py::arg("id"),
           "The material of an id.\n\nRaises\n------\nError\n    When there is no such id.")
      .def("__len__", &MaterialTable::size)
      .def("__contains__", &MaterialTable::contains, py::arg("id"))
      .def("__iter__",
           [](const MaterialTable& table) { return py::iter(py::cast(table.all(), py::return_value_policy::copy)); })
      .def("__repr__",
           [](const py::object& self) { return "MaterialTable(" + std::string(py::repr(self.attr("all")())) + ")"; })
      .def(py::pickle([](const MaterialTable& table) { return table.all(); },
                      [](const std::vector<Material>& materials) { return MaterialTable(materials); }));

  m.def("find_preset", &find_preset, py::arg("name"), py::arg("cutter") = CutterKind::carbide_bur,
        py::arg("sharpness") = Sharpness::used, doc("find_preset"));
  m.def(
      "preset_constants",
      [] {
        const auto constants = preset_constants();
        return std::vector<PresetConstant>(constants.begin(), constants.end());
      },
      doc("preset_constants"));
  m.def(
      "preset_names",
      [] {
        const auto names = preset_names();
        return std::vector<std::string>(names.begin(), names.end());
      },
      "The names that find_preset knows.");
  m.def("preset_color", &preset_color, py::arg("name"), doc("preset_color"));
}

}  // namespace hapticut::python
