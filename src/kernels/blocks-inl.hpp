// SPDX-License-Identifier: Apache-2.0
// The default law on a few blocks, from their voxels to the sums; included once per instruction set.
#if defined(HAPTICUT_KERNELS_BLOCKS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_BLOCKS_INL_HPP
#undef HAPTICUT_KERNELS_BLOCKS_INL_HPP
#else
#define HAPTICUT_KERNELS_BLOCKS_INL_HPP
#endif

#include "kernels/gather-inl.hpp"
#include "kernels/stages-inl.hpp"
#include "kernels/whole-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Evaluates a few blocks in sequence: finds their voxels that may be inside the head, collects those that are in
/// contact, and runs the stages.
template <class Springs>
class BlockEvaluator {
 public:
  HWY_INLINE BlockEvaluator(const Springs& springs, const ContactJob& job, Columns& columns, Stages& stages,
                            StiffnessVectors* stiffness, FrictionVectors* friction)
      : gather_(springs, job, 0),
        springs_(springs),
        job_(job),
        columns_(columns),
        stages_(stages),
        steps_((job.grid.voxel_steps).template cast<float>()),
        axes_((job.grid.voxel_steps / double(job.motion.voxel_size)).template cast<float>()),
        voxel_size_(job.motion.voxel_size),
        min_width_(job.motion.min_width),
        stands_(job.motion.spin == 0 && !job.motion.crushes),
        whole_(springs, job, stages, axes_, stiffness, friction) {}

  HWY_INLINE void evaluate(std::span<BlockTask> tasks) {
    bool may_cut = true;
    stages_.allow(may_cut);
    for (std::size_t n = 0; n < tasks.size(); ++n) {
      const BlockTask& task = tasks[n];
      if (task.may_cut != may_cut) {
        run_stages(tasks);
        may_cut = task.may_cut;
        stages_.allow(may_cut);
      }
      collect(found(task), tasks, int(n));
    }
    run_stages(tasks);
    whole_.flush();
    stages_.flush();
  }

 private:
  /// The voxels of a block that may be in contact. Whole voxels in a standing ball are evaluated on the way.
  HWY_INLINE ReachedVoxels found(const BlockTask& task) {
    if constexpr (Springs::kCentral)
      if (stands_) return whole_.evaluate_block(gather_, task.block, list_);
    return task.reached.voxels != nullptr ? task.reached : gather_.find(task.block, list_);
  }
  /// Stage sample_contact: collects the listed voxels that are in contact, with their springs, section and filled part.
  HWY_INLINE void collect(const ReachedVoxels& reached, std::span<BlockTask> tasks, int number) {
    const Floats d;
    const hn::RebindToSigned<Floats> ints;
    const hn::Rebind<std::uint16_t, Floats> shorts;
    Columns& c = columns_;
    const BlockView& block = tasks[std::size_t(number)].block;
    const Eigen::Vector3f base = job_.grid.position(block.origin).template cast<float>();
    const Wide per_edge = 1 / voxel_size_;
    const Wide reach = -kVoxelReach * voxel_size_ * (Springs::kSmooth ? float(kSmoothScale) : 1.0F);
    for (int first = 0; first < reached.count; first += int(kWidth)) {
      const auto voxels = hn::PromoteTo(ints, hn::LoadU(shorts, reached.voxels + first));
      const Place r = place_of(voxels, base);
      const formulas::SpatialSpring<Wide> spring = springs_.at(r.x, r.y, r.z);
      if (!Springs::kCentral && !any(spring.depth > reach)) continue;
      const Wide fill = block.fill == nullptr ? Wide(1) : Wide(hn::GatherIndex(d, block.fill, voxels));
      Mask listed = hn::FirstN(d, std::size_t(std::min(reached.count - first, int(kWidth))));
      if (stands_ && !Springs::kCentral && reached.material != kEmpty)
        listed = whole_.evaluate_lanes(reached.material, r, spring, fill, listed);
      const Place n = {r.x * spring.radial, r.y * spring.radial, spring.axial};
      const Section section(formulas::largest_component(axes_, n), min_width_);
      const Part part = Part::of(section, distance_of(spring) * per_edge, fill);
      const unsigned inside = bits_of(hn::And((part.top > 0 && fill > 0).m, listed));
      if (inside == 0) continue;
      const auto keep = [&](Columns::Name name, Wide value)
                            HWY_ATTR { store_lanes(value.v, inside, c.of[name] + c.count); };
      keep(Columns::kX, r.x), keep(Columns::kY, r.y), keep(Columns::kZ, r.z);
      keep(Columns::kNormalX, n.x), keep(Columns::kNormalY, n.y), keep(Columns::kNormalZ, n.z);
      keep(Columns::kP, section.p), keep(Columns::kQ, section.q), keep(Columns::kPerArea, section.per_area);
      keep(Columns::kFar, part.far), keep(Columns::kTop, part.top), keep(Columns::kHeight, part.height);
      keep(Columns::kFill, fill);
      if constexpr (Springs::kSmooth) {
        keep(Columns::kSmooth, spring.smooth);
        c.smooth = c.smooth || any(spring.smooth > 0 && Where{mask_of(inside)});
      }
      const auto index = voxels + hn::Set(ints, number * kBlockVoxels);
      const auto order = hn::IndicesFromVec(ints, numbers_of(inside));
      hn::StoreU(hn::TableLookupLanes(index, order), ints, c.index + c.count);
      if (c.count == 0) c.one_material = reached.material;
      if (c.one_material != reached.material) c.one_material = kEmpty;
      c.count += std::popcount(inside);
      if (c.count < Columns::kChunk) continue;
      stages_.run(tasks, Columns::kChunk);
      c.one_material = reached.material;  // material of those that are left
    }
  }
  /// [m] Positions of voxels in T.
  /// @param voxels  their offsets in a block
  /// @param base    [m] of the block's first voxel
  [[nodiscard]] HWY_INLINE Place place_of(hn::Vec<hn::RebindToSigned<Floats>> voxels, const Eigen::Vector3f& base) {
    const Floats d;
    const auto seven = hn::Set(hn::RebindToSigned<Floats>(), 7);
    const Wide i = hn::ConvertTo(d, hn::ShiftRight<6>(voxels)),
               j = hn::ConvertTo(d, hn::And(hn::ShiftRight<3>(voxels), seven)),
               k = hn::ConvertTo(d, hn::And(voxels, seven));
    const auto along = [&](int axis) HWY_ATTR {
      return Wide(base[axis]) + i * steps_(axis, 0) + j * steps_(axis, 1) + k * steps_(axis, 2);
    };
    return {along(0), along(1), along(2)};
  }
  HWY_INLINE void run_stages(std::span<BlockTask> tasks) {
    if (columns_.count > 0) stages_.run(tasks, columns_.count);
  }

  /// [m] Distance below the surface.
  [[nodiscard]] HWY_INLINE static Wide distance_of(const formulas::SpatialSpring<Wide>& spring) {
    if constexpr (!Springs::kSmooth) return spring.depth;
    return formulas::distance_below(spring.depth, select(spring.smooth > 0, Wide(kSmoothScale), 1));
  }

  alignas(64) std::uint16_t list_[ReachedVoxels::kCapacity];
  const Gather<Springs> gather_;
  const Springs& springs_;
  const ContactJob& job_;
  Columns& columns_;
  Stages& stages_;
  const Eigen::Matrix3f steps_;  // [m] steps of the grid, in T
  const Eigen::Matrix3f axes_;   // axes of the grid, in T
  const float voxel_size_, min_width_;
  const bool stands_;  // and removes nothing
  WholeVoxels<Springs> whole_;
};

template <class Springs>
HWY_INLINE void EvaluateAll(const Springs& springs, const ContactJob& job, std::span<BlockTask> tasks,
                            ContactSums& sums, StiffnessSums* stiffness, FrictionSums* friction) {
  Columns columns;
  AskedVectors in_stages, of_whole;  // apart, so that their sums do not depend on which of them runs first
  in_stages.ask(stiffness, friction), of_whole.ask(stiffness, friction);
  Stages stages(job, columns, sums, in_stages.stiffness(), in_stages.friction());
  BlockEvaluator<Springs>(springs, job, columns, stages, of_whole.stiffness(), of_whole.friction()).evaluate(tasks);
  in_stages.flush(), of_whole.flush();
}

}  // namespace strips

HWY_ATTR void EvaluateBlocks(const ContactJob& job, std::span<BlockTask> tasks, ContactSums& sums,
                             StiffnessSums* stiffness, FrictionSums* friction) {
  visit_springs<strips::Wide>(job.head, [&](const auto& springs) HWY_ATTR {
    strips::EvaluateAll(springs, job, tasks, sums, stiffness, friction);
  });
}

HWY_ATTR ReachedVoxels FindVoxels(const ContactJob& job, const BlockView& block, float motion, std::uint16_t* out) {
  return visit_springs<strips::Wide>(
      job.head, [&](const auto& springs) HWY_ATTR { return strips::Gather(springs, job, motion).find(block, out); });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
