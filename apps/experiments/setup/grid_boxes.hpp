// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/workpiece/builders.hpp"

/// @file
/// Boxes whose faces do not lie between voxels.
namespace hapticut::test {

/// Materials with the given relative stiffnesses; other constants do not affect a standing head.
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

/// A box along the axes of a grid. The grid may be anywhere in the world, and its lines need not match the box. The
/// fill of each voxel is the product of its covered lengths, and the centroid is the middle of the covered part. Both
/// are exact. This code is independent of the library's builders.
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

/// The half space z < 0, as a box that contains a head of this reach while its deepest point is at `depth`.
inline Box half_space(double lateral_reach, double depth, double voxel_size) {
  const double side = lateral_reach + 2 * voxel_size;
  return {Vec3(-side, -side, -depth - 2 * voxel_size), Vec3(side, side, 0)};
}

/// Number of grid phases over which errors are averaged: the error of one phase oscillates with the voxel size, and
/// only its root mean square has an order.
inline constexpr int kPhases = 12;

/// Evenly spread phases (the additive recurrence of the plastic number, in three dimensions).
inline Vec3 phase(int n) {
  const double g = 1.22074408460575947536;
  const auto fraction = [](double v) { return v - std::floor(v); };
  return {fraction(0.5 + (n + 1) / g), fraction(0.5 + (n + 1) / (g * g)), fraction(0.5 + (n + 1) / (g * g * g))};
}

}  // namespace hapticut::test
