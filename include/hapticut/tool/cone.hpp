// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "hapticut/tool/shapes.hpp"

namespace hapticut {

/// A cone standing on its apex. Frame origin = apex. Below its side `w = z sin(a) - rho cos(a)`, `n = (cos(a) radial,
/// -sin(a) axial)`; the base disk at z = height is smooth.
struct ConeHead {
  static constexpr char kWord[] = "cone", kName[] = "ConeHead", kInSentences[] = "a cone, given by angle and height,";

  double half_angle;  ///< [rad] angle between axis and generatrix, less than pi/2
  double height;      ///< [m] height from the apex to the base

  [[nodiscard]] double base_radius() const { return height * std::tan(half_angle); }  ///< [m]
  [[nodiscard]] static ConeHead usual() { return {30 * units::deg, 2 * units::mm}; }
  [[nodiscard]] HeadBox bounding_box() const { return HeadBox::around_axis(base_radius(), 0, height); }
  [[nodiscard]] double reach() const { return std::hypot(base_radius(), height); }
  [[nodiscard]] double volume() const { return units::kPi / 3 * base_radius() * base_radius() * height; }
  [[nodiscard]] double cutting_radius() const { return base_radius(); }
  [[nodiscard]] double tip() const { return 0; }
  [[nodiscard]] std::array<ProfileEdge, 2> edges() const {
    return {{{base_radius(), height}, {0, height, 0, EdgeKind::smooth}}};
  }
  [[nodiscard]] std::string description() const {
    return "a cone of half angle " + format_number(half_angle / units::deg) + " deg and height " +
           detail::in_mm(height);
  }
  /// @throws Error if the half angle is pi/2
  void validate() const {
    if (!(half_angle < units::kPi / 2))
      throw Error("ConeHead::half_angle"_name + " is " + format_number(half_angle / units::deg) +
                  " deg; must be less than 90 deg (pi/2). Give half of the opening angle.");
  }
};

constexpr auto fields_of(Of<ConeHead>) {
  return std::tuple{
      field("half_angle", &ConeHead::half_angle, "rad", Range{0, units::kPi / 2, true},
            "angle between axis and generatrix, less than pi/2"),
      field("height", &ConeHead::height, "m", Range::positive(), "height from the apex to the base"),
  };
}

namespace formulas {
#include "hapticut/formulas/cone.inl"
}  // namespace formulas

using formulas::ConeSprings;

}  // namespace hapticut
