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
