// SPDX-License-Identifier: Apache-2.0
// Strips of voxels in vectors: their lanes and places; included once per instruction set.
#if defined(HAPTICUT_KERNELS_STRIPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_STRIPS_INL_HPP
#undef HAPTICUT_KERNELS_STRIPS_INL_HPP
#else
#define HAPTICUT_KERNELS_STRIPS_INL_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstring>

#include "kernels/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A strip: the sixteen voxels of two neighbouring rows, which follow each other in memory. A vector has a strip or an
// equal part of one.
namespace strips {

constexpr int kStripLanes = ContactSums::kLanes;
constexpr int kStripsPerSlab = 64 / kStripLanes;  // a slab: the 64 voxels of a block of equal i
constexpr int kStrips = kBlockVoxels / kStripLanes;
using Floats = hn::CappedTag<float, kStripLanes>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
constexpr std::size_t kWidth = hn::MaxLanes(Floats());
constexpr std::size_t kVectors = kStripLanes / kWidth;
constexpr unsigned kAllLanes = (1U << kWidth) - 1;

HWY_INLINE Vec broadcast(float value) { return hn::Set(Floats(), value); }
HWY_INLINE Mask mask_of(unsigned bits) {
#if HWY_TARGET <= HWY_AVX3
  if constexpr (kWidth == kStripLanes) return Mask{__mmask16(bits)};
#endif
  const hn::RebindToSigned<Floats> ints;
  alignas(64) static constexpr std::int32_t kLaneBits[16] = {1,       1 << 1,  1 << 2,  1 << 3, 1 << 4,  1 << 5,
                                                             1 << 6,  1 << 7,  1 << 8,  1 << 9, 1 << 10, 1 << 11,
                                                             1 << 12, 1 << 13, 1 << 14, 1 << 15};
  return hn::RebindMask(Floats(), hn::TestBit(hn::Set(ints, int(bits)), hn::Load(ints, kLaneBits)));
}
HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bytes[8];
  hn::StoreMaskBits(Floats(), mask, bytes);
  if constexpr (kWidth <= 8) return bytes[0] & kAllLanes;
  std::uint16_t bits = 0;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

/// Adds the lanes of a vector to sums in double precision.
HWY_INLINE void add_lanes(Vec sum, double* totals) {
  alignas(64) float lanes[kWidth];
  hn::Store(sum, Floats(), lanes);
  for (std::size_t lane = 0; lane < kWidth; ++lane) totals[lane] += double(lanes[lane]);
}
HWY_INLINE double sum_of_lanes(Vec values) {
  double lanes[kWidth] = {}, sum = 0;
  add_lanes(values, lanes);
  for (const double lane : lanes) sum += lane;
  return sum;
}

/// Positions of the strips of a block, or of a point of each, from the block's first voxel.
struct StripOffsets {
  float x[kStrips], y[kStrips], z[kStrips];  // [m]

  /// @param place  [m] from a strip's first voxel
  StripOffsets(const Eigen::Matrix3f& steps, const Eigen::Vector3f& place) {
    for (int n = 0; n < kStrips; ++n) {
      const int slab = n / kStripsPerSlab, row = 2 * (n % kStripsPerSlab);
      const Eigen::Vector3f offset = steps.col(0) * float(slab) + steps.col(1) * float(row) + place;
      x[n] = offset.x(), y[n] = offset.y(), z[n] = offset.z();
    }
  }
};

/// Whether all lanes of a vector have one material.
HWY_INLINE bool all_are(const MaterialId* ids, MaterialId one) {
  using Word = std::conditional_t<(kWidth < 8), std::uint32_t, std::uint64_t>;
  Word difference = 0;
  for (std::size_t first = 0; first < kWidth; first += sizeof(Word)) {
    Word word = 0;
    std::memcpy(&word, ids + first, std::min(kWidth, sizeof(Word)));
    difference |= word ^ Word(~Word(0) / 255 * one);
  }
  return difference == 0;
}

/// The numbers of the lanes whose bits are set, in sequence; the entries after them are undefined. Compress of Highway
/// 1.0.3 copies its table onto the stack in each call with vectors of eight lanes.
HWY_INLINE hn::Vec<hn::RebindToSigned<Floats>> numbers_of(unsigned lanes) {
  const hn::RebindToSigned<Floats> ints;
  if constexpr (kWidth > 8) return hn::Compress(hn::Iota(ints, 0), hn::RebindMask(ints, mask_of(lanes)));
  static constexpr auto kNumbers = [] {
    std::array<std::array<std::uint8_t, 8>, 256> numbers = {};
    for (unsigned bits = 0; bits < 256; ++bits)
      for (unsigned lane = 0, n = 0; lane < 8; ++lane)
        if ((bits >> lane & 1U) != 0) numbers[bits][n++] = std::uint8_t(lane);
    return numbers;
  }();
  return hn::PromoteTo(ints, hn::LoadU(hn::Rebind<std::uint8_t, decltype(ints)>(), kNumbers[lanes].data()));
}

/// Stores those lanes of a vector whose bits are set, without gaps. What follows them is undefined.
HWY_INLINE void store_lanes(Vec values, unsigned lanes, float* to) {
  const auto order = hn::IndicesFromVec(Floats(), numbers_of(lanes));
  hn::StoreU(hn::TableLookupLanes(values, order), Floats(), to);
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
