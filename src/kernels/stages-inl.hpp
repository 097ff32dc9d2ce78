// SPDX-License-Identifier: Apache-2.0
// The default law on the columns, stage by stage; included once per instruction set.
#if defined(HAPTICUT_KERNELS_STAGES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_STAGES_INL_HPP
#undef HAPTICUT_KERNELS_STAGES_INL_HPP
#else
#define HAPTICUT_KERNELS_STAGES_INL_HPP
#endif

#include "kernels/materials-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// FoundationLaw::evaluate and sum_resultant: the texts of the law in the same order from crushing on; the filled part
/// is collected before, and the material is looked up before the motion. Each stage is a short loop over the columns,
/// without long chains of dependent operations, and a function of its own: a compiler that inlines everything into one
/// function makes it slower. The stages do not know the head.
class Stages {
  using C = Columns;
  using Chord = formulas::ChipChord<Wide>;
  using Surface = formulas::SurfaceMotion<Wide>;
  using Reaction = formulas::VoxelReaction<Wide>;
  using Term = ContactSums::Term;
  static constexpr int kStep = int(kWidth);

 public:
  HWY_INLINE Stages(const ContactJob& job, Columns& columns, ContactSums& totals, StiffnessVectors* stiffness,
                    FrictionVectors* friction)
      : c_(columns),
        job_(job),
        m_(job.motion),
        axis_(job.motion),
        lips_(job.motion),
        totals_(totals),
        stiffness_(stiffness),
        friction_(friction),
        materials_(job, columns),
        spins_(m_.spin != 0),
        chips_(m_.tooth_rate > 0) {}

  /// What the blocks of the next columns allow.
  HWY_INLINE void allow(bool may_write) {
    cuts_ = may_write && m_.cuts();
    crushes_ = may_write && m_.crushes;
  }

  /// Evaluates the collected voxels: all, or those of a chunk.
  HWY_NOINLINE void run(std::span<BlockTask> tasks, int count) {
    const int left = c_.count - count;
    c_.count = count;
    c_.pad();
    sums_.voxels += count;
    materials_.set(tasks);
    move();
    if (spins_ && m_.resists()) resist();
    kept_ = {C::kTop, C::kHeight, C::kFill};
    crushed_ = crushes_ && some_are_deep();
    if (crushed_) crush();
    if (cuts_ && chips_) take_chips();
    compress_springs();
    if (cuts_) {
      recede();
      decay();
    }
    book_energies();
    add_forces();
    if (stiffness_ != nullptr) add_stiffness();
    if (friction_ != nullptr) add_friction();
    if ((cuts_ || crushes_) && job_.writes_fills) write_fills(tasks);
    c_.count += left;
    if (left > 0)
      c_.remove_chunk();
    else
      c_.clear();
  }

  [[nodiscard]] HWY_INLINE ContactVectors& sums() { return sums_; }
  HWY_INLINE void flush() const { sums_.flush(totals_); }

 private:
  /// Motion of the surface, damping, and the work of the slip.
  HWY_NOINLINE void move() {
    for (int n = 0; n < c_.count; n += kStep) {
      const Place r = c_.place(n), normal = c_.normal(n);
      Wide factor = 1;
      if (job_.damped) factor = formulas::Damping<Wide>::of(m_, c_.get(C::kDamping, n), r, normal).factor;
      c_.put(C::kFactor, n, factor);
      Wide rate;
      if (spins_) {
        const Surface surface = Surface::of(m_, axis_, r, normal);
        rate = surface.rate;
        c_.put(C::kInverseSlip, n, surface.inverse_slip);
        c_.put(C::kWork, n,
               surface.work(c_.get(C::kRatio, n), c_.get(C::kStiffness, n), factor, m_.duration * m_.level_of_detail));
      } else {
        rate = Surface::rate_of(m_, r, normal);
      }
      const auto advance = formulas::HeadAdvance<Wide>::of(m_, rate);
      c_.put(C::kMoved, n, advance.moved), c_.put(C::kApproach, n, advance.approach);
    }
  }

  /// What a cut takes that depends on the motion: few materials and drills have it.
  HWY_NOINLINE void resist() {
    for (int n = 0; n < c_.count; n += kStep) {
      const Surface surface = Surface::of(m_, axis_, c_.place(n), c_.normal(n));
      const Material there = formulas::CutResistance<Wide>::of(m_, surface, c_.get(C::kFactor, n), c_.material(n));
      c_.put(C::kEnergy, n, there.energy), c_.put(C::kPerEnergy, n, there.per_energy);
      c_.put(C::kThreshold, n, there.threshold);
    }
  }

  // 1. The filled part.
  [[nodiscard]] HWY_INLINE Part part(int n) const {
    return {c_.section(n), c_.get(C::kFar, n), c_.get(C::kTop, n), c_.get(C::kHeight, n), c_.get(C::kFill, n)};
  }
  [[nodiscard]] HWY_INLINE Part kept(int n) const {
    return {c_.section(n), c_.get(C::kFar, n), c_.get(kept_.top, n), c_.get(kept_.height, n), c_.get(kept_.fill, n)};
  }

  // 2. Crushing.
  [[nodiscard]] HWY_INLINE formulas::Damping<Wide> damping(int n) const {
    return formulas::Damping<Wide>::of_factor(c_.get(C::kFactor, n));
  }
  [[nodiscard]] HWY_INLINE Wide crushing_limit(int n) const {
    return damping(n).crushing_depth(c_.get(C::kCrushing, n));
  }
  [[nodiscard]] HWY_NOINLINE bool some_are_deep() const {
    Where deep = Wide(0) > 0;
    for (int n = 0; n < c_.count; n += kStep) deep = deep || c_.get(C::kTop, n) > crushing_limit(n);
    return any(deep);
  }
  HWY_NOINLINE void crush() {
    for (int n = 0; n < c_.count; n += kStep) {
      const Material material = c_.material(n);
      const Wide limit = crushing_limit(n);
      Wide recedes = 0;
      if (cuts_) recedes = Chord::recession_at(limit, material, lips(n), c_.get(C::kWork, n));
      const auto p = formulas::PartCrushing<Wide>::of(part(n), c_.get(C::kApproach, n), limit, recedes);
      c_.put(C::kKeptTop, n, p.top), c_.put(C::kKeptHeight, n, p.height), c_.put(C::kKeptFill, n, p.fill);
      c_.put(C::kApproach, n, p.approach), c_.put(C::kYielding, n, p.yielding);
    }
    kept_ = {C::kKeptTop, C::kKeptHeight, C::kKeptFill};
  }

  // 3. Chips.
  [[nodiscard]] HWY_INLINE Wide lips(int n) const { return lips_.at(mean_rate(n)); }
  /// [m/s] Speed along the normal without its ripple.
  [[nodiscard]] HWY_INLINE Wide mean_rate(int n) const {
    return formulas::HeadAdvance<Wide>{c_.get(C::kMoved, n), 0}.mean_rate(m_, c_.normal(n));
  }
  HWY_NOINLINE void take_chips() {
    for (int n = 0; n < c_.count; n += kStep) {
      const Material material = c_.material(n);
      const auto chord = Chord::of(material, lips(n), c_.get(C::kWork, n), c_.get(kept_.top, n), c_.get(C::kFar, n),
                                   lips_.advance(mean_rate(n)));
      c_.put(C::kCutEnergy, n, chord.energy);
      c_.put(C::kCutFrom, n, chord.cut.threshold), c_.put(C::kExcess, n, chord.cut.excess);
    }
  }

  // 4. Springs of the part.
  HWY_NOINLINE void compress_springs() {
    Wide fill = 0, area = 0, deepest = 0;
    for (int n = 0; n < c_.count; n += kStep) {
      const Part kept = this->kept(n);
      const auto springs = formulas::PartSprings<Wide>::of(kept);
      c_.put(C::kDepth, n, springs.depth), c_.put(C::kVolume, n, springs.volume);
      fill = fill + springs.volume, area = area + springs.area, deepest = max(deepest, kept.top);
      if (!cuts_) {
        c_.put(C::kRubbing, n, springs.depth), c_.put(C::kSpring, n, springs.depth), c_.put(C::kLeft, n, kept.fill);
      }
    }
    sums_.add(Term::kFill, fill), sums_.add(Term::kArea, area);
    sums_.note_depth(deepest * m_.voxel_size);
  }

  // 5. Recession of the layer.
  HWY_NOINLINE void recede() {
    const bool release = m_.removal == RemovalLaw::elastic_release;
    for (int n = 0; n < c_.count; n += kStep) {
      const Material material = c_.material(n);
      const Part kept = this->kept(n);
      Wide energy = material.energy;
      auto cut = formulas::CutDepth<Wide>::of(kept.top, material.threshold);
      if (chips_) energy = c_.get(C::kCutEnergy, n), cut = {c_.get(C::kCutFrom, n), c_.get(C::kExcess, n)};
      const auto p = formulas::PartRecession<Wide>::of(kept, cut, energy, c_.get(C::kWork, n), c_.get(C::kApproach, n),
                                                       material.stored(m_.voxel_size), release, m_.at_end());
      c_.put(C::kReceded, n, p.receded), c_.put(C::kRate, n, p.rate), c_.put(C::kPrice, n, p.price);
      c_.put(C::kCutEnergy, n, energy), c_.put(C::kRubbing, n, p.rubbing(c_.get(C::kDepth, n)));
    }
  }

  // 6. Decay of the fill.
  HWY_NOINLINE void decay() {
    Wide cutting = 0, credited = 0, rounded_off = 0, helped = 0;
    for (int n = 0; n < c_.count; n += kStep) {
      const Wide fill = c_.get(kept_.fill, n), price = c_.get(C::kPrice, n), energy = c_.get(C::kCutEnergy, n);
      const auto p = formulas::PartDecay<Wide>::of(fill, {0, c_.get(C::kReceded, n), c_.get(C::kRate, n), price});
      c_.put(C::kLeft, n, p.left), c_.put(C::kSpring, n, c_.get(C::kRubbing, n) + p.cut);
      const auto cost = formulas::PartCost<Wide>::of(fill, p, energy, price);
      credited = credited + cost.credited, rounded_off = rounded_off + cost.rounded_off;
      cutting = cutting + cost.cutting, helped = helped + cost.helped;
    }
    sums_.add(Term::kCutting, cutting), sums_.add(Term::kCredited, credited);
    sums_.add(Term::kRubbing, rounded_off), sums_.add(Term::kHelped, helped);
  }

  // 7. Energies before and after.
  HWY_NOINLINE void book_energies() {
    Wide before = 0, change = 0, lost = 0, crushed = 0;
    for (int n = 0; n < c_.count; n += kStep) {
      const Part part = this->part(n), kept = this->kept(n);
      const Wide left = c_.get(C::kLeft, n), stored = c_.material(n).stored(m_.voxel_size);
      const auto e = formulas::PartEnergies<Wide>::of(part, kept, left, c_.get(C::kSpring, n), c_.get(C::kVolume, n),
                                                      c_.get(C::kMoved, n), m_.lead, c_.get(C::kCrushing, n));
      before = before + stored * e.before, change = change + stored * (e.after - e.before);
      lost = lost + stored * e.lost;
      if (!crushed_) continue;
      Wide helped = 0;
      if (cuts_)
        helped = formulas::PartCost<Wide>::helped_of(kept.fill - left, c_.get(C::kCutEnergy, n), c_.get(C::kPrice, n));
      crushed = crushed + select(part.top > kept.top, stored * e.lost - helped, 0);
    }
    sums_.add(Term::kBefore, before), sums_.add(Term::kChange, change);
    sums_.add(Term::kLost, lost), sums_.add(Term::kCrushed, crushed);
  }

  // The force, and what its work is.
  [[nodiscard]] HWY_INLINE formulas::PartForce<Wide> part_force(int n) const {
    return formulas::PartForce<Wide>::of(c_.get(C::kStiffness, n), c_.get(C::kSpring, n), c_.get(C::kFactor, n));
  }
  HWY_NOINLINE void add_forces() {
    Place force = {0, 0, 0}, torque = {0, 0, 0}, pushed = {0, 0, 0}, moment = {0, 0, 0};
    Wide normals = 0, damping = 0, rubbing = 0, couple = 0;
    for (int n = 0; n < c_.count; n += kStep) {
      const Place r = c_.place(n), normal = c_.normal(n);
      const auto pressed = part_force(n);
      const Wide push = pressed.push;
      Place reaction = Reaction::of(normal, push).force;
      if (spins_) {
        pushed = {pushed.x + reaction.x, pushed.y + reaction.y, pushed.z + reaction.z};
        const Surface surface = Surface::of(m_, axis_, r, normal);
        const auto turning = Reaction::of(surface, normal, push, c_.get(C::kRatio, n));
        reaction = turning.force;
        rubbing = rubbing + pressed.rubbed(c_.get(C::kWork, n), c_.get(C::kRubbing, n));
        couple = couple + turning.couple(surface);
      }
      force = {force.x + reaction.x, force.y + reaction.y, force.z + reaction.z};
      const Place arm = cross(r, reaction);
      torque = {torque.x + arm.x, torque.y + arm.y, torque.z + arm.z};
      moment = {moment.x + push * r.x, moment.y + push * r.y, moment.z + push * r.z};
      normals = normals + push, damping = damping + pressed.damped(c_.get(C::kMoved, n), m_.voxel_size);
    }
    sums_.add(Term::kForceX, force), sums_.add(Term::kTorqueX, torque);
    sums_.add(Term::kPushX, pushed), sums_.add(Term::kMomentX, moment);
    sums_.add(Term::kNormal, normals), sums_.add(Term::kDamping, damping);
    sums_.add(Term::kRubbing, rubbing), sums_.add(Term::kCouple, couple);
    if (cuts_ && totals_.pressed != nullptr) share(normals);
  }
  /// Adds the normal forces of each material.
  /// @param normals  [N/m^3] of all voxels
  HWY_NOINLINE void share(Wide normals) {
    for (const MaterialId id : materials_.listed()) {
      Wide pressed = normals;
      if (materials_.listed().size() > 1) {
        pressed = 0;
        for (int n = 0; n < c_.count; n += kStep) pressed = pressed + materials_.only(id, n, part_force(n).push);
      }
      (*totals_.pressed)[id] += sum_of_lanes(pressed.v);
    }
  }

  HWY_NOINLINE void add_stiffness() {
    using Stiffness = formulas::PartStiffness<Wide>;
    for (int n = 0; n < c_.count; n += kStep) {
      const Place r = c_.place(n), normal = c_.normal(n);
      const Material material = c_.material(n);
      const auto damping = this->damping(n);
      const formulas::PartSprings<Wide> springs = {c_.get(C::kDepth, n), c_.get(C::kVolume, n), 0};
      const Wide slope = Stiffness::slope_of(m_, material, damping, springs, c_.get(C::kSpring, n),
                                             crushed_ ? c_.get(C::kYielding, n) : Wide(0), c_.get(kept_.top, n));
      const auto k = Stiffness::of(m_, Surface::of(m_, axis_, r, normal), normal, slope, part_force(n).push,
                                   spins_ ? material.cutting_ratio : Wide(0));
      stiffness_->add(k.spring, r);
      if (!spins_) continue;
      stiffness_->add(k.turned, r);
      if (any(k.slowed.strength > 0)) stiffness_->add(k.slowed, r);
    }
  }
  /// Sums for the dry friction of a standing head.
  HWY_NOINLINE void add_friction() {
    for (int n = 0; n < c_.count; n += kStep) {
      const auto number = [&](float ContactMaterial::*of) HWY_ATTR {
        return materials_.each(n, [&](MaterialId id) { return job_.materials[id].*of; });
      };
      friction_->add(number, part_force(n).push, c_.get(C::kStiffness, n) * (1 / m_.voxel_size) * c_.get(C::kVolume, n),
                     c_.place(n), c_.normal(n));
    }
  }

  /// Writes the new fills to the blocks, with the changes that follow.
  HWY_NOINLINE void write_fills(std::span<BlockTask> tasks) {
    const float* after = c_.of[C::kLeft];
    for (int n = 0; n < c_.count; n += kStep) {
      const Wide left = c_.get(C::kLeft, n);
      const Where changed = left != c_.get(C::kFill, n);
      const unsigned changed_lanes = bits_of(changed.m), emptied_lanes = bits_of((changed && left == 0).m);
      const int end = std::min(n + kStep, c_.count);
      for (int first = n, next = n; first < end; first = next) {
        const unsigned block = unsigned(c_.index[first]) / kBlockVoxels;
        BlockTask& task = tasks[block];
        const bool in_place = task.fill_after == task.block.fill;
        for (; next < end && unsigned(c_.index[next]) / kBlockVoxels == block; ++next) {
          const unsigned voxel = unsigned(c_.index[next]) % kBlockVoxels;
          if (!in_place) begin_strip(task, voxel / kStripLanes);
          task.fill_after[voxel] = after[next];
        }
        const unsigned lanes = (1U << (next - n)) - (1U << (first - n));
        task.change.any_changed |= (changed_lanes & lanes) != 0;
        task.change.any_emptied |= (emptied_lanes & lanes) != 0;
        for (unsigned rest = emptied_lanes & lanes; rest != 0; rest &= rest - 1)
          task.change.emptied.add(int(unsigned(c_.index[n + std::countr_zero(rest)]) % kBlockVoxels));
      }
    }
    for (const MaterialId id : materials_.listed()) {
      Wide removed = 0;
      for (int n = 0; n < c_.count; n += kStep)
        removed = removed + materials_.only(id, n, c_.get(C::kFill, n) - c_.get(C::kLeft, n));
      totals_.removed[id] += sum_of_lanes(removed.v);
    }
  }

  /// Copies the fills of a strip that is written for the first time.
  HWY_INLINE static void begin_strip(BlockTask& task, unsigned strip) {
    if ((task.change.strips >> strip & 1U) != 0) return;
    task.change.strips |= 1U << strip;
    const int first = int(strip) * kStripLanes;
    for (int voxel = first; voxel < first + kStripLanes; ++voxel) task.fill_after[voxel] = task.block.fill_of(voxel);
  }

  struct KeptColumns {
    C::Name top, height, fill;
  };

  Columns& c_;
  const ContactJob& job_;
  const HeadMotion& m_;
  const formulas::AxisSlip<Wide> axis_;
  const formulas::ChippingLips<Wide> lips_;
  ContactSums& totals_;
  StiffnessVectors* const stiffness_;  // null: not needed
  FrictionVectors* const friction_;    // likewise
  ColumnMaterials materials_;
  const bool spins_, chips_;
  ContactVectors sums_;
  KeptColumns kept_ = {C::kTop, C::kHeight, C::kFill};  // columns of the part that crushing left
  bool cuts_ = false, crushes_ = false;
  bool crushed_ = false;  // some voxel of these columns was
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
