// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/profile.hpp"

#include "hapticut/core/errors.hpp"
#include "tool/meridian.hpp"

namespace hapticut {

ProfileHead::ProfileHead(Profile profile, double tolerance) : profile_(std::move(profile)), tolerance_(tolerance) {
  require_between(tolerance, 1e-4, 0.1, "ProfileHead tolerance [1]");
  auto meridian = std::make_shared<const detail::Meridian>(profile_);
  volume_ = meridian->volume();
  reach_ = meridian->reach();
  require_metres(reach_, kMaxHeadReach, "reach of the head [m]");  // before the table, which takes time
  cutting_radius_ = meridian->cutting_radius();
  table_ = std::make_shared<const ProfileTable>(detail::make_profile_table(*meridian, tolerance));
  meridian_ = std::move(meridian);
}

MeridianSpring<double> ProfileHead::exact_spring(double rho, double z) const {
  const detail::Vec2 x(rho, z);
  const MeridianSpring<double> outside = {-1, 1, 0};
  if (!(ProfileSprings<double>(*table_).margin(rho, z) > 0)) return outside;
  const std::size_t curve = meridian_->nearest(x);
  if (curve == detail::Meridian::kNone) return outside;
  const detail::MeridianCurve& nearest = meridian_->curves()[curve];
  MeridianSpring<double> spring = nearest.spring(x);
  spring.depth = formulas::depth_below(spring.depth, nearest.scale());
  if (nearest.smooth()) spring.smooth = formulas::square_from_corners(table_->exact_corners, rho, z);
  return spring;
}

}  // namespace hapticut
