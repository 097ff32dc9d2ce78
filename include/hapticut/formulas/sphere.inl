// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/sphere.hpp and of the kernels: the springs of a ball.

template <class Real>
struct SphereSprings {
  static constexpr bool kCentral = true, kSmooth = false;
  Real radius;
  float outer;  ///< [m] radius, for the bound

  HAPTICUT_FORMULA explicit SphereSprings(const SphereHead& head)
      : radius(Real(head.radius)), outer(float(head.radius)) {}

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

  [[nodiscard]] HAPTICUT_FORMULA SpatialSpring<Real> at(Real x, Real y, Real z) const {
    const auto [depth, inverse] = about_center(x * x + (y * y + z * z));
    return {depth, inverse, z * inverse, Real(0)};
  }
  struct Grown {
    float squared;
    [[nodiscard]] HAPTICUT_FORMULA auto hits(Real x, Real y, Real z) const {
      return x * x + (y * y + z * z) < Real(squared);
    }
  };
  [[nodiscard]] HAPTICUT_FORMULA Grown grown(float margin) const {
    const float r = std::max(0.0F, outer + margin);
    return {r * r};
  }
};

/// Calls `function(springs)` with the springs of a ball.
template <class Real, class Function>
HAPTICUT_FORMULA decltype(auto) with_springs(const SphereHead& head, const Function& function) {
  return function(SphereSprings<Real>(head));
}
