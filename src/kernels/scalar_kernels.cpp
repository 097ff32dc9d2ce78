// SPDX-License-Identifier: Apache-2.0
// What runs where Highway is not available: the scalar reference itself.
#include <algorithm>
#include <cmath>

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/kernels.hpp"

namespace hapticut::kernels {
namespace {

/// Leaves out what has no turn.
BlockView with_turn(const ContactJob& job, const BlockView& block,
                    std::array<std::uint64_t, kBlockEdge>& solid) noexcept {
  BlockView view = block;
  for (int slab = 0; slab < kBlockEdge; ++slab) {
    std::uint64_t& word = solid[std::size_t(slab)] = block.solid == nullptr ? ~std::uint64_t(0) : block.solid[slab];
    for (int strip = 0; strip < kBlockVoxels / kBlockEdge / BlockChange::kStrip; ++strip)
      if (!job.has_turn(block.origin, slab, strip)) word &= ~(0xFFFFULL << (BlockChange::kStrip * strip));
  }
  view.solid = solid.data();
  return view;
}

void press_block(const ContactJob& job, PressTask& task, ContactSums& sums, StiffnessSums* stiffness) noexcept {
  thread_local ContactBlock contact;
  task.change = {};
  std::array<std::uint64_t, kBlockEdge> solid;
  const BlockView block = job.level_of_detail > 1 ? with_turn(job, task.block, solid) : task.block;
  sample_contact(job.head, block, job.grid, job.quadrature, contact);
  if (contact.samples == 0) return;
  HeadMotion motion = job.motion;
  if (!task.may_cut) motion.removal = RemovalLaw::none;
  const LawTotals totals = FoundationLaw().evaluate(motion, job.materials, contact);
  Resultant resultant;
  hapticut::sum_resultant(contact, resultant);
  const double volume = std::pow(double(motion.voxel_size), 3);
  const auto add = [&](ContactSums::Term term, double total) { sums.lanes[term][0] += total / volume; };
  add(ContactSums::kForceX, -resultant.wrench_T.force.x());
  add(ContactSums::kForceY, -resultant.wrench_T.force.y());
  add(ContactSums::kForceZ, -resultant.wrench_T.force.z());
  add(ContactSums::kTorqueX, -resultant.wrench_T.torque.x());
  add(ContactSums::kTorqueY, -resultant.wrench_T.torque.y());
  add(ContactSums::kTorqueZ, -resultant.wrench_T.torque.z());
  // elastic_before = middle - change, elastic = middle + change - taken, released = taken - 2 lag - helped
  add(ContactSums::kElasticMiddle, totals.energies.elastic_before);
  add(ContactSums::kTakenElastic, totals.energies.elastic_before - totals.energies.elastic);
  add(ContactSums::kHelped, totals.energies.elastic_before - totals.energies.elastic - totals.energies.released);
  add(ContactSums::kDamping, totals.energies.damping);
  add(ContactSums::kRubbing, totals.energies.rubbing);
  add(ContactSums::kCredited, totals.energies.credited);
  add(ContactSums::kCouple, -totals.spin_couple * double(motion.spin));
  add(ContactSums::kFill, resultant.volume * volume);
  sums.voxels += resultant.voxels;
  sums.depth = std::max(sums.depth, float(resultant.depth));
  if (stiffness != nullptr) add_stiffness(contact, motion, job.materials, *stiffness);
  if (totals.may_remove) task.change = find_changes(contact, task.block, task.fill_after, sums.taken);
}

}  // namespace

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  head.visit_springs<float>(
      [&](const auto& springs) { hapticut::sample_contact(springs, block, grid, quadrature, out); });
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept { hapticut::sum_resultant(block, total); }

void press_blocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                  StiffnessSums* stiffness) noexcept {
  for (PressTask& task : tasks) press_block(job, task, sums, stiffness);
}

}  // namespace hapticut::kernels
