// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// A voxel that the interface between head and material crosses, integrated instead of sampled.
///
/// What is left of a voxel lies on the far side from the head: it is the part of the cube beyond a plane across the
/// head's normal n. No neighbour is asked. Along n the cube is seen as the fold of two boxes (a trapezoid):
///
///     widths   p = max |n_i|,  q = sqrt(1 - p^2)      [voxel edges], n in the grid's axes
///
///     section  A(v)        ____________
///                         /            \           v: distance from the corner farthest from the head, towards it
///                        /              \          h = p + q: the corner nearest to the head
///                       /                \         V(v) = integral of A: filled fraction
///                      0   q          p   h
///
/// The true cube is the fold of three boxes |n_i|. What makes the sections of all voxels that a plane crosses add up to
/// the plane itself, wherever it lies, is that one box is as wide as a step of the grid along n: the largest, p. The
/// other two matter through their variance only, which q has. So the force of a thin layer, pressure times section,
/// does not ripple as lattice points come and go, in any direction of the grid (docs/decisions/0009-cut-voxels.md).
namespace hapticut {

/// [voxel edges] A voxel whose centre is this far outside the head cannot reach into it: half of its largest p + q.
inline constexpr float kVoxelReach = 0.70710678F;

/// [1] 1/sqrt(3): no unit vector's largest component is less.
inline constexpr float kMinMaxNorm = 0.57735027F;

/// What a law integrates over the filled part of one voxel, per edge length l = 1 and of the whole voxel's volume.
template <class Real>
struct DepthIntegrals {
  Real depth;    ///< integral of max(w, 0)
  Real cutting;  ///< integral of w where w > w0
  Real volume;   ///< of what is deeper than 0
  Real energy;   ///< integral of max(w, 0)^2 / 2
};

/// From which depth on material is cut.
template <class Real>
struct CutDepth {
  Real least;   ///< w0
  Real excess;  ///< top^2 - w0^2 of a part's greatest depth; <= 0: none of it is cut. Precise where it is small

  static CutDepth of(Real top, Real least) { return {least, (top - least) * (top + least)}; }
  /// top - w0, not below 0
  [[nodiscard]] Real beyond(Real top) const { return excess > 0 ? excess / (top + least) : Real(0); }
  /// In another unit of length.
  [[nodiscard]] CutDepth scaled(Real factor) const { return {least * factor, excess * factor * factor}; }
};

/// A voxel seen along n.
template <class Real>
class VoxelSection {
 public:
  /// [1] A narrower box is widened to this, which changes no sum over voxels. The next voxel begins to be cut before
  /// the last of one that covers it is gone, so the force dips as layers change, the less the longer they overlap:
  /// along the grid 2.1 % at 0.05 and 0.5 % at 0.3. Static forces are off by (width l/depth)^2/12 there.
  static constexpr Real kMinWidth = Real(0.3);

  /// @param largest  [1] the largest |n_i| along the grid's axes, 1/sqrt(3) ... 1
  explicit VoxelSection(Real largest)
      : p_(largest), q_(std::max(std::sqrt(std::max(Real(0), 1 - largest * largest)), kMinWidth)) {}

  /// [1] h: from the far corner to the near one
  [[nodiscard]] Real span() const { return p_ + q_; }

  /// [1] distance of the plane from the far corner, where a part `fill` of the voxel lies beyond it
  [[nodiscard]] Real height_of(Real fill) const {
    const Real wide = std::max(p_, q_), narrow = std::min(p_, q_);
    const Real less = std::min(fill, 1 - fill);
    const Real height =
        2 * wide * less <= narrow ? std::sqrt(std::max(Real(0), 2 * wide * narrow * less)) : wide * less + narrow / 2;
    return fill <= Real(0.5) ? height : span() - height;
  }

  /// [1] area of the section at a height
  [[nodiscard]] Real area_at(Real height) const {
    const auto ramp = [](Real x) { return std::max(Real(0), x); };
    return std::max(Real(0), ramp(height) - ramp(height - p_) - ramp(height - q_)) / (p_ * q_);
  }
  /// [1] filled fraction below a height <= span(): the inverse of `height_of`
  [[nodiscard]] Real fill_below(Real height) const {
    const auto square = [](Real x) { return x > 0 ? x * x : Real(0); };
    return (square(height) - square(height - p_) - square(height - q_)) / (2 * p_ * q_);
  }

  /// @param height  [1] of the filled part, from `height_of`
  /// @param depth   [1] > 0 of the top of the filled part
  /// @param cut     [1] of that top
  [[nodiscard]] DepthIntegrals<Real> integrals(Real height, Real depth, const CutDepth<Real>& cut) const {
    const Real deep = cut.beyond(depth), least = cut.least;
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
    return {all * inverse, (beyond + least * deep_volume) * inverse, volume * inverse, energy * inverse};
  }

  [[nodiscard]] DepthIntegrals<Real> integrals(Real height, Real depth) const {
    return integrals(height, depth, CutDepth<Real>::of(depth, Real(0)));
  }

 private:
  struct Ramp {
    Real corner, sign;
  };
  /// integral over the ramp u = 0 ... x, of its last part of length d
  static Real volume_of_ramp(Real x, Real d) {
    const Real m = std::min(x, d);
    return m * (2 * x - m) / 2;
  }
  /// of the depth u - (x - d) there
  static Real integral_of_ramp(Real x, Real d) {
    const Real m = std::min(x, d), most = std::max(x, d);
    return m * m * (3 * most - m) / 6;
  }
  /// and of half its square
  static Real square_of_ramp(Real x, Real d) {
    return d < x ? d * d * d * (4 * x - d) / 24 : x * x * (x * x - 4 * x * d + 6 * d * d) / 24;
  }

  Real p_, q_;
};

/// How much thinner the layer in contact becomes in a sub-step, by the equation of its top: it comes nearer with the
/// head's speed v and recedes as it is cut,
///
///     t' = v - k_d (t^2 - w0^2),   k_d = kappa k_v s / (2 u)
///
/// which tends to t = sqrt(w0^2 + v/k_d) however stiff the foundation and long the step are.
template <class Real>
struct LayerRecession {
  Real share;  ///< [1] recession over that of the given depth, k_d (t^2 - w0^2) dt, for the whole sub-step

  /// @param top      [m] t where the contact is evaluated, if nothing were cut before; > w0
  /// @param cut      [m] w0
  /// @param rate     [1/(m s)] k_d
  /// @param speed    [m/s] v >= 0
  /// @param duration [s]
  /// @param at_end   whether the contact is evaluated at the end of the sub-step, in place of its middle: it stands for
  /// as much of what follows as it was deeper than w0 before, so that a touch begins with nothing
  static LayerRecession of(Real top, const CutDepth<Real>& cut, Real rate, Real speed, Real duration, bool at_end) {
    const Real least = cut.least, half = duration / 2;
    const Real deeper = std::max(Real(0), std::min(top, cut.beyond(top)));
    const Real before = speed * half > deeper ? deeper / speed : half;  // [s] deeper than w0, and then
    const Real after = at_end ? before : half;
    const Real time = before + after, t = std::max(least, top - speed * before);
    const Real balance = time * time * rate * (rate * least * least + speed);  // y^2, y = k_d T_e time
    const Real c = tanh_over(balance);                                         // tanh(y) / y
    // (1 - c) / y^2, by its series where the difference cancels
    const Real lack = balance < Real(0.01) ? Real(1.0 / 3) - balance * Real(2.0 / 15) : (1 - c) / balance;
    const Real gone = time * c * (t * t - least * least) +
                      speed * time * time * (time * (rate * least * least + speed) * lack + t * c);
    return {gone / ((1 + t * rate * time * c) * duration * cut.excess)};
  }

  /// tanh(sqrt(y2)) / sqrt(y2)
  static Real tanh_over(Real y2) {
    if (y2 < Real(0.01)) return 1 - y2 * (Real(1.0 / 3) - y2 * Real(2.0 / 15));
    const Real y = std::sqrt(y2);
    return std::tanh(y) / y;
  }
};

}  // namespace hapticut
