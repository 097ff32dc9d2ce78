// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/contact/cut_voxel.hpp and of the kernels: how a layer becomes thinner while it is cut.

/// tanh(y)/y = p/q with polynomials of s = y^2, within 2e-7 for all y. r = (q - p)/s gives (1 - tanh(y)/y)/s = r/q
/// without cancellation. The coefficients minimise the largest relative error up to s = kFar.
template <class Real>
struct TanhQuotient {
  Real p, q, r;

  static constexpr float kFar = 64;  ///< from here on tanh(y) is 1 within 2.3e-7

  HAPTICUT_FORMULA static TanhQuotient of(Real s) {
    constexpr double p1 = 0.12930343, p2 = 0.0029557954, p3 = 1.147499e-05;
    constexpr double q1 = 0.46263597, q2 = 0.023835734, q3 = 0.00023931324, q4 = 2.4731951e-07;
    const Real near = min(s, Real(kFar));
    TanhQuotient t;
    t.p = ((Real(p3) * near + Real(p2)) * near + Real(p1)) * near + 1;
    t.q = (((Real(q4) * near + Real(q3)) * near + Real(q2)) * near + Real(q1)) * near + 1;
    t.r = ((Real(q4) * near + Real(q3 - p3)) * near + Real(q2 - p2)) * near + Real(q1 - p1);
    const auto far = s > Real(kFar);
    if (!any(far)) return t;
    const Real inverse = inverse_root(max(s, Real(kFar)));
    t.p = select(far, inverse, t.p);
    t.q = select(far, Real(1), t.q);
    t.r = select(far, (1 - inverse) * inverse * inverse, t.r);
    return t;
  }
};

/// Mean of e^-s over 0 <= s <= x: (1 - e^-x)/x = T/(1 + y T) with y = x/2, T = tanh(y)/y; within 4e-7, x < 1e19.
template <class Real>
HAPTICUT_FORMULA Real mean_of_decay(Real x) {
  const Real y = Real(0.5) * x;
  const auto t = TanhQuotient<Real>::of(y * y);
  return t.p * reciprocal(t.q + y * t.p);
}

/// How much thinner the layer in contact becomes in a sub-step. Its top approaches with the head's speed v and recedes
/// as it is cut,
///
///     t' = v - k_d (t^2 - w0^2),   k_d = kappa k_v s / (2 u)
///
/// The solution tends to t = sqrt(w0^2 + v/k_d), for any stiffness of the foundation and any length of the step.
template <class Real>
struct LayerRecession {
  Real relative;  ///< [1] r: recession over the whole sub-step, relative to k_d (t^2 - w0^2) dt at the given depth

  /// In any units of length and time.
  /// @param top       [m] t at the evaluation of the contact if nothing were cut before; > w0
  /// @param cut       [m] w0
  /// @param rate      [1/(m s)] k_d
  /// @param speed     [m/s] v >= 0
  /// @param duration  [s]
  /// @param at_end    whether the contact is evaluated at the end of the sub-step instead of its middle. The time after
  ///                  the evaluation is then as long as the time before it with t > w0, so that a touch begins with no
  ///                  removal
  HAPTICUT_FORMULA static LayerRecession of(Real top, const CutDepth<Real>& cut, Real rate, Real speed, Real duration,
                                            bool at_end) {
    const Real half = Real(0.5) * duration, w0_squared = cut.threshold * cut.threshold;
    const Real deeper = max(Real(0), min(top, cut.beyond(top)));
    Real before = half;  // [s] with t > w0 before the evaluation
    if (const auto touched = speed * half > deeper; any(touched))
      before = select(touched, deeper / max(speed, Real(1e-20F)), half);
    const Real time = before + (at_end ? before : half), t = max(cut.threshold, top - speed * before);
    const Real gain = rate * w0_squared + speed;
    const auto c = TanhQuotient<Real>::of(time * time * rate * gain);  // y = k_d T_e time
    const Real removed = time * c.p * (t * t - w0_squared) + speed * time * time * (time * gain * c.r + t * c.p);
    const Real slowed = (c.q + t * rate * time * c.p) * (duration * cut.excess);
    return {removed / max(slowed, Real(1e-36F))};
  }
};
