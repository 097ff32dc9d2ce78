// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "hapticut/loop/workspace_map.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut {

/// Which axis of the device's base points up.
enum class Up { y, z };

/// The axis-parallel box in W around all voxels that are not empty; a point at the origin if all are empty.
[[nodiscard]] inline Box box_of_workpiece(const Workpiece& workpiece) {
  const IndexBox bounds = workpiece.bounds();
  const GridFrame& frame = workpiece.frame();
  Box box{Vec3::Zero(), Vec3::Zero()};
  for (int corner = 0; corner < 8 && !bounds.empty(); ++corner) {
    Vec3 p_V;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p_V[int(axis)] = (corner >> axis & 1) != 0 ? bounds.max[axis] + 0.5 : bounds.min[axis] - 0.5;
    const Vec3 p_W = frame.X_WV * (frame.voxel_size * p_V);
    box.min = corner == 0 ? p_W : box.min.cwiseMin(p_W).eval();
    box.max = corner == 0 ? p_W : box.max.cwiseMax(p_W).eval();
  }
  return box;
}

/// A map whose base origin puts the head of the tool on the middle of the workpiece's top.
/// @param scale  metres in the world per metre of the hand
[[nodiscard]] inline WorkspaceMapOptions map_above(const DeviceCapabilities& capabilities, const Box& box,
                                                   const Tool& tool, Up up, double scale) {
  WorkspaceMapOptions map;
  map.scale = scale;
  if (up == Up::y)
    map.X_WB.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // +x stays, up (+y) becomes +z, towards the user (+z) becomes -y
  const HeadBox head = tool.head().bounding_box();
  const Vec3 aside = tool.X_HT() * Vec3(0.5 * (head.min + head.max));  // head's middle in H; aside with an L handle
  double lowest = aside.z();
  for (const double x : {head.min.x(), head.max.x()})
    for (const double y : {head.min.y(), head.max.y()})
      for (const double z : {head.min.z(), head.max.z()}) lowest = std::min(lowest, (tool.X_HT() * Vec3(x, y, z)).z());
  map.X_WB.translation = Vec3(0.5 * (box.min.x() + box.max.x()) - aside.x(),
                              0.5 * (box.min.y() + box.max.y()) - aside.y(), box.max.z() - lowest);
  if (capabilities.input_degrees_of_freedom < 6) {
    map.orientation = false;
    map.X_SH.rotation = map.X_WB.rotation.transpose();  // the tool stands upright
  }
  return map;
}

}  // namespace hapticut
