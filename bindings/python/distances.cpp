// SPDX-License-Identifier: Apache-2.0
// Distances from what is left of a workpiece, and first touches of its materials
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "arrays.hpp"
#include "bindings.hpp"
#include "core/interruption.hpp"
#include "documentation.hpp"
#include "hapticut/workpiece/ray.hpp"
#include "material_set.hpp"
#include "simulation.hpp"
#include "structs.hpp"

namespace hapticut::python {

/// A row of Workpiece.first_hits.
struct RayHitRow {
  double distance;
  double point_W[3], normal_W[3];
  std::uint8_t material;
  std::uint8_t unused[7] = {};  // so that equal rows have equal bytes
};

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A material by its id or its name; none: any.
using MaterialChoice = std::optional<std::variant<int, std::string>>;

/// @throws Error when the table has no such material
MaterialId material_of(const MaterialTable& materials, const MaterialChoice& choice) {
  if (!choice) return kEmpty;
  if (const auto* name = std::get_if<std::string>(&*choice)) return materials.id_of(*name);
  const int id = std::get<int>(*choice);
  if (id < 1 || id > materials.size())
    throw Error("there is no material " + std::to_string(id) + "; the table has materials 1 to " +
                std::to_string(materials.size()) + ", and None means any of them.");
  return MaterialId(id);
}

void require_length(double length, const char* name) {
  if (!(length >= 0))
    throw Error(std::string(name) + " = " + format_number(length) + "; must be a length [m] >= 0, or math.inf.");
}

double distance_to(const Simulation& simulation, MaterialId material, const Pose& X_WH, double max_distance,
                   const std::string& name) {
  const double distance = simulation.distance_to(material, X_WH, max_distance);
  if (std::isnan(distance))
    throw Error(name +
                " is not a rigid transform; its numbers must be finite, and its rotation orthonormal with "
                "determinant +1. Re-orthonormalise an inexact matrix.");
  return distance;
}

py::array_t<double> distances_to(PythonSimulation& self, const MaterialChoice& choice, const Float64Array& poses,
                                 double max_distance) {
  require_length(max_distance, "max_distance");
  const std::span<const double> matrices = numbers_of(poses, "poses", {-1, 4, 4});
  const Simulation& simulation = self.write();  // a search uses memory of the workpiece
  const MaterialId material = material_of(simulation.workpiece().materials(), choice);
  py::array_t<double> distances(py::ssize_t(matrices.size() / 16));
  double* to = distances.mutable_data();
  const ReleasedWriting released(self.occupancy);
  for (std::size_t n = 0; n < matrices.size() / 16; ++n) {
    look_for_interruption();
    const std::string name = "poses[" + std::to_string(n) + "]";
    to[n] = distance_to(simulation, material, pose_from(matrices.data() + 16 * n, name.c_str()), max_distance, name);
  }
  return distances;
}

void require_ray(const Vec3& origin, const Vec3& direction, const std::string& which) {
  if (!is_finite(origin) || !is_finite(direction) || direction.isZero(0))
    throw Error("the ray" + which +
                " has a number that is not finite, or a direction of zero; give a finite origin, "
                "and a direction of any length but zero.");
}

py::array first_hits(const PythonWorkpiece& self, const Float64Array& origins, const Float64Array& directions,
                     double max_length, const MaterialChoice& choice) {
  require_length(max_length, "max_length");
  const std::span<const double> from = numbers_of(origins, "origins", {-1, 3});
  const std::span<const double> along = numbers_of(directions, "directions", {-1, 3});
  if (from.size() != along.size())
    throw Error("origins has " + std::to_string(from.size() / 3) + " rows and directions has " +
                std::to_string(along.size() / 3) + "; give as many of both.");
  const MaterialId material = material_of(self.read().materials(), choice);
  const std::size_t rays = from.size() / 3;
  for (std::size_t n = 0; n < rays; ++n)
    require_ray(Vec3(from.data() + 3 * n), Vec3(along.data() + 3 * n), std::string(" ") += std::to_string(n));
  py::array_t<RayHitRow> rows{py::ssize_t(rays)};
  RayHitRow* row = rows.mutable_data();
  const Workpiece& workpiece = self.read();
  const ReleasedReading released(self.occupancy());
  for (std::size_t n = 0; n < rays; ++n) {
    look_for_interruption();
    const std::optional<RayHit> hit =
        workpiece.first_hit(Vec3(from.data() + 3 * n), Vec3(along.data() + 3 * n), max_length, material);
    row[n] = {kNoLimit, {0, 0, 0}, {0, 0, 0}, kEmpty};
    if (!hit) continue;
    row[n].distance = hit->distance;
    row[n].material = hit->material;
    for (int axis = 0; axis < 3; ++axis) {
      row[n].point_W[axis] = hit->point_W[axis];
      row[n].normal_W[axis] = hit->normal_W[axis];
    }
  }
  return rows;
}

void bind_rays(py::module_& m) {
  PYBIND11_NUMPY_DTYPE(RayHitRow, distance, point_W, normal_W, material);
  bind_result<RayHit>(m, "RayHit", member("distance", &RayHit::distance), member("point_W", &RayHit::point_W),
                      member("normal_W", &RayHit::normal_W), member("material", &RayHit::material));
  using W = PythonWorkpiece;
  py::class_<W>(m.attr("Workpiece"))
      .def(
          "first_hit",
          [](const W& self, const Vec3& origin, const Vec3& direction, double max_length,
             const MaterialChoice& choice) {
            require_length(max_length, "max_length");
            require_ray(origin, direction, "");
            const Workpiece& workpiece = self.read();
            return workpiece.first_hit(origin, direction, max_length, material_of(workpiece.materials(), choice));
          },
          py::arg("origin_W"), py::arg("direction_W"), py::arg("max_length") = kNoLimit,
          py::arg("material") = py::none(),
          "The first place on a ray that is in material; None if there is none.\n\n"
          "The surface is where the fill, trilinear between the centres of the voxels, is one half: exact within 0.15\n"
          "voxels at a plane, half a voxel at a border between two materials.\n\n"
          "Parameters\n----------\n"
          "origin_W\n    [m] (3,) in W.\n"
          "direction_W\n    (3,) in W, of any length.\n"
          "max_length\n    [m] of the ray.\n"
          "material\n    id or name of the material that is looked for, as if there were no other; None: any.\n\n"
          "Raises\n------\nError\n    When the ray is not finite, its direction is zero, or the table has no such "
          "material.")
      .def("first_hits", &first_hits, py::arg("origins"), py::arg("directions"), py::arg("max_length") = kNoLimit,
           py::arg("material") = py::none(),
           "first_hit of many rays.\n\n"
           "Parameters\n----------\n"
           "origins\n    [m] (n, 3) float64, C-contiguous, in W.\n"
           "directions\n    (n, 3) float64, C-contiguous, in W.\n"
           "max_length, material\n    as in first_hit.\n\n"
           "Returns\n-------\n"
           "numpy.ndarray\n"
           "    (n,) structured, with the fields of RayHit; where there is no hit, distance is inf and material 0.\n\n"
           "Raises\n------\nError\n    As first_hit, and when the shapes differ; then no ray was followed.");
}

void bind_touches(py::module_& m) {
  using S = PythonSimulation;
  py::class_<S, std::shared_ptr<S>>(m.attr("Simulation"))
      .def(
          "distance_to",
          [](S& self, const MaterialChoice& choice, const Pose& X_WH, double max_distance) {
            require_length(max_distance, "max_distance");
            const Simulation& simulation = self.write();
            const MaterialId material = material_of(simulation.workpiece().materials(), choice);
            return distance_to(simulation, material, X_WH, max_distance, "X_WH");
          },
          py::arg("material"), py::arg("X_WH"), py::arg("max_distance") = kNoLimit,
          "[m] The distance between the head, with the handle at a pose, and what is left of a material: 0 where the\n"
          "head is in it, inf when nothing of it is left within max_distance. Exact within a fifth of a voxel at a\n"
          "surface against empty space; at a border between two materials up to 0.75 voxels too small or 0.4 too\n"
          "large, because each voxel has one material.\n\n"
          "Parameters\n----------\n"
          "material\n    id or name; None: any. Other materials in between do not matter.\n"
          "X_WH\n    (4, 4) pose of the handle.\n"
          "max_distance\n    [m] of the search; the smaller, the faster.\n\n"
          "Raises\n------\nError\n    When the pose is not a rigid transform, or the table has no such material.")
      .def("distances_to", &distances_to, py::arg("material"), py::arg("poses"), py::arg("max_distance") = kNoLimit,
           "distance_to of many poses, without the interpreter lock.\n\n"
           "Parameters\n----------\n"
           "poses\n    (n, 4, 4) float64, C-contiguous.\n"
           "material, max_distance\n    as in distance_to.\n\n"
           "Returns\n-------\nnumpy.ndarray\n    [m] (n,).\n\n"
           "Raises\n------\nError\n    As distance_to.")
      .def_property_readonly(
          "first_touched", [](const S& self) { return self.read().first_touched(); }, doc("Simulation::first_touched"))
      .def_property_readonly(
          "touched", [](const S& self) { return self.read().totals().touched; }, doc("SimulationTotals::touched"))
      .def_property_readonly(
          "first_touch_by_material",
          [](const S& self) {
            const ByMaterial<std::uint64_t>& steps = self.read().totals().first_touch;
            return py::array_t<std::uint64_t>(py::ssize_t(steps.size()), steps.data());
          },
          "(256,) uint64: by material id, the value of `steps` after the step that touched it first; 0: not yet. Step\n"
          "n of the first `run` is row n - 1 of its trace.");
}

}  // namespace

void bind_distances(py::module_& m) {
  bind_rays(m);
  bind_touches(m);
}

}  // namespace hapticut::python
