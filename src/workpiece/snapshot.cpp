// SPDX-License-Identifier: Apache-2.0
// Copies of the voxels of a workpiece, to return to.
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "workpiece/state.hpp"

namespace hapticut {

struct WorkpieceSnapshot::Voxels {
  VoxelTrees trees;
  GridFrame frame;
  int materials;
};

WorkpieceSnapshot Workpiece::snapshot() const {
  WorkpieceSnapshot snapshot;
  snapshot.voxels_.reset(new WorkpieceSnapshot::Voxels{*state_->trees, frame(), materials().size()});
  return snapshot;
}

void Workpiece::restore(const WorkpieceSnapshot& snapshot) {
  if (!snapshot.voxels_)
    throw Error("Workpiece::restore"_name + " was given an empty snapshot; take one with " +
                "Workpiece::snapshot"_name + " first.");
  const WorkpieceSnapshot::Voxels& saved = *snapshot.voxels_;
  const auto describe = [](const GridFrame& frame, int materials) {
    return std::to_string(materials) + (materials == 1 ? " material" : " materials") + " in voxels of " +
           format_number(frame.voxel_size / units::mm) + " mm";
  };
  if (saved.materials != materials().size() || !(saved.frame == frame()))
    throw Error("the snapshot is of another workpiece: it has " + describe(saved.frame, saved.materials) +
                ", and the present one has " + describe(frame(), materials().size()) +
                (saved.frame.voxel_size == voxel_size() ? ", or lies elsewhere" : "") +
                ". Restore a snapshot of the same workpiece or of its clone, or give the other one to reset.");
  state_->trees = copy_of(saved.trees);
  state_->cache = {};
  state_->change_layout();
  if (state_->journal) reserve_undo(state_->journal->capacity());
  reserve_blocks(state_->pool.target);
}

}  // namespace hapticut
