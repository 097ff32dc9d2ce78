// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/vocabulary.hpp"

/// @file
/// Steady cuts compared with their closed forms, and the speed under a constant force.
namespace hapticut::experiments {

/// A check for each component of the form: against the feed, across, thrust, torque.
/// @param what  first component in words
[[nodiscard]] std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                                          const SteadyState& cut, const Tolerance& tolerance,
                                          const Tolerance& of_thrust);
[[nodiscard]] std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                                          const SteadyState& cut, const Tolerance& tolerance);

/// A hand that pushes with a constant force. It speeds up while the cut pushes back less than this force, and slows
/// down while it pushes back more.
struct Hand {
  double force;      ///< [N]
  double inertia;    ///< [N·s/m] heavy enough not to follow the ripple of voxels
  int steps, from;   ///< number of steps, and the first that counts
  double speed = 0;  ///< [m/s] at the beginning

  /// [m/s] Mean speed.
  /// @param pushed_back  [N] force of the cut at a depth [m] and a speed [m/s]
  [[nodiscard]] double mean_speed(const std::function<double(double depth, double speed)>& pushed_back) const;
};

}  // namespace hapticut::experiments
