// SPDX-License-Identifier: Apache-2.0
// include/hapticut/force/effects, include/hapticut/simulation/output.hpp
#include "bindings.hpp"
#include "hapticut/simulation/output.hpp"
#include "structs.hpp"

namespace hapticut::python {

void bind_effects(py::module_& m) {
  bind_described<Gravity>(m, "Gravity");
  bind_described<Vibration>(m, "Vibration");
  bind_described<ToothPassing>(m, "ToothPassing");
  bind_described<DeltaFilter>(m, "DeltaFilter");
  bind_described<AxisMask>(m, "AxisMask");
  bind_described<OutputLimits>(m, "OutputLimits");
  bind_described<Effects>(m, "Effects");
  m.def("validate", py::overload_cast<const Gravity&>(&validate), py::arg("gravity"), doc("validate(Gravity)"));
  m.def("validate", py::overload_cast<const ToothPassing&>(&validate), py::arg("teeth"), doc("validate(ToothPassing)"));
  m.def("validate", py::overload_cast<const DeltaFilter&>(&validate), py::arg("filter"), doc("validate(DeltaFilter)"));
  m.def("validate", py::overload_cast<const OutputLimits&>(&validate), py::arg("limits"),
        doc("validate(OutputLimits)"));
  m.def("validate", py::overload_cast<const Vibration&, double>(&validate), py::arg("vibration"),
        py::arg("update_rate"), doc("validate(Vibration, double)"));
  m.def("validate", py::overload_cast<const Effects&, double>(&validate), py::arg("effects"), py::arg("update_rate"),
        doc("validate(Effects, double)"));

  py::class_<VibrationPhase> phase_class(m, "VibrationPhase", doc("VibrationPhase"));
  pickled_by_bytes(phase_class);
  phase_class.def(py::init<>())
      .def("advance", &VibrationPhase::advance, py::arg("vibration"), py::arg("touching"), py::arg("power"),
           py::arg("dt"), doc("VibrationPhase::advance"));
  py::class_<CutterAngle> angle_class(m, "CutterAngle", doc("CutterAngle"));
  pickled_by_bytes(angle_class);
  angle_class.def(py::init<>())
      .def("advance", &CutterAngle::advance, py::arg("teeth"), py::arg("turn"), py::arg("lips"),
           doc("CutterAngle::advance"));
  m.def("gravity_wrench", &gravity_wrench, py::arg("gravity"), py::arg("R_WH"), doc("gravity_wrench"));
  m.def("masked", &masked, py::arg("mask"), py::arg("wrench"), doc("masked"));
  m.def("filtered", &filtered, py::arg("filter"), py::arg("previous"), py::arg("calculated"), doc("filtered"));
  m.def("min_force_growth", &min_force_growth, py::arg("stiffness"), py::arg("speed"), doc("min_force_growth"));
  m.def("saturated", &saturated, py::arg("v"), py::arg("longest"), doc("saturated"));
  m.def("growth_limited", &growth_limited, py::arg("previous"), py::arg("target"), py::arg("max_growth"),
        doc("growth_limited"));

  bind_struct<EffectsInput>(m, "EffectsInput", field("X_WH", &EffectsInput::X_WH), field("X_WT", &EffectsInput::X_WT),
                            field("touching", &EffectsInput::touching), field("power", &EffectsInput::power),
                            field("dt", &EffectsInput::dt), field("lever", &EffectsInput::lever),
                            field("turn", &EffectsInput::turn), field("lips", &EffectsInput::lips));
  py::class_<Output>(m, "Output", doc("Output"))
      .def(py::init<>())
      .def("give", &Output::give, py::arg("effects"), py::arg("at"), py::arg("wrench"), py::return_value_policy::copy,
           doc("Output::give"))
      .def_property_readonly("given", &Output::given, py::return_value_policy::copy, doc("Output::given"))
      .def("drop", &Output::drop, doc("Output::drop"))
      .def("restart", &Output::restart, doc("Output::restart"));
}

}  // namespace hapticut::python
