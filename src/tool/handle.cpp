// SPDX-License-Identifier: Apache-2.0
#include "hapticut/tool/handle.hpp"

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {

Pose head_in_handle(const Handle& handle) {
  if (const auto* ray = std::get_if<RayHandle>(&handle)) {
    require_not_negative(ray->length, "RayHandle::length [m]");
    return Pose::from_translation(Vec3(0, 0, -ray->length));
  }
  const auto& bent = *std::get_if<LHandle>(&handle);
  require_not_negative(bent.length, "LHandle::length [m]");
  require_not_negative(bent.neck, "LHandle::neck [m]");
  require_between(bent.bend, -units::kPi, units::kPi, "LHandle::bend [rad]");
  const Mat3 R_HT = rotation_from_vector(Vec3(0, bent.bend, 0));
  return {R_HT, Vec3(0, 0, -bent.length) - bent.neck * R_HT.col(2)};
}

}  // namespace hapticut
