// SPDX-License-Identifier: Apache-2.0
// Rows of eight lanes in vectors of one instruction set; included once per set.
#if defined(HAPTICUT_KERNELS_ROWS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_ROWS_INL_HPP
#undef HAPTICUT_KERNELS_ROWS_INL_HPP
#else
#define HAPTICUT_KERNELS_ROWS_INL_HPP
#endif

#include <hwy/highway.h>

#include "kernels/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Vectors of at most eight floats, so that a row is one, two or eight of them and sums have the same order everywhere.
using Floats = hn::CappedTag<float, kLanes>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
constexpr std::size_t kWidth = hn::MaxLanes(Floats());
constexpr std::size_t kParts = kLanes / kWidth;

HWY_INLINE Vec broadcast(float value) { return hn::Set(Floats(), value); }

/// Lanes `part * kWidth ...` of the eight bits of a row.
HWY_INLINE Mask mask_of(unsigned bits, std::size_t part) {
  std::uint8_t shifted[8] = {std::uint8_t(bits >> (part * kWidth))};  // Highway may read eight bytes
  return hn::LoadMaskBits(Floats(), shifted);
}

HWY_INLINE unsigned bits_of(Mask mask, std::size_t part) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Floats(), mask, bits);
  return unsigned(bits[0]) << (part * kWidth);
}

/// One running sum per lane of a row.
struct LaneSum {
  Vec part[kParts];
  HWY_INLINE LaneSum() {
    for (Vec& v : part) v = hn::Zero(Floats());
  }
  /// The lanes added up in double precision, from the first to the last.
  HWY_INLINE double total() const {
    alignas(64) float lanes[kLanes];
    for (std::size_t p = 0; p < kParts; ++p) hn::Store(part[p], Floats(), lanes + p * kWidth);
    double sum = 0;
    for (const float lane : lanes) sum += double(lane);
    return sum;
  }
};

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
