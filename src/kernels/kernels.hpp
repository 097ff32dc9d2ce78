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

/// @file
/// The stages that work on one block, in the widest vector instructions of the machine, chosen when the program starts.
/// They compute what the scalar functions of the same names in the public headers compute, within rounding: those are
/// the reference that tests hold them against, and what runs where the library was built without Highway.
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
/// A strip is the unit of `press_blocks`: sixteen lanes, which are one vector with AVX-512, two with AVX2, four with
/// NEON. A row is that of the staged kernels, whose vectors have at most eight lanes.
///
///     press = sample + law + sum, in one pass over the voxels of a few blocks:
///
///     block -> strips near the head -> voxels in it    ->  sample           ->  law                  ->  sum
///              Gather::for_each        Gather::append      Press::sample        Press::press_parts       PressSums
///              from their middles      into a list         w, n, slip           f, fill, energies        F, T, ledger
///
/// What to read, in this order. Before all, the scalar forms, which have the formulas and their reasons:
/// workpiece/contact.hpp, force/laws/foundation.hpp, force/resultant.hpp. Then here:
///
///     kernels.hpp               what goes in and what comes out
///     spring_vectors-inl.hpp    depth and direction of a vector of points,
///     springs-inl.hpp           for each shape of head,
///     profile_springs-inl.hpp   and for profiles
///     strips-inl.hpp            lanes, masks, materials and velocities of a strip
///     gather-inl.hpp            which voxels of a block may be inside the head
///     contact_sums.hpp          what a sub-step adds up in double precision, lane by lane,
///     press_sums-inl.hpp        and in vectors over a few blocks;
///     stiffness_sums.hpp        what a coupling wants besides,
///     stiffness_sums-inl.hpp    and its vectors;
///     friction_sums.hpp         what dry friction wants,
///     friction-inl.hpp          and its vectors
///     materials-inl.hpp         constants of the voxels in work, and what was removed of each material
///     places-inl.hpp            where they come from, and where goes what is left
///     motion-inl.hpp            how the head's surface moves at them
///     smooth-inl.hpp            what is different at smooth surfaces
///     chip-inl.hpp              cutting energy that depends on the chip
///     cut_voxels-inl.hpp        the default law on parts of voxels
///     press-inl.hpp             the default law on blocks: Press::press_deep for whole voxels of a standing head, and
///                               for all others Press::sample, then Press::press_parts
///     press_blocks-inl.hpp      which Press for which head
///     rows-inl.hpp              rows; with them the staged kernels for all other laws,
///     sampling-inl.hpp          sample_contact
///     resultant-inl.hpp         and sum_resultant
///     simd_kernels.cpp          the choice of an instruction set; targets/ has a file for each
///     scalar_kernels.cpp        the same without Highway
///
/// A file `-inl.hpp` is compiled once for each instruction set. Vectors are added, multiplied and compared with
/// operators, which Highway has on all the sets in use (targets/which.hpp). `MulAdd(a, b, c)` is a b + c, rounded once
/// where the machine can; `NegMulAdd` is c - a b, `MulSub` is a b - c. Sums are written x = x + y: of x += y, which
/// takes an address, g++ 12 makes 1 % more instructions. Intrinsics of one machine are in `mask_of` and `spread` of
/// strips-inl.hpp, each beside its general form, and nowhere else. Why one pass, and what was measured on the way:
/// docs/decisions/0004-one-pass.md.
namespace hapticut::kernels {

/// Stage `sample_contact` for any head.
void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept;

struct ContactJob;

/// Number of the solid voxels of a block that `press_blocks` may find inside the head, without a level of detail.
[[nodiscard]] int count_voxels(const ContactJob& job, const BlockView& block) noexcept;

/// Stage `sum_resultant`.
void sum_resultant(const ContactBlock& block, Resultant& total) noexcept;

/// What every block of a sub-step has in common.
struct ContactJob {
  const ToolHead& head;
  GridInHead grid;
  HeadMotion motion;
  const ContactMaterials& materials;
  bool damped;                   ///< some material has damping
  unsigned level_of_detail = 1;  ///< n: only an n-th of the strips is evaluated
  unsigned turn = 0;             ///< which of them

  /// Strips take turns by diagonal planes.
  /// @param origin  of the block
  /// @param slab    0 ... 7, the strip's place along i
  /// @param strip   0 ... 3, and along j
  [[nodiscard]] bool has_phase(const VoxelIndex& origin, int slab, int strip) const {
    return (unsigned(origin[0] + slab) + unsigned(origin[1] / 2 + strip) + turn) % level_of_detail == 0;
  }
};

/// What the blocks of a sub-step give together.
struct ContactOutcome {
  Resultant resultant;
  LawEnergies energies;
};

}  // namespace hapticut::kernels

#ifdef HAPTICUT_SCALAR_KERNELS
namespace hapticut::kernels {
struct ContactSums : ContactOutcome {      // the scalar reference adds up what it finds
  ByMaterial<double> removed = {};  ///< [voxels] filled volume that was removed, by MaterialId
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

/// One block to be pressed: what it holds, where its fills go, and what became of them.
struct PressTask {
  BlockView block;
  float* fill_after = nullptr;  ///< [512] the fills of changed strips are written here; may be `block.fill`
  bool may_cut = true;          ///< false: felt but not cut, nor crushed
  BlockChange change;           ///< the result
};

/// `sample_contact`, FoundationLaw::evaluate and `sum_resultant` in one pass, which stores a sample once, in a list:
/// what the step runs unless it was given another law.
/// @param sums       of the sub-step, to add to; `pressed` says what they mean
/// @param stiffness  sums to add to; null: not wanted
/// @param friction   likewise; of a head that stands
void press_blocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                  StiffnessSums* stiffness = nullptr, FrictionSums* friction = nullptr) noexcept;

/// What the blocks that were pressed give together. Voxels that waited for their turn are represented by those that had
/// it; what was removed is exact. LawEnergies::cutting is what it took beyond u of all that was removed: callers, who
/// know the materials of `removed`, add that.
/// @param voxel_volume  [m^3]
[[nodiscard]] ContactOutcome outcome_of(const ContactJob& job, const ContactSums& sums, double voxel_volume) noexcept;

}  // namespace hapticut::kernels
