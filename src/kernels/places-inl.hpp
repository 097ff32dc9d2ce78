// SPDX-License-Identifier: Apache-2.0
// Origin of the voxels that the press kernel works on, and target of their new fills; included once per instruction
// set.
#if defined(HAPTICUT_KERNELS_PLACES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PLACES_INL_HPP
#undef HAPTICUT_KERNELS_PLACES_INL_HPP
#else
#define HAPTICUT_KERNELS_PLACES_INL_HPP
#endif

#include <cstring>

#include "kernels/gather-inl.hpp"
#include "kernels/materials-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

class Places {
 protected:
  HWY_INLINE Places(const ContactMaterials& materials, VoxelList& voxels, ContactSums& totals)
      : voxels_(voxels), totals_(totals), material_(materials, totals) {}

  HWY_INLINE void mark_emptied(int first, unsigned lanes) const {
    for (; lanes != 0; lanes &= lanes - 1) {
      const int n = first + std::countr_zero(lanes), voxel = voxel_of(n);
      BlockChange& change = task_of(n).change;
      change.any_emptied = true;
      change.emptied.add(voxel);
    }
  }

  /// The task of the block of voxel n of the list, its offset in the block, and its material.
  [[nodiscard]] HWY_INLINE PressTask& task_of(int n) const { return tasks_[unsigned(voxels_.index[n]) / kBlockVoxels]; }
  [[nodiscard]] HWY_INLINE int voxel_of(int n) const { return voxels_.index[n] % kBlockVoxels; }
  [[nodiscard]] HWY_INLINE MaterialId material_of(int n) const {
    const BlockView& block = task_of(n).block;
    return block.material == nullptr ? block.uniform_material : block.material[voxel_of(n)];
  }

  /// Writes the new fills of the listed voxels back to their blocks, and marks the blocks where one differs.
  HWY_INLINE void write_fills() const {
    const float *before = voxels_.fill, *after = voxels_.fill_after;
    for (int n = 0; n < voxels_.runs;) {
      const unsigned block = unsigned(voxels_.run_first[n]) / kBlockVoxels;
      PressTask& task = tasks_[block];
      const float* const first_after = after;
      for (; n < voxels_.runs && unsigned(voxels_.run_first[n]) / kBlockVoxels == block; ++n) {
        const unsigned first = unsigned(voxels_.run_first[n]), lanes = voxels_.run_lanes[n];
        spread(after, lanes, task.fill_after + first % kBlockVoxels);
        after += std::popcount(lanes);
      }
      const std::size_t count = std::size_t(after - first_after);
      bool& changed = task.change.any_changed;
      changed = changed || std::memcmp(before, first_after, sizeof(float) * count) != 0;
      before += count;
    }
  }

  HWY_INLINE void load_listed_materials(int first) {
    MaterialId ids[kWidth];
    for (int lane = 0; lane < int(kWidth); ++lane) ids[lane] = material_of(first + lane);
    material_.load(ids);
  }
  /// Books removed volume, by material.
  HWY_INLINE void book_removed(Vec removed, int first, Mask inside) {
    if (material_.book(removed)) return;
    alignas(64) float lanes[kWidth];
    hn::Store(removed, Floats(), lanes);
    for (unsigned bits = bits_of(inside); bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      totals_.removed[material_of(first + lane)] += double(lanes[lane]);
    }
  }

  VoxelList& voxels_;
  ContactSums& totals_;
  PressTask* tasks_ = nullptr;  // all tasks
  LoadedMaterials material_;
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
