// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/handle.hpp"

#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

Pose head_in_handle(const Handle& handle) {
  if (const auto* ray = std::get_if<RayHandle>(&handle)) {
    require_fields_within(*ray, "RayHandle::");
    return Pose::from_translation(Vec3(0, 0, -ray->length));
  }
  const auto& bent = *std::get_if<LHandle>(&handle);
  require_fields_within(bent, "LHandle::");
  const Mat3 R_HT = rotation_from_vector(Vec3(0, bent.bend, 0));
  return {R_HT, Vec3(0, 0, -bent.length) - bent.neck * R_HT.col(2)};
}

Vec3 thesis_handle_torque(const Handle& handle, const Vec3& force_H, double spin, double zeta) {
  const auto* bent = std::get_if<LHandle>(&handle);
  if (bent == nullptr) return {0, 0, spin};
  const Vec3 offset = head_in_handle(handle).translation;
  const double length = offset.norm();
  if (length == 0) return Vec3::Zero();
  return zeta * (offset.cross(force_H) + std::sin(bent->bend) * spin / length * offset);
}

}  // namespace hapticut
