// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hapticut/tool/profile_table.hpp"

namespace hapticut {

namespace detail {
class Meridian;
}

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
  static constexpr char kWord[] = "profile", kName[] = "ProfileHead";

  /// @param tolerance  [1] bound on the error of depths, relative to the smaller of largest radius and height,
  ///                   1e-4 ... 0.1; only points where three edges are equally near have an error
  /// @throws Error if the profile is not closed, crosses its axis or itself, runs in the wrong direction, has an edge
  ///         without length, an arc whose radius cannot span its ends, or no cutting edge
  explicit ProfileHead(Profile profile, double tolerance = 0.01);

  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] const ProfileTable& table() const { return *table_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }  ///< [1] bound on the relative error of depths

  [[nodiscard]] HeadBox bounding_box() const {
    return HeadBox::around_axis(table_->radius, table_->bottom, table_->top);
  }
  [[nodiscard]] double tip() const { return profile_.tip; }  ///< [m] z of the starting point
  [[nodiscard]] const std::vector<ProfileEdge>& edges() const { return profile_.edges; }
  [[nodiscard]] double volume() const { return volume_; }  ///< [m^3] inside the profile, exact (Pappus)
  [[nodiscard]] double reach() const { return reach_; }    ///< [m] largest distance from the frame's origin, exact

  /// [m] Largest rho of the cutting edges, exact.
  [[nodiscard]] double cutting_radius() const { return cutting_radius_; }

  [[nodiscard]] std::string description() const {
    return "a profile of radius " + detail::in_mm(table_->radius) + " and height " +
           detail::in_mm(double(table_->top) - double(table_->bottom));
  }

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

namespace formulas {
/// Calls `function(springs)` with the springs of a profile.
template <class Real, class Function>
decltype(auto) with_springs(const ProfileHead& head, const Function& function) {
  return function(ProfileSprings<Real>(head.table()));
}
}  // namespace formulas

}  // namespace hapticut
