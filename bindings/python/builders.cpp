// SPDX-License-Identifier: Apache-2.0
// include/hapticut/build, include/hapticut/workpiece/builders.hpp: builders of workpieces
#include "hapticut/workpiece/builders.hpp"

#include "bindings.hpp"
#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/volume.hpp"
#include "structs.hpp"
#include "warned.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

namespace {

void bind_built_shapes(py::module_& m) {
  bind_struct<BodyDescription>(m, "BodyDescription", required("box", &BodyDescription::box),
                               required("distance", &BodyDescription::distance),
                               required("material", &BodyDescription::material));
  m.def("build_body", making(&build_body), py::arg("body"), py::arg("voxel_size"), py::arg("materials"),
        py::arg("subsamples") = 8, doc("build_body"));
  m.def("build_block", making(&build_block), py::arg("box"), py::arg("voxel_size"), py::arg("material"),
        doc("build_block"));
  bind_struct<Layer>(m, "Layer", required("material", &Layer::material), required("thickness", &Layer::thickness));
  m.def("build_layered_slab", making(&build_layered_slab), py::arg("box"), py::arg("voxel_size"), py::arg("layers"),
        doc("build_layered_slab"));
  m.def("build_sphere", making(&build_sphere), py::arg("center"), py::arg("radius"), py::arg("voxel_size"),
        py::arg("material"), doc("build_sphere"));
}

void bind_molar(py::module_& m) {
  using P = MolarParameters;
  bind_described<P>(m, "MolarParameters");
  m.def("validate", py::overload_cast<const P&>(&validate), py::arg("parameters"), doc("validate(MolarParameters)"));
  m.attr("kMolarEnamel") = int(kMolarEnamel);
  m.attr("kMolarDentin") = int(kMolarDentin);
  m.attr("kMolarPulp") = int(kMolarPulp);
  m.attr("kMolarCaries") = int(kMolarCaries);
  m.def("describe_molar", &describe_molar, py::arg("parameters") = P{}, doc("describe_molar"));
  m.def("build_molar", making(&build_molar), py::arg("voxel_size"), py::arg("parameters") = P{}, doc("build_molar"));
}

void bind_meshes(py::module_& m) {
  py::class_<MeshShell> shell_class(m, "MeshShell", doc("MeshShell"));
  pickled_by_members(shell_class, &MeshShell::mesh, &MeshShell::material);
  shell_class
      .def(py::init([](const TriangleMesh& mesh, MaterialId material) {
             return MeshShell{mesh, material};
           }),
           py::arg("mesh"), py::arg("material") = int(kEmpty))
      .def_readonly("mesh", &MeshShell::mesh, doc("MeshShell::mesh"))
      .def_readwrite("material", &MeshShell::material, doc("MeshShell::material"));
  bind_struct<MeshImport>(m, "MeshImport", field("voxel_size", &MeshImport::voxel_size),
                          field("subsamples", &MeshImport::subsamples), field("large", &MeshImport::large));
  m.def("build_from_shells", &build_shells_with_warnings, py::arg("shells"), py::arg("materials"),
        py::arg("options") = MeshImport{}, doc("build_from_shells"));
  m.def(
      "build_from_mesh",
      [](const TriangleMesh& mesh, const Material& material, const MeshImport& options) {
        return build_shells_with_warnings({{mesh, 1}}, MaterialTable({material}), options);
      },
      py::arg("mesh"), py::arg("material"), py::arg("options") = MeshImport{}, doc("build_from_mesh"));
}

void bind_volumes(py::module_& m) {
  bind_struct<LabelMaterial>(m, "LabelMaterial", required("labels", &LabelMaterial::labels),
                             required("material", &LabelMaterial::material));
  m.def("build_from_labels", &build_labels_with_warnings, py::arg("volume"), py::arg("materials"),
        py::arg("options") = VolumeBuildOptions{}, py::arg("unclaimed") = UnclaimedLabels::refuse,
        doc("build_from_labels"));
  m.def("materials_of", &materials_of, py::arg("grade"), doc("materials_of"));
  m.def("build_from_grey", &build_ranges_with_warnings, py::arg("volume"), py::arg("ranges"),
        py::arg("options") = VolumeBuildOptions{}, doc("build_from_grey(GreyVolume, vector, VolumeBuildOptions)"));
  m.def("build_from_grey",
        making(py::overload_cast<const GreyVolume&, const Grade&, const VolumeBuildOptions&>(&build_from_grey)),
        py::arg("volume"), py::arg("grade"), py::arg("options") = VolumeBuildOptions{},
        doc("build_from_grey(GreyVolume, Grade, VolumeBuildOptions)"));
}

}  // namespace

void bind_builders(py::module_& m) {
  bind_built_shapes(m);
  bind_molar(m);
  bind_meshes(m);
  bind_volumes(m);
}

}  // namespace hapticut::python
