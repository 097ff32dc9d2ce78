// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "hapticut/contact/removal.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/spread_friction.hpp"

namespace hapticut::kernels {

/// Sums over the blocks of a sub-step, lane by lane, in as many lanes as a vector of the machine has, sixteen at most.
/// The lane of a voxel follows from its place among the voxels in contact. It is always the same on one kind of
/// processor, but may differ between kinds.
struct ContactSums {
  enum Term {  // forces in [N/m^3], torques in [N/m^2], energies in [J/m^3], to be multiplied by a voxel's volume
    kForceX,   // reaction on the material: minus the force on the tool
    kForceY,
    kForceZ,
    kTorqueX,
    kTorqueY,
    kTorqueZ,
    kBefore,   // stored at the beginning of the sub-step
    kChange,   // change of it by the end: small, so summed separately
    kLost,     // stored in removed material: released, crushed and helped together
    kCrushed,  // the part of it that crushing took
    kHelped,   // the part of it that helped cutting (law G)
    kCutting,  // u/sigma_c of what was cut, without what was crushed
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
    kArea,  // [voxel edges^2] area of the head's surface
    kTerms
  };
  static constexpr int kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};
  ByMaterial<double> removed = {};  ///< [voxels] filled volume that was removed, by MaterialId
  /// [N/m^3] normal reactions to a head that cuts, by MaterialId, to add to; null: nobody asks
  ByMaterial<double>* pressed = nullptr;
  int voxels = 0;   ///< number of samples
  float depth = 0;  ///< [m] maximum

  [[nodiscard]] double total(Term term) const {
    double sum = 0;
    for (const double lane : lanes[term]) sum += lane;
    return sum;
  }
};

/// Sums of the contact's stiffness over samples (formulas/stiffness.inl), row by row and lane by lane.
struct StiffnessSums {
  static constexpr std::size_t kTerms = 36;
  static constexpr std::size_t kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};  ///< [N/m^4], [N/m^3], [N/m^2]

  /// @param voxel_volume  [m^3]
  /// @param weight        [1] of each sample: the level of detail
  [[nodiscard]] Stiffness total(double voxel_volume, double weight) const {
    Stiffness k;
    for (std::size_t term = 0; term < kTerms; ++term) {
      double sum = 0;
      for (const double lane : lanes[term]) sum += lane;
      k(int(term / 6), int(term % 6)) = weight * (sum * voxel_volume);
    }
    return k;
  }
};

/// Sums over the samples of a standing head, lane by lane, from which SpreadFriction is computed. q = mu_s f is the
/// friction limit of a sample and m = (n, r x n) its moment, whose last component is 0 on a head of revolution:
///
///     A = Sum q P^T P - Sum q m m^T,   P^T P = [ 1       -[r]x         ]
///                                              [ [r]x    |r|^2 - r r^T ]
///
struct FrictionSums {
  enum Term {
    kStatic,                 // q [N/m^3]
    kDynamic,                // mu_d f
    kAnchor,                 // q k_t where k_t is given
    kSpring,                 // k_v phi where k_t is not given
    kFirst,                  // q r
    kSecond = kFirst + 3,    // q r r^T, its upper half row by row
    kNormals = kSecond + 6,  // q m m^T of the first five components of m, likewise
    kTerms = kNormals + 15
  };
  static constexpr std::size_t kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};

  /// @param voxel_volume  [m^3]
  /// @param weight        [1] of each sample: the level of detail
  [[nodiscard]] SpreadFriction total(double voxel_volume, double weight) const {
    std::array<double, kTerms> sums = {};
    for (std::size_t term = 0; term < kTerms; ++term)
      for (const double lane : lanes[term]) sums[term] += lane * voxel_volume * weight;
    const double q = sums[kStatic];
    const Vec3 first(sums[kFirst], sums[kFirst + 1], sums[kFirst + 2]);
    Mat3 second, arm;
    for (int i = 0, term = kSecond; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++term) second(i, j) = second(j, i) = sums[std::size_t(term)];
    arm << 0, -first.z(), first.y(), first.z(), 0, -first.x(), -first.y(), first.x(), 0;

    SpreadFriction contact;
    contact.directions << q * Mat3::Identity(), -arm, arm, second.trace() * Mat3::Identity() - second;
    for (int i = 0, term = kNormals; i < 5; ++i)
      for (int j = i; j < 5; ++j, ++term) {
        contact.directions(i, j) -= sums[std::size_t(term)];
        if (i != j) contact.directions(j, i) -= sums[std::size_t(term)];
      }
    contact.static_limit = q;
    contact.dynamic_limit = sums[kDynamic];
    contact.anchors = sums[kAnchor];
    contact.springs = kTangentialShare * sums[kSpring];
    return contact;
  }
};

}  // namespace hapticut::kernels
