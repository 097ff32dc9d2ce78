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
/// * `margin(rho, z)` [m]: a function that changes by at most one per unit of length and is positive exactly inside the
///   head; it serves to skip whole blocks that the head cannot touch.
namespace hapticut {

/// [1] beta: the depth w grows beta times as fast below a smooth surface as below a cutting surface. A wall then
/// presses on a smooth side earlier than on the cutting edges, and the corner leaves less uncut material. The value 2
/// gives the thrust of a drill within 1 % if the layer is a fiftieth of the drill's radius. A larger value would make
/// smooth sides too stiff for single precision and for the coupling.
inline constexpr double kSmoothScale = 2;

/// [m] Depth w at a distance below a surface with a scale of 1 or kSmoothScale. Outside, w equals the (negative)
/// distance for either surface, so that the nearest surface decides there.
template <class Real>
[[nodiscard]] constexpr Real depth_below(Real distance, Real scale) {
  return std::max(distance, scale * distance);
}
/// [m] Distance at a depth w: the inverse of `depth_below`.
template <class Real>
[[nodiscard]] constexpr Real distance_below(Real depth, Real scale) {
  return std::min(depth, depth / scale);
}

/// [m] Depth below two surfaces, one cutting and one smooth, that meet in an edge; outside both, minus the distance
/// from the edge.
template <class Real>
[[nodiscard]] Real depth_below_both(Real one, Real other) {
  return one < 0 && other < 0 ? -std::sqrt(one * one + other * other) : std::min(one, other);
}

/// The spring at one point in the meridian plane; see `Spring` for the spring in space. The depth is the smaller of
/// two: w = min(distance from the cutting surface, beta times distance from the smooth surface). It is zero on the
/// whole surface and continuous inside, so that forces along its gradient produce no energy on any closed path.
template <class Real>
struct MeridianSpring {
  Real depth;       ///< [m] w below the surface; <= 0: outside, no spring; near the surface, minus the distance
  Real n_radial;    ///< [1] component of n away from the axis
  Real n_axial;     ///< [1] component of n along +z; n is a unit vector from the tool into the material
  Real smooth = 0;  ///< [m^2] 0: the surface cuts; else it is smooth, and this is the squared distance from the nearest
                    ///< corner with a cutting surface

  [[nodiscard]] bool on_smooth() const { return smooth > 0; }
  /// [1] Change of w per distance along n, as Spring::scale.
  [[nodiscard]] Real scale() const { return on_smooth() ? Real(kSmoothScale) : Real(1); }
};

/// [m^2] MeridianSpring::smooth of a point at an offset from the corner. It is never zero, so that the corner itself
/// counts as smooth.
template <class Real>
[[nodiscard]] Real square_from_corner(Real along_rho, Real along_z) {
  return along_rho * along_rho + along_z * along_z + Real(1e-24);
}

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

/// The data of a sphere that the hot loop needs, in the precision of the loop. Each shape has such a struct with the
/// functions `spring` and `margin`; so must a custom shape.
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
  Real sine, cosine, height, base_radius;

  explicit ConeSprings(const ConeHead& head)
      : sine(Real(std::sin(head.half_angle))),
        cosine(Real(std::cos(head.half_angle))),
        height(Real(head.height)),
        base_radius(Real(head.height * std::tan(head.half_angle))) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = z * sine - rho * cosine, base = depth_below(height - z, Real(kSmoothScale));
    const Real depth = depth_below_both(side, base);
    if (base < side) return {depth, 0, 1, square_from_corner(base_radius - rho, height - z)};
    return {depth, cosine, -sine};
  }
  [[nodiscard]] Real margin(Real rho, Real z) const { return std::min(z * sine - rho * cosine, height - z); }
};

template <class Real, FlatRule kRule>
struct FlatSprings {
  Real radius, height;

  explicit FlatSprings(const FlatHead& head) : radius(Real(head.radius)), height(Real(head.height)) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = radius - rho;
    [[maybe_unused]] const bool below_top = z < height;
    if constexpr (kRule == FlatRule::bottom_only) {
      return {below_top && side > Real(0) ? z : Real(-1), Real(0), Real(-1)};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {below_top && z > Real(0) ? side : Real(-1), Real(1), Real(0)};
    } else if constexpr (kRule == FlatRule::both) {
      // Two parallel springs, side * radial - z * axial, equal one spring of depth |sum| along the sum with the same
      // stored energy: side^2/2 + z^2/2.
      const Real depth = std::sqrt(side * side + z * z);
      const Real inverse = Real(1) / std::max(depth, Real(1e-12));
      return {margin(rho, z) > Real(0) ? depth : Real(-1), side * inverse, -z * inverse};
    } else {
      const bool on_side = side < z;
      const Real cutting = std::min(side, z), top = depth_below(height - z, Real(kSmoothScale));
      const Real depth = depth_below_both(cutting, top);
      if (top < cutting) return {depth, 0, 1, square_from_corner(side, height - z)};
      return {depth, on_side ? Real(1) : Real(0), on_side ? Real(0) : Real(-1)};
    }
  }
  [[nodiscard]] Real margin(Real rho, Real z) const { return std::min(std::min(z, height - z), radius - rho); }
};

}  // namespace hapticut
