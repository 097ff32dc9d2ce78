// SPDX-License-Identifier: Apache-2.0
// Kernels press_blocks and count_voxels, which choose the Press for the head;
// included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_BLOCKS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_BLOCKS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_BLOCKS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_BLOCKS_INL_HPP
#endif

#include "kernels/press-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

template <class Springs>
HWY_INLINE void PressAll(const Springs& springs, const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                         StiffnessSums* stiffness, FrictionSums* friction) {
  VoxelList voxels;  // empty
  SampleList samples;
  StiffnessVectors stiffness_lanes;
  if (stiffness != nullptr) stiffness_lanes.clear();
  FrictionVectors friction_lanes;
  if (friction != nullptr) friction_lanes.clear();
  Press<Springs> press(springs, job, voxels, samples, sums, stiffness == nullptr ? nullptr : &stiffness_lanes,
                       friction == nullptr ? nullptr : &friction_lanes);
  press.press(tasks);
  if (friction != nullptr) friction_lanes.flush(*friction);
  if (stiffness != nullptr) stiffness_lanes.flush(*stiffness);
}

}  // namespace strips

HWY_ATTR void PressBlocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                          StiffnessSums* stiffness, FrictionSums* friction) {
  visit_springs(job.head, [&](const auto& springs)
                              HWY_ATTR { strips::PressAll(springs, job, tasks, sums, stiffness, friction); });
}

HWY_ATTR int CountVoxels(const ContactJob& job, const BlockView& block) {
  return visit_springs(job.head,
                       [&](const auto& springs) HWY_ATTR { return strips::Gather(springs, job).count(block); });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
