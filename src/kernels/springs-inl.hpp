// SPDX-License-Identifier: Apache-2.0
// Depth and direction of the material below a head's surface, for a vector of points; included once per instruction
// set.
#if defined(HAPTICUT_KERNELS_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_SPRINGS_INL_HPP
#endif

#include "kernels/profile_springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

// Each shape has these functions. `grown(margin)` is a bound of the head grown by a margin [m], also a negative one;
// its `hits(x, y, z)` tells which of a vector of points may be inside, as far as is known without a square root. `at(x,
// y, z)` gives the springs of the shape, also outside the head (hapticut/formulas/springs.inl). All normals of a shape
// that is `kCentral` meet in the head's origin, so that its springs have no torque about it. `kSmooth`: some of the
// surface may be smooth.

template <class W>
struct SphereVectors {
  static constexpr bool kCentral = true, kSmooth = false;
  float radius;
  formulas::SphereSprings<W> springs;
  HWY_INLINE explicit SphereVectors(const SphereHead& head) : radius(float(head.radius)), springs(head) {}

  struct Grown {
    float squared;
    HWY_INLINE auto hits(W x, W y, W z) const { return x * x + (y * y + z * z) < W(squared); }
  };
  HWY_INLINE Grown grown(float margin) const {
    const float r = std::max(0.0F, radius + margin);
    return {r * r};
  }
  HWY_INLINE SpringVectors<W> at(W x, W y, W z) const {
    const auto [depth, inverse] = springs.about_center(x * x + (y * y + z * z));
    return {depth, inverse, z * inverse, 0};
  }
};

template <class W>
struct ConeVectors {
  static constexpr bool kCentral = false, kSmooth = true;
  float tangent, per_cosine, height;
  formulas::ConeSprings<W> springs;
  HWY_INLINE explicit ConeVectors(const ConeHead& head)
      : tangent(float(std::tan(head.half_angle))),
        per_cosine(float(1 / std::cos(head.half_angle))),
        height(float(head.height)),
        springs(head) {}

  struct Grown {
    float tangent, wider, top;
    HWY_INLINE auto hits(W x, W y, W z) const {
      const W edge = z * tangent + wider;
      return x * x + y * y < edge * edge && (edge > 0 && z < W(top));
    }
  };
  HWY_INLINE Grown grown(float margin) const { return {tangent, margin * per_cosine, height + margin}; }
  HWY_INLINE SpringVectors<W> at(W x, W y, W z) const { return about_axis(springs, x, y, z); }
};

template <class W, FlatRule kRule>
struct FlatVectors {
  static constexpr bool kCentral = false, kSmooth = kRule == FlatRule::nearest;
  float radius, height;
  formulas::FlatSprings<W, kRule> springs;
  HWY_INLINE explicit FlatVectors(const FlatHead& head)
      : radius(float(head.radius)), height(float(head.height)), springs(head) {}

  struct Grown {
    float squared, bottom, top;
    HWY_INLINE auto hits(W x, W y, W z) const { return x * x + y * y < W(squared) && (z > W(bottom) && z < W(top)); }
  };
  HWY_INLINE Grown grown(float margin) const {
    const float r = std::max(0.0F, radius + margin);
    return {r * r, -margin, height + margin};
  }
  HWY_INLINE SpringVectors<W> at(W x, W y, W z) const { return about_axis(springs, x, y, z); }
};

/// Calls `function(springs)` with the springs of the head's shape for vectors W.
template <class W, class Function>
HWY_INLINE auto visit_springs(const ToolHead& head, const Function& function) {
  const ToolHead::Shape& shape = head.shape();
  if (const auto* sphere = std::get_if<SphereHead>(&shape)) return function(SphereVectors<W>(*sphere));
  if (const auto* cone = std::get_if<ConeHead>(&shape)) return function(ConeVectors<W>(*cone));
  if (const auto* profile = std::get_if<ProfileHead>(&shape))
    return profile->table().everywhere != 0 ? function(PlainProfileVectors<W>(profile->table()))
                                            : function(ProfileVectors<W>(profile->table()));
  const FlatHead& flat = *std::get_if<FlatHead>(&shape);
  switch (flat.rule) {
    case FlatRule::bottom_only:
      return function(FlatVectors<W, FlatRule::bottom_only>(flat));
    case FlatRule::side_only:
      return function(FlatVectors<W, FlatRule::side_only>(flat));
    case FlatRule::both:
      return function(FlatVectors<W, FlatRule::both>(flat));
    case FlatRule::nearest:
      break;
  }
  return function(FlatVectors<W, FlatRule::nearest>(flat));
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
