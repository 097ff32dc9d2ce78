// SPDX-License-Identifier: Apache-2.0
// FoundationLaw on a few blocks, from their voxels to the sums, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/cut_voxels-inl.hpp"
#include "kernels/friction-inl.hpp"
#include "kernels/gather-inl.hpp"
#include "kernels/motion-inl.hpp"
#include "kernels/places-inl.hpp"
#include "kernels/press_sums-inl.hpp"
#include "kernels/smooth-inl.hpp"
#include "kernels/stiffness_sums-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Evaluates a few blocks in sequence. The voxels inside the head are gathered first, so that no lane is wasted.
template <class Springs>
class Press : Places {
 public:
  /// @param voxels, samples  buffers for those of a few blocks
  HWY_INLINE Press(const Springs& springs, const ContactJob& job, VoxelList& voxels, SampleList& samples,
                   ContactSums& totals, StiffnessVectors* stiffness, FrictionVectors* friction)
      : Places(job.materials, voxels, totals),
        springs_(springs),
        gather_(springs, job),
        job_(job),
        m_(job.motion),
        samples_(samples),
        stiffness_(stiffness),
        friction_(friction),
        damped_(job.damped),
        release_(m_.removal == RemovalLaw::elastic_release),
        spins_(m_.spin != 0),
        deep_enough_(kVoxelReach * m_.voxel_size + (Springs::kCentral ? m_.velocity.norm() * m_.duration : 0.0F)),
        axes_((job.grid.voxel_steps / double(m_.voxel_size)).template cast<float>()) {}

  HWY_INLINE void press(std::span<PressTask> tasks) {
    PressSums sums;  // local, so that the loop keeps them in registers or cache
    tasks_ = tasks.data();
    for (std::size_t n = 0; n <= tasks.size(); ++n) {
      const bool done = n == tasks.size();
      if (done || voxels_.count >= VoxelList::kEnough || tasks[n].may_cut != may_write_) {
        if (stands())
          press_listed<true>(sums);
        else
          press_listed<false>(sums);
      }
      if (!done) gather(int(n), sums);
    }
    material_.flush();
    sums.flush(totals_);
  }

 private:
  /// Appends the voxels of a block to the list, except those that are evaluated at once.
  HWY_INLINE void gather(int number, PressSums& sums) {
    PressTask& task = tasks_[number];
    allow(task);
    std::uint32_t strips;
    if (stands()) {
      DeepSums deep;
      const std::uint32_t done = press_strips_within(task.block, deep);
      strips = gather_.append_skimmed(
          task.block, number, voxels_,
          done, [&](int voxel, const Vectors& r, Vec fill, Mask hit) HWY_ATTR __attribute__((always_inline)) {
            return press_deep(task.block, voxel, r, fill, hit, deep);
          });
      sums.add(deep);
    } else {
      strips = gather_.append(task.block, number, voxels_);
    }
    if (strips == 0) return;
    near_axis_ |= spins_ && gather_.near_axis(task.block);
    if (writes()) begin_strips(task, strips);
  }

  // For a head that stands and removes nothing, whole voxels that stay wholly inside the head need no section: the mean
  // depth of a cube is that of its centre, and the mean of its square is larger by l^2/12.

  /// Evaluates the strips of a block of one material that are so inside a ball: only springs, in registers.
  /// @return bit n: strip n was evaluated
  HWY_INLINE std::uint32_t press_strips_within(const BlockView& block, DeepSums& sums) {
    if constexpr (Springs::kCentral) {
      if (damped_ || m_.lead > 0 || stiffness_ != nullptr || friction_ != nullptr) return 0;
      if (block.material != nullptr || block.fill != nullptr) return 0;
      material_.load(block.uniform_material);
      const Vec k = material_.vectors().stiffness;
      const Eigen::Vector3f path = m_.velocity * m_.duration;
      DeepSums more;
      const std::uint32_t done = gather_.for_each_within(
          block, deep_enough_, [&](const Vectors& r) HWY_ATTR __attribute__((always_inline)) {
            const SpringVectors<Vec> spring = springs_.near(r.x, r.y, r.z);
            Sample s;
            s.radial = spring.radial, s.axial = spring.axial;
            const Vec advance = rate_of_depth<true>(r, s, path, path);
            const Vec pushed = more.add_spring(k, spring.depth, advance, 0.5F, m_.voxel_size);
            more.template add_push<true>(r, s, pushed);
            more.add_place(r, pushed);
            note_depth(spring.depth, r, s, hn::FirstN(Floats(), kWidth), more);
          });
      more.voxels = kStripLanes * std::popcount(done);
      sums = more;
      return done;
    }
    return 0;
  }

  /// Evaluates the whole voxels of a vector that are deep inside the head.
  /// @return the lanes that are left
  HWY_INLINE Mask press_deep(const BlockView& block, int voxel, const Vectors& r, Vec fill, Mask hit, DeepSums& sums) {
    const Floats d;
    const Vec one = broadcast(1.0F);
    Mask deep = hn::And(hit, fill >= one);
    if constexpr (Springs::kCentral) deep = hn::And(deep, springs_.hits(r.x, r.y, r.z, -deep_enough_));
    if (hn::AllFalse(d, deep)) return hit;
    const SpringVectors<Vec> spring = springs_.near(r.x, r.y, r.z);
    Sample s;
    s.radial = spring.radial, s.axial = spring.axial;
    const Vec advance =
        rate_of_depth<Springs::kCentral>(r, s, m_.velocity, m_.angular_velocity) * broadcast(m_.duration);
    if constexpr (!Springs::kCentral) deep = hn::And(deep, spring.depth > broadcast(deep_enough_) + hn::Abs(advance));
    if constexpr (Springs::kSmooth) deep = hn::AndNot(spring.smooth > hn::Zero(d), deep);
    const unsigned lanes = bits_of(deep);
    const MaterialId* ids = block.material == nullptr ? &block.uniform_material : block.material + voxel;
    if (damped_ && job_.materials[ids[0]].crushing_depth < ContactMaterial::kNeverCrushed) return hit;
    if (lanes == 0 || (block.material != nullptr && !all_are(ids, ids[0]))) return hit;

    material_.load(ids[0]);
    const Vec depth = spring.depth, k = hn::IfThenElseZero(deep, material_.vectors().stiffness);
    const Vec pushed = sums.add_spring(k, depth, advance, 0.5F - m_.lead, m_.voxel_size);
    DampingVectors damped;
    Vec normal = pushed;
    if (damped_) {
      const Vec felt = rate_of_depth<Springs::kCentral>(r, s, m_.felt_velocity, m_.felt_angular_velocity);
      damped = DampingVectors(material_.vectors().damping * felt);
      normal = pushed * damped.factor;
      sums.damping = hn::MulAdd(normal - pushed, advance, sums.damping);
    }
    sums.template add_push<Springs::kCentral>(r, s, normal);
    sums.add_place(r, normal);
    sums.voxels += std::popcount(lanes);
    note_depth(depth, r, s, deep, sums);
    if (stiffness_ != nullptr) [[unlikely]] {
      const Vec damper = damped.slope * material_.vectors().damping * depth * broadcast(1 / m_.time_to_move());
      s.rate = s.inverse_slip = s.smooth = hn::Zero(d);
      add_springs(m_, k * (damped.factor + damper), normal, hn::Zero(d), r, s, *stiffness_);
    }
    if (friction_ != nullptr) [[unlikely]] {
      s.smooth = hn::Zero(d);
      add_friction(0, normal, hn::IfThenElseZero(deep, one), r, s);
    }
    return hn::AndNot(deep, hit);
  }

  /// Updates the maximum depth by the tops of whole voxels.
  HWY_INLINE void note_depth(Vec depth, const Vectors& r, const Sample& s, Mask deep, DeepSums& sums) {
    const Floats d;
    const Vec reach = broadcast(kVoxelReach * m_.voxel_size);
    if (hn::AllFalse(d, hn::And(deep, depth + reach > broadcast(deepest_)))) [[likely]]
      return;
    const Vec half_span =
        broadcast(0.5F * m_.voxel_size) * SectionVectors(max_component_of(axes_, r, s), m_.min_width).span();
    sums.depth = hn::Max(sums.depth, hn::IfThenElseZero(deep, depth + half_span));
    deepest_ = hn::GetLane(hn::MaxOfLanes(d, sums.depth));
  }

  /// Samples all voxels of the list before the law is evaluated on any. With one loop for both, the processor would
  /// wait for long chains of dependent results.
  /// @tparam kStands  the head stands and removes nothing, which needs fewer checks
  template <bool kStands>
  HWY_INLINE void press_listed(PressSums& sums) {
    const Floats d;
    constexpr int kLanes = int(kWidth);
    const int count = voxels_.count;
    if (count == 0) return;
    voxels_.repeat_first();
    for (int first = 0; first < count; first += kLanes) {
      const Mask listed = hn::FirstN(d, std::size_t(std::min(count - first, kLanes)));
      const Vec fill = hn::Load(d, voxels_.fill + first);
      samples_.template store<Springs::kSmooth>(first, sample<kStands>(voxels_.place(first), fill, listed, sums));
    }
    if (voxels_.material != kEmpty) material_.load(voxels_.material);
    for (int first = 0; first < count; first += kLanes) {
      if (voxels_.material == kEmpty) load_listed_materials(first);
      press_parts<kStands>(first, voxels_.place(first), hn::Load(d, voxels_.fill + first),
                           samples_.template load<Springs::kSmooth>(first), sums);
    }
    if (writes()) write_fills();
    voxels_.clear();
    near_axis_ = false;
  }

  HWY_INLINE void allow(const PressTask& task) {
    may_write_ = task.may_cut;
    may_cut_ = may_write_ && m_.cuts();
    may_crush_ = may_write_ && m_.crushes;
  }
  [[nodiscard]] HWY_INLINE bool writes() const { return may_cut_ || may_crush_; }
  [[nodiscard]] HWY_INLINE bool stands() const { return !spins_ && !writes(); }

  /// Stage sample_contact.
  /// @param r       [m] positions of voxels, in T
  /// @param listed  the lanes that count if they are inside the head
  template <bool kStands>
  HWY_INLINE Sample sample(const Vectors& r, Vec fill, Mask listed, PressSums& sums) const {
    const Floats d;
    const SpringVectors<Vec> spring = springs_.near(r.x, r.y, r.z);
    Sample s;
    s.felt_rate = s.inverse_slip = s.slip_path = hn::Zero(d);
    s.radial = spring.radial;
    s.axial = spring.axial;
    s.smooth = spring.smooth;
    s.max_component = max_component_of(axes_, r, s);
    const SectionVectors section(s.max_component, m_.min_width);
    const Vec above_middle = hn::NegMulAdd(broadcast(0.5F), section.span(), section.height_of(fill));
    const Vec depth = distance_below<Springs::kSmooth>(s, spring.depth);
    s.top = hn::MulAdd(broadcast(m_.voxel_size), above_middle, depth);
    const Mask inside = hn::And(hn::And(s.top > hn::Zero(d), fill > hn::Zero(d)), listed);
    s.top = hn::IfThenElseZero(inside, s.top);
    s.depth = hn::IfThenElseZero(inside, depth);
    sums.voxels += int(hn::CountTrue(d, inside));
    if (!kStands && spins_) {
      const Vectors v = surface_velocity(m_, r);
      s.rate = hn::MulAdd(s.radial, hn::MulAdd(r.x, v.x, r.y * v.y), s.axial * v.z);
      Vec slip_squared = slip_of_centers(v, s);
      if (near_axis_) slip_squared = slip_squared + slip_about_axis(m_, r, slip_squared);
      constexpr float kRegular = FoundationLaw::kSlipRegularization * FoundationLaw::kSlipRegularization;
      s.inverse_slip = inverse_root(slip_squared + broadcast(kRegular));
      s.slip_path = slip_squared * s.inverse_slip * broadcast(m_.duration * m_.level_of_detail);
    } else {
      s.rate = rate_of_depth<Springs::kCentral>(r, s, m_.velocity, m_.angular_velocity);
    }
    if (damped_) s.felt_rate = rate_of_depth<Springs::kCentral>(r, s, m_.felt_velocity, m_.felt_angular_velocity);
    return s;
  }

  /// FoundationLaw::evaluate and sum_resultant.
  /// @param first  of the list
  template <bool kStands>
  HWY_INLINE void press_parts(int first, const Vectors& r, Vec old_fill, const Sample& s, PressSums& sums) {
    const MaterialVectors& material = material_at<Springs::kSmooth>(material_.vectors(), s, m_.voxel_size);
    DampingVectors damped;
    if (damped_) damped = DampingVectors(material.damping * s.felt_rate);
    const auto deep = [&]() HWY_ATTR { return s.top > damped.crushing_depth(material.crushing_depth); };
    if constexpr (kStands)
      press_as<true, false>(first, r, old_fill, s, material, damped, sums);
    else if (may_crush_ && !hn::AllFalse(Floats(), deep())) [[unlikely]]
      press_as<false, true>(first, r, old_fill, s, material, damped, sums);
    else
      press_as<false, false>(first, r, old_fill, s, material, damped, sums);
  }
  template <bool kStands, bool kCrushes>
  HWY_INLINE void press_as(int first, const Vectors& r, Vec old_fill, const Sample& s, const MaterialVectors& material,
                           const DampingVectors& damped, PressSums& sums) {
    const Floats d;
    const Vec zero = hn::Zero(d);
    const Mask inside = s.top > zero;
    const Vec fill = hn::IfThenElseZero(inside, old_fill), advance = s.rate * broadcast(m_.duration);
    const Vec crushing_depth = kCrushes ? damped.crushing_depth(material.crushing_depth) : zero;
    const Vec mean_rate = m_.tooth_rate > 0 ? s.rate - rate_of_depth<true>(r, s, m_.ripple, m_.ripple) : s.rate;
    const PartOutcome p = press_parts_of<kCrushes>(m_, material, s, mean_rate, fill, damped.factor, crushing_depth,
                                                   !kStands && may_cut_, release_);
    if (!kStands && (kCrushes || writes())) {
      const Mask finished = p.credit > zero;
      if (!hn::AllFalse(d, finished)) {
        sums.credited = hn::MulAdd(p.price, p.credit, sums.credited);
        mark_emptied(first, bits_of(finished));
      }
      sums.rubbing = hn::MulAdd(p.price, hn::Max(zero, p.refused), sums.rubbing);
      sums.credited = hn::NegMulAdd(p.price, hn::Min(zero, p.refused), sums.credited);
      const Vec cut = p.kept - p.left;
      if (release_) sums.helped = hn::MulAdd(p.energy - p.price, cut, sums.helped);
      if (m_.tooth_rate > 0) sums.chips = hn::MulAdd(p.energy - material.energy, cut, sums.chips);
      if constexpr (kCrushes) {
        sums.chips = hn::NegMulAdd(material.energy, fill - p.kept, sums.chips);
        // Without the part that helped cutting, which is booked as such.
        const Vec lost = release_ ? hn::NegMulAdd(p.energy - p.price, cut, p.released) : p.released;
        sums.crushed = sums.crushed + hn::IfThenElseZero(p.crushed, lost);
      }
      book_removed(fill - p.left, first, inside);
      hn::Store(hn::IfThenElse(inside, p.left, old_fill), d, voxels_.fill_after + first);
    }
    const Vec spring = p.rubbing + p.cut, normal = spring * damped.factor;
    const Vec kappa = !kStands && spins_ ? material.cutting_ratio : zero;
    if constexpr (kStands) {
      sums.template add_push<Springs::kCentral>(r, s, normal);
    } else {
      const Vec tangential = kappa * normal * s.inverse_slip;
      sums.add_reaction(r, s, hn::NegMulAdd(tangential, s.rate, normal), tangential, surface_velocity(m_, r));
      sums.rubbing = hn::MulAdd(kappa * p.rubbing * damped.factor, s.slip_path, sums.rubbing);
      sums.add_normal(r, s, normal);
      if (near_axis_) sums.couple = hn::MulAdd(tangential, slip_beyond_centers(m_, r, s), sums.couple);
    }
    sums.add_place(r, normal);
    sums.area = sums.area + p.area;

    sums.before = sums.before + p.before;
    sums.change = sums.change + (p.after - p.before);
    sums.released = sums.released + p.released;
    sums.damping = sums.damping + (normal - spring) * advance;
    if (stiffness_ != nullptr) [[unlikely]]
      add_springs(m_, p.slope(material, damped, m_.time_to_move()), normal, kappa, r, s, *stiffness_);
    if (friction_ != nullptr) add_friction(first, normal, p.volume, r, s);
    sums.fill = sums.fill + p.volume;
    sums.depth = hn::Max(sums.depth, p.top);
  }

  HWY_INLINE void add_friction(int first, Vec normal, Vec filled, const Vectors& r, const Sample& s) {
    const FrictionConstants constants(job_.materials, [&](int lane) HWY_ATTR {
      return material_.one() != kEmpty ? material_.one() : material_of(first + lane);
    });
    const Vectors place = r;  // a copy, so that the loop's own vector needs no address
    friction_->add(normal, scaled<Springs::kSmooth>(s, filled, kBeta * kBeta), constants, place, s.radial, s.axial);
  }

  const Springs& springs_;
  const Gather<Springs> gather_;
  const ContactJob& job_;
  const HeadMotion& m_;
  SampleList& samples_;
  StiffnessVectors* const stiffness_;  // null: not needed
  FrictionVectors* const friction_;    // likewise
  const bool damped_, release_, spins_;
  const float deep_enough_;     // [m] depth at which a voxel is wholly inside; for a ball, during the whole sub-step
  const Eigen::Matrix3f axes_;  // of the grid, in T
  // Of the listed voxels:
  bool may_write_ = true, may_cut_ = true, may_crush_ = false;
  bool near_axis_ = false;  // some of them are near the spindle's axis
  float deepest_ = 0;       // [m] of all voxels that were evaluated without being listed
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
