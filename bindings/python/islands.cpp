// SPDX-License-Identifier: Apache-2.0
// include/hapticut/islands
#include "hapticut/islands/islands.hpp"

#include <vector>

#include "bindings.hpp"
#include "hapticut/islands/island_watch.hpp"
#include "simulation.hpp"
#include "steps.hpp"
#include "structs.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

namespace {

/// (n, 3) int32
py::array indices_of(const Island& island) {
  py::array_t<std::int32_t> indices({py::ssize_t(island.voxels), py::ssize_t(3)});
  std::int32_t* next = indices.mutable_data();
  for (const BlockVoxels& block : island.blocks)
    block.voxels.for_each([&](int voxel) {
      for (const int i : voxel_at(block.origin, voxel)) *next++ = i;
    });
  return indices;
}

}  // namespace

void bind_islands(py::module_& m) {
  bind_described<IslandOptions>(m, "IslandOptions");
  bind_described<ChangeFeedOptions>(m, "ChangeFeedOptions");
  bind_described<IslandWatchOptions>(m, "IslandWatchOptions");
  py::class_<Island>(m, "Island", doc("Island"))
      .def_property_readonly("indices", &indices_of, "(n, 3) int32 indices of its voxels, block by block.")
      .def_readonly("voxels", &Island::voxels, doc("Island::voxels"))
      .def_readonly("min_fill", &Island::min_fill, doc("Island::min_fill"));
  using F = IslandFinder;
  py::class_<F>(m, "IslandFinder", doc("IslandFinder"))
      .def(py::init([](const PythonWorkpiece& workpiece, const IslandOptions& options) {
             return F(workpiece.read(), options);
           }),
           py::arg("workpiece"), py::arg("options") = IslandOptions{},
           doc("IslandFinder::IslandFinder(Workpiece, IslandOptions)"))
      .def(
          "update",
          [](F& self, const PythonWorkpiece& workpiece, const py::array_t<std::int32_t, py::array::c_style>& origins) {
            self.update(workpiece.read(), origins_from(origins));
          },
          py::arg("workpiece"), py::arg("origins"), doc("IslandFinder::update(Workpiece, span)"))
      .def(
          "update", [](F& self, const ChangedBlock& block) { self.update(block.origin, block.fill.data()); },
          py::arg("block"), doc("IslandFinder::update(VoxelIndex, float)"))
      .def("find", &F::find, doc("IslandFinder::find"));
  m.def(
      "find_islands",
      [](const PythonWorkpiece& workpiece, const IslandOptions& options) {
        return workpiece.read_released([&](const Workpiece& w) { return find_islands(w, options); });
      },
      py::arg("workpiece"), py::arg("options") = IslandOptions{}, doc("find_islands"));
  using R = IslandRemoval;
  py::class_<R>(m, "IslandRemoval", doc("IslandRemoval"))
      .def(py::init([](const Island& island) { return R{island}; }), py::arg("island"), doc("IslandRemoval"))
      .def_readonly("island", &R::island, doc("IslandRemoval::island"))
      .def_readonly("checked", &R::checked, doc("IslandRemoval::checked"))
      .def_readonly("removed", &R::removed, doc("IslandRemoval::removed"))
      .def_readonly("joined", &R::joined, doc("IslandRemoval::joined"))
      .def_property_readonly(
          "is_over", [](const R& self) { return self.is_over(); },
          "Whether the removal has ended: the island has left or stays.");
  m.def(
      "remove_island",
      [](PythonSimulation& simulation, R& removal, std::size_t max_blocks) {
        simulation.occupancy.require_writable("The simulation");
        return remove_island(simulation.simulation, removal, max_blocks);
      },
      py::arg("simulation"), py::arg("removal"), py::arg("max_blocks"), doc("remove_island"));
}

}  // namespace hapticut::python
