// SPDX-License-Identifier: Apache-2.0
// include/hapticut/safety, include/hapticut/realtime: the guard, its options and its log; the measurement of latency
#include "hapticut/safety/guard.hpp"

#include "bindings.hpp"
#include "hapticut/realtime/histogram.hpp"
#include "hapticut/realtime/realtime.hpp"
#include "hapticut/safety/device_limits.hpp"
#include "hapticut/simulation/config.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

void bind_states(py::module_& m) {
  bind_enum<DeviceFault>(m, "DeviceFault");
  bind_described<DeviceCapabilities>(m, "DeviceCapabilities");
  using S = DeviceState;
  bind_described<S>(m, "DeviceState").def("pressed", &S::pressed, py::arg("button"), "Whether a button is pressed.");
  bind_described<ModelContact>(m, "ModelContact");
  bind_struct<DeviceCommand>(m, "DeviceCommand", field("wrench", &DeviceCommand::wrench),
                             field("stop", &DeviceCommand::stop), field("contact", &DeviceCommand::contact));
  bind_bits<OutputChange>(m, "OutputChange");
  bind_described<DeviceOutput>(m, "DeviceOutput");
  m.def("describe", py::overload_cast<DeviceFault>(&describe), py::arg("fault"), doc("describe(DeviceFault)"));
  m.def(
      "describe", [](std::uint32_t changes) { return describe(OutputChange(changes)); }, py::arg("changes"),
      "The bits of OutputChange in words, separated by commas.");
  m.def(
      "has_any", [](std::uint32_t changes, OutputChange wanted) { return has_any(OutputChange(changes), wanted); },
      py::arg("changes"), py::arg("bits"), doc("has_any(OutputChange, OutputChange)"));
  bind_enum<ArmingState>(m, "ArmingState");
}

void bind_log(py::module_& m) {
  bind_enum<SafetyEvent>(m, "SafetyEvent");
  using L = SafetyLogEntry;
  py::class_<L> entry_class(m, "SafetyLogEntry", doc("SafetyLogEntry"));
  pickled_by_members(entry_class, &L::time, &L::sequence, &L::event, &L::value);
  entry_class.def_readonly("time", &L::time, doc("SafetyLogEntry::time"))
      .def_readonly("sequence", &L::sequence, doc("SafetyLogEntry::sequence"))
      .def_readonly("event", &L::event, "The event.")
      .def_readonly("value", &L::value, doc("SafetyLogEntry::value"));
  m.def("describe", py::overload_cast<const SafetyLogEntry&>(&describe), py::arg("entry"),
        "An entry as text: time, name, value and sentence.");
  m.def("sentence_of", &sentence_of, py::arg("entry"), doc("sentence_of"));
  py::class_<SafetyLog>(m, "SafetyLog", doc("SafetyLog"))
      .def("count", &SafetyLog::count, py::arg("event"), doc("SafetyLog::count"))
      .def_property_readonly("dropped", &SafetyLog::dropped, doc("SafetyLog::dropped"))
      .def("drain", &SafetyLog::drain, doc("SafetyLog::drain"));
}

void bind_options(py::module_& m) {
  bind_described<PoseGateOptions>(m, "PoseGateOptions");
  bind_described<ArmingOptions>(m, "ArmingOptions");
  bind_described<PassivityOptions>(m, "PassivityOptions");
  bind_described<ThermalOptions>(m, "ThermalOptions");
  bind_described<WatchdogOptions>(m, "WatchdogOptions");
  bind_described<GuardOptions>(m, "GuardOptions");
}

}  // namespace

void bind_guard(py::module_& m) {
  bind_states(m);
  bind_log(m);
  using Q = Requests;
  py::class_<Q>(m, "Requests", doc("Requests"))
      .def(py::init<>())
      .def("stop", &Q::stop, doc("Requests::stop"))
      .def("emergency_stop", &Q::emergency_stop, doc("Requests::emergency_stop"))
      .def("reset_fault", &Q::reset_fault, doc("Requests::reset_fault"))
      .def("interrupt", &Q::interrupt, py::arg("reason"), doc("Requests::interrupt"))
      .def_property_readonly("stop_wanted", &Q::stop_wanted, "Whether a stop is requested.")
      .def_property_readonly("emergency", &Q::emergency, "Whether an emergency stop is active.")
      .def_property_readonly("reset_wanted", &Q::reset_wanted, "Whether a reset is requested.");
  bind_options(m);
  py::reinterpret_borrow<py::class_<SimulationConfig>>(m.attr("SimulationConfig"))
      .def_static("for_device", &SimulationConfig::for_device, py::arg("device"), doc("SimulationConfig::for_device"));
  m.def("output_limits", &output_limits, py::arg("device"), py::arg("max_contact_speed") = 0.5, doc("output_limits"));
  py::class_<SafetyGuard>(m, "SafetyGuard", doc("SafetyGuard"))
      .def(py::init([](const DeviceCapabilities& capabilities, const GuardOptions& options) {
             return std::make_unique<SafetyGuard>(capabilities, options);  // with a separate Requests object
           }),
           py::arg("capabilities"), py::arg("options") = GuardOptions{}, doc("SafetyGuard::SafetyGuard"))
      .def("start", &SafetyGuard::start, doc("SafetyGuard::start"))
      .def("stop", &SafetyGuard::stop, doc("SafetyGuard::stop"))
      .def("admit", &SafetyGuard::admit, py::return_value_policy::copy, py::arg("reading"), doc("SafetyGuard::admit"))
      .def_property_readonly("repeats", &SafetyGuard::repeats, doc("SafetyGuard::repeats"))
      .def("limit", &SafetyGuard::limit, py::arg("commanded"), py::arg("contact") = ModelContact{},
           doc("SafetyGuard::limit"))
      .def("report_wait", &SafetyGuard::report_wait, py::arg("seconds"), doc("SafetyGuard::report_wait"))
      .def("report_applied", &SafetyGuard::report_applied, py::arg("wrench"), doc("SafetyGuard::report_applied"))
      .def_property_readonly("requests", &SafetyGuard::requests, py::return_value_policy::reference_internal,
                             doc("SafetyGuard::requests"))
      .def_property_readonly("state", &SafetyGuard::state, "Whether a force is allowed.")
      .def("report_exception", &SafetyGuard::report_exception, doc("SafetyGuard::report_exception"))
      .def_property_readonly(
          "heartbeat", [](const SafetyGuard& guard) { return guard.heartbeat().load(); }, doc("SafetyGuard::heartbeat"))
      .def_property_readonly("log", py::overload_cast<>(&SafetyGuard::log), py::return_value_policy::reference_internal,
                             "The log of the guard.")
      .def(
          "drain_log", [](SafetyGuard& guard) { return guard.log().drain(); },
          "Removes and returns the entries of the log, oldest first.")
      .def(
          "count", [](const SafetyGuard& guard, SafetyEvent event) { return guard.log().count(event); },
          py::arg("event"), doc("SafetyLog::count"))
      .def_property_readonly("output", &SafetyGuard::output, py::return_value_policy::copy,
                             "Commanded and applied wrench of the last tick.")
      .def_property_readonly("period", &SafetyGuard::period, doc("SafetyGuard::period"))
      .def_property_readonly("slew", &SafetyGuard::slew, doc("SafetyGuard::slew"))
      .def_property_readonly("max_force", &SafetyGuard::max_force, doc("SafetyGuard::max_force"));

  bind_described<RealtimeOptions>(m, "RealtimeOptions");
  using H = LatencyHistogram;
  py::class_<H> histogram_class(m, "LatencyHistogram", doc("LatencyHistogram"));
  pickled_by_bytes(histogram_class);
  histogram_class.def(py::init<>())
      .def("add", &H::add, py::arg("seconds"), doc("LatencyHistogram::add"))
      .def_property_readonly("count", &H::count, "How many durations were added.")
      .def_property_readonly("min", &H::min, doc("LatencyHistogram::min"))
      .def_property_readonly("max", &H::max, doc("LatencyHistogram::max"))
      .def_property_readonly("mean", &H::mean, doc("LatencyHistogram::mean"))
      .def_property_readonly("longer", &H::longer, doc("LatencyHistogram::longer"))
      .def_property_readonly(
          "buckets",
          [](const H& h) { return py::array_t<std::uint64_t>(py::ssize_t(h.buckets().size()), h.buckets().data()); },
          "(2000,) uint64: how many durations fell into each bucket of 1 us.")
      .def("at_least", &H::at_least, py::arg("seconds"), doc("LatencyHistogram::at_least"))
      .def("quantile", &H::quantile, py::arg("fraction"), doc("LatencyHistogram::quantile"));
}

}  // namespace hapticut::python
