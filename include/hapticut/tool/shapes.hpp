// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/formulas/numbers.hpp"

/// @file
/// The shapes of cutting heads (docs/model.md, heads; thesis section 5.2.1).
///
/// Tool frame T: +z is the spindle axis, pointing from the cutting tip towards the shank. Every head is a body of
/// revolution about z, so a point enters only by its distance `rho` from the axis and its height `z`, and the direction
/// from the local spring centre through it lies in the same meridian plane.
///
/// Each shape answers two questions:
/// * `spring(rho, z)`: how deep a material point lies below the cutting surface, and in which direction the spring
///   there pushes the material;
/// * `margin(rho, z)` [m]: a function that changes by at most one per unit of length and is positive exactly inside the
///   head; it serves to skip whole blocks that the head cannot touch.
namespace hapticut {

/// [1] beta: the depth w grows beta times as fast below a smooth surface as below a cutting surface. A wall then
/// presses on a smooth side earlier than on the cutting edges, and the corner leaves less uncut material. The value 2
/// gives the thrust of a drill within 1 % if the layer is a fiftieth of the drill's radius. A larger value would make
/// smooth sides too stiff for single precision and for the coupling.
inline constexpr double kSmoothScale = 2;

/// A ball. Frame origin = centre = spring centre.  `w = R - |x|`, `n = x/|x|`.
struct SphereHead {
  double radius;
};

constexpr auto fields_of(Of<SphereHead>) {
  return std::tuple{field("radius", &SphereHead::radius, "m", Range::positive(), "of the ball")};
}

/// A cone standing on its apex. Frame origin = apex. Below its side `w = z sin(a) - rho cos(a)`, `n = (cos(a) radial,
/// -sin(a) axial)`; the base disk at z = height is smooth.
struct ConeHead {
  double half_angle;
  double height;
};

constexpr auto fields_of(Of<ConeHead>) {
  return std::tuple{
      field("half_angle", &ConeHead::half_angle, "rad", Range{0, units::kPi / 2, true},
            "between axis and generatrix, less than pi/2"),
      field("height", &ConeHead::height, "m", Range::positive(), "from the apex to the base"),
  };
}

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
  double radius;
  double height;
  FlatRule rule = FlatRule::nearest;
};

constexpr auto fields_of(Of<FlatHead>) {
  return std::tuple{
      field("radius", &FlatHead::radius, "m", Range::positive(), "of the cylinder"),
      field("height", &FlatHead::height, "m", Range::positive(), "of the side wall"),
      field("rule", &FlatHead::rule, "which surface carries the spring"),
  };
}

namespace formulas {
#include "hapticut/formulas/springs.inl"
}  // namespace formulas

using formulas::ConeSprings;
using formulas::FlatSprings;
using formulas::MeridianSpring;
using formulas::SphereSprings;

}  // namespace hapticut
