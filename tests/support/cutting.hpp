// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bench/fixtures.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Steady cuts with a straight handle of length 0 (handle frame = head frame, axes along W), and their means.
namespace hapticut::test {

using fixtures::feed;
using fixtures::plain_material;
using fixtures::SteadyState;
using fixtures::unbooked;

inline constexpr double kRadius = 1 * units::mm;  // [m] of a head, where nothing else is said
inline constexpr double kVoxel = 0.1 * units::mm;
inline constexpr double kFeed = 2 * units::mm;  // [m/s]
inline constexpr double kSpin = 2000;           // [rad/s]
inline constexpr double kTick = 1e-3;           // [s]

/// Held where the hand feels it.
inline Tool tool_of(const ToolHead& head, double spin = 0) {
  return Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s});
}

inline SimulationConfig on_foundation(double reference_stiffness, bool deep_contact = true) {
  SimulationConfig config;
  config.reference_stiffness = reference_stiffness;
  config.deep_contact = deep_contact;
  return config;
}

/// As large as a millimetre's head asks for, below z = 0, on voxels of kVoxel.
/// @param half_width, depth  [m]
inline Workpiece plain_block(double half_width = 2 * units::mm, double depth = 2 * units::mm) {
  return build_block({Vec3(-half_width, -half_width, -depth), Vec3(half_width, half_width, 0)}, kVoxel,
                     plain_material());
}

inline void undo_all(Simulation& simulation) {
  while (!simulation.undo(64)) continue;
}
inline void redo_all(Simulation& simulation) {
  while (!simulation.redo(64)) continue;
}

/// How a tool points in the grid, from its z axis.
struct Way {
  const char* name;
  Mat3 R_WT;
};
inline const std::vector<Way> kWays = {
    {"10 deg", Eigen::AngleAxisd(10 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"45 deg", Eigen::AngleAxisd(45 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"<111>", Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(1, 1, 1)).toRotationMatrix()},
};
inline const Vec3 kOffGrid(0.0293 * units::mm, 0.0113 * units::mm, 0);  // [m] of a tool's axis, in its own axes

/// What of a box is where `distance` [m] is negative, of one material.
template <class Distance>
Workpiece body(const Box& box, double voxel, const Material& material, const Distance& distance) {
  return build_body({box, distance, [](const Vec3&) { return MaterialId(1); }}, voxel, MaterialTable({material}));
}

/// A step of the hand with the tool upright.
inline const StepResult& step_to(Simulation& simulation, const Vec3& p_WHo, const Vec3& velocity = Vec3::Zero()) {
  return simulation.step(Pose::from_translation(p_WHo), {velocity, Vec3::Zero()}, kTick);
}

}  // namespace hapticut::test
