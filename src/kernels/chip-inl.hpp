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

/// @param rate  [1/(m s)] kappa k_v s/(2 u), with the damping's factor
HWY_INLINE ChordVectors chord_of_chips(const MaterialVectors& material, float tooth_rate, Vec rate, Vec top, Vec bottom,
                                       Vec speed, float feed) {
  using Chord = ChipChord<float>;
  const Vec zero = hn::Zero(Floats()), min_roots = broadcast(Chord::kMinRoots), four = broadcast(4.0F);
  const Vec toward = hn::MulAdd(hn::Abs(speed), broadcast(1 / Chord::kGrazing), broadcast(Chord::kMinFeed));
  const Vec factor = hn::Min(broadcast(1.0F), toward * broadcast(1 / std::max(feed, Chord::kMinFeed)));
  const Vec chips = broadcast(tooth_rate) * factor;
  const Vec edge = material.edge_length * chips, square = material.size_length * chips;
  const Vec b = hn::Sqrt(square), w0 = material.cutting_depth, w0_squared = w0 * w0;
  const auto root_of_speed = [&](Vec depth) HWY_ATTR {
    const Vec q = hn::Max(zero, hn::MulSub(rate, hn::MulSub(depth, depth, w0_squared), edge));
    return (q + q) / hn::Max(b + hn::Sqrt(hn::MulAdd(four, q, square)), min_roots);
  };
  const Vec at_top = root_of_speed(top);
  const Vec outside = hn::Min(broadcast(1.0F), broadcast(-2.0F) * bottom / (top - bottom));
  const Vec other = hn::IfThenElse(bottom > zero, root_of_speed(bottom), outside * hn::Sqrt(hn::Max(zero, speed)));
  const Vec dearer = broadcast(1.0F) + b / hn::Max(at_top + other, min_roots);  // 1/sigma_c
  ChordVectors chord = {material.energy * dearer, CutDepthVectors(top, zero)};
  chord.cut.excess = hn::IfThenElseZero(rate > zero, at_top * at_top * dearer / rate);
  chord.cut.threshold = hn::Sqrt(hn::Max(zero, hn::MulSub(top, top, chord.cut.excess)));
  return chord;
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
