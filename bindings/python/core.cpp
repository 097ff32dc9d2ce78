// SPDX-License-Identifier: Apache-2.0
// include/hapticut/core
#include <utility>

#include "bindings.hpp"
#include "core.hpp"
#include "hapticut/core/build_info.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

std::vector<Vec3> points_from(py::handle array, const char* what) {
  const std::span<const double> numbers = numbers_of(array, what, {-1, 3});
  std::vector<Vec3> points(numbers.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Vec3(numbers.data() + 3 * i);
  return points;
}

TriangleMesh mesh_from(const Float64Array& vertices, const FewNumbers& triangles) {
  TriangleMesh mesh{points_from(vertices, "vertices"), {}};
  const py::array any = py::array::ensure(triangles);
  const bool whole = any && (any.dtype().kind() == 'i' || any.dtype().kind() == 'u');
  using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
  const Indices given = whole ? Indices::ensure(any) : Indices();  // uint64 values above int64 become negative
  if (!whole || !given || given.ndim() != 2 || given.shape(1) != 3) {
    throw Error("triangles: " + describe_given(triangles) +
                " was given; it must be an array of shape (n, 3) and a whole-number dtype.");
  }
  mesh.triangles.resize(std::size_t(given.shape(0)));
  for (py::ssize_t i = 0; i < given.shape(0); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const std::int64_t index = given.at(i, corner);
      if (index < 0 || index >= std::int64_t(mesh.vertices.size()))
        throw Error("triangle " + std::to_string(i) + " names vertex " + std::to_string(index) + ", but there are " +
                    std::to_string(mesh.vertices.size()) + " vertices.");
      mesh.triangles[std::size_t(i)][std::size_t(corner)] = std::uint32_t(index);
    }
  return mesh;
}

py::array triangles_of(const TriangleMesh& mesh, py::handle owner) {
  return view(py::dtype::of<std::uint32_t>(), {py::ssize_t(mesh.triangles.size()), 3},
              {3 * sizeof(std::uint32_t), sizeof(std::uint32_t)}, mesh.triangles.data(), owner);
}

template <class Value>
void bind_volume(py::module_& m, const char* name, const char* purpose) {
  using V = Volume<Value>;
  const std::string text = std::string(purpose) + "\n\n" + doc("Volume");
  py::class_<V> volume_class(m, name, text.c_str());
  volume_class.def("__copy__", [](const V& v) { return V(v); });
  volume_class.def(
      "__deepcopy__", [](const V& v, const py::dict&) { return V(v); }, py::arg("memo"));
  volume_class.def(py::pickle(
      [](const py::object& self) {
        return detail::attributes_of(self, {"values", "spacing", "X_WG", "padding"});
      },
      [](const py::tuple& state) {
        detail::require_items(state, 4, "the volume");
        V v = volume_from<Value>(state[0], state[1].cast<Vec3>(), state[2].cast<Pose>());
        v.padding = state[3].cast<std::size_t>();
        return v;
      }));
  volume_class
      .def(py::init([](const RealArray& values, const Vec3& spacing, const Pose& X_WG) {
             return volume_from<Value>(values, spacing, X_WG);
           }),
           py::arg("values"), py::arg("spacing"), py::arg("X_WG") = Pose{},
           "Copies an array of shape (nx, ny, nz), in any memory order; values[i, j, k] is sample (i, j, k).")
      .def_property_readonly(
          "values",
          [](const py::object& self) {
            const V& v = self.cast<const V&>();
            const auto nx = py::ssize_t(v.dims[0]), ny = py::ssize_t(v.dims[1]), nz = py::ssize_t(v.dims[2]);
            const auto size = py::ssize_t(sizeof(Value));
            return view(py::dtype::of<Value>(), {nx, ny, nz}, {size, size * nx, size * nx * ny}, v.values.data(), self);
          },
          "(nx, ny, nz) read-only; values[i, j, k] is sample (i, j, k). A view of the volume, not a copy.")
      .def_property_readonly(
          "dims", [](const V& v) { return py::make_tuple(v.dims[0], v.dims[1], v.dims[2]); }, doc("Volume::dims"))
      .def_readonly("spacing", &V::spacing, doc("Volume::spacing"))
      .def_readonly("X_WG", &V::X_WG, doc("Volume::X_WG"))
      .def_readonly("padding", &V::padding, doc("Volume::padding"))
      .def_readonly("remarks", &V::remarks, doc("Volume::remarks"))
      .def("position", &V::position, py::arg("i"), py::arg("j"), py::arg("k"), "[m] (3,) position of a sample, in W.");
}

void bind_spatial(py::module_& m) {
  bind_struct<Wrench>(m, "Wrench", field("force", &Wrench::force), field("torque", &Wrench::torque));
  m.def("transport", py::overload_cast<const Wrench&, const Vec3&>(&transport), py::arg("wrench_P"), py::arg("p_QP"),
        doc("transport(Wrench, Vec3)"));
  m.def("transport", py::overload_cast<const Twist&, const Vec3&>(&transport), py::arg("twist_P"), py::arg("p_PQ"),
        doc("transport(Twist, Vec3)"));
  m.def("transport", py::overload_cast<const Stiffness&, const Mat3&, const Vec3&>(&transport), py::arg("stiffness_T"),
        py::arg("R_WT"), py::arg("p_HoTo_W"), doc("transport(Stiffness, Mat3, Vec3)"));
  m.def("rotation_from_vector", &rotation_from_vector, py::arg("v"), doc("rotation_from_vector"));
  m.def("vector_from_rotation", &vector_from_rotation, py::arg("rotation"), doc("vector_from_rotation"));
  m.def(
      "twist_between",
      [](const Pose& from, const Pose& to, double dt) {
        require_positive(dt, "dt [s]");
        return twist_between(from, to, dt);
      },
      py::arg("from_"), py::arg("to"), py::arg("dt"), doc("twist_between"));
  m.def("advance", &advance, py::arg("from_"), py::arg("twist"), py::arg("dt"), doc("advance"));
  m.def("is_rotation", &is_rotation, py::arg("m"), py::arg("tolerance"), doc("is_rotation"));
  m.def("orthonormalized", &orthonormalized, py::arg("m"), doc("orthonormalized"));
}

}  // namespace

void bind_core(py::module_& m) {
  bind_result<BuildInfo>(m, "BuildInfo", member("version", &BuildInfo::version), member("commit", &BuildInfo::commit),
                         member("compiler", &BuildInfo::compiler), member("cpu", &BuildInfo::cpu));
  m.def("build_info", &build_info, "Version of the library and the machine that it runs on.");
  bind_spatial(m);

  py::class_<TriangleMesh> mesh_class(m, "TriangleMesh", doc("TriangleMesh"));
  pickled_by_constructor(mesh_class, {"vertices", "triangles"});
  mesh_class
      .def(py::init(&mesh_from), py::arg("vertices"), py::arg("triangles"),
           "Copies vertices (n, 3) float64 [m] and triangles (m, 3) of whole numbers.")
      .def_property_readonly(
          "vertices", [](const py::object& self) { return view_of(self.cast<const TriangleMesh&>().vertices, self); },
          "(n, 3) [m] in W; a read-only view of the mesh.")
      .def_property_readonly(
          "triangles", [](const py::object& self) { return triangles_of(self.cast<const TriangleMesh&>(), self); },
          "(m, 3) uint32: indices of vertices, counter-clockwise seen from outside; a read-only view of the mesh.")
      .def("__repr__", [](const TriangleMesh& mesh) {
        return "TriangleMesh(" + std::to_string(mesh.vertices.size()) + " vertices, " +
               std::to_string(mesh.triangles.size()) + " triangles)";
      });

  bind_struct<Color>(m, "Color", field("red", &Color::red), field("green", &Color::green), field("blue", &Color::blue))
      .def(
          "__eq__",
          [](const Color& a, const py::object& b) { return py::isinstance<Color>(b) && a == b.cast<const Color&>(); },
          py::arg("other"))
      .def("__hash__", [](const Color& c) { return (c.red << 16) + (c.green << 8) + c.blue; });
  py::class_<ColoredMesh> colored_class(m, "ColoredMesh", doc("ColoredMesh"));
  pickled_by_members(colored_class, &ColoredMesh::mesh, &ColoredMesh::colors);
  colored_class
      .def(py::init([](const TriangleMesh& mesh, const std::vector<Color>& colors) {
             return ColoredMesh{mesh, colors};
           }),
           py::arg("mesh"), py::arg("colors"))
      .def_readonly("mesh", &ColoredMesh::mesh, "The surface.")
      .def_property_readonly(
          "colors",
          [](const py::object& self) {
            const auto& colors = self.cast<const ColoredMesh&>().colors;
            static_assert(sizeof(Color) == 3);
            return view(py::dtype::of<std::uint8_t>(), {py::ssize_t(colors.size()), 3}, {3, 1}, colors.data(), self);
          },
          "(n, 3) uint8: red, green, blue of every vertex; read-only.");

  bind_volume<float>(m, "GreyVolume", "Grey values, e.g. Hounsfield units.");
  bind_volume<std::uint16_t>(m, "LabelVolume", "Labels; 0 is empty by convention.");
}

}  // namespace hapticut::python
