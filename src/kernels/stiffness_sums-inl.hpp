// SPDX-License-Identifier: Apache-2.0
// Sums of the contact's stiffness, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_STIFFNESS_SUMS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_STIFFNESS_SUMS_INL_HPP
#undef HAPTICUT_KERNELS_STIFFNESS_SUMS_INL_HPP
#else
#define HAPTICUT_KERNELS_STIFFNESS_SUMS_INL_HPP
#endif

#include "kernels/motion-inl.hpp"
#include "kernels/press_sums-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// StiffnessSums of one vector of lanes over the voxels of a few blocks; begins with `clear`.
class StiffnessVectors {
 public:
  HWY_INLINE void clear() {
    for (Vec& term : terms_) term = broadcast(0.0F);
  }

  /// @param slope  [N/m^4] of the springs; zero in lanes without one
  /// @param q      force for a unit normal force, with its drag
  HWY_NOINLINE void add(Vec slope, const Vectors& r, const Vectors& n, const Vectors& q) {
    const Vec row[6] = {q.x, q.y, q.z, cross_x(r, q), cross_y(r, q), cross_z(r, q)};
    const Vec column[6] = {n.x, n.y, n.z, cross_x(r, n), cross_y(r, n), cross_z(r, n)};
    for (int i = 0; i < 6; ++i) {
      const Vec along = slope * row[i];
      for (int j = 0; j < 6; ++j) terms_[6 * i + j] = hn::MulAdd(along, column[j], terms_[6 * i + j]);
    }
  }

  HWY_INLINE void flush(StiffnessSums& totals) {
    for (std::size_t term = 0; term < StiffnessSums::kTerms; ++term) {
      alignas(64) float lanes[kWidth];
      hn::Store(terms_[term], Floats(), lanes);
      double* total = &totals.lanes[term][0];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    }
  }

 private:
  static HWY_INLINE Vec cross_x(const Vectors& r, const Vectors& n) { return hn::MulSub(r.y, n.z, r.z * n.y); }
  static HWY_INLINE Vec cross_y(const Vectors& r, const Vectors& n) { return hn::MulSub(r.z, n.x, r.x * n.z); }
  static HWY_INLINE Vec cross_z(const Vectors& r, const Vectors& n) { return hn::MulSub(r.x, n.y, r.y * n.x); }

  Vec terms_[StiffnessSums::kTerms];
};

/// Adds springs along the normals with the drag of the spin, and the rotation of the drag with the slip.
/// @param slope   [N/m^4]
/// @param normal  [N/m^3] force along the normals
/// @param kappa   [1] 0: the spindle stands
HWY_INLINE void add_springs(const HeadMotion& m, Vec slope, Vec normal, Vec kappa, const Vectors& r, const Sample& s,
                            StiffnessVectors& sums) {
  const Vectors n = {r.x * s.radial, r.y * s.radial, s.axial}, v = surface_velocity(m, r);
  const Vec drag = kappa * s.inverse_slip, along = hn::NegMulAdd(drag, s.rate, broadcast(1.0F));
  sums.add(
      slope, r, n,
      {hn::MulAdd(along, n.x, drag * v.x), hn::MulAdd(along, n.y, drag * v.y), hn::MulAdd(along, n.z, drag * v.z)});
  if (m.spin == 0) return;
  const Vectors b = {hn::MulSub(n.y, v.z, n.z * v.y), hn::MulSub(n.z, v.x, n.x * v.z), hn::MulSub(n.x, v.y, n.y * v.x)};
  const Vec square = dot(b, b), min_square = broadcast(1e-12F);
  const Vec damper = hn::IfThenElseZero(square > min_square,
                                        drag * normal / (hn::Max(square, min_square) * broadcast(m.time_to_move())));
  sums.add(damper, r, b, b);
  constexpr float kRegular = FoundationLaw::kSlipRegularization, kSlow = StiffnessSums::kSlowSlip;
  const auto slow = square <= broadcast(kSlow * kSlow);
  if (hn::AllFalse(Floats(), slow)) return;
  const Vec min_slip = broadcast(kRegular * kRegular), into = hn::Neg(dot(n, v));
  const Vectors t = {hn::MulAdd(into, n.x, v.x), hn::MulAdd(into, n.y, v.y), hn::MulAdd(into, n.z, v.z)};
  sums.add(hn::IfThenElseZero(slow, damper * min_slip / (square + min_slip)), r, t, t);
}

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
