// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/spatial.hpp"

/// @file
/// The library's frame `D` (x towards the user, y to the right, z up) and the base frame `B` that all devices of
/// hapticut have (x to the right, y up, z towards the user).
namespace hapticut::force_dimension {

/// Converts a vector from D to B.
[[nodiscard]] inline Vec3 to_base(const Vec3& v_D) { return {v_D.y(), v_D.z(), v_D.x()}; }

/// Converts a vector from B to D.
[[nodiscard]] inline Vec3 to_library(const Vec3& v_B) { return {v_B.z(), v_B.x(), v_B.y()}; }

/// Converts the orientation of the stylus. The axes of both of its frames are permuted, so that the identity stays the
/// identity.
[[nodiscard]] inline Mat3 to_base(const Mat3& R_D) {
  Mat3 R;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) R(row, column) = R_D((row + 1) % 3, (column + 1) % 3);
  return R;
}

}  // namespace hapticut::force_dimension
