// SPDX-License-Identifier: Apache-2.0
// include/hapticut/device: real and simulated devices; include/hapticut/loop/workspace_map.hpp
#include "hapticut/device/device.hpp"

#include <limits>
#include <optional>

#include "bindings.hpp"
#include "device/use_maker_devices.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"
#include "hapticut/device/simulated/playback.hpp"
#include "hapticut/loop/workspace_map.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

/// A path that may be a Python function. An exception cannot leave the device's loop: it goes to sys.unraisablehook,
/// and the reading becomes invalid, so the guard gives no force.
ScriptedPath safe_path(const ScriptedPath& given) {
  return [given](double time) {
    try {
      return given(time);
    } catch (py::error_already_set& error) {
      const py::gil_scoped_acquire lock;
      error.discard_as_unraisable("the path of a MockDevice");
    } catch (const std::exception& error) {
      const py::gil_scoped_acquire lock;
      PyErr_SetString(PyExc_RuntimeError, error.what());
      PyErr_WriteUnraisable(Py_None);
    }
    return Pose::from_translation(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  };
}

}  // namespace

/// A null pointer becomes None.
template <>
struct InPython<ScriptedPath> {
  using Type = std::optional<ScriptedPath>;
  static Type there(const ScriptedPath& path) { return path ? Type(path) : std::nullopt; }
  static ScriptedPath back(const Type& given) { return given && *given ? safe_path(*given) : nullptr; }
};

namespace {

void bind_models(py::module_& m) {
  using D = DeviceModel;
  bind_described<D>(m, "DeviceModel");
  m.def(
      "device_models", [] { return std::vector<D>(device_models().begin(), device_models().end()); },
      doc("device_models"));
  m.def("device_model", &device_model, py::return_value_policy::copy, py::arg("name"), doc("device_model"));
  m.def("capabilities", &capabilities, py::arg("model"), doc("capabilities"));
  using H = HandModel;
  bind_described<H>(m, "HandModel");
  m.def(
      "hand_models", [] { return std::vector<H>(hand_models().begin(), hand_models().end()); }, doc("hand_models"));
  m.def("hand_model", &hand_model, py::return_value_policy::copy, py::arg("name"), doc("hand_model"));
}

void bind_runs(py::module_& m) {
  bind_described<RunOptions>(m, "RunOptions");
  using R = RunReport;
  auto report_class =
      bind_part_of_result<R>(m, "RunReport", member("period", &R::period), member("ticks", &R::ticks),
                             member("missed", &R::missed), member("wake_up", &R::wake_up),
                             member("compute", &R::compute), member("end", &R::end), member("fault", &R::fault),
                             member("arming", &R::arming), member("log", &R::log), member("warnings", &R::warnings));
  pickled_by_members(report_class, &R::period, &R::ticks, &R::missed, &R::wake_up, &R::compute, &R::end, &R::fault,
                     &R::arming, &R::events, &R::log, &R::warnings);
  report_class.def_property_readonly(
      "events",
      [](const R& report) {
        py::dict events;
        for (std::size_t i = 0; i < kSafetyEvents; ++i)
          if (report.events[i] > 0) events[py::str(std::string(name_of(SafetyEvent(i))))] = report.events[i];
        return events;
      },
      "dict from the name of a SafetyEvent to the number of ticks that reported it.");
}

void bind_devices(py::module_& m) {
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<Device>(m, "Device", doc("Device"))
      .def_property_readonly("name", &Device::name, doc("Device::name"))
      .def_property_readonly("capabilities", &Device::capabilities, py::return_value_policy::copy,
                             "What the device can measure and render.")
      .def(
          "run",
          [](Device& device, const DeviceCallback& callback, const RunOptions& options) {
            try {
              return device.run(callback, options);
            } catch (const py::cast_error&) {            // another type
            } catch (const py::reference_cast_error&) {  // None
            }
            throw py::type_error(
                "the callback of Device.run returned no DeviceCommand; return DeviceCommand(Wrench(force, torque)).");
          },
          py::arg("callback"), py::arg("options") = RunOptions{}, doc("Device::run"), Released())
      .def_property_readonly("requests", &Device::requests, py::return_value_policy::reference_internal,
                             doc("Device::requests"))
      .def("stop", &Device::stop, doc("Device::stop"))
      .def("emergency_stop", &Device::emergency_stop, doc("Device::emergency_stop"))
      .def("reset_fault", &Device::reset_fault, doc("Device::reset_fault"))
      .def("interrupt", &Device::interrupt, py::arg("reason"), doc("Device::interrupt"))
      .def_property_readonly("is_running", &Device::is_running, "Whether a run is in progress.")
      .def_property_readonly("state", &Device::state, doc("Device::state"))
      .def_property_readonly("output", &Device::output, doc("Device::output"))
      .def_property_readonly("arming", &Device::arming, "The state of the guard.")
      .def("drain_log", &Device::drain_log, doc("Device::drain_log"))
      .def("count", &Device::count, py::arg("event"), doc("Device::count"));
  m.def("open_device", &open_device, py::arg("name"), doc("open_device"));
  m.def(
      "device_drivers",
      [] {
        py::list drivers;
        for (const DeviceDriver& driver : device_drivers()) {
          py::dict entry;
          entry["scheme"] = driver.scheme;
          entry["usage"] = driver.usage;
          entry["missing"] = driver.missing;
          drivers.append(entry);
        }
        return drivers;
      },
      "All device drivers, usable or not: dicts with scheme, usage and missing (empty, or what to install).");

  m.def("scripted_path", &scripted_path, py::arg("name"), doc("scripted_path"));
  bind_described<MockOptions>(m, "MockOptions");
  py::class_<MockDevice, Device>(m, "MockDevice", doc("MockDevice"))
      .def(py::init<MockOptions, std::string>(), py::arg("options"), py::arg("name") = "mock",
           doc("MockDevice::MockDevice"));
  m.def("open_mock", &open_mock, py::arg("text"), doc("open_mock"));

  py::class_<PlaybackDevice, Device>(m, "PlaybackDevice", doc("PlaybackDevice"))
      .def(py::init<std::vector<DeviceState>, const DeviceCapabilities&, std::string>(), py::arg("readings"),
           py::arg("capabilities") = DeviceCapabilities{}, py::arg("name") = "playback",
           doc("PlaybackDevice::PlaybackDevice"))
      .def("size", &PlaybackDevice::size, doc("PlaybackDevice::size"))
      .def("__len__", &PlaybackDevice::size);

  bind_enum<MoveKey>(m, "MoveKey");
  using M = MouseOptions;
  bind_described<M>(m, "MouseOptions");
  py::class_<MouseDevice, Device>(m, "MouseDevice", doc("MouseDevice"))
      .def(py::init<const M&>(), py::arg("options") = M{}, doc("MouseDevice::MouseDevice"))
      .def("pointer_moved", &MouseDevice::pointer_moved, py::arg("dx"), py::arg("dy"),
           doc("MouseDevice::pointer_moved"))
      .def("wheel_turned", &MouseDevice::wheel_turned, py::arg("notches"), doc("MouseDevice::wheel_turned"))
      .def("button", &MouseDevice::button, py::arg("number"), py::arg("pressed"), doc("MouseDevice::button"))
      .def("key", &MouseDevice::key, py::arg("key"), py::arg("pressed"), doc("MouseDevice::key"))
      .def_property_readonly("set_point", &MouseDevice::set_point, doc("MouseDevice::set_point"));
}

void bind_map(py::module_& m) {
  using O = WorkspaceMapOptions;
  bind_described<O>(m, "WorkspaceMapOptions");
  using M = WorkspaceMap;
  py::class_<M>(m, "WorkspaceMap", doc("WorkspaceMap"))
      .def(py::init<const O&>(), py::arg("options") = O{}, doc("WorkspaceMap::WorkspaceMap"))
      .def("disengage", &M::disengage, py::arg("X_BS"), doc("WorkspaceMap::disengage"))
      .def("engage", &M::engage, py::arg("X_BS"), doc("WorkspaceMap::engage"))
      .def("place", &M::place, py::arg("X_BS"), py::arg("X_WH"), doc("WorkspaceMap::place"))
      .def("set_scale", &M::set_scale, py::arg("scale"), py::arg("X_BS"), doc("WorkspaceMap::set_scale"))
      .def_property_readonly("engaged", &M::engaged, "Whether the clutch is closed.")
      .def_property_readonly("scale", &M::scale, doc("WorkspaceMap::scale"))
      .def_property_readonly("options", &M::options, py::return_value_policy::copy, doc("WorkspaceMap::options"))
      .def("to_world", py::overload_cast<const Pose&>(&M::to_world, py::const_), py::arg("X_BS"),
           doc("WorkspaceMap::to_world(Pose)"))
      .def("to_world", py::overload_cast<const Pose&, const Twist&>(&M::to_world, py::const_), py::arg("X_BS"),
           py::arg("V_BS"), doc("WorkspaceMap::to_world(Pose, Twist)"))
      .def("to_device", &M::to_device, py::arg("X_BS"), py::arg("wrench"), doc("WorkspaceMap::to_device"))
      .def("felt_stiffness", &M::felt_stiffness, py::arg("stiffness"), doc("WorkspaceMap::felt_stiffness"));
  m.def("gains_in_world", &gains_in_world, py::arg("felt"), py::arg("map"), doc("gains_in_world"));
}

}  // namespace

void bind_device(py::module_& m) {
  use_maker_devices();
  bind_models(m);
  bind_runs(m);
  bind_devices(m);
  bind_map(m);
}

}  // namespace hapticut::python
