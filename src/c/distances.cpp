// SPDX-License-Identifier: Apache-2.0
// Distances of the head and of points from what is left of the workpiece.
#include <cmath>
#include <limits>
#include <string>

#include "c/simulation_object.hpp"
#include "c/structs.hpp"

namespace hapticut::c {
namespace {

/// The material of an id, where 0 means any.  @throws Refusal when there is no such id
MaterialId material_or_any(const Simulation& simulation, std::uint32_t id) {
  const int materials = simulation.workpiece().materials().size();
  if (id > std::uint32_t(materials))
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, "material = " + std::to_string(id) +
                                               "; the materials of this scene have the ids 1 to " +
                                               std::to_string(materials) + ", and 0 means any of them.");
  return MaterialId(id);
}

/// A length [m], where 0 means no limit.  @throws Refusal when it is negative or NaN
double length_or_unlimited(double length, const char* name) {
  if (!(length >= 0))
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, std::string(name) + " = " + std::to_string(length) +
                                               "; it must be a length [m] > 0, or 0 for no limit.");
  return length > 0 ? length : std::numeric_limits<double>::infinity();
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_distance_to(hapticut_simulation simulation, uint32_t material, const hapticut_pose* X_WH,
                         double max_distance, double* distance) {
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    require_argument(X_WH, "X_WH");
    require_argument(distance, "distance");
    const MaterialId id = material_or_any(use->simulation, material);
    const double found =
        use->simulation.distance_to(id, pose_of(*X_WH), length_or_unlimited(max_distance, "max_distance"));
    if (std::isnan(found))
      throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                    "X_WH is not a rigid transform; its numbers must be finite, and its rotation orthonormal with "
                    "determinant +1.");
    if (std::isinf(found)) return HAPTICUT_NOTHING;
    *distance = found;
    return HAPTICUT_OK;
  });
}

int hapticut_first_hit(hapticut_simulation simulation, const double* origin_W, const double* direction_W,
                       double max_length, uint32_t material, hapticut_ray_hit* hit) {
  if (const int code = check_size(hit, "hit"); code != HAPTICUT_OK) return code;
  return within(IdleSimulation(simulation), [&](const auto& use) -> int {
    require_argument(origin_W, "origin_W");
    require_argument(direction_W, "direction_W");
    const Vec3 origin = vector_of(origin_W), direction = vector_of(direction_W);
    if (!is_finite(origin) || !is_finite(direction) || direction.isZero(0))
      throw Refusal(HAPTICUT_ERROR_ARGUMENT,
                    "origin_W or direction_W is not a ray; their numbers must be finite, and the direction not zero.");
    const MaterialId id = material_or_any(use->simulation, material);
    const std::optional<RayHit> found =
        use->simulation.workpiece().first_hit(origin, direction, length_or_unlimited(max_length, "max_length"), id);
    if (!found) return HAPTICUT_NOTHING;
    hapticut_ray_hit own{};
    own.material = found->material;
    own.distance = found->distance;
    put(found->point_W, own.point_W);
    put(found->normal_W, own.normal_W);
    write_struct(own, hit);
    return HAPTICUT_OK;
  });
}

}  // extern "C"
