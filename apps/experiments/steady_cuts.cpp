// SPDX-License-Identifier: Apache-2.0
#include "experiments/steady_cuts.hpp"

#include <algorithm>

namespace hapticut::experiments {

std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                            const SteadyState& cut, const Tolerance& tolerance, const Tolerance& of_thrust) {
  std::vector<Check> checks;
  const auto add = [&](const char* name, const char* words, const char* unit, double form, double felt,
                       const Tolerance& allowed) {
    if (form != 0) checks.push_back({id + name, checks.empty() ? what : words, unit, form, felt, allowed});
  };
  add(" against the feed", "", "N", expected.force.x(), cut.force.x(), tolerance);
  add(" across", "side force", "N", expected.force.y(), cut.force.y(), tolerance);
  add(" thrust", "its thrust", "N", expected.force.z(), cut.force.z(), of_thrust);
  add(" torque", "its torque", "N m", expected.torque.z(), cut.torque.z(), tolerance);
  return checks;
}

std::vector<Check> compared(const std::string& id, const std::string& what, const Wrench& expected,
                            const SteadyState& cut, const Tolerance& tolerance) {
  return compared(id, what, expected, cut, tolerance, tolerance);
}

double Hand::mean_speed(const std::function<double(double depth, double speed)>& pushed_back) const {
  double depth = 0, now = speed, sum = 0;
  for (int n = 0; n < steps; ++n) {
    depth += now * kTick;
    if (n >= from) sum += now;
    now = std::max(0.0, now + (force - pushed_back(depth, now)) / inertia * kTick);
  }
  return sum / (steps - from);
}

}  // namespace hapticut::experiments
