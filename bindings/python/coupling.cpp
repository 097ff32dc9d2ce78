// SPDX-License-Identifier: Apache-2.0
// include/hapticut/device: the virtual coupling between hand and tool
#include "hapticut/simulation/coupling.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "bindings.hpp"
#include "steps.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

/// A coupling and the simulation that it steps.
struct PythonCoupling {
  std::shared_ptr<PythonSimulation> simulation;
  VirtualCoupling coupling;
};

/// A tick's result that outlives the next tick.
struct PythonCoupledResult {
  CoupledResult result;
  std::vector<RemovedVoxel> voxels;
  std::vector<VoxelIndex> changed;

  explicit PythonCoupledResult(const CoupledResult& given)
      : result(given),
        voxels(given.removed_voxels.begin(), given.removed_voxels.end()),
        changed(given.changed_blocks.origins.begin(), given.changed_blocks.origins.end()) {}
};

struct WrenchRow {
  double force[3], torque[3];
};

struct CouplingEnergyRow {
  double hand_work, tool_work, spring, damper, kinetic, implicit, turnover;
};

/// One row of what VirtualCoupling.run returns: CoupledResult as plain numbers.
struct CoupledRow {
  double time;  // [s] at the end of the tick, since the run began
  WrenchRow hand, coupling;
  double X_WH[4][4];
  double velocity[6];
  std::int64_t removed_voxels;  // how many
  double removed_volume;
  std::int32_t parts, newton_steps, level_of_detail;
  CouplingEnergyRow energy;
  std::uint32_t status;
};

CoupledRow coupled_row(const CoupledResult& result, double time) {
  CoupledRow row{};
  row.time = time;
  const auto copy = [](const Vec3& from, double* to) { std::copy_n(from.data(), 3, to); };
  copy(result.hand.force, row.hand.force);
  copy(result.hand.torque, row.hand.torque);
  copy(result.coupling.force, row.coupling.force);
  copy(result.coupling.torque, row.coupling.torque);
  write_pose(result.X_WH, row.X_WH[0]);
  copy(result.velocity.linear, row.velocity);
  copy(result.velocity.angular, row.velocity + 3);
  row.removed_voxels = std::int64_t(result.removed_voxels.size());
  row.removed_volume = result.removed_volume;
  row.parts = result.parts;
  row.newton_steps = result.newton_steps;
  row.level_of_detail = result.level_of_detail;
  const CouplingEnergy& e = result.energy;
  row.energy = {e.hand_work, e.tool_work, e.spring, e.damper, e.kinetic, e.implicit, e.turnover};
  row.status = std::uint32_t(result.status);
  return row;
}

py::array run(PythonCoupling& self, const Float64Array& poses, const Float64Array& velocities, const Durations& dt) {
  PythonSimulation& simulation = *self.simulation;
  const RunInput input(poses, velocities, dt);
  py::array_t<CoupledRow> trace{py::ssize_t(input.steps)};
  CoupledRow* rows = trace.mutable_data();
  simulation.occupancy.require_writable("The simulation");  // last: what is above may let other threads run
  simulation.removed.clear();
  TakenSteps taken;
  {
    const std::shared_ptr<void> recorder = simulation.recorder.lock();
    const ReleasedWriting released(simulation.occupancy);
    double time = 0;
    for (std::size_t i = 0; i < input.steps; ++i) {
      const StepInput now = input[i];
      const CoupledResult& result = self.coupling.step(now.pose, now.velocity, now.dt);
      time += now.dt;
      taken.note(result.status);
      rows[i] = coupled_row(result, time);
      simulation.remember(result.removed_voxels, i);
    }
  }
  taken.tell();
  return trace;
}

void bind_gains(py::module_& m) {
  using G = CouplingGains;
  bind_described<G>(m, "CouplingGains");
  m.def("validate", py::overload_cast<const G&>(&validate), py::arg("gains"), doc("validate"));
  m.def("coupling_gains", &coupling_gains, py::arg("device"), py::arg("mass") = py::none(), doc("coupling_gains"));
}

void bind_coupled_result(py::module_& m) {
  using E = CouplingEnergy;
  bind_described_result<E>(m, "CouplingEnergy")
      .def("imbalance", &E::imbalance, doc("CouplingEnergy::imbalance"))
      .def("closure", &E::closure, doc("CouplingEnergy::closure"));
  using R = PythonCoupledResult;
  py::class_<R>(m, "CoupledResult",
                "What one tick of the coupling gives. It owns what it holds and stays as it is when further ticks are "
                "made.")
      .def_property_readonly(
          "hand", [](const R& r) { return r.result.hand; }, doc("CoupledResult::hand"))
      .def_property_readonly(
          "coupling", [](const R& r) { return r.result.coupling; }, doc("CoupledResult::coupling"))
      .def_property_readonly(
          "X_WH", [](const R& r) { return r.result.X_WH; }, doc("CoupledResult::X_WH"))
      .def_property_readonly(
          "velocity", [](const R& r) { return r.result.velocity; }, doc("CoupledResult::velocity"))
      .def_property_readonly(
          "removed_voxels", [](const py::object& self) { return voxel_indices(self.cast<const R&>().voxels, self); },
          "(n, 3) int32: indices of the voxels that this tick emptied; read-only.")
      .def_property_readonly(
          "removed_materials",
          [](const py::object& self) { return voxel_materials(self.cast<const R&>().voxels, self); },
          "(n,) uint8: what each of the removed voxels was made of; read-only.")
      .def_property_readonly(
          "removed_volume", [](const R& r) { return r.result.removed_volume; }, doc("CoupledResult::removed_volume"))
      .def_property_readonly(
          "changed_blocks",
          [](const R& r) { return py::make_tuple(block_origins(r.changed), r.result.changed_blocks.complete); },
          "What the tick has changed: (n, 3) int32 first voxels of blocks, and whether that is all of them.")
      .def_property_readonly(
          "parts", [](const R& r) { return r.result.parts; }, doc("CoupledResult::parts"))
      .def_property_readonly(
          "newton_steps", [](const R& r) { return r.result.newton_steps; }, doc("CoupledResult::newton_steps"))
      .def_property_readonly(
          "level_of_detail", [](const R& r) { return r.result.level_of_detail; }, doc("CoupledResult::level_of_detail"))
      .def_property_readonly(
          "status", [](const R& r) { return std::uint32_t(r.result.status); },
          "Bits of StepStatus, of the simulation's steps; 0 = nothing to report.")
      .def_property_readonly(
          "energy", [](const R& r) { return r.result.energy; }, doc("CouplingEnergy"));
}

}  // namespace

void bind_coupling(py::module_& m) {
  PYBIND11_NUMPY_DTYPE(WrenchRow, force, torque);
  PYBIND11_NUMPY_DTYPE(CouplingEnergyRow, hand_work, tool_work, spring, damper, kinetic, implicit, turnover);
  PYBIND11_NUMPY_DTYPE(CoupledRow, time, hand, coupling, X_WH, velocity, removed_voxels, removed_volume, parts,
                       newton_steps, level_of_detail, energy, status);
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
           py::arg("simulation"), py::arg("gains") = CouplingGains{}, doc("VirtualCoupling::VirtualCoupling"))
      .def(
          "step",
          [](C& self, const FewNumbers& pose, const FewNumbers& velocity, double dt) {
            const StepInput input = step_input(pose, velocity, dt);
            self.simulation->occupancy.require_writable("The simulation");
            return PythonCoupledResult(self.coupling.step(input.pose, input.velocity, input.dt));
          },
          py::arg("pose"), py::arg("velocity"), py::arg("dt"), doc("VirtualCoupling::step"))
      .def(
          "run", &run, py::arg("poses"), py::arg("velocities"), py::arg("dt"),
          "Makes a tick for every row, without the interpreter lock; the arguments are those of Simulation.run.\n\n"
          "Returns\n-------\n"
          "numpy.ndarray\n"
          "    (n,) structured; the fields are those of CoupledResult: `trace[\"hand\"][\"force\"]` is (n, 3),\n"
          "    `trace[\"X_WH\"]` (n, 4, 4); removed_voxels is their number, see Simulation.removed_in_run; `time` [s]\n"
          "    is that since the beginning of the run.")
      .def(
          "release",
          [](C& self) {
            self.simulation->occupancy.require_writable("The simulation");
            self.coupling.release();
          },
          doc("VirtualCoupling::release"))
      .def(
          "leave",
          [](C& self, VirtualCoupling::Rejoin rejoin) {
            self.simulation->occupancy.require_writable("The simulation");
            self.coupling.leave(rejoin);
          },
          py::arg("rejoin"), doc("VirtualCoupling::leave"))
      .def(
          "set_gains",
          [](C& self, const CouplingGains& gains) {
            self.simulation->occupancy.require_writable("The simulation");
            validate(gains);
            self.coupling.set_gains(gains);
          },
          py::arg("gains"), doc("VirtualCoupling::set_gains"))
      .def(
          "worst_case", [](const C& self) { return self.coupling.worst_case(); }, doc("VirtualCoupling::worst_case"))
      .def_property_readonly(
          "gains", [](const C& self) { return self.coupling.gains(); }, "As they are now.")
      .def_property_readonly(
          "last_result",
          [](const C& self) {
            self.simulation->occupancy.require_readable("The simulation");
            return PythonCoupledResult(self.coupling.last_result());
          },
          "The result of the last tick.")
      .def_property_readonly(
          "simulation", [](const C& self) { return self.simulation; }, "The one that it steps.");
}

}  // namespace hapticut::python
