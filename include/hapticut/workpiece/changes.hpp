// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "hapticut/workpiece/contact.hpp"

namespace hapticut {

/// What a sub-step made of the fills of one block.
struct BlockChange {
  static constexpr int kStrip = 16;  ///< voxels of a strip: two rows, which follow each other in memory

  std::uint32_t strips = 0;  ///< bit n: some of the fills `kStrip * n ...` may have changed
  bool any_emptied = false;  ///< some voxel is empty now
  BlockMask emptied;         ///< the voxels that became empty
};

/// What a force law left of the samples of one block.
/// @param fill_after  [512] the fills of the changed strips are written here; may be `block.fill` itself
/// @param removed     [voxels] filled volume that was removed is added here, by MaterialId
/// @realtime no allocation, no lock; O(samples)
inline BlockChange find_changes(const ContactBlock& contact, const BlockView& block, float* fill_after,
                                ByMaterial<double>& removed) noexcept {
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
      change.emptied.add(voxel);
      change.any_emptied = true;
    }
  }
  return change;
}

}  // namespace hapticut
