// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/block.hpp"

/// @file
/// Stage `sample_contact`: the material of one block that lies inside the head, as a structure of arrays that stays in
/// the first-level cache while the later stages work on it.
namespace hapticut {

/// Arrays are processed in groups of this many samples; the last group is padded with samples of no material.
inline constexpr int kLanes = 8;

/// The samples of one block inside the head, in the tool frame T.
struct alignas(64) ContactBlock {
  template <class Value>
  using Array = std::array<Value, kBlockVoxels>;

  int size = 0;         ///< samples
  bool uniform = true;  ///< all samples are of material[0]

  Array<float> x, y, z;                       ///< [m] quadrature point, from the head's origin To
  Array<float> depth;                         ///< [m] w > 0, below the cutting surface
  Array<float> normal_x, normal_y, normal_z;  ///< [1] n, from the tool into the material
  Array<float> fill;                          ///< [1] phi before this sub-step; 0 in the padding

  Array<float> force_x, force_y, force_z;  ///< [N] on the tool, written by the force law
  Array<float> fill_after;                 ///< [1] phi after this sub-step, written by the force law

  Array<std::uint16_t> voxel;  ///< block_offset of the sample's voxel
  Array<MaterialId> material;

  /// Number of samples rounded up to whole groups.
  [[nodiscard]] int padded_size() const { return (size + kLanes - 1) / kLanes * kLanes; }
};

/// Where the voxels of a grid are as seen from the head: voxel (i, j, k) is at `origin + i * step_x + ...` in T.
struct GridInHead {
  Vec3 origin;       ///< [m] centre of voxel (0,0,0) in T
  Mat3 voxel_steps;  ///< [m] columns: from one voxel to the next along i, j, k, in T

  GridInHead(const Pose& X_TV, double voxel_size) : origin(X_TV.translation), voxel_steps(X_TV.rotation * voxel_size) {}

  [[nodiscard]] Vec3 position(const VoxelIndex& index) const {
    return origin + voxel_steps * Vec3(index[0], index[1], index[2]);
  }
};

/// Where in a partly filled voxel its force is taken.
enum class Quadrature {
  centroid,     ///< at the centroid of the part that was filled when the workpiece was built (default)
  voxel_center  ///< at the voxel's centre: first order at surfaces that are not aligned with the grid
};

/// Whether the head may reach into a block at all: false only when it certainly does not.
template <class Springs>
[[nodiscard]] bool may_touch(const Springs& springs, const GridInHead& grid, const VoxelIndex& block_origin,
                             float voxel_size) {
  constexpr float kHalf = (kBlockEdge - 1) / 2.0F;
  const Vec3 c = grid.position(block_origin) + grid.voxel_steps * Vec3::Constant(double(kHalf));
  // Farthest quadrature point from the block's centre: 3.5 voxels to the outermost centre and half a voxel beyond it.
  const float reach = 1.7320508F * (kHalf + 0.5F) * voxel_size;
  const auto rho = float(std::sqrt(c.x() * c.x() + c.y() * c.y()));
  return springs.margin(rho, float(c.z())) > -reach;
}

namespace detail {

/// Writes position, fill and material of every voxel of the block that is not empty.
inline void gather_solid_voxels(const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                                ContactBlock& out) {
  const Vec3 first = grid.position(block.origin);
  const auto base = first.cast<float>().eval();
  const Eigen::Matrix3f steps = grid.voxel_steps.cast<float>();
  const bool at_centroid = block.centroid != nullptr && quadrature == Quadrature::centroid;
  int n = 0;
  for (int word = 0; word < kBlockEdge; ++word) {
    std::uint64_t bits = block.solid == nullptr ? ~std::uint64_t(0) : block.solid[word];
    for (; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      const int voxel = word * 64 + bit;
      float i = float(word), j = float(bit >> 3), k = float(bit & 7);
      if (at_centroid) {
        const CentroidOffset offset = CentroidOffset::unpacked(std::uint32_t(block.centroid[voxel]));
        i += float(offset.steps[0]) * (1.0F / CentroidOffset::kSteps);
        j += float(offset.steps[1]) * (1.0F / CentroidOffset::kSteps);
        k += float(offset.steps[2]) * (1.0F / CentroidOffset::kSteps);
      }
      out.x[n] = base.x() + steps(0, 0) * i + steps(0, 1) * j + steps(0, 2) * k;
      out.y[n] = base.y() + steps(1, 0) * i + steps(1, 1) * j + steps(1, 2) * k;
      out.z[n] = base.z() + steps(2, 0) * i + steps(2, 1) * j + steps(2, 2) * k;
      out.voxel[n] = std::uint16_t(voxel);
      ++n;
    }
  }
  out.size = n;
}

}  // namespace detail

/// Stage `sample_contact`: fills `out` with the samples of one block inside the head.
/// @realtime no allocation, no lock; O(512)
template <class Springs>
void sample_contact(const Springs& springs, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) {
  detail::gather_solid_voxels(block, grid, quadrature, out);

  for (int n = 0; n < out.size; ++n) {
    const float rho = std::sqrt(out.x[n] * out.x[n] + out.y[n] * out.y[n]);
    const Spring<float> spring = springs.spring(rho, out.z[n]);
    const float radial = spring.n_radial / std::max(rho, 1e-12F);
    out.depth[n] = spring.depth;
    out.normal_x[n] = radial * out.x[n];
    out.normal_y[n] = radial * out.y[n];
    out.normal_z[n] = spring.n_axial;
  }

  // Keep what is inside, in the order of the voxels.
  int kept = 0;
  bool uniform = true;
  for (int n = 0; n < out.size; ++n) {
    if (!(out.depth[n] > 0)) continue;
    const int voxel = out.voxel[n];
    out.x[kept] = out.x[n];
    out.y[kept] = out.y[n];
    out.z[kept] = out.z[n];
    out.depth[kept] = out.depth[n];
    out.normal_x[kept] = out.normal_x[n];
    out.normal_y[kept] = out.normal_y[n];
    out.normal_z[kept] = out.normal_z[n];
    out.voxel[kept] = std::uint16_t(voxel);
    out.fill[kept] = block.fill == nullptr ? 1.0F : block.fill[voxel];
    out.material[kept] = block.material == nullptr ? block.uniform_material : block.material[voxel];
    uniform &= out.material[kept] == out.material[0];
    ++kept;
  }
  out.size = kept;
  out.uniform = uniform;
  for (int n = kept; n < out.padded_size(); ++n) {
    out.x[n] = out.y[n] = out.z[n] = 0;
    out.depth[n] = out.normal_x[n] = out.normal_y[n] = out.normal_z[n] = 0;
    out.fill[n] = 0;
    out.material[n] = out.material[0];
  }
}

}  // namespace hapticut
