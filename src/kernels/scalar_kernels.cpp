// SPDX-License-Identifier: Apache-2.0
// The kernels without Highway: the scalar reference itself.
#include <algorithm>
#include <cmath>

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/kernels.hpp"

namespace hapticut::kernels {
namespace {

/// Leaves out the strips of other subsets.
BlockView of_subset(const ContactJob& job, const BlockView& block, BlockMask& solid) noexcept {
  BlockView view = block;
  solid = block.solid_voxels();
  for (int slab = 0; slab < kBlockEdge; ++slab) {
    std::uint64_t& word = solid.words[std::size_t(slab)];
    for (int strip = 0; strip < kBlockVoxels / kBlockEdge / BlockChange::kStrip; ++strip)
      if (!job.in_subset(block.origin, slab, strip)) word &= ~(0xFFFFULL << (BlockChange::kStrip * strip));
  }
  view.solid = solid.words.data();
  return view;
}

/// Buffer for one block, reused by each call of a kernel.
ContactBlock& scratch() noexcept {
  thread_local ContactBlock contact;
  return contact;
}

void evaluate_block(const ContactJob& job, BlockTask& task, ContactSums& sums, StiffnessSums* stiffness,
                    FrictionSums* friction) noexcept {
  ContactBlock& contact = scratch();
  task.change = {};
  BlockMask solid;
  const BlockView block = job.level_of_detail > 1 ? of_subset(job, task.block, solid) : task.block;
  contact.min_width = job.motion.min_width;
  sample_contact(job.head, block, job.grid, Quadrature::sub_voxel, contact);
  if (contact.samples == 0) return;
  HeadMotion motion = job.motion;
  if (!task.may_cut) motion.removal = RemovalLaw::none, motion.crushes = false;
  const LawTotals totals =
      FoundationLaw().evaluate(motion, job.materials, contact, stiffness != nullptr ? &stiffness->sum : nullptr);
  hapticut::sum_resultant(contact, sums.resultant);
  sums.resultant.wrench_T.torque.z() += totals.spin_couple;
  if (motion.cuts() && sums.pressed != nullptr)
    add_pressed(contact, std::pow(double(motion.voxel_size), -3), *sums.pressed);
  sums.energies += totals.energies;
  sums.helped += totals.helped;
  if (friction != nullptr) friction->sum.add(contact, motion, job.materials);
  if (totals.may_remove && job.writes_fills)
    task.change = find_changes(contact, task.block, task.fill_after, sums.removed);
}

}  // namespace

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  head.visit_springs<float>(
      [&](const auto& springs) { hapticut::sample_contact(springs, block, grid, quadrature, out); });
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept { hapticut::sum_resultant(block, total); }

void evaluate_blocks(const ContactJob& job, std::span<BlockTask> tasks, ContactSums& sums, StiffnessSums* stiffness,
                     FrictionSums* friction) noexcept {
  for (BlockTask& task : tasks) evaluate_block(job, task, sums, stiffness, friction);
}

ReachedVoxels find_voxels(const ContactJob& job, const BlockView& block, float /*motion*/, std::uint16_t*) noexcept {
  scratch().min_width = job.motion.min_width;
  sample_contact(job.head, block, job.grid, Quadrature::sub_voxel, scratch());
  return {nullptr, scratch().samples};  // evaluate_blocks samples again
}

ContactTotals totals_of(const ContactJob& job, const ContactSums& sums, double /*voxel_volume*/) noexcept {
  const double weight = job.level_of_detail;
  ContactTotals all = sums;
  all.resultant.wrench_T.force *= weight;
  all.resultant.wrench_T.torque *= weight;
  all.resultant.voxels *= int(job.level_of_detail);
  all.resultant.volume *= weight;
  all.energies.elastic_before *= weight;
  all.resultant.normal_force *= weight;
  all.resultant.push_T *= weight;
  all.resultant.moment_T *= weight;
  all.resultant.area *= weight;
  // Voxels that were not evaluated store the work, and lose nothing.
  all.energies.elastic +=
      (weight - 1) * (sums.energies.elastic + sums.energies.released + sums.energies.crushed + sums.helped);
  all.energies.damping *= weight;
  return all;
}

}  // namespace hapticut::kernels
