// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "gestures/scripted_loops.hpp"
#include "hapticut/safety/guard.hpp"

/// @file
/// Scenes with a ball on a block of bone, in the loop of a Touch.
namespace hapticut::gestures {

inline constexpr double kBallRadius = 1 * mm;  // [m]

[[nodiscard]] inline Tool turning_ball(double speed = 40000 * rpm) {
  return tool_of(SphereHead{kBallRadius}, Spindle{speed * units::rad_per_s});
}

[[nodiscard]] inline Workpiece bone_for(const Report& report) {
  return slab(1.6 * mm, 3 * mm, report.voxel(), presets::cortical_bone());
}

[[nodiscard]] inline double applied_of(const Tick& tick) { return tick.applied.force.norm(); }

/// Demands that in no tick of a span the motor force grows faster than the slew limit of a Touch.
inline void demand_slow_growth(Report& report, const SceneLog& log, const Span& span,
                               const std::string& demand = "force step") {
  double max_growth = 0;  // [N] growth in one tick
  for (std::size_t n = std::max<std::size_t>(span.first, 1); n < span.last; ++n) {
    const Vec3 &last = log.ticks[n - 1].applied.force, &now = log.ticks[n].applied.force;
    max_growth = std::max(max_growth, (now - growth_limited(last, now, 0)).norm());
  }
  const double slew = SafetyGuard(capabilities(device_model("touch")), {}).slew();  // [N/s]
  report.at_most(demand, max_growth, 1.001 * slew * report.period, "N", "the slew limit");
}

}  // namespace hapticut::gestures
