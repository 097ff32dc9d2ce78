// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"

/// A head that is fed along a line through one material, and its mean force. The handle is straight and has no length,
/// so its frame is that of the head.
namespace hapticut::test {

inline constexpr double kRadius = 1 * units::mm;  // [m] default radius of a head
inline constexpr double kVoxel = 0.1 * units::mm;
inline constexpr double kFeed = 2 * units::mm;  // [m/s]
inline constexpr double kSpin = 2000;           // [rad/s]
inline constexpr double kTick = 1e-3;           // [s]

/// u = 3e8 J/m^3, kappa = 0.5, no edge pressure, no damping.
inline Material plain_material() {
  Material material;
  material.name = "plain";
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = 3e8;
  return material;
}

/// [1] Work that no term of the ledger accounts for, not even `entered`, relative to the turnover. Only rounding
/// remains.
inline double unbooked(const EnergyLedger& energy) {
  return std::abs(energy.imbalance() + energy.entered) / energy.turnover;
}

/// A tool whose handle is at the head.
inline Tool tool_of(const ToolHead& head, double spin = 0) {
  return Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s});
}

inline SimulationConfig on_foundation(double reference_stiffness, bool deep_contact = true) {
  SimulationConfig config;
  config.reference_stiffness = reference_stiffness;
  config.deep_contact = deep_contact;
  return config;
}

/// A block below z = 0, large enough for a head of a millimetre, with voxels of kVoxel.
/// @param half_width, depth  [m]
inline Workpiece plain_block(double half_width = 2 * units::mm, double depth = 2 * units::mm) {
  return build_block({Vec3(-half_width, -half_width, -depth), Vec3(half_width, half_width, 0)}, kVoxel,
                     plain_material());
}

inline void undo_all(Simulation& simulation) {
  while (!simulation.history().undo(64)) continue;
}
inline void redo_all(Simulation& simulation) {
  while (!simulation.history().redo(64)) continue;
}

/// The orientation of a tool in the grid.
struct Orientation {
  const char* name;
  Mat3 R_WT;
};
inline const std::vector<Orientation> kOrientations = {
    {"10 deg", Eigen::AngleAxisd(10 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"45 deg", Eigen::AngleAxisd(45 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"<111>", Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(1, 1, 1)).toRotationMatrix()},
};
inline const Vec3 kOffGrid(0.0293 * units::mm, 0.0113 * units::mm, 0);  // [m] place of a tool's axis, in its axes

/// The part of a box where `distance` [m] is negative, of one material.
template <class Distance>
Workpiece body(const Box& box, double voxel, const Material& material, const Distance& distance) {
  return build_body({box, distance, [](const Vec3&) { return MaterialId(1); }}, voxel, MaterialTable({material}));
}

/// A step of the hand with the tool upright.
inline const StepResult& step_to(Simulation& simulation, const Vec3& p_WHo, const Vec3& velocity = Vec3::Zero()) {
  return simulation.step(Pose::from_translation(p_WHo), {velocity, Vec3::Zero()}, kTick);
}

/// Means over a part of a straight feed.
struct SteadyState {
  Vec3 force = Vec3::Zero();           // [N] along the axes of the tool
  Vec3 torque = Vec3::Zero();          // [N·m]
  double engaged_volume = 0;           // [m^3] filled volume in the head
  double removed_volume = 0;           // [m^3] on the whole path
  EnergyLedger energy;                 // at the end
  StepStatus status = StepStatus::ok;  // all bits of all steps
};

/// Feeds the tool along a straight line at constant speed, and averages after the fraction `from` of the path.
/// @param R_WT  orientation of the tool; the means are along the tool's axes
inline SteadyState feed(Simulation& simulation, const Vec3& start, const Vec3& feed_velocity, double travel, double dt,
                        double from = 0.5, const Mat3& R_WT = Mat3::Identity()) {
  SteadyState state;
  const int steps = int(std::lround(travel / (feed_velocity.norm() * dt)));
  int count = 0;
  for (int i = 0; i < steps; ++i) {
    const Pose pose = {R_WT, start + feed_velocity * (dt * (i + 1))};
    const StepResult& result = simulation.step(pose, {feed_velocity, Vec3::Zero()}, dt);
    state.removed_volume += result.removed_volume;
    state.status |= result.status;
    if (i < from * steps) continue;
    ++count;
    state.force += R_WT.transpose() * result.force;
    state.torque += R_WT.transpose() * result.torque;
    state.engaged_volume += result.contact.volume;
  }
  state.force /= count;
  state.torque /= count;
  state.engaged_volume /= count;
  state.energy = simulation.last_result().energy;
  return state;
}

}  // namespace hapticut::test
