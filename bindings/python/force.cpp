// SPDX-License-Identifier: Apache-2.0
// include/hapticut/force: laws, friction, stiffness and calibration
#include "bindings.hpp"
#include "hapticut/force/calibration.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/force/stiffness.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

namespace {

template <class Law>
using LawBinding = py::class_<Law, ForceLaw, std::shared_ptr<Law>>;

/// Binds a law whose constructor takes its constants.
template <class Law>
LawBinding<Law> bind_law(py::module_& m, const char* name) {
  using Constants = typename Law::Constants;
  const std::string scope = std::string(name) + "::";
  LawBinding<Law> law(m, name, py::is_final(), doc(name));
  bind_described<Constants>(law, "Constants", (scope + "Constants").c_str());
  law.def(py::init<const Constants&>(), py::arg("constants"), doc(scope + name))
      .def_property_readonly("constants", &Law::constants, py::return_value_policy::copy,
                             "As passed to the constructor.");
  pickled_by_constructor(law, {"constants"});
  return law;
}

/// Binds a law with one constant, which its constructor takes.
template <class Law>
LawBinding<Law> bind_law_of_one_number(py::module_& m, const char* name) {
  LawBinding<Law> law(m, name, py::is_final(), doc(name));
  const auto constant = std::get<0>(fields_of(Of<typename Law::Constants>{}));
  law.def(py::init<double>(), py::arg(constant.name), doc(std::string(name) + "::" + name))
      .def_property_readonly(
          constant.name, [member = constant.member](const Law& self) { return self.constants().*member; },
          detail::doc_of_described(constant, name).c_str());
  pickled_by_constructor(law, {constant.name});
  return law;
}

void bind_laws(py::module_& m) {
  bind_enum<RemovalLaw>(m, "RemovalLaw");
  py::class_<ForceLaw, std::shared_ptr<ForceLaw>>(
      m, "ForceLaw",
      "A force law: maps the samples inside the head to the force on the tool and to the remaining fraction of each "
      "voxel.\n\n"
      "It runs in the 1 kHz loop, so a custom law is a C++ class; Python selects a law and its constants.")
      .def("require_head", &ForceLaw::require_head, py::arg("head"), doc("ForceLaw::require_head"))
      .def("needs_moments", &ForceLaw::needs_moments, doc("ForceLaw::needs_moments"))
      .def("tethers_deep_ball", &ForceLaw::tethers_deep_ball, doc("ForceLaw::tethers_deep_ball"));
  using Foundation = FoundationLaw;
  LawBinding<Foundation> foundation(m, "FoundationLaw", py::is_final(), doc("FoundationLaw"));
  foundation.def(py::init<>()).def("__repr__", [](const Foundation&) { return "FoundationLaw()"; });
  pickled_by_constructor(foundation, {});

  bind_law<ThesisLaw>(m, "ThesisLaw");
  bind_law<DampingMatrixLaw>(m, "DampingMatrixLaw");
  bind_law_of_one_number<ContactMechanicsLaw>(m, "ContactMechanicsLaw")
      .def("force", &ContactMechanicsLaw::force, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::force"))
      .def("energy", &ContactMechanicsLaw::energy, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::energy"))
      .def_static("depth_of", &ContactMechanicsLaw::depth_of, py::arg("head"), py::arg("volume"),
                  doc("ContactMechanicsLaw::depth_of"));
  bind_law_of_one_number<HertzianBurrLaw>(m, "HertzianBurrLaw")
      .def("force", &HertzianBurrLaw::force, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::force"))
      .def("energy", &HertzianBurrLaw::energy, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::energy"));
  bind_law<TwistDrillLaw>(m, "TwistDrillLaw")
      .def("thrust", &TwistDrillLaw::thrust, py::arg("diameter"), py::arg("a"), py::arg("point_angle"),
           doc("TwistDrillLaw::thrust"))
      .def("torque", &TwistDrillLaw::torque, py::arg("diameter"), py::arg("a"), doc("TwistDrillLaw::torque"))
      .def_static("point_angle", &TwistDrillLaw::point_angle, py::arg("head"), doc("TwistDrillLaw::point_angle"));
}

void bind_friction(py::module_& m) {
  bind_described<DryFriction>(m, "DryFriction");
  m.def("validate", py::overload_cast<const DryFriction&>(&validate), py::arg("friction"),
        doc("validate(DryFriction)"));
}

}  // namespace

void bind_force(py::module_& m) {
  bind_laws(m);
  bind_friction(m);
  m.def("stiffness_for_head", &stiffness_for_head, py::arg("head"), doc("stiffness_for_head"));
  m.def("stiffness_for_accuracy", &stiffness_for_accuracy, py::arg("head"), py::arg("material"),
        py::arg("spindle_speed"), py::arg("feed_speed"), py::arg("cutter") = Cutter{}, doc("stiffness_for_accuracy"));
  m.def("max_contact_stiffness", &max_contact_stiffness, py::arg("head"), doc("max_contact_stiffness"));
  m.def("stiffness_for_device", &stiffness_for_device, py::arg("head"), py::arg("device_stiffness"),
        doc("stiffness_for_device"));

  bind_struct<DrillingTest>(m, "DrillingTest", required("radius", &DrillingTest::radius),
                            required("spindle_speed", &DrillingTest::spindle_speed),
                            required("feed_speed", &DrillingTest::feed_speed), field("thrust", &DrillingTest::thrust),
                            field("torque", &DrillingTest::torque), field("lips", &DrillingTest::lips));
  bind_enum<ChipTerm>(m, "ChipTerm");
  bind_struct<Calibration>(
      m, "Calibration", field("specific_cutting_energy", &Calibration::specific_cutting_energy),
      field("cutting_ratio", &Calibration::cutting_ratio), field("edge_pressure", &Calibration::edge_pressure),
      field("edge_length", &Calibration::edge_length), field("size_length", &Calibration::size_length),
      field("cutter", &Calibration::cutter), field("term", &Calibration::term),
      field("ratio_identified", &Calibration::ratio_identified),
      field("edge_identified", &Calibration::edge_identified), field("edge_assumed", &Calibration::edge_assumed),
      field("size_assumed", &Calibration::size_assumed), field("better_term", &Calibration::better_term),
      field("checked", &Calibration::checked), field("chip_identified", &Calibration::chip_identified),
      field("thrust_residual", &Calibration::thrust_residual), field("torque_residual", &Calibration::torque_residual),
      field("worst_factor", &Calibration::worst_factor), field("thinnest_chip", &Calibration::thinnest_chip));
  bind_result<AxialCutForce>(m, "AxialCutForce", member("thrust", &AxialCutForce::thrust),
                             member("torque", &AxialCutForce::torque));
  m.def("axial_cut_force", &axial_cut_force, py::arg("constants"), py::arg("radius"), py::arg("spindle_speed"),
        py::arg("feed_speed"), py::arg("lips") = 2.0, "Steady thrust and torque of a flat head fed axially (C22).");
  m.def(
      "calibrate",
      [](const std::vector<DrillingTest>& tests, std::optional<ChipTerm> term, std::optional<CutterKind> cutter) {
        return calibrate(tests, term, cutter);
      },
      py::arg("tests"), py::arg("term") = py::none(), py::arg("cutter") = py::none(), doc("calibrate"));
  m.def("advice_on", &advice_on, py::arg("constants"), doc("advice_on"));
  m.def("presets_beside", &presets_beside, py::arg("constants"), py::arg("number"), py::return_value_policy::copy,
        doc("presets_beside"));
}

}  // namespace hapticut::python
