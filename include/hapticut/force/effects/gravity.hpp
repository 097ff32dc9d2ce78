// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// The weight of the virtual tool (thesis 5.9). The device's own stylus already has a weight, so give the difference.
///
///     F = m g,   T = (p_com - Ho) x F   about the handle's origin
struct Gravity {
  double mass = 0;  ///< [kg] mass of the tool minus mass of the device's stylus; its weight acts on the hand
  Vec3 center_of_mass = Vec3::Zero();        ///< [m] centre of this mass, from the handle's origin Ho, in its frame H
  Vec3 acceleration = Vec3(0, 0, -9.80665);  ///< [m/s^2] gravitational acceleration, in W
};

constexpr auto fields_of(Of<Gravity>) {
  return std::tuple{
      field("mass", &Gravity::mass, "kg", Range::not_negative(),
            "mass of the tool minus mass of the device's stylus; its weight acts on the hand"),
      field("center_of_mass", &Gravity::center_of_mass, "m",
            "centre of this mass, from the handle's origin Ho, in its frame H"),
      field("acceleration", &Gravity::acceleration, "m/s^2", "gravitational acceleration, in W"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const Gravity& gravity) { require_fields_within(gravity, "Gravity::"); }

/// @param R_WH  orientation of the handle
/// @return about Ho, in W
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Wrench gravity_wrench(const Gravity& gravity, const Mat3& R_WH) {
  const Vec3 weight = gravity.mass * gravity.acceleration;
  return {weight, (R_WH * gravity.center_of_mass).cross(weight)};
}

}  // namespace hapticut
