// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

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
  explicit RemovalRecord(std::size_t capacity) { voxels_.reserve(capacity); }

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

/// Stage `remove_material`: writes the fills that the force law left into the workpiece and records what went.
/// @param voxel_volume  [m^3]
/// @return false when the workpiece's pool is exhausted: this block stays as it was
/// @realtime no allocation, no lock; O(samples)
[[nodiscard]] inline bool remove_material(const ContactBlock& contact, const VoxelIndex& block_origin,
                                          double voxel_volume, Workpiece& workpiece, RemovalRecord& record) noexcept {
  bool changed = false;
  for (int n = 0; n < contact.lanes(); ++n) changed |= contact.fill_after[n] != contact.fill[n];
  if (!changed) return true;
  float* fill = workpiece.writable_fill(block_origin);
  if (fill == nullptr) return false;

  std::uint64_t emptied[8] = {};
  bool any_emptied = false;
  for (int n = 0; n < contact.lanes(); ++n) {
    const float lost = contact.fill[n] - contact.fill_after[n];
    if (lost == 0) continue;
    const int voxel = contact.row[n / kLanes] * kLanes + n % kLanes;
    const MaterialId material = contact.material_of(n);
    fill[voxel] = contact.fill_after[n];
    record.add_volume(material, double(lost) * voxel_volume);
    if (contact.fill_after[n] > 0) continue;
    emptied[voxel >> 6] |= std::uint64_t(1) << (voxel & 63);
    any_emptied = true;
    record.add({{block_origin[0] + (voxel >> 6), block_origin[1] + (voxel >> 3 & 7), block_origin[2] + (voxel & 7)},
                material});
  }
  if (any_emptied) workpiece.empty_voxels(block_origin, emptied);
  return true;
}

}  // namespace hapticut
