// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bench/fixtures.hpp"
#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Simple experiments: a head held still in a half space, or fed along a line through a block.
namespace hapticut::validation {

namespace forms = closed_forms;
using fixtures::feed;
using fixtures::hold;
using fixtures::kStiffness;
using fixtures::plain_material;
using fixtures::static_config;
using fixtures::SteadyState;

inline constexpr double kR = 1 * units::mm;  // [m] of the heads, where nothing else is said
inline constexpr double kTick = 1e-3;        // [s]

/// The half space z < 0 under a head, on a grid whose lines match neither the surface nor the head.
inline Workpiece half_space(double reach, double depth, double voxel, const Material& material = plain_material()) {
  const double side = reach + 2.3 * voxel;
  return build_block({Vec3(-side, -side - 0.37 * voxel, -depth - 2.61 * voxel), Vec3(side, side, 0)}, voxel, material);
}

}  // namespace hapticut::validation
