// SPDX-License-Identifier: Apache-2.0
// Copies and pickles of workpieces, simulations and results of steps
#include <cstring>
#include <string>
#include <utility>

#include "bindings.hpp"
#include "hapticut/core/build_info.hpp"
#include "io/vdb/vdb_bytes.hpp"
#include "simulation.hpp"
#include "simulation/simulation_memory.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

namespace {

Workpiece workpiece_from(std::string bytes) {
  try {
    return workpiece_of_vdb(std::move(bytes));
  } catch (const Error& error) {
    throw Error("the pickled workpiece cannot be read: " + error.sentence());
  }
}

/// Identifies the library that pickled a simulation, because its memory has no other format.
std::string this_build() {
  const BuildInfo build = build_info();
  return build.version + " " + build.commit;
}

std::shared_ptr<PythonSimulation> copied(const PythonSimulation& self) {
  const Simulation& simulation = self.read();
  std::shared_ptr<PythonSimulation> copy;
  {
    const ReleasedReading released(const_cast<PythonSimulation&>(self).occupancy);
    copy = std::make_shared<PythonSimulation>(copy_of(simulation));
  }
  copy->removed = self.removed;
  return copy;
}

py::tuple pickled_simulation(PythonSimulation& self) {
  const Simulation& simulation = self.read();
  std::string workpiece, memory;
  {
    const ReleasedReading released(self.occupancy);
    memory = SimulationMemory::bytes_of(simulation);
    workpiece = vdb_bytes(simulation.workpiece());
  }
  const py::bytes removed(reinterpret_cast<const char*>(self.removed.data()),
                          self.removed.size() * sizeof(RemovedInRun));
  return py::make_tuple(this_build(), py::bytes(workpiece), simulation.tool(), simulation.config(), py::bytes(memory),
                        removed);
}

std::shared_ptr<PythonSimulation> simulation_from(const py::tuple& state) {
  detail::require_items(state, 6, "the simulation");
  if (const auto build = state[0].cast<std::string>(); build != this_build())
    throw Error(
        "the simulation was pickled by hapticut " + build + ", but this is " + this_build() +
        "; a pickle is for the same version only. Pickle it again, or keep workpieces as .vdb files and runs as "
        "recordings.");
  auto workpiece = state[1].cast<std::string>();
  const auto tool = state[2].cast<Tool>();
  auto config = state[3].cast<SimulationConfig>();
  const auto memory = state[4].cast<std::string>(), removed = state[5].cast<std::string>();
  std::shared_ptr<PythonSimulation> made;
  {
    const ReleasedLock released;
    Workpiece left = workpiece_from(std::move(workpiece));
    try {
      made = std::make_shared<PythonSimulation>(
          SimulationMemory::restored(std::move(left), tool, std::move(config), memory));
    } catch (const Error& error) {
      throw Error("the memory of the pickled simulation cannot be read: " + error.sentence());
    }
  }
  made->removed.resize(removed.size() / sizeof(RemovedInRun));
  if (!made->removed.empty())
    std::memcpy(made->removed.data(), removed.data(), made->removed.size() * sizeof(RemovedInRun));
  return made;
}

/// A value without the span of removed voxels, which its Python object owns.
py::tuple pickled_result(const PythonStepResult& self) {
  py::list parts;
  for_each_field<StepResult>([&](const auto& field) {
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (!std::is_same_v<T, std::span<const RemovedVoxel>>) parts.append(self.result.*field.member);
  });
  std::vector<std::pair<VoxelIndex, MaterialId>> voxels;
  for (const RemovedVoxel& voxel : self.voxels) voxels.emplace_back(voxel.index, voxel.material);
  parts.append(voxels);
  return py::tuple(parts);
}

PythonStepResult result_from(const py::tuple& state) {
  detail::require_items(state, kFieldsOf<StepResult>, "the result");
  StepResult result;
  std::size_t i = 0;
  for_each_field<StepResult>([&](const auto& field) {
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (!std::is_same_v<T, std::span<const RemovedVoxel>>)
      result.*field.member = state[i++].template cast<T>();
  });
  std::vector<RemovedVoxel> voxels;
  for (const auto& [index, material] : state[i].cast<std::vector<std::pair<VoxelIndex, MaterialId>>>())
    voxels.push_back({index, material});
  result.removed_voxels = voxels;
  return PythonStepResult(result);
}

}  // namespace

void bind_copies(py::module_& m) {
  py::reinterpret_borrow<py::class_<PythonWorkpiece>>(m.attr("Workpiece"))
      .def(py::pickle(
          [](const PythonWorkpiece& self) {
            const std::string bytes =
                self.read_released([](const Workpiece& workpiece) { return vdb_bytes(workpiece); });
            return py::make_tuple(py::bytes(bytes));
          },
          [](const py::tuple& state) {
            detail::require_items(state, 1, "the workpiece");
            auto bytes = state[0].cast<std::string>();
            return make_released([&] { return workpiece_from(std::move(bytes)); });
          }));
  py::reinterpret_borrow<py::class_<PythonSimulation, std::shared_ptr<PythonSimulation>>>(m.attr("Simulation"))
      .def("__copy__", &copied, "A separate simulation whose next steps have the same bits.")
      .def(
          "__deepcopy__", [](const PythonSimulation& self, const py::dict&) { return copied(self); }, py::arg("memo"),
          "The same as ``__copy__``.")
      .def(py::pickle(&pickled_simulation, &simulation_from));
  py::reinterpret_borrow<py::class_<PythonStepResult>>(m.attr("StepResult"))
      .def(py::pickle(&pickled_result, &result_from));
}

}  // namespace hapticut::python
