// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/shapes.hpp"

/// @file
/// C1 ... C19, C39 ... C41: springs, crushing, friction, limits and handles, with the spindle at rest.
namespace hapticut::closed_forms {

// --- a head at rest: springs alone -----------------------------------------------------------------------------------

/// C1: vertical force of a ball, `k_v (pi/12) e^3 (4R - 3e)` with e = min(d, 2R - d); it decreases beyond d = R.
/// Springs only, as are C4 ... C6: by default a head that stands also has friction, which adds up to nine tenths after
/// a few steps. `SimulationConfig::friction = DryFriction{0, 0}` leaves it out. A step returns the mean over its
/// motion.
/// @param k_v    [N/m^4]
/// @param R      [m] > 0
/// @param depth  [m] any; outside 0 ... 2R there is no force
/// @return [N]
[[nodiscard]] inline double cap_force(double k_v, double R, double depth) {
  const double e = std::min(depth, 2 * R - depth);
  return e > 0 ? k_v * units::kPi / 12 * e * e * e * (4 * R - 3 * e) : 0.0;
}

/// C2: stiffness dF/dd of a ball, `k_v pi d^2 (R - d)`, 0 <= d <= R.
/// @return [N/m]
[[nodiscard]] inline double cap_stiffness(double k_v, double R, double depth) {
  return k_v * units::kPi * depth * depth * (R - depth);
}

/// C2: largest stiffness of a ball, `(4 pi/27) k_v R^3`, at d = 2R/3.
/// @return [N/m]
[[nodiscard]] inline double max_cap_stiffness(double k_v, double R) { return 4 * units::kPi / 27 * k_v * R * R * R; }

/// C3: energy stored under a ball, `pi k_v (R d^4/12 - d^5/20)`, 0 <= d <= R.
/// @return [J]
[[nodiscard]] inline double cap_energy(double k_v, double R, double depth) {
  return units::kPi * k_v * (R * std::pow(depth, 4) / 12 - std::pow(depth, 5) / 20);
}

/// C4: vertical force of a cone, `(pi/12) k_v sin^2 a tan^2 a d^4`, d at most its height. No friction, as in C1.
/// @param half_angle  [rad] a, between axis and generatrix
/// @return [N]
[[nodiscard]] inline double cone_force(double k_v, double half_angle, double depth) {
  const double slope = std::sin(half_angle) * std::tan(half_angle);
  return units::kPi / 12 * k_v * slope * slope * std::pow(depth, 4);
}

/// C5: vertical force of a flat head with rule bottom_only, `k_v pi R^2 d^2/2`. No friction, as in C1.
/// @return [N]
[[nodiscard]] inline double flat_bottom_force(double k_v, double R, double depth) {
  return k_v * units::kPi * R * R * depth * depth / 2;
}

/// C6: vertical force of a flat head with rule nearest, where points nearer to the side wall do not push up:
/// `pi k_v (R^2 d^2/2 - 2R d^3/3 + d^4/4)`, d <= R and at most the height. No friction, as in C1.
/// @return [N]
[[nodiscard]] inline double flat_nearest_force(double k_v, double R, double depth) {
  return units::kPi * k_v * (R * R * depth * depth / 2 - 2 * R * std::pow(depth, 3) / 3 + std::pow(depth, 4) / 4);
}

/// C7: horizontal force on a cylinder whose side is pressed a depth d into the wall x > c = R - d over a height h,
/// `F_x = -k_v h [c^2 a + a^3/3 - R c^2 ln((R + a)/c)]`, a = sqrt(R^2 - c^2), 0 < d < R.
/// @return [N] along x, negative: away from the wall
[[nodiscard]] inline double side_wall_force(double k_v, double R, double depth, double height) {
  const double c = R - depth, a = std::sqrt(R * R - c * c);
  return -k_v * height * (c * c * a + a * a * a / 3 - R * c * c * std::log((R + a) / c));
}

/// C8: torque of C7 about y through (0, 0, z_r), for a wall from z0 to z1:
/// `T_y = F_x [(z1^2 - z0^2)/2 - z_r (z1 - z0)]/(z1 - z0)`.
/// @return [N·m]
[[nodiscard]] inline double side_wall_torque(double k_v, double R, double depth, double z0, double z1, double z_r) {
  return side_wall_force(k_v, R, depth, 1) * ((z1 * z1 - z0 * z0) / 2 - z_r * (z1 - z0));
}

/// [m^2] Area of the part x < x0 of a disk of radius R about the origin, `R^2 acos(-x0/R) + x0 sqrt(R^2 - x0^2)`, |x0|
/// <= R.
[[nodiscard]] inline double disk_area_before(double R, double x0) {
  return R * R * std::acos(-x0 / R) + x0 * std::sqrt(R * R - x0 * x0);
}

/// C9: vertical force of a flat head, rule bottom_only, over the edge of a body that fills x < x0, z < 0:
/// `k_v d^2 A/2`, A = `disk_area_before`.
/// @return [N]
[[nodiscard]] inline double edge_force(double k_v, double R, double depth, double x0) {
  return k_v * depth * depth / 2 * disk_area_before(R, x0);
}

/// C9: torque of `edge_force` about y through the axis, `T_y = (k_v d^2/3) (R^2 - x0^2)^1.5`.
/// @return [N·m]
[[nodiscard]] inline double edge_torque(double k_v, double R, double depth, double x0) {
  return k_v * depth * depth / 3 * std::pow(R * R - x0 * x0, 1.5);
}

/// C10: vertical force of a ball through a layer of stiffness k1 into one of k2 below,
/// `k1 [S(d) - S(d - t)] + k2 S(d - t)`, S of C1; k2 = 0: the layer is a plate with air below it.
/// @param k1, k2     [N/m^4]
/// @param thickness  [m] t of the upper one
/// @return [N]
[[nodiscard]] inline double layered_cap_force(double k1, double k2, double thickness, double R, double depth) {
  const double below = cap_force(1, R, depth - thickness);
  return k1 * (cap_force(1, R, depth) - below) + k2 * below;
}

/// C11, the pressure identity: the springs have the wrench of a pressure `k_v w^2/2` on the surface of the material
/// inside the head. It is true for any pose, for any body of uniform stiffness, and any head whose depth vanishes on
/// all of its surface in material.
/// @param w  [m] >= 0 depth
/// @return [Pa]
[[nodiscard]] inline double surface_pressure(double k_v, double w) { return k_v * w * w / 2; }

/// A flat surface; the material lies where height(p) < 0.
struct Plane {
  Vec3 normal = Vec3::UnitZ();  ///< [1] out of the material
  double offset = 0;            ///< [m] distance of the surface from the origin, along the normal
  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p) - offset; }  ///< [m]
};

/// C11 for a flat surface: `F = Int N p dA`, `T = Int r x N p dA`, by the midpoint rule on a square grid of points. The
/// pressure and its slope vanish at the rim, so that 200 points across give an error below 2e-4.
/// @param depth_of  [m] w of a point (rho, z) of the head's meridian; <= 0 outside
/// @param middle    [m] of the head, in T
/// @param reach     [m] radius of a ball about the middle that contains the head
/// @param points    across the grid
/// @return about To, in W
template <class DepthOf>
[[nodiscard]] Wrench wrench_on_plane(double k_v, const DepthOf& depth_of, const Pose& X_WT, const Plane& plane,
                                     const Vec3& middle, double reach, int points) {
  const Vec3 u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
  const Vec3 above = X_WT * middle, center = above - plane.height(above) * plane.normal;
  const double side = 2 * reach / points;
  const Pose X_TW = X_WT.inverse();
  Wrench wrench;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      const Vec3 p_WQ = center + ((i + 0.5) * side - reach) * u + ((j + 0.5) * side - reach) * v;
      const Vec3 p_TQ = X_TW * p_WQ;
      const double w = depth_of(std::hypot(p_TQ.x(), p_TQ.y()), p_TQ.z());
      if (w <= 0) continue;
      const Vec3 force = surface_pressure(k_v, w) * side * side * plane.normal;
      wrench.force += force;
      wrench.torque += (p_WQ - X_WT.translation).cross(force);
    }
  return wrench;
}

/// C12: force on a ball in a stiffness k_v + gradient . p: the force of C11 minus the gradient times the stored energy
/// over k_v, `F = k_v S(d) z - (U/k_v) gradient`, 0 <= d <= R. The axis of the ball passes through the origin.
/// @param k_v       [N/m^4] at the origin
/// @param gradient  [N/m^5] of the stiffness
/// @return [N]
[[nodiscard]] inline Vec3 graded_cap_force(double k_v, const Vec3& gradient, double R, double depth) {
  return cap_force(k_v, R, depth) * Vec3::UnitZ() - cap_energy(1, R, depth) * gradient;
}

/// C13: work of the hand along a closed path of a head at rest, without removal, damping and friction.
inline constexpr double kWorkOfAClosedPath = 0;  // [J]

/// C14: torque of a ball about a point P. All its springs point to the centre C, so `T = (C - P) x F`.
/// @param p_PC   [m] from P to the centre
/// @param force  [N]
/// @return [N·m]
[[nodiscard]] inline Vec3 ball_torque(const Vec3& p_PC, const Vec3& force) { return p_PC.cross(force); }

/// C15: force of Hunt-Crossley damping on a ball that moves down,
/// `(2 pi/3) k_v chi v {R(R^3 - h^3)/3 - (R^4 - h^4)/4 - h^3 [R ln(R/h) - d]}`, h = R - d, 0 <= d < R. It also
/// is true for a ball that moves up while chi times the speed is nowhere above 1.
/// @param chi    [s/m]
/// @param speed  [m/s] downwards
/// @return [N]
[[nodiscard]] inline double ball_damping_force(double k_v, double chi, double R, double depth, double speed) {
  const double h = R - depth;
  return 2 * units::kPi / 3 * k_v * chi * speed *
         (R * (std::pow(R, 3) - std::pow(h, 3)) / 3 - (std::pow(R, 4) - std::pow(h, 4)) / 4 -
          std::pow(h, 3) * (R * std::log(R / h) - depth));
}

/// C16: vertical force of an upright head, `(k_v/2) Int w^2 dA` over its section with the surface, by the midpoint rule
/// on rings. The depth must vanish on all parts of the head's surface in material that are not vertical. This excludes
/// the flat rules side_only and both.
/// @param depth_at  [m] w at a distance rho from the axis, at the height of the surface; <= 0 outside
/// @param reach     [m] where the section ends
/// @return [N]
template <class DepthAt>
[[nodiscard]] double section_force(double k_v, const DepthAt& depth_at, double reach, int rings = 20000) {
  double force = 0;
  for (int i = 0; i < rings; ++i) {
    const double rho = reach * (i + 0.5) / rings;
    force += surface_pressure(k_v, std::max(0.0, double(depth_at(rho)))) * 2 * units::kPi * rho * reach / rings;
  }
  return force;
}

// --- crushing --------------------------------------------------------------------------------------------------------

/// C39: vertical force of a flat head with rule bottom_only that crushes: `F_z = sigma pi R^2`.
/// @param strength  [Pa] sigma
/// @return [N]
[[nodiscard]] inline double flat_bottom_crushing_force(double strength, double radius) {
  return strength * units::kPi * radius * radius;
}

/// C40: vertical force of a ball that crushes, between the crushing depth w0 = sqrt(2 sigma/k_v) and its radius:
/// `F_z = pi sigma (2 R d - d^2 - (4/3) R w0 + w0^2/2)`. For w0 = 0 it is sigma times the projected area.
/// @param strength        [Pa] sigma
/// @param crushing_depth  [m] w0
/// @return [N]
[[nodiscard]] inline double cap_crushing_force(double strength, double crushing_depth, double radius, double depth) {
  const double w0 = crushing_depth;
  return units::kPi * strength * (2 * radius * depth - depth * depth - 4.0 / 3 * radius * w0 + w0 * w0 / 2);
}

// --- smooth surfaces -------------------------------------------------------------------------------------------------

/// C41: force on a smooth pin that fills a straight hole and is pushed sideways. With t, the thickness of the wall
/// inside the pin in the direction phi, `F = k_v beta^2 L Int (R t^2/2 - t^3/3) cos(phi) dphi`, `t = R + x cos(phi) -
/// sqrt(R^2 - x^2 sin^2(phi))`; (2/3) k_v beta^2 x^2 R L for small x. beta = kSmoothScale.
/// @param radius  [m] R of pin and hole
/// @param length  [m] L of the hole
/// @param push    [m] x
/// @return [N] against the push
[[nodiscard]] inline double pushed_pin_force(double k_v, double radius, double length, double push) {
  constexpr int kDirections = 2000;
  double sum = 0;
  for (int n = 0; n < kDirections; ++n) {
    const double phi = units::kPi / 2 * (n + 0.5) / kDirections, aside = push * std::sin(phi);
    const double t = std::max(0.0, radius + push * std::cos(phi) - std::sqrt(radius * radius - aside * aside));
    sum += (radius * t * t / 2 - t * t * t / 3) * std::cos(phi);
  }
  return k_v * kSmoothScale * kSmoothScale * length * 2 * sum * units::kPi / 2 / kDirections;
}

// --- friction, limits, handles ---------------------------------------------------------------------------------------

/// C17: work to drag a contact at rest over a length, under a constant normal force and with the spindle at rest:
/// `(mu_s N)^2/(2 k_t) + mu_d N (L - mu_s N/k_t)`, for a length beyond the onset of slip.
/// @param mu_s, mu_d  [1]
/// @param k_t         [N/m]
/// @param normal      [N] N
/// @param length      [m] L >= mu_s N/k_t
/// @return [J]
[[nodiscard]] inline double drag_work(double mu_s, double mu_d, double k_t, double normal, double length) {
  const double peak = mu_s * normal;
  return peak * peak / (2 * k_t) + mu_d * normal * (length - peak / k_t);
}

/// C17: largest force of the drag, mu_s N, at the onset of slip. [N]
[[nodiscard]] inline double drag_peak(double mu_s, double normal) { return mu_s * normal; }

/// C17: force during sliding, mu_d N. [N]
[[nodiscard]] inline double drag_plateau(double mu_d, double normal) { return mu_d * normal; }

/// C18: time in which a limited output grows by a difference, `|dF|/rate`, for any step size; a decrease takes no time.
/// @param difference  [N] > 0
/// @param rate        [N/s]
/// @return [s]
[[nodiscard]] inline double growth_time(double difference, double rate) { return difference / rate; }

/// C19: power of a wrench on a body, `F . V + T . Omega`, equal at every point of the body.
/// @param wrench  about a point
/// @param twist   of the same point, in the same axes
/// @return [W]
[[nodiscard]] inline double power(const Wrench& wrench, const Twist& twist) {
  return wrench.force.dot(twist.linear) + wrench.torque.dot(twist.angular);
}

}  // namespace hapticut::closed_forms
