// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/workpiece/removal.hpp"

namespace hapticut::kernels {

/// Sums of the contact's stiffness over samples: the upper triangle of `Sum s J^T J`, `J = (n, r x n)`, row by row.
///
/// The force `f(w) n` of a spring answers to a motion by `f' J^T J` and by the turning of its normal. The second part
/// is left out (Gauss and Newton's approximation), which keeps the sum positive semidefinite.
struct StiffnessSums {
  static constexpr std::size_t kTerms = 21;
  static constexpr std::size_t kLanes = BlockChange::kStrip;

  alignas(64) std::array<std::array<double, kLanes>, kTerms> lanes = {};  ///< [N/m^4], [N/m^3], [N/m^2]

  /// @param voxel_volume  [m^3]
  [[nodiscard]] Stiffness total(double voxel_volume) const {
    Stiffness k;
    std::size_t term = 0;
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column, ++term) {
        double sum = 0;
        for (const double lane : lanes[term]) sum += lane;
        k(row, column) = k(column, row) = sum * voxel_volume;
      }
    return k;
  }
};

/// Adds the stiffness of the samples of one block, after FoundationLaw has evaluated it: each is a spring and damper
/// of `f' = k phi (max(0, 1 + chi w_dot) + chi w/dt)` along its normal, `phi` the mean fill of the sub-step. The
/// reference for the vectors.
inline void add_stiffness(const ContactBlock& b, const HeadMotion& m, const ContactMaterials& materials,
                          StiffnessSums& sums) noexcept {
  const double volume = std::pow(double(m.voxel_size), 3);
  for (std::size_t i = 0; i < std::size_t(b.lanes()); ++i) {
    if (!((b.sub_voxel ? b.top[i] : b.depth[i]) > 0)) continue;
    const Eigen::Vector3f r(b.x[i], b.y[i], b.z[i]), n(b.normal_x[i], b.normal_y[i], b.normal_z[i]);
    const float damping = materials[b.material_of(int(i))].damping;
    const float damped = 1 + damping * (m.felt_velocity + m.felt_angular_velocity.cross(r)).dot(n);
    if (!(damped > 0)) continue;
    const Eigen::Vector3f force(b.force_x[i], b.force_y[i], b.force_z[i]);
    float in_contact = 1, depth = b.depth[i];  // [1] of the sample, and [m] its mean depth
    if (b.sub_voxel) {
      const VoxelSection<float> section(b.largest[i]);
      const float top = b.top[i] / m.voxel_size;
      const float height = top - b.depth[i] / m.voxel_size + section.span() / 2;
      const DepthIntegrals<float> part = section.integrals(height, top, 0);
      in_contact = part.volume;
      depth = part.depth * m.voxel_size;
    }
    const double spring = -double(force.dot(n)) / (volume * double(depth) * double(damped));  // k phi
    const double slope = spring * double(in_contact * damped + damping * depth / m.duration);
    const Eigen::Vector3d direction = n.cast<double>(), arm = r.cross(n).cast<double>();
    const double j[6] = {direction.x(), direction.y(), direction.z(), arm.x(), arm.y(), arm.z()};
    std::size_t term = 0;
    for (int row = 0; row < 6; ++row)
      for (int column = row; column < 6; ++column, ++term)
        sums.lanes[term][i % StiffnessSums::kLanes] += slope * j[row] * j[column];
  }
}

}  // namespace hapticut::kernels
