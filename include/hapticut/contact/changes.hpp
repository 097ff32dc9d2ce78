// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "hapticut/contact/contact.hpp"

namespace hapticut {

/// How a sub-step changed the fills of one block.
struct BlockChange {
  static constexpr int kStrip = 16;  ///< voxels of a strip: two rows that are adjacent in memory

  std::uint32_t strips = 0;  ///< bit n: fills of strip n, from `kStrip * n` on, may have changed
  bool any_changed = false;  ///< at least one fill differs from before
  bool any_emptied = false;  ///< at least one voxel became empty
  BlockMask emptied;         ///< the voxels that became empty
};

/// Finds the changes that a force law made to the samples of one block.
/// @param fill_after  [512] receives the fills of the changed strips; may be `block.fill` itself
/// @param removed     [voxels] by MaterialId; the removed filled volume is added to it
/// @realtime no allocation, no lock; O(samples)
inline BlockChange find_changes(const ContactBlock& contact, const BlockView& block, float* fill_after,
                                ByMaterial<double>& removed) noexcept {
  BlockChange change;
  for (int row = 0; row < contact.rows; ++row) {
    float max_removed = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = row * kLanes + lane;
      max_removed = std::max(max_removed, contact.fill[n] - contact.fill_after[n]);
    }
    if (!(max_removed > 0)) continue;
    change.any_changed = true;
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
