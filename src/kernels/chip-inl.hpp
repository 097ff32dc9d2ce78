// SPDX-License-Identifier: Apache-2.0
// Cutting energy that depends on the chip; included once per instruction set.
#if defined(HAPTICUT_KERNELS_CHIP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_CHIP_INL_HPP
#undef HAPTICUT_KERNELS_CHIP_INL_HPP
#else
#define HAPTICUT_KERNELS_CHIP_INL_HPP
#endif

#include "hapticut/force/chip.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// CutDepth in vectors.
struct CutDepthVectors {
  Vec threshold, excess;

  HWY_INLINE CutDepthVectors(Vec top, Vec from) : threshold(from), excess((top - from) * (top + from)) {}
  [[nodiscard]] HWY_INLINE Vec beyond(Vec top) const {
    return hn::IfThenElseZero(excess > hn::Zero(Floats()), excess / (top + threshold));
  }
};

/// ChipChord in vectors; its comments give the reasons.
struct ChordVectors {
  Vec energy;
  CutDepthVectors cut;
};

/// ChipChord::Roots in vectors.
struct RootsVectors {
  Vec rate, edge, square, b, w0_squared;

  HWY_INLINE RootsVectors(const MaterialVectors& material, float tooth_rate, Vec rate_, Vec speed, float feed)
      : rate(rate_), w0_squared(material.cutting_depth * material.cutting_depth) {
    using Chord = ChipChord<float>;
    const Vec toward = hn::MulAdd(hn::Abs(speed), broadcast(1 / Chord::kGrazing), broadcast(Chord::kMinFeed));
    const Vec factor = hn::Min(broadcast(1.0F), toward * broadcast(1 / std::max(feed, Chord::kMinFeed)));
    const Vec chips = broadcast(tooth_rate) * factor;
    edge = material.edge_length * chips, square = material.size_length * chips;
    b = hn::Sqrt(square);
  }
  [[nodiscard]] HWY_INLINE Vec operator()(Vec depth) const {
    const Vec q = hn::Max(hn::Zero(Floats()), hn::MulSub(rate, hn::MulSub(depth, depth, w0_squared), edge));
    return (q + q) /
           hn::Max(b + hn::Sqrt(hn::MulAdd(broadcast(4.0F), q, square)), broadcast(ChipChord<float>::kMinRoots));
  }
};

/// ChipChord::recession_at in vectors.
HWY_INLINE Vec recession_at(Vec depth, const MaterialVectors& material, float tooth_rate, Vec rate, Vec speed,
                            float feed) {
  const Vec root = RootsVectors(material, tooth_rate, rate, speed, feed)(depth);
  return root * root;
}

/// @param rate  [1/(m s)] kappa k_v s/(2 u), with the damping's factor
HWY_INLINE ChordVectors chord_of_chips(const MaterialVectors& material, float tooth_rate, Vec rate, Vec top, Vec bottom,
                                       Vec speed, float feed) {
  const Vec zero = hn::Zero(Floats()), min_roots = broadcast(ChipChord<float>::kMinRoots);
  const RootsVectors root_of_speed(material, tooth_rate, rate, speed, feed);
  const Vec at_top = root_of_speed(top);
  const Vec outside = hn::Min(broadcast(1.0F), broadcast(-2.0F) * bottom / (top - bottom));
  const Vec other = hn::IfThenElse(bottom > zero, root_of_speed(bottom), outside * hn::Sqrt(hn::Max(zero, speed)));
  const Vec dearer = broadcast(1.0F) + root_of_speed.b / hn::Max(at_top + other, min_roots);  // 1/sigma_c
  ChordVectors chord = {material.energy * dearer, CutDepthVectors(top, zero)};
  chord.cut.excess = hn::IfThenElseZero(rate > zero, at_top * at_top * dearer / rate);
  chord.cut.threshold = hn::Sqrt(hn::Max(zero, hn::MulSub(top, top, chord.cut.excess)));
  return chord;
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
