// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Limits on the size and the growth of the output. Unlimited by default, because a simulation alone has no device and
/// returns the force of the model. In RealtimeLoop, where a hand feels the output, SafetyGuard limits size and growth
/// to what the device can do, whatever is set here. In your own loop use `output_limits(device)`
/// (docs/decisions/0006-thesis-mode-and-output-limits.md).
struct OutputLimits {
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] larger forces are shortened to this size
  double max_torque = std::numeric_limits<double>::infinity();  ///< [N m] larger torques are shortened to this size
  /// [N/s] how fast the force may grow; it falls at once
  double force_growth = std::numeric_limits<double>::infinity();
  /// [N m/s] how fast the torque may grow; it falls at once
  double torque_growth = std::numeric_limits<double>::infinity();
  /// [s] time in which the output grows to its full size after the start, a jump or a reset
  double ramp_time = 0;
};

constexpr auto fields_of(Of<OutputLimits>) {
  using L = OutputLimits;
  return std::tuple{
      field("max_force", &L::max_force, "N", Range::limit(), "larger forces are shortened to this size"),
      field("max_torque", &L::max_torque, "N m", Range::limit(), "larger torques are shortened to this size"),
      field("force_growth", &L::force_growth, "N/s", Range::limit(), "how fast the force may grow; it falls at once"),
      field("torque_growth", &L::torque_growth, "N m/s", Range::limit(),
            "how fast the torque may grow; it falls at once"),
      field("ramp_time", &L::ramp_time, "s", Range::not_negative(),
            "time in which the output grows to its full size after the start, a jump or a reset"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const OutputLimits& limits) { require_fields_within(limits, "OutputLimits::"); }

/// [N/s] The minimum growth limit that does not turn a wall of stiffness K, hit at speed v, into a source of energy:
/// 1.25 K v.
/// @param stiffness  [N/m] that the device renders
/// @param speed      [m/s] maximum speed of the hand into the wall
[[nodiscard]] constexpr double min_force_growth(double stiffness, double speed) { return 1.25 * stiffness * speed; }

/// [N/s] The default growth limit of a device's force: what its stiffest wall needs. If the stiffness is unknown, the
/// force may reach its peak within 10 ms.
[[nodiscard]] constexpr double default_force_growth(double stiffness, double max_contact_speed, double max_force) {
  const double needed = min_force_growth(stiffness, max_contact_speed);
  return needed > 0 ? needed : max_force / 10e-3;
}

/// Shortens a vector to a maximum length. Its direction is kept.
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Vec3 saturated(const Vec3& v, double max_length) {
  const double length = v.norm();
  return length > max_length ? Vec3(v * (max_length / length)) : v;
}

/// Moves from the last output towards a target. Release is immediate, growth takes time.
///
/// The output first shrinks along its own direction to the foot of the target on it, at once. From there it moves
/// straight towards the target, by at most `max_growth`. So its direction of change is constant, it is never larger
/// than the larger of the two, and it reaches a target of zero at once (C18). A limit on shrinking would make a wall
/// active.
/// @param max_growth  rate times dt, in the unit of the vectors
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Vec3 growth_limited(const Vec3& previous, const Vec3& target, double max_growth) {
  const double squared = previous.squaredNorm();
  const double kept = squared > 0 ? std::clamp(target.dot(previous) / squared, 0.0, 1.0) : 0.0;
  const Vec3 start = kept * previous;
  return start + saturated(target - start, max_growth);
}

}  // namespace hapticut
