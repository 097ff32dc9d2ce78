// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// Integrals over a voxel that the interface between head and material crosses.
///
/// The remaining material of a voxel lies on the side away from the head: it is the part of the cube beyond a plane
/// across the head's normal n. Neighbouring voxels are not needed. Along n the cube is modelled as the convolution of
/// two boxes (a trapezoid):
///
///     widths   p = max |n_i|,  q = sqrt(1 - p^2)      [voxel edges], n in the grid's axes
///
///     section  A(v)        ____________
///                         /            \           v: distance from the corner farthest from the head, towards it
///                        /              \          h = p + q: the corner nearest to the head
///                       /                \         V(v) = integral of A: filled fraction
///                      0   q          p   h
///
/// The exact section of a cube is the convolution of three boxes of width |n_i|. The sections of all voxels that a
/// plane crosses add up to the plane, at any position of the plane, because one box is as wide as a step of the grid
/// along n: the largest, p. The other two boxes matter only through their variance, and q has the same variance. The
/// force of a thin layer, pressure times section, therefore does not ripple as grid points enter and leave, in any
/// direction of the grid (docs/decisions/0009-cut-voxels.md).
namespace hapticut {

/// [voxel edges] A voxel whose centre is this far outside the head cannot reach into it: half of its largest p + q.
inline constexpr float kVoxelReach = 0.70710678F;

/// [1] 1/sqrt(3): the smallest possible value of the largest component of a unit vector.
inline constexpr float kMinMaxNorm = 0.57735027F;

/// Integrals of a law over the filled part of one voxel, for an edge length l = 1, relative to the volume of the voxel.
template <class Real>
struct DepthIntegrals {
  Real depth;    ///< integral of max(w, 0)
  Real cutting;  ///< integral of w where w > w0
  Real volume;   ///< integral of 1 where w > 0
  Real energy;   ///< integral of max(w, 0)^2 / 2
};

/// The depth from which on material is cut.
template <class Real>
struct CutDepth {
  Real threshold;  ///< w0
  Real excess;  ///< top^2 - w0^2, top: the largest depth of the part; <= 0: nothing is cut. Precise where it is small

  static CutDepth of(Real top, Real threshold) { return {threshold, (top - threshold) * (top + threshold)}; }
  /// top - w0, not below 0
  [[nodiscard]] Real beyond(Real top) const { return excess > 0 ? excess / (top + threshold) : Real(0); }
  /// The values in another unit of length.
  [[nodiscard]] CutDepth scaled(Real factor) const { return {threshold * factor, excess * factor * factor}; }
};

/// A voxel seen along n.
template <class Real>
class VoxelSection {
 public:
  /// [1] While material is cut, a narrower box is widened to this; no sum over voxels changes. Cutting of the next
  /// voxel begins before the last part of the voxel above it is removed, so the force dips at the change of layers. A
  /// longer overlap makes the dip smaller: along the grid 2.1 % at 0.05 and 0.5 % at 0.3.
  static constexpr Real kMinWidth = Real(0.3);
  /// [1] The same for a head whose spindle is off, under which layers change only by crushing. The relative error of a
  /// static force on a face of the grid is (width l/depth)^2/12: with 0.3 a flat head pressed with 0.5 N would feel up
  /// to five times that.
  static constexpr Real kMinStandingWidth = Real(0.01);

  /// @param max_component  [1] the largest |n_i| along the grid's axes, 1/sqrt(3) ... 1
  /// @param min_width      [1] kMinWidth or kMinStandingWidth
  explicit VoxelSection(Real max_component, Real min_width = kMinWidth)
      : p_(max_component), q_(std::max(std::sqrt(std::max(Real(0), 1 - max_component * max_component)), min_width)) {}

  /// [1] h: length from the far corner to the near corner
  [[nodiscard]] Real span() const { return p_ + q_; }

  /// [1] Distance of the plane from the far corner when the fraction `fill` of the voxel is filled.
  [[nodiscard]] Real height_of(Real fill) const {
    const Real wide = std::max(p_, q_), narrow = std::min(p_, q_);
    const Real smaller = std::min(fill, 1 - fill);
    const Real height = 2 * wide * smaller <= narrow ? std::sqrt(std::max(Real(0), 2 * wide * narrow * smaller))
                                                     : wide * smaller + narrow / 2;
    return fill <= Real(0.5) ? height : span() - height;
  }

  /// [1] Area of the section at a height.
  [[nodiscard]] Real area_at(Real height) const {
    const auto ramp = [](Real x) { return std::max(Real(0), x); };
    return std::max(Real(0), ramp(height) - ramp(height - p_) - ramp(height - q_)) / (p_ * q_);
  }
  /// [1] Filled fraction below a height <= span(): the inverse of `height_of`.
  [[nodiscard]] Real fill_below(Real height) const {
    const auto square = [](Real x) { return x > 0 ? x * x : Real(0); };
    return (square(height) - square(height - p_) - square(height - q_)) / (2 * p_ * q_);
  }

  /// @param height  [1] of the filled part, from `height_of`
  /// @param depth   [1] > 0, of the top of the filled part
  /// @param cut     [1] cut depth for that top
  [[nodiscard]] DepthIntegrals<Real> integrals(Real height, Real depth, const CutDepth<Real>& cut) const {
    const Real deep = cut.beyond(depth), threshold = cut.threshold;
    Real all = 0, beyond = 0, volume = 0, deep_volume = 0, energy = 0;
    // A(v) (p q) = v - max(v - p, 0) - max(v - q, 0) below the near corner. Written so that nothing cancels where the
    // layer in contact is thin.
    for (const auto& [corner, sign] : {Ramp{0, 1}, Ramp{p_, -1}, Ramp{q_, -1}}) {
      const Real x = std::max(Real(0), height - corner);
      all += sign * integral_of_ramp(x, depth);
      beyond += sign * integral_of_ramp(x, deep);
      volume += sign * volume_of_ramp(x, depth);
      deep_volume += sign * volume_of_ramp(x, deep);
      energy += sign * square_of_ramp(x, depth);
    }
    const Real inverse = 1 / (p_ * q_);
    return {all * inverse, (beyond + threshold * deep_volume) * inverse, volume * inverse, energy * inverse};
  }

  [[nodiscard]] DepthIntegrals<Real> integrals(Real height, Real depth) const {
    return integrals(height, depth, CutDepth<Real>::of(depth, Real(0)));
  }

 private:
  struct Ramp {
    Real corner, sign;
  };
  /// Integral of 1 over the last part, of length d, of the ramp u = 0 ... x.
  static Real volume_of_ramp(Real x, Real d) {
    const Real m = std::min(x, d);
    return m * (2 * x - m) / 2;
  }
  /// Integral of the depth u - (x - d) over that part.
  static Real integral_of_ramp(Real x, Real d) {
    const Real shorter = std::min(x, d), longer = std::max(x, d);
    return shorter * shorter * (3 * longer - shorter) / 6;
  }
  /// Integral of half the square of that depth.
  static Real square_of_ramp(Real x, Real d) {
    return d < x ? d * d * d * (4 * x - d) / 24 : x * x * (x * x - 4 * x * d + 6 * d * d) / 24;
  }

  Real p_, q_;
};

/// How much thinner the layer in contact becomes in a sub-step. Its top approaches with the head's speed v and recedes
/// as it is cut,
///
///     t' = v - k_d (t^2 - w0^2),   k_d = kappa k_v s / (2 u)
///
/// The solution tends to t = sqrt(w0^2 + v/k_d), for any stiffness of the foundation and any length of the step.
template <class Real>
struct LayerRecession {
  Real relative;  ///< [1] r: recession over the whole sub-step, relative to k_d (t^2 - w0^2) dt at the given depth

  /// @param top      [m] t at the evaluation of the contact if nothing were cut before; > w0
  /// @param cut      [m] w0
  /// @param rate     [1/(m s)] k_d
  /// @param speed    [m/s] v >= 0
  /// @param duration [s]
  /// @param at_end   whether the contact is evaluated at the end of the sub-step instead of its middle. The time after
  ///                 the evaluation is then as long as the time before it with t > w0, so that a touch begins with no
  ///                 removal
  static LayerRecession of(Real top, const CutDepth<Real>& cut, Real rate, Real speed, Real duration, bool at_end) {
    const Real threshold = cut.threshold, half = duration / 2;
    const Real deeper = std::max(Real(0), std::min(top, cut.beyond(top)));
    const Real before = speed * half > deeper ? deeper / speed : half;  // [s] with t > w0 before the evaluation
    const Real after = at_end ? before : half;
    const Real time = before + after, t = std::max(threshold, top - speed * before);
    const Real balance = time * time * rate * (rate * threshold * threshold + speed);  // y^2, y = k_d T_e time
    const Real c = tanh_over(balance);                                                 // tanh(y) / y
    // (1 - c) / y^2, by its series where the difference cancels
    const Real residual = balance < Real(0.01) ? Real(1.0 / 3) - balance * Real(2.0 / 15) : (1 - c) / balance;
    const Real removed = time * c * (t * t - threshold * threshold) +
                         speed * time * time * (time * (rate * threshold * threshold + speed) * residual + t * c);
    return {removed / ((1 + t * rate * time * c) * duration * cut.excess)};
  }

  /// tanh(sqrt(y2)) / sqrt(y2)
  static Real tanh_over(Real y2) {
    if (y2 < Real(0.01)) return 1 - y2 * (Real(1.0 / 3) - y2 * Real(2.0 / 15));
    const Real y = std::sqrt(y2);
    return std::tanh(y) / y;
  }
};

}  // namespace hapticut
