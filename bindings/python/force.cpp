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

void bind_laws(py::module_& m) {
  bind_enum<RemovalLaw>(m, "RemovalLaw");
  py::class_<ForceLaw, std::shared_ptr<ForceLaw>>(
      m, "ForceLaw",
      "A force law: maps the samples inside the head to the force on the tool and to the remaining fraction of each "
      "voxel.\n\n"
      "It runs in the 1 kHz loop, so a custom law is a C++ class; Python selects a law and its constants.")
      .def("require_head", &ForceLaw::require_head, py::arg("head"), doc("ForceLaw::require_head"))
      .def("needs_moments", &ForceLaw::needs_moments, doc("ForceLaw::needs_moments"))
      .def("holds_deep_contact", &ForceLaw::holds_deep_contact, doc("ForceLaw::holds_deep_contact"));
  using Foundation = FoundationLaw;
  LawBinding<Foundation> foundation(m, "FoundationLaw", py::is_final(), doc("FoundationLaw"));
  foundation.def(py::init<>()).def("__repr__", [](const Foundation&) { return "FoundationLaw()"; });
  pickled_by_constructor(foundation, {});

  LawBinding<ThesisLaw> thesis(m, "ThesisLaw", py::is_final(), doc("ThesisLaw"));
  using Thesis = ThesisLaw::Constants;
  bind_struct<Thesis>(thesis, "Constants", "ThesisLaw::Constants",
                      field("reference_voxel_size", &Thesis::reference_voxel_size), field("damping", &Thesis::damping),
                      field("spin_torque", &Thesis::spin_torque), field("spin_exponent", &Thesis::spin_exponent),
                      field("cutting_force", &Thesis::cutting_force), field("cutting_speed", &Thesis::cutting_speed));
  thesis.def(py::init<const Thesis&>(), py::arg("constants"), doc("ThesisLaw::ThesisLaw"))
      .def_property_readonly("constants", &ThesisLaw::constants, py::return_value_policy::copy,
                             "As passed to the constructor.");
  pickled_by_constructor(thesis, {"constants"});

  LawBinding<ContactMechanicsLaw> mechanics(m, "ContactMechanicsLaw", py::is_final(), doc("ContactMechanicsLaw"));
  pickled_by_constructor(mechanics, {"effective_modulus"});
  mechanics.def(py::init<double>(), py::arg("effective_modulus"), doc("ContactMechanicsLaw::ContactMechanicsLaw"))
      .def_property_readonly("effective_modulus", &ContactMechanicsLaw::effective_modulus,
                             doc("ContactMechanicsLaw::effective_modulus"))
      .def("force", &ContactMechanicsLaw::force, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::force"))
      .def("energy", &ContactMechanicsLaw::energy, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::energy"))
      .def_static("depth_of", &ContactMechanicsLaw::depth_of, py::arg("head"), py::arg("volume"),
                  doc("ContactMechanicsLaw::depth_of"));

  LawBinding<HertzianBurrLaw> burr(m, "HertzianBurrLaw", py::is_final(), doc("HertzianBurrLaw"));
  pickled_by_constructor(burr, {"stiffness"});
  burr.def(py::init<double>(), py::arg("stiffness"), doc("HertzianBurrLaw::HertzianBurrLaw"))
      .def_property_readonly("stiffness", &HertzianBurrLaw::stiffness, doc("HertzianBurrLaw::stiffness"))
      .def("force", &HertzianBurrLaw::force, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::force"))
      .def("energy", &HertzianBurrLaw::energy, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::energy"));

  LawBinding<DampingMatrixLaw> damping(m, "DampingMatrixLaw", py::is_final(), doc("DampingMatrixLaw"));
  using Damping = DampingMatrixLaw::Constants;
  bind_struct<Damping>(damping, "Constants", "DampingMatrixLaw::Constants", field("resistance", &Damping::resistance),
                       field("friction", &Damping::friction));
  damping.def(py::init<const Damping&>(), py::arg("constants"), doc("DampingMatrixLaw::DampingMatrixLaw"))
      .def_property_readonly("constants", &DampingMatrixLaw::constants, py::return_value_policy::copy,
                             "As passed to the constructor.");
  pickled_by_constructor(damping, {"constants"});

  LawBinding<TwistDrillLaw> drill(m, "TwistDrillLaw", py::is_final(), doc("TwistDrillLaw"));
  using Drill = TwistDrillLaw::Constants;
  bind_struct<Drill>(drill, "Constants", "TwistDrillLaw::Constants", field("specific_energy", &Drill::specific_energy),
                     field("max_feed_per_revolution", &Drill::max_feed_per_revolution));
  pickled_by_constructor(drill, {"constants"});
  drill.def(py::init<const Drill&>(), py::arg("constants"), doc("TwistDrillLaw::TwistDrillLaw"))
      .def_property_readonly("constants", &TwistDrillLaw::constants, py::return_value_policy::copy,
                             "As passed to the constructor.")
      .def("thrust", &TwistDrillLaw::thrust, py::arg("diameter"), py::arg("a"), py::arg("point_angle"),
           doc("TwistDrillLaw::thrust"))
      .def("torque", &TwistDrillLaw::torque, py::arg("diameter"), py::arg("a"), doc("TwistDrillLaw::torque"))
      .def_static("point_angle", &TwistDrillLaw::point_angle, py::arg("head"), doc("TwistDrillLaw::point_angle"));
}

void bind_friction(py::module_& m) {
  bind_described<DryFriction>(m, "DryFriction");
  m.def("validate", py::overload_cast<const DryFriction&>(&validate), py::arg("friction"), doc("validate"));
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
      field("ratio_identified", &Calibration::ratio_identified),
      field("edge_identified", &Calibration::edge_identified), field("edge_assumed", &Calibration::edge_assumed),
      field("checked", &Calibration::checked), field("chip_identified", &Calibration::chip_identified),
      field("thrust_residual", &Calibration::thrust_residual), field("torque_residual", &Calibration::torque_residual));
  bind_result<AxialCutForce>(m, "AxialCutForce", member("thrust", &AxialCutForce::thrust),
                             member("torque", &AxialCutForce::torque));
  m.def("axial_cut_force", &axial_cut_force, py::arg("constants"), py::arg("radius"), py::arg("spindle_speed"),
        py::arg("feed_speed"), py::arg("lips") = 2.0, "Steady thrust and torque of a flat head fed axially (C22).");
  m.def(
      "calibrate", [](const std::vector<DrillingTest>& tests, ChipTerm term) { return calibrate(tests, term); },
      py::arg("tests"), py::arg("term") = ChipTerm::edge_length, doc("calibrate"));
}

}  // namespace hapticut::python
