// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// A head that is fed along a line through one material, and what it feels in the mean. The handle is straight and has
/// no length, so that its frame is that of the head.
namespace hapticut::test {

/// u = 3e8 J/m^3, kappa = 0.5, no edge pressure, no damping.
inline Material plain_material() {
  Material material;
  material.name = "plain";
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = 3e8;
  return material;
}

/// [1] What is in no term of the ledger, `entered` among them, relative to the turnover: rounding.
inline double unbooked(const EnergyLedger& energy) {
  return std::abs(energy.imbalance() + energy.entered) / energy.turnover;
}

/// Means over a part of a straight feed.
struct SteadyState {
  Vec3 force = Vec3::Zero();           // [N]
  Vec3 torque = Vec3::Zero();          // [N·m]
  double ripple_z = 0;                 // [1] standard deviation of force.z over its mean
  double engaged_volume = 0;           // [m^3] filled volume in the head
  double removed_volume = 0;           // [m^3] on the whole path
  EnergyLedger energy;                 // at the end
  StepStatus status = StepStatus::ok;  // all bits that ever were set
};

/// Feeds the tool along a straight line at constant speed and averages from `from` of the path on.
inline SteadyState feed(Simulation& simulation, const Vec3& start, const Vec3& feed_velocity, double travel, double dt,
                        double from = 0.5) {
  SteadyState state;
  const int steps = int(std::lround(travel / (feed_velocity.norm() * dt)));
  std::vector<double> thrusts;
  for (int i = 0; i < steps; ++i) {
    const Pose pose = Pose::from_translation(start + feed_velocity * (dt * (i + 1)));
    const StepResult& result = simulation.step(pose, {feed_velocity, Vec3::Zero()}, dt);
    state.removed_volume += result.removed_volume;
    state.status |= result.status;
    if (i < from * steps) continue;
    thrusts.push_back(result.force.z());
    state.force += result.force;
    state.torque += result.torque;
    state.engaged_volume += result.contact.volume;
  }
  const double n = double(thrusts.size());
  state.force /= n;
  state.torque /= n;
  state.engaged_volume /= n;
  double variance = 0;
  for (const double thrust : thrusts) variance += std::pow(thrust - state.force.z(), 2) / n;
  state.ripple_z = std::sqrt(variance) / std::abs(state.force.z());
  state.energy = simulation.last_result().energy;
  return state;
}

}  // namespace hapticut::test
