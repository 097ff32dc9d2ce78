// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/material.hpp"

/// The choice of the foundation's stiffness k_v, which regularises the contact. Two demands conflict: accuracy needs a
/// high stiffness, and a device that is driven directly needs a low one. A virtual coupling separates the two.
namespace hapticut {

/// [N/m^4] For forces at points, one for each voxel. The thin layer of a stiffer foundation would be hit and missed as
/// the head moves.
inline constexpr double kStiffnessOfPoints = 1e13;

inline constexpr double kPressureOfCuts = 1e6;  ///< [Pa] interface pressure in a common cut, which has 0.1 to 10 MPa
inline constexpr double kLayerOfRadius = 0.01;  ///< [1] engaged layer at that pressure over the head's radius
inline constexpr double kLayerOfPoint =
    4.0 / 3;                              ///< [1] factor of that layer for each unit of the slope of a pointed head
inline constexpr double kMinLayer = 0.1;  ///< [1] minimum factor of that layer, however pointed

namespace detail {

/// [1] Slope d rho/dz of a head's end near its tip: above 2 for round or flat ends.
[[nodiscard]] inline double slope_of_tip(const ToolHead& head) {
  constexpr double kHeight = 0.05;  // [1] height above the tip, over the radius
  constexpr int kHalvings = 30;
  const double radius = head.cutting_radius(), height = kHeight * radius, z = head.bounding_box().min.z() + height;
  double inside = 0, outside = 2 * radius;
  if (!(head.spring_at({0, 0, z}).depth > 0)) return outside / height;  // a hollow
  for (int n = 0; n < kHalvings; ++n) {
    const double rho = 0.5 * (inside + outside);
    (head.spring_at({rho, 0, z}).depth > 0 ? inside : outside) = rho;
  }
  return inside / height;
}

}  // namespace detail

/// The k_v that a simulation chooses by default. Under kPressureOfCuts the interface between head and material, whose
/// pressure is k_v t^2/2 at depth t, is pressed in by a hundredth of the head's radius; a material of relative
/// stiffness s by s^-1/2 times as much, so that it feels softer or stiffer. For a needle the layer is thinner, because
/// the needle would otherwise sink through bone before the material at its point is crushed. The voxel size does not
/// enter, because the volume that a constant force removes would then depend on it: the rear half of a bur rests on its
/// own groove, at a depth proportional to k_v^-1/4 (docs/decisions/0021-hand-to-the-end.md).
/// @return [N/m^4] for a material of relative stiffness 1
[[nodiscard]] inline double stiffness_for_head(const ToolHead& head) {
  const double pointed = std::clamp(kLayerOfPoint * detail::slope_of_tip(head), kMinLayer, 1.0);
  const double layer = pointed * kLayerOfRadius * head.cutting_radius();
  return 2 * kPressureOfCuts / (layer * layer);
}

namespace detail {

inline constexpr int kSections = 64;  // planes through the head, in each direction
inline constexpr int kSection = 64;   // points across one of them

// A flat solid that advances by dd into the head adds a slice of thickness dd to the immersed volume. With N the normal
// of its face, `dF/dd = k_v Int s w |n . N| dA` over the section of the head by that face; s is the scale of the
// spring, 1 or kSmoothScale.

/// The integral over the section normal to the axis at height z.  [m^3]
[[nodiscard]] inline double axial_section(const ToolHead& head, double z, double radius) {
  double sum = 0;
  const double step = radius / kSection;
  for (int i = 0; i < kSection; ++i) {
    const double rho = (i + 0.5) * step;
    const Spring s = head.spring_at({rho, 0, z});
    if (s.depth > 0) sum += s.scale() * s.depth * std::abs(s.direction.z()) * 2 * units::kPi * rho * step;
  }
  return sum;
}

/// The integral over the section parallel to the axis, at distance c from it: twice that over a half of it.  [m^3]
[[nodiscard]] inline double lateral_section(const ToolHead& head, double c, const HeadBox& box) {
  double sum = 0;
  const double dy = box.max.y() / kSection;
  const double dz = (box.max.z() - box.min.z()) / kSection;
  for (int i = 0; i < kSection; ++i)
    for (int k = 0; k < kSection; ++k) {
      const Spring s = head.spring_at({c, (i + 0.5) * dy, box.min.z() + (k + 0.5) * dz});
      if (s.depth > 0) sum += s.scale() * s.depth * std::abs(s.direction.x());
    }
  return 2 * sum * dy * dz;
}

}  // namespace detail

/// The reference stiffness above which the engaged layer of a steady cut is thinner than a tenth of the head's radius:
/// k_v = `200 u V/(kappa omega R^3)`, V = v_f + sqrt(h_s f_z v_f) + h_e f_z (C35), over the material's relative
/// stiffness. With a lower stiffness, cutting forces are too low.
/// @param material       u, h_e, h_s, kappa and the relative stiffness are used; kappa must be > 0
/// @param spindle_speed  not 0
/// @param feed_speed     [m/s] > 0, at most kMaxFeed
/// @param cutter         its lips make the chips
/// @return [N/m^4] for SimulationConfig::reference_stiffness
/// @throws Error when one of them is out of range
[[nodiscard]] inline double stiffness_for_accuracy(const ToolHead& head, const Material& material,
                                                   AngularSpeed spindle_speed, double feed_speed,
                                                   const Cutter& cutter = {}) {
  require_positive(std::abs(spindle_speed), "spindle speed [rad/s]");
  require_feed(feed_speed, "feed speed [m/s]");
  require_positive(material.cutting_ratio, "Material::cutting_ratio [1]");
  const double radius = head.cutting_radius(), teeth = tooth_rate(cutter, spindle_speed);
  const double speed = feed_speed + std::sqrt(material.size_length * teeth * feed_speed) + material.edge_length * teeth;
  return 200 * material.specific_cutting_energy * speed /
         (material.relative_stiffness * material.cutting_ratio * std::abs(spindle_speed) * radius * radius * radius);
}

/// The maximum contact stiffness of a head pressed into a flat solid of unit k_v, along its axis or sideways: `max
/// dF/dd`, by the pressure identity (C11) on a plane that moves through the head. For a sphere `(4 pi/27) R^3` (C2).
/// @return [m^3] to be multiplied by k_v; relative error below 1 %
[[nodiscard]] inline double max_contact_stiffness(const ToolHead& head) {
  const HeadBox box = head.bounding_box();
  double maximum = 0;
  for (int i = 0; i < detail::kSections; ++i) {
    const double fraction = (i + 0.5) / detail::kSections;
    const double z = box.min.z() + fraction * (box.max.z() - box.min.z());
    maximum = std::max(maximum, detail::axial_section(head, z, box.max.x()));
    maximum = std::max(maximum, detail::lateral_section(head, fraction * box.max.x(), box));
  }
  return maximum;
}

/// The maximum k_v that a directly driven device can render stably: `K_max / max_contact_stiffness(head)`.
/// @param device_stiffness  [N/m] K_max > 0, the stiffest wall the device renders
/// @return [N/m^4] for a material of relative stiffness 1
/// @throws Error when the device stiffness is not positive
[[nodiscard]] inline double stiffness_for_device(const ToolHead& head, double device_stiffness) {
  require_positive(device_stiffness, "device stiffness [N/m]");
  return device_stiffness / max_contact_stiffness(head);
}

}  // namespace hapticut
