// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/setup/grid_boxes.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/simulation/status_sentences.hpp"

/// @file
/// A tool with a standing spindle, held still in a workpiece with a misaligned grid.
namespace hapticut::test {

inline constexpr double kStiffness = 1e12;  ///< [N/m^4] k_v of the static cases, at relative stiffness 1

/// Only springs: no removal, no friction. A step may move the head by any distance, for `rest_at`.
inline SimulationConfig static_config() {
  SimulationConfig config;
  config.reference_stiffness = kStiffness;
  config.removal = RemovalLaw::none;
  config.friction = DryFriction{0, 0, 1};
  config.reserved_blocks = 1;
  config.max_sweep = 1;
  return config;
}

/// The wrench on a tool at rest at a pose. The given velocity affects only the damping.
///
/// Takes two steps. The first moves the tool there; if it is rejected as a jump, the second places it there. In the
/// second step the tool does not move, so the wrench is that of exactly this pose.
inline const StepResult& rest_at(Simulation& simulation, const Pose& X_WH, const Twist& velocity = {}) {
  (void)simulation.step(X_WH, velocity, 1e-3);
  return simulation.step(X_WH, velocity, 1e-3);
}

/// `rest_at`, with the expectation that the step has no status.
/// @throws Error when the step has a status
inline const StepResult& rest_ok_at(Simulation& simulation, const Pose& X_WH, const Twist& velocity = {}) {
  const StepResult& result = rest_at(simulation, X_WH, velocity);
  if (result.status != StepStatus::ok || result.sub_steps != 1)
    throw Error("a head at rest takes " + std::to_string(result.sub_steps) + " sub-steps: " + describe(result.status));
  return result;
}

inline const StepResult& rest_ok_at(Simulation& simulation, const Vec3& p_WHo, const Twist& velocity = {}) {
  return rest_ok_at(simulation, Pose::from_translation(p_WHo), velocity);
}

}  // namespace hapticut::test
