// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hapticut/contact/changes.hpp"
#include "hapticut/core/reserve.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// A voxel that became empty.
struct RemovedVoxel {
  std::array<int, 3> index;  ///< index in the workpiece's grid
  MaterialId material;       ///< its former material
  [[nodiscard]] bool operator==(const RemovedVoxel&) const = default;
};

/// The material removed in one step, collected over its sub-steps. Lists a fixed number of voxels at most.
class RemovalRecord {
 public:
  /// @param capacity  number of voxels that it can list; 0: it lists none, and that is no overflow
  explicit RemovalRecord(std::size_t capacity) { reserve_touched(voxels_, capacity); }

  void clear() noexcept {
    voxels_.clear();
    volume_ = 0;
    overflowed_ = false;
  }
  [[nodiscard]] bool lists() const noexcept { return voxels_.capacity() > 0; }
  void add(const RemovedVoxel& voxel) noexcept {  ///< only if it lists
    if (voxels_.size() < voxels_.capacity())
      voxels_.push_back(voxel);
    else
      overflowed_ = true;
  }
  void add_volume(MaterialId material, double volume) noexcept {
    volume_ += volume;
    total_by_material_[material] += volume;
  }

  /// Replaces the list by one of another capacity, and clears it; `voxels` receives the old list. Totals are kept.
  void exchange_list(std::vector<RemovedVoxel>& voxels) noexcept {
    std::swap(voxels_, voxels);
    clear();
  }

  [[nodiscard]] std::span<const RemovedVoxel> voxels() const { return voxels_; }
  [[nodiscard]] double volume() const { return volume_; }        ///< [m^3] since the last clear
  [[nodiscard]] bool overflowed() const { return overflowed_; }  ///< whether removed voxels are missing in the list

  /// [m^3] Removed since construction, by MaterialId; not reset by `clear`.
  [[nodiscard]] const ByMaterial<double>& total_by_material() const { return total_by_material_; }

 private:
  friend struct SimulationMemory;
  std::vector<RemovedVoxel> voxels_;
  double volume_ = 0;  // [m^3]
  bool overflowed_ = false;
  ByMaterial<double> total_by_material_ = {};
};

/// Stage `remove_emptied` for one block: empties its voxels in the workpiece and lists them, if the record does.
/// @param block  the block before the sub-step
/// @realtime no allocation, no lock; O(emptied voxels)
inline void empty_voxels(const BlockView& block, const BlockMask& emptied, Workpiece& workpiece,
                         RemovalRecord& record) noexcept {
  if (record.lists())
    emptied.for_each([&](int voxel) { record.add({voxel_at(block.origin, voxel), block.material_of(voxel)}); });
  workpiece.empty_voxels(block.origin, emptied);
}

}  // namespace hapticut
