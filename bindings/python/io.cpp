// SPDX-License-Identifier: Apache-2.0
// include/hapticut/io
#include <map>
#include <string>

#include "bindings.hpp"
#include "hapticut/build/volume_operations.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "interruption.hpp"
#include "structs.hpp"
#include "warned.hpp"
#include "workpiece.hpp"
#ifdef HAPTICUT_PYTHON_WITH_IO
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/mesh/profile_from_mesh.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "hapticut/io/picture/picture.hpp"
#endif

namespace hapticut::python {

namespace {

using Path = std::filesystem::path;
using Released = py::call_guard<ReleasedLock>;

void bind_vdb(py::module_& m) {
  py::class_<VdbImport> import(m, "VdbImport", doc("VdbImport"));
  bind_enum<VdbImport::Kind>(import, "Kind", "VdbImport::Kind");
  pickled_by_constructor(import, {"material", "grid", "unit_mm", "kind"});
  import
      .def(py::init([](const Material& material, const std::string& grid, double unit_mm, VdbImport::Kind kind) {
             return VdbImport{material, grid, unit_mm, kind};
}),
           py::arg("material"), py::arg("grid") = "", py::arg("unit_mm") = 1.0,
           py::arg("kind") = VdbImport::Kind::from_class)
      .def_readwrite("material", &VdbImport::material, doc("VdbImport::material"))
      .def_readwrite("grid", &VdbImport::grid, doc("VdbImport::grid"))
      .def_readwrite("unit_mm", &VdbImport::unit_mm, doc("VdbImport::unit_mm"))
      .def_readwrite("kind", &VdbImport::kind, "Meaning of the grid's values.");
m.def(
    "save_vdb",
    [](const PythonWorkpiece& workpiece, const Path& path) {
      workpiece.read_released([&](const Workpiece& w) { save_vdb(w, path); });
    },
    py::arg("workpiece"), py::arg("path"), doc("save_vdb"));
m.def("load_vdb", making(py::overload_cast<const Path&>(&load_vdb)), py::arg("path"), doc("load_vdb(path)"));
m.def("load_vdb", making(py::overload_cast<const Path&, const VdbImport&>(&load_vdb)), py::arg("path"),
      py::arg("options"), doc("load_vdb(path, VdbImport)"));
}  // namespace

/// Functions for both grey values and labels.
template <class Volume>
void bind_operations_of(py::module_& m) {
  using V = const Volume&;
  m.def("with_spacing", py::overload_cast<Volume, const Vec3&>(&with_spacing), py::arg("volume"), py::arg("spacing"),
        doc("with_spacing"));
  m.def("box_of_volume", py::overload_cast<V>(&box_of_volume), py::arg("volume"), doc("box_of_volume"));
  m.def("crop_to_samples", py::overload_cast<V, const IndexBox&>(&crop_to_samples), py::arg("volume"),
        py::arg("samples"), doc("crop_to_samples"), Released());
  m.def("crop_to_box", py::overload_cast<V, const Box&>(&crop_to_box), py::arg("volume"), py::arg("box"),
        doc("crop_to_box"), Released());
}

void bind_operations(py::module_& m) {
  using Grey = const GreyVolume&;
  using Labels = const LabelVolume&;
  using Numbers = std::vector<std::uint16_t>;
  bind_operations_of<GreyVolume>(m);
  bind_operations_of<LabelVolume>(m);
  m.def("box_around", py::overload_cast<Labels, const Numbers&, double>(&box_around), py::arg("volume"),
        py::arg("labels") = Numbers{}, py::arg("margin") = 0.0, doc("box_around(LabelVolume, vector, double)"),
        Released());
  m.def("box_around", py::overload_cast<Grey, double, double>(&box_around), py::arg("volume"), py::arg("threshold"),
        py::arg("margin") = 0.0, doc("box_around(GreyVolume, double, double)"), Released());
  m.def("label_range", &label_range, py::arg("volume"), py::arg("from_"), py::arg("to"), py::arg("label") = 1,
        doc("label_range"), Released());
  m.def("grey_range", &grey_range, py::arg("volume"), doc("grey_range"), Released());
  m.def("count_from", &count_from, py::arg("volume"), py::arg("threshold"), doc("count_from"), Released());
  m.def("count_labels", py::overload_cast<Labels>(&count_labels), py::arg("volume"), doc("count_labels(LabelVolume)"),
        Released());
  m.def("count_labels", py::overload_cast<Grey, std::size_t>(&count_labels), py::arg("volume"),
        py::arg("max_labels") = 64, doc("count_labels(GreyVolume, size_t)"), Released());
  m.def("unused_label", &unused_label, py::arg("volume"), doc("unused_label"));
  m.def("keep_largest_component", py::overload_cast<LabelVolume>(&keep_largest_component), py::arg("volume"),
        doc("keep_largest_component(LabelVolume)"), Released());
  m.def("keep_largest_component", py::overload_cast<GreyVolume, double>(&keep_largest_component), py::arg("volume"),
        py::arg("threshold"), doc("keep_largest_component(GreyVolume, double)"), Released());
  m.def("fill_cavities", &fill_cavities, py::arg("volume"), py::arg("label"), doc("fill_cavities"), Released());
}

#ifdef HAPTICUT_PYTHON_WITH_IO

void bind_meshes(py::module_& m) {
  py::class_<NamedMesh> named_class(m, "NamedMesh", doc("NamedMesh"));
  pickled_by_members(named_class, &NamedMesh::name, &NamedMesh::mesh);
  named_class.def_readonly("name", &NamedMesh::name, doc("NamedMesh::name"))
      .def_readonly("mesh", &NamedMesh::mesh, "The surface, in metres.");
  m.def("read_mesh", &read_mesh, py::arg("path"), py::arg("unit_mm") = py::none(), doc("read_mesh"), Released());
  m.def("write_stl", &write_stl, py::arg("mesh"), py::arg("path"), py::arg("unit_mm") = 1.0, doc("write_stl"),
        Released());
  m.def("write_ply", py::overload_cast<const TriangleMesh&, const Path&, double>(&write_ply), py::arg("mesh"),
        py::arg("path"), py::arg("unit_mm") = 1.0, doc("write_ply(TriangleMesh, path, double)"), Released());
  m.def("write_ply", py::overload_cast<const ColoredMesh&, const Path&, double>(&write_ply), py::arg("mesh"),
        py::arg("path"), py::arg("unit_mm") = 1.0, doc("write_ply(ColoredMesh, path, double)"), Released());
  m.def("write_obj", py::overload_cast<const TriangleMesh&, const Path&, double>(&write_obj), py::arg("mesh"),
        py::arg("path"), py::arg("unit_mm") = 1.0, doc("write_obj(TriangleMesh, path, double)"), Released());
  m.def("write_obj", py::overload_cast<const std::vector<NamedMesh>&, const Path&, double>(&write_obj),
        py::arg("objects"), py::arg("path"), py::arg("unit_mm") = 1.0, doc("write_obj(vector, path, double)"),
        Released());

  py::class_<RecognizedProfile> recognized_class(m, "RecognizedProfile", doc("RecognizedProfile"));
  pickled_by_members(recognized_class, &RecognizedProfile::profile, &RecognizedProfile::X_MT,
                     &RecognizedProfile::deviation);
  recognized_class.def_readonly("profile", &RecognizedProfile::profile, doc("RecognizedProfile::profile"))
      .def_readonly("X_MT", &RecognizedProfile::X_MT, doc("RecognizedProfile::X_MT"))
      .def_readonly("deviation", &RecognizedProfile::deviation, doc("RecognizedProfile::deviation"));
  m.def("profile_from_mesh", &profile_from_mesh, py::arg("mesh"), py::arg("towards_shank") = Vec3(Vec3::UnitZ()),
        py::arg("tolerance") = 0.02, doc("profile_from_mesh"), Released());

  using P = PictureOptions;
  bind_struct<P>(m, "PictureOptions", field("width", &P::width), field("height", &P::height),
                 field("view_direction", &P::view_direction), field("up", &P::up), field("background", &P::background),
                 field("scale_bar", &P::scale_bar));
  m.def("material_color", &material_color, py::arg("name"), doc("material_color"));
  m.def("colored", &colored, py::arg("surface"), py::arg("materials"), doc("colored"));
  m.def("write_picture", &write_picture, py::arg("meshes"), py::arg("options"), py::arg("path"), doc("write_picture"),
        Released());
}

void bind_volume_files(py::module_& m) {
  m.attr("kMaxVolumeSamples") = kMaxVolumeSamples;
  bind_struct<VolumeReadOptions>(m, "VolumeReadOptions", field("spacing", &VolumeReadOptions::spacing),
                                 field("dicom_series", &VolumeReadOptions::dicom_series));
  m.def(
      "read_grey_volume",
      [](const Path& path, const VolumeReadOptions& options) {
        return read_with_warnings([&] { return read_grey_volume(path, options); });
      },
      py::arg("path"), py::arg("options") = VolumeReadOptions{}, doc("read_grey_volume"));
  m.def(
      "read_label_volume",
      [](const Path& path, const VolumeReadOptions& options) {
        return read_with_warnings([&] { return read_label_volume(path, options); });
      },
      py::arg("path"), py::arg("options") = VolumeReadOptions{}, doc("read_label_volume"));
  m.def(
      "read_color_slices",
      [](const Path& folder, const py::dict& label_of, const Vec3& spacing) {
        std::map<Color, std::uint16_t> labels;
        for (const auto& [color, label] : label_of) {
          const auto [red, green, blue] = color.cast<std::array<std::uint8_t, 3>>();
          labels[{red, green, blue}] = label.cast<std::uint16_t>();
        }
        const ReleasedLock released;
        return read_color_slices(folder, labels, spacing);
      },
      py::arg("folder"), py::arg("label_of"), py::arg("spacing"),
      (std::string(doc("read_color_slices")) + "\n\nlabel_of is a dict from (red, green, blue) to a label.").c_str());
  bind_enum<ValueType>(m, "ValueType");
  bind_struct<RawLayout>(m, "RawLayout", field("dims", &RawLayout::dims), field("spacing", &RawLayout::spacing),
                         field("type", &RawLayout::type), field("big_endian", &RawLayout::big_endian),
                         field("skip", &RawLayout::skip));
  m.def("read_raw_grey_volume", &read_raw_grey_volume, py::arg("path"), py::arg("layout"),
        "Reads grey values from a file without a header.", Released());
  m.def("read_raw_label_volume", &read_raw_label_volume, py::arg("path"), py::arg("layout"),
        "Reads labels from a file without a header.", Released());
  m.def(
      "write_nrrd", [](const GreyVolume& volume, const Path& path) { write_nrrd(volume, path); }, py::arg("volume"),
      py::arg("path"), doc("write_nrrd(GreyVolume, path)"), Released());
  m.def(
      "write_nrrd", [](const LabelVolume& volume, const Path& path) { write_nrrd(volume, path); }, py::arg("volume"),
      py::arg("path"), Released());
  m.def(
      "write_nrrd",
      [](const PythonWorkpiece& workpiece, const Path& path) {
        workpiece.read_released([&](const Workpiece& w) { write_nrrd(w, path); });
      },
      py::arg("workpiece"), py::arg("path"),
      "Writes material ids under ``path`` and filled fractions under the name with ``_density`` before the extension.");
}

void bind_filters(py::module_& m) {
  using Grey = const GreyVolume&;
  using Labels = const LabelVolume&;
  bind_enum<LabelInterpolation>(m, "LabelInterpolation");
  m.def(
      "resample", [](Grey v, double voxel_size) { return resample(v, voxel_size); }, py::arg("volume"),
      py::arg("voxel_size"), doc("resample"), Released());
  m.def(
      "resample",
      [](Labels v, double voxel_size, LabelInterpolation interpolation) {
        return resample(v, voxel_size, interpolation);
      },
      py::arg("volume"), py::arg("voxel_size"), py::arg("interpolation") = LabelInterpolation::nearest,
      "Resamples a label volume to cubic samples.", Released());
  m.def(
      "close_gaps", [](Labels v, double radius, std::uint16_t label) { return close_gaps(v, radius, label); },
      py::arg("volume"), py::arg("radius"), py::arg("label"), doc("close_gaps"), Released());
}

#endif

}  // namespace hapticut::python

void bind_io(py::module_& m) {
  bind_vdb(m);
  bind_operations(m);
#ifdef HAPTICUT_PYTHON_WITH_IO
  m.attr("kWithIo") = true;
  bind_meshes(m);
  bind_volume_files(m);
  bind_filters(m);
#else
  m.attr("kWithIo") = false;
#endif
}

}  // namespace hapticut::python
