// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/builders.hpp"

/// @file
/// Bounding boxes of samples and voxels.
namespace hapticut {

/// The smallest box around the moved corners of a box.
/// @param moved  `moved(p)`: the new position of a corner p
template <class Moved>
[[nodiscard]] Eigen::AlignedBox3d box_of_moved(const Box& box, const Moved& moved) {
  const Eigen::AlignedBox3d given(box.min, box.max);
  Eigen::AlignedBox3d around;
  for (int n = 0; n < 8; ++n) around.extend(Vec3(moved(given.corner(Eigen::AlignedBox3d::CornerType(n)))));
  return around;
}

/// Indices of all samples.
template <class Value>
[[nodiscard]] IndexBox samples_of(const Volume<Value>& volume) {
  return {{0, 0, 0}, {volume.dims[0] - 1, volume.dims[1] - 1, volume.dims[2] - 1}};
}

}  // namespace hapticut
