// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/closed_forms/standing_head.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

/// @file
/// C20 ... C38, C42 and C43: forces and torques of a spinning head in a steady cut, and the figures of the thesis.
namespace hapticut::closed_forms {

// --- steady cutting --------------------------------------------------------------------------------------------------

/// A cut in steady state.
struct SteadyCut {
  double specific_cutting_energy;  ///< [J/m^3] u
  double cutting_ratio;            ///< [1] kappa > 0
  double spin;                     ///< [rad/s] omega > 0, about +z
  double feed_speed;               ///< [m/s] v_f > 0
  double edge_pressure = 0;        ///< [Pa] p_e, used by C22 and C23 only

  double tooth_rate = 0;   ///< [1/s] f_z, used by C35 ... C38 and C42 only
  double edge_length = 0;  ///< [m] h_e, used by C35 ... C38 and C42 only
  double size_length = 0;  ///< [m] h_s, used by C35 ... C38 and C42 only
  double viscosity = 0;    ///< [Pa s/m] eta, used by C22 and C23 only

  /// [m/s] `sqrt(h_s f_z v_f)`: additional feed speed with the cost of thin chips.
  [[nodiscard]] double size_speed() const { return std::sqrt(size_length * tooth_rate * feed_speed); }
  /// [m/s] `h_e f_z`: additional feed speed with the cost of the edges.
  [[nodiscard]] double edge_speed() const { return edge_length * tooth_rate; }

  /// [Pa] `p_e + eta v_f`: pressure on a flat head that cuts nothing.
  [[nodiscard]] double idle_pressure() const { return edge_pressure + viscosity * feed_speed; }

  /// [N/m] u v_f/omega: torque per area, and force per length across the feed.
  [[nodiscard]] double chip() const { return specific_cutting_energy * feed_speed / spin; }
};

/// C20 and, with an edge pressure, C22: thrust of a flat head fed axially, rule bottom_only,
/// `F_z = pi R^2 p_e + 2 pi R u v_f/(kappa omega)`; with a viscosity p_e + eta v_f in place of p_e.
/// @return [N]
[[nodiscard]] inline double axial_cutting_force_of_a_flat_head(const SteadyCut& cut, double R) {
  return units::kPi * R * R * cut.idle_pressure() + 2 * units::kPi * R * cut.chip() / cut.cutting_ratio;
}

/// C20 and, with an edge pressure, C22: torque of a flat head fed axially, `T_z = -[(2 pi/3) kappa p_e R^3 + u pi R^2
/// v_f/omega]`; with a viscosity p_e + eta v_f in place of p_e.
/// @return [N·m]
[[nodiscard]] inline double axial_cutting_torque_of_a_flat_head(const SteadyCut& cut, double R) {
  return -(2 * units::kPi / 3 * cut.cutting_ratio * cut.idle_pressure() * R * R * R + units::kPi * R * R * cut.chip());
}

/// C21: the thrust of C20 under law G, where elastic energy helps to cut,
/// `F_z = (2 pi u v_f/(kappa omega)) [R - (v_f/(kappa omega)) ln(1 + kappa omega R/v_f)]`. Thrust and torque
/// still pay for the volume: `|T_z| omega + F_z v_f = u pi R^2 v_f` (C30).
/// @return [N]
[[nodiscard]] inline double axial_cutting_force_with_elastic_release(const SteadyCut& cut, double R) {
  const double length = cut.feed_speed / (cut.cutting_ratio * cut.spin);
  return 2 * units::kPi * cut.chip() / cut.cutting_ratio * (R - length * std::log1p(R / length));
}

/// C23: feed of a flat head under a constant force of the hand, `kappa omega (F - pi R^2 p_e)/(2 pi R u)`; 0 if the
/// edges carry the whole force; with a viscosity the denominator has kappa omega pi R^2 eta more.
/// `SteadyCut::feed_speed` is not used.
/// @param force  [N]
/// @return [m/s]
[[nodiscard]] inline double feed_of_a_flat_head_under(double force, const SteadyCut& cut, double R) {
  const double on_chips = force - units::kPi * R * R * cut.edge_pressure;
  const double per_speed = 2 * units::kPi * R * cut.specific_cutting_energy +
                           cut.cutting_ratio * cut.spin * units::kPi * R * R * cut.viscosity;  // [J/m^2]
  return std::max(0.0, cut.cutting_ratio * cut.spin * on_chips / per_speed);
}

/// C25: wrench on a cylinder fed along +x that cuts with its side between two angles, over a height h; with
/// U = u v_f h/omega
///
///     F_x = -(U/kappa) Int cos^2 + U Int sin cos,   F_y = -(U/kappa) Int sin cos - U Int cos^2,   T_z = -U R Int cos
///
/// @param from, to  [rad] from the feed towards +y, within -pi/2 ... pi/2
/// @param height    [m] h
/// @return about the axis, at half the height
[[nodiscard]] inline Wrench side_milling_wrench(const SteadyCut& cut, double R, double height, double from, double to) {
  const double U = cut.chip() * height;
  const double cos_cos = (to - from) / 2 + (std::sin(2 * to) - std::sin(2 * from)) / 4;
  const double sin_cos = (std::pow(std::sin(to), 2) - std::pow(std::sin(from), 2)) / 2;
  return {Vec3(-U / cut.cutting_ratio * cos_cos + U * sin_cos, -U / cut.cutting_ratio * sin_cos - U * cos_cos, 0),
          Vec3(0, 0, -U * R * (std::sin(to) - std::sin(from)))};
}

/// C24: wrench on a cylinder that cuts a slot of its own diameter,
/// `F_x = -(pi/2) u v_f h/(kappa omega)`, `F_y = -(pi/2) u v_f h/omega`, `T_z = -2 u v_f R h/omega`.
/// @param height  [m] h
/// @return about the axis, at half the height
[[nodiscard]] inline Wrench slotting_wrench(const SteadyCut& cut, double R, double height) {
  const double U = cut.chip() * height;
  return {Vec3(-units::kPi / 2 * U / cut.cutting_ratio, -units::kPi / 2 * U, 0), Vec3(0, 0, -2 * U * R)};
}

/// C26: wrench on a ball that cuts a groove, with its axis normal to the surface; with th = acos(1 - d/R), g = th - sin
/// th cos th
///
///     F_x = -(pi/4) u v_f R g/(kappa omega),   F_y = -(pi/2) (u v_f R/omega) (1 - cos th),
///     F_z = (u v_f R/(kappa omega)) sin^2 th,   T_z = -(u v_f R^2/omega) g
///
/// @param depth  [m] of the groove, 0 ... 2R
/// @return force, and the torque about the axis; the other two components of the torque are left 0
[[nodiscard]] inline Wrench groove_wrench(const SteadyCut& cut, double R, double depth) {
  const double th = std::acos(1 - depth / R), g = th - std::sin(th) * std::cos(th), U = cut.chip() * R;
  return {Vec3(-units::kPi / 4 * U * g / cut.cutting_ratio, -units::kPi / 2 * U * (1 - std::cos(th)),
               U / cut.cutting_ratio * std::pow(std::sin(th), 2)),
          Vec3(0, 0, -U * R * g)};
}

/// C27: wrench on a ball buried in material and fed sideways, C26 with d = 2R:
/// `F_x = -(pi^2/4) u v_f R/(kappa omega)`, `F_y = -pi u v_f R/omega`, `T_z = -pi u v_f R^2/omega`.
[[nodiscard]] inline Wrench buried_ball_wrench(const SteadyCut& cut, double R) {
  const double U = cut.chip() * R;
  return {Vec3(-units::kPi * units::kPi / 4 * U / cut.cutting_ratio, -units::kPi * U, 0),
          Vec3(0, 0, -units::kPi * U * R)};
}

/// C28: wrench on a ball plunged along its axis; with th = acos(1 - d/R), pi/2 from d = R on,
/// `F_z = (pi R u v_f/(kappa omega)) (th + sin th cos th)`, `T_z = -u pi R^2 sin^2 th v_f/omega`.
[[nodiscard]] inline Wrench ball_plunge_wrench(const SteadyCut& cut, double R, double depth) {
  const double th = std::acos(1 - std::min(depth, R) / R);
  return {Vec3(0, 0, units::kPi * R * cut.chip() / cut.cutting_ratio * (th + std::sin(th) * std::cos(th))),
          Vec3(0, 0, -units::kPi * std::pow(R * std::sin(th), 2) * cut.chip())};
}

/// C29: wrench on a cone plunged along its axis; with a = d tan(alpha),
/// `F_z = 2 pi u v_f sin(alpha) a/(kappa omega)`, `T_z = -u pi a^2 v_f/omega`.
/// @param half_angle  [rad] alpha
/// @param depth       [m] at most the height of the cone
[[nodiscard]] inline Wrench cone_plunge_wrench(const SteadyCut& cut, double half_angle, double depth) {
  const double a = depth * std::tan(half_angle);
  return {Vec3(0, 0, 2 * units::kPi * cut.chip() * std::sin(half_angle) * a / cut.cutting_ratio),
          Vec3(0, 0, -units::kPi * a * a * cut.chip())};
}

/// C35: wrench on a flat head fed axially, with an energy that depends on the chip, `u (1 + h_e f_z/v + sqrt(h_s
/// f_z/v))`: that of C22 with V = v_f + sqrt(h_s f_z v_f) + h_e f_z in place of v_f.
/// @return force and torque along z
[[nodiscard]] inline Wrench axial_chip_wrench(const SteadyCut& cut, double R) {
  SteadyCut dearer = cut;
  dearer.feed_speed += cut.size_speed() + cut.edge_speed();
  return {Vec3(0, 0, axial_cutting_force_of_a_flat_head(dearer, R)),
          Vec3(0, 0, axial_cutting_torque_of_a_flat_head(dearer, R))};
}

/// C36: feed of a flat head under a constant force, with an energy that depends on the chip: with
/// V = kappa omega (F - pi R^2 p_e)/(2 pi R u) - h_e f_z and b = sqrt(h_s f_z), `((sqrt(b^2 + 4 V) - b)/2)^2`, or 0.
/// @param force  [N]
/// @return [m/s]
[[nodiscard]] inline double feed_with_chips_under(double force, const SteadyCut& cut, double R) {
  const double beyond_edges = feed_of_a_flat_head_under(force, cut, R) - cut.edge_speed();
  if (beyond_edges <= 0) return 0;
  const double b_squared = cut.size_length * cut.tooth_rate;
  return std::pow(2 * beyond_edges / (std::sqrt(b_squared + 4 * beyond_edges) + std::sqrt(b_squared)), 2);
}

/// [1] Integral of cos^n between -pi/2 and pi/2, `sqrt(pi) Gamma((n + 1)/2)/Gamma(n/2 + 1)`.
[[nodiscard]] inline double integral_of_cosine(double n) {
  return std::sqrt(units::kPi) * std::tgamma((n + 1) / 2) / std::tgamma(n / 2 + 1);
}

/// C37: wrench on a cylinder that cuts a slot of its own diameter, with an energy that depends on the chip. The chip is
/// thickest in the middle,
///
///     F_x = -(u h/(kappa omega)) [(pi/2) v_f + 1.748 sqrt(h_s f_z v_f) + 2 h_e f_z],   F_y = kappa F_x
///     T_z = -(u R h/omega) [2 v_f + 2.396 sqrt(h_s f_z v_f) + pi h_e f_z]
///
/// @param height  [m] h
/// @return about the axis, at half the height
[[nodiscard]] inline Wrench slotting_chip_wrench(const SteadyCut& cut, double R, double height) {
  const double u_h = cut.specific_cutting_energy * height / cut.spin;
  const auto sum = [&](double n) {
    return integral_of_cosine(n + 1) * cut.feed_speed + integral_of_cosine(n + 0.5) * cut.size_speed() +
           integral_of_cosine(n) * cut.edge_speed();
  };
  return {Vec3(-u_h / cut.cutting_ratio * sum(1), -u_h * sum(1), 0), Vec3(0, 0, -u_h * R * sum(0))};
}

/// C38: wrench on a ball plunged along its axis, deeper than its radius, with an energy that depends on the chip,
///
///     F_z = (2 pi R u/(kappa omega)) [(pi/4) v_f + 0.874 sqrt(h_s f_z v_f) + h_e f_z]
///     T_z = -(2 pi R^2 u/omega) [v_f/2 + (2/3) sqrt(h_s f_z v_f) + h_e f_z]
[[nodiscard]] inline Wrench ball_plunge_chip_wrench(const SteadyCut& cut, double R) {
  const double u_R = 2 * units::kPi * R * cut.specific_cutting_energy / cut.spin;
  return {
      Vec3(0, 0,
           u_R / cut.cutting_ratio *
               (units::kPi / 4 * cut.feed_speed + integral_of_cosine(1.5) / 2 * cut.size_speed() + cut.edge_speed())),
      Vec3(0, 0, -u_R * R * (cut.feed_speed / 2 + 2.0 / 3 * cut.size_speed() + cut.edge_speed()))};
}

/// C42: the groove of C26 with an energy that depends on the chip; with c(n) the integral of cos^n between -pi/2 and
/// pi/2, s(n) the integral of sin^n between 0 and th, and the sums over m = 1, 1/2, 0 with V = v_f, sqrt(h_s f_z v_f),
/// h_e f_z
///
///     F_x = -(u R/(kappa omega)) Sum c(m + 1) s(m + 1) V,   F_y = -(u R/omega) Sum c(m + 1) s(m) V
///     F_z = (u R/(kappa omega)) Sum c(m) sin(th)^(m + 1) V/(m + 1),   T_z = -(u R^2/omega) Sum c(m) s(m + 1) V
///
/// @param depth  [m] of the groove, 0 ... 2R
/// @return force, and the torque about the axis; the other two components of the torque are left 0
[[nodiscard]] inline Wrench groove_chip_wrench(const SteadyCut& cut, double R, double depth) {
  constexpr int kSteps = 400;
  const double th = std::acos(1 - depth / R), u_R = cut.specific_cutting_energy * R / cut.spin;
  // In steps of th x^2, because the root has an infinite slope at the lowest point.
  const auto sines = [&](double m) {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) / kSteps;
      sum += std::pow(std::sin(th * x * x), m) * 2 * th * x / kSteps;
    }
    return sum;
  };
  const auto sum = [&](double cosines, const auto& along) {
    return integral_of_cosine(cosines + 1) * along(1.0) * cut.feed_speed +
           integral_of_cosine(cosines + 0.5) * along(0.5) * cut.size_speed() +
           integral_of_cosine(cosines) * along(0.0) * cut.edge_speed();
  };
  const auto across = [&](double m) { return sines(m + 1); };
  const auto upwards = [&](double m) { return std::pow(std::sin(th), m + 1) / (m + 1); };
  return {
      Vec3(-u_R / cut.cutting_ratio * sum(1, across), -u_R * sum(1, sines), u_R / cut.cutting_ratio * sum(0, upwards)),
      Vec3(0, 0, -u_R * R * sum(0, across))};
}

/// C30: power of the cut, `u dV/dt`, without edge pressure. With law A the motor alone supplies it, `|T_z| omega`, and
/// the work of the hand becomes released elastic energy. With law G both supply it, `|T_z| omega + F_f v_f`.
/// @param volume_rate  [m^3/s] dV/dt, removed volume per time
/// @return [W]
[[nodiscard]] inline double cutting_power(const SteadyCut& cut, double volume_rate) {
  return cut.specific_cutting_energy * volume_rate;
}

/// C31: wrench on a twist drill of diameter D and point angle beta, `F_z = u a (D/2) sin(beta/2)`, `T_z = -u a D^2/8`,
/// a = 2 pi v_f/omega. The default law gives the same wrench for a flat head with kappa = 1/sin(beta/2), and for a cone
/// of half angle beta/2 with kappa = 1. `SteadyCut::cutting_ratio` is not used.
/// @param point_angle  [rad] beta
[[nodiscard]] inline Wrench twist_drill_wrench(const SteadyCut& cut, double diameter, double point_angle) {
  const double ua = 2 * units::kPi * cut.chip();
  return {Vec3(0, 0, ua * diameter / 2 * std::sin(point_angle / 2)), Vec3(0, 0, -ua * diameter * diameter / 8)};
}

/// C32: torque over thrust of a flat head, `kappa R/2` without edge pressure.
/// @return [m]
[[nodiscard]] inline double torque_over_thrust_of_chips(double kappa, double R) { return kappa * R / 2; }

/// C32: torque over thrust of a flat head if the edges carry the whole force, `(2/3) kappa R`.
/// @return [m]
[[nodiscard]] inline double torque_over_thrust_of_edges(double kappa, double R) { return 2.0 / 3 * kappa * R; }

// --- C33: a head that goes down step by step; each step removes all material deeper than w_c -------------------------

/// C33: volume of a step of a flat head, `pi R^2 D`, equal in every step.
/// @param step  [m] D
/// @return [m^3]
[[nodiscard]] inline double step_volume_of_a_flat_head(double R, double step) { return units::kPi * R * R * step; }

/// C33: volume of a step of a cone down to depth d, `pi tan^2 a (d^3 - (d - D)^3)/3`.
/// @param depth  [m] after the step
[[nodiscard]] inline double step_volume_of_a_cone(double half_angle, double depth, double step) {
  return units::kPi / 3 * std::pow(std::tan(half_angle), 2) * (std::pow(depth, 3) - std::pow(depth - step, 3));
}

/// C33: volume of a step of a ball down to depth d <= R, the difference of two caps of volume `pi d^2 (R - d/3)`.
[[nodiscard]] inline double step_volume_of_a_ball(double R, double depth, double step) {
  const auto cap = [R](double d) { return units::kPi * d * d * (R - d / 3); };
  return cap(depth) - cap(depth - step);
}

/// C33: force of a step of a flat head, `k_v pi R^2 D^2/2`, equal in every step.
/// @return [N]
[[nodiscard]] inline double step_force_of_a_flat_head(double k_v, double R, double step) {
  return flat_bottom_force(k_v, R, step);
}

/// C33: force of a step of a cone, `(k_v/2) pi d^2 tan^2 a (D sin a + w_c)^2`; it grows with every step.
/// @param depth  [m] of the middle of the step; much larger than D and w_c
[[nodiscard]] inline double step_force_of_a_cone(double k_v, double half_angle, double depth, double step,
                                                 double removal_depth = 0) {
  const double layer = std::sin(half_angle) * step + removal_depth;
  return k_v / 2 * units::kPi * std::pow(depth * std::tan(half_angle) * layer, 2);
}

/// C33: force of a step of a ball, `k_v Int (D n_z + w_c)^2/2 n_z dA` over its cap, whose normals have n_z from c = (R
/// - d)/R to 1: `pi R^2 k_v [D^2 (1 - c^4)/4 + 2 D w_c (1 - c^3)/3 + w_c^2 (1 - c^2)/2]`.
/// @param depth  [m] of the middle of the step, at most R; much larger than D and w_c
[[nodiscard]] inline double step_force_of_a_ball(double k_v, double R, double depth, double step,
                                                 double removal_depth = 0) {
  const double c = (R - depth) / R, w = removal_depth;
  return units::kPi * R * R * k_v *
         (step * step * (1 - std::pow(c, 4)) / 4 + 2 * step * w * (1 - std::pow(c, 3)) / 3 + w * w * (1 - c * c) / 2);
}

// --- C34: the engaged layer ------------------------------------------------------------------------------------------

/// C34: thickness of the layer under a flat head in which material is pressed and cut, at a distance rho from the axis:
/// `sqrt(2 u v_f/(kappa k_v omega rho))`. At this depth the fill has fallen to 1/e.
/// @return [m]
[[nodiscard]] inline double engaged_layer(const SteadyCut& cut, double k_v, double rho) {
  return std::sqrt(2 * cut.chip() / (cut.cutting_ratio * k_v * rho));
}

/// C34, inverted: the stiffness that gives a layer of a thickness [m] at rho [m].
/// @return [N/m^4]
[[nodiscard]] inline double stiffness_for_layer(const SteadyCut& cut, double layer, double rho) {
  return 2 * cut.chip() / (cut.cutting_ratio * rho * layer * layer);
}

/// C34: filled volume in a flat head that is fed axially, for a layer with a sharp surface: `(4 pi/3) R^2 delta(R)`.
/// @param layer  [m] delta at the rim
/// @return [m^3]
[[nodiscard]] inline double engaged_volume_under_a_flat_head(double R, double layer) {
  return 4 * units::kPi / 3 * R * R * layer;
}

/// C34: filled volume in a flat head that is fed axially, for material that decays through the layer, `(2 pi^1.5/3) R^2
/// delta(R)`.
[[nodiscard]] inline double decaying_volume_under_a_flat_head(double R, double layer) {
  return 2 * std::pow(units::kPi, 1.5) / 3 * R * R * layer;
}

// --- C43: what a pass leaves -----------------------------------------------------------------------------------------

/// C43: thickness of the material that a head leaves on the wall beside its path, inside the surface that it sweeps,
/// `(a_1^2/2) (v_f^2/(R k_d^2))^(1/3)` with `k_d = kappa k_v omega rho/(2 u)` and the first zero -a_1 of Airy's Ai'.
/// While the head passes, at the distance `v_f^2 tau^2/(2 R)`, the depth of the layer follows
/// `t' = -v_f^2 tau/R - k_d t^2`. An edge pressure leaves about 1.5 sqrt(2 p_e/k_v) more.
/// @param rho        [m] distance of the wall from the axis
/// @param curvature  [m] radius R of the head along the feed
/// @return [m]
[[nodiscard]] inline double wall_left_by_a_pass(const SteadyCut& cut, double k_v, double rho, double curvature) {
  constexpr double kZeroOfAiry = 1.0187929716;                                                        // a_1
  const double decay = cut.cutting_ratio * k_v * cut.spin * rho / (2 * cut.specific_cutting_energy);  // [1/(m s)] k_d
  return kZeroOfAiry * kZeroOfAiry / 2 * std::cbrt(cut.feed_speed * cut.feed_speed / (curvature * decay * decay));
}

}  // namespace hapticut::closed_forms
