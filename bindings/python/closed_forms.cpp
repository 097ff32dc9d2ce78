// SPDX-License-Identifier: Apache-2.0
// include/hapticut/closed_forms: results of the model in closed form; numbers may be arrays
#include <pybind11/numpy.h>

#include <string>
#include <type_traits>

#include "bindings.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/tool/head.hpp"
#include "structs.hpp"
#include "tool_head.hpp"

namespace hapticut::python {
namespace {

namespace forms = closed_forms;

/// A number, or a cut as `py::vectorize` passes it on.
template <class Argument>
using Passed = std::conditional_t<std::is_arithmetic_v<Argument>, Argument, forms::SteadyCut&>;

/// A form that gives a number: its numbers may be arrays.
template <class... Given, class... Arguments>
void number_form(py::module_& m, const char* name, double (*form)(Given...), const Arguments&... arguments) {
  const std::string text = std::string(doc(name)) + "\n\nEach number may be an array of shape (n,); arrays broadcast.";
  m.def(name, py::vectorize([form](Passed<Given>... given) { return form(given...); }), arguments..., text.c_str());
}

void bind_standing_head(py::module_& m) {
  number_form(m, "cap_force", &forms::cap_force, py::arg("k_v"), py::arg("R"), py::arg("depth"));
  number_form(m, "cap_stiffness", &forms::cap_stiffness, py::arg("k_v"), py::arg("R"), py::arg("depth"));
  number_form(m, "max_cap_stiffness", &forms::max_cap_stiffness, py::arg("k_v"), py::arg("R"));
  number_form(m, "cap_energy", &forms::cap_energy, py::arg("k_v"), py::arg("R"), py::arg("depth"));
  number_form(m, "cone_force", &forms::cone_force, py::arg("k_v"), py::arg("half_angle"), py::arg("depth"));
  number_form(m, "flat_bottom_force", &forms::flat_bottom_force, py::arg("k_v"), py::arg("R"), py::arg("depth"));
  number_form(m, "flat_nearest_force", &forms::flat_nearest_force, py::arg("k_v"), py::arg("R"), py::arg("depth"));
  number_form(m, "side_wall_force", &forms::side_wall_force, py::arg("k_v"), py::arg("R"), py::arg("depth"),
              py::arg("height"));
  number_form(m, "side_wall_torque", &forms::side_wall_torque, py::arg("k_v"), py::arg("R"), py::arg("depth"),
              py::arg("z0"), py::arg("z1"), py::arg("z_r"));
  number_form(m, "disk_area_before", &forms::disk_area_before, py::arg("R"), py::arg("x0"));
  number_form(m, "edge_force", &forms::edge_force, py::arg("k_v"), py::arg("R"), py::arg("depth"), py::arg("x0"));
  number_form(m, "edge_torque", &forms::edge_torque, py::arg("k_v"), py::arg("R"), py::arg("depth"), py::arg("x0"));
  number_form(m, "layered_cap_force", &forms::layered_cap_force, py::arg("k1"), py::arg("k2"), py::arg("thickness"),
              py::arg("R"), py::arg("depth"));
  number_form(m, "surface_pressure", &forms::surface_pressure, py::arg("k_v"), py::arg("w"));
  number_form(m, "ball_damping_force", &forms::ball_damping_force, py::arg("k_v"), py::arg("chi"), py::arg("R"),
              py::arg("depth"), py::arg("speed"));
  number_form(m, "flat_bottom_crushing_force", &forms::flat_bottom_crushing_force, py::arg("strength"),
              py::arg("radius"));
  number_form(m, "cap_crushing_force", &forms::cap_crushing_force, py::arg("strength"), py::arg("crushing_depth"),
              py::arg("radius"), py::arg("depth"));
  number_form(m, "pushed_pin_force", &forms::pushed_pin_force, py::arg("k_v"), py::arg("radius"), py::arg("length"),
              py::arg("push"));
  number_form(m, "drag_work", &forms::drag_work, py::arg("mu_s"), py::arg("mu_d"), py::arg("k_t"), py::arg("normal"),
              py::arg("length"));
  number_form(m, "drag_peak", &forms::drag_peak, py::arg("mu_s"), py::arg("normal"));
  number_form(m, "drag_plateau", &forms::drag_plateau, py::arg("mu_d"), py::arg("normal"));
  number_form(m, "growth_time", &forms::growth_time, py::arg("difference"), py::arg("rate"));
}

void bind_steady_cut(py::module_& m) {
  number_form(m, "axial_cutting_force_of_a_flat_head", &forms::axial_cutting_force_of_a_flat_head, py::arg("cut"),
              py::arg("R"));
  number_form(m, "axial_cutting_torque_of_a_flat_head", &forms::axial_cutting_torque_of_a_flat_head, py::arg("cut"),
              py::arg("R"));
  number_form(m, "axial_cutting_force_with_elastic_release", &forms::axial_cutting_force_with_elastic_release,
              py::arg("cut"), py::arg("R"));
  number_form(m, "feed_of_a_flat_head_under", &forms::feed_of_a_flat_head_under, py::arg("force"), py::arg("cut"),
              py::arg("R"));
  m.def("side_milling_wrench", &forms::side_milling_wrench, py::arg("cut"), py::arg("R"), py::arg("height"),
        py::arg("from_"), py::arg("to"), doc("side_milling_wrench"));
  m.def("slotting_wrench", &forms::slotting_wrench, py::arg("cut"), py::arg("R"), py::arg("height"),
        doc("slotting_wrench"));
  m.def("groove_wrench", &forms::groove_wrench, py::arg("cut"), py::arg("R"), py::arg("depth"), doc("groove_wrench"));
  m.def("buried_ball_wrench", &forms::buried_ball_wrench, py::arg("cut"), py::arg("R"), doc("buried_ball_wrench"));
  m.def("ball_plunge_wrench", &forms::ball_plunge_wrench, py::arg("cut"), py::arg("R"), py::arg("depth"),
        doc("ball_plunge_wrench"));
  m.def("cone_plunge_wrench", &forms::cone_plunge_wrench, py::arg("cut"), py::arg("half_angle"), py::arg("depth"),
        doc("cone_plunge_wrench"));
  m.def("axial_chip_wrench", &forms::axial_chip_wrench, py::arg("cut"), py::arg("R"), doc("axial_chip_wrench"));
  number_form(m, "feed_with_chips_under", &forms::feed_with_chips_under, py::arg("force"), py::arg("cut"),
              py::arg("R"));
  m.def("slotting_chip_wrench", &forms::slotting_chip_wrench, py::arg("cut"), py::arg("R"), py::arg("height"),
        doc("slotting_chip_wrench"));
  m.def("ball_plunge_chip_wrench", &forms::ball_plunge_chip_wrench, py::arg("cut"), py::arg("R"),
        doc("ball_plunge_chip_wrench"));
  m.def("groove_chip_wrench", &forms::groove_chip_wrench, py::arg("cut"), py::arg("R"), py::arg("depth"),
        doc("groove_chip_wrench"));
  number_form(m, "cutting_power", &forms::cutting_power, py::arg("cut"), py::arg("volume_rate"));
  m.def("twist_drill_wrench", &forms::twist_drill_wrench, py::arg("cut"), py::arg("diameter"), py::arg("point_angle"),
        doc("twist_drill_wrench"));
  number_form(m, "torque_over_thrust_of_chips", &forms::torque_over_thrust_of_chips, py::arg("kappa"), py::arg("R"));
  number_form(m, "torque_over_thrust_of_edges", &forms::torque_over_thrust_of_edges, py::arg("kappa"), py::arg("R"));
  number_form(m, "step_volume_of_a_flat_head", &forms::step_volume_of_a_flat_head, py::arg("R"), py::arg("step"));
  number_form(m, "step_volume_of_a_cone", &forms::step_volume_of_a_cone, py::arg("half_angle"), py::arg("depth"),
              py::arg("step"));
  number_form(m, "step_volume_of_a_ball", &forms::step_volume_of_a_ball, py::arg("R"), py::arg("depth"),
              py::arg("step"));
  number_form(m, "step_force_of_a_flat_head", &forms::step_force_of_a_flat_head, py::arg("k_v"), py::arg("R"),
              py::arg("step"));
  number_form(m, "step_force_of_a_cone", &forms::step_force_of_a_cone, py::arg("k_v"), py::arg("half_angle"),
              py::arg("depth"), py::arg("step"), py::arg("removal_depth") = 0);
  number_form(m, "step_force_of_a_ball", &forms::step_force_of_a_ball, py::arg("k_v"), py::arg("R"), py::arg("depth"),
              py::arg("step"), py::arg("removal_depth") = 0);
  number_form(m, "engaged_layer", &forms::engaged_layer, py::arg("cut"), py::arg("k_v"), py::arg("rho"));
  number_form(m, "stiffness_for_layer", &forms::stiffness_for_layer, py::arg("cut"), py::arg("layer"), py::arg("rho"));
  number_form(m, "engaged_volume_under_a_flat_head", &forms::engaged_volume_under_a_flat_head, py::arg("R"),
              py::arg("layer"));
  number_form(m, "decaying_volume_under_a_flat_head", &forms::decaying_volume_under_a_flat_head, py::arg("R"),
              py::arg("layer"));
  number_form(m, "wall_left_by_a_pass", &forms::wall_left_by_a_pass, py::arg("cut"), py::arg("k_v"), py::arg("rho"),
              py::arg("curvature"));
  number_form(m, "grain_variation", &forms::grain_variation, py::arg("grain"), py::arg("grain_length"),
              py::arg("area"));
  number_form(m, "cutting_area_of_a_slot", &forms::cutting_area_of_a_slot, py::arg("R"), py::arg("H"));
  number_form(m, "tooth_passing_variation", &forms::tooth_passing_variation, py::arg("once_per_turn"),
              py::arg("per_tooth"));
}

void bind_other_laws(py::module_& m) {
  number_form(m, "flat_punch_force", &forms::flat_punch_force, py::arg("modulus"), py::arg("R"), py::arg("depth"));
  number_form(m, "ball_punch_force", &forms::ball_punch_force, py::arg("modulus"), py::arg("R"), py::arg("depth"));
  number_form(m, "cone_punch_force", &forms::cone_punch_force, py::arg("modulus"), py::arg("half_angle"),
              py::arg("depth"));
  number_form(m, "hertzian_burr_force", &forms::hertzian_burr_force, py::arg("stiffness"), py::arg("R"),
              py::arg("depth"));
  number_form(m, "drooped_speed", &forms::drooped_speed, py::arg("setting"), py::arg("droop"), py::arg("power"));
}

/// C11 for any head.
Wrench wrench_on_plane(double k_v, const ToolHead& head, const Pose& X_WT, const Vec3& normal, double offset,
                       int points) {
  const HeadBox box = head.bounding_box();
  const Vec3 middle(0, 0, 0.5 * (box.min.z() + box.max.z()));
  const double reach = 0.5 * (box.max - box.min).norm();
  const auto depth_of = [&](double rho, double z) { return head.spring_at({rho, 0, z}).depth; };
  return forms::wrench_on_plane(k_v, depth_of, X_WT, {normal, offset}, middle, reach, points);
}

}  // namespace

void bind_closed_forms(py::module_& m) {
  using Cut = forms::SteadyCut;
  bind_struct<Cut>(m, "SteadyCut", "SteadyCut", required("specific_cutting_energy", &Cut::specific_cutting_energy),
                   required("cutting_ratio", &Cut::cutting_ratio), required("spin", &Cut::spin),
                   required("feed_speed", &Cut::feed_speed), field("edge_pressure", &Cut::edge_pressure),
                   field("tooth_rate", &Cut::tooth_rate), field("edge_length", &Cut::edge_length),
                   field("size_length", &Cut::size_length));
  bind_standing_head(m);
  bind_steady_cut(m);
  bind_other_laws(m);
  m.def("wrench_on_plane", &wrench_on_plane, py::arg("k_v"), py::arg("head"), py::arg("X_WT"),
        py::arg("normal") = Vec3(0, 0, 1), py::arg("offset") = 0.0, py::arg("points") = 200,
        "C11: force and torque about To of a standing head at the pose X_WT, of shape (4, 4), in the half space that "
        "`normal . p < offset` fills, with a normal of shape (3,), by the pressure identity on its surface.");
}

}  // namespace hapticut::python
