// SPDX-License-Identifier: Apache-2.0
// What the press kernel adds up, lane by lane; included once per instruction set.
#if defined(HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#undef HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#else
#define HAPTICUT_KERNELS_PRESS_SUMS_INL_HPP
#endif

#include <algorithm>

#include "kernels/strips-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

namespace strips {

enum class Mode { standing, rubbing, cutting };  // spindle stands; turns with removal off; turns and cuts

/// Running sums of one vector of lanes.
struct PressSums {
  Vec force_x, force_y, force_z, torque_x, torque_y, torque_z;
  Vec elastic_middle, elastic_change, taken_elastic, lag, helped, damping, rubbing, credited, couple, fill, depth;

  HWY_INLINE PressSums() {
    const Vec zero = broadcast(0.0F);
    force_x = force_y = force_z = torque_x = torque_y = torque_z = zero;
    elastic_middle = elastic_change = taken_elastic = lag = helped = zero;
    damping = rubbing = credited = couple = fill = depth = zero;
  }
  HWY_INLINE void add(const PressSums& other) {
    const auto add_to = [](Vec& sum, Vec more) HWY_ATTR { sum = hn::Add(sum, more); };
    add_to(force_x, other.force_x);
    add_to(force_y, other.force_y);
    add_to(force_z, other.force_z);
    add_to(torque_x, other.torque_x);
    add_to(torque_y, other.torque_y);
    add_to(torque_z, other.torque_z);
    add_to(elastic_middle, other.elastic_middle);
    add_to(elastic_change, other.elastic_change);
    add_to(taken_elastic, other.taken_elastic);
    add_to(lag, other.lag);
    add_to(helped, other.helped);
    add_to(damping, other.damping);
    add_to(rubbing, other.rubbing);
    add_to(credited, other.credited);
    add_to(couple, other.couple);
    add_to(fill, other.fill);
    depth = hn::Max(depth, other.depth);
  }
  HWY_INLINE void add_reaction(const Vectors& r, const Vectors& g) {
    force_x = hn::Add(force_x, g.x);
    force_y = hn::Add(force_y, g.y);
    force_z = hn::Add(force_z, g.z);
    torque_x = hn::MulAdd(r.y, g.z, hn::NegMulAdd(r.z, g.y, torque_x));
    torque_y = hn::MulAdd(r.z, g.x, hn::NegMulAdd(r.x, g.z, torque_y));
    torque_z = hn::MulAdd(r.x, g.y, hn::NegMulAdd(r.y, g.x, torque_z));
  }

  /// Adds the lanes to those of the sub-step, in double precision.
  template <Mode kMode>
  HWY_INLINE void flush(std::size_t part, bool damped, ContactSums& totals) const {
    const auto add = [&](ContactSums::Term term, Vec sum) HWY_ATTR {
      alignas(64) float lanes[kWidth];
      hn::Store(sum, Floats(), lanes);
      double* total = &totals.lanes[term][part * kWidth];
      for (std::size_t lane = 0; lane < kWidth; ++lane) total[lane] += double(lanes[lane]);
    };
    add(ContactSums::kForceX, force_x);
    add(ContactSums::kForceY, force_y);
    add(ContactSums::kForceZ, force_z);
    add(ContactSums::kTorqueX, torque_x);
    add(ContactSums::kTorqueY, torque_y);
    add(ContactSums::kTorqueZ, torque_z);
    add(ContactSums::kElasticMiddle, elastic_middle);
    add(ContactSums::kElasticChange, elastic_change);
    add(ContactSums::kFill, fill);
    if (damped) add(ContactSums::kDamping, damping);
    if constexpr (kMode != Mode::standing) {
      add(ContactSums::kRubbing, rubbing);
      add(ContactSums::kCouple, couple);
    }
    if constexpr (kMode == Mode::cutting) {
      add(ContactSums::kTakenElastic, taken_elastic);
      add(ContactSums::kLag, lag);
      add(ContactSums::kHelped, helped);
      add(ContactSums::kCredited, credited);
    }
    totals.depth = std::max(totals.depth, hn::GetLane(hn::MaxOfLanes(Floats(), depth)));
  }
};

}  // namespace strips

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
