// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "hapticut/tool/shapes.hpp"

namespace hapticut {

/// A ball. Frame origin = centre = spring centre.  `w = R - |x|`, `n = x/|x|`.
struct SphereHead {
  static constexpr char kWord[] = "sphere", kName[] = "SphereHead", kInSentences[] = "a sphere";

  double radius;  ///< [m] radius of the ball

  [[nodiscard]] static SphereHead usual() { return {1 * units::mm}; }
  [[nodiscard]] HeadBox bounding_box() const { return HeadBox::around_axis(radius, -radius, radius); }
  [[nodiscard]] double reach() const { return radius; }
  [[nodiscard]] double volume() const { return 4 * units::kPi / 3 * radius * radius * radius; }
  [[nodiscard]] double cutting_radius() const { return radius; }
  [[nodiscard]] double tip() const { return -radius; }
  [[nodiscard]] std::array<ProfileEdge, 1> edges() const { return {{{0, radius, radius}}}; }
  [[nodiscard]] std::string description() const { return "a sphere of radius " + detail::in_mm(radius); }
};

constexpr auto fields_of(Of<SphereHead>) {
  return std::tuple{field("radius", &SphereHead::radius, "m", Range::positive(), "radius of the ball")};
}

namespace formulas {
#include "hapticut/formulas/sphere.inl"
}  // namespace formulas

using formulas::SphereSprings;

}  // namespace hapticut
