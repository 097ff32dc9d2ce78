// SPDX-License-Identifier: Apache-2.0
#include "hapticut/simulation/worst_case.hpp"

#include <cmath>

#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/block.hpp"
#include "simulation/near_blocks.hpp"

namespace hapticut {

std::size_t max_voxels(const ToolHead& head, double voxel_size) {
  // A voxel that meets the head lies wholly within its diagonal of it. The volume of the head grown by so much, from
  // rings of its meridian plane, each counted whole as soon as a part of it may belong.
  const double grown = std::sqrt(3.0) * voxel_size;
  const HeadBox box = head.bounding_box();
  const double radius = box.max.x() + grown, bottom = box.min.z() - grown, height = box.max.z() + grown - bottom;
  constexpr int kRings = 128;
  const double d_rho = radius / kRings, d_z = height / kRings;
  const double slack = grown + std::hypot(d_rho, d_z) / 2;
  double volume = 0;
  head.visit_springs<double>([&](const auto& springs) {
    for (int i = 0; i < kRings; ++i)
      for (int j = 0; j < kRings; ++j) {
        const double rho = (i + 0.5) * d_rho, z = bottom + (j + 0.5) * d_z;
        if (springs.margin(rho, z) > -slack) volume += 2 * units::kPi * rho * d_rho * d_z;
      }
  });
  return std::size_t(std::ceil(volume / (voxel_size * voxel_size * voxel_size)));
}

std::size_t max_blocks(const ToolHead& head, double voxel_size) {
  const HeadBox box = head.bounding_box();
  // Voxels are in contact from a voxel beyond the head on, whatever the quadrature.
  const double diagonal = (box.max - box.min).norm() / voxel_size + 2 * (1 + NearBlocks::kMotion);
  const double edge = std::ceil(diagonal / kBlockEdge) + 1;
  return std::size_t(edge * edge * edge);
}

}  // namespace hapticut
