// SPDX-License-Identifier: Apache-2.0
// Depth and direction of the material below a head's surface, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_SPRINGS_INL_HPP
#endif

#include <hwy/highway.h>

#include "kernels/profile_springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Each shape has these functions. `hits(x, y, z, margin)` tells which of a vector of points may be inside the head
/// grown by a margin [m], as far as is known without a square root. `at(x, y, z)` gives the springs at points that may
/// be inside the head; elsewhere its result is undefined. `near(x, y, z)` also works for points a little outside, with
/// a negative depth, as the scalar springs do. All normals of a shape that is `kCentral` meet in the head's origin, so
/// that its springs have no torque about it. `kSmooth`: some of the surface may be smooth.
struct SphereVectors {
  static constexpr bool kCentral = true, kSmooth = false;
  float radius;
  explicit SphereVectors(const SphereHead& head) : radius(float(head.radius)) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, z * z));
    const float grown = std::max(0.0F, radius + margin);
    return squared < same(x, grown * grown);
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V squared = hn::MulAdd(x, x, hn::MulAdd(y, y, z * z));
    const V inverse = inverse_root(hn::Max(squared, same(x, kMinSquare)));
    return {hn::NegMulAdd(squared, inverse, same(x, radius)), inverse, z * inverse, same(x, 0.0F)};
  }
  template <class V>
  HWY_INLINE SpringVectors<V> near(V x, V y, V z) const {
    return at(x, y, z);
  }
};

struct ConeVectors {
  static constexpr bool kCentral = false, kSmooth = true;
  float sine, cosine, height, base_radius;
  explicit ConeVectors(const ConeHead& head)
      : sine(float(std::sin(head.half_angle))),
        cosine(float(std::cos(head.half_angle))),
        height(float(head.height)),
        base_radius(float(head.height * std::tan(head.half_angle))) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V edge = hn::MulAdd(z, same(x, sine / cosine), same(x, margin / cosine));
    const V squared = hn::MulAdd(x, x, y * y);
    return hn::And(squared < edge * edge, hn::And(edge > hn::Zero(hn::DFromV<V>()), z < same(x, height + margin)));
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V zero = same(x, 0.0F), squared = hn::MulAdd(x, x, y * y);
    const V inverse = inverse_root(hn::Max(squared, same(x, kMinSquare))), rho = squared * inverse;
    const V side = hn::MulSub(z, same(x, sine), rho * same(x, cosine));
    const V above = same(x, height) - z, base = depth_below(above, same(x, kBeta));
    const auto on_base = base < side;
    return {depth_below_both(base, side), hn::IfThenElse(on_base, zero, inverse * same(x, cosine)),
            hn::IfThenElse(on_base, same(x, 1.0F), same(x, -sine)),
            hn::IfThenElseZero(on_base, square_from_corner(same(x, base_radius) - rho, above))};
  }
  template <class V>
  HWY_INLINE SpringVectors<V> near(V x, V y, V z) const {
    return at(x, y, z);
  }
};

template <FlatRule kRule>
struct FlatVectors {
  static constexpr bool kCentral = false, kSmooth = kRule == FlatRule::nearest;
  float radius, height;
  explicit FlatVectors(const FlatHead& head) : radius(float(head.radius)), height(float(head.height)) {}
  template <class V>
  HWY_INLINE auto hits(V x, V y, V z, float margin) const {
    const V squared = hn::MulAdd(x, x, y * y);
    const float grown = std::max(0.0F, radius + margin);
    return hn::And(squared < same(x, grown * grown), hn::And(z > same(x, -margin), z < same(x, height + margin)));
  }
  template <class V>
  HWY_INLINE SpringVectors<V> at(V x, V y, V z) const {
    const V zero = same(x, 0.0F);
    const V squared = hn::MulAdd(x, x, y * y);
    const V inverse = inverse_root(hn::Max(squared, same(x, kMinSquare)));
    const V side = hn::NegMulAdd(squared, inverse, same(x, radius)), above = same(x, height) - z;
    const auto inside = hn::Min(hn::Min(z, above), side) > zero;
    if constexpr (kRule == FlatRule::bottom_only) {
      return {hn::IfThenElseZero(inside, z), zero, same(x, -1.0F), zero};
    } else if constexpr (kRule == FlatRule::side_only) {
      return {hn::IfThenElseZero(inside, side), inverse, zero, zero};
    } else if constexpr (kRule == FlatRule::both) {
      const V depth_squared = hn::MulAdd(side, side, z * z);
      const V inverse_depth = inverse_root(hn::Max(depth_squared, same(x, kMinSquare)));
      return {hn::IfThenElseZero(inside, depth_squared * inverse_depth), side * inverse_depth * inverse,
              hn::Neg(z * inverse_depth), zero};
    } else {
      const V cutting = hn::Min(side, z), top = depth_below(above, same(x, kBeta));
      const auto on_top = top < cutting, on_side = hn::AndNot(on_top, side < z);
      const V upwards = hn::IfThenElse(on_top, same(x, 1.0F), same(x, -1.0F));
      return {depth_below_both(cutting, top), hn::IfThenElseZero(on_side, inverse),
              hn::IfThenZeroElse(on_side, upwards), hn::IfThenElseZero(on_top, square_from_corner(side, above))};
    }
  }
  template <class V>
  HWY_INLINE SpringVectors<V> near(V x, V y, V z) const {
    SpringVectors<V> spring = at(x, y, z);
    if constexpr (kRule == FlatRule::nearest) return spring;
    const V zero = same(x, 0.0F), squared = hn::MulAdd(x, x, y * y);
    const V side = hn::NegMulAdd(squared, inverse_root(hn::Max(squared, same(x, kMinSquare))), same(x, radius));
    V depth = spring.depth;
    auto has_surface = z < same(x, height);
    if constexpr (kRule == FlatRule::bottom_only) {
      depth = z;
      has_surface = hn::And(has_surface, side > zero);
    } else if constexpr (kRule == FlatRule::side_only) {
      depth = side;
      has_surface = hn::And(has_surface, z > zero);
    } else {
      has_surface = depth > zero;
    }
    spring.depth = hn::IfThenElse(has_surface, depth, same(x, kFarOutside));
    return spring;
  }
};

/// Calls `function(springs)` with the vector springs of the head's shape.
template <class Function>
HWY_INLINE auto visit_springs(const ToolHead& head, const Function& function) {
  const ToolHead::Shape& shape = head.shape();
  if (const auto* sphere = std::get_if<SphereHead>(&shape)) return function(SphereVectors(*sphere));
  if (const auto* cone = std::get_if<ConeHead>(&shape)) return function(ConeVectors(*cone));
  if (const auto* profile = std::get_if<ProfileHead>(&shape))
    return profile->table().everywhere != 0 ? function(PlainProfileVectors(profile->table()))
                                            : function(ProfileVectors(profile->table()));
  const FlatHead& flat = *std::get_if<FlatHead>(&shape);
  switch (flat.rule) {
    case FlatRule::bottom_only:
      return function(FlatVectors<FlatRule::bottom_only>(flat));
    case FlatRule::side_only:
      return function(FlatVectors<FlatRule::side_only>(flat));
    case FlatRule::both:
      return function(FlatVectors<FlatRule::both>(flat));
    case FlatRule::nearest:
      break;
  }
  return function(FlatVectors<FlatRule::nearest>(flat));
}

/// Component `kShift / 10` of packed centroid offsets, in voxel edges.
template <int kShift, class Words>
HWY_INLINE auto centroid_component(Words packed) {
  const hn::Rebind<float, hn::DFromV<Words>> floats;
  const auto steps = hn::ShiftRight<22>(hn::ShiftLeft<22 - kShift>(packed));
  return hn::ConvertTo(floats, steps) * hn::Set(floats, 1.0F / CentroidOffset::kSteps);
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
