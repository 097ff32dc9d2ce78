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

/// What an edge of a profile does.
enum class EdgeKind {
  cutting,  ///< presses and cuts
  smooth    ///< safe-sided, margin, neck or shank: presses and rubs, but cuts only close to a cutting edge
};

constexpr auto names_of(Of<EdgeKind>) {
  using enum EdgeKind;
  return std::array{
      Named{cutting, "cutting"},
      Named{smooth, "smooth"},
  };
}

/// One edge of a meridian, from the end of the edge before it.
struct ProfileEdge {
  double rho = 0;  ///< [m] end: distance from the axis, >= 0
  double z = 0;    ///< [m] end: height
  double radius =
      0;  ///< [m] 0: straight; > 0: arc that bulges outwards; < 0: hollow arc. Never more than a half circle
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
/// The depth of a point inside the head is its distance from the cutting surface or, if that is less, kSmoothScale
/// times its distance from the smooth one, and the direction is that from the point to the surface whose it is. So a
/// ConeHead and a FlatHead are profiles too.
///
/// A straight cutting edge that has the whole body on one side goes on as its line beyond a smooth edge that turns away
/// from it; of any other, the end is the nearest point of what lies behind. A smooth edge cuts within a land of its
/// cutting neighbours, which finishes the wall that the corner leaves (HeadMotion, ContactMaterial::land).
class ProfileHead {
 public:
  /// @param tolerance  [1] bound on the error of depths, relative to the smaller of largest radius and height, in
  ///                   1e-4 ... 0.1; only the points where three edges are equally near have any error
  /// @throws Error when the profile is not closed, crosses its axis or itself, runs the wrong way round, has an edge of
  ///         no length, an arc whose radius cannot span its ends, or no cutting edge
  explicit ProfileHead(Profile profile, double tolerance = 0.01);

  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] const ProfileTable& table() const { return *table_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }  ///< [1] that the table was made for

  [[nodiscard]] double volume() const { return volume_; }  ///< [m^3] inside the profile, exact (Pappus)
  [[nodiscard]] double reach() const { return reach_; }    ///< [m] greatest distance from the frame's origin, exact

  [[nodiscard]] double cutting_radius() const { return cutting_radius_; }  ///< [m] largest rho of what cuts, exact

  /// Depth and direction by asking every edge, without the table. For tests and set-up code: O(edges).
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
