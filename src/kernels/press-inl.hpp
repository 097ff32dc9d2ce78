// SPDX-License-Identifier: Apache-2.0
// FoundationLaw on one block, from its voxels to the sums, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/gather-inl.hpp"
#include "kernels/press_sums-inl.hpp"
#include "kernels/stiffness-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// A few blocks one after the other. In vectors of sixteen, and on the long way of a turning head, the voxels inside
/// the head are gathered first, so that no lane computes for nothing; in shorter ones, or on the short way of a
/// standing head, gathering would cost more than the empty lanes do (measured: decision 4).
template <class Springs, Mode kMode>
class Press {
  static constexpr bool kGathers = kMode != Mode::standing && kWidth == kStripLanes;

 public:
  /// @param voxels  room for those of one block
  HWY_INLINE Press(const Springs& springs, const ContactJob& job, VoxelList& voxels, ContactSums& totals,
                   StiffnessVectors* stiffness)
      : springs_(springs),
        gather_(springs, job),
        job_(job),
        m_(job.motion),
        voxels_(voxels),
        totals_(totals),
        stiffness_(stiffness),
        damped_(job.damped),
        release_(m_.removal == RemovalLaw::elastic_release),
        implicit_(m_.lead > 0 || stiffness != nullptr),
        material_(job.materials[kEmpty]),
        taken_(broadcast(0.0F)) {}

  HWY_INLINE void press_block(PressTask& task) {
    if constexpr (kMode != Mode::standing) near_axis_ = gather_.near_axis(task.block);
    PressSums sums[kParts];  // close at hand in the loop
    if constexpr (kGathers)
      press_gathered(task, sums);
    else
      press_where_they_are(task, sums);
    for (std::size_t part = 0; part < kParts; ++part) sums_[part].add(sums[part]);
  }

  /// Adds the sums of these blocks to those of the sub-step, in double precision.
  HWY_INLINE void flush() {
    flush_taken();
    for (std::size_t part = 0; part < kParts; ++part)
      sums_[part].template flush<kMode>(part, damped_ || m_.lead > 0, totals_);
  }

 private:
  HWY_INLINE void press_where_they_are(PressTask& task, PressSums (&sums)[kParts]) {
    const BlockView& block = task.block;
    if (block.material == nullptr) take_material(block.uniform_material);
    gather_.for_each(
        block, [&](int voxel, const Vectors& r, Mask hit, unsigned lanes) HWY_ATTR __attribute__((always_inline)) {
          if (block.material != nullptr) take_materials(block.material + voxel, lanes);
          const Vec fill = block.fill == nullptr ? broadcast(1.0F) : hn::LoadU(Floats(), block.fill + voxel);
          const std::size_t part = std::size_t(voxel) / kWidth % kParts;
          press_voxels(task, voxel, part, r, fill, hit, sums[part]);
        });
  }

  HWY_INLINE void press_gathered(PressTask& task, PressSums (&sums)[kParts]) {
    const Floats d;
    const BlockView& block = task.block;
    gather_.list(block, voxels_);
    if (voxels_.count == 0) return;
    if (voxels_.material != kEmpty) take_material(voxels_.material);
    for (int first = 0; first < voxels_.count; first += kStripLanes) {
      if (voxels_.material == kEmpty) take_listed_materials(block.material, first);
      const Vectors r = {hn::Load(d, voxels_.x + first), hn::Load(d, voxels_.y + first),
                         hn::Load(d, voxels_.z + first)};
      const Vec fill = block.fill == nullptr ? broadcast(1.0F) : hn::Load(d, voxels_.fill + first);
      const Mask listed = hn::FirstN(d, std::size_t(std::min(voxels_.count - first, kStripLanes)));
      press_voxels(task, first, 0, r, fill, listed, sums[0]);
    }
    if (kMode == Mode::cutting && task.may_cut) write_fills(task);
  }

  /// @param first   of the list, or of the block where there is none
  /// @param listed  the lanes that count, if they are inside the head
  HWY_INLINE void press_voxels(PressTask& task, int first, std::size_t part, const Vectors& r, Vec old_fill,
                               Mask listed, PressSums& sums) {
    const Floats d;
    const Vec zero = hn::Zero(d), one = broadcast(1.0F), half = broadcast(0.5F);
    const BlockView& block = task.block;

    // Stage sample_contact.
    const SpringVectors<Vec> spring = springs_.at(r.x, r.y, r.z);
    const Mask inside = hn::And(hn::Gt(spring.depth, zero), listed);
    totals_.voxels += int(hn::CountTrue(d, inside));
    const Vectors n = {spring.normal_x, spring.normal_y, spring.normal_z};
    const Vec w = hn::IfThenElseZero(inside, spring.depth);
    const Vec phi = hn::IfThenElseZero(inside, old_fill);
    const MaterialVectors& material = material_;

    // Stage evaluate_law.
    const Vec dt = broadcast(m_.duration);
    const Vectors p = velocity_at(r, m_.velocity, m_.angular_velocity);
    const Vec w_dot = dot(p, n);
    const Vec advance = hn::Mul(w_dot, dt);
    const Vec stiff_depth = hn::Mul(material.stiffness, w);
    Vec damped = one;
    if (damped_) {
      const Vec felt = dot(velocity_at(r, m_.felt_velocity, m_.felt_angular_velocity), n);
      damped = hn::Max(zero, hn::MulAdd(material.damping, felt, one));
    }
    Vec mean_fill = phi, gone = zero;

    // Stored energy k phi (w -+ advance/2)^2 / 2 at the beginning and the end, in terms that both share.
    const Vec half_stiffness = hn::Mul(half, material.stiffness);
    const Vec squares = hn::MulAdd(w, w, hn::Mul(broadcast(0.25F), hn::Mul(advance, advance)));
    const Vec product = hn::Mul(w, advance);
    const Vec pressed = hn::Mul(half_stiffness, product);
    sums.elastic_middle = hn::MulAdd(hn::Mul(half_stiffness, squares), phi, sums.elastic_middle);
    sums.elastic_change = hn::MulAdd(pressed, phi, sums.elastic_change);
    Vectors reaction = n;

    if constexpr (kMode == Mode::standing) {
      const Vec normal = normal_force(sums, stiff_depth, phi, damped, advance);
      reaction = {hn::Mul(normal, n.x), hn::Mul(normal, n.y), hn::Mul(normal, n.z)};
    } else {
      const Vec spin = broadcast(m_.spin), kappa = material.cutting_ratio;
      const Vectors t = {hn::NegMulAdd(spin, r.y, hn::NegMulAdd(w_dot, n.x, p.x)),
                         hn::MulAdd(spin, r.x, hn::NegMulAdd(w_dot, n.y, p.y)), hn::NegMulAdd(w_dot, n.z, p.z)};
      Vec slip_squared = dot(t, t), extra = zero;
      if (near_axis_) {
        const Vec rho_squared = hn::MulAdd(r.x, r.x, hn::Mul(r.y, r.y));
        const Vec zone = hn::Max(zero, hn::NegMulAdd(rho_squared, broadcast(FoundationLaw::axis_zone_factor(m_)), one));
        extra = hn::Mul(broadcast(FoundationLaw::axis_slip_squared(m_)), hn::Mul(zone, zone));
        slip_squared = hn::Add(slip_squared, extra);
      }
      constexpr float kRegular = FoundationLaw::kSlipRegularization * FoundationLaw::kSlipRegularization;
      const Vec inverse_slip = hn::Div(one, hn::Sqrt(hn::Add(slip_squared, broadcast(kRegular))));
      const Vec slip_path = hn::Mul(hn::Mul(slip_squared, inverse_slip), broadcast(m_.duration * m_.turns));  // [m]

      Mask is_cut = hn::MaskFromVec(zero);
      if (kMode == Mode::cutting && task.may_cut) {
        is_cut = hn::Gt(w, material.cutting_depth);
        Vec work = hn::Mul(hn::Mul(kappa, stiff_depth), slip_path);  // [J/m^3] tangential, per filled volume
        if (damped_) work = hn::Mul(work, damped);
        work = hn::IfThenElseZero(is_cut, work);
        const Vec u = material.energy;
        Vec price = u, exponent;
        if (release_) {
          const Vec stored = hn::Mul(hn::Mul(half, stiff_depth), w);
          price = hn::Max(hn::Sub(u, stored), hn::Mul(u, broadcast(FoundationLaw::kLeastEnergyShare)));
          exponent = hn::Div(work, price);
        } else {
          exponent = hn::Mul(work, material.inverse_energy);
        }
        exponent = hn::Min(exponent, broadcast(FoundationLaw::kLargestExponent));
        mean_fill = hn::Mul(phi, mean_of_decay(exponent));
        Vec taken = hn::Mul(mean_fill, exponent);
        Vec left = hn::Sub(phi, taken);
        const Mask finished = hn::And(hn::And(inside, hn::Gt(exponent, zero)), hn::Lt(left, broadcast(kSmallestFill)));
        if (!hn::AllFalse(d, finished)) {
          const Vec credit = hn::IfThenElseZero(finished, left);
          left = hn::IfThenZeroElse(finished, left);
          taken = hn::Add(taken, credit);
          sums.credited = hn::MulAdd(price, credit, sums.credited);
          task.change.any_emptied = true;
          for (unsigned bits = bits_of(finished); bits != 0; bits &= bits - 1) {
            const int voxel = voxel_at(first + std::countr_zero(bits));
            task.change.emptied[std::size_t(voxel >> 6)] |= std::uint64_t(1) << (voxel & 63);
          }
        }
        // Elastic energy of what was taken, less what of it helped cutting (law G).
        const Vec half_taken = hn::Mul(half_stiffness, taken);
        sums.taken_elastic = hn::MulAdd(half_taken, hn::Add(squares, product), sums.taken_elastic);
        sums.lag = hn::MulAdd(pressed, hn::Sub(phi, mean_fill), sums.lag);
        if (release_) sums.helped = hn::MulAdd(hn::Sub(u, price), taken, sums.helped);

        gone = taken;
        take(taken, block, first, inside);
        if constexpr (kGathers) {
          hn::Store(hn::IfThenElse(inside, left, old_fill), d, voxels_.fill_after + first);
        } else {
          begin_strips(task, 1U << (first / kStripLanes));
          hn::BlendedStore(left, inside, d, task.fill_after + first);
        }
      }
      const Vec normal = normal_force(sums, stiff_depth, mean_fill, damped, advance);
      const Vec tangential = hn::Mul(kappa, hn::Mul(normal, inverse_slip));
      reaction = {hn::MulAdd(normal, n.x, hn::Mul(tangential, t.x)), hn::MulAdd(normal, n.y, hn::Mul(tangential, t.y)),
                  hn::MulAdd(normal, n.z, hn::Mul(tangential, t.z))};
      const Mask rubs = hn::AndNot(is_cut, inside);
      if (!hn::AllFalse(d, rubs)) {
        const Vec rubbed = hn::Mul(hn::Mul(kappa, normal), slip_path);
        sums.rubbing = hn::Add(sums.rubbing, hn::IfThenElseZero(rubs, rubbed));
      }
      if (near_axis_) sums.couple = hn::MulAdd(tangential, extra, sums.couple);
    }

    if (implicit_) [[unlikely]] {
      if (m_.lead > 0) add_lead(sums, half_stiffness, w, phi, mean_fill, gone, advance);
      if (stiffness_ != nullptr)
        add_stiffness(stiffness_[part], hn::Mul(material.stiffness, mean_fill), w, damped, r, n);
    }

    // Stage sum_resultant.
    sums.add_reaction(r, reaction);
    sums.fill = hn::Add(sums.fill, phi);
    sums.depth = hn::Max(sums.depth, w);
  }

  [[nodiscard]] HWY_INLINE int voxel_at(int place) const { return kGathers ? voxels_.index[place] : place; }

  /// Strips that are written for the first time, voxel by voxel: the others of theirs keep their fills.
  HWY_INLINE static void begin_strips(PressTask& task, std::uint32_t strips) {
    const BlockView& block = task.block;
    if (task.fill_after != block.fill)
      for (std::uint32_t begun = strips & ~task.change.strips; begun != 0; begun &= begun - 1) {
        const int first = kStripLanes * std::countr_zero(begun);
        for (int voxel = first; voxel < first + kStripLanes; ++voxel) task.fill_after[voxel] = block.fill_of(voxel);
      }
    task.change.strips |= strips;
  }

  /// What the sub-step left of the listed voxels goes back to where they came from.
  HWY_INLINE void write_fills(PressTask& task) const {
    begin_strips(task, voxels_.strips);
    const float* after = voxels_.fill_after;
    for (int n = 0; n < voxels_.runs; ++n) {
      const unsigned lanes = voxels_.run_lanes[n];
      float* to = task.fill_after + voxels_.run_first[n];
      if (lanes == kAllLanes)
        hn::StoreU(hn::LoadU(Floats(), after), Floats(), to);
      else
        spread(after, lanes, to);
      after += std::popcount(lanes);
    }
  }

  /// The energies of a sub-step whose contact is evaluated after its middle: corrects the sums from the depth w there
  /// to that in the middle, and books what the springs push harder than what they store as a damper's work. Those that
  /// were not touched at the beginning stored nothing there.
  HWY_INLINE void add_lead(PressSums& sums, Vec half_stiffness, Vec w, Vec fill, Vec mean_fill, Vec taken,
                           Vec advance) const {
    const Vec half = broadcast(0.5F), lead = hn::Mul(broadcast(m_.lead), advance);
    const Vec middle = hn::Sub(w, lead);
    const Vec squares = hn::Mul(half_stiffness, hn::MulSub(middle, middle, hn::Mul(w, w)));
    const Vec product = hn::Mul(half_stiffness, hn::Mul(hn::Neg(lead), advance));
    const Vec not_yet = hn::Max(hn::Zero(Floats()), hn::MulSub(half, advance, middle));
    const Vec before_touch = hn::Mul(hn::Mul(half_stiffness, fill), hn::Mul(not_yet, not_yet));
    const Vec half_before = hn::Mul(half, before_touch);
    sums.elastic_middle = hn::Add(sums.elastic_middle, hn::MulSub(squares, fill, half_before));
    sums.elastic_change = hn::Add(sums.elastic_change, hn::MulAdd(product, fill, half_before));
    sums.taken_elastic = hn::MulAdd(taken, hn::Add(squares, product), sums.taken_elastic);
    sums.lag = hn::MulAdd(product, hn::Sub(fill, mean_fill), sums.lag);
    const Vec pushed = hn::Mul(hn::Mul(half_stiffness, mean_fill), hn::Mul(hn::Add(lead, lead), advance));
    sums.damping = hn::Add(sums.damping, hn::Sub(pushed, before_touch));
  }

  HWY_INLINE void add_stiffness(StiffnessVectors& sums, Vec spring, Vec w, Vec damped, const Vectors& r,
                                const Vectors& n) {
    if (damped_) {
      const Vec damper = hn::Mul(hn::Mul(material_.damping, w), broadcast(1.0F / m_.duration));
      const Vec slope = hn::IfThenElseZero(hn::Gt(damped, hn::Zero(Floats())), hn::Add(damped, damper));
      spring = hn::Mul(spring, slope);
    }
    sums.add(spring, r, n);
  }

  /// [N/m^3] of filled and empty volume alike; books what the damping takes.
  HWY_INLINE Vec normal_force(PressSums& sums, Vec stiff_depth, Vec fill, Vec damped, Vec advance) {
    const Vec spring = hn::Mul(stiff_depth, fill);
    if (!damped_) return spring;
    const Vec normal = hn::Mul(spring, damped);
    sums.damping = hn::MulAdd(hn::Sub(normal, spring), advance, sums.damping);
    return normal;
  }

  /// Loads the constants of a material, unless they are those of the voxels before.
  HWY_INLINE void take_material(MaterialId one) {
    if (one == material_id_) return;
    flush_taken();
    material_id_ = one;
    material_ = MaterialVectors(job_.materials[one]);
  }
  /// @param ids  of a vector of voxels of which only some lanes count
  HWY_INLINE void take_materials(const MaterialId* ids, unsigned lanes) {
    if (material_id_ != kEmpty && all_are(ids, material_id_)) return;
    const MaterialId one = ids[std::countr_zero(lanes)];
    bool uniform = true;
    for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) uniform &= ids[std::countr_zero(lanes)] == one;
    if (uniform) return take_material(one);
    flush_taken();
    material_id_ = kEmpty;
    material_ = MaterialVectors(job_.materials, ids);
  }
  HWY_INLINE void take_listed_materials(const MaterialId* materials, int first) {
    MaterialId ids[kWidth];
    for (std::size_t lane = 0; lane < kWidth; ++lane) ids[lane] = materials[voxels_.index[std::size_t(first) + lane]];
    take_materials(ids, kAllLanes);
  }
  /// Books what went, by material.
  HWY_INLINE void take(Vec taken, const BlockView& block, int first, Mask inside) {
    if (material_id_ != kEmpty) {
      taken_ = hn::Add(taken_, taken);
      return;
    }
    alignas(64) float lanes[kWidth];
    hn::Store(taken, Floats(), lanes);
    for (unsigned bits = bits_of(inside); bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      totals_.taken[block.material[voxel_at(first + lane)]] += double(lanes[lane]);
    }
  }
  HWY_INLINE void flush_taken() {
    if constexpr (kMode == Mode::cutting) {
      alignas(64) float lanes[kWidth];
      hn::Store(taken_, Floats(), lanes);
      double sum = 0;
      for (const float lane : lanes) sum += double(lane);
      totals_.taken[material_id_] += sum;
      taken_ = hn::Zero(Floats());
    }
  }

  const Springs& springs_;
  const Gather<Springs> gather_;
  const ContactJob& job_;
  const HeadMotion& m_;
  VoxelList& voxels_;
  ContactSums& totals_;
  StiffnessVectors* const stiffness_;  // [kParts]; null: not wanted
  const bool damped_, release_, implicit_;
  bool near_axis_ = false;
  MaterialVectors material_;
  MaterialId material_id_ = kEmpty;  // kEmpty: the lanes of material_ differ
  Vec taken_;                        // [voxels] of material_id_
  PressSums sums_[kParts];
};

template <class Springs, Mode kMode>
HWY_INLINE void PressAll(const Springs& springs, const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                         StiffnessSums* stiffness) {
  VoxelList voxels;
  StiffnessVectors by_part[kParts];
  if (stiffness != nullptr)
    for (StiffnessVectors& part : by_part) part.clear();
  Press<Springs, kMode> press(springs, job, voxels, sums, stiffness == nullptr ? nullptr : by_part);
  for (PressTask& task : tasks) press.press_block(task);
  press.flush();
  if (stiffness != nullptr)
    for (std::size_t part = 0; part < kParts; ++part) by_part[part].flush(part, *stiffness);
}

}  // namespace strips

inline HWY_ATTR void PressBlocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                                 StiffnessSums* stiffness) {
  using strips::Mode;
  visit_springs(job.head, [&](const auto& springs) HWY_ATTR {
    using Springs = std::decay_t<decltype(springs)>;
    if (job.motion.spin == 0) return strips::PressAll<Springs, Mode::standing>(springs, job, tasks, sums, stiffness);
    if (job.motion.removal == RemovalLaw::none)
      return strips::PressAll<Springs, Mode::rubbing>(springs, job, tasks, sums, stiffness);
    return strips::PressAll<Springs, Mode::cutting>(springs, job, tasks, sums, stiffness);
  });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
