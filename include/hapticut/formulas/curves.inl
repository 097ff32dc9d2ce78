// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/profile_table.hpp and of the kernels: the spring at a point of a profile.

/// A line or an arc of a meridian; see ProfileCurves.
template <class Real>
struct CurveSprings {
  Real rho, z;                ///< [m] starting point p
  Real normal_rho, normal_z;  ///< [1] m
  Real curvature;             ///< [1/m] k
  Real scale;                 ///< [1] s

  /// The spring of the curve alone; MeridianSpring::smooth is not set.
  [[nodiscard]] HAPTICUT_FORMULA MeridianSpring<Real> spring(Real at_rho, Real at_z) const {
    const Real q_rho = at_rho - rho, q_z = at_z - z, inward = normal_rho * q_rho + normal_z * q_z;
    const auto straight = curvature == 0;
    if (all(straight)) return {depth_below(inward, scale), -normal_rho, -normal_z};
    const Real twice = inward + inward - curvature * (q_rho * q_rho + q_z * q_z);
    const Real g_rho = curvature * q_rho - normal_rho, g_z = curvature * q_z - normal_z;
    const Real squared = g_rho * g_rho + g_z * g_z, inverse = inverse_root(max(squared, Real(1e-24)));
    // A line among arcs gives the same bits as alone: a result must not depend on the other voxels of a vector.
    const Real distance = select(straight, inward, twice / (1 + squared * inverse));
    return {depth_below(distance, scale), select(straight, -normal_rho, g_rho * inverse),
            select(straight, -normal_z, g_z * inverse)};
  }
  /// Where points are beyond the starting point, towards the shank: the tangent is m rotated by -90 degrees.
  [[nodiscard]] HAPTICUT_FORMULA auto begins_before(Real at_rho, Real at_z) const {
    return normal_z * (at_rho - rho) >= normal_rho * (at_z - z);
  }
};

/// [m^2] MeridianSpring::smooth at a point, from the nearest corner.
template <class Real, class Corners>
HAPTICUT_FORMULA Real square_from_corners(const Corners& corners, Real rho, Real z) {
  Real nearest = Real(1e30F);
  for (const auto& corner : corners)
    nearest = min(nearest, square_from_corner(rho - Real(corner.rho), z - Real(corner.z)));
  return nearest;
}

/// The spring of the curve that decides among those that were asked so far.
template <class Real>
struct DecidingCurve {
  MeridianSpring<Real> spring;
  Real scale;  ///< [1] scale of the curve

  HAPTICUT_FORMULA DecidingCurve(const CurveSprings<Real>& curve, Real rho, Real z)
      : spring(curve.spring(rho, z)), scale(curve.scale) {}

  /// Asks one more curve, by a rule.
  HAPTICUT_FORMULA void decide(CellRule rule, const CurveSprings<Real>& curve, Real rho, Real z) {
    const Real positive = max(scale, Real(1));
    const auto always = positive > 0, never = positive < 0;
    decide(rule == CellRule::nearer ? always : never, rule == CellRule::farther ? always : never,
           rule == CellRule::sides ? always : never, curve, rho, z);
  }
  /// Asks one more curve, by the rule that applies to each voxel.
  template <class Condition>
  HAPTICUT_FORMULA void decide(Condition nearer, Condition farther, Condition sides, const CurveSprings<Real>& curve,
                               Real rho, Real z) {
    const DecidingCurve other(curve, rho, z);
    const auto lesser = other.spring.depth < spring.depth;
    const auto is_edge_of_both = nearer && scale != other.scale;
    const Real of_both = any(is_edge_of_both) ? depth_below_both(spring.depth, other.spring.depth) : Real(0);
    const auto chosen =
        (nearer && lesser) || (farther && other.spring.depth > spring.depth) || (sides && curve.begins_before(rho, z));
    spring.depth = select(is_edge_of_both, of_both, select(chosen, other.spring.depth, spring.depth));
    spring.n_radial = select(chosen, other.spring.n_radial, spring.n_radial);
    spring.n_axial = select(chosen, other.spring.n_axial, spring.n_axial);
    scale = select(chosen, other.scale, scale);
  }

  /// The spring of a profile, whose curves end where they leave the head.
  /// @param profile  its `radius`, `bottom`, `top` and `corners`
  /// @param outside  known to be outside the head
  template <class Bounds, class Condition>
  HAPTICUT_FORMULA MeridianSpring<Real> bounded(const Bounds& profile, Condition outside, Real rho, Real z) const {
    const Real beyond = max(rho - Real(profile.radius), max(Real(profile.bottom) - z, z - Real(profile.top)));
    MeridianSpring<Real> found = spring;
    found.depth = select((outside || beyond >= 0) && found.depth > 0, Real(-1), found.depth);
    found.depth = select(beyond > 0, min(found.depth, -beyond), found.depth);
    const auto is_smooth = scale > 1;
    found.smooth = Real(0);
    if (!any(is_smooth)) return found;
    found.smooth = select(is_smooth, square_from_corners(profile.corners, rho, z), Real(0));
    return found;
  }
};
