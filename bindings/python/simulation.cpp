// SPDX-License-Identifier: Apache-2.0
// include/hapticut/simulation
#include "simulation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bindings.hpp"
#include "hapticut/simulation/scenes.hpp"
#include "recording.hpp"
#include "structs.hpp"
#include "tool_head.hpp"
#include "trace.hpp"

namespace hapticut::python {

TraceRow trace_row(const StepResult& result, double time) {
  TraceRow row{};
  row.time = time;
  const auto copy = [](const Vec3& from, double* to) { std::copy_n(from.data(), 3, to); };
  copy(result.force, row.force);
  copy(result.torque, row.torque);
  row.removed_voxels = std::int64_t(result.removed_voxels.size());
  row.removed_volume = result.removed_volume;
  row.contact = {result.contact.voxels, result.contact.volume, result.contact.depth};
  copy(result.model.force, row.model.force);
  copy(result.model.torque, row.model.torque);
  const EnergyLedger& e = result.energy;
  row.energy = {e.hand_work, e.motor_work, e.elastic, e.cutting,  e.released, e.damping,
                e.rubbing,   e.anchored,   e.sliding, e.credited, e.entered};
  row.spindle = {result.spindle.speed, result.spindle.torque};
  row.sub_steps = result.sub_steps;
  row.status = std::uint32_t(result.status);
  return row;
}

namespace {

void require_finite(std::span<const double> numbers, std::size_t per_row, const char* what) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      throw Error(std::string(what) + "[" + std::to_string(i / per_row) + "] holds " + format_number(numbers[i]) +
                  "; every number must be finite. Nothing was simulated.");
}

/// The inputs of a run, checked before its first step.
struct RunInput {
  std::span<const double> poses, velocities, durations;
  double dt;
  std::size_t steps;

  RunInput(const py::object& given_poses, const py::object& given_velocities, const py::object& given_dt)
      : poses(numbers_of(given_poses, "poses", {-1, 4, 4})),
        velocities(numbers_of(given_velocities, "velocities", {-1, 6})),
        dt(0),
        steps(poses.size() / 16) {
    if (velocities.size() / 6 != steps)
      throw Error("poses has " + std::to_string(steps) + " rows, but velocities has " +
                  std::to_string(velocities.size() / 6) + "; each step needs one of both.");
    if (py::isinstance<py::array>(given_dt) && py::reinterpret_borrow<py::array>(given_dt).ndim() > 0) {
      durations = numbers_of(given_dt, "dt", {-1});
      if (durations.size() != steps)
        throw Error("poses has " + std::to_string(steps) + " rows, but dt has " + std::to_string(durations.size()) +
                    "; give one number, or one for each step.");
      require_finite(durations, 1, "dt");
    } else {
      dt = PyFloat_AsDouble(given_dt.ptr());
      if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw Error("dt: " + describe_given(given_dt) +
                    " was given; needed is a number, or an array of shape (n,) and "
                    "dtype float64.");
      }
      require_finite({&dt, 1}, 1, "dt");
    }
    require_finite(poses, 16, "poses");
    require_finite(velocities, 6, "velocities");
    for (std::size_t i = 0; i < steps; ++i) (void)pose_of(i);
  }
  [[nodiscard]] Pose pose_of(std::size_t step) const { return pose_from(poses.data() + 16 * step, "a row of poses"); }
  [[nodiscard]] Twist velocity_of(std::size_t step) const {
    return {Vec3(velocities.data() + 6 * step), Vec3(velocities.data() + 6 * step + 3)};
  }
  [[nodiscard]] double duration_of(std::size_t step) const { return durations.empty() ? dt : durations[step]; }
};

}  // namespace

PythonStepResult make_step(PythonSimulation& simulation, const FewNumbers& pose, const FewNumbers& velocity, double dt,
                           const Stepper& step) {
  simulation.occupancy.require_writable("The simulation");
  std::array<double, 16> matrix;
  std::array<double, 6> twist;
  if (!read_numbers(pose, "pose", {4, 4}, matrix.data())) (void)numbers_of(pose, "pose", {4, 4});
  if (!read_numbers(velocity, "velocity", {6}, twist.data())) (void)numbers_of(velocity, "velocity", {6});
  return PythonStepResult(step({pose_from(matrix.data(), "pose"), {Vec3(twist.data()), Vec3(twist.data() + 3)}, dt}));
}

py::array make_steps(PythonSimulation& simulation, const Float64Array& poses, const Float64Array& velocities,
                     const Durations& dt, const Stepper& step) {
  simulation.occupancy.require_writable("The simulation");
  const RunInput input(poses, velocities, dt);
  py::array_t<TraceRow> trace{py::ssize_t(input.steps)};
  TraceRow* rows = trace.mutable_data();
  simulation.removed.clear();
  {
    const ReleasedWriting released(simulation.occupancy);
    double time = 0;
    for (std::size_t i = 0; i < input.steps; ++i) {
      const double duration = input.duration_of(i);
      const StepResult& result = step({input.pose_of(i), input.velocity_of(i), duration});
      time += duration;
      rows[i] = trace_row(result, time);
      for (const RemovedVoxel& voxel : result.removed_voxels)
        simulation.removed.push_back(
            {std::int64_t(i), {voxel.index[0], voxel.index[1], voxel.index[2]}, voxel.material});
    }
  }
  return trace;
}

namespace {

Stepper stepper_of(PythonSimulation& self) {
  return [&self](const StepInput& input) -> const StepResult& {
    return self.simulation.step(input.pose, input.velocity, input.dt);
  };
}

void bind_config(py::module_& m) {
  using C = SimulationConfig;
  using Law = std::optional<std::shared_ptr<ForceLaw>>;
  const auto law = computed<C, Law>(
      "law", [](const C& c) { return c.law ? Law(std::const_pointer_cast<ForceLaw>(c.law)) : std::nullopt; },
      [](C& c, const Law& given) { c.law = given.value_or(nullptr); });
  bind_struct<C>(m, "SimulationConfig", field("reference_stiffness", &C::reference_stiffness),
                 field("removal", &C::removal), field("quadrature", &C::quadrature), law,
                 field("friction", &C::friction), field("deep_contact", &C::deep_contact),
                 field("handle_torque", &C::handle_torque), field("handle_torque_scale", &C::handle_torque_scale),
                 field("effects", &C::effects), field("update_rate", &C::update_rate),
                 field("reserved_blocks", &C::reserved_blocks),
                 field("removed_voxel_capacity", &C::removed_voxel_capacity), field("voxel_budget", &C::voxel_budget),
                 field("stage_times", &C::stage_times), field("shortest_dt", &C::shortest_dt),
                 field("longest_dt", &C::longest_dt), field("longest_sweep", &C::longest_sweep));
  m.def("validate", py::overload_cast<const C&>(&validate), py::arg("config"), doc("validate"));
}

void bind_result_of_step(py::module_& m) {
  bind_bits<StepStatus>(m, "StepStatus",
                        {{"ok", StepStatus::ok},
                         {"pose_rejected", StepStatus::pose_rejected},
                         {"velocity_rejected", StepStatus::velocity_rejected},
                         {"dt_rejected", StepStatus::dt_rejected},
                         {"jump_rejected", StepStatus::jump_rejected},
                         {"blocks_low", StepStatus::blocks_low},
                         {"blocks_exhausted", StepStatus::blocks_exhausted},
                         {"removed_list_full", StepStatus::removed_list_full},
                         {"power_limited", StepStatus::power_limited},
                         {"engaged_layer_thick", StepStatus::engaged_layer_thick},
                         {"vibration_left_out", StepStatus::vibration_left_out},
                         {"detail_reduced", StepStatus::detail_reduced}});
  m.attr("kRejected") = std::uint32_t(kRejected);
  m.def(
      "has", [](std::uint32_t bits, StepStatus wanted) { return has(StepStatus(bits), wanted); }, py::arg("status"),
      py::arg("bits"), doc("has"));
  bind_result<Contact>(m, "Contact", member("voxels", &Contact::voxels), member("volume", &Contact::volume),
                       member("depth", &Contact::depth));
  bind_result<SpindleState>(m, "SpindleState", member("speed", &SpindleState::speed),
                            member("torque", &SpindleState::torque));
  using E = EnergyLedger;
  bind_result<E>(m, "EnergyLedger", member("hand_work", &E::hand_work), member("motor_work", &E::motor_work),
                 member("elastic", &E::elastic), member("cutting", &E::cutting), member("released", &E::released),
                 member("damping", &E::damping), member("rubbing", &E::rubbing), member("anchored", &E::anchored),
                 member("sliding", &E::sliding), member("credited", &E::credited), member("entered", &E::entered))
      .def("imbalance", &E::imbalance, doc("EnergyLedger::imbalance"))
      .def("closure", &E::closure, doc("EnergyLedger::closure"));

  using R = PythonStepResult;
  static_assert(sizeof(RemovedVoxel) == 16 && sizeof(int) == 4);
  py::class_<R>(m, "StepResult",
                "What one step returns. It owns what it holds and stays as it is when further steps are made.")
      .def_property_readonly(
          "force", [](const R& r) { return r.result.force; }, doc("StepResult::force"))
      .def_property_readonly(
          "torque", [](const R& r) { return r.result.torque; }, doc("StepResult::torque"))
      .def_property_readonly(
          "removed_voxels",
          [](const py::object& self) {
            const auto& voxels = self.cast<const R&>().voxels;
            return view(py::dtype::of<std::int32_t>(), {py::ssize_t(voxels.size()), 3}, {sizeof(RemovedVoxel), 4},
                        voxels.empty() ? nullptr : voxels.data()->index.data(), self);
          },
          "(n, 3) int32: indices of the voxels that this step emptied; read-only.")
      .def_property_readonly(
          "removed_materials",
          [](const py::object& self) {
            const auto& voxels = self.cast<const R&>().voxels;
            return view(py::dtype::of<std::uint8_t>(), {py::ssize_t(voxels.size())}, {sizeof(RemovedVoxel)},
                        voxels.empty() ? nullptr : &voxels.data()->material, self);
          },
          "(n,) uint8: what each of the removed voxels was made of; read-only.")
      .def_property_readonly(
          "removed_volume", [](const R& r) { return r.result.removed_volume; }, doc("StepResult::removed_volume"))
      .def_property_readonly(
          "contact", [](const R& r) { return r.result.contact; }, doc("StepResult::contact"))
      .def_property_readonly(
          "model", [](const R& r) { return r.result.model; }, doc("StepResult::model"))
      .def_property_readonly(
          "energy", [](const R& r) { return r.result.energy; }, doc("StepResult::energy"))
      .def_property_readonly(
          "spindle", [](const R& r) { return r.result.spindle; }, doc("StepResult::spindle"))
      .def_property_readonly(
          "sub_steps", [](const R& r) { return r.result.sub_steps; }, doc("StepResult::sub_steps"))
      .def_property_readonly(
          "status", [](const R& r) { return std::uint32_t(r.result.status); },
          "Bits of StepStatus; 0 = nothing to report.")
      .def("__repr__", [](const py::object& self) {
        const auto text = [&](const char* name) { return std::string(py::repr(self.attr(name))); };
        return "StepResult(force=" + text("force") + ", torque=" + text("torque") +
               ", removed_volume=" + text("removed_volume") + ", status=" + text("status") + ")";
      });
}

void bind_limits(py::module_& m) {
  using T = StageTimes;
  bind_result<T>(m, "StageTimes", member("check_input", &T::check_input), member("plan_sweep", &T::plan_sweep),
                 member("plan_sub_step", &T::plan_sub_step), member("find_blocks", &T::find_blocks),
                 member("evaluate_contact", &T::evaluate_contact), member("remove_material", &T::remove_material),
                 member("hold_deep_contact", &T::hold_deep_contact), member("add_friction", &T::add_friction),
                 member("book_energy", &T::book_energy), member("transport_to_handle", &T::transport_to_handle),
                 member("add_effects", &T::add_effects));
  bind_result<WorstCase>(m, "WorstCase", member("blocks", &WorstCase::blocks), member("voxels", &WorstCase::voxels),
                         member("sub_steps", &WorstCase::sub_steps),
                         member("level_of_detail", &WorstCase::level_of_detail));
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
          "nothing was simulated then.\n    Whatever else is wrong with an input is reported by `status`, as step "
          "does.")
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
          "tool", [](const S& self) { return self.simulation.tool(); }, "As given.")
      .def_property_readonly(
          "config", [](const S& self) { return self.simulation.config(); }, "As given; a copy.")
      .def_property_readonly(
          "last_result",
          [](S& self) {
            self.occupancy.require_readable("The simulation");
            return PythonStepResult(self.simulation.last_result());
          },
          "The result of the last step.")
      .def_property_readonly(
          "removed_volume_by_material",
          [](S& self) {
            self.occupancy.require_readable("The simulation");
            const auto& volumes = self.simulation.removed_volume_by_material();
            return py::array_t<double>(py::ssize_t(volumes.size()), volumes.data());
          },
          "[m^3] (256,) taken away since construction or reset, by material id.")
      .def_property_readonly(
          "spindle_setting", [](const S& self) { return self.simulation.spindle_setting(); },
          doc("Simulation::spindle_setting"))
      .def_property_readonly(
          "steps", [](const S& self) { return self.simulation.steps(); }, doc("Simulation::steps"))
      .def_property_readonly(
          "workpiece_exchanges", [](const S& self) { return self.simulation.workpiece_exchanges(); },
          doc("Simulation::workpiece_exchanges"))
      .def(
          "changed_blocks",
          [](S& self) {
            self.occupancy.require_readable("The simulation");
            const ChangedBlocks changed = self.simulation.changed_blocks();
            py::array_t<std::int32_t> origins({py::ssize_t(changed.origins.size()), py::ssize_t(3)});
            for (std::size_t i = 0; i < changed.origins.size(); ++i)
              std::copy_n(changed.origins[i].data(), 3, origins.mutable_data(py::ssize_t(i)));
            return py::make_tuple(origins, changed.complete);
          },
          "What the last step has changed: (n, 3) int32 first voxels of blocks, and whether that is all of them.")
      .def(
          "worst_case", [](const S& self) { return self.simulation.worst_case(); }, doc("Simulation::worst_case"))
      .def_property_readonly(
          "stage_times",
          [](const S& self) {
            self.occupancy.require_readable("The simulation");
            return self.simulation.stage_times();
          },
          doc("Simulation::stage_times"))
      .def(
          "set_spindle_speed",
          [](S& self, double speed) {
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
          "reserve_blocks",
          [](S& self, std::size_t count) {
            self.occupancy.require_writable("The simulation");
            self.simulation.reserve_blocks(count);
          },
          py::arg("count"), doc("Simulation::reserve_blocks"))
      .def(
          "snapshot",
          [](S& self) {
            self.occupancy.require_readable("The simulation");
            return self.simulation.snapshot();
          },
          doc("Simulation::snapshot"))
      .def(
          "restore",
          [](S& self, const WorkpieceSnapshot& snapshot) {
            self.occupancy.require_writable("The simulation");
            self.simulation.restore(snapshot);
          },
          py::arg("snapshot"), doc("Simulation::restore"))
      .def(
          "reset",
          [](S& self, const PythonWorkpiece& workpiece) {
            self.occupancy.require_writable("The simulation");
            self.simulation.reset(workpiece.read().clone());
          },
          py::arg("workpiece"),
          "Starts again with a copy of another workpiece: tool position, energies and removed volumes are "
          "forgotten.\n\nRaises\n------\nError\n    When the workpiece is empty, or the head thinner than a voxel.");
}

void bind_scenes(py::module_& m) {
  bind_struct<StepInput>(m, "StepInput", field("pose", &StepInput::pose), field("velocity", &StepInput::velocity),
                         field("dt", &StepInput::dt));
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
  PYBIND11_NUMPY_DTYPE(ContactRow, voxels, volume, depth);
  PYBIND11_NUMPY_DTYPE(WrenchRow, force, torque);
  PYBIND11_NUMPY_DTYPE(SpindleRow, speed, torque);
  PYBIND11_NUMPY_DTYPE(EnergyRow, hand_work, motor_work, elastic, cutting, released, damping, rubbing, anchored,
                       sliding, credited, entered);
  PYBIND11_NUMPY_DTYPE(TraceRow, time, force, torque, removed_voxels, removed_volume, contact, model, energy, spindle,
                       sub_steps, status);
  PYBIND11_NUMPY_DTYPE(RemovedInRun, step, index, material);
  bind_config(m);
  bind_result_of_step(m);
  bind_limits(m);
  bind_the_simulation(m);
  bind_scenes(m);
}

}  // namespace hapticut::python
