// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hapticut/core/reserve.hpp"
#include "hapticut/workpiece/changes.hpp"
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
  [[nodiscard]] const ByMaterial<double>& total_by_material() const { return total_by_material_; }

 private:
  std::vector<RemovedVoxel> voxels_;
  double volume_ = 0;  // [m^3]
  bool overflowed_ = false;
  ByMaterial<double> total_by_material_ = {};
};

/// Stage `remove_emptied` for one block: takes its emptied voxels out of the workpiece and lists them.
/// @param block  as it was before the sub-step
/// @realtime no allocation, no lock; O(emptied voxels)
inline void empty_voxels(const BlockView& block, const BlockMask& emptied, Workpiece& workpiece,
                         RemovalRecord& record) noexcept {
  emptied.for_each([&](int voxel) { record.add({voxel_at(block.origin, voxel), block.material_of(voxel)}); });
  workpiece.empty_voxels(block.origin, emptied);
}

}  // namespace hapticut
