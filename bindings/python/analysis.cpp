// SPDX-License-Identifier: Apache-2.0
// include/hapticut/analysis: the closed loop in simulated time, what it measures, and injected faults
#include "bindings.hpp"
#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/analysis/faults.hpp"
#include "hapticut/analysis/pressed_ball.hpp"
#include "hapticut/analysis/stability.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "interruption.hpp"
#include "models.hpp"
#include "structs.hpp"

namespace hapticut::python {

namespace {

void bind_plant(py::module_& m) {
  using O = PlantOptions;
  bind_described<O>(m, "PlantOptions");
  py::class_<Plant>(m, "Plant", doc("Plant"))
      .def(py::init<const DeviceModel&, const HandModel&, const O&>(), py::arg("device"), py::arg("hand"),
           py::arg("options") = O{}, doc("Plant::Plant"))
      .def("reset", &Plant::reset, py::arg("X_BS"), doc("Plant::reset"))
      .def("set_target", &Plant::set_target, py::arg("X_BS"), doc("Plant::set_target"))
      .def_property_readonly("target", &Plant::target, "(4, 4) target pose of the hand.")
      .def("set_velocity", &Plant::set_velocity, py::arg("velocity"), doc("Plant::set_velocity"))
      .def("advance", &Plant::advance, py::arg("wrench"), doc("Plant::advance"))
      .def("advance_fine", &Plant::advance_fine, py::arg("wrench"), doc("Plant::advance_fine"))
      .def_property_readonly("pose", &Plant::pose, "(4, 4) exact pose.")
      .def_property_readonly("measured_pose", &Plant::measured_pose, "(4, 4) pose measured by the encoders.")
      .def_property_readonly("velocity", &Plant::velocity, "(6,) exact velocity.")
      .def_property_readonly("kinetic_energy", &Plant::kinetic_energy, doc("Plant::kinetic_energy"))
      .def_property_readonly("device", &Plant::device, py::return_value_policy::copy, "As passed to the constructor.")
      .def_property_readonly("hand", &Plant::hand, py::return_value_policy::copy, "As passed to the constructor.")
      .def_property_readonly("options", &Plant::options, py::return_value_policy::copy,
                             "As passed to the constructor.");
  py::reinterpret_borrow<py::class_<MockDevice, Device>>(m.attr("MockDevice"))
      .def_property_readonly("plant", &MockDevice::plant, py::return_value_policy::copy,
                             "A copy of the present state of device and hand.");
}

void bind_closed_loop(py::module_& m) {
  using W = LinearWall;
  py::class_<W> wall_class(m, "LinearWall", doc("LinearWall"));
  pickled_by_bytes(wall_class);
  wall_class
      .def(py::init([](double stiffness, double damping, double filter, bool one_sided, double height) {
             W wall;
             wall.stiffness = stiffness;
             wall.damping = damping;
             wall.filter = filter;
             wall.one_sided = one_sided;
             wall.height = height;
             return wall;
           }),
           py::arg("stiffness") = 0.0, py::arg("damping") = 0.0, py::arg("filter") = 0.0, py::arg("one_sided") = true,
           py::arg("height") = 0.0)
      .def_readwrite("stiffness", &W::stiffness, doc("LinearWall::stiffness"))
      .def_readwrite("damping", &W::damping, doc("LinearWall::damping"))
      .def_readwrite("filter", &W::filter, doc("LinearWall::filter"))
      .def_readwrite("one_sided", &W::one_sided, doc("LinearWall::one_sided"))
      .def_readwrite("height", &W::height, doc("LinearWall::height"))
      .def("__call__", &W::operator(), py::arg("state"), "The wrench for a device reading.");

  using C = ClosedLoopConfig;
  bind_struct<C>(m, "ClosedLoopConfig", field("device", &C::device), field("hand", &C::hand), field("delay", &C::delay),
                 field("period", &C::period), field("dry_friction", &C::dry_friction), field("encoder", &C::encoder),
                 field("saturation", &C::saturation), field("rotation", &C::rotation),
                 field("velocity_filter", &C::velocity_filter));
  using L = ClosedLoop;
  py::class_<L>(m, "ClosedLoop", doc("ClosedLoop"))
      .def(py::init<const C&>(), py::arg("config"), doc("ClosedLoop::ClosedLoop"))
      .def("reset", &L::reset, py::arg("X_BS"), doc("ClosedLoop::reset"))
      .def("read", &L::read, py::return_value_policy::copy, doc("ClosedLoop::read"))
      .def("write", py::overload_cast<const Wrench&>(&L::write), py::arg("wrench"), doc("ClosedLoop::write(Wrench)"))
      .def("write",
           py::overload_cast<const Wrench&, const std::function<void(const Plant&, const Wrench&)>&>(&L::write),
           py::arg("wrench"), py::arg("observer"), doc("ClosedLoop::write(Wrench, function)"))
      .def("miss_tick", &L::miss_tick, py::arg("scale") = 1.0, doc("ClosedLoop::miss_tick"))
      .def(
          "tick", [](L& self, const AnyModel& model) { self.tick(calling(model)); }, py::arg("model"),
          "One tick: reads the device, calls the model, writes the wrench.")
      .def_property_readonly("plant", py::overload_cast<>(&L::plant), py::return_value_policy::reference_internal,
                             "The plant: device and hand.")
      .def_property_readonly("config", &L::config, py::return_value_policy::copy, "As passed to the constructor.")
      .def_property_readonly("applied", &L::applied, py::return_value_policy::copy, doc("ClosedLoop::applied"))
      .def_property_readonly("generated_energy", &L::generated_energy, doc("ClosedLoop::generated_energy"))
      .def_property_readonly("device_dissipation", &L::device_dissipation, doc("ClosedLoop::device_dissipation"));
}

void bind_stability(py::module_& m) {
  using S = StabilitySearch;
  bind_described<S>(m, "StabilitySearch");
  m.def(
      "is_stable",
      [](const ClosedLoopConfig& config, const AnyFactory& factory, double stiffness, const S& search) {
        const ModelFactory make = factory_from(factory);
        const ReleasedLock released;
        return is_stable(config, make, stiffness, search);
      },
      py::arg("config"), py::arg("factory"), py::arg("stiffness"), py::arg("search") = S{}, doc("is_stable"));
  m.def(
      "max_stable_stiffness",
      [](const ClosedLoopConfig& config, const AnyFactory& factory, const S& search) {
        const ModelFactory make = factory_from(factory);
        const ReleasedLock released;
        return max_stable_stiffness(config, make, search);
      },
      py::arg("config"), py::arg("factory"), py::arg("search") = S{}, doc("max_stable_stiffness"));
  using B = Bounce;
  bind_result<B>(m, "Bounce", member("restitution", &B::restitution), member("mean_restitution", &B::mean_restitution),
                 member("generated_energy", &B::generated_energy), member("penetration", &B::penetration),
                 member("peak_force", &B::peak_force));
  using T = BounceTest;
  bind_described<T>(m, "BounceTest");
  m.def(
      "measure_bounce",
      [](const ClosedLoopConfig& config, const AnyFactory& factory, double stiffness, const T& test) {
        const ModelFactory make = factory_from(factory);
        const ReleasedLock released;
        return measure_bounce(config, make, stiffness, test);
      },
      py::arg("config"), py::arg("factory"), py::arg("stiffness"), py::arg("test") = T{},
      "Measures a free flight into the material.");
  using Z = Buzz;
  bind_result<Z>(m, "Buzz", member("position_rms", &Z::position_rms), member("frequency", &Z::frequency),
                 member("force_peak_to_peak", &Z::force_peak_to_peak), member("generated_power", &Z::generated_power),
                 member("max_force", &Z::max_force))
      .def("buzzes", &Z::buzzes, doc("Buzz::buzzes"));
  using P = PressTest;
  bind_described<P>(m, "PressTest");
  m.def(
      "measure_buzz",
      [](const ClosedLoopConfig& config, const AnyFactory& factory, double stiffness, const P& test) {
        const ModelFactory make = factory_from(factory);
        const ReleasedLock released;
        return measure_buzz(config, make, stiffness, test);
      },
      py::arg("config"), py::arg("factory"), py::arg("stiffness"), py::arg("test") = P{},
      "Measures the vibration of a hand that presses steadily.");
}

void bind_pressed_ball(py::module_& m) {
  py::class_<PythonForceModel>(m, "ForceModel", "A force model of the library: maps a device reading to a wrench.")
      .def(
          "__call__", [](const PythonForceModel& self, const DeviceState& state) { return self.model(state); },
          py::arg("state"), "The wrench for a device reading.");
  py::class_<PythonModelFactory>(m, "ModelFactory",
                                 "Makes force models of a given stiffness. They run without the interpreter lock.")
      .def(
          "__call__",
          [](const PythonModelFactory& self, double stiffness) { return PythonForceModel{self.make(stiffness)}; },
          py::arg("stiffness"), "A new model.");
  using C = PressedBall;
  bind_struct<C>(m, "PressedBall", field("radius", &C::radius), field("voxel_size", &C::voxel_size),
                 field("coupling", &C::coupling));
  m.def(
      "contact_models", [](const C& ball) { return PythonModelFactory{contact_models(ball)}; }, py::arg("ball"),
      doc("contact_models"));
  m.def("pressed_search", &pressed_search, py::arg("ball"), doc("pressed_search"));
}

void bind_faults(py::module_& m) {
  bind_enum<InjectedFault>(m, "InjectedFault");
  m.def(
      "injected_faults", [] { return std::vector<InjectedFault>(injected_faults().begin(), injected_faults().end()); },
      "All faults.");
  using R = FaultResponse;
  bind_result<R>(m, "FaultResponse", member("time_to_zero", &R::time_to_zero), member("max_force", &R::max_force),
                 member("max_growth", &R::max_growth), member("oldest_force", &R::oldest_force),
                 member("end", &R::end));
  m.def(
      "measure_fault_response",
      [](const ClosedLoopConfig& config, const AnyFactory& factory, double stiffness, const GuardOptions& options,
         InjectedFault fault, double height) {
        const ModelFactory make = factory_from(factory);
        const ReleasedLock released;
        return measure_fault_response(config, make, stiffness, options, fault, height);
      },
      py::arg("config"), py::arg("factory"), py::arg("stiffness"), py::arg("options"), py::arg("fault"),
      py::arg("height") = 0.0, doc("measure_fault_response"));
  m.def("obeys_the_rules", &obeys_the_rules, py::arg("response"), py::arg("guard"), py::arg("period"),
        doc("obeys_the_rules"));
}

}  // namespace

void bind_analysis(py::module_& m) {
  bind_plant(m);
  bind_closed_loop(m);
  bind_stability(m);
  bind_pressed_ball(m);
  bind_faults(m);
}

}  // namespace hapticut::python
