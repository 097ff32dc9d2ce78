// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

/// @file
/// Directions of the grid along which a tool is fed.
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

inline const Vec3 kOffGrid(0.0293 * units::mm, 0.0113 * units::mm, 0);  // [m] of a tool's axis, in its own axes

}  // namespace hapticut::test
