// SPDX-License-Identifier: Apache-2.0
// Voxels that the interface crosses, integrated over their filled parts; included once per instruction set.
#if defined(HAPTICUT_KERNELS_CUT_VOXELS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_CUT_VOXELS_INL_HPP
#undef HAPTICUT_KERNELS_CUT_VOXELS_INL_HPP
#else
#define HAPTICUT_KERNELS_CUT_VOXELS_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/workpiece/cut_voxel.hpp"
#include "kernels/chip-inl.hpp"
#include "kernels/press_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// VoxelSection in vectors; its comments give the reasons.
class SectionVectors {
 public:
  HWY_INLINE SectionVectors(Vec max_component, float min_width) : p_(max_component) {
    const Vec one = broadcast(1.0F);
    q_ = hn::Max(hn::Sqrt(hn::Max(hn::Zero(Floats()), hn::NegMulAdd(max_component, max_component, one))),
                 broadcast(min_width));
    per_area_ = one / (p_ * q_);
  }

  [[nodiscard]] HWY_INLINE Vec span() const { return p_ + q_; }

  [[nodiscard]] HWY_INLINE Vec height_of(Vec fill) const {
    if (hn::AllTrue(Floats(), fill >= broadcast(1.0F))) return span();
    const Vec half = broadcast(0.5F), wide = hn::Max(p_, q_), narrow = hn::Min(p_, q_);
    const Vec less = hn::Min(fill, broadcast(1.0F) - fill), ramp = wide * less, twice = ramp + ramp;
    const Vec height = hn::IfThenElse(twice <= narrow, hn::Sqrt(hn::Max(hn::Zero(Floats()), twice * narrow)),
                                      hn::MulAdd(half, narrow, ramp));
    return hn::IfThenElse(fill <= half, height, span() - height);
  }

  [[nodiscard]] HWY_INLINE Vec area_at(Vec height) const {
    const Corners x = corners(hn::Max(hn::Zero(Floats()), height));
    return hn::Max(hn::Zero(Floats()), x.all - x.without_p - x.without_q) * per_area_;
  }
  [[nodiscard]] HWY_INLINE Vec fill_below(Vec height) const {
    const Corners x = corners(hn::Max(hn::Zero(Floats()), height));
    const Vec squares = x.all * x.all - x.without_p * x.without_p - x.without_q * x.without_q;
    return broadcast(0.5F) * per_area_ * squares;
  }

  /// DepthIntegrals::depth and volume.
  struct DepthAndVolume {
    Vec depth, volume;
  };
  [[nodiscard]] HWY_INLINE DepthAndVolume depth_and_volume(Vec height, Vec depth) const {
    const Corners x = corners(height);
    return {broadcast(1.0F / 6) * per_area_ * depths(x, depth), broadcast(0.5F) * per_area_ * volumes(x, depth)};
  }

  /// DepthIntegrals::cutting.
  /// @param beyond  CutDepth::beyond
  [[nodiscard]] HWY_INLINE Vec cutting(Vec height, Vec threshold, Vec beyond) const {
    const Corners x = corners(height);
    return hn::MulAdd(broadcast(0.5F) * threshold, volumes(x, beyond), broadcast(1.0F / 6) * depths(x, beyond)) *
           per_area_;
  }

  /// DepthIntegrals::energy; zero where the depth is not positive.
  [[nodiscard]] HWY_INLINE Vec energy(Vec height, Vec depth) const {
    const Vec zero = hn::Zero(Floats()), d = hn::Max(zero, depth), d2 = d * d;
    const auto ramp = [&](Vec x) HWY_ATTR {
      const Vec four_x = broadcast(4.0F) * x;
      const Vec shallow = d2 * d * (four_x - d);
      const Vec whole = x * x * hn::MulAdd(broadcast(6.0F), d2, hn::NegMulAdd(four_x, d, x * x));
      return hn::IfThenElse(d < x, shallow, whole);
    };
    const Vec sum = ramp(height) - ramp(hn::Max(zero, height - p_)) - ramp(hn::Max(zero, height - q_));
    return broadcast(1.0F / 24) * per_area_ * sum;
  }

 private:
  struct Corners {
    Vec all, without_p, without_q;
  };
  [[nodiscard]] HWY_INLINE Corners corners(Vec height) const {
    const Vec zero = hn::Zero(Floats());
    return {height, hn::Max(zero, height - p_), hn::Max(zero, height - q_)};
  }

  /// 6 p q times the integral of the depth.
  [[nodiscard]] HWY_INLINE static Vec depths(const Corners& x, Vec to) {
    const auto of = [&](Vec ramp) HWY_ATTR {
      const Vec m = hn::Min(ramp, to), larger = hn::Max(ramp, to);
      return m * m * hn::MulSub(broadcast(3.0F), larger, m);
    };
    return of(x.all) - of(x.without_p) - of(x.without_q);
  }

  /// 2 p q times the volume.
  [[nodiscard]] HWY_INLINE static Vec volumes(const Corners& x, Vec to) {
    const auto of = [&](Vec ramp) HWY_ATTR {
      const Vec m = hn::Min(ramp, to);
      return m * (ramp + ramp - m);
    };
    return of(x.all) - of(x.without_p) - of(x.without_q);
  }

  Vec p_, q_;     // [1] widths of the two boxes whose convolution is the section
  Vec per_area_;  // [1] 1/(p q)
};

/// LayerRecession::of in vectors.
HWY_INLINE Vec relative_recession(Vec top, const CutDepthVectors& cut, Vec rate, Vec speed, float duration,
                                  bool at_end) {
  const Vec one = broadcast(1.0F), dt = broadcast(duration);
  const Vec min_squared = cut.threshold * cut.threshold, half = broadcast(duration / 2);
  const Vec deeper = hn::Min(top, cut.beyond(top));
  const Vec before = hn::Min(half, deeper / hn::Max(speed, broadcast(1e-20F)));
  const Vec time = before + (at_end ? before : half), t = hn::NegMulAdd(speed, before, top);
  const Vec gain = hn::MulAdd(rate, min_squared, speed);
  const Vec balance = time * time * rate * gain;
  // tanh(y)/y = m/(1 - y m) with m = (1 - e^-2y)/(2y), and by its series where (1 - tanh(y)/y)/y^2 would cancel
  const Vec y = hn::Sqrt(balance), m = mean_of_decay(y + y);
  const auto small = balance < broadcast(0.01F);
  const Vec deficit_of_small = hn::NegMulAdd(balance, broadcast(2.0F / 15), broadcast(1.0F / 3));
  const Vec c = hn::IfThenElse(small, hn::NegMulAdd(balance, deficit_of_small, one), m / hn::NegMulAdd(y, m, one));
  const Vec deficit = hn::IfThenElse(small, deficit_of_small, (one - c) / hn::Max(balance, broadcast(0.01F)));
  const Vec removed = hn::MulAdd(time * c, hn::MulSub(t, t, min_squared),
                                 speed * time * time * hn::MulAdd(time * gain, deficit, t * c));
  const Vec as_evaluated = dt * cut.excess;
  return removed / (hn::MulAdd(t * rate, time * c, one) * hn::Max(as_evaluated, broadcast(1e-36F)));
}

/// FoundationLaw on parts of voxels.
struct PartOutcome {
  Vec rubbing, cut;            // [N/m^3] springs: too shallow to be cut, and deep enough
  Vec left;                    // [1] fill after the sub-step
  Vec energy;                  // [J/m^3] u of the cut material, with its chips
  Vec credit, price;           // [1] fill that was removed without work, and [J/m^3] its cutting energy
  Vec refused;                 // [1] fill whose work was done, but which rounding did not remove
  Vec before, after;           // [J/m^3] stored at the beginning and the end
  Vec released;                // [J/m^3] energy put in less energy stored; zero where nothing is cut
  Vec kept;                    // [1] fill that was not crushed
  Vec yielding;                // [1] part of the contact volume that is at the crushing limit
  Vec top;                     // [m] depth of the top of what crushing left
  Mask crushed;                // only where some are
  Vec elastic, volume, depth;  // [N/m^3] springs without cutting; [1] volume in contact; [m] its integral of the depth
  Vec area;                    // [voxel edges^2] of the head's surface

  /// [N/m^4] Change of the force with depth, reduced as the springs yield while they are cut.
  [[nodiscard]] HWY_INLINE Vec slope(const MaterialVectors& material, const DampingVectors& damped, float time) const {
    const Vec yields = (rubbing + cut) / hn::Max(elastic, broadcast(1e-20F));
    // The crushing limit moves up with the closing speed.
    const Vec limit = hn::IfThenElseZero(damped.factor > broadcast(1.0F), broadcast(0.5F) * top * yielding);
    const Vec damper = damped.slope * material.damping * (depth - limit) * broadcast(1 / time);
    return material.stiffness * yields * hn::MulAdd(volume - yielding, damped.factor, damper);
  }
};

/// @tparam kCrushes       some voxels are deeper than crushing_depth
/// @param crushing_depth  [m] deeper material is crushed
template <bool kCrushes>
HWY_INLINE PartOutcome press_parts_of(const HeadMotion& m, const MaterialVectors& material, const Sample& s,
                                      Vec mean_rate, Vec fill, Vec damped, Vec crushing_depth, bool may_cut,
                                      bool release) {
  const Floats d;
  const Vec zero = hn::Zero(d), half = broadcast(0.5F);
  const Vec l = broadcast(m.voxel_size), per_l = broadcast(1 / m.voxel_size);
  const Mask inside = s.top > zero;
  PartOutcome p;
  // The steps have the numbers of FoundationLaw::evaluate_parts; the springs (4) come before the chips (3).
  // 1. The filled part: its section, far plane and height.
  const SectionVectors section(s.max_component, m.min_width);
  const Vec far_plane = hn::MulSub(s.depth, per_l, half * section.span());
  const Vec full_height = hn::MulSub(s.top, per_l, far_plane), stiff = material.stiffness * l;
  Vec height = full_height;
  const Vec work = half * material.cutting_ratio * material.stiffness * damped * s.slip_path;
  const float slip_time = m.duration * m.level_of_detail, feed = (m.velocity - m.ripple).norm();
  const Vec per_time = broadcast(1 / slip_time);
  Vec speed = hn::Max(zero, s.rate);
  p.top = s.top;
  p.kept = fill;
  p.yielding = zero;
  if constexpr (kCrushes) {  // 2. Crushing.
    Vec deepest = crushing_depth;
    if (may_cut) {  // what can be cut at the strength is not crushed
      const Vec rate = work * per_time * material.inverse_energy;
      const Vec cut = hn::Min(speed, recession_at(crushing_depth, material, m.tooth_rate, rate, mean_rate, feed));
      deepest = hn::MulAdd(cut, broadcast(0.5F * slip_time), crushing_depth);
      speed = hn::IfThenElse(s.top > deepest, cut, speed);
    }
    p.crushed = s.top > deepest;
    p.top = hn::IfThenElse(p.crushed, deepest, s.top);
    height = hn::IfThenElse(p.crushed, hn::Max(zero, hn::MulSub(p.top, per_l, far_plane)), height);
    const Vec below = hn::Min(fill, section.fill_below(height));  // rounding
    const Vec kept = hn::IfThenElseZero(below >= broadcast(FoundationLaw::kMinPart), below);
    p.kept = hn::IfThenElse(p.crushed, kept, fill);
    p.yielding = hn::IfThenElseZero(p.crushed, p.top * per_l * section.area_at(height));
  }
  // 4. Springs of the part.
  const Vec top = p.top * per_l;
  const auto part = section.depth_and_volume(height, top);
  p.volume = hn::IfThenElseZero(inside, part.volume);
  p.area = hn::IfThenElseZero(inside, section.area_at(hn::Neg(far_plane)));
  p.depth = hn::IfThenElseZero(inside, part.depth) * l;
  p.elastic = p.rubbing = hn::IfThenElseZero(inside, stiff * part.depth);
  p.cut = p.credit = p.refused = zero;
  p.left = p.kept;
  p.energy = p.price = material.energy;
  // 3. Chips: energy and threshold of the cut.
  Mask is_cut = hn::MaskFromVec(zero);
  CutDepthVectors cut_depth(p.top, material.cutting_depth);
  if (may_cut) {
    if (m.tooth_rate > 0) {
      const Vec rate = work * per_time * material.inverse_energy;
      const ChordVectors chord = chord_of_chips(material, m.tooth_rate, rate, p.top, far_plane * l, mean_rate, feed);
      p.energy = p.price = chord.energy;
      cut_depth = chord.cut;
    }
    is_cut = hn::And(inside, cut_depth.excess > zero);
    if constexpr (kCrushes) is_cut = hn::And(is_cut, p.kept > zero);
  }
  if (!hn::AllFalse(d, is_cut)) {
    const Vec cutting = section.cutting(height, cut_depth.threshold * per_l, cut_depth.beyond(p.top) * per_l);
    // 5. Recession of the layer.
    Vec path = work / p.price;  // k_d dt
    Vec recession = relative_recession(p.top, cut_depth, path * per_time, speed, slip_time, m.at_end());
    if (release) {  // helped by the energy stored at the mean depth of the layer's top
      const Vec squared = hn::MulAdd(recession, cut_depth.excess, cut_depth.threshold * cut_depth.threshold);
      p.price = hn::Max(hn::NegMulAdd(half * material.stiffness, squared, p.price),
                        p.price * broadcast(FoundationLaw::kMinEnergyShare));
      path = work / p.price;
      recession = relative_recession(p.top, cut_depth, path * per_time, speed, slip_time, m.at_end());
    }
    // 6. Decay of the fill.
    const Vec decay = (path + path) * l * cutting * recession / hn::Max(p.kept, broadcast(FoundationLaw::kMinPart));
    const Vec exponent = hn::IfThenElseZero(is_cut, hn::Min(decay, broadcast(FoundationLaw::kMaxExponent)));
    const Vec mean = mean_of_decay(exponent);
    p.cut = hn::IfThenElseZero(is_cut, stiff * cutting * recession * mean);
    p.rubbing = hn::IfThenElse(is_cut, stiff * hn::Max(zero, part.depth - cutting), p.rubbing);
    const Vec loss = p.kept * exponent * mean;
    p.left = p.kept - loss;
    p.refused = loss - (p.kept - p.left);
    const Mask finished = hn::And(hn::And(is_cut, exponent > zero), p.left < broadcast(FoundationLaw::kMinPart));
    // Never zero, so that it also marks the finished lanes.
    p.credit = hn::IfThenElseZero(finished, hn::Max(p.left, broadcast(1e-30F)));
    p.left = hn::IfThenZeroElse(finished, p.left);
  }
  // 7. Energies before and after.
  const Vec advance = s.rate * broadcast(m.duration), moved = advance * per_l;
  const Vec energy = stiff * l;
  const Vec height_left = may_cut ? section.height_of(p.left) : height;
  const Vec later = hn::MulAdd(moved, broadcast(0.5F - m.lead), height_left + far_plane);
  p.after = hn::IfThenElseZero(hn::And(inside, p.left > zero), energy * section.energy(height_left, later));
  const Mask removed = fill - p.left > broadcast(FoundationLaw::kMinLoss) * fill;
  // Released energy is zero where nothing is cut, and never negative: the error of the midpoint rule is `entered`.
  p.before = hn::NegMulAdd(p.rubbing + p.cut, advance, p.after);
  p.released = zero;
  if constexpr (kCrushes) {  // a voxel that is crushed completely is finished too
    const Mask none_kept = hn::And(p.crushed, p.kept <= zero);
    p.credit = hn::IfThenElse(none_kept, broadcast(1e-30F), p.credit);
  }
  if ((may_cut || kCrushes) && !hn::AllFalse(d, removed)) {
    const Vec earlier = hn::NegMulAdd(moved, broadcast(0.5F + m.lead), s.top * per_l);
    // The excess force of a contact that is evaluated at the end was not stored before.
    const Vec harder = material.stiffness * p.volume * advance * advance * broadcast(m.lead);
    const Vec surplus = hn::MulSub(energy, section.energy(full_height, earlier), p.before + harder);
    p.released = hn::IfThenElseZero(removed, hn::Max(zero, surplus));
    if constexpr (kCrushes) {
      const Vec strength = half * material.stiffness * material.crushing_depth * material.crushing_depth;
      p.released = hn::IfThenElse(p.crushed, strength * (fill - p.kept), p.released);
    }
    p.before = p.before + p.released;
  }
  return p;
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
