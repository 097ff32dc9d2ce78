// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "hapticut/contact/contact.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Sums over the blocks of one sub-step.
struct Resultant {
  Wrench wrench_T;          ///< [N], [N·m] on the tool about To, in T
  int voxels = 0;           ///< samples inside the head
  double volume = 0;        ///< [voxels] filled volume inside the head
  double depth = 0;         ///< [m] maximum depth
  double normal_force = 0;  ///< [N] sum of the magnitudes of the normal forces

  // Position of the contact: of the normal forces alone, without the drag of the spin.
  Vec3 push_T = Vec3::Zero();    ///< [N] their vector sum, on the tool, in T
  Vec3 moment_T = Vec3::Zero();  ///< [N·m] sum of their magnitudes times their positions from To, in T
  double area = 0;               ///< [voxel edges^2] part of the head's surface that is in material
};

/// Adds the normal forces [N] of the samples of a block to those of their materials.
inline void add_pressed(const ContactBlock& b, double scale, ByMaterial<double>& pressed) {
  for (int n = 0; n < b.lanes(); ++n)
    if (b.fill[n] > 0)
      pressed[b.material_of(n)] -=
          scale * double(b.force_x[n] * b.normal_x[n] + b.force_y[n] * b.normal_y[n] + b.force_z[n] * b.normal_z[n]);
}

/// Stage `sum_resultant`: `F = Sum g_i`, `T = Sum r_i x g_i` over one block, added to `total`.
///
/// Partial sums per lane within a block are in single precision, sums across blocks in double precision, always in the
/// same order.
/// @realtime no allocation, no lock; O(samples)
inline void sum_resultant(const ContactBlock& b, Resultant& total) {
  enum Term {
    kForceX,
    kForceY,
    kForceZ,
    kTorqueX,
    kTorqueY,
    kTorqueZ,
    kFill,
    kNormal,
    kPushX,
    kPushY,
    kPushZ,
    kMomentX,
    kMomentY,
    kMomentZ,
    kArea,
    kTerms
  };
  float sums[kTerms][kLanes] = {};
  float deepest[kLanes] = {};
  for (int group = 0; group < b.lanes(); group += kLanes)
    for (int lane = 0; lane < kLanes; ++lane) {
      const int n = group + lane;
      const float fx = b.force_x[n], fy = b.force_y[n], fz = b.force_z[n];
      const float x = b.x[n], y = b.y[n], z = b.z[n];
      sums[kForceX][lane] += fx;
      sums[kForceY][lane] += fy;
      sums[kForceZ][lane] += fz;
      sums[kTorqueX][lane] += y * fz - z * fy;
      sums[kTorqueY][lane] += z * fx - x * fz;
      sums[kTorqueZ][lane] += x * fy - y * fx;
      sums[kFill][lane] += b.sub_voxel ? b.immersed[n] : b.fill[n];
      const float along = fx * b.normal_x[n] + fy * b.normal_y[n] + fz * b.normal_z[n];
      sums[kNormal][lane] -= along;
      sums[kPushX][lane] += along * b.normal_x[n];
      sums[kPushY][lane] += along * b.normal_y[n];
      sums[kPushZ][lane] += along * b.normal_z[n];
      sums[kMomentX][lane] -= along * x;
      sums[kMomentY][lane] -= along * y;
      sums[kMomentZ][lane] -= along * z;
      sums[kArea][lane] += (b.sub_voxel ? 1.0F : b.scale_of(n)) * b.exposed[n];
      deepest[lane] = std::max(deepest[lane], b.sub_voxel ? b.top[n] : b.depth[n]);
    }
  const auto sum = [&](Term term) {
    double s = 0;
    for (const float lane_sum : sums[term]) s += double(lane_sum);
    return s;
  };
  total.wrench_T.force += Vec3(sum(kForceX), sum(kForceY), sum(kForceZ));
  total.wrench_T.torque += Vec3(sum(kTorqueX), sum(kTorqueY), sum(kTorqueZ));
  total.voxels += b.samples;
  total.volume += sum(kFill);
  total.normal_force += sum(kNormal);
  total.push_T += Vec3(sum(kPushX), sum(kPushY), sum(kPushZ));
  total.moment_T += Vec3(sum(kMomentX), sum(kMomentY), sum(kMomentZ));
  total.area += sum(kArea);
  for (const float depth : deepest) total.depth = std::max(total.depth, double(depth));
}

}  // namespace hapticut
