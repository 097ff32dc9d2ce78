// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openvdb/Grid.h>

#include "hapticut/workpiece/block.hpp"

/// @file
/// How OpenVDB transforms and GridFrame translate into each other.
namespace hapticut {

/// @param unit  [m] length of one world unit of the transform
[[nodiscard]] openvdb::math::Transform::Ptr transform_of(const GridFrame& frame, double unit);

/// @throws Error when the transform is anything else than one voxel size, a rotation and a translation
[[nodiscard]] GridFrame frame_of(const openvdb::math::Transform& transform, double unit);

}  // namespace hapticut
