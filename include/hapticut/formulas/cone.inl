// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/cone.hpp and of the kernels: the springs of a cone.

template <class Real>
struct ConeSprings {
  static constexpr bool kCentral = false, kSmooth = true;
  Real sine, cosine, height, base_radius;
  float tangent, per_cosine, upper;  ///< [1], [1], [m] for the bound

  HAPTICUT_FORMULA explicit ConeSprings(const ConeHead& head)
      : sine(Real(std::sin(head.half_angle))),
        cosine(Real(std::cos(head.half_angle))),
        height(Real(head.height)),
        base_radius(Real(head.base_radius())),
        tangent(float(std::tan(head.half_angle))),
        per_cosine(float(1 / std::cos(head.half_angle))),
        upper(float(head.height)) {}

  [[nodiscard]] HAPTICUT_FORMULA MeridianSpring<Real> spring(Real rho, Real z) const {
    const Real side = z * sine - rho * cosine, above = height - z, base = depth_below(above, Real(kSmoothScale));
    const auto on_base = base < side;
    return {depth_below_both(side, base), select(on_base, Real(0), cosine), select(on_base, Real(1), -sine),
            select(on_base, square_from_corner(base_radius - rho, above), Real(0))};
  }
  [[nodiscard]] HAPTICUT_FORMULA Real margin(Real rho, Real z) const {
    return min(z * sine - rho * cosine, height - z);
  }

  [[nodiscard]] HAPTICUT_FORMULA SpatialSpring<Real> at(Real x, Real y, Real z) const {
    return about_axis(*this, x, y, z);
  }
  struct Grown {
    float tangent, wider, top;
    [[nodiscard]] HAPTICUT_FORMULA auto hits(Real x, Real y, Real z) const {
      const Real edge = z * Real(tangent) + Real(wider);
      return x * x + y * y < edge * edge && (edge > 0 && z < Real(top));
    }
  };
  [[nodiscard]] HAPTICUT_FORMULA Grown grown(float margin) const {
    return {tangent, margin * per_cosine, upper + margin};
  }
};

/// Calls `function(springs)` with the springs of a cone.
template <class Real, class Function>
HAPTICUT_FORMULA decltype(auto) with_springs(const ConeHead& head, const Function& function) {
  return function(ConeSprings<Real>(head));
}
