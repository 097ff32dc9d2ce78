// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "hapticut/core/description.hpp"
#include "hapticut/force/effects/output_limits.hpp"
#include "hapticut/safety/device_state.hpp"

/// @file
/// Mechanical models of devices and of the hand that holds them. The mock device and the closed loop in simulated time
/// use them.
namespace hapticut {

/// The mechanics of a device, equal along all axes: an apparent mass at the tip with viscous and dry friction, read
/// through an encoder.
struct DeviceModel {
  std::string_view name;               ///< name for device_model
  double mass = 0;                     ///< [kg] apparent at the tip
  double damping = 0;                  ///< [N s/m] viscous
  double dry_friction = 0;             ///< [N] Coulomb
  double encoder_step = 0;             ///< [m] resolution of positions
  double peak_force = 0;               ///< [N] maximum of the motors
  double continuous_force = 0;         ///< [N] that the motors give permanently
  double rendered_stiffness = 0;       ///< [N/m] maximum that the device is said to render
  double rendered_damping = 0;         ///< [N s/m] maximum that the device is said to render
  double rotational_inertia = 2e-5;    ///< [kg m^2] inertia of the gimbal
  double rotational_damping = 2e-4;    ///< [N m s/rad] damping of the gimbal
  double peak_torque = 0;              ///< [N m] 0: the gimbal has no motors
  double workspace_half_width = 0.08;  ///< [m] half the edge of the cube around the origin
  double continuous_torque = 0;        ///< [N m] that the motors of the gimbal give permanently
  /// [N m] largest torque about the stylus, whose motor is weaker; peak_torque is about the axes across it
  double peak_roll_torque = 0;
};

constexpr auto fields_of(Of<DeviceModel>) {
  using M = DeviceModel;
  return std::tuple{
      field("name", &M::name, "name for device_model"),
      field("mass", &M::mass, "kg", Range::positive(), "apparent at the tip"),
      field("damping", &M::damping, "N s/m", Range::not_negative(), "viscous"),
      field("dry_friction", &M::dry_friction, "N", Range::not_negative(), "Coulomb"),
      field("encoder_step", &M::encoder_step, "m", Range::not_negative(), "resolution of positions"),
      field("peak_force", &M::peak_force, "N", Range::not_negative(), "maximum of the motors"),
      field("continuous_force", &M::continuous_force, "N", Range::not_negative(), "that the motors give permanently"),
      field("rendered_stiffness", &M::rendered_stiffness, "N/m", Range::not_negative(),
            "maximum that the device is said to render"),
      field("rendered_damping", &M::rendered_damping, "N s/m", Range::not_negative(),
            "maximum that the device is said to render"),
      field("rotational_inertia", &M::rotational_inertia, "kg m^2", Range::positive(), "inertia of the gimbal"),
      field("rotational_damping", &M::rotational_damping, "N m s/rad", Range::not_negative(), "damping of the gimbal"),
      field("peak_torque", &M::peak_torque, "N m", Range::not_negative(), "0: the gimbal has no motors"),
      field("workspace_half_width", &M::workspace_half_width, "m", Range::not_negative(),
            "half the edge of the cube around the origin"),
      field("continuous_torque", &M::continuous_torque, "N m", Range::not_negative(),
            "that the motors of the gimbal give permanently"),
      field("peak_roll_torque", &M::peak_roll_torque, "N m", Range::not_negative(),
            "largest torque about the stylus, whose motor is weaker; peak_torque is about the axes across it"),
  };
}

/// What the motors of the gimbal make of a torque.
/// @param axis  [1] of the stylus
/// @param torque  [N·m] about the stylus point
/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Vec3 rendered_torque(const DeviceModel& model, const Vec3& axis, const Vec3& torque) noexcept {
  const double roll = torque.dot(axis), limit = std::min(model.peak_roll_torque, model.peak_torque);
  return saturated(Vec3(torque - roll * axis), model.peak_torque) + std::clamp(roll, -limit, limit) * axis;
}

/// The presets `touch`, `premium15`, `premium6dof` and `omega`. They follow published data where available. The omega
/// is an estimate for its class (docs/devices.md).
[[nodiscard]] std::span<const DeviceModel> device_models();

/// The device preset of a name.  @throws Error that lists the known names
[[nodiscard]] const DeviceModel& device_model(std::string_view name);

/// The capabilities that a device of this model would report.
[[nodiscard]] DeviceCapabilities capabilities(const DeviceModel& model);

/// A hand: a mass that a spring and a damper pull to a set point. It is bonded to the stylus (`pad_stiffness` 0), or
/// coupled through the soft pad of the fingers.
struct HandModel {
  std::string_view name;         ///< name for hand_model
  double mass = 0;               ///< [kg] mass of the hand; with a pad it must not be 0
  double damping = 0;            ///< [N s/m] damping of the hand's motion
  double stiffness = 0;          ///< [N/m] towards the set point
  double pad_stiffness = 0;      ///< [N/m] stiffness between stylus and hand; 0: bonded
  double pad_damping = 0;        ///< [N s/m] damping between stylus and hand
  double inertia = 0;            ///< [kg m^2] that the fingers add to the gimbal
  double angular_damping = 0;    ///< [N m s/rad] that the fingers add to the gimbal
  double angular_stiffness = 0;  ///< [N m/rad] towards the orientation of the set point
};

constexpr auto fields_of(Of<HandModel>) {
  using M = HandModel;
  return std::tuple{
      field("name", &M::name, "name for hand_model"),
      field("mass", &M::mass, "kg", Range::not_negative(), "mass of the hand; with a pad it must not be 0"),
      field("damping", &M::damping, "N s/m", Range::not_negative(), "damping of the hand's motion"),
      field("stiffness", &M::stiffness, "N/m", Range::not_negative(), "towards the set point"),
      field("pad_stiffness", &M::pad_stiffness, "N/m", Range::not_negative(),
            "stiffness between stylus and hand; 0: bonded"),
      field("pad_damping", &M::pad_damping, "N s/m", Range::not_negative(), "damping between stylus and hand"),
      field("inertia", &M::inertia, "kg m^2", Range::not_negative(), "that the fingers add to the gimbal"),
      field("angular_damping", &M::angular_damping, "N m s/rad", Range::not_negative(),
            "that the fingers add to the gimbal"),
      field("angular_stiffness", &M::angular_stiffness, "N m/rad", Range::not_negative(),
            "towards the orientation of the set point"),
  };
}

/// The presets `released`, `light`, `nominal`, `firm`, and `light-pad`, `nominal-pad`, `firm-pad` with the pad of the
/// fingers.
[[nodiscard]] std::span<const HandModel> hand_models();

/// The hand preset of a name.  @throws Error that lists the known names
[[nodiscard]] const HandModel& hand_model(std::string_view name);

}  // namespace hapticut
