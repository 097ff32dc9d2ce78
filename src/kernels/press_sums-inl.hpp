// SPDX-License-Identifier: Apache-2.0
// Sums of the press kernel, lane by lane; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#endif

#include <algorithm>

#include "kernels/gather-inl.hpp"
#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

/// Result of stage sample_contact for a vector of voxels.
struct Sample {
  Vec depth;               // [m] of the voxel's centre below the surface; zero in lanes that do not count
  Vec radial, axial;       // of the normal, as in SpringVectors
  Vec rate;                // [m/s] rate of change of the depth
  Vec felt_rate;           // [m/s] as the damping feels it; set where some material has damping
  Vec inverse_slip;        // [s/m] zero where the head stands
  Vec slip_path;           // [m] in the sub-step, likewise
  Vec top, max_component;  // of the filled part: its maximum depth [m], zero in lanes that do not count; and max |n_i|
  Vec smooth;              // [m^2] as in SpringVectors; read only of springs that are kSmooth

  [[nodiscard]] HWY_INLINE Mask on_smooth() const { return smooth > hn::Zero(Floats()); }
  /// [m] r x n = (y lever, -x lever, 0)
  [[nodiscard]] HWY_INLINE Vec lever(const Vectors& r) const { return hn::NegMulAdd(r.z, radial, axial); }
};

/// Samples of the voxels of a VoxelList.
class SampleList {
 public:
  /// @tparam kSmooth  some may be on smooth surfaces
  template <bool kSmooth>
  HWY_INLINE void store(int first, const Sample& s) {
    const auto keep = [&](int n, Vec value) HWY_ATTR { hn::Store(value, Floats(), values_[n] + first); };
    keep(0, s.depth), keep(1, s.radial), keep(2, s.axial), keep(3, s.rate), keep(4, s.felt_rate);
    keep(5, s.inverse_slip), keep(6, s.slip_path), keep(7, s.top), keep(8, s.max_component);
    if (kSmooth) keep(9, s.smooth);
  }
  template <bool kSmooth>
  [[nodiscard]] HWY_INLINE Sample load(int first) const {
    const auto value = [&](int n) HWY_ATTR { return hn::Load(Floats(), values_[n] + first); };
    Sample s;
    s.depth = value(0), s.radial = value(1), s.axial = value(2), s.rate = value(3), s.felt_rate = value(4);
    s.inverse_slip = value(5), s.slip_path = value(6);
    s.top = value(7), s.max_component = value(8);
    s.smooth = kSmooth ? value(9) : hn::Zero(Floats());
    return s;
  }

 private:
  static constexpr int kVectors = 10;
  alignas(64) float values_[kVectors][VoxelList::kCapacity];
};

/// Force and torque of normal forces, and their positions.
struct PushSums {
  Vec force_x, force_y, force_z, torque_x, torque_y;
  Vec moment_x, moment_y, moment_z, normal_force;

  HWY_INLINE PushSums() {
    force_x = force_y = force_z = torque_x = torque_y = broadcast(0.0F);
    moment_x = moment_y = moment_z = normal_force = broadcast(0.0F);
  }

  /// @param size  [N/m^3] normal force
  HWY_INLINE void add_place(const Vectors& r, Vec size) {
    normal_force = normal_force + size;
    moment_x = hn::MulAdd(size, r.x, moment_x);
    moment_y = hn::MulAdd(size, r.y, moment_y);
    moment_z = hn::MulAdd(size, r.z, moment_z);
  }

  /// @param normal  [N/m^3] normal force, without drag
  template <bool kCentral>
  HWY_INLINE void add_push(const Vectors& r, const Sample& s, Vec normal) {
    const Vec across = normal * s.radial;
    force_x = hn::MulAdd(across, r.x, force_x);
    force_y = hn::MulAdd(across, r.y, force_y);
    force_z = hn::MulAdd(normal, s.axial, force_z);
    if constexpr (kCentral) return;
    const Vec moment = normal * s.lever(r);
    torque_x = hn::MulAdd(moment, r.y, torque_x);
    torque_y = hn::NegMulAdd(moment, r.x, torque_y);
  }
};

/// Sums of whole voxels that are wholly inside a standing head.
struct DeepSums : PushSums {
  Vec twice_after, change, damping, depth;
  int voxels = 0;

  HWY_INLINE DeepSums() { twice_after = change = damping = depth = broadcast(0.0F); }

  /// @param k       [N/m^4] zero in lanes that do not count
  /// @param w       [m] depth of the centres, which advances by `advance` in the sub-step
  /// @param to_end  [1] part of the advance from there to the end
  /// @return [N/m^3] normal force
  HWY_INLINE Vec add_spring(Vec k, Vec w, Vec advance, float to_end, float voxel_size) {
    const Vec pushed = k * w, at_end = hn::MulAdd(advance, broadcast(to_end), w);
    change = hn::MulAdd(pushed, advance, change);
    twice_after = hn::MulAdd(k, hn::MulAdd(at_end, at_end, broadcast(voxel_size * voxel_size / 12)), twice_after);
    return pushed;
  }
};

/// ContactSums of one vector of lanes.
struct PressSums : PushSums {
  Vec torque_z, push_x, push_y, push_z, area;
  Vec before, change, released, crushed, helped, chips, credited, damping, rubbing, couple, fill, depth;
  int voxels = 0, whole = 0;  // whole: not counted in `fill`

  HWY_INLINE PressSums() {
    torque_z = push_x = push_y = push_z = area = broadcast(0.0F);
    before = change = released = crushed = helped = chips = credited = broadcast(0.0F);
    damping = rubbing = couple = fill = depth = broadcast(0.0F);
  }

  /// @param normal  [N/m^3] normal force
  /// @param drag    [N s/m^4] against the velocity v
  HWY_INLINE void add_reaction(const Vectors& r, const Sample& s, Vec normal, Vec drag, const Vectors& v) {
    const Vec across = normal * s.radial;
    const Vec x = hn::MulAdd(across, r.x, drag * v.x), y = hn::MulAdd(across, r.y, drag * v.y),
              z = hn::MulAdd(normal, s.axial, drag * v.z);
    force_x = force_x + x;
    force_y = force_y + y;
    force_z = force_z + z;
    torque_x = hn::MulAdd(r.y, z, hn::NegMulAdd(r.z, y, torque_x));
    torque_y = hn::MulAdd(r.z, x, hn::NegMulAdd(r.x, z, torque_y));
    torque_z = hn::MulAdd(r.x, y, hn::NegMulAdd(r.y, x, torque_z));
  }

  /// @param normal  [N/m^3] normal force, without the drag
  HWY_INLINE void add_normal(const Vectors& r, const Sample& s, Vec normal) {
    const Vec across = normal * s.radial;
    push_x = hn::MulAdd(across, r.x, push_x);
    push_y = hn::MulAdd(across, r.y, push_y);
    push_z = hn::MulAdd(normal, s.axial, push_z);
  }

  HWY_INLINE void add(const DeepSums& deep) {
    moment_x = moment_x + deep.moment_x;
    moment_y = moment_y + deep.moment_y;
    moment_z = moment_z + deep.moment_z;
    force_x = force_x + deep.force_x;
    force_y = force_y + deep.force_y;
    force_z = force_z + deep.force_z;
    torque_x = torque_x + deep.torque_x;
    torque_y = torque_y + deep.torque_y;
    change = change + deep.change;
    before = before + hn::MulSub(broadcast(0.5F), deep.twice_after, deep.change);
    damping = damping + deep.damping;
    normal_force = normal_force + deep.normal_force;
    depth = hn::Max(depth, deep.depth);
    voxels += deep.voxels;
    whole += deep.voxels;
  }

  /// Adds the lanes to those of the sub-step, in double precision.
  HWY_INLINE void flush(ContactSums& totals) const {
    const auto add = [&](ContactSums::Term term, Vec sum) HWY_ATTR {
      alignas(64) float lanes[kWidth];
      hn::Store(sum, Floats(), lanes);
      double* total = &totals.lanes[term][0];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    };
    add(ContactSums::kForceX, force_x);
    add(ContactSums::kForceY, force_y);
    add(ContactSums::kForceZ, force_z);
    add(ContactSums::kTorqueX, torque_x);
    add(ContactSums::kTorqueY, torque_y);
    add(ContactSums::kTorqueZ, torque_z);
    add(ContactSums::kBefore, before);
    add(ContactSums::kChange, change);
    add(ContactSums::kReleased, released);
    add(ContactSums::kCrushed, crushed);
    add(ContactSums::kHelped, helped);
    add(ContactSums::kChips, chips);
    add(ContactSums::kCredited, credited);
    add(ContactSums::kDamping, damping);
    add(ContactSums::kRubbing, rubbing);
    add(ContactSums::kCouple, couple);
    add(ContactSums::kFill, fill);
    totals.lanes[ContactSums::kFill][0] += double(whole);
    add(ContactSums::kNormal, normal_force);
    add(ContactSums::kPushX, push_x);
    add(ContactSums::kPushY, push_y);
    add(ContactSums::kPushZ, push_z);
    add(ContactSums::kMomentX, moment_x);
    add(ContactSums::kMomentY, moment_y);
    add(ContactSums::kMomentZ, moment_z);
    add(ContactSums::kArea, area);
    totals.voxels += voxels;
    totals.depth = std::max(totals.depth, hn::GetLane(hn::MaxOfLanes(Floats(), depth)));
  }
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
