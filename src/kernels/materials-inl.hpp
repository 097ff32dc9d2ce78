// SPDX-License-Identifier: Apache-2.0
// The constants of the materials of a vector of voxels; included once per instruction set.
#if defined(HAPTICUT_KERNELS_MATERIALS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_MATERIALS_INL_HPP
#undef HAPTICUT_KERNELS_MATERIALS_INL_HPP
#else
#define HAPTICUT_KERNELS_MATERIALS_INL_HPP
#endif

#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// The constants of a vector of voxels, and the volume removed of one material since they were loaded.
class LoadedMaterials {
 public:
  HWY_INLINE LoadedMaterials(const ContactMaterials& table, ContactSums& totals)
      : table_(table), totals_(totals), vectors_(table[kEmpty]), removed_(broadcast(0.0F)) {}

  [[nodiscard]] HWY_INLINE const MaterialVectors& vectors() const { return vectors_; }

  /// The material of all lanes, or kEmpty if they differ.
  [[nodiscard]] HWY_INLINE MaterialId one() const { return id_; }

  /// Loads the constants of a material, unless they are those of the voxels before.
  HWY_INLINE void load(MaterialId one) {
    if (one == id_) return;
    flush();
    id_ = one;
    vectors_ = MaterialVectors(table_[one]);
  }
  /// @param ids  of a vector of voxels
  HWY_INLINE void load(const MaterialId* ids) {
    if (id_ != kEmpty && all_are(ids, id_)) return;
    if (all_are(ids, ids[0])) return load(ids[0]);
    flush();
    id_ = kEmpty;
    vectors_ = MaterialVectors(table_, ids);
  }

  /// Books removed volume [voxels].
  /// @return false if the materials of the lanes differ; then nothing was booked
  [[nodiscard]] HWY_INLINE bool book(Vec removed) {
    if (id_ == kEmpty) return false;
    removed_ = removed_ + removed;
    return true;
  }
  /// Adds the booked volume to the sums of the sub-step.
  HWY_INLINE void flush() {
    alignas(64) float lanes[kWidth];
    hn::Store(removed_, Floats(), lanes);
    double sum = 0;
    for (const float lane : lanes) sum += double(lane);
    totals_.removed[id_] += sum;
    removed_ = hn::Zero(Floats());
  }

 private:
  const ContactMaterials& table_;
  ContactSums& totals_;
  MaterialVectors vectors_;
  MaterialId id_ = kEmpty;  // kEmpty: the materials of the lanes differ
  Vec removed_;             // [voxels] of id_
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
