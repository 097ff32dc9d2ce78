// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/shapes.hpp and of the kernels: what the springs of all shapes of head have in common.

/// [m] Depth w at a distance below a surface with a scale of 1 or kSmoothScale. Outside, w equals the (negative)
/// distance for either surface, so that the nearest surface decides there.
template <class Real>
[[nodiscard]] HAPTICUT_FORMULA Real depth_below(Real distance, Real scale) {
  return max(distance, scale * distance);
}
/// [m] Distance at a depth w: the inverse of `depth_below`.
template <class Real>
[[nodiscard]] HAPTICUT_FORMULA Real distance_below(Real depth, Real scale) {
  return min(depth, depth * reciprocal(scale));
}

/// [m] Depth below two surfaces, one cutting and one smooth, that meet in an edge; outside both, minus the distance
/// from the edge.
template <class Real>
[[nodiscard]] HAPTICUT_FORMULA Real depth_below_both(Real one, Real other) {
  const Real lesser = min(one, other);
  const auto outside = max(one, other) < 0;
  if (!any(outside)) return lesser;
  return select(outside, -sqrt(one * one + other * other), lesser);
}

/// [m^2] MeridianSpring::smooth of a point at an offset from the corner. It is never zero, so that the corner itself
/// counts as smooth.
template <class Real>
[[nodiscard]] HAPTICUT_FORMULA Real square_from_corner(Real along_rho, Real along_z) {
  return along_rho * along_rho + (along_z * along_z + Real(1e-24));
}

/// The spring at one point in the meridian plane; see `Spring` for the spring in space. The depth is the smaller of
/// two: w = min(distance from the cutting surface, beta times distance from the smooth surface). It is zero on the
/// whole surface and continuous inside, so that forces along its gradient produce no energy on any closed path.
template <class Real>
struct MeridianSpring {
  Real depth;             ///< [m] w below the surface; <= 0: outside, no spring; near the surface, minus the distance
  Real n_radial;          ///< [1] component of n away from the axis
  Real n_axial;           ///< [1] component of n along +z; n is a unit vector from the tool into the material
  Real smooth = Real(0);  ///< [m^2] 0: the surface cuts; else it is smooth, and this is the squared distance from the
                          ///< nearest corner with a cutting surface

  [[nodiscard]] HAPTICUT_FORMULA auto on_smooth() const { return smooth > 0; }
  /// [1] Change of w per distance along n, as Spring::scale.
  [[nodiscard]] HAPTICUT_FORMULA Real scale() const { return select(on_smooth(), Real(kSmoothScale), Real(1)); }
};

/// The spring at a point (x, y, z) of a body of revolution: its normal lies in the plane through the spindle's axis,
/// n = (x radial, y radial, axial).
template <class Real>
struct SpatialSpring {
  Real depth;   ///< [m] w
  Real radial;  ///< [1/m]
  Real axial;   ///< [1]
  Real smooth;  ///< [m^2] as MeridianSpring::smooth
};

/// The spring at a point, from that in its half-plane.
template <class Springs, class Real>
[[nodiscard]] HAPTICUT_FORMULA SpatialSpring<Real> about_axis(const Springs& springs, Real x, Real y, Real z) {
  const Real squared = x * x + y * y, inverse_rho = inverse_root(max(squared, Real(1e-24)));  // finite on the axis
  const MeridianSpring<Real> spring = springs.spring(squared * inverse_rho, z);
  return {spring.depth, spring.n_radial * inverse_rho, spring.n_axial, spring.smooth};
}

// The springs of each shape have these functions:
// * `spring(rho, z)`: the spring at a point of the meridian plane, also outside the head.
// * `margin(rho, z)` [m]: changes by at most one per unit of length, and is positive exactly inside the head. It serves
//   to skip whole blocks that the head cannot touch.
// The kernels also need:
// * `at(x, y, z)`: the spring at a point in space.
// * `grown(margin)`: a bound of the head grown by `margin` [m]. Its `hits(x, y, z)` takes no square root. With a margin
//   >= 0 it is true at each point nearer to the head than the margin, and may be true at others. With a negative margin
//   it is true only at points deeper than -margin, and may be false everywhere, as that of a profile.
// * `kCentral`: all normals meet in the head's origin, so that the springs have no torque about it.
// * `kSmooth`: some of the surface may be smooth.
// A function `with_springs<Real>(shape, function)` beside them calls `function(springs)`.
