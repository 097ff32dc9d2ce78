// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/work_estimate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/build/mesh_builder.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {

void require_allowed(const WorkEstimate& estimate, bool large) {
  if (large || (estimate.memory_bytes <= kMaxBuildMemory && estimate.seconds <= kMaxBuildTime)) return;
  throw Error("the workpiece would take about " + format_number(estimate.voxels) + " voxels, " +
              format_number(estimate.memory_bytes) + " bytes and " + format_number(estimate.seconds) +
              " s of work; check its unit and size, choose a larger voxel size, or lift the limit (" + "large"_name +
              ").");
}

WorkEstimate estimate_work(const std::vector<MeshShell>& shells, const MeshImport& options) {
  // Measured on one core of 2.5 GHz.
  constexpr double kSecondsPerPoint = 4e-8, kSecondsPerCutVoxel = 1e-5, kSecondsPerBlock = 2e-6;
  constexpr double kBytesPerVoxel = 1.3, kBytesPerCutVoxel = 40;
  const double h = options.voxel_size, points = std::pow(options.subsamples, 3);
  WorkEstimate estimate;
  Eigen::AlignedBox3d around;
  for (const MeshShell& shell : shells)
    for (const auto& t : shell.mesh.triangles) {
      const Vec3 &a = shell.mesh.vertices[t[0]], &b = shell.mesh.vertices[t[1]], &c = shell.mesh.vertices[t[2]];
      around.extend(a).extend(b).extend(c);
      // The voxels of its area projected along the three axes, and a row of voxels along its edges.
      const Vec3 area = 0.5 * (b - a).cross(c - a).cwiseAbs();
      const double length = (b - a).norm() + (c - b).norm() + (a - c).norm();
      estimate.cut_voxels += area.sum() / (h * h) + 0.5 * length / h;
    }
  estimate.voxels = 1;
  for (int axis = 0; axis < 3; ++axis) estimate.voxels *= std::ceil(around.sizes()[axis] / h) + 1;
  estimate.cut_voxels = std::min(estimate.cut_voxels, estimate.voxels);
  estimate.memory_bytes = kBytesPerVoxel * estimate.voxels + kBytesPerCutVoxel * estimate.cut_voxels;
  estimate.seconds = (kSecondsPerCutVoxel + points * kSecondsPerPoint) * estimate.cut_voxels +
                     kSecondsPerBlock * estimate.voxels / kBlockVoxels;
  return estimate;
}

}  // namespace hapticut
