// SPDX-License-Identifier: Apache-2.0
// include/hapticut/tool
#include "hapticut/tool/tool.hpp"

#include "bindings.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/mesh_of_revolution.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/shank.hpp"
#include "interruption.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {

template <ShapeOfHead Shape>
inline constexpr bool kNumbersAreRequired<Shape> = true;
template <>
inline constexpr bool kNumbersAreRequired<RayHandle> = true;

namespace {

void bind_shapes(py::module_& m) {
  bind_enum<FlatRule>(m, "FlatRule");
  for_each_shape([&]<class Shape>(Of<Shape>) {
    if constexpr (Described<Shape>) bind_described<Shape>(m, Shape::kName);
  });
  bind_enum<EdgeKind>(m, "EdgeKind");
  bind_struct<ProfileEdge>(m, "ProfileEdge", field("rho", &ProfileEdge::rho), field("z", &ProfileEdge::z),
                           field("radius", &ProfileEdge::radius), field("kind", &ProfileEdge::kind));
  bind_struct<Profile>(m, "Profile", field("tip", &Profile::tip), field("edges", &Profile::edges));
  using S = MeridianSpring<double>;
  py::class_<S> spring_class(m, "MeridianSpring", doc("MeridianSpring"));
  pickled_by_members(spring_class, &S::depth, &S::n_radial, &S::n_axial, &S::smooth);
  spring_class.def_readonly("depth", &S::depth, doc("MeridianSpring::depth"))
      .def_readonly("n_radial", &S::n_radial, doc("MeridianSpring::n_radial"))
      .def_readonly("n_axial", &S::n_axial, doc("MeridianSpring::n_axial"))
      .def_readonly("smooth", &S::smooth, doc("MeridianSpring::smooth"))
      .def_property_readonly("on_smooth", &S::on_smooth, "Whether the surface is smooth.")
      .def_property_readonly("scale", &S::scale, doc("MeridianSpring::scale"));
  py::class_<ProfileHead> head_class(m, "ProfileHead", doc("ProfileHead"));
  pickled_by_constructor(head_class, {"profile", "tolerance"});
  head_class
      .def(py::init<Profile, double>(), py::arg("profile"), py::arg("tolerance") = 0.01,
           doc("ProfileHead::ProfileHead"))
      .def_property_readonly("profile", &ProfileHead::profile, py::return_value_policy::copy, "The meridian.")
      .def_property_readonly("tolerance", &ProfileHead::tolerance, doc("ProfileHead::tolerance"))
      .def("exact_spring", &ProfileHead::exact_spring, py::arg("rho"), py::arg("z"), doc("ProfileHead::exact_spring"))
      .def_property_readonly("volume", &ProfileHead::volume, doc("ProfileHead::volume"))
      .def_property_readonly("reach", &ProfileHead::reach, doc("ProfileHead::reach"))
      .def_property_readonly("cutting_radius", &ProfileHead::cutting_radius, doc("ProfileHead::cutting_radius"))
      .def_property_readonly(
          "table_error", [](const ProfileHead& head) { return head.table().error; }, doc("ProfileTable::error"));
}

void bind_heads(py::module_& m) {
  bind_result<HeadBox>(m, "HeadBox", member("min", &HeadBox::min), member("max", &HeadBox::max));
  py::class_<Spring> spring_class(m, "Spring", doc("Spring"));
  pickled_by_members(spring_class, &Spring::depth, &Spring::direction, &Spring::smooth);
  spring_class.def_readonly("depth", &Spring::depth, doc("Spring::depth"))
      .def_readonly("direction", &Spring::direction, doc("Spring::direction"))
      .def_readonly("smooth", &Spring::smooth, doc("Spring::smooth"))
      .def_property_readonly("on_smooth", &Spring::on_smooth, "Whether the surface is smooth.")
      .def_property_readonly("scale", &Spring::scale, doc("Spring::scale"));
  py::class_<ToolHead> head_class(m, "ToolHead", doc("ToolHead"));
  pickled_by_constructor(head_class, {"shape"});
  head_class.def(py::init<ToolHead::Shape>(), py::arg("shape"), doc("ToolHead::ToolHead"))
      .def_property_readonly("shape", &ToolHead::shape, py::return_value_policy::copy, doc("ToolHead::shape"))
      .def("bounding_box", &ToolHead::bounding_box, doc("ToolHead::bounding_box"))
      .def("reach", &ToolHead::reach, doc("ToolHead::reach"))
      .def("volume", &ToolHead::volume, doc("ToolHead::volume"))
      .def("tip", &ToolHead::tip, doc("ToolHead::tip"))
      .def("max_radius", &ToolHead::max_radius, doc("ToolHead::max_radius"))
      .def("cutting_radius", &ToolHead::cutting_radius, doc("ToolHead::cutting_radius"))
      .def("description", &ToolHead::description, doc("ToolHead::description"))
      .def("profile", &ToolHead::profile, doc("ToolHead::profile"))
      .def("spring_at", &ToolHead::spring_at, py::arg("p_TQ"),
           "The spring at a point (3,) [m] in T: depth in the head and direction of the force.")
      .def("spring_center", &ToolHead::spring_center, py::arg("p_TQ"), doc("ToolHead::spring_center"))
      .def("__repr__",
           [](const py::object& self) { return "ToolHead(" + std::string(py::repr(self.attr("shape"))) + ")"; });

  m.def("round_head", &round_head, py::arg("diameter"), doc("round_head"));
  m.def("inverted_cone_head", &inverted_cone_head, py::arg("tip_diameter"), py::arg("neck_diameter"), py::arg("length"),
        doc("inverted_cone_head"));
  m.def("cylinder_head", &cylinder_head, py::arg("diameter"), py::arg("length"), doc("cylinder_head"));
  m.def("round_end_cylinder_head", &round_end_cylinder_head, py::arg("diameter"), py::arg("length"),
        doc("round_end_cylinder_head"));
  m.def("tapered_head", &tapered_head, py::arg("tip_diameter"), py::arg("diameter"), py::arg("length"),
        doc("tapered_head"));
  m.def("round_end_tapered_head", &round_end_tapered_head, py::arg("tip_diameter"), py::arg("diameter"),
        py::arg("length"), doc("round_end_tapered_head"));
  m.def("needle_head", &needle_head, py::arg("diameter"), py::arg("length"), doc("needle_head"));
  m.def("flame_head", &flame_head, py::arg("diameter"), py::arg("length"), py::arg("neck_diameter"),
        py::arg("widest_height"), doc("flame_head"));
  m.def("pear_head", &pear_head, py::arg("diameter"), py::arg("length"), py::arg("neck_diameter"), doc("pear_head"));
  bind_described<Shank>(m, "Shank");
  bind_enum<ShankKind>(m, "ShankKind");
  m.def("standard_shank", &standard_shank, py::arg("kind"), py::arg("neck_diameter"), doc("standard_shank"));
  m.def("on_shank", &on_shank, py::arg("head"), py::arg("shank"), doc("on_shank"));
  m.def("with_body", &with_body, py::arg("head"), py::arg("body"), doc("with_body"));
  m.def("wheel_head", &wheel_head, py::arg("diameter"), py::arg("thickness"), py::arg("shank_diameter"),
        doc("wheel_head"));
  m.def("christmas_tree_head", &christmas_tree_head, py::arg("diameter"), py::arg("length"), py::arg("tiers"),
        doc("christmas_tree_head"));
  m.def("twist_drill_head", &twist_drill_head, py::arg("diameter"), py::arg("length"),
        py::arg("point_angle") = kCommonDrillPoint, doc("twist_drill_head"));

  m.def("mesh_of_revolution", &mesh_of_revolution, py::arg("profile"), py::arg("sides"), doc("mesh_of_revolution"));
}

void bind_handles(py::module_& m) {
  bind_described<RayHandle>(m, "RayHandle");
  bind_described<LHandle>(m, "LHandle");
  bind_enum<HandleTorque>(m, "HandleTorque");
  m.def("thesis_handle_torque", &thesis_handle_torque, py::arg("handle"), py::arg("force_H"), py::arg("spindle_torque"),
        py::arg("zeta"), doc("thesis_handle_torque"));
  m.def("head_in_handle", &head_in_handle, py::arg("handle"), doc("head_in_handle"));
}

}  // namespace

void bind_tool(py::module_& m) {
  bind_shapes(m);
  bind_heads(m);
  bind_handles(m);
  m.attr("kMaxSpindleSpeed") = kMaxSpindleSpeed;
  bind_described<Spindle>(m, "Spindle").def("is_limited", &Spindle::is_limited, doc("Spindle::is_limited"));
  m.def("validate", py::overload_cast<const Spindle&>(&validate), py::arg("spindle"), doc("validate(Spindle)"));
  py::class_<SpindleMotor> motor_class(m, "SpindleMotor", doc("SpindleMotor"));
  pickled_by_bytes(motor_class);
  motor_class.def(py::init<const Spindle&>(), py::arg("spindle"))
      .def("set", &SpindleMotor::set, py::arg("setting"), doc("SpindleMotor::set"))
      .def("halt", &SpindleMotor::halt, doc("SpindleMotor::halt"))
      .def("drive", &SpindleMotor::drive, py::arg("torque"), py::arg("dt"), doc("SpindleMotor::drive"))
      .def("advance", &SpindleMotor::advance, py::arg("torque"), py::arg("dt"), doc("SpindleMotor::advance"))
      .def_property_readonly("speed", &SpindleMotor::speed, doc("SpindleMotor::speed"))
      .def_property_readonly("setting", &SpindleMotor::setting, doc("SpindleMotor::setting"))
      .def("has_reserve", &SpindleMotor::has_reserve, py::arg("torque"), doc("SpindleMotor::has_reserve"))
      .def("is_limited", &SpindleMotor::is_limited, doc("Spindle::is_limited"))
      .def_property_readonly("stall_torque", &SpindleMotor::stall_torque, doc("SpindleMotor::stall_torque"))
      .def_property_readonly("loaded", &SpindleMotor::loaded, doc("SpindleMotor::loaded"))
      .def_property_readonly("stalled", &SpindleMotor::stalled, doc("SpindleMotor::stalled"));
  bind_enum<MotorKind>(m, "MotorKind");
  m.def("common_motor", &common_motor, py::arg("speed"), doc("common_motor"));
  m.def("max_speed", &max_speed, py::arg("motor"), doc("max_speed"));
  m.def("common_spindle", py::overload_cast<MotorKind, AngularSpeed>(&common_spindle), py::arg("motor"),
        py::arg("speed"), doc("common_spindle(MotorKind, AngularSpeed)"));
  m.def("common_spindle", py::overload_cast<AngularSpeed>(&common_spindle), py::arg("speed"),
        doc("common_spindle(AngularSpeed)"));
  bind_enum<CutterKind>(m, "CutterKind");
  bind_described<Cutter>(m, "Cutter");
  m.def("validate", py::overload_cast<const Cutter&>(&validate), py::arg("cutter"), doc("validate(Cutter)"));
  m.def("lips_of", &lips_of, py::arg("cutter"), doc("lips_of"));
  m.def("usual_cutter", &usual_cutter, py::arg("head"), doc("usual_cutter"));
  m.def("tooth_rate", &tooth_rate, py::arg("cutter"), py::arg("spindle_speed"), doc("tooth_rate"));
  py::class_<Tool> tool_class(m, "Tool", doc("Tool"));
  pickled_by_constructor(tool_class, {"head", "handle", "spindle", "cutter"});
  tool_class
      .def(py::init<ToolHead, Handle, Spindle, std::optional<Cutter>>(), py::arg("head"),
           py::arg("handle") = Handle(RayHandle{0}), py::arg("spindle") = Spindle{}, py::arg("cutter") = py::none(),
           doc("Tool::Tool"))
      .def_property_readonly("head", &Tool::head, py::return_value_policy::copy, "The cutting head.")
      .def_property_readonly("handle", &Tool::handle, py::return_value_policy::copy, "RayHandle or LHandle.")
      .def_property_readonly("spindle", &Tool::spindle, py::return_value_policy::copy, "The motor.")
      .def_property_readonly("cutter", &Tool::cutter, py::return_value_policy::copy, "What the head cuts with.")
      .def_property_readonly("X_HT", &Tool::X_HT, doc("Tool::X_HT"))
      .def("__repr__", [](const py::object& self) {
        return "Tool(" + std::string(py::repr(self.attr("head"))) + ", " + std::string(py::repr(self.attr("handle"))) +
               ", " + std::string(py::repr(self.attr("spindle"))) + ", " + std::string(py::repr(self.attr("cutter"))) +
               ")";
      });
}

}  // namespace hapticut::python
