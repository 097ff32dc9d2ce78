// SPDX-License-Identifier: Apache-2.0
// include/hapticut/workpiece: everything that makes a workpiece
#include "hapticut/workpiece/builders.hpp"

#include "bindings.hpp"
#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/build/volume_builders.hpp"
#include "hapticut/core/volume.hpp"
#include "structs.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

namespace {

void bind_built_shapes(py::module_& m) {
  bind_struct<BodyDescription>(m, "BodyDescription", required("box", &BodyDescription::box),
                               required("distance", &BodyDescription::distance),
                               required("material", &BodyDescription::material));
  m.def(
      "build_body",
      [](const BodyDescription& body, double voxel_size, const MaterialTable& materials, int subsamples) {
        return make_released([&] { return build_body(body, voxel_size, materials, subsamples); });
      },
      py::arg("body"), py::arg("voxel_size"), py::arg("materials"), py::arg("subsamples") = 8, doc("build_body"));
  m.def(
      "build_block",
      [](const Box& box, double voxel_size, const Material& material) {
        return make_released([&] { return build_block(box, voxel_size, material); });
      },
      py::arg("box"), py::arg("voxel_size"), py::arg("material"), doc("build_block"));
  bind_struct<Layer>(m, "Layer", required("material", &Layer::material), required("thickness", &Layer::thickness));
  m.def(
      "build_layered_slab",
      [](const Box& box, double voxel_size, const std::vector<Layer>& layers) {
        return make_released([&] { return build_layered_slab(box, voxel_size, layers); });
      },
      py::arg("box"), py::arg("voxel_size"), py::arg("layers"), doc("build_layered_slab"));
  m.def(
      "build_sphere",
      [](const Vec3& center, double radius, double voxel_size, const Material& material) {
        return make_released([&] { return build_sphere(center, radius, voxel_size, material); });
      },
      py::arg("center"), py::arg("radius"), py::arg("voxel_size"), py::arg("material"), doc("build_sphere"));
}

void bind_molar(py::module_& m) {
  using P = MolarParameters;
  bind_struct<P>(
      m, "MolarParameters", field("crown_mesiodistal", &P::crown_mesiodistal),
      field("crown_buccolingual", &P::crown_buccolingual), field("crown_height", &P::crown_height),
      field("cervix_mesiodistal", &P::cervix_mesiodistal), field("cervix_buccolingual", &P::cervix_buccolingual),
      field("cervical_curvature", &P::cervical_curvature), field("mesial_root_length", &P::mesial_root_length),
      field("distal_root_length", &P::distal_root_length), field("furcation_depth", &P::furcation_depth),
      field("fossa_depth", &P::fossa_depth), field("fissure_depth", &P::fissure_depth),
      field("fissure_half_width", &P::fissure_half_width), field("distal_cusp", &P::distal_cusp),
      field("enamel_at_cusps", &P::enamel_at_cusps), field("enamel_on_walls", &P::enamel_on_walls),
      field("enamel_in_fossa", &P::enamel_in_fossa), field("chamber_mesiodistal", &P::chamber_mesiodistal),
      field("chamber_buccolingual", &P::chamber_buccolingual), field("chamber_roof", &P::chamber_roof),
      field("chamber_height", &P::chamber_height), field("horn_height", &P::horn_height),
      field("canal_radius", &P::canal_radius), field("canal_radius_at_apex", &P::canal_radius_at_apex),
      field("apical_dentin", &P::apical_dentin), field("caries_depth", &P::caries_depth),
      field("caries_width", &P::caries_width));
  m.def("validate", py::overload_cast<const P&>(&validate), py::arg("parameters"), doc("validate"));
  m.attr("kMolarEnamel") = int(kMolarEnamel);
  m.attr("kMolarDentin") = int(kMolarDentin);
  m.attr("kMolarPulp") = int(kMolarPulp);
  m.attr("kMolarCaries") = int(kMolarCaries);
  m.def("describe_molar", &describe_molar, py::arg("parameters") = P{}, doc("describe_molar"));
  m.def(
      "build_molar",
      [](double voxel_size, const P& parameters) {
        return make_released([&] { return build_molar(voxel_size, parameters); });
      },
      py::arg("voxel_size"), py::arg("parameters") = P{}, doc("build_molar"));
}

void bind_meshes(py::module_& m) {
  py::class_<MeshShell>(m, "MeshShell", doc("MeshShell"))
      .def(py::init([](const TriangleMesh& mesh, MaterialId material) {
             return MeshShell{mesh, material};
           }),
           py::arg("mesh"), py::arg("material") = int(kEmpty))
      .def_property_readonly(
          "mesh", [](const MeshShell& s) -> const TriangleMesh& { return s.mesh; },
          py::return_value_policy::reference_internal, doc("MeshShell::mesh"))
      .def_readwrite("material", &MeshShell::material, doc("MeshShell::material"));
  bind_struct<MeshImport>(m, "MeshImport", field("voxel_size", &MeshImport::voxel_size),
                          field("subsamples", &MeshImport::subsamples), field("large", &MeshImport::large));
  m.def(
      "build_from_shells",
      [](const std::vector<MeshShell>& shells, const MaterialTable& materials, const MeshImport& options) {
        return make_released([&] { return build_from_shells(shells, materials, options); });
      },
      py::arg("shells"), py::arg("materials"), py::arg("options") = MeshImport{}, doc("build_from_shells"));
  m.def(
      "build_from_mesh",
      [](const TriangleMesh& mesh, const Material& material, const MeshImport& options) {
        return make_released([&] { return build_from_mesh(mesh, material, options); });
      },
      py::arg("mesh"), py::arg("material"), py::arg("options") = MeshImport{}, doc("build_from_mesh"));
}

void bind_volumes(py::module_& m) {
  bind_struct<LabelMaterial>(m, "LabelMaterial", required("labels", &LabelMaterial::labels),
                             required("material", &LabelMaterial::material));
  m.def(
      "build_from_labels",
      [](const LabelVolume& volume, const std::vector<LabelMaterial>& materials, const VolumeBuildOptions& options,
         UnclaimedLabels unclaimed) {
        return make_released([&] { return build_from_labels(volume, materials, options, unclaimed); });
      },
      py::arg("volume"), py::arg("materials"), py::arg("options") = VolumeBuildOptions{},
      py::arg("unclaimed") = UnclaimedLabels::refuse, doc("build_from_labels"));
  m.def("materials_of", &materials_of, py::arg("grade"), doc("materials_of"));
  m.def(
      "build_from_grey",
      [](const GreyVolume& volume, const std::vector<GreyRange>& ranges, const VolumeBuildOptions& options) {
        return make_released([&] { return build_from_grey(volume, ranges, options); });
      },
      py::arg("volume"), py::arg("ranges"), py::arg("options") = VolumeBuildOptions{}, doc("build_from_grey"));
  m.def(
      "build_from_grey",
      [](const GreyVolume& volume, const Grade& grade, const VolumeBuildOptions& options) {
        return make_released([&] { return build_from_grey(volume, grade, options); });
      },
      py::arg("volume"), py::arg("grade"), py::arg("options") = VolumeBuildOptions{}, doc("build_from_grey#2"));
}

}  // namespace

void bind_builders(py::module_& m) {
  bind_built_shapes(m);
  bind_molar(m);
  bind_meshes(m);
  bind_volumes(m);
}

}  // namespace hapticut::python
