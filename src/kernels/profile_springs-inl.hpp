// SPDX-License-Identifier: Apache-2.0
// Springs of heads of any profile, for a vector of points; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#endif

#include "kernels/wide-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

/// Bounds of a profile: which points may be inside.
template <class W>
struct ProfileBounds {
  static constexpr bool kCentral = false, kSmooth = true;
  using D = hn::DFromV<typename W::Vector>;
  float radius, bottom, top;         // [m] see ProfileTable
  const float* slab_radius_squared;  // [m^2]
  float slabs_per_length;            // [1/m]
  std::span<const ProfileCorner<float>> corners;
  HWY_INLINE explicit ProfileBounds(const ProfileTable& t)
      : radius(float(t.radius)),
        bottom(float(t.bottom)),
        top(float(t.top)),
        slab_radius_squared(t.slab_radius_squared.data()),
        slabs_per_length(ProfileTable::kSlabs / (top - bottom)),
        corners(t.corners) {}

  /// The largest radius in each of a few slabs; beyond the head, of the first and the last.
  struct Grown {
    float bottom, slabs_per_length, low, high;
    alignas(64) float squares[ProfileTable::kSlabs];  // [m^2]

    HWY_INLINE auto hits(W x, W y, W z) const {
      constexpr float kLast = ProfileTable::kSlabs - 1;
      const auto slab = floor_of(min(max((z - bottom) * slabs_per_length, 0), kLast + 0.5F));
      W bound;
      if constexpr (hn::MaxLanes(D()) == ProfileTable::kSlabs)
        bound = hn::TableLookupLanes(hn::Load(D(), squares), hn::IndicesFromVec(D(), slab));
      else
        bound = hn::GatherIndex(D(), squares, slab);
      return x * x + y * y < bound && (z > W(low) && z < W(high));
    }
  };
  /// No point far inside the cylinder around the head is known to be far inside the head: with margin < 0 no point
  /// hits.
  HWY_INLINE Grown grown(float margin) const {
    Grown g = {bottom, slabs_per_length, bottom - margin, top + margin, {}};
    // Outside a corner the springs are those of its curves, which are nearer than the corner: hence twice the margin.
    const int reach = int(std::ceil(2 * margin * slabs_per_length));
    for (int slab = 0; slab < ProfileTable::kSlabs && margin >= 0; ++slab) {
      float most = 0;
      for (int other = std::max(0, slab - reach); other <= std::min(ProfileTable::kSlabs - 1, slab + reach); ++other)
        most = std::max(most, slab_radius_squared[other]);
      const float r = std::min(std::sqrt(most) + 2 * margin, radius + margin);
      g.squares[slab] = margin == 0 ? most : r * r;
    }
    return g;
  }

  /// Whole part of 0 <= v < 2^22; of a whole number that, or one less. From 2^23 on the last bit is the unit.
  HWY_INLINE static auto floor_of(W v) {
    const hn::RebindToSigned<D> ints;
    constexpr float kUnit = 12582912.0F;  // 2^23 + 2^22, also for v - 0.5 < 0
    return hn::BitCast(ints, (v - 0.5F + kUnit).v) - hn::BitCast(ints, W(kUnit).v);
  }
};

/// A profile for which one rule applies everywhere: ProfileTable::everywhere and lid.
template <class W>
struct PlainProfileVectors : ProfileBounds<W> {
  using Curve = formulas::CurveSprings<W>;
  CellRule rule;
  bool has_lid;
  Curve first, second, lid;
  HWY_INLINE explicit PlainProfileVectors(const ProfileTable& t)
      : ProfileBounds<W>(t),
        rule(ProfileCell::rule(t.everywhere)),
        has_lid(t.lid != 0),
        first(curve(t, ProfileCell::first(t.everywhere))),
        second(curve(t, ProfileCell::second(t.everywhere))),
        lid(curve(t, t.lid)) {}

  HWY_INLINE formulas::SpatialSpring<W> at(W x, W y, W z) const { return formulas::about_axis(*this, x, y, z); }
  HWY_INLINE formulas::MeridianSpring<W> spring(W rho, W z) const {
    formulas::DecidingCurve<W> found(first, rho, z);
    if (rule != CellRule::first) found.decide(rule, second, rho, z);
    if (has_lid) found.decide(CellRule::nearer, lid, rho, z);
    return found.bounded(*this, W(0) > 0, rho, z);
  }

 private:
  HWY_INLINE static Curve curve(const ProfileTable& t, std::uint32_t n) {
    const ProfileCurves<float>& c = t.curves;
    return {c.rho[n], c.z[n], c.normal_rho[n], c.normal_z[n], c.curvature[n], c.scale[n]};
  }
};

/// The curve of its cell for every point: see ProfileSprings.
template <class W>
struct ProfileVectors : ProfileBounds<W> {
  using Base = ProfileBounds<W>;
  using D = typename Base::D;
  ProfileSprings<float> table;
  HWY_INLINE explicit ProfileVectors(const ProfileTable& t) : Base(t), table(t) {}

  HWY_INLINE formulas::SpatialSpring<W> at(W x, W y, W z) const { return formulas::about_axis(*this, x, y, z); }
  HWY_INLINE formulas::MeridianSpring<W> spring(W rho, W z) const {
    const hn::RebindToSigned<D> ints;
    const auto column =
        hn::Min(Base::floor_of(min(rho, Base::radius) * table.cells_per_length), hn::Set(ints, table.columns - 1));
    const auto row = hn::Min(Base::floor_of((max(z, Base::bottom) - Base::bottom) * table.cells_per_length),
                             hn::Set(ints, table.rows - 1));
    const auto cell = hn::GatherIndex(ints, reinterpret_cast<const std::int32_t*>(table.cells_near),
                                      row * hn::Set(ints, table.columns) + column);
    const formulas::WhereOf<D> outside = {hn::RebindMask(D(), cell < hn::Zero(ints))};  // ProfileCell::kOutside
    const auto rule = hn::And(hn::ShiftRight<28>(cell), hn::Set(ints, 7));
    const auto curve_bits = hn::Set(ints, std::int32_t(ProfileCell::kMaxCurves - 1));
    formulas::DecidingCurve<W> found(curves(hn::And(cell, curve_bits)), rho, z);
    if (!hn::AllTrue(ints, hn::Eq(rule, hn::Zero(ints)))) {
      const auto is = [&](CellRule r) HWY_ATTR {
        return formulas::WhereOf<D>{hn::RebindMask(D(), hn::Eq(rule, hn::Set(ints, int(r))))};
      };
      found.decide(is(CellRule::nearer), is(CellRule::farther), is(CellRule::sides),
                   curves(hn::And(hn::ShiftRight<14>(cell), curve_bits)), rho, z);
    }
    return found.bounded(*this, outside, rho, z);
  }

 private:
  template <class I>
  HWY_INLINE formulas::CurveSprings<W> curves(I curve) const {
    const hn::DFromV<I> ints;
    const std::int32_t one = hn::GetLane(curve);
    const auto each = [&](const auto& of) HWY_ATTR -> formulas::CurveSprings<W> {
      return {of(table.rho),      of(table.z),         of(table.normal_rho),
              of(table.normal_z), of(table.curvature), of(table.scale)};
    };
    if (table.curve_count <= hn::MaxLanes(D())) {
      // The numbers of all curves fit into a vector each: no need to gather them from memory.
      const auto order = hn::IndicesFromVec(D(), curve);
      return each([&](const float* all) HWY_ATTR -> W { return hn::TableLookupLanes(hn::LoadU(D(), all), order); });
    }
    if (hn::AllTrue(ints, hn::Eq(curve, hn::Set(ints, one))))
      return each([&](const float* all) HWY_ATTR -> W { return all[one]; });
    return each([&](const float* all) HWY_ATTR -> W { return hn::GatherIndex(D(), all, curve); });
  }
};

namespace formulas {
/// Calls `function(springs)` with the springs of a profile.
template <class W, class Function>
HWY_INLINE decltype(auto) with_springs(const ProfileHead& head, const Function& function) {
  return head.table().everywhere != 0 ? function(PlainProfileVectors<W>(head.table()))
                                      : function(ProfileVectors<W>(head.table()));
}
}  // namespace formulas

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
