// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/flat.hpp and of the kernels: the springs of a flat head.

template <class Real, FlatRule kRule>
struct FlatSprings {
  static constexpr bool kCentral = false, kSmooth = kRule == FlatRule::nearest;
  Real radius, height;
  float outer, upper;  ///< [m] radius and height, for the bound

  HAPTICUT_FORMULA explicit FlatSprings(const FlatHead& head)
      : radius(Real(head.radius)), height(Real(head.height)), outer(float(head.radius)), upper(float(head.height)) {}

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

  [[nodiscard]] HAPTICUT_FORMULA SpatialSpring<Real> at(Real x, Real y, Real z) const {
    return about_axis(*this, x, y, z);
  }
  struct Grown {
    float squared, bottom, top;
    [[nodiscard]] HAPTICUT_FORMULA auto hits(Real x, Real y, Real z) const {
      return x * x + y * y < Real(squared) && (z > Real(bottom) && z < Real(top));
    }
  };
  [[nodiscard]] HAPTICUT_FORMULA Grown grown(float margin) const {
    const float r = std::max(0.0F, outer + margin);
    return {r * r, -margin, upper + margin};
  }
};

/// Calls `function(springs)` with the springs of a flat head.
template <class Real, class Function>
HAPTICUT_FORMULA decltype(auto) with_springs(const FlatHead& head, const Function& function) {
  switch (head.rule) {
    case FlatRule::bottom_only:
      return function(FlatSprings<Real, FlatRule::bottom_only>(head));
    case FlatRule::side_only:
      return function(FlatSprings<Real, FlatRule::side_only>(head));
    case FlatRule::both:
      return function(FlatSprings<Real, FlatRule::both>(head));
    case FlatRule::nearest:
      break;
  }
  return function(FlatSprings<Real, FlatRule::nearest>(head));
}
