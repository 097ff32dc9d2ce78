// SPDX-License-Identifier: Apache-2.0
// The default law on a few blocks, from their voxels to the sums; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_INL_HPP
#endif

#include "kernels/gather-inl.hpp"
#include "kernels/stages-inl.hpp"
#include "kernels/whole-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Evaluates a few blocks in sequence: lists their voxels that may be inside the head, collects those that are in
/// contact, and runs the stages.
template <class Springs>
class Press {
 public:
  HWY_INLINE Press(const Springs& springs, const ContactJob& job, VoxelList& voxels, Columns& columns, Stages& stages)
      : springs_(springs),
        gather_(springs, job),
        axes_((job.grid.voxel_steps / double(job.motion.voxel_size)).template cast<float>()),
        whole_(springs, job, stages, axes_),
        voxels_(voxels),
        columns_(columns),
        stages_(stages),
        voxel_size_(job.motion.voxel_size),
        min_width_(job.motion.min_width),
        spins_(job.motion.spin != 0) {}

  HWY_INLINE void press(std::span<PressTask> tasks) {
    bool may_cut = true;
    stages_.allow(may_cut);
    for (std::size_t n = 0; n < tasks.size(); ++n) {
      PressTask& task = tasks[n];
      if (task.may_cut != may_cut) {
        collect_listed(tasks);
        run_stages(tasks);
        may_cut = task.may_cut;
        stages_.allow(may_cut);
      }
      const std::uint32_t strips = spins_ || stages_.writes() ? gather_.append(task.block, int(n), voxels_)
                                                              : whole_.press(gather_, task.block, int(n), voxels_);
      if (stages_.writes()) begin_strips(task, strips);
      if (voxels_.count >= VoxelList::kEnough) collect_listed(tasks);
    }
    collect_listed(tasks);
    run_stages(tasks);
    stages_.flush();
  }

 private:
  /// Stage sample_contact: collects the listed voxels that are in contact, with their springs, section and filled part.
  HWY_INLINE void collect_listed(std::span<PressTask> tasks) {
    const Floats d;
    const hn::RebindToSigned<Floats> ints;
    Columns& c = columns_;
    const Wide per_edge = 1 / voxel_size_;
    const Wide reach = -kVoxelReach * voxel_size_ * (Springs::kSmooth ? float(kSmoothScale) : 1.0F);
    for (int first = 0; first < voxels_.count; first += int(kWidth)) {
      const Place r = voxels_.place(first);
      const Wide fill = Wide::load(voxels_.fill + first);
      const SpringVectors<Wide> spring = springs_.at(r.x, r.y, r.z);
      if (!Springs::kCentral && !any(spring.depth > reach)) continue;
      const Place n = {r.x * spring.radial, r.y * spring.radial, spring.axial};
      const Section section(formulas::largest_component(axes_, n), min_width_);
      const Wide far = distance_of(spring) * per_edge - Wide(0.5F) * section.span();
      const Wide height = section.height_of(fill), top = far + height;
      const Mask listed = hn::FirstN(d, std::size_t(std::min(voxels_.count - first, int(kWidth))));
      const unsigned inside = bits_of(hn::And((top > 0 && fill > 0).m, listed));
      if (inside == 0) continue;
      const auto lanes = numbers_of(inside);
      const auto keep = [&](Columns::Name name, Wide value) HWY_ATTR {
        hn::StoreU(hn::TableLookupLanes(value.v, hn::IndicesFromVec(d, lanes)), d, c.of[name] + c.count);
      };
      keep(Columns::kX, r.x), keep(Columns::kY, r.y), keep(Columns::kZ, r.z);
      keep(Columns::kNormalX, n.x), keep(Columns::kNormalY, n.y), keep(Columns::kNormalZ, n.z);
      keep(Columns::kP, section.p), keep(Columns::kQ, section.q), keep(Columns::kPerArea, section.per_area);
      keep(Columns::kFar, far), keep(Columns::kTop, top), keep(Columns::kHeight, height), keep(Columns::kFill, fill);
      if constexpr (Springs::kSmooth) {
        keep(Columns::kSmooth, spring.smooth);
        c.smooth = c.smooth || any(spring.smooth > 0 && Where{mask_of(inside)});
      }
      const auto index = hn::LoadU(ints, voxels_.index + first);
      hn::StoreU(hn::TableLookupLanes(index, hn::IndicesFromVec(ints, lanes)), ints, c.index + c.count);
      if (c.count == 0) c.one_material = voxels_.material;
      if (c.one_material != voxels_.material) c.one_material = kEmpty;
      c.count += std::popcount(inside);
      if (c.count >= Columns::kChunk) run_stages(tasks);
    }
    voxels_.clear();
  }
  HWY_INLINE void run_stages(std::span<PressTask> tasks) {
    if (columns_.count > 0) stages_.run(tasks);
  }

  /// [m] Distance below the surface.
  [[nodiscard]] HWY_INLINE static Wide distance_of(const SpringVectors<Wide>& spring) {
    if constexpr (!Springs::kSmooth) return spring.depth;
    return formulas::distance_below(spring.depth, select(spring.smooth > 0, Wide(kSmoothScale), 1));
  }

  const Springs& springs_;
  const Gather<Springs> gather_;
  const Eigen::Matrix3f axes_;  // of the grid, in T
  Whole<Springs> whole_;
  VoxelList& voxels_;
  Columns& columns_;
  Stages& stages_;
  const float voxel_size_, min_width_;
  const bool spins_;
};

template <class Springs>
HWY_INLINE void PressAll(const Springs& springs, const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                         StiffnessSums* stiffness, FrictionSums* friction) {
  VoxelList voxels;  // empty
  Columns columns;
  StiffnessVectors stiffness_lanes;
  if (stiffness != nullptr) stiffness_lanes.clear();
  FrictionVectors friction_lanes;
  if (friction != nullptr) friction_lanes.clear();
  Stages stages(job, columns, sums, stiffness == nullptr ? nullptr : &stiffness_lanes,
                friction == nullptr ? nullptr : &friction_lanes);
  Press<Springs>(springs, job, voxels, columns, stages).press(tasks);
  if (friction != nullptr) friction_lanes.flush(*friction);
  if (stiffness != nullptr) stiffness_lanes.flush(*stiffness);
}

}  // namespace strips

HWY_ATTR void PressBlocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                          StiffnessSums* stiffness, FrictionSums* friction) {
  visit_springs<strips::Wide>(job.head, [&](const auto& springs) HWY_ATTR {
    strips::PressAll(springs, job, tasks, sums, stiffness, friction);
  });
}

HWY_ATTR int CountVoxels(const ContactJob& job, const BlockView& block) {
  return visit_springs<strips::Wide>(
      job.head, [&](const auto& springs) HWY_ATTR { return strips::Gather(springs, job).count(block); });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
