// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "bench/fixtures.hpp"
#include "bench/grid_boxes.hpp"
#include "hapticut/core/units.hpp"

/// @file
/// A tool whose spindle stands, held still in a workpiece whose grid is misaligned with it.
namespace hapticut::test {

using fixtures::box_at_phase;
using fixtures::box_on_grid;
using fixtures::kPhases;
using fixtures::kStiffness;
using fixtures::MaterialAt;
using fixtures::materials_of_stiffness;
using fixtures::phase;
using fixtures::static_config;

inline Box half_space(double lateral_reach, double depth, double voxel_size) {
  return fixtures::half_space_box(lateral_reach, depth, voxel_size);
}

/// `fixtures::hold`, of which the tests ask that it went well.
inline const StepResult& hold(Simulation& simulation, const Pose& X_WH, const Twist& velocity = {}) {
  const StepResult& result = fixtures::hold(simulation, X_WH, velocity);
  EXPECT_EQ(result.status, StepStatus::ok);
  EXPECT_EQ(result.sub_steps, 1);
  return result;
}

inline const StepResult& hold(Simulation& simulation, const Vec3& p_WHo, const Twist& velocity = {}) {
  return hold(simulation, Pose::from_translation(p_WHo), velocity);
}

}  // namespace hapticut::test
