// SPDX-License-Identifier: Apache-2.0
// Springs of a ProfileHead in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_PROFILE_SPRINGS_INL_HPP
#endif

#include <hwy/highway.h>

#include <span>

#include "kernels/spring_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Bounds of a profile: which points may be inside.
struct ProfileBounds {
  static constexpr bool kCentral = false, kSmooth = true;
  float radius, bottom, top;         // [m] see ProfileTable
  const float* slab_radius_squared;  // [m^2]
  float slabs_per_length;            // [1/m]
  std::span<const ProfileCorner<float>> corners;
  explicit ProfileBounds(const ProfileTable& t)
      : radius(float(t.radius)),
        bottom(float(t.bottom)),
        top(float(t.top)),
        slab_radius_squared(t.slab_radius_squared.data()),
        slabs_per_length(ProfileTable::kSlabs / (top - bottom)),
        corners(t.corners) {}

  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, y * y);
    const auto between = hn::And(z > same(z, bottom - margin), z < same(z, top + margin));
    // No point far inside the cylinder is known to be far inside the head: with margin < 0 no point hits.
    const float grown = margin < 0 ? 0.0F : radius + margin;
    const V bound = margin == 0 ? of_slab(z) : same(x, grown * grown);
    return hn::And(squared < bound, between);
  }

  /// Points outside that a curve would call inside lie beyond its end: they are far outside.
  template <class V, class M>
  HWY_INLINE SpringVectors<V> no_deeper_than_the_surface(M outside, SpringVectors<V> spring, V z) const {
    const auto ends = hn::And(outside, spring.depth > same(z, 0.0F));
    spring.depth = hn::IfThenElse(ends, same(z, kFarOutside), spring.depth);
    return spring;
  }

  /// Corrects springs of the table for points that may lie outside its bounds.
  template <class V>
  HWY_INLINE SpringVectors<V> bounded(SpringVectors<V> spring, V x, V y, V z) const {
    const V zero = same(z, 0.0F), rho = hn::Sqrt(hn::MulAdd(x, x, y * y));
    const V beyond = hn::Max(rho - same(z, radius), hn::Max(same(z, bottom) - z, z - same(z, top)));
    spring = no_deeper_than_the_surface(beyond >= zero, spring, z);
    spring.depth = hn::IfThenElse(beyond > zero, hn::Min(spring.depth, hn::Neg(beyond)), spring.depth);
    return spring;
  }

  /// SpringVectors::smooth where `smooth` is set, else 0.
  template <class V, class M>
  HWY_INLINE V from_corners(M smooth, V rho, V z) const {
    const hn::DFromV<V> d;
    V min_square = hn::Zero(d);
    if (hn::AllFalse(d, smooth)) return min_square;
    min_square = same(z, 1.0F);
    for (const ProfileCorner<float>& corner : corners)
      min_square = hn::Min(min_square, square_from_corner(rho - same(z, corner.rho), z - same(z, corner.z)));
    return hn::IfThenElseZero(smooth, min_square);
  }

  /// Whole part of 0 <= v < 2^22; of a whole number that, or one less. From 2^23 on the last bit is the unit.
  template <class V>
  HWY_INLINE static auto floor_of(V v) {
    const hn::RebindToSigned<hn::DFromV<V>> ints;
    constexpr float kUnit = 12582912.0F;  // 2^23 + 2^22, also for v - 0.5 < 0
    const V sum = v - same(v, 0.5F) + same(v, kUnit);
    return hn::BitCast(ints, sum) - hn::BitCast(ints, same(v, kUnit));
  }

 private:
  /// [m^2] of the slabs at heights z; beyond the head, of the first and the last.
  template <class V>
  HWY_INLINE V of_slab(V z) const {
    const hn::DFromV<V> d;
    constexpr float kLast = ProfileTable::kSlabs - 1;
    const V height = (z - same(z, bottom)) * same(z, slabs_per_length);
    const auto slab = floor_of(hn::Min(hn::Max(height, hn::Zero(d)), same(z, kLast + 0.5F)));
    if constexpr (hn::MaxLanes(hn::DFromV<V>()) == ProfileTable::kSlabs)
      return hn::TableLookupLanes(hn::LoadU(d, slab_radius_squared), hn::IndicesFromVec(d, slab));
    else
      return hn::GatherIndex(d, slab_radius_squared, slab);
  }
};

/// One line or arc for all points of a vector, with few operations; see ProfileCurves.
class CurveSprings {
 public:
  CurveSprings(const ProfileTable& t, std::uint32_t n)
      : start_rho_(float(t.exact_curves.rho[n])),
        start_z_(float(t.exact_curves.z[n])),
        normal_rho_(float(t.exact_curves.normal_rho[n])),
        normal_z_(float(t.exact_curves.normal_z[n])),
        scale_(float(t.exact_curves.scale[n])) {
    const ProfileCurves<double>& c = t.exact_curves;
    const double k = c.curvature[n];
    if (k == 0) {
      kind_ = Kind::line;
      offset_ = float(c.normal_rho[n] * c.rho[n] + c.normal_z[n] * c.z[n]);
      return;
    }
    const double center_rho = c.rho[n] + c.normal_rho[n] / k, size = std::max(t.radius, t.top - t.bottom);
    const bool about_axis = std::abs(center_rho * k) < kOnAxis && std::abs(k) * size >= 1;
    kind_ = about_axis ? Kind::arc_about_axis : Kind::arc;
    center_rho_ = float(center_rho);
    center_z_ = float(c.z[n] + c.normal_z[n] / k);
    curvature_ = float(k);
    radius_ = float(1 / k);
    sense_ = k > 0 ? 1.0F : -1.0F;
  }

  [[nodiscard]] bool is_smooth() const { return scale_ > 1; }

  /// Where points are beyond the curve's starting point, towards the shank.
  template <class V>
  HWY_INLINE auto begins_before(V rho, V z) const {
    return same(z, normal_z_) * (rho - same(z, start_rho_)) >= same(z, normal_rho_) * (z - same(z, start_z_));
  }

  /// @param squared      [m^2] rho^2
  /// @param inverse_rho  [1/m]
  /// @return without SpringVectors::smooth
  template <class V>
  HWY_INLINE SpringVectors<V> at(V squared, V inverse_rho, V rho, V z) const {
    const V m_rho = same(z, normal_rho_), m_z = same(z, normal_z_), zero = same(z, 0.0F), scale = same(z, scale_);
    if (kind_ == Kind::line)
      return {depth_below(hn::MulAdd(m_rho, rho, hn::MulSub(m_z, z, same(z, offset_))), scale),
              hn::Neg(m_rho * inverse_rho), hn::Neg(m_z), zero};
    const V v_z = z - same(z, center_z_), sense = same(z, sense_);
    if (kind_ == Kind::arc_about_axis) {
      const V distance_squared = hn::MulAdd(v_z, v_z, squared);
      const V inward = sense * inverse_root(hn::Max(distance_squared, same(z, kMinSquare)));
      return {depth_below(hn::NegMulAdd(distance_squared, inward, same(z, radius_)), scale), inward, inward * v_z,
              zero};
    }
    // R - |x - c| without its cancellation, because the arc may be flat.
    const V v_rho = rho - same(z, center_rho_);
    const V q_rho = rho - same(z, start_rho_), q_z = z - same(z, start_z_);
    const V distance_squared = hn::MulAdd(v_rho, v_rho, v_z * v_z);
    const V inverse = inverse_root(hn::Max(distance_squared, same(z, kMinSquare)));
    const V curvature = same(z, curvature_), signed_inverse = sense * inverse;
    const V inward = hn::MulAdd(m_rho, q_rho, m_z * q_z);
    const V twice = hn::NegMulAdd(curvature, hn::MulAdd(q_rho, q_rho, q_z * q_z), inward + inward);
    const V root = curvature * (distance_squared * signed_inverse);
    return {depth_below(twice / (same(z, 1.0F) + root), scale), signed_inverse * inverse_rho * v_rho,
            signed_inverse * v_z, zero};
  }

 private:
  enum class Kind { line, arc, arc_about_axis };  // arc_about_axis: no flatter than the head
  static constexpr double kOnAxis = 1e-7;         // [1] of the radius

  float start_rho_, start_z_;            // [m] see ProfileCurves
  float normal_rho_, normal_z_;          // [1]
  float scale_;                          // [1]
  float offset_ = 0;                     // [m] of a line: from the origin, along its normal
  float center_rho_ = 0, center_z_ = 0;  // [m] of an arc
  float radius_ = 0, curvature_ = 0;     // [m], [1/m] of an arc; negative where it is hollow
  float sense_ = 1;                      // [1] sign of the curvature
  Kind kind_;
};

/// A profile for which one rule holds everywhere: ProfileTable::everywhere and lid.
struct PlainProfileVectors : ProfileBounds {
  CellRule rule;
  bool has_lid;
  CurveSprings first, second, lid;
  explicit PlainProfileVectors(const ProfileTable& t)
      : ProfileBounds(t),
        rule(ProfileCell::rule(t.everywhere)),
        has_lid(t.lid != 0),
        first(t, ProfileCell::first(t.everywhere)),
        second(t, ProfileCell::second(t.everywhere)),
        lid(t, t.lid) {}

  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const hn::DFromV<V> d;
    const V squared = hn::MulAdd(x, x, y * y);
    const V inverse_rho = inverse_root(hn::Max(squared, same(x, kMinSquare)));
    const V rho = squared * inverse_rho;
    SpringVectors<V> spring = first.at(squared, inverse_rho, rho, z);
    auto smooth = hn::FirstN(d, first.is_smooth() ? hn::Lanes(d) : 0);
    const auto select = [&](auto where, const CurveSprings& curve, const SpringVectors<V>& other) HWY_ATTR {
      spring.depth = hn::IfThenElse(where, other.depth, spring.depth);
      spring.radial = hn::IfThenElse(where, other.radial, spring.radial);
      spring.axial = hn::IfThenElse(where, other.axial, spring.axial);
      smooth = curve.is_smooth() ? hn::Or(smooth, where) : hn::AndNot(where, smooth);
    };
    const auto select_nearer = [&](const CurveSprings& curve, const SpringVectors<V>& other) HWY_ATTR {
      const V depth = depth_below_both(spring.depth, other.depth);
      const auto is_edge_of_both = curve.is_smooth() ? hn::Not(smooth) : smooth;
      const V lesser = hn::Min(spring.depth, other.depth);
      select(other.depth < spring.depth, curve, other);
      spring.depth = hn::IfThenElse(is_edge_of_both, depth, lesser);
    };
    if (rule == CellRule::nearer) {
      select_nearer(second, second.at(squared, inverse_rho, rho, z));
    } else if (rule != CellRule::first) {
      const SpringVectors<V> other = second.at(squared, inverse_rho, rho, z);
      select(rule == CellRule::sides ? second.begins_before(rho, z) : other.depth > spring.depth, second, other);
    }
    if (has_lid) select_nearer(lid, lid.at(squared, inverse_rho, rho, z));
    spring.smooth = from_corners(smooth, rho, z);
    return spring;
  }
  template <class V>
  HWY_INLINE SpringVectors<V> near(V x, V y, V z) const {
    return bounded(at(x, y, z), x, y, z);
  }
};

/// Curves of a profile for a vector of points: see ProfileCurves.
template <class V>
struct CurveVectors {
  V rho, z, normal_rho, normal_z, curvature, scale;

  /// Where points are beyond the curve's starting point, towards the shank.
  HWY_INLINE auto begins_before(V at_rho, V at_z) const { return normal_z * (at_rho - rho) >= normal_rho * (at_z - z); }
  /// These curves, replaced by `other` where the mask is set.
  template <class M>
  HWY_INLINE CurveVectors unless(M mask, const CurveVectors& other) const {
    return {hn::IfThenElse(mask, other.rho, rho),
            hn::IfThenElse(mask, other.z, z),
            hn::IfThenElse(mask, other.normal_rho, normal_rho),
            hn::IfThenElse(mask, other.normal_z, normal_z),
            hn::IfThenElse(mask, other.curvature, curvature),
            hn::IfThenElse(mask, other.scale, scale)};
  }
};

/// Springs in the (rho, z) half-plane, before the last divisions: `ProfileSprings::below` for a vector of curves.
template <class V>
struct MeridianVectors {
  V twice, root;  // depth = twice / (1 + root), with the curve's scale
  V g_rho, g_z;   // direction = g / root
  V inverse_root, scale;

  HWY_INLINE MeridianVectors(const CurveVectors<V>& c, V rho, V z) {
    const V q_rho = rho - c.rho, q_z = z - c.z;
    const V inward = hn::MulAdd(c.normal_rho, q_rho, c.normal_z * q_z);
    scale = c.scale;
    twice = depth_below(hn::NegMulAdd(c.curvature, hn::MulAdd(q_rho, q_rho, q_z * q_z), inward + inward), scale);
    g_rho = hn::MulSub(c.curvature, q_rho, c.normal_rho), g_z = hn::MulSub(c.curvature, q_z, c.normal_z);
    const V squared = hn::MulAdd(g_rho, g_rho, g_z * g_z);
    inverse_root = kernels::HWY_NAMESPACE::inverse_root(hn::Max(squared, same(z, kMinSquare)));
    root = squared * inverse_root;
  }
  /// Positive where the other depth is larger, negative where it is smaller.
  HWY_INLINE V deeper(const MeridianVectors& other) const {
    return hn::MulSub(other.twice, same(root, 1.0F) + root, hn::MulAdd(twice, other.root, twice));
  }
  template <class M>
  HWY_INLINE void select(M mask, const MeridianVectors& other) {
    twice = hn::IfThenElse(mask, other.twice, twice), root = hn::IfThenElse(mask, other.root, root);
    g_rho = hn::IfThenElse(mask, other.g_rho, g_rho), g_z = hn::IfThenElse(mask, other.g_z, g_z);
    inverse_root = hn::IfThenElse(mask, other.inverse_root, inverse_root);
    scale = hn::IfThenElse(mask, other.scale, scale);
  }
  /// @param smooth  of all lanes
  HWY_INLINE SpringVectors<V> spring(V inverse_rho, V smooth) const {
    return {twice / (same(root, 1.0F) + root), g_rho * inverse_root * inverse_rho, g_z * inverse_root, smooth};
  }
  [[nodiscard]] HWY_INLINE auto is_smooth() const { return scale > same(scale, 1.0F); }
};

/// The curve of its cell for every point: see ProfileSprings.
struct ProfileVectors : ProfileBounds {
  ProfileSprings<float> table;
  explicit ProfileVectors(const ProfileTable& t) : ProfileBounds(t), table(t) {}

  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V squared = hn::MulAdd(x, x, y * y);
    const V inverse_rho = inverse_root(hn::Max(squared, same(x, kMinSquare)));
    const V rho = squared * inverse_rho;
    const auto bounds = hn::And(rho < same(rho, radius), hn::And(z > same(z, bottom), z < same(z, top)));
    return decide(cell_at(table.cells, rho, z, bounds), rho, inverse_rho, z);
  }
  template <class V>
  HWY_INLINE SpringVectors<V> near(V x, V y, V z) const {
    const V squared = hn::MulAdd(x, x, y * y);
    const V inverse_rho = inverse_root(hn::Max(squared, same(x, kMinSquare)));
    const V rho = squared * inverse_rho;
    const V cell_rho = hn::Min(rho, same(x, radius)), cell_z = hn::Max(z, same(x, bottom));
    const auto cell =
        cell_at(table.cells_near, cell_rho, cell_z, hn::FirstN(hn::DFromV<V>(), hn::Lanes(hn::DFromV<V>())));
    const auto ints = hn::DFromV<decltype(cell)>();
    const auto outside = hn::RebindMask(hn::DFromV<V>(), cell < hn::Zero(ints));  // ProfileCell::kOutside
    const auto of_head = hn::And(cell, hn::Set(ints, 0x7fffffff));
    const auto spring = no_deeper_than_the_surface(outside, decide(of_head, rho, inverse_rho, z), z);
    return bounded(spring, x, y, z);
  }

 private:
  /// Cells at (rho, z); 0 outside `bounds`.
  template <class V, class M>
  HWY_INLINE auto cell_at(const std::uint32_t* cells, V rho, V z, M bounds) const {
    const hn::RebindToSigned<hn::DFromV<V>> ints;
    const V scale = same(z, table.cells_per_length);
    const auto column = hn::Min(floor_of(rho * scale), hn::Set(ints, table.columns - 1));
    const auto row = hn::Min(floor_of((z - same(z, bottom)) * scale), hn::Set(ints, table.rows - 1));
    const auto within = hn::RebindMask(ints, bounds);
    const auto index = hn::IfThenElseZero(within, row * hn::Set(ints, table.columns) + column);
    return hn::IfThenElseZero(within, hn::GatherIndex(ints, reinterpret_cast<const std::int32_t*>(cells), index));
  }

  /// The springs at (rho, z) by the rules of cells.
  template <class I, class V>
  HWY_INLINE SpringVectors<V> decide(I cell, V rho, V inverse_rho, V z) const {
    const hn::DFromV<V> d;
    const hn::RebindToSigned<hn::DFromV<V>> ints;
    const auto zero = hn::Zero(ints);
    const auto curve_bits = hn::Set(ints, std::int32_t(ProfileCell::kMaxCurves - 1));
    const auto rule = hn::ShiftRight<28>(cell);

    CurveVectors<V> curve = of_curves(hn::And(cell, curve_bits), d);
    const auto spring_of = [&](const MeridianVectors<V>& meridian) HWY_ATTR {
      return meridian.spring(inverse_rho, from_corners(meridian.is_smooth(), rho, z));
    };
    if (hn::AllTrue(ints, hn::Eq(rule, zero))) return spring_of(MeridianVectors<V>(curve, rho, z));
    const CurveVectors<V> other = of_curves(hn::And(hn::ShiftRight<14>(cell), curve_bits), d);
    const auto is = [&](CellRule r) HWY_ATTR { return hn::RebindMask(d, hn::Eq(rule, hn::Set(ints, int(r)))); };
    curve = curve.unless(hn::And(is(CellRule::sides), other.begins_before(rho, z)), other);
    MeridianVectors<V> meridian(curve, rho, z);
    const MeridianVectors<V> second(other, rho, z);
    const V deeper = meridian.deeper(second);
    const auto nearer = hn::And(is(CellRule::nearer), deeper < hn::Zero(d));
    const auto farther = hn::And(is(CellRule::farther), deeper > hn::Zero(d));
    meridian.select(hn::Or(nearer, farther), second);
    return spring_of(meridian);
  }

  template <class I, class D>
  HWY_INLINE CurveVectors<hn::Vec<D>> of_curves(I curve, D d) const {
    const hn::DFromV<I> ints;
    const std::int32_t one = hn::GetLane(curve);
    if (table.curve_count <= hn::MaxLanes(d)) {
      // The numbers of all curves fit into a vector each: no need to gather them from memory.
      const auto order = hn::IndicesFromVec(d, curve);
      const auto of = [&](const float* all) HWY_ATTR { return hn::TableLookupLanes(hn::LoadU(d, all), order); };
      return {of(table.rho),      of(table.z),         of(table.normal_rho),
              of(table.normal_z), of(table.curvature), of(table.scale)};
    }
    if (hn::AllTrue(ints, hn::Eq(curve, hn::Set(ints, one)))) {
      const auto of = [&](const float* all) HWY_ATTR { return hn::Set(d, all[one]); };
      return {of(table.rho),      of(table.z),         of(table.normal_rho),
              of(table.normal_z), of(table.curvature), of(table.scale)};
    }
    const auto of = [&](const float* all) HWY_ATTR { return hn::GatherIndex(d, all, curve); };
    return {of(table.rho), of(table.z), of(table.normal_rho), of(table.normal_z), of(table.curvature), of(table.scale)};
  }
};

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
