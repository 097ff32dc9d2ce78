// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "hapticut/simulation/simulation.hpp"

/// @file
/// What `hapticut validate` and the tests both measure with: one material, a head that stands, a head that is fed along
/// a line. The handle is straight and has no length, so that its frame is that of the head.
namespace hapticut::fixtures {

inline constexpr double kStiffness = 1e12;  ///< [N/m^4] k_v of the static cases, at relative stiffness 1

/// u = 3e8 J/m^3, kappa = 0.5, no edge pressure, no damping.
inline Material plain_material() {
  Material material;
  material.name = "plain";
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = 3e8;
  return material;
}

/// Springs alone: no removal, no friction; and a step may take the head anywhere, for `hold`.
inline SimulationConfig static_config() {
  SimulationConfig config;
  config.reference_stiffness = kStiffness;
  config.removal = RemovalLaw::none;
  config.friction = DryFriction{0, 0, 1};
  config.reserved_blocks = 1;
  config.longest_sweep = 1;
  return config;
}

/// [1] What is in no term of the ledger, `entered` among them, relative to the turnover: rounding.
inline double unbooked(const EnergyLedger& energy) {
  return std::abs(energy.imbalance() + energy.entered) / energy.turnover;
}

/// What a tool feels that stands still at a pose, or moves through it at the given velocity as far as damping knows.
///
/// Two steps: the first takes the tool there, or is rejected as a jump and takes it there all the same; in the second
/// it does not move, so that the wrench is the one of exactly this pose.
inline const StepResult& hold(Simulation& simulation, const Pose& X_WH, const Twist& velocity = {}) {
  (void)simulation.step(X_WH, velocity, 1e-3);
  return simulation.step(X_WH, velocity, 1e-3);
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
/// @param R_WT  how the tool points, in whose axes the means are told
inline SteadyState feed(Simulation& simulation, const Vec3& start, const Vec3& feed_velocity, double travel, double dt,
                        double from = 0.5, const Mat3& R_WT = Mat3::Identity()) {
  SteadyState state;
  const int steps = int(std::lround(travel / (feed_velocity.norm() * dt)));
  std::vector<double> thrusts;
  for (int i = 0; i < steps; ++i) {
    const Pose pose = {R_WT, start + feed_velocity * (dt * (i + 1))};
    const StepResult& result = simulation.step(pose, {feed_velocity, Vec3::Zero()}, dt);
    state.removed_volume += result.removed_volume;
    state.status |= result.status;
    if (i < from * steps) continue;
    const Vec3 force_T = R_WT.transpose() * result.force;
    thrusts.push_back(force_T.z());
    state.force += force_T;
    state.torque += R_WT.transpose() * result.torque;
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

}  // namespace hapticut::fixtures
