// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hapticut/workpiece/removal.hpp"

namespace hapticut::kernels {

/// Sums over the blocks of a sub-step, lane by lane, in as many lanes as a vector of the machine has, sixteen at most.
/// The lane of a voxel follows from its place in the list of gathered voxels. It is always the same on one kind of
/// processor, but may differ between kinds.
struct ContactSums {
  enum Term {  // the first six in units of [N/m^3], the energies in [J/m^3], to be multiplied by a voxel's volume
    kForceX,   // of the reaction on the material: minus the force on the tool
    kForceY,
    kForceZ,
    kTorqueX,
    kTorqueY,
    kTorqueZ,
    kBefore,    // stored at the beginning of the sub-step
    kChange,    // change of it by the end: small, so summed separately
    kReleased,  // stored in removed material: released, crushed and helped together
    kCrushed,   // the part of it that crushing took
    kHelped,    // the part of it that helped cutting (law G)
    kChips,     // cutting energy beyond u: of thin chips; negative for crushed material
    kCredited,
    kDamping,
    kRubbing,
    kCouple,
    kFill,
    kNormal,  // sum of the magnitudes of the normal reactions
    kPushX,   // their vector sum, without the drag of the spin
    kPushY,
    kPushZ,
    kMomentX,  // sum of magnitude times position
    kMomentY,
    kMomentZ,
    kArea,  // [voxel edges^2] of the head's surface
    kTerms
  };
  static constexpr int kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};
  ByMaterial<double> removed = {};  ///< [voxels] filled volume that was removed, by MaterialId
  int voxels = 0;                   ///< number of samples
  float depth = 0;                  ///< [m] maximum

  [[nodiscard]] double total(Term term) const {
    double sum = 0;
    for (const double lane : lanes[term]) sum += lane;
    return sum;
  }
};

}  // namespace hapticut::kernels
