// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hapticut/core/reserve.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// A voxel that became empty.
struct RemovedVoxel {
  std::array<int, 3> index;  ///< in the workpiece's grid
  MaterialId material;       ///< what it was made of
  [[nodiscard]] bool operator==(const RemovedVoxel&) const = default;
};

/// What was taken away, collected over the sub-steps of one step. Has room for a fixed number of voxels.
class RemovalRecord {
 public:
  explicit RemovalRecord(std::size_t capacity) { reserve_touched(voxels_, capacity); }

  void clear() noexcept {
    voxels_.clear();
    volume_ = 0;
    overflowed_ = false;
  }
  void add(const RemovedVoxel& voxel) noexcept {
    if (voxels_.size() < voxels_.capacity())
      voxels_.push_back(voxel);
    else
      overflowed_ = true;
  }
  void add_volume(MaterialId material, double volume) noexcept {
    volume_ += volume;
    total_by_material_[material] += volume;
  }

  /// Another list, of another capacity; `voxels` is then the old one. What was counted stays.
  void exchange_list(std::vector<RemovedVoxel>& voxels) noexcept {
    std::swap(voxels_, voxels);
    clear();
  }

  [[nodiscard]] std::span<const RemovedVoxel> voxels() const { return voxels_; }
  [[nodiscard]] double volume() const { return volume_; }        ///< [m^3] since the last clear
  [[nodiscard]] bool overflowed() const { return overflowed_; }  ///< some voxels were not listed, though they are gone

  /// [m^3] taken away since construction, by MaterialId; not reset by `clear`.
  [[nodiscard]] const std::array<double, 256>& total_by_material() const { return total_by_material_; }

 private:
  std::vector<RemovedVoxel> voxels_;
  double volume_ = 0;  // [m^3]
  bool overflowed_ = false;
  std::array<double, 256> total_by_material_ = {};
};

/// What a sub-step made of the fills of one block.
struct BlockChange {
  static constexpr int kStrip = 16;  ///< voxels of a strip: two rows, which follow each other in memory

  std::uint32_t strips = 0;                   ///< bit n: some of the fills `kStrip * n ...` may have changed
  bool any_emptied = false;                   ///< some voxel is empty now
  std::array<std::uint64_t, 8> emptied = {};  ///< bit `block_offset`: this voxel became empty
};

/// What a force law left of the samples of one block.
/// @param fill_after  [512] the fills of the changed strips are written here; may be `block.fill` itself
/// @param removed     [voxels] filled volume that was removed is added here, by MaterialId
/// @realtime no allocation, no lock; O(samples)
inline BlockChange find_changes(const ContactBlock& contact, const BlockView& block, float* fill_after,
                                std::array<double, 256>& removed) noexcept {
  BlockChange change;
  for (int row = 0; row < contact.rows; ++row) {
    float most = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = row * kLanes + lane;
      most = std::max(most, contact.fill[n] - contact.fill_after[n]);
    }
    if (!(most > 0)) continue;
    const int first = contact.row[row] * kLanes, strip = first / BlockChange::kStrip;
    if ((change.strips >> strip & 1U) == 0) {
      change.strips |= 1U << strip;
      for (int voxel = strip * BlockChange::kStrip; voxel < (strip + 1) * BlockChange::kStrip; ++voxel)
        fill_after[voxel] = block.fill_of(voxel);
    }
    for (unsigned lanes = contact.inside[row]; lanes != 0; lanes &= lanes - 1) {
      const int lane = std::countr_zero(lanes), n = row * kLanes + lane, voxel = first + lane;
      removed[contact.material_of(n)] += double(contact.fill[n] - contact.fill_after[n]);
      fill_after[voxel] = contact.fill_after[n];
      if (contact.fill_after[n] > 0) continue;
      change.emptied[voxel >> 6] |= std::uint64_t(1) << (voxel & 63);
      change.any_emptied = true;
    }
  }
  return change;
}

/// Stage `remove_emptied` for one block: takes its emptied voxels out of the workpiece and lists them.
/// @param block  as it was before the sub-step
/// @realtime no allocation, no lock; O(emptied voxels)
inline void empty_voxels(const BlockView& block, const std::array<std::uint64_t, 8>& emptied, Workpiece& workpiece,
                         RemovalRecord& record) noexcept {
  for (int slab = 0; slab < kBlockEdge; ++slab)
    for (std::uint64_t bits = emptied[slab]; bits != 0; bits &= bits - 1) {
      const int in_slab = std::countr_zero(bits);
      const MaterialId material =
          block.material != nullptr ? block.material[slab * 64 + in_slab] : block.uniform_material;
      record.add(
          {{block.origin[0] + slab, block.origin[1] + (in_slab >> 3), block.origin[2] + (in_slab & 7)}, material});
    }
  workpiece.empty_voxels(block.origin, emptied.data());
}

}  // namespace hapticut
