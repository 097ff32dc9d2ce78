// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Workpieces from shapes. Surfaces are antialiased: a voxel that the surface cuts gets its filled fraction and the
/// centroid of the filled part, by subsampling.
namespace hapticut {

/// An axis-aligned box in W.
struct Box {
  Vec3 min;  ///< [m]
  Vec3 max;  ///< [m]
};

/// A body described by functions of the position in W.
struct BodyDescription {
  Box box;  ///< contains the whole body
  /// [m] Signed distance, or a lower bound of its magnitude: negative inside, positive outside. It must change by at
  /// most 1 m per metre.
  std::function<double(const Vec3& p_WQ)> distance;
  /// Material at a point inside. Called from several threads at the same time.
  std::function<MaterialId(const Vec3& p_WQ)> material;
};

/// Builds any body described by functions.
/// @param subsamples  rows per voxel edge that are summed in a voxel that the surface cuts, 1 ... 32. A face along the
///                    grid is exact with 2 or more. With 1, a voxel is full if its centre is inside, and empty
///                    otherwise
/// @throws Error if the voxel size is not positive, the box is empty or not finite, or there would be too many voxels
[[nodiscard]] Workpiece build_body(const BodyDescription& body, double voxel_size, MaterialTable materials,
                                   int subsamples = 8);

/// A solid block. Voxel (i, j, k) is centred at `min + ((i+.5) h, (j+.5) h, (k+.5) h)`; a last row of voxels that the
/// block covers only partly is filled to that fraction.
[[nodiscard]] Workpiece build_block(const Box& box, double voxel_size, Material material);

/// One layer of `build_layered_slab`.
struct Layer {
  Material material;
  double thickness;  ///< [m] > 0
};
/// A slab of horizontal layers, from the top down.
/// @param box     horizontal extent and upper face. Layers go down from `box.max.z` and end at `box.min.z`; below the
///                last layer the slab is empty
/// @param layers  from the top down. A row of voxels that two of them share is of the one with the larger part
/// @throws Error also when a layer within the box is too thin to be the larger part of any row of voxels
[[nodiscard]] Workpiece build_layered_slab(const Box& box, double voxel_size, const std::vector<Layer>& layers);

/// A ball.
[[nodiscard]] Workpiece build_sphere(const Vec3& center, double radius, double voxel_size, Material material);

}  // namespace hapticut
