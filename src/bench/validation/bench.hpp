// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Simple experiments: a head held still in a half space, or fed along a line through a block.
namespace hapticut::validation {

inline constexpr double kStiffness = 1e12;  ///< [N/m^4] of the static cases

/// u = 3e8 J/m^3, kappa = 0.5, no edge pressure, no damping, no friction.
inline Material plain_material() {
  Material material;
  material.name = "plain";
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = 3e8;
  material.static_friction = material.dynamic_friction = 0;
  return material;
}

inline constexpr double kR = 1 * units::mm;  // [m] of the heads, where nothing else is said
inline constexpr double kTick = 1e-3;        // [s]

inline double cap(double d) { return units::kPi / 12 * d * d * d * (4 * kR - 3 * d); }  // S(R, d), C1

inline SimulationConfig static_config() {
  SimulationConfig config;
  config.reference_stiffness = kStiffness;
  config.removal = RemovalLaw::none;
  config.longest_sweep = 1;
  config.reserved_blocks = 1;
  return config;
}

/// The half space z < 0 under a head, on a grid whose lines match neither the surface nor the head.
inline Workpiece half_space(double reach, double depth, double voxel, const Material& material = plain_material()) {
  const double side = reach + 2.3 * voxel;
  return build_block({Vec3(-side, -side - 0.37 * voxel, -depth - 2.61 * voxel), Vec3(side, side, 0)}, voxel, material);
}

/// What the tool feels that stands at a pose: the first call takes it there, in the second it does not move.
inline const StepResult& hold(Simulation& simulation, const Pose& X_WH, const Twist& velocity = {}) {
  (void)simulation.step(X_WH, velocity, 1e-3);
  return simulation.step(X_WH, velocity, 1e-3);
}

/// Means over the last part of a straight feed at constant speed.
struct Steady {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double engaged_volume = 0;  // [m^3] filled volume in the head
  double removed_volume = 0;  // [m^3] on the whole way
  EnergyLedger energy;
};

inline Steady feed(Simulation& simulation, const Vec3& start, const Vec3& velocity, double travel, double from,
                   double dt = 1e-3) {
  Steady steady;
  const int steps = int(std::lround(travel / (velocity.norm() * dt)));
  int counted = 0;
  for (int i = 0; i < steps; ++i) {
    const StepResult& result =
        simulation.step(Pose::from_translation(start + velocity * (dt * (i + 1))), {velocity, Vec3::Zero()}, dt);
    steady.removed_volume += result.removed_volume;
    if (i < from * steps) continue;
    ++counted;
    steady.force += result.force;
    steady.torque += result.torque;
    steady.engaged_volume += result.contact.volume;
  }
  steady.force /= counted;
  steady.torque /= counted;
  steady.engaged_volume /= counted;
  steady.energy = simulation.last_result().energy;
  return steady;
}

}  // namespace hapticut::validation
