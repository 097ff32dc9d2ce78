// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/setup/cutting.hpp"
#include "support/touch_gains.hpp"

/// @file
/// Tools on a virtual coupling, and a hand that presses them down.
namespace hapticut::test {

inline constexpr double kPress = 5;          // [N]
inline constexpr double kApproach = 0.1;     // [m/s]
inline const Vec3 kAside = {1e-5, 2e-5, 0};  // [m] off the symmetry of the grid

/// By default only springs: no damping except that of the material.
inline SimulationConfig implicit(double reference_stiffness, std::optional<double> contact_damping = 0.0) {
  SimulationConfig config;
  config.reference_stiffness = reference_stiffness;
  config.contact_damping = contact_damping;
  config.contact_time = ContactTime::end;
  return config;
}

/// @param depth  [m] depth of the material below z = 0
inline Workpiece half_space(double depth = 4e-3, const Material& material = plain_material(), double voxel = 1e-4) {
  return build_block({{-4e-3, -4e-3, -depth}, {4e-3, 4e-3, 0}}, voxel, material);
}

inline Tool ball(double spin = 0) { return tool_of(SphereHead{kRadius}, spin); }

inline Pose at_height(double z) { return Pose::from_translation(kAside + Vec3(0, 0, z)); }

/// A hand that comes down along z and stops where the coupling pulls with a given force.
struct PressedTool {
  double rest_penetration = 0;  // [m]
  double max_penetration = 0;   // [m]
  double rebound = 0;           // [m/s] maximum speed upwards
  double jitter = 0;            // [m] from the lowest to the highest position in the last half second
  double rest_force = 0;        // [N] on the hand, upwards
  int newton_steps = 0;         // sum over all ticks
};

inline PressedTool press(VirtualCoupling& coupling, double force = kPress, int ticks = 2000) {
  const double start = kRadius + 1e-3, end = kRadius - force / coupling.gains().stiffness;
  PressedTool pressed;
  double last = start, low = 1, high = -1;
  for (int n = 0; n < ticks; ++n) {
    const double z = std::max(start - kApproach * n * kTick, end);
    const CoupledResult& result = coupling.step(at_height(z), {Vec3(0, 0, (z - last) / kTick), Vec3::Zero()}, kTick);
    last = z;
    const double height = result.X_WH.translation.z();
    pressed.newton_steps += result.newton_steps;
    pressed.rebound = std::max(pressed.rebound, result.V_WH.linear.z());
    pressed.max_penetration = std::max(pressed.max_penetration, kRadius - height);
    if (n >= ticks - 500) low = std::min(low, height), high = std::max(high, height);
  }
  pressed.rest_penetration = kRadius - coupling.last_result().X_WH.translation.z();
  pressed.jitter = high - low;
  pressed.rest_force = coupling.last_result().hand.force.z();
  return pressed;
}

}  // namespace hapticut::test
