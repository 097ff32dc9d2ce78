// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openvdb/Grid.h>

#include "hapticut/workpiece/block.hpp"

/// @file
/// Conversion between OpenVDB transforms and GridFrame.
namespace hapticut {

/// @param unit  [m] length of one world unit of the transform
[[nodiscard]] openvdb::math::Transform::Ptr transform_of(const GridFrame& frame, double unit);

/// @throws Error if the transform is not a combination of one voxel size, a rotation and a translation
[[nodiscard]] GridFrame frame_of(const openvdb::math::Transform& transform, double unit);

}  // namespace hapticut
