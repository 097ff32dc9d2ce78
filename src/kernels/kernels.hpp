// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hapticut/contact/contact.hpp"
#include "hapticut/contact/removal.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/force/spread_friction.hpp"
#include "hapticut/tool/head.hpp"

/// The stages that work on one block, in the widest vector instructions of the machine, which are chosen when the
/// program starts. They compute the same as the scalar functions of the public headers, within rounding:
/// evaluate_blocks as FoundationLaw::evaluate, the others as those of their names. The scalar functions are the
/// reference in the tests, and they run when the library was built without Highway.
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
/// 1. Lists. Only half of the lanes of the strips near a cutting head are inside it. So the voxels of a block that may
///    be inside are listed without gaps, for several evaluations (NearBlocks); those in contact are then collected
///    without gaps once more. Results do not depend on which other voxels were listed.
/// 2. Columns. The law runs in chunks of 112 voxels, whose numbers stay in the first cache.
/// 3. Stages. Each step of the law is a short loop of its own over the columns, so that the processor never waits for a
///    long chain of roots and divisions. A stage does not know the head, so it is compiled once.
///
/// Voxels are found strip by strip: sixteen lanes, which are one vector with AVX-512, two with AVX2, four with NEON. A
/// row is the unit of the kernels for laws at points, whose vectors have at most eight lanes.
///
///     blocks -> Gather -> ReachedVoxels -> BlockEvaluator -> Columns -> Stages::run                         -> sums
///               strips near the head,      in contact:       numbers    material, motion, 2. crushing,         new
///               voxels in it               springs, section  by column  3. chips, 4. springs, 5. recession,    fills
///                                                                       6. decay, 7. energies, forces
///                                            '-> WholeVoxels: in a head that stands and removes nothing -> sums
///                                                 (a ball's go there from Gather)
///
/// Reading order. First the law, which contains the formulas and their reasons: force/laws/foundation.hpp, and the
/// texts in hapticut/formulas that it includes; the kernels include the same. Then the main path:
///
///     kernels.hpp               input and output of the kernels
///     blocks-inl.hpp            the main path: from blocks to the columns
///     gather-inl.hpp            which voxels of a block may be inside the head
///     stages-inl.hpp            the default law on the columns, step by step
///     columns-inl.hpp           the columns, and the sums in vectors
///     materials-inl.hpp         the materials in the columns
///     whole-inl.hpp             whole voxels inside a standing head
///
/// The other files, when you meet their names:
///
///     wide-inl.hpp              a number for each lane, and with it the formulas
///     springs-inl.hpp           the springs of a head, of the text of its shape in hapticut/formulas;
///     profile_springs-inl.hpp   those of a profile, for a vector of points
///     strips-inl.hpp            lanes and masks of a strip
///     sums.hpp                  sums of a sub-step in double precision, lane by lane
///     points-inl.hpp            sample_contact and sum_resultant for all other laws
///     simd_kernels.cpp          the choice of an instruction set; targets/ has a file for each
///     scalar_kernels.cpp        kernels without Highway
///
/// A file `-inl.hpp` is compiled once for each instruction set. Vectors are added, multiplied and compared with
/// operators, which Highway has on all the sets in use (targets/which.hpp). Sums are written x = x + y, because g++ 12
/// makes 1 % more instructions from x += y, which takes an address. Intrinsics of one machine occur only in `mask_of`
/// of strips-inl.hpp, beside its general form. docs/decisions/0027-one-text.md says why there are columns and stages,
/// and what was measured.
namespace hapticut::kernels {

/// Stage `sample_contact` for any head.
void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept;

struct ContactJob;

/// The solid voxels of a block that may be inside a head.
struct ReachedVoxels {
  static constexpr int kEnd = 16;                        ///< number of zeros after the last one
  static constexpr int kCapacity = kBlockVoxels + kEnd;  ///< size of an array for those of one block
  const std::uint16_t* voxels = nullptr;  ///< their offsets in the block, ascending, then zeros; null: not listed
  int count = 0;
  MaterialId material = kEmpty;  ///< material of all voxels of the block; kEmpty: their materials may differ
};

/// Lists the voxels of a block that may be inside the head, or inside it after a motion.
/// @param motion  [m] of any point of the head, at most
/// @param out     [ReachedVoxels::kCapacity]
[[nodiscard]] ReachedVoxels find_voxels(const ContactJob& job, const BlockView& block, float motion,
                                        std::uint16_t* out) noexcept;

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
  unsigned subset = 0;           ///< number of the subset, 0 ... n-1
  bool writes_fills = true;      ///< false: nobody needs the new fills and changes

  /// Whether a strip is in the subset that is evaluated. Strips alternate by diagonal planes.
  /// @param origin  of the block
  /// @param slab    0 ... 7, index of the strip along i
  /// @param strip   0 ... 3, index along j
  [[nodiscard]] bool in_subset(const VoxelIndex& origin, int slab, int strip) const {
    return (unsigned(origin[0] + slab) + unsigned(origin[1] / 2 + strip) + subset) % level_of_detail == 0;
  }
};

/// Result of all blocks of a sub-step.
struct ContactTotals {
  Resultant resultant;
  LawEnergies energies;
};

}  // namespace hapticut::kernels

#ifdef HAPTICUT_SCALAR_KERNELS
namespace hapticut::kernels {
struct ContactSums : ContactTotals {      // the scalar reference sums the results
  ByMaterial<double> removed = {};        ///< [voxels] filled volume that was removed, by MaterialId
  ByMaterial<double>* pressed = nullptr;  ///< [N/m^3] normal reactions to a head that cuts; null: nobody asks
  double helped = 0;                      ///< [J] LawTotals::helped
};
struct StiffnessSums {  // likewise
  Stiffness sum = Stiffness::Zero();
  [[nodiscard]] Stiffness total(double /*voxel_volume*/, double weight) const { return weight * sum; }
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
#include "kernels/sums.hpp"
#endif

namespace hapticut::kernels {

/// One block to evaluate: its content, the target of its new fills, and its changes.
struct BlockTask {
  BlockView block;
  float* fill_after = nullptr;  ///< [512] the fills of changed strips are written here; may be `block.fill`; null with
                                ///< ContactJob::writes_fills = false
  bool may_cut = true;          ///< false: felt but not cut, nor crushed
  ReachedVoxels reached;        ///< from `find_voxels`; without a list the kernel finds them
  BlockChange change;           ///< the result
};

/// `sample_contact`, FoundationLaw::evaluate and `sum_resultant` together, as stages over columns of samples. The step
/// runs this kernel unless it has another law.
/// @param sums       of the sub-step, to add to; `totals_of` converts them
/// @param stiffness  sums to add to; null: not needed
/// @param friction   sums to add to, of a standing head; null: not needed
void evaluate_blocks(const ContactJob& job, std::span<BlockTask> tasks, ContactSums& sums,
                     StiffnessSums* stiffness = nullptr, FrictionSums* friction = nullptr) noexcept;

/// Converts the sums of a sub-step to its result. With a level of detail, the evaluated voxels stand for all; the
/// removed volume is exact.
/// @param voxel_volume  [m^3]
[[nodiscard]] ContactTotals totals_of(const ContactJob& job, const ContactSums& sums, double voxel_volume) noexcept;

}  // namespace hapticut::kernels
