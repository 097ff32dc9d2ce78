// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hapticut/workpiece/removal.hpp"

namespace hapticut::kernels {

/// What the blocks of a sub-step add up to, lane by lane, in as many lanes as a vector of the machine has,
/// sixteen at most. A voxel meets the lane of its place in the list of those that were gathered: always the same on one
/// kind of processor, not on all.
struct ContactSums {
  enum Term {  // the first six in units of [N/m^3], the energies in [J/m^3], to be multiplied by a voxel's volume
    kForceX,   // of the reaction of the material, that is minus the force on the tool
    kForceY,
    kForceZ,
    kTorqueX,
    kTorqueY,
    kTorqueZ,
    kBefore,    // stored at the beginning of the sub-step,
    kChange,    // and by its end so much more: small beside it, and added up by itself
    kReleased,  // stored in what was taken away: released, crushed and helped together
    kCrushed,   // what of it crushing took
    kHelped,    // and what helped cutting (law G)
    kChips,     // cutting energy beyond u: of thin chips, and less than none of what was crushed
    kCredited,
    kDamping,
    kRubbing,
    kCouple,
    kFill,
    kNormal,  // the reaction along the normals, whatever their directions
    kPushX,   // of it, without the drag of the spin
    kPushY,
    kPushZ,
    kMomentX,  // its size times its place
    kMomentY,
    kMomentZ,
    kArea,  // [voxel edges^2] of the head's surface
    kTerms
  };
  static constexpr int kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};
  ByMaterial<double> removed = {};  ///< [voxels] filled volume that was removed, by MaterialId
  int voxels = 0;                   ///< samples
  float depth = 0;                  ///< [m] greatest

  [[nodiscard]] double total(Term term) const {
    double sum = 0;
    for (const double lane : lanes[term]) sum += lane;
    return sum;
  }
};

}  // namespace hapticut::kernels
