// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Steady cuts with a straight handle of length 0 (handle frame = head frame, axes along W), and their means.
namespace hapticut::test {

/// The material of model.md 8.3: u = 3e8 J/m^3, kappa = 0.5, no edge pressure, no damping.
inline Material plain_material() {
  Material material;
  material.name = "plain";
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = 3e8;
  return material;
}

/// Mean and relative standard deviation of force and torque over a part of a path.
struct SteadyState {
  Vec3 force = Vec3::Zero();           // [N]
  Vec3 torque = Vec3::Zero();          // [N·m]
  double ripple_z = 0;                 // [1] standard deviation of force.z over its mean
  double removed_volume = 0;           // [m^3] on the whole path
  EnergyLedger energy;                 // at the end
  StepStatus status = StepStatus::ok;  // all bits that ever were set
};

/// Feeds the tool along a straight line at constant speed and averages from `from` of the path on.
inline SteadyState feed(Simulation& simulation, const Vec3& start, const Vec3& feed_velocity, double travel, double dt,
                        double from = 0.5) {
  SteadyState state;
  const int steps = int(travel / (feed_velocity.norm() * dt) + 0.5);
  std::vector<Vec3> forces;
  for (int i = 0; i < steps; ++i) {
    const Pose pose = Pose::from_translation(start + feed_velocity * (dt * (i + 1)));
    const StepResult& result = simulation.step(pose, {feed_velocity, Vec3::Zero()}, dt);
    state.removed_volume += result.removed_volume;
    state.status |= result.status;
    if (i < from * steps) continue;
    forces.push_back(result.force);
    state.torque += result.torque;
  }
  const double n = double(forces.size());
  for (const Vec3& f : forces) state.force += f / n;
  state.torque /= n;
  double variance = 0;
  for (const Vec3& f : forces) variance += (f.z() - state.force.z()) * (f.z() - state.force.z()) / n;
  state.ripple_z = std::sqrt(variance) / std::abs(state.force.z());
  state.energy = simulation.last_result().energy;
  return state;
}

}  // namespace hapticut::test
