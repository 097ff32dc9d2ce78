// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/tool/cone.hpp and of the kernels: the springs of a cone.

template <class Real>
struct ConeSprings {
  Real sine, cosine, height, base_radius;

  HAPTICUT_FORMULA explicit ConeSprings(const ConeHead& head)
      : sine(Real(std::sin(head.half_angle))),
        cosine(Real(std::cos(head.half_angle))),
        height(Real(head.height)),
        base_radius(Real(head.base_radius())) {}

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

/// Calls `function(springs)` with the springs of a cone.
template <class Real, class Function>
HAPTICUT_FORMULA decltype(auto) with_springs(const ConeHead& head, const Function& function) {
  return function(ConeSprings<Real>(head));
}
