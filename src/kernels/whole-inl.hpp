// SPDX-License-Identifier: Apache-2.0
// Whole voxels that stay wholly inside a standing head; included once per instruction set.
#if defined(HAPTICUT_KERNELS_WHOLE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_WHOLE_INL_HPP
#undef HAPTICUT_KERNELS_WHOLE_INL_HPP
#else
#define HAPTICUT_KERNELS_WHOLE_INL_HPP
#endif

#include "kernels/gather-inl.hpp"
#include "kernels/stages-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// For a head that stands and removes nothing, whole voxels that stay wholly inside it need no section: the mean depth
/// of a cube is that of its centre, and the mean of its square is larger by l^2/12. They cost a third of the stages,
/// and inside a ball, where they are evaluated strip by strip as they are found, a quarter.
template <class Springs>
class WholeVoxels {
 public:
  HWY_INLINE WholeVoxels(const Springs& springs, const ContactJob& job, Stages& stages, const Eigen::Matrix3f& axes,
                         StiffnessVectors* stiffness, FrictionVectors* friction)
      : springs_(springs),
        job_(job),
        m_(job.motion),
        stages_(stages),
        stiffness_(stiffness),
        friction_(friction),
        axes_(axes),
        deep_enough_(kVoxelReach * m_.voxel_size + (Springs::kCentral ? m_.velocity.norm() * m_.duration : 0.0F)),
        deep_(springs.grown(-deep_enough_)) {}

  /// Evaluates the voxels of a block that are so inside a ball.
  /// @param out  [ReachedVoxels::kCapacity]
  /// @return the others that may be inside
  HWY_INLINE ReachedVoxels evaluate_block(const Gather<Springs>& gather, const BlockView& block, std::uint16_t* out) {
    const std::uint32_t done = evaluate_strips(gather, block);
    return gather.find_skimmed(
        block, out, done, [&](int voxel, const Place& r, unsigned lanes) HWY_ATTR __attribute__((always_inline)) {
          const Mask near = deep_.hits(r.x, r.y, r.z).m;
          if (hn::AllFalse(Floats(), near)) return lanes;
          const MaterialId* ids = block.material == nullptr ? &block.uniform_material : block.material + voxel;
          if (block.material != nullptr && !all_are(ids, ids[0])) return lanes;
          const Wide fill = block.fill == nullptr ? Wide(1) : Wide(hn::LoadU(Floats(), block.fill + voxel));
          return bits_of(evaluate_lanes(ids[0], r, springs_.at(r.x, r.y, r.z), fill, hn::And(near, mask_of(lanes)))) |
                 (lanes & ~bits_of(near));
        });
  }

  /// Evaluates the strips of a block of one material that are so inside a ball.
  /// @return bit n: strip n was evaluated
  HWY_INLINE std::uint32_t evaluate_strips(const Gather<Springs>& gather, const BlockView& block) {
    static_assert(Springs::kCentral);
    if (job_.damped || m_.lead > 0 || stiffness_ != nullptr || friction_ != nullptr) return 0;
    if (block.material != nullptr || block.fill != nullptr) return 0;
    const Wide k = job_.materials[block.uniform_material].stiffness;
    const Eigen::Vector3f path = m_.velocity * m_.duration;
    const Where all = Wide(1) > 0;
    const std::uint32_t done = gather.for_each_within(
        block, deep_, [&](const Place& r) HWY_ATTR __attribute__((always_inline)) {
          const auto [depth, radial, axial, smooth] = springs_.at(r.x, r.y, r.z);
          const Wide advance = rate_of(r, radial, axial, path, path);
          sums_.add_push(r, radial, axial, sums_.add_spring(k, depth, advance, 0.5F, m_.voxel_size));
          note_depth(depth, r, radial, axial, all);
        });
    sums_.voxels += kStripLanes * std::popcount(done);
    return done;
  }

  /// Evaluates the voxels of a vector that are so, or collects them.
  /// @param id      material of all of them
  /// @param listed  which lanes have a voxel
  /// @return the lanes that are left
  HWY_INLINE Mask evaluate_lanes(MaterialId id, const Place& r, const formulas::SpatialSpring<Wide>& spring, Wide fill,
                                 Mask listed) {
    const Wide advance = rate_of(r, spring.radial, spring.axial, m_.velocity, m_.angular_velocity) * m_.duration;
    Mask deep = hn::And(listed, (fill >= 1 && spring.depth > abs(advance) + deep_enough_).m);
    if constexpr (Springs::kSmooth) deep = hn::AndNot((spring.smooth > 0).m, deep);
    const unsigned lanes = bits_of(deep);
    if (lanes == 0) return listed;
    if constexpr (Springs::kCentral)
      evaluate(id, r, spring.depth, spring.radial, spring.axial, Where{deep});
    else
      collect(id, r, spring, lanes);
    return hn::AndNot(deep, listed);
  }

  HWY_INLINE void flush() {
    run(count_);
    if (sums_.voxels > 0) sums_.add_to(stages_.sums());
  }

 private:
  /// ContactSums of whole voxels, without a torque about the axis.
  struct Sums {
    Place force = {0, 0, 0}, moment = {0, 0, 0};
    Wide torque_x = 0, torque_y = 0, normals = 0, twice_after = 0, change = 0, damping = 0, depth = 0;
    int voxels = 0;

    // The implicit one is not compiled for the instruction set. NOLINTNEXTLINE(modernize-use-equals-default)
    HWY_INLINE Sums() {}

    /// @param k        [N/m^4] zero in lanes that do not count
    /// @param w        [m] depth of the centres, which advances by `advance` in the sub-step
    /// @param to_end   [1] part of the advance from there to the end
    /// @return [N/m^3] normal force
    HWY_INLINE Wide add_spring(Wide k, Wide w, Wide advance, float to_end, float voxel_size) {
      const Wide pushed = k * w, at_end = advance * to_end + w;
      change = change + pushed * advance;
      twice_after = twice_after + k * (at_end * at_end + voxel_size * voxel_size / 12);
      return pushed;
    }
    /// @param radial, axial  of the normals, as in SpatialSpring
    HWY_INLINE void add_push(const Place& r, Wide radial, Wide axial, Wide push) {
      const Wide across = push * radial;
      force = {force.x + across * r.x, force.y + across * r.y, force.z + push * axial};
      normals = normals + push;
      moment = {moment.x + push * r.x, moment.y + push * r.y, moment.z + push * r.z};
      if constexpr (Springs::kCentral) return;
      const Wide lever = push * (axial - r.z * radial);
      torque_x = torque_x + lever * r.y, torque_y = torque_y - lever * r.x;
    }
    HWY_INLINE void add_to(ContactVectors& sums) const {
      using Term = ContactSums::Term;
      sums.add(Term::kForceX, force), sums.add(Term::kMomentX, moment);
      sums.add(Term::kTorqueX, torque_x), sums.add(Term::kTorqueY, torque_y);
      sums.add(Term::kNormal, normals), sums.add(Term::kDamping, damping);
      sums.add(Term::kChange, change), sums.add(Term::kBefore, Wide(0.5F) * twice_after - change);
      sums.note_depth(depth);
      sums.voxels += voxels, sums.whole += voxels;
    }
  };

  HWY_INLINE void collect(MaterialId id, const Place& r, const formulas::SpatialSpring<Wide>& spring, unsigned lanes) {
    if (count_ > 0 && id != id_) run(count_);
    id_ = id;
    const Wide values[kColumns] = {r.x, r.y, r.z, spring.depth, spring.radial, spring.axial};
    for (int column = 0; column < kColumns; ++column) store_lanes(values[column].v, lanes, of_[column] + count_);
    count_ += std::popcount(lanes);
    if (count_ >= Columns::kChunk) run(Columns::kChunk);
  }
  /// Evaluates the collected voxels: all, or those of a chunk.
  HWY_NOINLINE void run(int count) {
    if (count % int(kWidth) != 0)  // the lanes after the last voxel; not a number would spoil the sums
      for (auto& column : of_) hn::StoreU(hn::Zero(Floats()), Floats(), column + count);
    for (int first = 0; first < count; first += int(kWidth)) {
      const auto get = [&](int column) HWY_ATTR { return Wide::load(of_[column] + first); };
      const Mask lanes = hn::FirstN(Floats(), std::size_t(std::min(count - first, int(kWidth))));
      evaluate(id_, {get(0), get(1), get(2)}, get(3), get(4), get(5), Where{lanes});
    }
    count_ -= count;
    if (count_ == 0) return;
    for (auto& column : of_) Wide::load(column + Columns::kChunk).store(column);
  }

  HWY_INLINE void evaluate(MaterialId id, const Place& r, Wide depth, Wide radial, Wide axial, Where deep) {
    const ContactMaterial& material = job_.materials[id];
    const Wide advance = rate_of(r, radial, axial, m_.velocity, m_.angular_velocity) * m_.duration;
    const Wide k = select(deep, Wide(material.stiffness), 0);
    const Wide pushed = sums_.add_spring(k, depth, advance, 0.5F - m_.lead, m_.voxel_size);
    formulas::Damping<Wide> damping = {1, 0};
    Wide push = pushed;
    if (job_.damped) {
      damping = formulas::Damping<Wide>::of(material.damping *
                                            rate_of(r, radial, axial, m_.felt_velocity, m_.felt_angular_velocity));
      push = pushed * damping.factor;
      sums_.damping = sums_.damping + (push - pushed) * advance;
    }
    sums_.add_push(r, radial, axial, push);
    sums_.voxels += std::popcount(bits_of(deep.m));
    note_depth(depth, r, radial, axial, deep);
    const Place n = {r.x * radial, r.y * radial, axial};
    if (stiffness_ != nullptr) [[unlikely]] {
      const Wide damper = damping.slope * material.damping * depth * (1 / m_.time_to_move());
      stiffness_->add({k * (damping.factor + damper), n, n}, r);
    }
    if (friction_ != nullptr) [[unlikely]]
      friction_->add([&](float ContactMaterial::*of) HWY_ATTR { return Wide(material.*of); }, push, k, r, n);
  }

  /// [m/s] Speed along the normal, n (v + omega x r) = v n + omega (r x n). The normals of a ball have no moment; those
  /// of a body of revolution have r x n = (y lever, -x lever, 0).
  HWY_INLINE static Wide rate_of(const Place& r, Wide radial, Wide axial, const Eigen::Vector3f& v,
                                 const Eigen::Vector3f& omega) {
    const Wide along = radial * (r.x * v.x() + r.y * v.y()) + axial * v.z();
    if constexpr (Springs::kCentral) return along;
    return along + (axial - r.z * radial) * (r.y * omega.x() - r.x * omega.y());
  }

  /// Updates the maximum depth by the tops of voxels.
  HWY_INLINE void note_depth(Wide depth, const Place& r, Wide radial, Wide axial, Where deep) {
    if (!any(deep && depth + kVoxelReach * m_.voxel_size > deepest_)) [[likely]]
      return;
    const Place n = {r.x * radial, r.y * radial, axial};
    const Section section(formulas::largest_component(axes_, n), m_.min_width);
    sums_.depth = max(sums_.depth, select(deep, depth + section.span() * (0.5F * m_.voxel_size), 0));
    deepest_ = hn::GetLane(hn::MaxOfLanes(Floats(), sums_.depth.v));
  }

  static constexpr int kColumns = 6;
  alignas(64) float of_[kColumns][Columns::kCapacity];  // position, depth, radial and axial
  const Springs& springs_;
  const ContactJob& job_;
  const HeadMotion& m_;
  Stages& stages_;
  StiffnessVectors* const stiffness_;  // null: not needed
  FrictionVectors* const friction_;    // likewise
  const Eigen::Matrix3f& axes_;        // axes of the grid, in T
  const float deep_enough_;  // [m] depth at which a voxel is wholly inside; for a ball, during the whole sub-step
  const typename Gather<Springs>::Bound deep_;  // bound on the centres of such voxels; exact for a ball
  int count_ = 0;                               // number of collected voxels
  MaterialId id_ = kEmpty;                      // material of all of them
  float deepest_ = 0;                           // [m] maximum of all voxels so far
  Sums sums_;
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
