// SPDX-License-Identifier: Apache-2.0
// A tool that is fed along a line through the grid, in any direction of it.
#pragma once

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

}  // namespace hapticut::test
