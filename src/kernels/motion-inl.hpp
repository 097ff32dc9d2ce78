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

/// [m^2/s^2] Square of the slip at the voxels' centres: of the velocity across the normal.
HWY_INLINE Vec slip_of_centers(const Vectors& velocity, const Sample& s) {
  return hn::Max(hn::Zero(Floats()), hn::NegMulAdd(s.rate, s.rate, dot(velocity, velocity)));
}

/// [m/s] Closing speed of voxels along the normal: n (v + omega x r) = v n + omega (r x n).
template <bool kCentral>
HWY_INLINE Vec rate_of_depth(const Vectors& r, const Sample& s, const Eigen::Vector3f& v,
                             const Eigen::Vector3f& omega) {
  const Vec across = hn::MulAdd(r.x, broadcast(v.x()), r.y * broadcast(v.y()));
  const Vec rate = hn::MulAdd(s.radial, across, s.axial * broadcast(v.z()));
  if constexpr (kCentral) return rate;
  const Vec turning = hn::MulSub(r.y, broadcast(omega.x()), r.x * broadcast(omega.y()));
  return hn::MulAdd(s.lever(r), turning, rate);
}

/// [m^2/s^2] FoundationLaw::AxisSlip::squared less the square of the slip at the voxel's centre.
HWY_INLINE Vec slip_about_axis(const HeadMotion& m, const Vectors& r, Vec of_center) {
  using Slip = FoundationLaw::AxisSlip;
  const Slip slip(m);
  const Vec one = broadcast(1.0F), q = hn::MulAdd(r.x, r.x, r.y * r.y) * broadcast(slip.per_edge);
  const Vec below = hn::MulAdd(q * q, hn::MulAdd(q, broadcast(Slip::kSteep), broadcast(Slip::kFlat)), one);
  const Vec peak = broadcast(Slip::kPeak) * hn::NegMulAdd(q, broadcast(Slip::kZero), one);
  const Vec excess = broadcast(slip.per_slip) * (peak / below + broadcast(Slip::kFar));
  const Vec beyond = hn::Max(excess, broadcast(slip.min_squared) - of_center);
  return hn::IfThenElseZero(q < broadcast(FoundationLaw::kAxisZone * FoundationLaw::kAxisZone), beyond);
}

/// [m^2/s^2] slip_about_axis of sampled voxels, against which the couple about the axis does work.
HWY_INLINE Vec slip_beyond_centers(const HeadMotion& m, const Vectors& r, const Sample& s) {
  return slip_about_axis(m, r, slip_of_centers(surface_velocity(m, r), s));
}

/// [1] the largest |n_i| along the grid's axes, which are the columns of `axes`, of unit vectors n
HWY_INLINE Vec max_component_of(const Eigen::Matrix3f& axes, const Vectors& r, const Sample& s) {
  Vec max_component = broadcast(kMinMaxNorm);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec across = hn::MulAdd(r.x, broadcast(axes(0, axis)), r.y * broadcast(axes(1, axis)));
    max_component = hn::Max(max_component, hn::Abs(hn::MulAdd(s.radial, across, s.axial * broadcast(axes(2, axis)))));
  }
  return hn::Min(max_component, broadcast(1.0F));
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
