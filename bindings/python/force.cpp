// SPDX-License-Identifier: Apache-2.0
// include/hapticut/force: laws, friction, stiffness and calibration
#include "bindings.hpp"
#include "hapticut/force/calibration.hpp"
#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/force/limit_surface.hpp"
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
      "A force law: from the samples inside the head to the force on the tool and to what is left of each voxel.\n\n"
      "It works in the 1 kHz loop, so a law of your own is a class in C++; Python chooses one and its constants.")
      .def("require_head", &ForceLaw::require_head, py::arg("head"), doc("ForceLaw::require_head"))
      .def("needs_moments", &ForceLaw::needs_moments, doc("ForceLaw::needs_moments"))
      .def("holds_deep_contact", &ForceLaw::holds_deep_contact, doc("ForceLaw::holds_deep_contact"));
  using Foundation = FoundationLaw;
  LawBinding<Foundation>(m, "FoundationLaw", doc("FoundationLaw"))
      .def(py::init<>())
      .def("__repr__", [](const Foundation&) { return "FoundationLaw()"; })
      .def("__reduce__", [](const py::object& self) { return py::make_tuple(py::type::of(self), py::tuple()); })
      .def_readonly_static("kSlipRegularization", &Foundation::kSlipRegularization,
                           doc("FoundationLaw::kSlipRegularization"))
      .def_readonly_static("kLargestExponent", &Foundation::kLargestExponent, doc("FoundationLaw::kLargestExponent"))
      .def_readonly_static("kLeastEnergyShare", &Foundation::kLeastEnergyShare, doc("FoundationLaw::kLeastEnergyShare"))
      .def_readonly_static("kSmallestPart", &Foundation::kSmallestPart, doc("FoundationLaw::kSmallestPart"))
      .def_readonly_static("kSmallestLoss", &Foundation::kSmallestLoss, doc("FoundationLaw::kSmallestLoss"))
      .def_readonly_static("kAxisZone", &Foundation::kAxisZone, doc("FoundationLaw::kAxisZone"))
      .def_readonly_static("kAxisSlip", &Foundation::kAxisSlip, doc("FoundationLaw::kAxisSlip"));
  m.attr("kSmallestFill") = kSmallestFill;

  LawBinding<ThesisLaw> thesis(m, "ThesisLaw", doc("ThesisLaw"));
  using Thesis = ThesisLaw::Constants;
  bind_struct<Thesis>(thesis, "Constants", "ThesisLaw::Constants",
                      field("reference_voxel_size", &Thesis::reference_voxel_size), field("damping", &Thesis::damping),
                      field("spin_torque", &Thesis::spin_torque), field("spin_exponent", &Thesis::spin_exponent),
                      field("required_power", &Thesis::required_power));
  thesis.def(py::init<const Thesis&>(), py::arg("constants"), doc("ThesisLaw::ThesisLaw"))
      .def_property_readonly("constants", &ThesisLaw::constants, py::return_value_policy::copy, "As given.");

  LawBinding<ContactMechanicsLaw>(m, "ContactMechanicsLaw", doc("ContactMechanicsLaw"))
      .def(py::init<double>(), py::arg("effective_modulus"), doc("ContactMechanicsLaw::ContactMechanicsLaw"))
      .def("force", &ContactMechanicsLaw::force, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::force"))
      .def("energy", &ContactMechanicsLaw::energy, py::arg("head"), py::arg("d"), doc("ContactMechanicsLaw::energy"))
      .def_static("depth_of", &ContactMechanicsLaw::depth_of, py::arg("head"), py::arg("volume"),
                  doc("ContactMechanicsLaw::depth_of"));

  LawBinding<HertzianBurrLaw>(m, "HertzianBurrLaw", doc("HertzianBurrLaw"))
      .def(py::init<double>(), py::arg("stiffness"), doc("HertzianBurrLaw::HertzianBurrLaw"))
      .def("force", &HertzianBurrLaw::force, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::force"))
      .def("energy", &HertzianBurrLaw::energy, py::arg("R"), py::arg("h"), doc("HertzianBurrLaw::energy"));

  LawBinding<DampingMatrixLaw> damping(m, "DampingMatrixLaw", doc("DampingMatrixLaw"));
  using Damping = DampingMatrixLaw::Constants;
  bind_struct<Damping>(damping, "Constants", "DampingMatrixLaw::Constants", field("resistance", &Damping::resistance),
                       field("friction", &Damping::friction));
  damping.def(py::init<const Damping&>(), py::arg("constants"), doc("DampingMatrixLaw::DampingMatrixLaw"));

  LawBinding<TwistDrillLaw> drill(m, "TwistDrillLaw", doc("TwistDrillLaw"));
  using Drill = TwistDrillLaw::Constants;
  bind_struct<Drill>(drill, "Constants", "TwistDrillLaw::Constants", field("specific_energy", &Drill::specific_energy),
                     field("largest_feed_per_turn", &Drill::largest_feed_per_turn));
  drill.def(py::init<const Drill&>(), py::arg("constants"), doc("TwistDrillLaw::TwistDrillLaw"))
      .def("thrust", &TwistDrillLaw::thrust, py::arg("diameter"), py::arg("a"), py::arg("point_angle"),
           doc("TwistDrillLaw::thrust"))
      .def("torque", &TwistDrillLaw::torque, py::arg("diameter"), py::arg("a"), doc("TwistDrillLaw::torque"))
      .def_static("point_angle", &TwistDrillLaw::point_angle, py::arg("head"), doc("TwistDrillLaw::point_angle"));
}

void bind_friction(py::module_& m) {
  bind_described<DryFriction>(m, "DryFriction");
  m.def("validate", py::overload_cast<const DryFriction&>(&validate), py::arg("friction"), doc("validate"));
  m.attr("kFullSpinSpeed") = kFullSpinSpeed;
  m.def("standing_share", &standing_share, py::arg("spin"), py::arg("radius"), doc("standing_share"));

  py::class_<SpreadFriction>(m, "SpreadFriction", doc("SpreadFriction"))
      .def(py::init<>())
      .def(
          "add",
          [](SpreadFriction& self, const Vec3& r, const Vec3& n, double normal, const DryFriction& friction,
             double spring) { self.add(r, n, normal, friction, spring); },
          py::arg("r"), py::arg("n"), py::arg("normal"), py::arg("friction"), py::arg("spring") = 0.0,
          doc("SpreadFriction::add"))
      .def_static("at_point", &SpreadFriction::at_point, py::arg("normal_force"), py::arg("friction"),
                  py::arg("spring") = 0.0, doc("SpreadFriction::at_point"))
      .def_readonly("directions", &SpreadFriction::directions, doc("SpreadFriction::directions"))
      .def_readonly("static_limit", &SpreadFriction::static_limit, doc("SpreadFriction::static_limit"))
      .def_readonly("dynamic_limit", &SpreadFriction::dynamic_limit, doc("SpreadFriction::dynamic_limit"))
      .def_readonly("anchors", &SpreadFriction::anchors, doc("SpreadFriction::anchors"))
      .def_readonly("springs", &SpreadFriction::springs, doc("SpreadFriction::springs"))
      .def_property_readonly("stiffness", &SpreadFriction::stiffness, doc("SpreadFriction::stiffness"));

  py::class_<LimitSurface> limit_surface(m, "LimitSurface", doc("LimitSurface"));
  py::class_<LimitSurface::Outcome>(limit_surface, "Outcome", "What a motion of the tool gave.")
      .def_readonly("wrench", &LimitSurface::Outcome::wrench, doc("LimitSurface::Outcome::wrench"))
      .def_readonly("dissipated", &LimitSurface::Outcome::dissipated, doc("LimitSurface::Outcome::dissipated"))
      .def_readonly("stiffness", &LimitSurface::Outcome::stiffness, doc("LimitSurface::Outcome::stiffness"));
  limit_surface.def(py::init<>())
      .def(
          "move",
          [](LimitSurface& self, const SpreadFriction& contact, const Twist& displacement, double share, double lead) {
            return self.move(contact, displacement, share, lead);
          },
          py::arg("contact"), py::arg("displacement"), py::arg("share") = 1.0, py::arg("lead") = 0.0,
          doc("LimitSurface::move"))
      .def_property_readonly("stored", &LimitSurface::stored, doc("LimitSurface::stored"))
      .def_property_readonly("anchored", &LimitSurface::anchored, doc("LimitSurface::anchored"))
      .def_property_readonly("sliding", &LimitSurface::sliding, "It slides.")
      .def_property_readonly("stiffness", &LimitSurface::stiffness, doc("LimitSurface::stiffness"))
      .def("release", &LimitSurface::release, doc("LimitSurface::release"));

  py::class_<DeepContact> deep(m, "DeepContact", doc("DeepContact"));
  using Outcome = DeepContact::Outcome;
  py::class_<Outcome>(deep, "Outcome", "What a motion of the ball gave.")
      .def_readonly("force", &Outcome::force, doc("DeepContact::Outcome::force"))
      .def_readonly("stored_before", &Outcome::stored_before, doc("DeepContact::Outcome::stored_before"))
      .def_readonly("stored", &Outcome::stored, doc("DeepContact::Outcome::stored"))
      .def_readonly("released", &Outcome::released, doc("DeepContact::Outcome::released"));
  deep.def(py::init<>())
      .def("move", &DeepContact::move, py::arg("start"), py::arg("to"), py::arg("filled"), py::arg("normal_force"),
           py::arg("radius"), doc("DeepContact::move"))
      .def_readonly_static("kDeep", &DeepContact::kDeep, doc("DeepContact::kDeep"))
      .def_readonly_static("kFree", &DeepContact::kFree, doc("DeepContact::kFree"))
      .def("wants_normal_force", &DeepContact::wants_normal_force, py::arg("filled"),
           doc("DeepContact::wants_normal_force"))
      .def_property_readonly("held", &DeepContact::held, doc("DeepContact::held"))
      .def_property_readonly("stiffness", &DeepContact::stiffness, doc("DeepContact::stiffness"))
      .def_property_readonly(
          "normal", [](const DeepContact& d) { return d.normal(); }, doc("DeepContact::normal"))
      .def_property_readonly("stored", &DeepContact::stored, doc("DeepContact::stored"))
      .def("release", &DeepContact::release, "Lets go.");
}

}  // namespace

void bind_force(py::module_& m) {
  bind_laws(m);
  bind_friction(m);
  m.def("stiffness_for_accuracy", &stiffness_for_accuracy, py::arg("head"), py::arg("material"),
        py::arg("spindle_speed"), py::arg("feed_speed"), py::arg("cutter") = Cutter{}, doc("stiffness_for_accuracy"));
  m.def("largest_contact_stiffness", &largest_contact_stiffness, py::arg("head"), doc("largest_contact_stiffness"));
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
