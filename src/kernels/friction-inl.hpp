// SPDX-License-Identifier: Apache-2.0
// Sums for the dry friction of a standing head; included once per instruction set.
#if defined(HAPTICUT_KERNELS_FRICTION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_FRICTION_INL_HPP
#undef HAPTICUT_KERNELS_FRICTION_INL_HPP
#else
#define HAPTICUT_KERNELS_FRICTION_INL_HPP
#endif

#include "kernels/press_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Friction constants of the materials of a vector of voxels.
struct FrictionConstants {
  alignas(64) float static_friction[kWidth], dynamic_friction[kWidth], tangential_stiffness[kWidth], stiffness[kWidth];

  /// @param id_of  of a lane
  template <class IdOf>
  HWY_INLINE FrictionConstants(const ContactMaterials& table, const IdOf& id_of) {
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      const ContactMaterial& m = table[id_of(int(lane))];
      static_friction[lane] = m.static_friction;
      dynamic_friction[lane] = m.dynamic_friction;
      tangential_stiffness[lane] = m.tangential_stiffness;
      stiffness[lane] = m.stiffness;
    }
  }
};

/// FrictionSums of one vector of lanes; begins with `clear`.
class FrictionVectors {
 public:
  HWY_INLINE void clear() {
    for (Vec& term : terms_) term = broadcast(0.0F);
  }

  /// @param normal  [N/m^3] normal force; zero in lanes without contact
  /// @param filled  [1] part of the volume that is in contact
  /// @param radial, axial  of the normals, as in SpringVectors
  HWY_NOINLINE void add(Vec normal, Vec filled, const FrictionConstants& constants, const Vectors& r, Vec radial,
                        Vec axial) {
    using Term = FrictionSums::Term;
    const Floats d;
    const Vec limit = hn::Load(d, constants.static_friction) * normal;
    const Vec tangential = hn::Load(d, constants.tangential_stiffness);
    const Vec spring = hn::Load(d, constants.stiffness) * filled;
    const Mask from_spring = hn::And(tangential == hn::Zero(d), normal > hn::Zero(d));
    add_to(Term::kStatic, limit);
    add_to(Term::kDynamic, hn::Load(d, constants.dynamic_friction) * normal);
    add_to(Term::kAnchor, tangential * limit);
    add_to(Term::kSpring, hn::IfThenElseZero(from_spring, spring));
    const Vec place[3] = {r.x, r.y, r.z}, lever = hn::NegMulAdd(r.z, radial, axial);
    const Vec moment[5] = {r.x * radial, r.y * radial, axial, lever * r.y, hn::Neg(lever * r.x)};
    for (int i = 0, term = Term::kSecond; i < 3; ++i) {
      const Vec weighted = limit * place[i];
      add_to(Term::kFirst + i, weighted);
      for (int j = i; j < 3; ++j, ++term) terms_[term] = hn::MulAdd(weighted, place[j], terms_[term]);
    }
    for (int i = 0, term = Term::kNormals; i < 5; ++i) {
      const Vec weighted = limit * moment[i];
      for (int j = i; j < 5; ++j, ++term) terms_[term] = hn::MulAdd(weighted, moment[j], terms_[term]);
    }
  }

  HWY_INLINE void flush(FrictionSums& totals) {
    for (std::size_t term = 0; term < FrictionSums::kTerms; ++term) {
      alignas(64) float lanes[kWidth];
      hn::Store(terms_[term], Floats(), lanes);
      double* total = &totals.lanes[term][0];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    }
  }

 private:
  HWY_INLINE void add_to(int term, Vec value) { terms_[term] = terms_[term] + value; }

  Vec terms_[FrictionSums::kTerms];
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
