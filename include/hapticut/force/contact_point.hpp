// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/spatial.hpp"
#include "hapticut/tool/head.hpp"

namespace hapticut {

/// Where the summed normal force leaves the head: the point of its surface on the line of action of a wrench, on the
/// side of the material. Dry friction acts there.
///
/// The line of action of a force F with torque T about To passes through `F x T / |F|^2` along F. The part of T along F
/// has no line of action and is left out.
/// @param wrench_T  normal force on the tool and its torque about To, in T; the force is not zero
/// @return [m] in T; the point of the line nearest to To where the line misses the head
/// @realtime no allocation, no lock; about a hundred evaluations of the head's depth
[[nodiscard]] inline Vec3 contact_point(const ToolHead& head, const Wrench& wrench_T) {
  const Vec3 outward = -wrench_T.force.normalized();
  Vec3 nearest = wrench_T.force.cross(wrench_T.torque) / wrench_T.force.squaredNorm();
  const auto inside = [&](double s) { return head.spring_at(nearest + s * outward).depth > 0; };
  constexpr int kSearch = 64, kBisections = 24;
  const double reach = 1.01 * head.reach(), step = 2 * reach / kSearch;
  double out = reach;
  for (int n = 0; n < kSearch && !inside(out - step); ++n) out -= step;
  if (!inside(out - step)) return nearest;
  double in = out - step;
  for (int n = 0; n < kBisections; ++n) {
    const double middle = 0.5 * (in + out);
    (inside(middle) ? in : out) = middle;
  }
  return nearest + out * outward;
}

}  // namespace hapticut
