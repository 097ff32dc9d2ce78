// SPDX-License-Identifier: Apache-2.0
// Strips of voxels in vectors: their lanes, places, materials and motion; included once per instruction set.
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

// A strip: the sixteen voxels of two neighbouring rows, which follow each other in memory. A vector holds a strip or an
// equal part of one.
namespace strips {

constexpr int kStripLanes = ContactSums::kLanes;
constexpr int kStripsPerSlab = 64 / kStripLanes;  // a slab: the 64 voxels of a block of equal i
constexpr int kStrips = kBlockVoxels / kStripLanes;
using Floats = hn::CappedTag<float, kStripLanes>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
constexpr std::size_t kWidth = hn::MaxLanes(Floats());
constexpr std::size_t kParts = kStripLanes / kWidth;
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

/// c0 - c1 x + c2 x^2 - ... - c7 x^7 in pairs: the shortest chain of dependent operations.
HWY_INLINE Vec alternating_series(Vec x, const float (&c)[8]) {
  const auto pair = [&](int n) HWY_ATTR { return hn::NegMulAdd(broadcast(c[n + 1]), x, broadcast(c[n])); };
  const Vec x2 = x * x, x4 = x2 * x2;
  const Vec low = hn::MulAdd(pair(2), x2, pair(0)), high = hn::MulAdd(pair(6), x2, pair(4));
  return hn::MulAdd(high, x4, low);
}

/// (1 - e^-x)/x for x >= 0, as in core/decay.hpp.
HWY_INLINE Vec mean_of_decay(Vec x) {
  const Floats d;
  const hn::RebindToSigned<Floats> ints;
  constexpr float kMean[8] = {1, 0.5F, 1.0F / 6, 1.0F / 24, 1.0F / 120, 1.0F / 720, 1.0F / 5040, 1.0F / 40320};
  constexpr float kExponential[8] = {1, 1, 0.5F, 1.0F / 6, 1.0F / 24, 1.0F / 120, 1.0F / 720, 1.0F / 5040};
  const Vec series = alternating_series(x, kMean);
  const Mask small = x < broadcast(0.5F);
  if (hn::AllTrue(d, small)) return series;

  const Vec safe = hn::Max(x, broadcast(0.5F));
  const Vec bounded = hn::Min(safe, broadcast(80.0F));
  const auto n = hn::NearestInt(bounded * broadcast(1.44269504F));
  const Vec whole = hn::ConvertTo(d, n);
  const Vec g =
      hn::NegMulAdd(whole, broadcast(-2.12194440e-4F), hn::NegMulAdd(whole, broadcast(0.693359375F), bounded));
  const auto exponent = hn::ShiftLeft<23>(hn::Set(ints, 127) - n);
  const Vec exp_of_minus = alternating_series(g, kExponential) * hn::BitCast(d, exponent);
  return hn::IfThenElse(small, series, (broadcast(1.0F) - exp_of_minus) / safe);
}

/// FoundationLaw::damping_factor.
HWY_INLINE Vec damping_factor(Vec x) {
  const Vec zero = hn::Zero(Floats()), one = broadcast(1.0F);
  return (one + hn::Max(x, zero)) / (one - hn::Min(x, zero));
}

/// FoundationLaw::Damping of vectors.
struct DampingVectors {
  Vec factor, slope;

  HWY_INLINE DampingVectors() : factor(broadcast(1.0F)), slope(hn::Zero(Floats())) {}
  HWY_INLINE explicit DampingVectors(Vec x) : factor(damping_factor(x)) {
    const Vec opening = hn::Min(factor, broadcast(1.0F));
    slope = opening * opening;
  }
  [[nodiscard]] HWY_INLINE Vec crushing_depth(Vec at_rest) const {
    return at_rest / hn::Sqrt(hn::Max(factor, broadcast(1.0F)));
  }
};

/// Material constants of the lanes of one vector.
struct MaterialVectors {
  Vec stiffness, damping, cutting_ratio, energy, inverse_energy, cutting_depth, edge_length, size_length,
      crushing_depth, sliding_ratio, land;

  HWY_INLINE explicit MaterialVectors(const ContactMaterial& m)
      : stiffness(broadcast(m.stiffness)),
        damping(broadcast(m.damping)),
        cutting_ratio(broadcast(m.cutting_ratio)),
        energy(broadcast(m.cutting_energy)),
        inverse_energy(broadcast(1.0F / m.cutting_energy)),
        cutting_depth(broadcast(m.cutting_depth)),
        edge_length(broadcast(m.edge_length)),
        size_length(broadcast(m.size_length)),
        crushing_depth(broadcast(m.crushing_depth)),
        sliding_ratio(broadcast(m.sliding_ratio)),
        land(broadcast(m.land)) {}

  HWY_INLINE MaterialVectors(const ContactMaterials& table, const MaterialId* ids) {
    alignas(64) float lanes[11][kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) {
      const ContactMaterial& m = table[ids[i]];
      lanes[0][i] = m.stiffness;
      lanes[1][i] = m.damping;
      lanes[2][i] = m.cutting_ratio;
      lanes[3][i] = m.cutting_energy;
      lanes[4][i] = 1.0F / m.cutting_energy;
      lanes[5][i] = m.cutting_depth;
      lanes[6][i] = m.edge_length;
      lanes[7][i] = m.size_length;
      lanes[8][i] = m.crushing_depth;
      lanes[9][i] = m.sliding_ratio;
      lanes[10][i] = m.land;
    }
    const Floats d;
    stiffness = hn::Load(d, lanes[0]);
    damping = hn::Load(d, lanes[1]);
    cutting_ratio = hn::Load(d, lanes[2]);
    energy = hn::Load(d, lanes[3]);
    inverse_energy = hn::Load(d, lanes[4]);
    cutting_depth = hn::Load(d, lanes[5]);
    edge_length = hn::Load(d, lanes[6]);
    size_length = hn::Load(d, lanes[7]);
    crushing_depth = hn::Load(d, lanes[8]);
    sliding_ratio = hn::Load(d, lanes[9]);
    land = hn::Load(d, lanes[10]);
  }
};

/// A vector of points, of velocities ...
struct Vectors {
  Vec x, y, z;
};
HWY_INLINE Vec dot(const Vectors& a, const Vectors& b) { return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z)); }
/// v + omega x r
HWY_INLINE Vectors velocity_at(const Vectors& r, const Eigen::Vector3f& v, const Eigen::Vector3f& omega) {
  const Vec ox = broadcast(omega.x()), oy = broadcast(omega.y()), oz = broadcast(omega.z());
  return {hn::NegMulAdd(oz, r.y, hn::MulAdd(oy, r.z, broadcast(v.x()))),
          hn::NegMulAdd(ox, r.z, hn::MulAdd(oz, r.x, broadcast(v.y()))),
          hn::NegMulAdd(oy, r.x, hn::MulAdd(ox, r.y, broadcast(v.z())))};
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

/// Writes consecutive values to the lanes of a vector whose bits are set; the other lanes do not change.
HWY_INLINE void spread(const float* values, unsigned lanes, float* to) {
#if HWY_TARGET <= HWY_AVX3
  const auto mask = __mmask16(lanes);
  _mm512_mask_storeu_ps(to, mask, _mm512_maskz_expand_ps(mask, _mm512_loadu_ps(values)));
#else
  for (; lanes != 0; lanes &= lanes - 1) to[std::countr_zero(lanes)] = *values++;
#endif
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
