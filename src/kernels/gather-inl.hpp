// SPDX-License-Identifier: Apache-2.0
// The voxels of a block that may be inside the head, gathered without gaps; included once per instruction set.
#if defined(HAPTICUT_KERNELS_GATHER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_GATHER_INL_HPP
#undef HAPTICUT_KERNELS_GATHER_INL_HPP
#else
#define HAPTICUT_KERNELS_GATHER_INL_HPP
#endif

#include "kernels/columns-inl.hpp"
#include "kernels/springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// [voxels] From the middle of a strip to its farthest voxel: 3.5 along k and 0.5 along j, rounded up.
constexpr float kHalfStrip = 3.6F;
/// Finds the solid voxels of blocks that may be inside the head.
template <class Springs>
class Gather {
 public:
  using Bound = decltype(std::declval<const Springs&>().grown(0.0F));

  /// @param motion  [m] of any point of the head, at most, until the voxels are evaluated
  HWY_INLINE Gather(const Springs& springs, const ContactJob& job, float motion)
      : near_(springs.grown(kVoxelReach * job.motion.voxel_size + motion)),
        strips_near_(springs.grown((kHalfStrip + kVoxelReach) * job.motion.voxel_size + motion)),
        strips_inside_(springs.grown(-(kHalfStrip + kVoxelReach) * job.motion.voxel_size)),
        steps_(job.grid.voxel_steps.template cast<float>()),
        firsts_(steps_, Eigen::Vector3f::Zero()),
        middles_(steps_, steps_ * Eigen::Vector3f(0, 0.5F, 3.5F)),
        job_(job) {
    for (std::size_t vector = 0; vector < kVectors; ++vector) {
      const Vec lane = hn::Iota(Floats(), float(vector * kWidth));
      const Vec j = hn::IfThenElseZero(lane >= broadcast(8.0F), broadcast(1.0F));
      const Vec k = hn::NegMulAdd(j, broadcast(8.0F), lane);
      const auto offset = [&](int axis) HWY_ATTR {
        return hn::MulAdd(j, broadcast(steps_(axis, 1)), k * broadcast(steps_(axis, 2)));
      };
      lane_offsets_[vector] = {offset(0), offset(1), offset(2)};
    }
  }

  /// @param out  [ReachedVoxels::kCapacity]
  HWY_INLINE ReachedVoxels find(const BlockView& block, std::uint16_t* out) const {
    return find_skimmed(block, out, 0, nullptr);
  }

  /// @param done  bit n: strip n is skipped
  /// @param skim  called with the first index of a vector of voxels, their positions, and the lanes that may be inside,
  /// as bits; returns those to list; nullptr: all
  template <class Skim>
  HWY_INLINE ReachedVoxels find_skimmed(const BlockView& block, std::uint16_t* out, std::uint32_t done,
                                        const Skim& skim) const {
    const hn::Rebind<std::uint16_t, Floats> shorts;
    ReachedVoxels reached = {out, 0, material_of(block)};
    for_each(
        block, done, [&](int voxel, const Place& r, unsigned lanes) HWY_ATTR __attribute__((always_inline)) {
          if constexpr (!std::is_null_pointer_v<Skim>) lanes = skim(voxel, r, lanes);
          if (lanes == 0) return;
          const auto places = numbers_of(lanes) + hn::Set(kInts, voxel);
          hn::StoreU(hn::DemoteTo(shorts, places), shorts, out + reached.count);
          reached.count += std::popcount(lanes);
        });
    std::fill_n(out + reached.count, ReachedVoxels::kEnd, std::uint16_t(0));
    return reached;
  }

  /// Calls `found(r)` for each vector of voxels of those strips whose voxels are all solid and within a bound, in a
  /// ball.
  /// @return bit n: strip n is such a strip
  template <class Found>
  HWY_INLINE std::uint32_t for_each_within(const BlockView& block, const Bound& deep, const Found& found) const {
    static_assert(Springs::kCentral);  // because its bound is exact, also for a negative margin
    const Eigen::Vector3f base = first_voxel(block);
    std::uint32_t done = 0;
    Place lanes[kVectors];
    first_strip(base, lanes);
    for (std::uint32_t rest = strips_within(base, deep) & strips_of_subset(block); rest != 0; rest &= rest - 1) {
      const int strip = std::countr_zero(rest);
      if (block.solid != nullptr && (block.solid[strip >> 2] >> (16 * (strip & 3)) & 0xffff) != 0xffff) continue;
      Place r[kVectors];
      Mask within = hn::FirstN(Floats(), kWidth);
      for (std::size_t vector = 0; vector < kVectors; ++vector) {
        r[vector] = {lanes[vector].x + broadcast(firsts_.x[strip]), lanes[vector].y + broadcast(firsts_.y[strip]),
                     lanes[vector].z + broadcast(firsts_.z[strip])};
        within = hn::And(within, deep.hits(r[vector].x, r[vector].y, r[vector].z).m);
      }
      if (!hn::AllTrue(Floats(), within)) continue;
      done |= 1U << strip;
      for (const Place& place : r) found(place);
    }
    return done;
  }

 private:
  static constexpr hn::RebindToSigned<Floats> kInts = {};

  /// The material of all voxels of a block that ever had one; kEmpty when there are several.
  [[nodiscard]] HWY_INLINE static MaterialId material_of(const BlockView& block) {
    if (block.material == nullptr) return block.uniform_material;
    const hn::CappedTag<MaterialId, 16> ids;
    auto least = hn::Set(ids, std::numeric_limits<MaterialId>::max()), most = hn::Zero(ids);
    for (std::size_t n = 0; n < kBlockVoxels; n += hn::MaxLanes(ids)) {
      const auto there = hn::LoadU(ids, block.material + n);
      most = hn::Max(most, there);
      least = hn::Min(least, hn::IfThenElse(hn::Eq(there, hn::Zero(ids)), least, there));
    }
    MaterialId lows[16], highs[16];
    hn::StoreU(least, ids, lows), hn::StoreU(most, ids, highs);
    const MaterialId low = *std::min_element(lows, lows + hn::MaxLanes(ids)),
                     high = *std::max_element(highs, highs + hn::MaxLanes(ids));
    return low == high ? low : kEmpty;
  }

  /// Calls `found(voxel, r, lanes)` for each vector of voxels that may be inside the head: the index of the first voxel
  /// in the block, the positions [m] in T, and the lanes that may be inside, as bits.
  template <class Found>
  HWY_INLINE void for_each(const BlockView& block, std::uint32_t done, const Found& found) const {
    const Eigen::Vector3f base = first_voxel(block);
    const std::uint32_t near =
        strips_within(base, strips_near_) & solid_strips(block) & strips_of_subset(block) & ~done;
    const std::uint32_t inner = strips_within(base, strips_inside_);
    Place lanes[kVectors];
    first_strip(base, lanes);
    for (std::uint32_t rest = near; rest != 0; rest &= rest - 1) {
      const int strip = std::countr_zero(rest);
      const auto solid =
          block.solid == nullptr ? 0xffffU : unsigned(block.solid[strip >> 2] >> (16 * (strip & 3)) & 0xffff);
      for (std::size_t vector = 0; vector < kVectors; ++vector) {
        const unsigned bits = solid >> (vector * kWidth) & kAllLanes;
        const int voxel = strip * kStripLanes + int(vector * kWidth);
        const Place r = {lanes[vector].x + broadcast(firsts_.x[strip]), lanes[vector].y + broadcast(firsts_.y[strip]),
                         lanes[vector].z + broadcast(firsts_.z[strip])};
        const unsigned hit = (inner >> strip & 1U) != 0 ? bits : bits & bits_of(near_.hits(r.x, r.y, r.z).m);
        if (hit != 0) found(voxel, r, hit);
      }
    }
  }

  /// Positions of the voxels of a strip that begins at the block's first voxel.
  HWY_INLINE void first_strip(const Eigen::Vector3f& base, Place (&lanes)[kVectors]) const {
    for (std::size_t vector = 0; vector < kVectors; ++vector)
      lanes[vector] = {lane_offsets_[vector].x + broadcast(base.x()), lane_offsets_[vector].y + broadcast(base.y()),
                       lane_offsets_[vector].z + broadcast(base.z())};
  }

  [[nodiscard]] HWY_INLINE Eigen::Vector3f first_voxel(const BlockView& block) const {
    return job_.grid.position(block.origin).template cast<float>();
  }

  /// Bit n: the middle of strip n is within a bound.
  [[nodiscard]] HWY_INLINE std::uint32_t strips_within(const Eigen::Vector3f& base, const Bound& bound) const {
    std::uint32_t strips = 0;
    for (int n = 0; n < kStrips; n += int(kWidth)) {
      const auto at = [&](const float* of, float from)
                          HWY_ATTR -> Wide { return hn::LoadU(Floats(), of + n) + broadcast(from); };
      const Where hit = bound.hits(at(middles_.x, base.x()), at(middles_.y, base.y()), at(middles_.z, base.z()));
      strips |= bits_of(hit.m) << n;
    }
    return strips;
  }

  /// Bit n: strip n has solid voxels.
  [[nodiscard]] HWY_INLINE static std::uint32_t solid_strips(const BlockView& block) {
    if (block.solid == nullptr) return ~0U;
    const hn::CappedTag<std::uint16_t, kStrips> d;
    std::uint32_t strips = 0;
    for (int n = 0; n < kStrips; n += int(hn::MaxLanes(d))) {
      std::uint16_t words[hn::MaxLanes(d)];
      std::memcpy(words, reinterpret_cast<const char*>(block.solid) + 2 * n, sizeof(words));
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, words), hn::Zero(d)), bits);
      std::uint32_t some = 0;
      std::memcpy(&some, bits, sizeof(some));
      strips |= some << n;
    }
    return strips;
  }

  [[nodiscard]] HWY_INLINE std::uint32_t strips_of_subset(const BlockView& block) const {
    if (job_.level_of_detail <= 1) return ~0U;
    std::uint32_t strips = 0;
    for (int strip = 0; strip < kStrips; ++strip)
      strips |= std::uint32_t(job_.in_subset(block.origin, strip / kStripsPerSlab, strip % kStripsPerSlab)) << strip;
    return strips;
  }

  const Bound near_;                         // bound on centres of voxels that may reach into the head
  const Bound strips_near_, strips_inside_;  // bounds on middles of strips with such voxels, and with no others
  Place lane_offsets_[kVectors];             // [m] offsets of the lanes of a strip, from the strip's first voxel
  const Eigen::Matrix3f steps_;
  const StripOffsets firsts_, middles_;
  const ContactJob& job_;
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
