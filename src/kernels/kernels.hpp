// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hapticut/force/law.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/force/spread_friction.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "hapticut/workpiece/removal.hpp"
#include "kernels/stiffness_sums.hpp"

/// The stages that work on one block, in the widest vector instructions of the machine, which are chosen when the
/// program starts. They compute the same as the scalar functions of the same names in the public headers, within
/// rounding. The scalar functions are the reference in the tests, and they run when the library was built without
/// Highway.
///
///     a block: 8 x 8 x 8 voxels        a slab: the 64 voxels of one i; in memory k goes fastest, then j, then i
///
///            .--------------.                  k = 0 1 2 3 4 5 6 7
///           /              /|              j = 0   o o o o o o o o   row 0 |  strip 0: sixteen voxels that
///          /  slabs i     / |                  1   o o o o o o o o   row 1 |  follow each other in memory
///         .--------------.  |                  2   o o o o o o o o   row 2 |  strip 1
///         |              |  |                  3   o o o o o o o o   row 3 |
///       j |              |  .                  4   o o o o o o o o   row 4 |  strip 2
///         |              | /                   5   o o o o o o o o   row 5 |
///         |              |/                    6   o o o o o o o o   row 6 |  strip 3
///         '--------------'                     7   o o o o o o o o   row 7 |
///                k
///
/// Three properties make it fast:
///
/// 1. One pass. Storing every sample between sampling, law and sum took half of the time.
/// 2. Gathering. Only 39 ... 56 % of the lanes of the strips near a cutting head are inside it. So the voxels inside
///    are first listed without gaps, about 256 over several blocks.
/// 3. Two loops over the list: first all samples, then the law. With one loop, the processor would wait for chains of
///    roots and divisions.
///
/// A strip is the unit of `press_blocks`: sixteen lanes, which are one vector with AVX-512, two with AVX2, four with
/// NEON. A row is the unit of the staged kernels, whose vectors have at most eight lanes.
///
///     press = sample + law + sum, in one pass over the voxels of a few blocks:
///
///     block -> strips near the head -> voxels in it    ->  sample           ->  law                  ->  sum
///              Gather::for_each        Gather::append      Press::sample        Press::press_parts       PressSums
///              from their middles      into a list         w, n, slip           f, fill, energies        F, T, ledger
///
/// Reading order. First the scalar forms, which contain the formulas and their reasons: workpiece/contact.hpp,
/// force/laws/foundation.hpp, force/resultant.hpp. Then the main path:
///
///     kernels.hpp               input and output of the kernels
///     press_blocks-inl.hpp      the Press for each shape of head
///     press-inl.hpp             the default law on blocks: Press::press_deep for whole voxels of a standing head, and
///                               for all others Press::sample, then Press::press_parts
///     gather-inl.hpp            which voxels of a block may be inside the head
///     springs-inl.hpp           depth and direction of a vector of points, for each shape of head
///     motion-inl.hpp            velocity of the head's surface at voxels
///     cut_voxels-inl.hpp        the default law on parts of voxels
///     press_sums-inl.hpp        sums in vectors over a few blocks
///
/// The other files, when you meet their names:
///
///     spring_vectors-inl.hpp    a depth and a direction in vectors;
///     profile_springs-inl.hpp   those of profiles
///     strips-inl.hpp            lanes, masks, materials and velocities of a strip
///     contact_sums.hpp          sums of a sub-step in double precision, lane by lane
///     stiffness_sums.hpp        stiffness, for a coupling,
///     stiffness_sums-inl.hpp    and its vectors;
///     friction_sums.hpp         sums for dry friction,
///     friction-inl.hpp          and its vectors
///     materials-inl.hpp         constants of the current voxels, and removed volume of each material
///     places-inl.hpp            where voxels come from, and where their new fills go
///     smooth-inl.hpp            smooth surfaces
///     chip-inl.hpp              cutting energy that depends on the chip
///     rows-inl.hpp              rows; with them the staged kernels for all other laws,
///     sampling-inl.hpp          sample_contact
///     resultant-inl.hpp         and sum_resultant
///     simd_kernels.cpp          the choice of an instruction set; targets/ has a file for each
///     scalar_kernels.cpp        kernels without Highway
///
/// A file `-inl.hpp` is compiled once for each instruction set. Vectors are added, multiplied and compared with
/// operators, which Highway has on all the sets in use (targets/which.hpp). `MulAdd(a, b, c)` is a b + c, rounded once
/// where the machine can; `NegMulAdd` is c - a b, `MulSub` is a b - c. Sums are written x = x + y, because g++ 12 makes
/// 1 % more instructions from x += y, which takes an address. Intrinsics of one machine occur only in `mask_of` and
/// `spread` of strips-inl.hpp, each beside its general form. docs/decisions/0004-one-pass.md says why there is one
/// pass, and what was measured.
namespace hapticut::kernels {

/// Stage `sample_contact` for any head.
void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept;

struct ContactJob;

/// Number of the solid voxels of a block that `press_blocks` may find inside the head, without a level of detail.
[[nodiscard]] int count_voxels(const ContactJob& job, const BlockView& block) noexcept;

/// Stage `sum_resultant`.
void sum_resultant(const ContactBlock& block, Resultant& total) noexcept;

/// Input that all blocks of a sub-step share.
struct ContactJob {
  const ToolHead& head;
  GridInHead grid;
  HeadMotion motion;
  const ContactMaterials& materials;
  bool damped;                   ///< some material has damping
  unsigned level_of_detail = 1;  ///< n: only one n-th of the strips is evaluated
  unsigned phase = 0;            ///< which of them

  /// Whether a strip is evaluated in this phase. Strips alternate by diagonal planes.
  /// @param origin  of the block
  /// @param slab    0 ... 7, index of the strip along i
  /// @param strip   0 ... 3, index along j
  [[nodiscard]] bool has_phase(const VoxelIndex& origin, int slab, int strip) const {
    return (unsigned(origin[0] + slab) + unsigned(origin[1] / 2 + strip) + phase) % level_of_detail == 0;
  }
};

/// Result of all blocks of a sub-step.
struct ContactOutcome {
  Resultant resultant;
  LawEnergies energies;
};

}  // namespace hapticut::kernels

#ifdef HAPTICUT_SCALAR_KERNELS
namespace hapticut::kernels {
struct ContactSums : ContactOutcome {  // the scalar reference sums the results
  ByMaterial<double> removed = {};     ///< [voxels] filled volume that was removed, by MaterialId
};
struct FrictionSums {  // likewise
  SpreadFriction sum;
  [[nodiscard]] SpreadFriction total(double /*voxel_volume*/, double weight) const {
    SpreadFriction all = sum;
    return all *= weight;
  }
};
}  // namespace hapticut::kernels
#else
#include "kernels/contact_sums.hpp"
#include "kernels/friction_sums.hpp"
#endif

namespace hapticut::kernels {

/// One block to evaluate: its content, the target of its new fills, and its changes.
struct PressTask {
  BlockView block;
  float* fill_after = nullptr;  ///< [512] the fills of changed strips are written here; may be `block.fill`
  bool may_cut = true;          ///< false: felt but not cut, nor crushed
  BlockChange change;           ///< the result
};

/// `sample_contact`, FoundationLaw::evaluate and `sum_resultant` in one pass, which stores a sample once, in a list.
/// The step runs this kernel unless it has another law.
/// @param sums       of the sub-step, to add to; `outcome_of` converts them
/// @param stiffness  sums to add to; null: not needed
/// @param friction   sums to add to, of a standing head; null: not needed
void press_blocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                  StiffnessSums* stiffness = nullptr, FrictionSums* friction = nullptr) noexcept;

/// Converts the sums of a sub-step to its result. With a level of detail, the evaluated voxels stand for all; the
/// removed volume is exact. LawEnergies::cutting is only the part beyond u times the removed volume: callers, who know
/// the materials of `removed`, add the rest.
/// @param voxel_volume  [m^3]
[[nodiscard]] ContactOutcome outcome_of(const ContactJob& job, const ContactSums& sums, double voxel_volume) noexcept;

}  // namespace hapticut::kernels
