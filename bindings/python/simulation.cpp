// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation
#include "simulation.hpp"

#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "hapticut/bench/scenes.hpp"
#include "hapticut/simulation/thesis_mode.hpp"
#include "steps.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

namespace {

/// @throws Error while another thread is at work on it
const Simulation& read(const PythonSimulation& self) {
  self.occupancy.require_readable("The simulation");
  return self.simulation;
}

Stepper stepper_of(PythonSimulation& self) {
  return [&self](const StepInput& input) -> const StepResult& {
    return self.simulation.step(input.pose, input.velocity, input.dt);
  };
}

void bind_config(py::module_& m) {
  using C = SimulationConfig;
  bind_enum<ContactTime>(m, "ContactTime");
  bind_enum<ProbedMotions>(m, "ProbedMotions");
  bind_described<C>(m, "SimulationConfig");
  m.def("validate", py::overload_cast<const C&>(&validate), py::arg("config"), doc("validate"));
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
        return std::uint32_t(check_input(config, input.pose, input.velocity, input.dt));
      },
      py::arg("config"), py::arg("pose"), py::arg("velocity"), py::arg("dt"), doc("check_input"));
}

void bind_limits(py::module_& m) {
  bind_described_result<StageTimes>(m, "StageTimes");
  bind_result<WorstCase>(m, "WorstCase", member("blocks", &WorstCase::blocks), member("voxels", &WorstCase::voxels),
                         member("sub_steps", &WorstCase::sub_steps),
                         member("level_of_detail", &WorstCase::level_of_detail),
                         member("contacts", &WorstCase::contacts));
  m.def("most_voxels", &most_voxels, py::arg("head"), py::arg("voxel_size"), doc("most_voxels"));
  m.def("most_blocks", &most_blocks, py::arg("head"), py::arg("voxel_size"), doc("most_blocks"));
}

void bind_the_simulation(py::module_& m) {
  using S = PythonSimulation;
  py::class_<S, std::shared_ptr<S>>(m, "Simulation", doc("Simulation"))
      .def(py::init([](const PythonWorkpiece& workpiece, const Tool& tool, const SimulationConfig& config) {
             Workpiece copy = workpiece.read().clone();
             const py::gil_scoped_release released;
             return std::make_shared<S>(Simulation(std::move(copy), tool, config));
           }),
           py::arg("workpiece"), py::arg("tool"), py::arg("config") = SimulationConfig{},
           "Works on a copy of the workpiece, and reserves all memory that cutting will need.\n\n"
           "Raises\n------\nError\n    When the configuration is invalid, the workpiece is empty, or the head thinner "
           "than a voxel.")
      .def(
          "step",
          [](S& self, const FewNumbers& pose, const FewNumbers& velocity, double dt) {
            return make_step(self, pose, velocity, dt, stepper_of(self));
          },
          py::arg("pose"), py::arg("velocity"), py::arg("dt"), doc("Simulation::step"))
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
          "Returns\n-------\n"
          "numpy.ndarray\n"
          "    (n,) structured; the fields are those of StepResult: `trace[\"force\"]` is (n, 3),\n"
          "    `trace[\"energy\"][\"cutting\"]` (n,); removed_voxels is their number, see removed_in_run; `time` [s] "
          "is\n"
          "    that since the beginning of the run.\n\n"
          "Raises\n------\nError\n    When an array has another shape or type, or holds a number that is not finite; "
          "nothing was simulated then.\n    Everything else that is wrong with an input is reported by `status`, as "
          "step "
          "does.\n\nWarns\n-----\nUserWarning\n    When none of the steps was taken.")
      .def(
          "probe",
          [](S& self, const FewNumbers& pose, const FewNumbers& velocity, double dt, ProbedMotions motions) {
            const StepInput input = step_input(pose, velocity, dt);
            self.occupancy.require_writable("The simulation");  // it works in the simulation's own memory
            return self.simulation.probe(input.pose, input.velocity, input.dt, motions);
          },
          py::arg("pose"), py::arg("velocity"), py::arg("dt"),
          py::arg_v("motions", ProbedMotions::all, "ProbedMotions.all"), doc("Simulation::probe"))
      .def_property_readonly(
          "last_input", [](const S& self) { return read(self).last_input(); }, doc("Simulation::last_input"))
      .def_property_readonly(
          "removed_in_run",
          [](S& self) -> py::array {
            self.occupancy.require_readable("The simulation");
            return py::array_t<RemovedInRun>(py::ssize_t(self.removed.size()), self.removed.data());
          },
          "(n,) structured: step, index (3,) and material of every voxel that the last run emptied.")
      .def_property_readonly(
          "workpiece", [](S& self) { return PythonWorkpiece(self.shared_from_this()); },
          "What is left: a look at it, not a copy. It cannot be changed from there.")
      .def_property_readonly(
          "tool", [](const S& self) { return read(self).tool(); }, "As given.")
      .def_property_readonly(
          "config", [](const S& self) { return read(self).config(); }, "As given; a copy.")
      .def_property_readonly(
          "last_result", [](const S& self) { return PythonStepResult(read(self).last_result()); },
          "The result of the last step.")
      .def_property_readonly(
          "removed_volume_by_material",
          [](const S& self) {
            const auto& volumes = read(self).removed_volume_by_material();
            return py::array_t<double>(py::ssize_t(volumes.size()), volumes.data());
          },
          "[m^3] (256,) taken away since construction or reset, by material id.")
      .def_property_readonly(
          "spindle_setting", [](const S& self) { return read(self).spindle_setting(); },
          doc("Simulation::spindle_setting"))
      .def_property_readonly(
          "steps", [](const S& self) { return read(self).steps(); }, doc("Simulation::steps"))
      .def_property_readonly(
          "starts_afresh", [](const S& self) { return read(self).starts_afresh(); }, doc("Simulation::starts_afresh"))
      .def_property_readonly(
          "workpiece_exchanges", [](const S& self) { return read(self).workpiece_exchanges(); },
          doc("Simulation::workpiece_exchanges"))
      .def(
          "changed_blocks",
          [](const S& self) {
            const ChangedBlocks changed = read(self).changed_blocks();
            return py::make_tuple(block_origins(changed.origins), changed.complete);
          },
          "What the last step has changed: (n, 3) int32 first voxels of blocks, and whether that is all of them.")
      .def(
          "worst_case", [](const S& self) { return read(self).worst_case(); }, doc("Simulation::worst_case"))
      .def_property_readonly(
          "stage_times",
          [](const S& self) {
            self.occupancy.require_readable("The simulation");
            return self.simulation.stage_times();
          },
          doc("Simulation::stage_times"))
      .def(
          "set_spindle_speed",
          [](S& self, AngularSpeed speed) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_spindle_speed(speed);
          },
          py::arg("speed"), doc("Simulation::set_spindle_speed"))
      .def(
          "set_effects",
          [](S& self, const Effects& effects) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_effects(effects);
          },
          py::arg("effects"), doc("Simulation::set_effects"))
      .def(
          "set_tool",
          [](S& self, const Tool& tool) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_tool(tool);
          },
          py::arg("tool"), doc("Simulation::set_tool"))
      .def(
          "set_materials",
          [](S& self, const MaterialTable& materials) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_materials(materials);
          },
          py::arg("materials"), doc("Simulation::set_materials"))
      .def(
          "set_friction",
          [](S& self, const std::optional<DryFriction>& friction) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_friction(friction);
          },
          py::arg("friction"), doc("Simulation::set_friction"))
      .def(
          "set_removal",
          [](S& self, RemovalLaw removal) {
            self.occupancy.require_writable("The simulation");
            self.simulation.set_removal(removal);
          },
          py::arg("removal"), doc("Simulation::set_removal"))
      .def(
          "halt_spindle",
          [](S& self) {
            self.occupancy.require_writable("The simulation");
            self.simulation.halt_spindle();
          },
          doc("Simulation::halt_spindle"))
      .def(
          "hold_spindle",
          [](S& self, bool hold) {
            self.occupancy.require_writable("The simulation");
            self.simulation.hold_spindle(hold);
          },
          py::arg("hold"), doc("Simulation::hold_spindle"))
      .def_property_readonly(
          "spindle_is_held", [](const S& self) { return read(self).spindle_is_held(); },
          "Whether the spindle is held, whatever it is set to.")
      .def(
          "reserve_blocks",
          [](S& self, std::size_t count) {
            self.occupancy.require_writable("The simulation");
            self.simulation.reserve_blocks(count);
          },
          py::arg("count"), doc("Simulation::reserve_blocks"))
      .def(
          "snapshot", [](const S& self) { return read(self).snapshot(); }, doc("Simulation::snapshot"))
      .def(
          "restore",
          [](S& self, const WorkpieceSnapshot& snapshot) {
            self.occupancy.require_writable("The simulation");
            self.simulation.restore(snapshot);
          },
          py::arg("snapshot"), doc("Simulation::restore"))
      .def(
          "reserve_undo",
          [](S& self, std::size_t blocks) {
            self.occupancy.require_writable("The simulation");
            self.simulation.reserve_undo(blocks);
          },
          py::arg("blocks"), doc("Simulation::reserve_undo"))
      .def(
          "set_undo_mark",
          [](S& self) {
            self.occupancy.require_writable("The simulation");
            if (!self.simulation.set_undo_mark()) throw Error("There is no memory for undo; call reserve_undo first.");
          },
          "Marks the present state of the workpiece. Raises Error without `reserve_undo`.")
      .def_property_readonly(
          "undo_marks", [](const S& self) { return read(self).undo_marks(); }, "How many marks `undo` can return to.")
      .def(
          "undo",
          [](S& self, std::size_t most) {
            self.occupancy.require_writable("The simulation");
            return self.simulation.undo(most);
          },
          py::arg("most"), doc("Simulation::undo"))
      .def_property_readonly(
          "taken_volume_by_material",
          [](const S& self) {
            const auto& volumes = read(self).taken_volume_by_material();
            return py::array_t<double>(py::ssize_t(volumes.size()), volumes.data());
          },
          "[m^3] (256,) that left without a cut since construction or reset, by material id: islands.remove_island.")
      .def_property_readonly(
          "redo_marks", [](const S& self) { return read(self).redo_marks(); },
          "How many undone marks `redo` can go forth over.")
      .def(
          "redo",
          [](S& self, std::size_t most) {
            self.occupancy.require_writable("The simulation");
            return self.simulation.redo(most);
          },
          py::arg("most"), doc("Simulation::redo"))
      .def(
          "reset",
          [](S& self, const PythonWorkpiece& workpiece) {
            self.occupancy.require_writable("The simulation");
            self.simulation.reset(workpiece.read().clone());
          },
          py::arg("workpiece"),
          "Starts again with a copy of another workpiece: tool position, energies, removed volumes and undo marks are "
          "forgotten.\nIt gets as much memory for undo as the old one had.\n\nRaises\n------\nError\n    When the "
          "workpiece is empty, or the head thinner than a voxel.");
}

/// What Simulation.run would be in C++: the same steps, nothing kept but their sum.
double loop_in_cpp(PythonSimulation& self, const Float64Array& poses, const Float64Array& velocities,
                   const Durations& dt) {
  const RunInput input(poses, velocities, dt);
  self.occupancy.require_writable("The simulation");
  const ReleasedWriting released(self.occupancy);
  double sum = 0;
  for (std::size_t i = 0; i < input.steps; ++i) {
    const StepInput now = input[i];
    sum += self.simulation.step(now.pose, now.velocity, now.dt).force.z();
  }
  return sum;
}

void bind_scenes(py::module_& m) {
  py::class_<Scene>(m, "Scene", doc("Scene"))
      .def_readonly("name", &Scene::name, "What find_scene is asked for.")
      .def_readonly("description", &Scene::description, doc("Scene::description"))
      .def(
          "make", [](const Scene& scene) { return std::make_shared<PythonSimulation>(scene.make()); },
          doc("Scene::make"))
      .def(
          "input", [](const Scene& scene, int tick) { return scene.input(tick); }, py::arg("tick"),
          doc("Scene::input"));
  m.def("scenes", &scenes, py::return_value_policy::copy, doc("scenes"));
  m.def("find_scene", &find_scene, py::return_value_policy::copy, py::arg("name"), doc("find_scene"));
}

}  // namespace

void bind_simulation(py::module_& m) {
  bind_config(m);
  bind_limits(m);
  bind_the_simulation(m);
  m.def("_loop_in_cpp", &loop_in_cpp, py::arg("simulation"), py::arg("poses"), py::arg("velocities"), py::arg("dt"),
        "For benchmarks/python_cost.py.");
  bind_scenes(m);
}

}  // namespace hapticut::python
