// SPDX-License-Identifier: Apache-2.0
// The kernels of the best instruction set of this machine, chosen by Highway at run time. Each set is compiled in a
// file of its own, kernels/targets/, so that they compile side by side.
#include "kernels/targets/which.hpp"
//
#define HWY_DISABLED_TARGETS HAPTICUT_LEFT_OUT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/simd_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "kernels/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

void SampleContact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                   ContactBlock& out);
void EvaluateBlocks(const ContactJob& job, std::span<BlockTask> tasks, ContactSums& sums, StiffnessSums* stiffness,
                    FrictionSums* friction);
ReachedVoxels FindVoxels(const ContactJob& job, const BlockView& block, float motion, std::uint16_t* out);
void SumResultant(const ContactBlock& block, Resultant& total);

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hapticut::kernels {

HWY_EXPORT(SampleContact);
HWY_EXPORT(EvaluateBlocks);
HWY_EXPORT(FindVoxels);
HWY_EXPORT(SumResultant);

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  if (quadrature == Quadrature::sub_voxel)  // not vectorised
    return head.visit_springs<float>(
        [&](const auto& springs) { hapticut::sample_contact(springs, block, grid, quadrature, out); });
  HWY_DYNAMIC_DISPATCH(SampleContact)(head, block, grid, quadrature, out);
}

void evaluate_blocks(const ContactJob& job, std::span<BlockTask> tasks, ContactSums& sums, StiffnessSums* stiffness,
                     FrictionSums* friction) noexcept {
  HWY_DYNAMIC_DISPATCH(EvaluateBlocks)(job, tasks, sums, stiffness, friction);
}

ReachedVoxels find_voxels(const ContactJob& job, const BlockView& block, float motion, std::uint16_t* out) noexcept {
  return HWY_DYNAMIC_DISPATCH(FindVoxels)(job, block, motion, out);
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept {
  if (block.sub_voxel) return hapticut::sum_resultant(block, total);
  HWY_DYNAMIC_DISPATCH(SumResultant)(block, total);
}

ContactTotals totals_of(const ContactJob& job, const ContactSums& sums, double voxel_volume) noexcept {
  using Term = ContactSums::Term;
  const double weight = job.level_of_detail;
  const auto total = [&](Term term) { return weight * sums.total(term) * voxel_volume; };
  ContactTotals all;
  Resultant& resultant = all.resultant;
  resultant.wrench_T.force = -Vec3(total(Term::kForceX), total(Term::kForceY), total(Term::kForceZ));
  resultant.wrench_T.torque = -Vec3(total(Term::kTorqueX), total(Term::kTorqueY), total(Term::kTorqueZ));
  // The couple does work against the whole rotation: of the spin and of the handpiece.
  if (const float turning = job.motion.turning(); job.motion.spin != 0 && turning != 0)
    resultant.wrench_T.torque.z() -= total(Term::kCouple) / double(turning);
  resultant.voxels = sums.voxels * int(job.level_of_detail);
  resultant.volume = weight * sums.total(Term::kFill);
  resultant.depth = double(sums.depth);
  resultant.normal_force = total(Term::kNormal);
  resultant.push_T = job.motion.spin != 0 ? -Vec3(total(Term::kPushX), total(Term::kPushY), total(Term::kPushZ))
                                          : resultant.wrench_T.force;
  resultant.moment_T = Vec3(total(Term::kMomentX), total(Term::kMomentY), total(Term::kMomentZ));
  resultant.area = weight * sums.total(Term::kArea);
  LawEnergies& energies = all.energies;
  const double lost = total(Term::kLost) / weight;
  energies.elastic_before = total(Term::kBefore);
  energies.elastic = energies.elastic_before +
                     (total(Term::kChange) + (weight - 1) * lost);  // voxels that were not evaluated lost nothing
  energies.crushed = total(Term::kCrushed) / weight;
  energies.released = lost - total(Term::kHelped) / weight - energies.crushed;
  energies.cutting = total(Term::kCutting) / weight;
  energies.damping = total(Term::kDamping);
  energies.rubbing = total(Term::kRubbing) / weight;  // over the time since the last evaluation
  energies.credited = total(Term::kCredited) / weight;
  return all;
}

}  // namespace hapticut::kernels
#endif
