// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/shapes.hpp and of the kernels: the spring at a point of each shape of head.

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

/// The data of a sphere that the hot loop needs, in the precision of the loop. Each shape has such a struct with the
/// functions `spring` and `margin`; so must a custom shape.
template <class Real>
struct SphereSprings {
  Real radius;

  HAPTICUT_FORMULA explicit SphereSprings(const SphereHead& head) : radius(Real(head.radius)) {}

  struct Central {
    Real depth;    ///< [m] w
    Real inverse;  ///< [1/m] n = x inverse
  };
  /// @param squared  [m^2] |x|^2
  [[nodiscard]] HAPTICUT_FORMULA Central about_center(Real squared) const {
    const Real inverse = inverse_root(max(squared, Real(1e-24)));  // finite in the centre
    return {radius - squared * inverse, inverse};
  }
  [[nodiscard]] HAPTICUT_FORMULA MeridianSpring<Real> spring(Real rho, Real z) const {
    const Central c = about_center(rho * rho + z * z);
    return {c.depth, rho * c.inverse, z * c.inverse};
  }
  [[nodiscard]] HAPTICUT_FORMULA Real margin(Real rho, Real z) const { return radius - sqrt(rho * rho + z * z); }
};

template <class Real>
struct ConeSprings {
  Real sine, cosine, height, base_radius;

  HAPTICUT_FORMULA explicit ConeSprings(const ConeHead& head)
      : sine(Real(std::sin(head.half_angle))),
        cosine(Real(std::cos(head.half_angle))),
        height(Real(head.height)),
        base_radius(Real(head.height * std::tan(head.half_angle))) {}

  [[nodiscard]] HAPTICUT_FORMULA MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = z * sine - rho * cosine, above = height - z, base = depth_below(above, Real(kSmoothScale));
    const auto on_base = base < side;
    return {depth_below_both(side, base), select(on_base, Real(0), cosine), select(on_base, Real(1), -sine),
            select(on_base, square_from_corner(base_radius - rho, above), Real(0))};
  }
  [[nodiscard]] HAPTICUT_FORMULA Real margin(Real rho, Real z) const {
    return min(z * sine - rho * cosine, height - z);
  }
};

template <class Real, FlatRule kRule>
struct FlatSprings {
  Real radius, height;

  HAPTICUT_FORMULA explicit FlatSprings(const FlatHead& head) : radius(Real(head.radius)), height(Real(head.height)) {}

  [[nodiscard]] HAPTICUT_FORMULA MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = radius - rho, above = height - z;
    if constexpr (kRule == FlatRule::bottom_only) {
      return {select(above > 0 && side > 0, z, Real(-1)), Real(0), Real(-1)};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {select(above > 0 && z > 0, side, Real(-1)), Real(1), Real(0)};
    } else if constexpr (kRule == FlatRule::both) {
      // Two parallel springs, side * radial - z * axial, equal one spring of depth |sum| along the sum with the same
      // stored energy: side^2/2 + z^2/2.
      const Real squared = side * side + z * z, inverse = inverse_root(max(squared, Real(1e-24)));
      return {select(margin(rho, z) > 0, squared * inverse, Real(-1)), side * inverse, -z * inverse};
    } else {
      const Real cutting = min(side, z), top = depth_below(above, Real(kSmoothScale));
      const auto on_top = top < cutting, on_side = side < z;
      return {depth_below_both(cutting, top), select(on_top, Real(0), select(on_side, Real(1), Real(0))),
              select(on_top, Real(1), select(on_side, Real(0), Real(-1))),
              select(on_top, square_from_corner(side, above), Real(0))};
    }
  }
  [[nodiscard]] HAPTICUT_FORMULA Real margin(Real rho, Real z) const { return min(min(z, height - z), radius - rho); }
};
