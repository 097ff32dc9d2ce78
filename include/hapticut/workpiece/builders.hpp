// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Workpieces from shapes. Surfaces are antialiased: a voxel that the surface cuts gets the fraction of it that is
/// filled and the centroid of that part, by subsampling.
namespace hapticut {

/// An axis-aligned box in W.
struct Box {
  Vec3 min;  ///< [m]
  Vec3 max;  ///< [m]
};

/// A body described by functions of the position in W.
struct BodyDescription {
  Box box;  ///< contains the whole body
  /// [m] negative inside, positive outside; must not change faster than the position does (a distance, or a bound of
  /// it).
  std::function<double(const Vec3& p_WQ)> distance;
  /// Material at a point inside. Called from several threads at once.
  std::function<MaterialId(const Vec3& p_WQ)> material;
};

/// Builds any body described by functions.
/// @param subsamples  rows per voxel edge added up in a voxel that the surface cuts, 1 ... 32; a face along the grid is
///                    exact from 2 on; 1: voxels are full when their centre is inside, and empty otherwise
/// @throws Error when the voxel size is not positive, the box is empty or not finite, or there would be too many voxels
[[nodiscard]] Workpiece build_body(const BodyDescription& body, double voxel_size, MaterialTable materials,
                                   int subsamples = 8);

/// A solid block. Voxel (i, j, k) is centred at `min + ((i+.5) h, (j+.5) h, (k+.5) h)`; a last row of voxels that the
/// block fills only partly is filled by that fraction.
[[nodiscard]] Workpiece build_block(const Box& box, double voxel_size, Material material);

/// A block made of horizontal layers, from the top down.
struct Layer {
  Material material;
  double thickness;  ///< [m] > 0
};
/// @param top  upper face and horizontal extent: layers go down from `box.max.z`; below the last one there is nothing,
///             and the box's own lower face cuts what would reach beyond it
[[nodiscard]] Workpiece build_layered_slab(const Box& box, double voxel_size, const std::vector<Layer>& layers);

/// A ball.
[[nodiscard]] Workpiece build_sphere(const Vec3& center, double radius, double voxel_size, Material material);

}  // namespace hapticut
