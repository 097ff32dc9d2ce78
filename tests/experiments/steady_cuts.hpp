// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/vocabulary.hpp"

/// @file
/// What a form gives of a steady cut beside what is felt of it, and the speed that a hand finds.
namespace hapticut::experiments {

/// A case for each component that the form gives: against the feed, across, thrust, torque.
/// @param what  the first of them in words
[[nodiscard]] std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                                          const SteadyState& cut, const Tolerance& tolerance,
                                          const Tolerance& of_thrust);
[[nodiscard]] std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                                          const SteadyState& cut, const Tolerance& tolerance);

/// A hand that pushes with a constant force: it speeds up while the cut pushes back less, and slows down while it
/// pushes back more.
struct Hand {
  double force;      ///< [N]
  double inertia;    ///< [N·s/m] heavy enough not to follow the ripple of voxels
  int steps, from;   ///< of all, and the first that counts
  double speed = 0;  ///< [m/s] at the beginning

  /// [m/s] The mean speed.
  /// @param pushed_back  [N] of a step to a depth [m] at a speed [m/s]
  [[nodiscard]] double mean_speed(const std::function<double(double depth, double speed)>& pushed_back) const;
};

}  // namespace hapticut::experiments
