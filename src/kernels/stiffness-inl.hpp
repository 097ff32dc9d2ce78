// SPDX-License-Identifier: Apache-2.0
// Sums of the contact's stiffness, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_STIFFNESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_STIFFNESS_INL_HPP
#undef HAPTICUT_KERNELS_STIFFNESS_INL_HPP
#else
#define HAPTICUT_KERNELS_STIFFNESS_INL_HPP
#endif

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
  HWY_INLINE void add(Vec slope, const Vectors& r, const Vectors& n) {
    const Vec direction[6] = {n.x,
                              n.y,
                              n.z,
                              hn::MulSub(r.y, n.z, r.z * n.y),
                              hn::MulSub(r.z, n.x, r.x * n.z),
                              hn::MulSub(r.x, n.y, r.y * n.x)};
    int term = 0;
    for (int row = 0; row < 6; ++row) {
      const Vec along = slope * direction[row];
      for (int column = row; column < 6; ++column, ++term)
        terms_[term] = hn::MulAdd(along, direction[column], terms_[term]);
    }
  }

  HWY_INLINE void flush(std::size_t part, StiffnessSums& totals) {
    for (std::size_t term = 0; term < StiffnessSums::kTerms; ++term) {
      alignas(64) float lanes[kWidth];
      hn::Store(terms_[term], Floats(), lanes);
      double* total = &totals.lanes[term][part * kWidth];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    }
  }

 private:
  Vec terms_[StiffnessSums::kTerms];
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
