// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "hapticut/tool/shapes.hpp"

namespace hapticut {

/// How a flat head chooses between its bottom disk and its side wall.
enum class FlatRule {
  nearest,      ///< the surface with the smaller depth: continuous and conservative (default)
  bottom_only,  ///< `w = z` everywhere in the head, pushing along the axis: not conservative at the side
  side_only,    ///< `w = R - rho` everywhere, pushing away from the axis: not conservative at bottom and top
  both          ///< the sum of the two springs
};

constexpr auto names_of(Of<FlatRule>) {
  using enum FlatRule;
  return std::array{
      Named{nearest, "nearest"},
      Named{bottom_only, "bottom_only"},
      Named{side_only, "side_only"},
      Named{both, "both"},
  };
}

/// A cylinder with a cutting bottom disk at z = 0 and a cutting side wall. The top disk is smooth with rule `nearest`
/// and has no spring with the other rules. Frame origin = centre of the bottom disk.
struct FlatHead {
  static constexpr char kWord[] = "flat", kName[] = "FlatHead", kInSentences[] = "a flat head";

  double radius;                      ///< [m] radius of the cylinder
  double height;                      ///< [m] height of the side wall
  FlatRule rule = FlatRule::nearest;  ///< which surface carries the spring

  [[nodiscard]] static FlatHead usual() { return {1 * units::mm, 2 * units::mm}; }
  [[nodiscard]] HeadBox bounding_box() const { return HeadBox::around_axis(radius, 0, height); }
  [[nodiscard]] double reach() const { return std::hypot(radius, height); }
  [[nodiscard]] double volume() const { return units::kPi * radius * radius * height; }
  [[nodiscard]] double cutting_radius() const { return radius; }
  [[nodiscard]] double tip() const { return 0; }
  /// The surfaces that the rule does not use are smooth.
  [[nodiscard]] std::array<ProfileEdge, 3> edges() const {
    constexpr EdgeKind kCutting = EdgeKind::cutting, kSmooth = EdgeKind::smooth;
    return {{{radius, 0, 0, rule == FlatRule::side_only ? kSmooth : kCutting},
             {radius, height, 0, rule == FlatRule::bottom_only ? kSmooth : kCutting},
             {0, height, 0, kSmooth}}};
  }
  [[nodiscard]] std::string description() const {
    return "a flat head of radius " + detail::in_mm(radius) + " and height " + detail::in_mm(height);
  }
};

constexpr auto fields_of(Of<FlatHead>) {
  return std::tuple{
      field("radius", &FlatHead::radius, "m", Range::positive(), "radius of the cylinder"),
      field("height", &FlatHead::height, "m", Range::positive(), "height of the side wall"),
      field("rule", &FlatHead::rule, "which surface carries the spring"),
  };
}

namespace formulas {
#include "hapticut/formulas/flat.inl"
}  // namespace formulas

using formulas::FlatSprings;

}  // namespace hapticut
