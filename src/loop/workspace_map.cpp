// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/workspace_map.hpp"

#include "hapticut/core/errors.hpp"

namespace hapticut {

CouplingGains gains_in_world(const CouplingGains& felt, const WorkspaceMapOptions& map) noexcept {
  CouplingGains gains = felt;
  const double scale = map.scale * map.force_scale;
  gains.stiffness /= scale;
  gains.damping /= scale;
  gains.mass /= scale;
  gains.max_force /= map.force_scale;
  gains.angular_stiffness /= map.torque_scale;
  gains.angular_damping /= map.torque_scale;
  gains.inertia /= map.torque_scale;
  gains.max_torque /= map.torque_scale;
  return gains;
}

WorkspaceMap::WorkspaceMap(const WorkspaceMapOptions& options) : options_(options), X_WS_home_(options.X_WB) {
  require_fields_within(options, "WorkspaceMapOptions::");
  constexpr double kInexact = 1e-6;
  for (const Pose& X : {options.X_WB, options.X_SH})
    if (!is_finite(X) || !is_rotation(X.rotation, kInexact))
      throw Error("WorkspaceMapOptions::X_WB"_name +
                  " or X_SH is not a pose; its rotation must be orthonormal and right-handed.");
}

Pose WorkspaceMap::stylus_in_world(const Pose& X_BS) const noexcept {
  if (!engaged_) return X_WS_home_;
  const Mat3& R_WB = options_.X_WB.rotation;
  Pose X_WS;
  X_WS.translation = X_WS_home_.translation + options_.scale * (R_WB * (X_BS.translation - X_BS_latch_.translation));
  X_WS.rotation = X_WS_home_.rotation;
  if (options_.orientation)
    X_WS.rotation = R_WB * (X_BS.rotation * X_BS_latch_.rotation.transpose()) * R_WB.transpose() * X_WS_home_.rotation;
  return X_WS;
}

void WorkspaceMap::latch(const Pose& X_BS, const Pose& X_WS) noexcept {
  X_WS_home_ = {orthonormalized(X_WS.rotation), X_WS.translation};  // rounding errors must not accumulate
  X_BS_latch_ = X_BS;
}

void WorkspaceMap::disengage(const Pose& X_BS) noexcept {
  if (!engaged_) return;
  latch(X_BS, stylus_in_world(X_BS));
  engaged_ = false;
}

void WorkspaceMap::engage(const Pose& X_BS) noexcept {
  latch(X_BS, stylus_in_world(X_BS));
  engaged_ = true;
}

void WorkspaceMap::place(const Pose& X_BS, const Pose& X_WH) noexcept { latch(X_BS, X_WH * options_.X_SH.inverse()); }

bool WorkspaceMap::set_scale(double scale, const Pose& X_BS) noexcept {
  if (!range_of(&WorkspaceMapOptions::scale).contains(scale)) return false;
  latch(X_BS, stylus_in_world(X_BS));
  options_.scale = scale;
  return true;
}

Pose WorkspaceMap::to_world(const Pose& X_BS) const noexcept { return stylus_in_world(X_BS) * options_.X_SH; }

Twist WorkspaceMap::to_world(const Pose& X_BS, const Twist& V_BS) const noexcept {
  if (!engaged_) return {};
  const Mat3& R_WB = options_.X_WB.rotation;
  Twist twist{options_.scale * (R_WB * V_BS.linear), Vec3::Zero()};
  if (options_.orientation) twist.angular = R_WB * V_BS.angular;
  return transport(twist, stylus_in_world(X_BS).rotation * options_.X_SH.translation);
}

Wrench WorkspaceMap::to_device(const Pose& X_BS, const Wrench& wrench) const noexcept {
  if (!engaged_) return {};
  const Mat3& R_WB = options_.X_WB.rotation;
  const Wrench about_stylus = transport(wrench, stylus_in_world(X_BS).rotation * options_.X_SH.translation);
  return {options_.force_scale * (R_WB.transpose() * about_stylus.force),
          options_.torque_scale * (R_WB.transpose() * about_stylus.torque)};
}

}  // namespace hapticut
