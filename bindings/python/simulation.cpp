// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation
#include "simulation.hpp"

#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "hapticut/simulation/thesis_mode.hpp"
#include "steps.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

namespace {

/// (256,) array of volumes by material.
py::array_t<double> by_material(const ByMaterial<double>& volumes) {
  return py::array_t<double>(py::ssize_t(volumes.size()), volumes.data());
}

Stepper stepper_of(PythonSimulation& self) {
  return [&self](const StepInput& input) -> const StepResult& {
    return self.simulation.step(input.X_WH, input.V_WH, input.dt);
  };
}

void bind_config(py::module_& m) {
  using C = SimulationConfig;
  bind_enum<ContactTime>(m, "ContactTime");
  bind_enum<ProbedMotions>(m, "ProbedMotions");
  bind_described<C>(m, "SimulationConfig");
  m.def("validate", py::overload_cast<const C&>(&validate), py::arg("config"), doc("validate(SimulationConfig)"));
  using M = ThesisMode;
  bind_struct<M>(m, "ThesisMode", field("law", &M::law), field("update_rate", &M::update_rate),
                 field("tool_mass", &M::tool_mass), field("center_of_mass", &M::center_of_mass),
                 field("handle_torque_scale", &M::handle_torque_scale));
  m.def(
      "thesis_mode", [](const std::optional<M>& mode) { return thesis_mode(mode.value_or(M{})); },
      py::arg("mode") = std::nullopt, doc("thesis_mode"));
  m.def(
      "check_input",
      [](const C& config, const FewNumbers& pose, const FewNumbers& velocity, double dt) {
        const StepInput input = step_input(pose, velocity, dt);
        return std::uint32_t(check_input(config, input.X_WH, input.V_WH, input.dt));
      },
      py::arg("config"), py::arg("X_WH"), py::arg("V_WH"), py::arg("dt"), doc("check_input"));
}

void bind_limits(py::module_& m) {
  bind_described_result<StageTimes>(m, "StageTimes");
  bind_result<WorstCase>(m, "WorstCase", member("blocks", &WorstCase::blocks), member("voxels", &WorstCase::voxels),
                         member("sub_steps", &WorstCase::sub_steps),
                         member("level_of_detail", &WorstCase::level_of_detail),
                         member("contacts", &WorstCase::contacts));
  m.def("max_voxels", &max_voxels, py::arg("head"), py::arg("voxel_size"), doc("max_voxels"));
  m.def("max_blocks", &max_blocks, py::arg("head"), py::arg("voxel_size"), doc("max_blocks"));
}

void bind_the_simulation(py::module_& m) {
  using S = PythonSimulation;
  const std::string text =
      std::string(doc("Simulation")) +
      "\n\nIt copies and pickles. The next steps of a copy have the same bits; its workpiece, energies and counters "
      "are "
      "its\nown. Recorders and collectors stay with the original. A pickle is for the same version of hapticut.";
  py::class_<S, std::shared_ptr<S>>(m, "Simulation", text.c_str())
      .def(py::init([](const PythonWorkpiece& workpiece, const Tool& tool, const SimulationConfig& config) {
             Workpiece copy = workpiece.read().clone();
             const py::gil_scoped_release released;
             return std::make_shared<S>(Simulation(std::move(copy), tool, config));
           }),
           py::arg("workpiece"), py::arg("tool"), py::arg("config") = SimulationConfig{},
           "Works on a copy of the workpiece, and reserves all memory for cutting.\n\n"
           "Raises\n------\nError\n    When the configuration is invalid, the workpiece is empty, or the head thinner "
           "than a voxel.")
      .def(
          "step",
          [](S& self, const FewNumbers& pose, const FewNumbers& velocity, double dt) {
            return make_step(self, pose, velocity, dt, stepper_of(self));
          },
          py::arg("X_WH"), py::arg("V_WH"), py::arg("dt"), doc("Simulation::step"))
      .def(
          "run",
          [](S& self, const Float64Array& poses, const Float64Array& velocities, const Durations& dt) {
            return make_steps(self, poses, velocities, dt, stepper_of(self));
          },
          py::arg("poses"), py::arg("velocities"), py::arg("dt"),
          "Makes a step for every row, without the interpreter lock.\n\n"
          "Parameters\n----------\n"
          "poses\n    (n, 4, 4) float64, C-contiguous: X_WH at the end of each step.\n"
          "velocities\n    (n, 6) float64, C-contiguous: [m/s] of Ho, then [rad/s], in W.\n"
          "dt\n    [s] one number, or (n,) float64.\n\n"
          "Ctrl-C ends the run within a second by KeyboardInterrupt. The steps made so far stay made: `steps` counts\n"
          "them, `workpiece` and `removed_in_run` show what they have cut.\n\n"
          "Returns\n-------\n"
          "numpy.ndarray\n"
          "    (n,) structured; the fields are those of StepResult: `trace[\"force\"]` is (n, 3),\n"
          "    `trace[\"energy\"][\"cutting\"]` (n,); removed_voxels is their number, see removed_in_run; `time`\n"
          "    [s] is the time since the beginning of the run.\n\n"
          "Raises\n------\nError\n    When an array has another shape or type, or has a number that is not finite, "
          "or\n"
          "    the last row of a pose is not 0 0 0 1; then no step was made. `status` reports all other errors of an\n"
          "    input, as in step.\n\n"
          "Warns\n-----\nUserWarning\n    When no step was made.")
      .def(
          "probe",
          [](S& self, const FewNumbers& pose, const FewNumbers& velocity, double dt, ProbedMotions motions) {
            const StepInput input = step_input(pose, velocity, dt);
            // The probe uses the memory of the simulation.
            return self.write().probe(input.X_WH, input.V_WH, input.dt, motions);
          },
          py::arg("X_WH"), py::arg("V_WH"), py::arg("dt"),
          py::arg_v("motions", ProbedMotions::all, "ProbedMotions.all"), doc("Simulation::probe"))
      .def_property_readonly("last_input", reading<S>(&Simulation::last_input), doc("Simulation::last_input"))
      .def_property_readonly(
          "removed_in_run",
          [](S& self) -> py::array {
            self.occupancy.require_readable("The simulation");
            py::array_t<RemovedInRun> rows(py::ssize_t(self.removed.size()));
            std::copy(self.removed.begin(), self.removed.end(), rows.mutable_data());
            return rows;
          },
          "(n,) structured: step, index (3,) and material of every voxel that the last run emptied.")
      .def_property_readonly(
          "workpiece", [](S& self) { return PythonWorkpiece(self.shared_from_this()); },
          "The remaining workpiece: a read-only view, not a copy.")
      .def_property_readonly("tool", reading<S>(&Simulation::tool), "As passed to the constructor.")
      .def_property_readonly("config", reading<S>(&Simulation::config), "A copy of the configuration.")
      .def_property_readonly(
          "last_result", [](const S& self) { return PythonStepResult(self.read().last_result()); },
          "The result of the last step.")
      .def_property_readonly(
          "removed_volume_by_material", [](const S& self) { return by_material(self.read().totals().removed_volume); },
          "[m^3] (256,) removed since construction or reset, by material id.")
      .def_property_readonly(
          "normal_forces", [](const S& self) { return by_material(self.read().normal_forces()); },
          "[N] (256,) normal forces of each material on a head that cuts, by material id, in the last sub-step of the "
          "last step: their shares tell which layers are being cut.")
      .def_property_readonly(
          "spindle_setting", [](const S& self) { return self.read().spindle().setting(); },
          doc("SpindleDrive::setting"))
      .def_property_readonly("steps", reading<S>(&Simulation::steps), doc("Simulation::steps"))
      .def_property_readonly(
          "next_step_is_first", reading<S>(&Simulation::next_step_is_first),
          "Whether the next step will be the first of the tool: before the first one, and after `undo`, `redo`,\n"
          "`restore`, `set_tool`, `set_materials` and `reset`, and commands of a loop that exchange one of these. "
          "After\n"
          "these calls, the material that the tool is in is neither felt nor cut: steps are rejected with\n"
          "StepStatus.tool_waits until the head touches nothing. Exceptions are the very first step, and `reset` when "
          "no\n"
          "coupling holds the tool.")
      .def_property_readonly(
          "is_fresh", reading<S>(&Simulation::is_fresh),
          "Whether the simulation is as new: since construction or `reset` it has made no step and received no\n"
          "workpiece that a tool was in, and no `undo`, `redo` or islands.remove_island has changed its workpiece. A\n"
          "recording begins with such a simulation. Calls of `set_tool` and the like do not matter.")
      .def_property_readonly(
          "workpiece_exchanges", [](const S& self) { return self.read().totals().exchanges; },
          "How often something other than a step has changed the workpiece, tool or materials: `restore`, `undo`,\n"
          "`redo`, `reset`, `set_tool`, `set_materials`, `set_friction`, `set_removal`, and commands of a loop.\n"
          "Effects do not count. `reset` keeps this number.")
      .def(
          "changed_blocks",
          [](const S& self) {
            const ChangedBlocks changed = self.read().changed_blocks();
            return py::make_tuple(block_origins(changed.origins), changed.complete);
          },
          "Changes of the last step: (n, 3) int32 first voxels of the changed blocks, and whether the list is "
          "complete.")
      .def("worst_case", reading<S>(&Simulation::worst_case), doc("Simulation::worst_case"))
      .def_property_readonly("stage_times", reading<S>(&Simulation::stage_times), doc("Simulation::stage_times"))
      .def(
          "set_spindle_speed", [](S& self, AngularSpeed speed) { self.write().spindle().set_speed(speed); },
          py::arg("speed"), doc("SpindleDrive::set_speed"))
      .def("set_effects", writing<S>(py::overload_cast<const Effects&>(&Simulation::set)), py::arg("effects"),
           doc("Simulation::set(Effects)"))
      .def("set_tool", writing<S>(py::overload_cast<Tool>(&Simulation::set)), py::arg("tool"),
           doc("Simulation::set(Tool)"))
      .def("set_materials", writing<S>(py::overload_cast<MaterialTable>(&Simulation::set)), py::arg("materials"),
           doc("Simulation::set(MaterialTable)"))
      .def("set_friction", writing<S>(py::overload_cast<const std::optional<DryFriction>&>(&Simulation::set)),
           py::arg("friction"), doc("Simulation::set(optional)"))
      .def("set_removal", writing<S>(static_cast<void (Simulation::*)(RemovalLaw) noexcept>(&Simulation::set)),
           py::arg("removal"), doc("Simulation::set(RemovalLaw)"))
      .def(
          "halt_spindle", [](S& self) { self.write().spindle().halt(); }, doc("SpindleDrive::halt"))
      .def(
          "hold_spindle", [](S& self, bool hold) { self.write().spindle().hold(hold); }, py::arg("hold"),
          doc("SpindleDrive::hold"))
      .def_property_readonly(
          "spindle_is_held", [](const S& self) { return self.read().spindle().is_held(); },
          "Whether the spindle is held, independent of its set speed.")
      .def("reserve_blocks", writing<S>(&Simulation::reserve_blocks), py::arg("count"),
           doc("Simulation::reserve_blocks"))
      .def(
          "snapshot", [](const S& self) { return self.read().workpiece().snapshot(); }, doc("Workpiece::snapshot"))
      .def(
          "restore", [](S& self, const WorkpieceSnapshot& snapshot) { self.write().history().restore(snapshot); },
          py::arg("snapshot"), doc("WorkpieceHistory::restore"))
      .def(
          "reserve_undo", [](S& self, std::size_t blocks) { self.write().history().reserve(blocks); },
          py::arg("blocks"),
          "Reserves memory for `set_undo_mark` and `undo`, also for workpieces of a later `reset`: 2.7 kB for each of\n"
          "`blocks` blocks that are cut after a mark, and 4 bytes for every block within the workpiece's bounds. 0: "
          "no\n"
          "undo. Deletes all marks.\n\nRaises\n------\nError\n    When the workpiece spans too many blocks or the "
          "memory is not available; then nothing has changed.")
      .def(
          "set_undo_mark",
          [](S& self) {
            if (!self.write().history().mark()) throw Error("There is no memory for undo; call reserve_undo first.");
          },
          "Marks the present state of the workpiece. Raises Error without `reserve_undo`.")
      .def_property_readonly(
          "undo_marks", [](const S& self) { return self.read().workpiece().marks(); },
          "Number of marks that `undo` can return to.")
      .def(
          "undo", [](S& self, std::size_t max_blocks) { return self.write().history().undo(max_blocks); },
          py::arg("max_blocks"), doc("WorkpieceHistory::undo"))
      .def_property_readonly(
          "detached_volume_by_material",
          [](const S& self) { return by_material(self.read().totals().detached_volume); },
          "[m^3] (256,) removed as islands since construction or reset, by material id: see islands.remove_island.")
      .def_property_readonly(
          "redo_marks", [](const S& self) { return self.read().workpiece().redo_marks(); },
          "Number of marks that `redo` can restore.")
      .def(
          "redo", [](S& self, std::size_t max_blocks) { return self.write().history().redo(max_blocks); },
          py::arg("max_blocks"),
          "Redoes the last `undo`: restores the state before it, and its mark. Called as `undo` is. Needs no memory\n"
          "beyond that of `reserve_undo`. Cutting discards all redo marks.\n\n"
          "Returns\n-------\nbool\n    True when it is done, or nothing was undone.")
      .def(
          "reset", [](S& self, const PythonWorkpiece& workpiece) { self.write().reset(workpiece.read().clone()); },
          py::arg("workpiece"),
          "Starts again with a copy of another workpiece: tool position, energies, removed volumes and undo marks are "
          "reset.\nThe new workpiece gets as much memory for undo as the old one.\n\nRaises\n------\nError\n    When "
          "the "
          "workpiece is empty, or the head thinner than a voxel.");
}

/// The loop of Simulation.run in C++: makes the steps and keeps only their sum.
double loop_in_cpp(PythonSimulation& self, const Float64Array& poses, const Float64Array& velocities,
                   const Durations& dt) {
  const RunInput input(poses, velocities, dt);
  self.occupancy.require_writable("The simulation");
  const ReleasedWriting released(self.occupancy);
  double sum = 0;
  for (std::size_t i = 0; i < input.steps; ++i) {
    const StepInput now = input[i];
    sum += self.simulation.step(now.X_WH, now.V_WH, now.dt).force.z();
  }
  return sum;
}

}  // namespace

void bind_simulation(py::module_& m) {
  bind_config(m);
  bind_limits(m);
  bind_the_simulation(m);
  m.def("_loop_in_cpp", &loop_in_cpp, py::arg("simulation"), py::arg("poses"), py::arg("velocities"), py::arg("dt"),
        "For benchmarks/python_cost.py.");
}

}  // namespace hapticut::python
