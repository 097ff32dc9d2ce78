// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

/// A straight handpiece (thesis 5.11): the head sits on the axis of the stylus.
///
///         z_H ^  o  Ho  where the hand feels the wrench
///             |  |
///             |  |  length
///             |  |
///         z_T ^  o  To  origin of the tool head; its tip points down
///
struct RayHandle {
  double length = std::numeric_limits<double>::quiet_NaN();  ///< [m] must be given: from Ho to To, along -z_H
};

constexpr auto fields_of(Of<RayHandle>) {
  return std::tuple{
      field("length", &RayHandle::length, "m", Range::not_negative(), "must be given: from Ho to To, along -z_H")};
}

/// An angled handpiece (thesis 5.12-5.14), such as a dental contra-angle: the head's axis is bent away from the stylus.
///
///         z_H ^  o  Ho
///             |  |
///             |  |  length
///             |  |
///             E  o-----o  To      elbow E = -length z_H
///                 neck             To = E - neck z_T
///                                  z_T = z_H rotated by `bend` about y_H  (bend = 0: straight; pi/2: z_T = x_H)
///
struct LHandle {
  double length = std::numeric_limits<double>::quiet_NaN();  ///< [m] must be given: from Ho to the elbow, along -z_H
  double neck = std::numeric_limits<double>::quiet_NaN();    ///< [m] must be given: from the elbow to To, along -z_T
  double bend = units::kPi / 2;                              ///< [rad] angle between z_H and z_T, about y_H
};

constexpr auto fields_of(Of<LHandle>) {
  return std::tuple{
      field("length", &LHandle::length, "m", Range::not_negative(), "must be given: from Ho to the elbow, along -z_H"),
      field("neck", &LHandle::neck, "m", Range::not_negative(), "must be given: from the elbow to To, along -z_T"),
      field("bend", &LHandle::bend, "rad", Range::between(-units::kPi, units::kPi),
            "angle between z_H and z_T, about y_H"),
  };
}

using Handle = std::variant<RayHandle, LHandle>;

/// How force and torque at the head are transferred to the handle.
enum class HandleTorque {
  full_wrench,  ///< exactly: T_Ho = T_To + (To - Ho) x F (default)
  thesis        ///< by equations 5.11-5.14 of the thesis: see `thesis_handle_torque`
};

constexpr auto names_of(Of<HandleTorque>) {
  using enum HandleTorque;
  return std::array{
      Named{full_wrench, "full_wrench"},
      Named{thesis, "thesis"},
  };
}

namespace detail {

template <class AnyHandle>
void require_lengths(const AnyHandle& handle, const std::string& name) {
  for_each_field<AnyHandle>([&](const auto& field) {
    if (std::isnan(handle.*field.member) && std::string_view(field.unit) == "m") {
      const std::string member = name + "::" + field.name;
      throw Error(Name(member) + " [m] " + field.text + ". 0.02 is 20 mm; 0 puts the hand at the head.");
    }
  });
  require_fields_within(handle, name + "::");
}

}  // namespace detail

/// Pose of the tool head T in the handle frame H.
/// @throws Error if a length is missing, negative or not finite, or if the bend is outside [-pi, pi]
[[nodiscard]] inline Pose head_in_handle(const Handle& handle) {
  if (const auto* ray = std::get_if<RayHandle>(&handle)) {
    detail::require_lengths(*ray, "RayHandle");
    return Pose::from_translation(Vec3(0, 0, -ray->length));
  }
  const auto& bent = *std::get_if<LHandle>(&handle);
  detail::require_lengths(bent, "LHandle");
  const Mat3 R_HT = rotation_from_vector(Vec3(0, bent.bend, 0));
  return {R_HT, Vec3(0, 0, -bent.length) - bent.neck * R_HT.col(2)};
}

/// The handle torque by equations 5.11-5.14 of the thesis, for comparison with the thesis.
///
///     ray:  roll about z_H:  T_res               pitch = yaw = 0
///     L:    T = zeta (To - Ho) x F  +  zeta sin(bend) T_res o,   o = (To - Ho)/|To - Ho|
///
/// T_res is the torque about the spindle's axis. The thesis writes the first term as the two force components across
/// the offset times the offset's length (pitch and roll), and the second term as the yaw, about the offset. The text of
/// the thesis does not define its angle beta; this function uses the bend of the handle. An L handle whose head sits on
/// Ho has no offset and therefore no torque.
/// @param force_H  [N] on the tool, in the axes of H
/// @param spindle_torque  [N·m] T_res about +z of T
/// @param zeta     [1] the thesis's constant
/// @return [N·m] about Ho, in the axes of H
[[nodiscard]] inline Vec3 thesis_handle_torque(const Handle& handle, const Vec3& force_H, double spindle_torque,
                                               double zeta) {
  const auto* bent = std::get_if<LHandle>(&handle);
  if (bent == nullptr) return {0, 0, spindle_torque};
  const Vec3 offset = head_in_handle(handle).translation;
  const double length = offset.norm();
  if (length == 0) return Vec3::Zero();
  return zeta * (offset.cross(force_H) + std::sin(bent->bend) * spindle_torque / length * offset);
}

/// The torque at the handle of a force at the head, over that of a rigid handle.
/// @param zeta  [1] the thesis's constant
/// @return [1] 1 for the full wrench; by the equations of the thesis zeta for an L and 0 for a ray
[[nodiscard]] inline double lever_at_handle(HandleTorque by, const Handle& handle, double zeta) {
  if (by == HandleTorque::full_wrench) return 1;
  return std::holds_alternative<LHandle>(handle) ? zeta : 0;
}

}  // namespace hapticut
