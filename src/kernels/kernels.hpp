// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hapticut/force/law.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "hapticut/workpiece/removal.hpp"
#include "kernels/stiffness.hpp"

/// @file
/// The stages that work on one block, in the widest vector instructions of the machine, chosen when the program starts.
/// They compute what the scalar functions of the same names in the public headers compute, within rounding: those are
/// the reference that tests hold them against, and what runs where the library was built without Highway.
namespace hapticut::kernels {

/// Stage `sample_contact` for any head.
void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept;

/// Stage `sum_resultant`.
void sum_resultant(const ContactBlock& block, Resultant& total) noexcept;

/// What every block of a sub-step has in common.
struct ContactJob {
  const ToolHead& head;
  GridInHead grid;
  HeadMotion motion;
  const ContactMaterials& materials;
  Quadrature quadrature;
  bool damped;                   ///< some material has damping
  unsigned level_of_detail = 1;  ///< n: only an n-th of the strips is evaluated
  unsigned turn = 0;             ///< which of them

  /// Strips take turns by diagonal planes.
  /// @param origin  of the block
  /// @param slab    0 ... 7, the strip's place along i
  /// @param strip   0 ... 3, and along j
  [[nodiscard]] bool has_turn(const VoxelIndex& origin, int slab, int strip) const {
    return (unsigned(origin[0] + slab) + unsigned(origin[1] / 2 + strip) + turn) % level_of_detail == 0;
  }
};

/// What the blocks of a sub-step give together.
struct Pressed {
  Resultant resultant;
  LawEnergies energies;
  std::array<double, 256> taken = {};  ///< [voxels] filled volume taken away, by MaterialId
};

}  // namespace hapticut::kernels

#ifdef HAPTICUT_SCALAR_KERNELS
namespace hapticut::kernels {
using ContactSums = Pressed;  // the scalar reference adds up what it finds
}
#else
#include "kernels/contact_sums.hpp"
#endif

namespace hapticut::kernels {

/// One block to be pressed: what it holds, where its fills go, and what became of them.
struct PressTask {
  BlockView block;
  float* fill_after = nullptr;  ///< [512] the fills of changed strips are written here; may be `block.fill`
  bool may_cut = true;          ///< false: felt but not cut
  BlockChange change;           ///< the result
};

/// Stages `sample_contact`, `evaluate_law` of FoundationLaw and `sum_resultant` in one pass that never leaves the
/// registers: what the step runs unless it was given another law.
/// @param sums       of the sub-step, to add to; `pressed` says what they mean
/// @param stiffness  sums to add to; null: not wanted
void press_blocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                  StiffnessSums* stiffness = nullptr) noexcept;

/// What the blocks that were pressed give together. Voxels that waited for their turn are represented by those that had
/// it; what was taken is exact. LawEnergies::cutting is left to who books `taken` by its materials.
/// @param voxel_volume  [m^3]
[[nodiscard]] Pressed pressed(const ContactJob& job, const ContactSums& sums, double voxel_volume) noexcept;

}  // namespace hapticut::kernels
