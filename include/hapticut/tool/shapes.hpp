// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

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
/// * `margin(rho, z)`: a function that changes by at most one per unit of length and is positive exactly inside the
///   head, used to skip whole blocks that the head cannot touch.
namespace hapticut {

/// The spring at one point, in the meridian plane; `Spring` is the same in space.
template <class Real>
struct MeridianSpring {
  Real depth;     ///< [m] depth w below the cutting surface; <= 0: outside, no spring; the distance from it, if near
  Real n_radial;  ///< [1] component of n away from the axis
  Real n_axial;   ///< [1] component of n along +z; n is a unit vector from the tool into the material
};

/// A ball. Frame origin = centre = spring centre.  `w = R - |x|`, `n = x/|x|`.
struct SphereHead {
  double radius;
};

constexpr auto fields_of(Of<SphereHead>) {
  return std::tuple{field("radius", &SphereHead::radius, "m", Range::positive(), "of the ball")};
}

/// A cone standing on its apex. Frame origin = apex.  `w = z sin(a) - rho cos(a)`, `n = (cos(a) radial, -sin(a)
/// axial)`. The base disk at z = height carries no spring.
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
  bottom_only,  ///< `w = z`, pushing along the axis
  side_only,    ///< `w = R - rho`, pushing away from the axis
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

/// A cylinder with a cutting bottom disk at z = 0 and a cutting side wall. Frame origin = centre of the bottom disk.
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

/// The part of a shape that the hot loop needs, in the precision of the loop. One of these per shape; a shape of your
/// own offers the same two functions.
template <class Real>
struct SphereSprings {
  Real radius;

  explicit SphereSprings(const SphereHead& head) : radius(Real(head.radius)) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real distance = std::sqrt(rho * rho + z * z);
    const Real inverse = Real(1) / std::max(distance, Real(1e-12));
    return {radius - distance, rho * inverse, z * inverse};
  }
  [[nodiscard]] Real margin(Real rho, Real z) const { return radius - std::sqrt(rho * rho + z * z); }
};

template <class Real>
struct ConeSprings {
  Real sine, cosine, height;

  explicit ConeSprings(const ConeHead& head)
      : sine(Real(std::sin(head.half_angle))), cosine(Real(std::cos(head.half_angle))), height(Real(head.height)) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real depth = z * sine - rho * cosine;
    return {z < height ? depth : Real(-1), cosine, -sine};
  }
  [[nodiscard]] Real margin(Real rho, Real z) const { return std::min(z * sine - rho * cosine, height - z); }
};

template <class Real, FlatRule kRule>
struct FlatSprings {
  Real radius, height;

  explicit FlatSprings(const FlatHead& head) : radius(Real(head.radius)), height(Real(head.height)) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = radius - rho;
    const bool below_top = z < height;
    if constexpr (kRule == FlatRule::bottom_only) {
      return {below_top && side > Real(0) ? z : Real(-1), Real(0), Real(-1)};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {below_top && z > Real(0) ? side : Real(-1), Real(1), Real(0)};
    } else if constexpr (kRule == FlatRule::both) {
      // Two springs in parallel, side * radial - z * axial, are one of depth |sum| along the sum, with the same stored
      // energy: side^2/2 + z^2/2.
      const Real depth = std::sqrt(side * side + z * z);
      const Real inverse = Real(1) / std::max(depth, Real(1e-12));
      return {margin(rho, z) > Real(0) ? depth : Real(-1), side * inverse, -z * inverse};
    } else {
      const bool on_side = side < z;
      return {below_top ? std::min(side, z) : Real(-1), on_side ? Real(1) : Real(0), on_side ? Real(0) : Real(-1)};
    }
  }
  [[nodiscard]] Real margin(Real rho, Real z) const { return std::min(std::min(z, height - z), radius - rho); }
};

}  // namespace hapticut
