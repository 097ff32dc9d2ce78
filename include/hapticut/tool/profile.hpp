// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/tool/profile_table.hpp"

namespace hapticut {

namespace detail {
class Meridian;
}

/// Whether an edge of a profile cuts.
enum class EdgeKind {
  cutting,  ///< the edge presses and cuts
  smooth    ///< safe side, margin, neck or shank: presses and rubs, and cuts only close to a cutting edge
};

constexpr auto names_of(Of<EdgeKind>) {
  using enum EdgeKind;
  return std::array{
      Named{cutting, "cutting"},
      Named{smooth, "smooth"},
  };
}

/// One edge of a meridian. It begins at the end of the previous edge.
struct ProfileEdge {
  double rho = 0;  ///< [m] end: distance from the axis, >= 0
  double z = 0;    ///< [m] end: height
  /// [m] 0: straight; > 0: arc that bulges outwards; < 0: hollow arc. At most a half circle.
  double radius = 0;
  EdgeKind kind = EdgeKind::cutting;
};

/// The meridian of a body of revolution, in the tool frame: from its tip on the axis outwards, up and back to the axis
/// on the shank's side, with the body to the left.
///
///       z ^
///         +-----+       edges: tip -> (R, 0) -> (R, H) -> (0, H)
///         |     |
///         |     |
///     tip +-----+--> rho
///
struct Profile {
  double tip = 0;  ///< [m] z of the starting point, at rho = 0
  std::vector<ProfileEdge> edges;
};

/// A head of any profile of revolution.
///
/// The depth of a point inside the head is the smaller of two values: its distance from the cutting surface, and
/// kSmoothScale times its distance from the smooth surface. The direction points from the point to the surface that
/// gave the depth. ConeHead and FlatHead follow the same rule.
///
/// If the whole body lies on one side of a straight cutting edge, and the smooth edge next to it bends away, the edge
/// is extended as a straight line. Any other cutting edge ends at its end point, which is then the nearest point for
/// the region behind it. A smooth edge cuts within a land next to its cutting neighbours; this finishes the wall that
/// the corner leaves (HeadMotion, ContactMaterial::land).
class ProfileHead {
 public:
  /// @param tolerance  [1] bound on the error of depths, relative to the smaller of largest radius and height,
  ///                   1e-4 ... 0.1; only points where three edges are equally near have an error
  /// @throws Error if the profile is not closed, crosses its axis or itself, runs in the wrong direction, has an edge
  ///         without length, an arc whose radius cannot span its ends, or no cutting edge
  explicit ProfileHead(Profile profile, double tolerance = 0.01);

  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] const ProfileTable& table() const { return *table_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }  ///< [1] bound on the relative error of depths

  [[nodiscard]] double volume() const { return volume_; }  ///< [m^3] inside the profile, exact (Pappus)
  [[nodiscard]] double reach() const { return reach_; }    ///< [m] largest distance from the frame's origin, exact

  /// [m] Largest rho of the cutting edges, exact.
  [[nodiscard]] double cutting_radius() const { return cutting_radius_; }

  /// Depth and direction from all edges, without the table.  @realtime O(edges); for tests and set-up code
  [[nodiscard]] MeridianSpring<double> exact_spring(double rho, double z) const;

 private:
  Profile profile_;
  double tolerance_;
  double volume_ = 0;
  double reach_ = 0;
  double cutting_radius_ = 0;
  std::shared_ptr<const detail::Meridian> meridian_;
  std::shared_ptr<const ProfileTable> table_;
};

}  // namespace hapticut
