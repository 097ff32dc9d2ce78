// SPDX-License-Identifier: Apache-2.0
// A tool that is fed along a line through the grid, in any direction of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut::test {

struct Way {
  const char* name;
  Mat3 R_WT;  // from its z axis, how the tool points in the grid
};
inline const std::vector<Way> kWays = {
    {"10 deg", Eigen::AngleAxisd(10 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"45 deg", Eigen::AngleAxisd(45 * units::deg, Vec3::UnitY()).toRotationMatrix()},
    {"<111>", Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(1, 1, 1)).toRotationMatrix()},
};

/// Means and ripple of the force along and across the tool's axis while it is fed along a line.
struct Fed {
  Vec3 force_T = Vec3::Zero(), ripple_T = Vec3::Zero(), torque_T = Vec3::Zero();
  EnergyLedger energy;
};
inline Fed feed_along(Simulation& simulation, const Mat3& R_WT, const Vec3& start, const Vec3& velocity, double travel,
                      double from, double dt = 1e-3) {
  std::vector<Vec3> forces;
  Fed fed;
  const int steps = int(std::lround(travel / (velocity.norm() * dt)));
  for (int n = 0; n < steps; ++n) {
    Pose pose;
    pose.rotation = R_WT;
    pose.translation = start + velocity * (dt * (n + 1));
    const StepResult& result = simulation.step(pose, {velocity, Vec3::Zero()}, dt);
    if (n < from * steps) continue;
    forces.push_back(R_WT.transpose() * result.force);
    fed.torque_T += R_WT.transpose() * result.torque;
  }
  const double count = double(forces.size());
  for (const Vec3& f : forces) fed.force_T += f / count;
  for (const Vec3& f : forces) fed.ripple_T += (f - fed.force_T).cwiseAbs2() / count;
  fed.ripple_T = fed.ripple_T.cwiseSqrt();
  fed.torque_T /= count;
  fed.energy = simulation.last_result().energy;
  return fed;
}

/// [m/s] how fast a tool comes down that a hand pushes through a damper, and [N] the force that it feels meanwhile.
struct Pushed {
  double speed, force;
};
inline Pushed push_down(Simulation& simulation, double hand_force) {
  const double damper = 1000;  // [N s/m] of the hand, soft against a layer of bone and firm against its own push
  double z = 0.001 * units::mm, speed = 0, force = 0, mean_force = 0, begin = 0;
  constexpr double kTick = 1e-4, kFastest = 5 * units::mm;
  constexpr int kTicks = 8000, kFrom = 4000;
  for (int n = 0; n < kTicks; ++n) {
    speed = (hand_force - force) / damper;
    z -= std::clamp(speed, -kFastest, kFastest) * kTick;
    const Pose pose = Pose::from_translation({0.0293 * units::mm, 0.0113 * units::mm, z});
    force = simulation.step(pose, {{0, 0, -speed}, Vec3::Zero()}, kTick).force.z();
    if (n == kFrom) begin = z;
    if (n >= kFrom) mean_force += force / (kTicks - kFrom);
  }
  return {(begin - z) / (kTick * (kTicks - kFrom)), mean_force};
}

}  // namespace hapticut::test
