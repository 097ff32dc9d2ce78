// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/fixtures.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// A tool whose spindle stands, held still in a workpiece whose grid is misaligned with it, and how the error of its
/// wrench falls with the voxel size.
namespace hapticut::test {

using fixtures::kStiffness;
using fixtures::static_config;

/// Materials of the given relative stiffnesses, and nothing else that matters to a standing head.
inline MaterialTable materials_of_stiffness(const std::vector<double>& relative_stiffnesses) {
  MaterialTable table;
  for (const double stiffness : relative_stiffnesses) {
    Material material;
    material.name = "stiffness " + std::to_string(table.size());
    material.relative_stiffness = stiffness;
    table.add(material);
  }
  return table;
}

using MaterialAt = std::function<MaterialId(const Vec3& p_VQ)>;

/// A box along the axes of a grid that lies anywhere in the world and need not match the box: the fill of each voxel is
/// the product of its covered lengths, the centroid the middle of the covered part, both exact. Written again here,
/// without the library's builders.
/// @param box_V        [m] in the axes of the grid, from the centre of voxel (0,0,0)
/// @param material_at  material at the centroid of a voxel, in the same frame; null: material 1 everywhere
inline Workpiece box_on_grid(const Box& box_V, const GridFrame& frame, MaterialTable materials,
                             const MaterialAt& material_at = nullptr) {
  const double l = frame.voxel_size;
  IndexBox domain;
  for (int axis = 0; axis < 3; ++axis) {
    domain.min[axis] = int(std::ceil(box_V.min[axis] / l - 0.5 + 1e-9));
    domain.max[axis] = int(std::floor(box_V.max[axis] / l + 0.5 - 1e-9));
  }
  const auto fill_block = [&](const VoxelIndex& origin, BlockContent& content) {
    std::array<std::array<double, kBlockEdge>, 3> length, middle;  // [voxel edges]
    bool full = true;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kBlockEdge; ++i) {
        const int index = origin[axis] + i;
        const double low = std::max(-0.5, box_V.min[axis] / l - index);
        const double high = std::min(0.5, box_V.max[axis] / l - index);
        length[axis][i] = std::max(0.0, high - low);
        middle[axis][i] = (low + high) / 2;
        full &= length[axis][i] > 1 - 1e-9;
      }
    if (full && !material_at) return BlockKind::solid(1);
    for (int n = 0; n < kBlockVoxels; ++n) {
      const auto [i, j, k] = place_in_block(n);
      const double fill = length[0][i] * length[1][j] * length[2][k];
      const Vec3 offset(middle[0][i], middle[1][j], middle[2][k]);
      const Vec3 centroid = l * (Vec3(origin[0] + i, origin[1] + j, origin[2] + k) + offset);
      content.material[n] = fill > 1e-9 ? (material_at ? material_at(centroid) : MaterialId(1)) : kEmpty;
      content.fill[n] = float(fill);
      content.centroid[n] = fill < 1 ? CentroidOffset::from_offset(offset) : CentroidOffset{};
    }
    return BlockKind::mixed();
  };
  return Workpiece::from_blocks(domain, frame, std::move(materials), fill_block);
}

/// A box in the world on a grid along its axes whose lines are `phase` voxels away from the world's origin.
inline Workpiece box_at_phase(const Box& box, double voxel_size, const Vec3& phase,
                              MaterialTable materials = materials_of_stiffness({1}),
                              const MaterialAt& material_at = nullptr) {
  const Vec3 shift = voxel_size * (phase + Vec3::Constant(0.5));
  const MaterialAt in_grid =
      material_at ? MaterialAt([&](const Vec3& p_VQ) { return material_at(p_VQ + shift); }) : nullptr;
  return box_on_grid({box.min - shift, box.max - shift}, {voxel_size, Pose::from_translation(shift)},
                     std::move(materials), in_grid);
}

/// The half space z < 0, as a box that a head of this reach does not leave while its deepest point is at `depth`.
inline Box half_space(double lateral_reach, double depth, double voxel_size) {
  const double side = lateral_reach + 2 * voxel_size;
  return {Vec3(-side, -side, -depth - 2 * voxel_size), Vec3(side, side, 0)};
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

/// Errors at three sizes, each half of the one before: of voxels, or of whatever else is refined.
struct Convergence {
  std::array<double, 3> size;   // [m]
  std::array<double, 3> error;  // [1] relative, root mean square over the grid phases

  /// p of error ~ size^p, from the coarsest to the finest.
  [[nodiscard]] double order() const { return std::log(error[0] / error[2]) / std::log(size[0] / size[2]); }
};

/// Number of grid phases over which errors are averaged: the error of one phase oscillates with the voxel size, and
/// only its root mean square has an order.
inline constexpr int kPhases = 12;

/// Evenly spread phases (the additive recurrence of the plastic number, in three dimensions).
inline Vec3 phase(int n) {
  const double g = 1.22074408460575947536;
  const auto fraction = [](double v) { return v - std::floor(v); };
  return {fraction(0.5 + (n + 1) / g), fraction(0.5 + (n + 1) / (g * g)), fraction(0.5 + (n + 1) / (g * g * g))};
}

/// @param relative_error  of one voxel size [m] and phase
inline Convergence converge(double coarsest, const std::function<double(double, const Vec3&)>& relative_error) {
  Convergence c;
  double voxel_size = coarsest;
  for (std::size_t level = 0; level < 3; ++level, voxel_size /= 2) {
    double sum = 0;
    for (int n = 0; n < kPhases; ++n) {
      const double e = relative_error(voxel_size, phase(n));
      sum += e * e;
    }
    c.size[level] = voxel_size;
    c.error[level] = std::sqrt(sum / kPhases);
  }
  return c;
}

/// Checks that the error falls at least with an order, and is below a bound everywhere.
/// @param bound  [1] of the relative error, for a size [m]
inline void expect_convergence(const Convergence& c, double least_order, const std::function<double(double)>& bound) {
  EXPECT_GE(c.order(), least_order) << "errors " << c.error[0] << ", " << c.error[1] << ", " << c.error[2];
  for (std::size_t level = 0; level < 3; ++level)
    EXPECT_LE(c.error[level], bound(c.size[level])) << "at " << c.size[level] / units::mm << " mm";
  testing::Test::RecordProperty("order", std::to_string(c.order()));
  testing::Test::RecordProperty("relative_error_at_finest", std::to_string(c.error[2]));
}

/// The same with the bound `constant * (l / length)^2`.
inline void expect_convergence(const Convergence& c, double least_order, double constant, double length) {
  expect_convergence(c, least_order, [=](double l) { return constant * std::pow(l / length, 2); });
}

}  // namespace hapticut::test
