// SPDX-License-Identifier: Apache-2.0
// include/hapticut/io: recordings and their replay
#include "bindings.hpp"
#include "steps.hpp"
#include "structs.hpp"
#ifdef HAPTICUT_PYTHON_WITH_IO
#include "hapticut/io/recording/playback.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "recorder.hpp"
#endif

namespace hapticut::python {

#ifdef HAPTICUT_PYTHON_WITH_IO

namespace {

/// Accessor of a recorder's state.
template <class Result>
auto of_recorder(Result (Recorder::*what)() const) {
  return [what](const PythonRecorder& self) { return ((*self.recorder).*what)(); };
}

void bind_recorder(py::module_& m) {
  bind_described<DeviceTick>(m, "DeviceTick");
  using O = RecorderOptions;
  const auto workpiece_file = computed<O, std::string>(
      "workpiece_file", [](const O& o) { return o.workpiece_file.string(); },
      [](O& o, const std::string& path) { o.workpiece_file = path; });
  bind_struct<O>(m, "RecorderOptions", field("device", &O::device), field("note", &O::note),
                 field("capabilities", &O::capabilities), field("buffered_steps", &O::buffered_steps),
                 field("flush_period", &O::flush_period), field("wait_when_full", &O::wait_when_full), workpiece_file);
  using R = PythonRecorder;
  py::class_<R, std::shared_ptr<R>>(m, "Recorder", doc("Recorder"))
      .def(py::init([](const std::filesystem::path& path, const std::shared_ptr<PythonSimulation>& simulation,
                       const O& given, py::object driven_by) {
             simulation->occupancy.require_writable("The simulation");
             if (!simulation->recorder.expired())
               throw Error("another recorder already observes the simulation; close and delete it first.");
             O options = given;
             if (!driven_by.is_none()) options.driven_by = &driven_by.cast<const Device&>();
             auto held = std::make_shared<R>(R{simulation, std::move(driven_by), nullptr});
             {
               const ReleasedWriting released(simulation->occupancy);
               held->recorder = std::make_unique<Recorder>(path, simulation->simulation, options);
             }
             simulation->recorder = held;
             return held;
           }),
           py::arg("path"), py::arg("simulation"), py::arg("options") = O{}, py::arg("driven_by") = py::none(),
           "Records every step of a simulation, including those of a loop or a coupling, until it is closed.\n\n"
           "driven_by is the device whose loop makes the steps. It supplies name, capabilities and the device data of\n"
           "every step. Without it, a custom loop supplies them by options.device, options.capabilities and\n"
           "set_device_tick.")
      .def(
          "step",
          [](R& self, const FewNumbers& pose, const FewNumbers& velocity, double dt,
             const std::optional<DeviceTick>& device) {
            return make_step(*self.simulation, pose, velocity, dt, self.stepper(device ? &*device : nullptr));
          },
          py::arg("X_WH"), py::arg("V_WH"), py::arg("dt"), py::arg("device") = py::none(),
          "Makes a step of the simulation, from a pose (4, 4), a velocity (6,) and dt [s], and records it.")
      .def(
          "run",
          [](R& self, const Float64Array& poses, const Float64Array& velocities, const Durations& dt) {
            return make_steps(*self.simulation, poses, velocities, dt, self.stepper());
          },
          py::arg("poses"), py::arg("velocities"), py::arg("dt"),
          "Makes and records a step for every row of poses (n, 4, 4) and velocities (n, 6); see Simulation.run.\n"
          "A run is faster than the disk: set RecorderOptions.wait_when_full, or steps are lost.")
      .def(
          "set_device_tick",
          [](const R& self, const DeviceTick& tick) {
            self.simulation->occupancy.require_writable("The simulation");
            self.recorder->set_device_tick(tick);
          },
          py::arg("tick"), doc("Recorder::set_device_tick"))
      .def_property_readonly("recorded", of_recorder(&Recorder::recorded), doc("Recorder::recorded"))
      .def_property_readonly("lost", of_recorder(&Recorder::lost), doc("Recorder::lost"))
      .def_property_readonly("failed", of_recorder(&Recorder::failed), doc("Recorder::failed"))
      .def("close", &R::close, doc("Recorder::close"))
      .def("__enter__", [](py::object self) { return self; })
      .def(
          "__exit__", [](R& r, const py::object&, const py::object&, const py::object&) { r.close(); }, py::arg("type"),
          py::arg("value"), py::arg("traceback"));
}

void bind_recording(py::module_& m) {
  m.attr("kRecordingFormat") = kRecordingFormat;
  using I = RecordingInfo;
  bind_result<I>(m, "RecordingInfo", member("format", &I::format), member("version", &I::version),
                 member("commit", &I::commit), member("compiler", &I::compiler), member("cpu", &I::cpu),
                 member("begun", &I::begun), member("device", &I::device), member("note", &I::note),
                 member("closed", &I::closed), member("lost", &I::lost),
                 member("workpiece_hash_at_end", &I::workpiece_hash_at_end), member("remarks", &I::remarks));
  bind_result<RecordedEffects>(m, "RecordedEffects", member("first_step", &RecordedEffects::first_step),
                               member("effects", &RecordedEffects::effects));
  py::class_<Recording>(m, "Recording", doc("Recording"))
      .def_property_readonly("path", &Recording::path, "Path of the file.")
      .def_property_readonly("info", &Recording::info, py::return_value_policy::copy,
                             "Build, machine and device of the recording, and how it ended.")
      .def_property_readonly("has_device", &Recording::has_device, doc("Recording::has_device"))
      .def_property_readonly("capabilities", &Recording::capabilities, py::return_value_policy::copy,
                             doc("Recording::capabilities"))
      .def_property_readonly("default_law", &Recording::default_law, doc("Recording::default_law"))
      .def("__len__", &Recording::size)
      .def(
          "read",
          [](const Recording& recording, std::uint64_t first, std::optional<std::uint64_t> count) {
            std::vector<RecordedStep> steps;
            {
              const py::gil_scoped_release released;
              steps = recording.read(first, count.value_or(recording.size()));
            }
            const auto n = py::ssize_t(steps.size());
            py::array_t<double> poses({n, py::ssize_t(4), py::ssize_t(4)}), velocities({n, py::ssize_t(6)}), dt(n);
            py::array_t<std::int64_t> removed_voxels(n);
            py::array trace = empty_rows(trace_type(), steps.size());
            const auto width = std::size_t(trace.itemsize());
            for (py::ssize_t i = 0; i < n; ++i) {
              const RecordedStep& step = steps[std::size_t(i)];
              write_pose(step.input.X_WH, poses.mutable_data(i));
              std::copy_n(step.input.V_WH.linear.data(), 3, velocities.mutable_data(i));
              std::copy_n(step.input.V_WH.angular.data(), 3, velocities.mutable_data(i) + 3);
              dt.mutable_at(i) = step.input.dt;
              StepResult result;
              result.force = step.force;
              result.torque = step.torque;
              result.removed_volume = step.removed_volume;
              result.contact = step.contact;
              result.model = step.model;
              result.energy = step.energy;
              result.spindle = step.spindle;
              result.sub_steps = step.sub_steps;
              result.status = step.status;
              write_trace_row(result, step.time,
                              static_cast<std::byte*>(trace.mutable_data()) + width * std::size_t(i));
              removed_voxels.mutable_at(i) = std::int64_t(step.removed_voxels);
            }
            trace["removed_voxels"] = removed_voxels;  // the recording has only their number
            py::dict out;
            out["poses"] = poses;
            out["velocities"] = velocities;
            out["dt"] = dt;
            out["trace"] = trace;
            return out;
          },
          py::arg("first") = 0, py::arg("count") = py::none(),
          "`count` steps from `first` on, or all if `count` is None: a dict of poses (n, 4, 4), velocities (n, 6) and\n"
          "dt (n,), the arguments of Simulation.run, and trace, its result.")
      .def_property_readonly("tool", &Recording::tool, py::return_value_policy::copy, "The tool that made the steps.")
      .def_property_readonly("config", &Recording::config, py::return_value_policy::copy, doc("Recording::config"))
      .def_property_readonly("effects", &Recording::effects, py::return_value_policy::copy, doc("Recording::effects"))
      .def(
          "workpiece", [](const Recording& r) { return make_released([&] { return r.workpiece(); }); },
          doc("Recording::workpiece"));
  const auto released = py::call_guard<ReleasedLock>();
  m.def("read_recording", &read_recording, py::arg("path"), doc("read_recording"), released);
  m.def("write_csv", &write_csv, py::arg("recording"), py::arg("path"), doc("write_csv"), released);
  m.def("write_npz", &write_npz, py::arg("recording"), py::arg("path"), doc("write_npz"), released);
  m.def("write_wav", &write_wav, py::arg("recording"), py::arg("path"), py::arg("sample_rate") = 48000.0,
        doc("write_wav"), released);
}

void bind_replay(py::module_& m) {
  using D = ReplayDifference;
  bind_result<D>(m, "ReplayDifference", member("step", &D::step), member("column", &D::column),
                 member("element", &D::element), member("recorded", &D::recorded), member("replayed", &D::replayed));
  using R = ReplayReport;
  bind_result<R>(m, "ReplayReport", member("steps", &R::steps), member("identical", &R::identical),
                 member("first_difference", &R::first_difference),
                 member("max_force_difference", &R::max_force_difference), member("skipped", &R::skipped),
                 member("workpiece_hash", &R::workpiece_hash));
  using Law = std::shared_ptr<ForceLaw>;
  m.def(
      "replay",
      [](const Recording& recording, const std::optional<Law>& law,
         const std::optional<std::function<void(std::uint64_t)>>& progress) {
        ReplayOptions options;
        options.law = law.value_or(nullptr);
        if (progress) options.progress = *progress;
        const ReleasedLock without_lock;
        return replay(recording, options);
      },
      py::arg("recording"), py::arg("law") = py::none(), py::arg("progress") = py::none(), doc("replay"));
  m.def(
      "simulation_of",
      [](const Recording& recording, const std::optional<Law>& law) {
        const py::gil_scoped_release without_lock;
        return std::make_shared<PythonSimulation>(simulation_of(recording, law.value_or(nullptr)));
      },
      py::arg("recording"), py::arg("law") = py::none(), doc("simulation_of"));
}

}  // namespace

void bind_recordings(py::module_& m) {
  use_recordings();  // open_device("replay:FILE")
  bind_struct<PlaybackRange>(m, "PlaybackRange", field("first", &PlaybackRange::first),
                             field("count", &PlaybackRange::count));
  m.attr("kMaxPlayedSteps") = kMaxPlayedSteps;
  m.def("open_playback", &open_playback, py::arg("recording"), py::arg("range") = PlaybackRange{}, doc("open_playback"),
        py::call_guard<py::gil_scoped_release>());
  bind_recorder(m);
  bind_recording(m);
  bind_replay(m);
}

#else

void bind_recordings(py::module_&) {}

#endif

}  // namespace hapticut::python
