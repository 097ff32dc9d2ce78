// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/mesh.hpp"
#include "hapticut/tool/profile.hpp"

namespace hapticut {

/// A profile found in a mesh.
struct RecognizedProfile {
  Profile profile;   ///< tip at z = 0; all edges cut but a flat last one, the shank's side
  Pose X_MT;         ///< pose of the head's frame in the frame of the mesh: origin at the tip, +z to the shank
  double deviation;  ///< [m] greatest distance found between the mesh and the body of the profile
};

/// Recognises a closed mesh as a body of revolution: its axis (the line about which a rotation moves the surface along
/// itself: least squares over the facets), its meridian (a cut from the axis to the axis, moved out to the vertices,
/// which lie on the surface while facets lie below it), and the straight lines and arcs of that.
/// @param towards_shank  in the frame of the mesh: which end of the axis is the shank's, and the axis of a ball
/// @param tolerance      [1] of the largest radius, 1e-4 ... 0.1: by how much the mesh may be off
/// @throws Error when the mesh is empty or open, when its axis does not pass through it once, or when it is not a body
///         of revolution; the message says how far it is off
[[nodiscard]] RecognizedProfile profile_from_mesh(const TriangleMesh& mesh, const Vec3& towards_shank = Vec3::UnitZ(),
                                                  double tolerance = 0.02);

/// The closed surface of a profile, its vertices on the surface.
/// @param sides  3 ... 10000 facets around the axis; arcs are divided as finely
[[nodiscard]] TriangleMesh mesh_of_revolution(const Profile& profile, int sides);

}  // namespace hapticut
