// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// Where a ray first meets material: see Workpiece::first_hit.
struct RayHit {
  double distance = 0;           ///< [m] from the origin of the ray; 0 if the origin is in the material
  Vec3 point_W = Vec3::Zero();   ///< [m] position in W
  Vec3 normal_W = Vec3::Zero();  ///< [1] unit vector out of the material, in W; zero deep inside the material
  MaterialId material = kEmpty;  ///< that was met
};

}  // namespace hapticut
