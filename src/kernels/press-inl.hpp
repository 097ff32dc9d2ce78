// SPDX-License-Identifier: Apache-2.0
// FoundationLaw on one block, from its voxels to the sums, in vectors; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_INL_HPP
#endif

#include "hapticut/force/laws/foundation.hpp"
#include "kernels/springs-inl.hpp"
#include "kernels/stiffness-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

enum class Mode { standing, rubbing, cutting };  // spindle stands; turns with removal off; turns and cuts

/// Running sums of one vector of lanes over the strips of a block.
struct PressSums {
  Vec force_x, force_y, force_z, torque_x, torque_y, torque_z;
  Vec elastic_middle, elastic_change, taken_elastic, lag, helped, damping, rubbing, credited, couple, fill, depth;

  HWY_INLINE PressSums() {
    const Vec zero = broadcast(0.0F);
    force_x = force_y = force_z = torque_x = torque_y = torque_z = zero;
    elastic_middle = elastic_change = taken_elastic = lag = helped = zero;
    damping = rubbing = credited = couple = fill = depth = zero;
  }
  HWY_INLINE void add_reaction(const Vectors& r, const Vectors& g) {
    force_x = hn::Add(force_x, g.x);
    force_y = hn::Add(force_y, g.y);
    force_z = hn::Add(force_z, g.z);
    torque_x = hn::MulAdd(r.y, g.z, hn::NegMulAdd(r.z, g.y, torque_x));
    torque_y = hn::MulAdd(r.z, g.x, hn::NegMulAdd(r.x, g.z, torque_y));
    torque_z = hn::MulAdd(r.x, g.y, hn::NegMulAdd(r.y, g.x, torque_z));
  }
};

/// The strips of a few blocks one after the other, in those lanes that share a vector: `part * kWidth ...`.
template <class Springs, Mode kMode>
class Press {
 public:
  HWY_INLINE Press(const Springs& springs, const ContactJob& job, const StripOffsets& offsets, std::size_t part,
                   ContactSums& totals, StiffnessSums* stiffness_totals)
      : springs_(springs),
        job_(job),
        m_(job.motion),
        offsets_(offsets),
        totals_(totals),
        stiffness_totals_(stiffness_totals),
        part_(part),
        damped_(job.damped),
        release_(m_.removal == RemovalLaw::elastic_release),
        implicit_(m_.lead > 0 || stiffness_totals != nullptr),
        material_(job.materials[kEmpty]),
        steps_(job.grid.voxel_steps.template cast<float>()),
        stiffness_(stiffness_totals != nullptr) {
    const Floats d;
    const Vec lane = hn::Iota(d, float(part * kWidth));
    const Vec j = hn::IfThenElseZero(hn::Ge(lane, broadcast(8.0F)), broadcast(1.0F));
    const Vec k = hn::NegMulAdd(j, broadcast(8.0F), lane);
    const auto offset = [&](int axis) HWY_ATTR {
      return hn::MulAdd(j, broadcast(steps_(axis, 1)), hn::Mul(k, broadcast(steps_(axis, 2))));
    };
    lane_offsets_ = {offset(0), offset(1), offset(2)};
    taken_ = hn::Zero(d);
  }

  HWY_INLINE void press_block(PressTask& task) {
    const BlockView& block = task.block;
    const Eigen::Vector3f base = job_.grid.position(block.origin).template cast<float>();
    lanes_ = {hn::Add(lane_offsets_.x, broadcast(base.x())), hn::Add(lane_offsets_.y, broadcast(base.y())),
              hn::Add(lane_offsets_.z, broadcast(base.z()))};
    if (block.material == nullptr) take_material(block.uniform_material);
    // The zone about the spindle's axis where a voxel cuts by its mean slip may reach into this block.
    if constexpr (kMode != Mode::standing) {
      const Eigen::Vector3f middle = base + steps_ * Eigen::Vector3f::Constant(3.5F);
      near_axis_ = middle.head<2>().squaredNorm() < 56.25F * m_.voxel_size * m_.voxel_size;
    }
    const bool at_centroid = block.centroid != nullptr && job_.quadrature == Quadrature::centroid;
    for (int slab = 0; slab < kBlockEdge; ++slab) {
      const std::uint64_t solid = block.solid == nullptr ? ~std::uint64_t(0) : block.solid[slab];
      if (solid == 0) continue;
      for (int strip = 0; strip < kStripsPerSlab; ++strip) {
        const auto bits = unsigned(solid >> (kStripLanes * strip + int(part_ * kWidth))) & kAllLanes;
        if (job_.level_of_detail > 1 && !job_.has_turn(block.origin, slab, strip)) continue;
        if (bits != 0) press_strip(task, slab * kStripsPerSlab + strip, bits, at_centroid);
      }
    }
  }

  /// Adds the sums of these blocks to those of the sub-step, in double precision.
  HWY_INLINE void flush() {
    flush_taken();
    const auto add = [&](ContactSums::Term term, Vec sum) HWY_ATTR {
      alignas(64) float lanes[kWidth];
      hn::Store(sum, Floats(), lanes);
      double* total = &totals_.lanes[term][part_ * kWidth];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    };
    add(ContactSums::kForceX, sums_.force_x);
    add(ContactSums::kForceY, sums_.force_y);
    add(ContactSums::kForceZ, sums_.force_z);
    add(ContactSums::kTorqueX, sums_.torque_x);
    add(ContactSums::kTorqueY, sums_.torque_y);
    add(ContactSums::kTorqueZ, sums_.torque_z);
    add(ContactSums::kElasticMiddle, sums_.elastic_middle);
    add(ContactSums::kElasticChange, sums_.elastic_change);
    add(ContactSums::kFill, sums_.fill);
    if (damped_ || m_.lead > 0) add(ContactSums::kDamping, sums_.damping);
    if constexpr (kMode != Mode::standing) {
      add(ContactSums::kRubbing, sums_.rubbing);
      add(ContactSums::kCouple, sums_.couple);
    }
    if constexpr (kMode == Mode::cutting) {
      add(ContactSums::kTakenElastic, sums_.taken_elastic);
      add(ContactSums::kLag, sums_.lag);
      if (release_) add(ContactSums::kHelped, sums_.helped);
      add(ContactSums::kCredited, sums_.credited);
    }
    totals_.depth = std::max(totals_.depth, hn::GetLane(hn::MaxOfLanes(Floats(), sums_.depth)));
    if (stiffness_totals_ != nullptr) stiffness_.flush(part_, *stiffness_totals_);
  }

 private:
  /// @param solid  bits of the lanes that are not empty
  HWY_INLINE void press_strip(PressTask& task, int strip, unsigned solid, bool at_centroid) {
    const Floats d;
    const Vec zero = hn::Zero(d), one = broadcast(1.0F), half = broadcast(0.5F);
    const BlockView& block = task.block;
    const int voxel = strip * kStripLanes + int(part_ * kWidth);

    // Stage sample_contact.
    Vectors r = {hn::Add(lanes_.x, broadcast(offsets_.x[strip])), hn::Add(lanes_.y, broadcast(offsets_.y[strip])),
                 hn::Add(lanes_.z, broadcast(offsets_.z[strip]))};
    if (at_centroid) shift_to_centroids(block.centroid + voxel, r);
    if (springs_.misses(r.x, r.y, r.z)) return;
    const SpringVectors<Vec> spring = springs_.at(r.x, r.y, r.z);
    Mask inside = hn::Gt(spring.depth, zero);
    if (solid != kAllLanes) inside = hn::And(inside, mask_of(solid));
    if (hn::AllFalse(d, inside)) return;
    totals_.voxels += int(hn::CountTrue(d, inside));
    const Vectors n = {spring.normal_x, spring.normal_y, spring.normal_z};
    const Vec w = hn::IfThenElseZero(inside, spring.depth);
    const Vec old_fill = block.fill == nullptr ? one : hn::LoadU(d, block.fill + voxel);
    const Vec phi = hn::IfThenElseZero(inside, old_fill);
    if (block.material != nullptr) take_materials(block.material + voxel, inside);
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
    sums_.elastic_middle = hn::MulAdd(hn::Mul(half_stiffness, squares), phi, sums_.elastic_middle);
    sums_.elastic_change = hn::MulAdd(pressed, phi, sums_.elastic_change);
    Vectors reaction = n;

    if constexpr (kMode == Mode::standing) {
      const Vec normal = normal_force(stiff_depth, phi, damped, advance);
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
          sums_.credited = hn::MulAdd(price, credit, sums_.credited);
          task.change.any_emptied = true;
          task.change.emptied[std::size_t(voxel >> 6)] |= bits_of(finished) << (voxel & 63);
        }
        // Elastic energy of what was taken, less what of it helped cutting (law G).
        const Vec half_taken = hn::Mul(half_stiffness, taken);
        sums_.taken_elastic = hn::MulAdd(half_taken, hn::Add(squares, product), sums_.taken_elastic);
        sums_.lag = hn::MulAdd(pressed, hn::Sub(phi, mean_fill), sums_.lag);
        if (release_) sums_.helped = hn::MulAdd(hn::Sub(u, price), taken, sums_.helped);

        gone = taken;
        take(taken, block, voxel, inside);
        if (kParts > 1 && task.fill_after != block.fill) begin_strip(task, strip);
        const Vec kept = solid == kAllLanes ? old_fill : hn::IfThenElseZero(mask_of(solid), old_fill);
        hn::StoreU(hn::IfThenElse(inside, left, kept), d, task.fill_after + voxel);
        task.change.strips |= 1U << strip;
      }
      const Vec normal = normal_force(stiff_depth, mean_fill, damped, advance);
      const Vec tangential = hn::Mul(kappa, hn::Mul(normal, inverse_slip));
      reaction = {hn::MulAdd(normal, n.x, hn::Mul(tangential, t.x)), hn::MulAdd(normal, n.y, hn::Mul(tangential, t.y)),
                  hn::MulAdd(normal, n.z, hn::Mul(tangential, t.z))};
      const Mask rubs = hn::AndNot(is_cut, inside);
      if (!hn::AllFalse(d, rubs)) {
        const Vec rubbed = hn::Mul(hn::Mul(kappa, normal), slip_path);
        sums_.rubbing = hn::Add(sums_.rubbing, hn::IfThenElseZero(rubs, rubbed));
      }
      if (near_axis_) sums_.couple = hn::MulAdd(tangential, extra, sums_.couple);
    }

    if (implicit_) [[unlikely]] {
      if (m_.lead > 0) add_lead(half_stiffness, w, phi, mean_fill, gone, advance);
      if (stiffness_totals_ != nullptr) add_stiffness(hn::Mul(material.stiffness, mean_fill), w, damped, r, n);
    }

    // Stage sum_resultant.
    sums_.add_reaction(r, reaction);
    sums_.fill = hn::Add(sums_.fill, phi);
    sums_.depth = hn::Max(sums_.depth, w);
  }

  /// A strip that is written for the first time, in parts: those that the head does not reach keep their fills.
  HWY_INLINE static void begin_strip(PressTask& task, int strip) {
    if ((task.change.strips >> strip & 1U) != 0) return;
    for (int voxel = strip * kStripLanes; voxel < (strip + 1) * kStripLanes; ++voxel)
      task.fill_after[voxel] = task.block.fill_of(voxel);
  }

  /// The energies of a sub-step whose contact is evaluated after its middle: corrects the sums from the depth w there
  /// to that in the middle, and books what the springs push harder than what they store as a damper's work. Those that
  /// were not touched at the beginning stored nothing there.
  HWY_INLINE void add_lead(Vec half_stiffness, Vec w, Vec fill, Vec mean_fill, Vec taken, Vec advance) {
    const Vec half = broadcast(0.5F), lead = hn::Mul(broadcast(m_.lead), advance);
    const Vec middle = hn::Sub(w, lead);
    const Vec squares = hn::Mul(half_stiffness, hn::MulSub(middle, middle, hn::Mul(w, w)));
    const Vec product = hn::Mul(half_stiffness, hn::Mul(hn::Neg(lead), advance));
    const Vec not_yet = hn::Max(hn::Zero(Floats()), hn::MulSub(half, advance, middle));
    const Vec before_touch = hn::Mul(hn::Mul(half_stiffness, fill), hn::Mul(not_yet, not_yet));
    const Vec half_before = hn::Mul(half, before_touch);
    sums_.elastic_middle = hn::Add(sums_.elastic_middle, hn::MulSub(squares, fill, half_before));
    sums_.elastic_change = hn::Add(sums_.elastic_change, hn::MulAdd(product, fill, half_before));
    sums_.taken_elastic = hn::MulAdd(taken, hn::Add(squares, product), sums_.taken_elastic);
    sums_.lag = hn::MulAdd(product, hn::Sub(fill, mean_fill), sums_.lag);
    const Vec pushed = hn::Mul(hn::Mul(half_stiffness, mean_fill), hn::Mul(hn::Add(lead, lead), advance));
    sums_.damping = hn::Add(sums_.damping, hn::Sub(pushed, before_touch));
  }

  HWY_INLINE void add_stiffness(Vec spring, Vec w, Vec damped, const Vectors& r, const Vectors& n) {
    if (damped_) {
      const Vec damper = hn::Mul(hn::Mul(material_.damping, w), broadcast(1.0F / m_.duration));
      const Vec slope = hn::IfThenElseZero(hn::Gt(damped, hn::Zero(Floats())), hn::Add(damped, damper));
      spring = hn::Mul(spring, slope);
    }
    stiffness_.add(spring, r, n);
  }

  /// [N/m^3] of filled and empty volume alike; books what the damping takes.
  HWY_INLINE Vec normal_force(Vec stiff_depth, Vec fill, Vec damped, Vec advance) {
    const Vec spring = hn::Mul(stiff_depth, fill);
    if (!damped_) return spring;
    const Vec normal = hn::Mul(spring, damped);
    sums_.damping = hn::MulAdd(hn::Sub(normal, spring), advance, sums_.damping);
    return normal;
  }

  HWY_INLINE void shift_to_centroids(const std::int32_t* centroids, Vectors& r) const {
    const hn::RebindToSigned<Floats> ints;
    const auto packed = hn::LoadU(ints, centroids);
    if (hn::AllTrue(ints, hn::Eq(packed, hn::Zero(ints)))) return;
    const Vec di = centroid_component<0>(packed), dj = centroid_component<10>(packed),
              dk = centroid_component<20>(packed);
    const auto shifted = [&](Vec p, int axis) HWY_ATTR {
      return hn::MulAdd(di, broadcast(steps_(axis, 0)),
                        hn::MulAdd(dj, broadcast(steps_(axis, 1)), hn::MulAdd(dk, broadcast(steps_(axis, 2)), p)));
    };
    r = {shifted(r.x, 0), shifted(r.y, 1), shifted(r.z, 2)};
  }

  /// Loads the constants of a material, unless they are those of the strip before.
  HWY_INLINE void take_material(MaterialId one) {
    if (one == material_id_) return;
    flush_taken();
    material_id_ = one;
    material_ = MaterialVectors(job_.materials[one]);
  }
  HWY_INLINE void take_materials(const MaterialId* ids, Mask inside) {
    if (material_id_ != kEmpty && all_are(ids, material_id_)) return;
    std::uint64_t lanes = bits_of(inside);
    const MaterialId one = ids[std::countr_zero(lanes)];
    bool uniform = true;
    for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) uniform &= ids[std::countr_zero(lanes)] == one;
    if (uniform) return take_material(one);
    flush_taken();
    material_id_ = kEmpty;
    material_ = MaterialVectors(job_.materials, ids);
  }
  /// Books what went, by material.
  HWY_INLINE void take(Vec taken, const BlockView& block, int voxel, Mask inside) {
    if (material_id_ != kEmpty) {
      taken_ = hn::Add(taken_, taken);
      return;
    }
    alignas(64) float lanes[kWidth];
    hn::Store(taken, Floats(), lanes);
    for (std::uint64_t bits = bits_of(inside); bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      totals_.taken[block.material[voxel + lane]] += double(lanes[lane]);
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
  const ContactJob& job_;
  const HeadMotion& m_;
  const StripOffsets& offsets_;
  ContactSums& totals_;
  StiffnessSums* const stiffness_totals_;  // null: not wanted
  const std::size_t part_;
  const bool damped_, release_, implicit_;
  bool near_axis_ = false;
  MaterialVectors material_;
  MaterialId material_id_ = kEmpty;  // kEmpty: the lanes of material_ differ
  const Eigen::Matrix3f steps_;
  Vectors lane_offsets_;  // [m] of the lanes of a strip, from the strip's first voxel
  Vectors lanes_;         // [m] of the lanes of the block's first strip, in T
  Vec taken_;             // [voxels] of material_id_
  PressSums sums_;
  StiffnessVectors stiffness_;
};

template <class Springs, Mode kMode>
HWY_INLINE void PressParts(const Springs& springs, const ContactJob& job, const StripOffsets& offsets,
                           std::span<PressTask> tasks, ContactSums& sums, StiffnessSums* stiffness) {
  for (std::size_t part = 0; part < kParts; ++part) {
    Press<Springs, kMode> press(springs, job, offsets, part, sums, stiffness);
    for (PressTask& task : tasks) press.press_block(task);
    press.flush();
  }
}

}  // namespace strips

inline HWY_ATTR void PressBlocks(const ContactJob& job, std::span<PressTask> tasks, ContactSums& sums,
                                 StiffnessSums* stiffness) {
  using strips::Mode;
  const strips::StripOffsets offsets(job.grid.voxel_steps.cast<float>());
  visit_springs(job.head, [&](const auto& springs) HWY_ATTR {
    using Springs = std::decay_t<decltype(springs)>;
    if (job.motion.spin == 0)
      return strips::PressParts<Springs, Mode::standing>(springs, job, offsets, tasks, sums, stiffness);
    if (job.motion.removal == RemovalLaw::none)
      return strips::PressParts<Springs, Mode::rubbing>(springs, job, offsets, tasks, sums, stiffness);
    return strips::PressParts<Springs, Mode::cutting>(springs, job, offsets, tasks, sums, stiffness);
  });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
