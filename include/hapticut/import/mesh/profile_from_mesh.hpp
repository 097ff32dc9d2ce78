// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/profile.hpp"

namespace hapticut {

/// The result of `profile_from_mesh`.
struct RecognizedProfile {
  Profile profile;   ///< tip at z = 0; all edges cut, except a flat last edge on the shank's side
  Pose X_MT;         ///< pose of the head's frame in the frame of the mesh: origin at the tip, +z to the shank
  double deviation;  ///< [m] largest distance found between the mesh and the body of the profile
};

/// Recognises a closed mesh as a body of revolution, in three steps:
/// 1. The axis: a rotation about it moves the surface along itself (least squares over the facets).
/// 2. The meridian: a cut from axis to axis, moved out to the vertices, because vertices lie on the true surface and
///    facets lie below it.
/// 3. The straight lines and arcs that fit the meridian.
/// @param towards_shank  direction in the frame of the mesh that selects the shank's end of the axis; for a ball, it is
///                       the axis
/// @param tolerance      [1] allowed deviation of the mesh over its largest radius, 1e-4 ... 0.1
/// @throws Error if the mesh is empty or open, if its axis does not pass through it exactly once, or if it is not a
///         body of revolution; the message contains the deviation
[[nodiscard]] RecognizedProfile profile_from_mesh(const TriangleMesh& mesh, const Vec3& towards_shank = Vec3::UnitZ(),
                                                  double tolerance = 0.02);

}  // namespace hapticut
