// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation/coupling.hpp: the virtual coupling between hand and tool
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/loop/coupling_gains.hpp"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "material_set.hpp"
#include "steps.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

/// A coupling and the simulation that it steps.
struct PythonCoupling {
  std::shared_ptr<PythonSimulation> simulation;
  VirtualCoupling coupling;

  /// @throws Error while another thread uses the simulation
  [[nodiscard]] VirtualCoupling& write() {
    simulation->occupancy.require_writable("The simulation");
    return coupling;
  }
};

/// A result of a tick that stays valid after the next tick.
struct PythonCoupledResult {
  CoupledResult result;
  std::vector<RemovedVoxel> voxels;
  std::vector<VoxelIndex> changed;

  explicit PythonCoupledResult(const CoupledResult& given)
      : result(given),
        voxels(given.removed_voxels.begin(), given.removed_voxels.end()),
        changed(given.changed_blocks.origins.begin(), given.changed_blocks.origins.end()) {}
};

py::tuple pickled_coupled(const PythonCoupledResult& self) {
  const CoupledResult& r = self.result;
  std::vector<std::pair<VoxelIndex, MaterialId>> voxels;
  for (const RemovedVoxel& voxel : self.voxels) voxels.emplace_back(voxel.index, voxel.material);
  return py::make_tuple(r.hand, r.coupling, r.X_WH, r.V_WH, r.removed_volume, r.sub_ticks, r.newton_steps,
                        r.level_of_detail, r.status, r.energy, voxels, self.changed, r.changed_blocks.complete);
}

PythonCoupledResult coupled_from(const py::tuple& state) {
  detail::require_items(state, 13, "the result");
  CoupledResult result;
  std::size_t i = 0;
  const auto read = [&](auto& value) { value = state[i++].cast<std::remove_reference_t<decltype(value)>>(); };
  const auto read_all = [&](auto&... values) { (read(values), ...); };
  read_all(result.hand, result.coupling, result.X_WH, result.V_WH, result.removed_volume, result.sub_ticks,
           result.newton_steps, result.level_of_detail, result.status, result.energy);
  std::vector<std::pair<VoxelIndex, MaterialId>> voxels;
  std::vector<VoxelIndex> changed;
  read_all(voxels, changed, result.changed_blocks.complete);
  std::vector<RemovedVoxel> removed;
  for (const auto& [index, material] : voxels) removed.push_back({index, material});
  result.removed_voxels = removed;
  result.changed_blocks.origins = changed;
  return PythonCoupledResult(result);
}

/// Calls `visit(name, value)` for each field of a row of VirtualCoupling.run's result.
/// @param time  [s] at the end of the tick, since the run began
template <class Visit>
void for_each_field_of_row(const CoupledResult& result, double time, const Visit& visit) {
  visit("time", time);
  visit("hand", result.hand);
  visit("coupling", result.coupling);
  visit("X_WH", result.X_WH);
  visit("V_WH", result.V_WH);
  visit("removed_voxels", result.removed_voxels);
  visit("removed_volume", result.removed_volume);
  visit("sub_ticks", result.sub_ticks);
  visit("newton_steps", result.newton_steps);
  visit("level_of_detail", result.level_of_detail);
  visit("energy", result.energy);
  visit("status", result.status);
}

py::array run(PythonCoupling& self, const Float64Array& poses, const Float64Array& velocities, const Durations& dt) {
  py::list fields;
  for_each_field_of_row({}, 0, [&](const char* name, const auto& value) {
    fields.append(detail::row_field<std::remove_cvref_t<decltype(value)>>(name));
  });
  const auto step = [&](const StepInput& now) -> const CoupledResult& {
    return self.coupling.step(now.X_WH, now.V_WH, now.dt);
  };
  const auto write = [](const CoupledResult& result, double time, std::byte* row) {
    for_each_field_of_row(result, time, [&](const char*, const auto& value) { detail::put(row, value); });
  };
  return make_rows(*self.simulation, RunInput(poses, velocities, dt), row_type(fields), step, write);
}

template <class T>
auto of_result(T CoupledResult::*member) {
  return [member](const PythonCoupledResult& self) { return self.result.*member; };
}

void bind_gains(py::module_& m) {
  using G = CouplingGains;
  bind_described<G>(m, "CouplingGains");
  m.def("validate", py::overload_cast<const G&>(&validate), py::arg("gains"), doc("validate(CouplingGains)"));
  m.def("coupling_gains", &coupling_gains, py::arg("device"), py::arg("mass") = py::none(), doc("coupling_gains"));
}

void bind_coupled_result(py::module_& m) {
  using E = CouplingEnergy;
  bind_described_result<E>(m, "CouplingEnergy")
      .def("imbalance", &E::imbalance, doc("CouplingEnergy::imbalance"))
      .def("closure", &E::closure, doc("CouplingEnergy::closure"));
  using R = PythonCoupledResult;
  py::class_<R>(m, "CoupledResult",
                "Result of one tick of the coupling. It owns its data and does not change when further ticks are "
                "made.")
      .def(py::pickle(&pickled_coupled, &coupled_from))
      .def_property_readonly("hand", of_result(&CoupledResult::hand), doc("CoupledResult::hand"))
      .def_property_readonly("coupling", of_result(&CoupledResult::coupling), doc("CoupledResult::coupling"))
      .def_property_readonly("X_WH", of_result(&CoupledResult::X_WH), doc("CoupledResult::X_WH"))
      .def_property_readonly("V_WH", of_result(&CoupledResult::V_WH), doc("CoupledResult::V_WH"))
      .def_property_readonly(
          "removed_voxels", [](const py::object& self) { return voxel_indices(self.cast<const R&>().voxels, self); },
          "(n, 3) int32: indices of the voxels that this tick emptied; read-only.")
      .def_property_readonly(
          "removed_materials",
          [](const py::object& self) { return voxel_materials(self.cast<const R&>().voxels, self); },
          "(n,) uint8: material ids of the removed voxels; read-only.")
      .def_property_readonly("removed_volume", of_result(&CoupledResult::removed_volume),
                             doc("CoupledResult::removed_volume"))
      .def_property_readonly(
          "changed_blocks",
          [](const R& r) { return py::make_tuple(block_origins(r.changed), r.result.changed_blocks.complete); },
          "Changes of the tick: (n, 3) int32 first voxels of the changed blocks, and whether the list is complete.")
      .def_property_readonly("sub_ticks", of_result(&CoupledResult::sub_ticks), doc("CoupledResult::sub_ticks"))
      .def_property_readonly("newton_steps", of_result(&CoupledResult::newton_steps),
                             doc("CoupledResult::newton_steps"))
      .def_property_readonly("level_of_detail", of_result(&CoupledResult::level_of_detail),
                             doc("CoupledResult::level_of_detail"))
      .def_property_readonly(
          "status", [](const R& r) { return std::uint32_t(r.result.status); },
          "Bits of StepStatus, of the simulation's steps; 0 = nothing to report.")
      .def_property_readonly("first_touched", of_result(&CoupledResult::first_touched),
                             doc("CoupledResult::first_touched"))
      .def_property_readonly("energy", of_result(&CoupledResult::energy), doc("CouplingEnergy"));
}

}  // namespace

void bind_coupling(py::module_& m) {
  bind_gains(m);
  bind_coupled_result(m);
  using C = PythonCoupling;
  py::class_<C> coupling(m, "VirtualCoupling", doc("VirtualCoupling"));
  bind_enum<VirtualCoupling::Rejoin>(coupling, "Rejoin", "VirtualCoupling::Rejoin");
  coupling
      .def(py::init([](const std::shared_ptr<PythonSimulation>& simulation, const CouplingGains& gains) {
             simulation->occupancy.require_readable("The simulation");
             return C{simulation, VirtualCoupling(simulation->simulation, gains)};
           }),
           py::arg("simulation"), py::arg("gains") = CouplingGains{},
           doc("VirtualCoupling::VirtualCoupling(Simulation, CouplingGains)"))
      .def(
          "step",
          [](C& self, const FewNumbers& pose, const FewNumbers& velocity, double dt) {
            const StepInput input = step_input(pose, velocity, dt);
            return PythonCoupledResult(self.write().step(input.X_WH, input.V_WH, input.dt));
          },
          py::arg("X_WD"), py::arg("V_WD"), py::arg("dt"), doc("VirtualCoupling::step"))
      .def(
          "run", &run, py::arg("poses"), py::arg("velocities"), py::arg("dt"),
          "Makes a tick for every row, without the interpreter lock. The arguments are those of Simulation.run.\n\n"
          "Returns\n-------\n"
          "numpy.ndarray\n"
          "    (n,) structured; the fields are those of CoupledResult: `trace[\"hand\"][\"force\"]` is (n, 3),\n"
          "    `trace[\"X_WH\"]` (n, 4, 4); removed_voxels is their number, see Simulation.removed_in_run; `time` [s]\n"
          "    is the time since the beginning of the run.")
      .def("reset", writing<C>(&VirtualCoupling::reset), doc("VirtualCoupling::reset"))
      .def("park", writing<C>(&VirtualCoupling::park), py::arg("rejoin"), doc("VirtualCoupling::park"))
      .def(
          "set_gains",
          [](C& self, const CouplingGains& gains) {
            VirtualCoupling& changed = self.write();
            validate(gains);
            changed.set_gains(gains);
          },
          py::arg("gains"), doc("VirtualCoupling::set_gains"))
      .def(
          "worst_case", [](const C& self) { return self.coupling.worst_case(); }, doc("VirtualCoupling::worst_case"))
      .def_property_readonly(
          "gains", [](const C& self) { return self.coupling.gains(); }, "The present gains.")
      .def_property_readonly(
          "last_result",
          [](const C& self) {
            self.simulation->occupancy.require_readable("The simulation");
            return PythonCoupledResult(self.coupling.last_result());
          },
          "The result of the last tick.")
      .def_property_readonly(
          "simulation", [](const C& self) { return self.simulation; }, "The simulation that the coupling steps.");
}

}  // namespace hapticut::python
