// SPDX-License-Identifier: Apache-2.0
// include/hapticut/surface
#include <optional>

#include "bindings.hpp"
#include "hapticut/loop/block_outbox.hpp"
#include "hapticut/surface/extract_surface.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "steps.hpp"
#include "structs.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

namespace {

/// (n,) of `position` (3,) int16, `material` uint8 and `normal` (3,) int8, 12 bytes each.
py::dtype vertex_type() {
  py::list names, formats, offsets;
  const auto add = [&](const char* name, const char* format, std::size_t offset) {
    names.append(name), formats.append(format), offsets.append(offset);
  };
  add("position", "(3,)<i2", offsetof(SurfaceVertex, position));
  add("material", "u1", offsetof(SurfaceVertex, material));
  add("normal", "(3,)i1", offsetof(SurfaceVertex, normal));
  return py::dtype(names, formats, offsets, sizeof(SurfaceVertex));
}

/// (n, 3) float64 array of a vector per vertex.
template <class Of>
py::array of_vertices(const SurfacePage& page, const Of& of) {
  py::array_t<double> all({py::ssize_t(page.vertices.size()), py::ssize_t(3)});
  double* next = all.mutable_data();
  for (const SurfaceVertex& vertex : page.vertices) {
    const Vec3 one = of(vertex);
    for (int axis = 0; axis < 3; ++axis) *next++ = one[axis];
  }
  return all;
}

void bind_whole_surface(py::module_& m) {
  using W = WorkpieceSurface;
  py::class_<W> surface_class(m, "WorkpieceSurface", doc("WorkpieceSurface"));
  surface_class
      .def(py::pickle(
          [](const py::object& self) {
            return detail::attributes_of(self, {"mesh", "normals", "materials"});
          },
          [](const py::tuple& state) {
            detail::require_items(state, 3, "the surface");
            const std::span<const double> normals = numbers_of(state[1], "normals", {-1, 3});
            W surface{state[0].cast<TriangleMesh>(), std::vector<Vec3>(normals.size() / 3),
                      state[2].cast<std::vector<MaterialId>>()};
            for (std::size_t n = 0; n < surface.normals.size(); ++n) surface.normals[n] = Vec3(normals.data() + 3 * n);
            return surface;
          }))
      .def_readonly("mesh", &WorkpieceSurface::mesh, doc("WorkpieceSurface::mesh"))
      .def_property_readonly(
          "normals", [](const py::object& self) { return view_of(self.cast<const WorkpieceSurface&>().normals, self); },
          "(n, 3) unit normals of the vertices, out of the material, in W; read-only.")
      .def_property_readonly(
          "materials",
          [](const py::object& self) {
            const auto& ids = self.cast<const WorkpieceSurface&>().materials;
            return view(py::dtype::of<std::uint8_t>(), {py::ssize_t(ids.size())}, {1}, ids.data(), self);
          },
          "(n,) uint8 material ids of the vertices: from the nearest voxel that is at least half full; read-only.");
  m.def(
      "extract_surface",
      [](const PythonWorkpiece& w) { return w.read_released([](const Workpiece& x) { return extract_surface(x); }); },
      py::arg("workpiece"), doc("extract_surface(Workpiece)"));
  m.def(
      "extract_surface",
      [](const PythonWorkpiece& w, MaterialId material) {
        return w.read_released([material](const Workpiece& x) { return extract_surface(x, material); });
      },
      py::arg("workpiece"), py::arg("material"), doc("extract_surface(Workpiece, MaterialId)"));
}

void bind_page(py::module_& m) {
  using P = SurfacePage;
  py::class_<P> page(m, "SurfacePage", doc("SurfacePage"));
  page.def_readonly("origin", &P::origin, doc("SurfacePage::origin"))
      .def_readonly("version", &P::version, doc("SurfacePage::version"))
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            const auto& vertices = self.cast<const P&>().vertices;
            return view(vertex_type(), {py::ssize_t(vertices.size())}, {sizeof(SurfaceVertex)}, vertices.data(), self);
          },
          "(n,) read-only, 12 bytes each: `position` (3,) int16 in 1/512 voxel along the axes of V, from the centre "
          "of\n"
          "the page's first voxel; `material` uint8; `normal` (3,) int8 in 1/127.")
      .def_property_readonly(
          "indices",
          [](const py::object& self) {
            const auto& indices = self.cast<const P&>().indices;
            return view(py::dtype::of<std::uint16_t>(), {py::ssize_t(indices.size() / 3), 3}, {6, 2}, indices.data(),
                        self);
          },
          "(m, 3) uint16 vertices of the triangles, counter-clockwise seen from outside; read-only.")
      .def(
          "positions",
          [](const P& self, const GridFrame& frame) {
            return of_vertices(self, [&](const SurfaceVertex& v) { return vertex_position(frame, self, v); });
          },
          py::arg("frame"), "[m] (n, 3) positions of the vertices, in W.")
      .def(
          "normals",
          [](const P& self, const GridFrame& frame) {
            return of_vertices(self, [&](const SurfaceVertex& v) { return vertex_normal(frame, v); });
          },
          py::arg("frame"), "(n, 3) unit normals of the vertices, in W.");
  page.attr("kEdge") = P::kEdge;
  page.attr("kBlocks") = P::kBlocks;
  page.attr("kMaxVertices") = P::kMaxVertices;
  page.attr("kMaxIndices") = P::kMaxIndices;
}

}  // namespace

void bind_surface(py::module_& m) {
  bind_whole_surface(m);
  bind_page(m);
  using S = SurfaceStream;
  py::class_<S>(m, "SurfaceStream", doc("SurfaceStream"))
      .def(py::init([](const PythonWorkpiece& workpiece) { return S(workpiece.read()); }), py::arg("workpiece"),
           doc("SurfaceStream::SurfaceStream"))
      .def(
          "update",
          [](S& self, const PythonWorkpiece& workpiece, const py::array_t<std::int32_t, py::array::c_style>& origins) {
            return self.update(workpiece.read(), origins_from(origins));
          },
          py::arg("workpiece"), py::arg("origins"), doc("SurfaceStream::update(Workpiece, span)"))
      .def(
          "update",
          [](S& self, const ChangedBlock& block) {
            return self.update(block.origin, block.material.data(), block.fill.data());
          },
          py::arg("block"), doc("SurfaceStream::update(VoxelIndex, MaterialId, float)"))
      .def(
          "next_page",
          [](S& self) {
            std::optional<SurfacePage> page(std::in_place);
            if (!self.next_page(*page)) page.reset();
            return page;
          },
          "Removes and returns the waiting page nearest to the point looked at, meshed from the present voxels; None "
          "when no page waits.")
      .def("look_at", &S::look_at, py::arg("p_WQ"), doc("SurfaceStream::look_at"))
      .def("resend", &S::resend, doc("SurfaceStream::resend"))
      .def_property_readonly("frame", &S::frame, py::return_value_policy::copy, doc("GridFrame"))
      .def("waiting", &S::waiting, doc("SurfaceStream::waiting"))
      .def("blocks_meshed", &S::blocks_meshed, doc("SurfaceStream::blocks_meshed"))
      .def("memory_bytes", &S::memory_bytes, doc("SurfaceStream::memory_bytes"));
}

}  // namespace hapticut::python
