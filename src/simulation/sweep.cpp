// SPDX-License-Identifier: Apache-2.0
// The sub-steps of a step.
#include <algorithm>
#include <cmath>
#include <variant>

#include "simulation/hand_motion.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr double kLayerShare = 0.25;  // [1] largest motion of a rim in a slice of a sub-step, over the crushed layer
constexpr int kMaxForLayer = 4;       // slices of a step; more would take too much time

/// [m] Upper bound on the motion of a point of the head.
double farthest_between(const Pose& from, const Pose& to, const Tool& tool) noexcept {
  const Vec3 head_shift = to * tool.X_HT().translation - from * tool.X_HT().translation;
  return head_shift.norm() + rotation_between(from, to) * tool.head().reach();
}

}  // namespace

/// The sub-steps in which no point of the head moves farther than half a voxel; while a standing head may crush
/// material, in slices of a quarter of the layer that it crushes. What a rim passes in one step is met by the face
/// behind the rim, which moves along the material and does not crush it.
Sweep Simulation::State::plan_sweep(const Pose& from, const Pose& to) const noexcept {
  const StageTimer timer = timed(&StageTimes::plan_sweep);
  Sweep sweep = sweep_between(from, to);
  if (crushing_depth == 0) return sweep;
  const double wanted = std::ceil(farthest_between(from, to, tool) / (kLayerShare * crushing_depth)) / sweep.sub_steps;
  sweep.slices = std::max(1, int(std::min(wanted, double(kMaxForLayer) / sweep.sub_steps)));
  return sweep;
}

/// The sub-steps in which no point of the head moves farther than half a voxel; max_sweep + 1 if they are more.
Sweep Simulation::State::sweep_between(const Pose& from, const Pose& to) const noexcept {
  const double half_voxels = farthest_between(from, to, tool) / (0.5 * workpiece.voxel_size());
  return {int(std::clamp(std::ceil(half_voxels - 1e-9), 1.0, config.max_sweep + 1.0)), 1 / std::max(1.0, half_voxels)};
}

}  // namespace hapticut
