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
#include "kernels/stiffness-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// A few blocks one after the other. The voxels inside the head are gathered first, so that no lane computes for
/// nothing.
/// @tparam kOfParts  Quadrature::sub_voxel: voxels are integrated over their filled parts
template <class Springs, Mode kMode, bool kOfParts>
class Press : Places {
 public:
  /// @param voxels, samples  room for those of a few blocks
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
        implicit_(m_.lead > 0 || stiffness != nullptr),
        axes_((job.grid.voxel_steps / double(m_.voxel_size)).template cast<float>()) {}

  HWY_INLINE void press(std::span<PressTask> tasks) {
    PressSums sums;  // close at hand in the loop
    tasks_ = tasks.data();
    // One place that presses, for its code is long.
    for (std::size_t n = 0; n <= tasks.size(); ++n) {
      const bool done = n == tasks.size();
      if (done || voxels_.count >= VoxelList::kEnough || tasks[n].may_cut != may_write_) press_listed(sums);
      if (!done) gather(int(n));
    }
    if constexpr (kMode == Mode::cutting) material_.flush();
    sums.template flush<kMode>(damped_ || m_.lead > 0, totals_);
  }

 private:
  /// Appends the voxels of a block to the list.
  HWY_INLINE void gather(int number) {
    PressTask& task = tasks_[number];
    allow(task);
    const std::uint32_t strips = gather_.append(task.block, number, voxels_);
    if (strips == 0) return;
    near_axis_ |= kMode != Mode::standing && gather_.near_axis(task.block);
    if (kMode == Mode::cutting && writes()) begin_strips(task, strips);
  }

  /// Samples all voxels of the list before the law is evaluated on any: in one loop for both, the processor would wait
  /// for one long chain of results after the other.
  HWY_INLINE void press_listed(PressSums& sums) {
    const Floats d;
    constexpr int kLanes = int(kWidth);
    const int count = voxels_.count;
    if (count == 0) return;
    voxels_.repeat_first();
    for (int first = 0; first < count; first += kLanes) {
      const Mask listed = hn::FirstN(d, std::size_t(std::min(count - first, kLanes)));
      const Vec fill = hn::Load(d, voxels_.fill + first);
      samples_.template store<kOfParts, Springs::kSmooth>(first, sample(voxels_.place(first), fill, listed, sums));
    }
    if (voxels_.material != kEmpty) material_.load(voxels_.material);
    for (int first = 0; first < count; first += kLanes) {
      if (voxels_.material == kEmpty) load_listed_materials(first);
      press_voxels(first, voxels_.place(first), hn::Load(d, voxels_.fill + first),
                   samples_.template load<kOfParts, Springs::kSmooth>(first), sums);
    }
    if (kMode == Mode::cutting && writes()) write_fills();
    voxels_.clear();
    near_axis_ = false;
  }

  HWY_INLINE void allow(const PressTask& task) {
    may_write_ = task.may_cut;
    may_cut_ = may_write_ && (!kOfParts || m_.cuts());
    may_crush_ = kOfParts && may_write_ && m_.crushes;
  }
  [[nodiscard]] HWY_INLINE bool writes() const { return may_cut_ || may_crush_; }

  /// Stage sample_contact.
  /// @param r       [m] places of voxels, in T
  /// @param listed  the lanes that count, if they are inside the head
  HWY_INLINE Sample sample(const Vectors& r, Vec fill, Mask listed, PressSums& sums) const {
    const Floats d;
    const SpringVectors<Vec> spring = kOfParts ? springs_.near(r.x, r.y, r.z) : springs_.at(r.x, r.y, r.z);
    Sample s;
    s.felt_rate = s.inverse_slip = s.slip_path = s.top = s.largest = hn::Zero(d);
    s.radial = spring.radial;
    s.axial = spring.axial;
    s.smooth = spring.smooth;
    Mask inside;
    if constexpr (kOfParts) {
      s.largest = largest_component(axes_, r, s);
      const SectionVectors section(s.largest);
      const Vec above_middle = hn::NegMulAdd(broadcast(0.5F), section.span(), section.height_of(fill));
      s.top = hn::MulAdd(broadcast(m_.voxel_size), above_middle, spring.depth);
      inside = hn::And(hn::And(s.top > hn::Zero(d), fill > hn::Zero(d)), listed);
      s.top = hn::IfThenElseZero(inside, s.top);
    } else {
      inside = hn::And(spring.depth > hn::Zero(d), listed);
    }
    s.depth = hn::IfThenElseZero(inside, spring.depth);
    s.radial = scaled<Springs::kSmooth>(s, s.radial), s.axial = scaled<Springs::kSmooth>(s, s.axial);
    sums.voxels += int(hn::CountTrue(d, inside));
    if constexpr (kMode == Mode::standing) {
      s.rate = s.closing = rate_of_depth<Springs::kCentral>(r, s, m_.velocity, m_.angular_velocity);
    } else {
      const Vectors v = surface_velocity(m_, r);
      s.rate = s.closing = hn::MulAdd(s.radial, hn::MulAdd(r.x, v.x, r.y * v.y), s.axial * v.z);
      if constexpr (Springs::kSmooth)
        s.closing = hn::IfThenElse(s.on_smooth(), s.rate * broadcast(1 / (kBeta * kBeta)), s.rate);
      Vec slip_squared = slip_of_centers(v, s);
      if (near_axis_) slip_squared = slip_squared + slip_about_axis(m_, r, slip_squared);
      constexpr float kRegular = FoundationLaw::kSlipRegularization * FoundationLaw::kSlipRegularization;
      s.inverse_slip = inverse_root(slip_squared + broadcast(kRegular));
      s.slip_path = slip_squared * s.inverse_slip * broadcast(m_.duration * m_.level_of_detail);
    }
    if (damped_) s.felt_rate = rate_of_depth<Springs::kCentral>(r, s, m_.felt_velocity, m_.felt_angular_velocity);
    return s;
  }

  /// Stages evaluate_law and sum_resultant.
  /// @param first  of the list
  HWY_INLINE void press_voxels(int first, const Vectors& r, Vec old_fill, const Sample& s, PressSums& sums) {
    if constexpr (kOfParts) return press_parts(first, r, old_fill, s, sums);
    const Floats d;
    const Vec zero = hn::Zero(d), one = broadcast(1.0F), half = broadcast(0.5F);
    const MaterialVectors& material = material_at<Springs::kSmooth>(material_.vectors(), s, m_.voxel_size);
    const Vec w = s.depth;
    const Mask inside = w > zero;
    const Vec phi = hn::IfThenElseZero(inside, old_fill);
    const Vec half_advance = s.rate * broadcast(0.5F * m_.duration);
    const Vec stiff_depth = material.stiffness * w;
    Vec damped = one;
    if (damped_) damped = hn::Max(zero, hn::MulAdd(material.damping, s.felt_rate, one));

    // Stored energy k phi (w -+ advance/2)^2 / 2 at the beginning and the end, in terms that both share.
    const Vec spring = stiff_depth * phi;
    const Vec stiff_advance = material.stiffness * phi * half_advance;
    sums.twice_middle = hn::MulAdd(spring, w, hn::MulAdd(stiff_advance, half_advance, sums.twice_middle));
    sums.elastic_change = hn::MulAdd(spring, half_advance, sums.elastic_change);

    Vec mean_fill = phi, gone = zero;
    if constexpr (kMode == Mode::standing) {
      const Vec normal = normal_force(sums, spring, damped, half_advance);
      sums.add_normal(r, s, normal, Springs::kCentral);
      if (friction_ != nullptr) add_friction(first, normal, phi, r, s);
    } else {
      const Vec kappa = material.cutting_ratio;
      Mask is_cut = hn::MaskFromVec(zero);
      if (kMode == Mode::cutting && may_cut_) {
        Vec work = kappa * stiff_depth * s.slip_path;  // [J/m^3] tangential, per filled volume
        if (damped_) work = work * damped;
        Vec u = material.energy, least = material.cutting_depth;
        if (m_.tooth_rate > 0) {
          const ChordVectors chord = chord_of_point(material, m_, work, w, phi, s.rate);
          u = chord.energy, least = chord.cut.least;
        }
        is_cut = w > least;
        work = hn::IfThenElseZero(is_cut, work);
        Vec price = u, exponent;
        if (release_)
          price = hn::Max(hn::NegMulAdd(half * stiff_depth, w, u), u * broadcast(FoundationLaw::kLeastEnergyShare));
        exponent = release_ || m_.tooth_rate > 0 ? work / price : work * material.inverse_energy;
        exponent = hn::Min(exponent, broadcast(FoundationLaw::kLargestExponent));
        mean_fill = phi * mean_of_decay(exponent);
        gone = mean_fill * exponent;
        Vec left = phi - gone;
        const Mask finished = hn::And(hn::And(inside, exponent > zero), left < broadcast(kSmallestFill));
        if (!hn::AllFalse(d, finished)) {
          const Vec credit = hn::IfThenElseZero(finished, left);
          left = hn::IfThenZeroElse(finished, left);
          gone = gone + credit;
          sums.credited = hn::MulAdd(price, credit, sums.credited);
          mark_emptied(first, bits_of(finished));
        }
        // Elastic energy of what was removed, less what of it helped cutting (law G).
        const Vec end = w + half_advance;
        const Vec removed_stiffness = material.stiffness * gone;
        sums.twice_removed = hn::MulAdd(removed_stiffness * end, end, sums.twice_removed);
        if (release_) sums.helped = hn::MulAdd(u - price, gone, sums.helped);
        if (m_.tooth_rate > 0) sums.chips = hn::MulAdd(u - material.energy, gone, sums.chips);
        book_removed(gone, first, inside);
        hn::Store(hn::IfThenElse(inside, left, old_fill), d, voxels_.fill_after + first);
      }
      const Vec spring_left = stiff_depth * mean_fill;
      if constexpr (kMode == Mode::cutting) {
        sums.lag = hn::MulAdd(spring - spring_left, half_advance, sums.lag);
        sums.pressed = sums.pressed + scaled<Springs::kSmooth>(s, spring_left);
      }
      const Vec normal = normal_force(sums, spring_left, damped, half_advance);
      const Vec rubbed = kappa * normal, tangential = rubbed * s.inverse_slip;
      // Along the normal and, of the surface's velocity, what is not along it.
      sums.add_reaction(r, s, hn::NegMulAdd(tangential, s.closing, normal), tangential, surface_velocity(m_, r));
      const Mask rubs = hn::AndNot(is_cut, inside);
      if (!hn::AllFalse(d, rubs)) sums.rubbing = sums.rubbing + hn::IfThenElseZero(rubs, rubbed * s.slip_path);
      if (near_axis_) sums.couple = hn::MulAdd(tangential, slip_beyond_centers(m_, r, s), sums.couple);
    }
    if (implicit_) [[unlikely]] {
      if (m_.lead > 0) add_lead(sums, w, phi, mean_fill, gone, half_advance);
      if (stiffness_ != nullptr) add_stiffness(*stiffness_, material.stiffness * mean_fill, damped, r, s);
    }
    sums.fill = sums.fill + phi;
    sums.depth = hn::Max(sums.depth, w);
  }

  /// The same for parts of voxels.
  HWY_INLINE void press_parts(int first, const Vectors& r, Vec old_fill, const Sample& s, PressSums& sums) {
    if (may_crush_ && !hn::AllFalse(Floats(), s.top > material_.vectors().crushing_depth)) [[unlikely]]
      press_parts<true>(first, r, old_fill, s, sums);
    else
      press_parts<false>(first, r, old_fill, s, sums);
  }
  template <bool kCrushes>
  HWY_INLINE void press_parts(int first, const Vectors& r, Vec old_fill, const Sample& s, PressSums& sums) {
    const Floats d;
    const Vec zero = hn::Zero(d), half = broadcast(0.5F);
    const Mask inside = s.top > zero;
    const Vec fill = hn::IfThenElseZero(inside, old_fill), advance = s.rate * broadcast(m_.duration);
    const MaterialVectors& material = material_at<Springs::kSmooth>(material_.vectors(), s, m_.voxel_size);
    const Vec damped =
        damped_ ? hn::Max(zero, hn::MulAdd(material.damping, s.felt_rate, broadcast(1.0F))) : broadcast(1.0F);
    const PressedParts p = press_parts_of<kCrushes>(m_, material, s, fill, damped, may_cut_, release_);
    if (kCrushes || writes()) {
      const Mask finished = p.credit > zero;
      if (!hn::AllFalse(d, finished)) {
        sums.credited = hn::MulAdd(p.price, p.credit, sums.credited);
        mark_emptied(first, bits_of(finished));
      }
      const Vec cut = p.kept - p.left;
      if (release_) sums.helped = hn::MulAdd(p.energy - p.price, cut, sums.helped);
      if (m_.tooth_rate > 0) sums.chips = hn::MulAdd(p.energy - material.energy, cut, sums.chips);
      if constexpr (kCrushes) {
        sums.chips = hn::NegMulAdd(material.energy, fill - p.kept, sums.chips);
        // Less what of it helped cutting, which is booked there.
        const Vec taken = release_ ? hn::NegMulAdd(p.energy - p.price, cut, p.released) : p.released;
        sums.crushed = sums.crushed + hn::IfThenElseZero(p.crushed, taken);
      }
      book_removed(fill - p.left, first, inside);
      hn::Store(hn::IfThenElse(inside, p.left, old_fill), d, voxels_.fill_after + first);
    }
    const Vec spring = p.rubbing + p.cut, normal = spring * damped;
    const Vec kappa = m_.spin == 0 ? zero : material.cutting_ratio;
    const Vec tangential = kappa * normal * s.inverse_slip;
    sums.add_reaction(r, s, hn::NegMulAdd(tangential, s.closing, normal), tangential, surface_velocity(m_, r));
    sums.rubbing = hn::MulAdd(kappa * p.rubbing * damped, s.slip_path, sums.rubbing);
    if (near_axis_) sums.couple = hn::MulAdd(tangential, slip_beyond_centers(m_, r, s), sums.couple);
    sums.pressed = sums.pressed + scaled<Springs::kSmooth>(s, spring);

    sums.twice_middle = sums.twice_middle + (p.before + p.after);
    sums.elastic_change = hn::MulAdd(half, p.after - p.before, sums.elastic_change);
    sums.lag = hn::NegMulAdd(half, p.released, sums.lag);
    sums.damping = sums.damping + hn::MulAdd(normal - spring, advance, p.lead_work);
    if (stiffness_ != nullptr) [[unlikely]]
      add_springs(m_, p.slope(material, damped, m_.duration), normal, kappa, r, s, *stiffness_);
    if (friction_ != nullptr) add_friction(first, normal, p.volume, r, s);
    sums.fill = sums.fill + p.volume;
    sums.depth = hn::Max(sums.depth, p.top);
  }

  HWY_INLINE void add_friction(int first, Vec normal, Vec filled, const Vectors& r, const Sample& s) {
    const FrictionConstants constants(job_.materials, [&](int lane) HWY_ATTR {
      return material_.one() != kEmpty ? material_.one() : material_of(first + lane);
    });
    // Copies, so that the ones in the loop need no address.
    const Vectors place = r;
    const Vec shorter =
        Springs::kSmooth ? hn::IfThenElse(s.on_smooth(), broadcast(1 / kBeta), broadcast(1.0F)) : broadcast(1.0F);
    const Vec radial = s.radial * shorter, axial = s.axial * shorter;
    normal = scaled<Springs::kSmooth>(s, normal);
    filled = scaled<Springs::kSmooth>(s, scaled<Springs::kSmooth>(s, filled));
    friction_->add(normal, filled, constants, place, radial, axial);
  }

  /// The energies of a sub-step whose contact is evaluated after its middle: corrects the sums from the depth w there
  /// to that in the middle, and books what the springs push harder than what they store as a damper's work. Those that
  /// were not touched at the beginning stored nothing there.
  HWY_INLINE void add_lead(PressSums& sums, Vec w, Vec fill, Vec mean_fill, Vec removed, Vec half_advance) const {
    const Vec stiffness = material_.vectors().stiffness, zero = hn::Zero(Floats());
    const Vec lead = broadcast(2 * m_.lead) * half_advance, middle = w - lead;
    const Vec squares = stiffness * hn::MulSub(middle, middle, w * w);  // twice the energy, from here
    const Vec product = hn::Neg(stiffness * (lead * half_advance));
    const Vec not_yet = hn::Max(zero, half_advance - middle);
    const Vec before_touch = stiffness * fill * (not_yet * not_yet);
    const Vec half_before = broadcast(0.5F) * before_touch;
    sums.twice_middle = sums.twice_middle + hn::MulSub(squares, fill, half_before);
    sums.elastic_change = sums.elastic_change + hn::MulAdd(product, fill, broadcast(0.5F) * half_before);
    sums.twice_removed = hn::MulAdd(removed, squares + (product + product), sums.twice_removed);
    sums.lag = hn::MulAdd(product, fill - mean_fill, sums.lag);
    const Vec pushed = stiffness * mean_fill * ((lead + lead) * half_advance);
    sums.damping = sums.damping + (pushed - half_before);
  }

  HWY_INLINE void add_stiffness(StiffnessVectors& sums, Vec spring, Vec damped, const Vectors& r, const Sample& s) {
    const MaterialVectors& material = material_at<Springs::kSmooth>(material_.vectors(), s, m_.voxel_size);
    const Vec kappa = m_.spin == 0 ? broadcast(0.0F) : material.cutting_ratio, normal = spring * s.depth * damped;
    if (damped_) {
      const Vec damper = material.damping * s.depth * broadcast(1.0F / m_.duration);
      spring = spring * hn::IfThenElseZero(damped > hn::Zero(Floats()), damped + damper);
    }
    add_springs(m_, spring, normal, kappa, r, s, sums);
  }
  /// [N/m^3] of filled and empty volume alike, from that of the springs; books what the damping takes.
  HWY_INLINE Vec normal_force(PressSums& sums, Vec spring, Vec damped, Vec half_advance) {
    if (!damped_) return spring;
    const Vec normal = spring * damped;
    sums.damping = hn::MulAdd(normal - spring, half_advance + half_advance, sums.damping);
    return normal;
  }

  const Springs& springs_;
  const Gather<Springs> gather_;
  const ContactJob& job_;
  const HeadMotion& m_;
  SampleList& samples_;
  StiffnessVectors* const stiffness_;  // null: not wanted
  FrictionVectors* const friction_;    // likewise
  const bool damped_, release_, implicit_;
  const Eigen::Matrix3f axes_;  // of the grid, in T
  // Of the voxels listed:
  bool may_write_ = true, may_cut_ = true, may_crush_ = false;
  bool near_axis_ = false;  // some of them are near the spindle's axis
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
