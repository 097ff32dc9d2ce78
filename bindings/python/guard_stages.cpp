// SPDX-License-Identifier: Apache-2.0
// include/hapticut/device: the stages of the safety pipeline, each by itself
#include "bindings.hpp"
#include "hapticut/safety/arming.hpp"
#include "hapticut/safety/guard.hpp"
#include "hapticut/safety/passivity.hpp"
#include "hapticut/safety/pose_gate.hpp"
#include "hapticut/safety/thermal_budget.hpp"
#include "hapticut/safety/watchdog.hpp"
#include "structs.hpp"

namespace hapticut::python {

void bind_guard_stages(py::module_& m) {
  using G = PoseGate;
  py::class_<G> gate(m, "PoseGate", doc("PoseGate"));
  bind_enum<G::Verdict>(gate, "Verdict", "PoseGate::Verdict");
  gate.def(py::init<const DeviceCapabilities&, const PoseGateOptions&>(), py::arg("capabilities"),
           py::arg("options") = PoseGateOptions{}, doc("PoseGate::PoseGate"))
      .def("check", &G::check, py::arg("reading"), py::arg("dt"), py::arg("log"), doc("PoseGate::check"))
      .def_property_readonly("state", &G::state, py::return_value_policy::copy, doc("PoseGate::state"))
      .def("restart", &G::restart, doc("PoseGate::restart"));

  using A = Arming;
  py::class_<A>(m, "Arming", doc("Arming"))
      .def(py::init<const ArmingOptions&>(), py::arg("options") = ArmingOptions{}, doc("Arming::Arming"))
      .def("start", &A::start, py::arg("log"), "Begins a run: armed, waiting for valid readings.")
      .def("stop", &A::stop, "Ends a run: off.")
      .def("interrupt", &A::interrupt, py::arg("reason"), py::arg("short_ramp"), py::arg("log"), py::arg("value") = 0.0,
           doc("Arming::interrupt"))
      .def("fail", &A::fail, py::arg("log"), py::arg("value") = 0.0, "Enters the fault state, until it is reset.")
      .def("reset", &A::reset, py::arg("log"), doc("Arming::reset"))
      .def(
          "tick",
          [](A& a, double dt, bool reading_ok, double force, double torque, SafetyLog& log,
             std::optional<bool> touching) { return a.tick(dt, reading_ok, force, torque, touching, log); },
          py::arg("dt"), py::arg("reading_ok"), py::arg("force"), py::arg("torque"), py::arg("log"),
          py::arg("touching") = py::none(), doc("Arming::tick"))
      .def_property_readonly("state", &A::state, "Whether a force is allowed.");

  using P = PassivityController;
  py::class_<P>(m, "PassivityController", doc("PassivityController"))
      .def(py::init<const PassivityOptions&, double>(), py::arg("options"), py::arg("greatest"),
           doc("PassivityController::PassivityController"))
      .def(
          "control",
          [](P& p, const Vec3& force, const Vec3& applied, const Vec3& motion, double dt, const Vec3& effects,
             std::optional<double> stored, std::optional<double> motor) {
            return p.control({{force}, {effects}, {applied}, motion, Vec3::Zero(), dt, stored, motor}).force;
          },
          py::arg("force"), py::arg("applied"), py::arg("motion"), py::arg("dt"),
          py::arg("effects") = Vec3(Vec3::Zero()), py::arg("stored") = py::none(), py::arg("motor") = py::none(),
          "[N] (3,) the force with what damping it takes. Forces, effects and motion are (3,), in N and m.")
      .def("restart", &P::restart, "Forgets what was stored.")
      .def_property_readonly("stored", &P::stored, doc("PassivityController::stored"))
      .def_property_readonly("taken", &P::taken, doc("PassivityController::taken"));

  using T = ThermalBudget;
  py::class_<T>(m, "ThermalBudget", doc("ThermalBudget"))
      .def(py::init<double, double, const ThermalOptions&>(), py::arg("peak"), py::arg("continuous"),
           py::arg("options") = ThermalOptions{}, doc("ThermalBudget::ThermalBudget"))
      .def_property_readonly("limit", &T::limit, doc("ThermalBudget::limit"))
      .def_property_readonly("is_limiting", &T::is_limiting, "Whether the limit is below the peak.")
      .def("tick", &T::tick, py::arg("force"), py::arg("temperature"), py::arg("dt"), doc("ThermalBudget::tick"));

  using W = Watchdog;
  py::class_<W> watchdog(m, "Watchdog", doc("Watchdog"));
  bind_enum<W::Verdict>(watchdog, "Verdict", "Watchdog::Verdict");
  watchdog
      .def(py::init<const WatchdogOptions&, double>(), py::arg("options") = WatchdogOptions{}, py::arg("period") = 1e-3,
           doc("Watchdog::Watchdog"))
      .def("verdict", &W::verdict, py::arg("seconds_without"), "What that long a silence means.")
      .def("scale", &W::scale, py::arg("seconds_without"), doc("Watchdog::scale"))
      .def_property_readonly("options", &W::options, py::return_value_policy::copy, "As given.");
  py::class_<SafetyGuard>(m.attr("SafetyGuard"))
      .def("report_silence", &SafetyGuard::report_silence, py::arg("verdict"), py::arg("share"),
           doc("SafetyGuard::report_silence"));
}

}  // namespace hapticut::python
