// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
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
  std::uint64_t changed_rows = 0;  // bit n: row n of the contact lost something
  for (int row = 0; row < contact.rows; ++row) {
    float most = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = row * kLanes + lane;
      most = std::max(most, contact.fill[n] - contact.fill_after[n]);
    }
    if (most > 0) changed_rows |= std::uint64_t(1) << row;
  }
  if (changed_rows == 0) return true;
  float* fill = workpiece.writable_fill(block_origin);
  if (fill == nullptr) return false;

  std::uint64_t emptied[8] = {};
  bool any_emptied = false;
  for (; changed_rows != 0; changed_rows &= changed_rows - 1) {
    const int row = std::countr_zero(changed_rows);
    for (unsigned lanes = contact.inside[row]; lanes != 0; lanes &= lanes - 1) {
      const int lane = std::countr_zero(lanes);
      const int n = row * kLanes + lane, voxel = contact.row[row] * kLanes + lane;
      const float lost = contact.fill[n] - contact.fill_after[n];
      const MaterialId material = contact.material_of(n);
      fill[voxel] = contact.fill_after[n];
      record.add_volume(material, double(lost) * voxel_volume);
      if (contact.fill_after[n] > 0) continue;
      emptied[voxel >> 6] |= std::uint64_t(1) << (voxel & 63);
      any_emptied = true;
      record.add({{block_origin[0] + (voxel >> 6), block_origin[1] + (voxel >> 3 & 7), block_origin[2] + (voxel & 7)},
                  material});
    }
  }
  if (any_emptied) workpiece.empty_voxels(block_origin, emptied);
  return true;
}

}  // namespace hapticut
