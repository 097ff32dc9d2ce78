// SPDX-License-Identifier: Apache-2.0
// How the surface of the head moves at a vector of voxels; included once per instruction set.
#if defined(HAPTICUT_KERNELS_MOTION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_MOTION_INL_HPP
#undef HAPTICUT_KERNELS_MOTION_INL_HPP
#else
#define HAPTICUT_KERNELS_MOTION_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/press_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// [m/s] v + omega x r of the head's turning surface, in T
HWY_INLINE Vectors surface_velocity(const HeadMotion& m, const Vectors& r) {
  return velocity_at(r, m.velocity, m.angular_velocity + Eigen::Vector3f(0, 0, m.spin));
}

/// [m/s] how fast voxels come nearer along the normal: n (v + omega x r) = v n + omega (r x n)
template <bool kCentral>
HWY_INLINE Vec rate_of_depth(const Vectors& r, const Sample& s, const Eigen::Vector3f& v,
                             const Eigen::Vector3f& omega) {
  const Vec across = hn::MulAdd(r.x, broadcast(v.x()), r.y * broadcast(v.y()));
  const Vec rate = hn::MulAdd(s.radial, across, s.axial * broadcast(v.z()));
  if constexpr (kCentral) return rate;
  const Vec turning = hn::MulSub(r.y, broadcast(omega.x()), r.x * broadcast(omega.y()));
  return hn::MulAdd(s.lever(r), turning, rate);
}

/// [m^2/s^2] square of the mean slip that a voxel near the axis has beyond that of its centre
HWY_INLINE Vec axis_slip_squared(const HeadMotion& m, const Vectors& r) {
  const Vec rho_squared = hn::MulAdd(r.x, r.x, r.y * r.y);
  const Vec zone = hn::NegMulAdd(rho_squared, broadcast(FoundationLaw::axis_zone_factor(m)), broadcast(1.0F));
  const Vec inner = hn::Max(hn::Zero(Floats()), zone);
  return broadcast(FoundationLaw::axis_slip_squared(m)) * (inner * inner);
}

/// [1] the largest |n_i| along the grid's axes, which are the columns of `axes`
HWY_INLINE Vec largest_component(const Eigen::Matrix3f& axes, const Vectors& r, const Sample& s) {
  Vec largest = broadcast(kLeastLargest);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec across = hn::MulAdd(r.x, broadcast(axes(0, axis)), r.y * broadcast(axes(1, axis)));
    largest = hn::Max(largest, hn::Abs(hn::MulAdd(s.radial, across, s.axial * broadcast(axes(2, axis)))));
  }
  return hn::Min(largest, broadcast(1.0F));
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
