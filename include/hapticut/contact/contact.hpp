// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/block.hpp"

/// @file
/// Stage `sample_contact`: the material of one block inside the head, as a structure of arrays that fits the
/// first-level cache during the later stages.
namespace hapticut {

/// Voxels in a row: the eight voxels of a block along z. All arrays are processed row by row.
inline constexpr int kLanes = kBlockEdge;
inline constexpr int kBlockRows = kBlockVoxels / kLanes;  ///< 64

/// The samples of one block inside the head, in the tool frame T. The arrays store the rows of the block that have at
/// least one sample, eight lanes each. A lane whose voxel is empty or outside the head has fill 0 and depth 0, and
/// therefore neither force nor removal.
struct ContactBlock {
  /// One value per lane, aligned for the widest vectors.
  template <class Value>
  struct alignas(64) Array : std::array<Value, kBlockVoxels> {};

  VoxelIndex origin = {0, 0, 0};  ///< index of the block's first voxel
  int rows = 0;                   ///< rows with at least one sample; entry n of an array is lane n % 8 of row n / 8
  int samples = 0;                ///< lanes inside the head
  bool uniform = true;            ///< all samples are of `one_material`
  MaterialId one_material = kEmpty;
  bool sub_voxel = false;  ///< sampled by Quadrature::sub_voxel: `depth` is the centre's distance below the surface
                           ///< with the smallest w, and may be negative
  float min_width = VoxelSection<float>::kMinWidth;  ///< [1] width of VoxelSection; set before the block is sampled

  std::array<std::uint8_t, kBlockRows> row;     ///< place of each row in the block: its first voxel's block_offset / 8
  std::array<std::uint8_t, kBlockRows> inside;  ///< bit set: the lane is a sample

  Array<float> x, y, z;                       ///< [m] quadrature point, from the head's origin To
  Array<float> depth;                         ///< [m] w > 0, below the head's surface
  Array<float> normal_x, normal_y, normal_z;  ///< [1] n, from the tool into the material
  Array<float> smooth;                        ///< [m^2] 0 at a cutting surface; see MeridianSpring::smooth
  Array<float> fill;                          ///< [1] phi before this sub-step
  Array<float> top;                           ///< [m] largest distance of the filled part; only if `sub_voxel`
  Array<float> max_component;                 ///< [1] largest |n_i| along the grid's axes; only if `sub_voxel`
  Array<float> immersed;                      ///< [1] filled fraction inside the head; only if `sub_voxel`
  Array<float> exposed;                       ///< [voxel edges^2] head surface in the voxel; approximate for points
  Array<MaterialId> material;                 ///< valid only when not `uniform`

  Array<float> force_x, force_y, force_z;  ///< [N] on the tool, written by the force law
  Array<float> fill_after;                 ///< [1] phi after this sub-step, written by the force law

  /// Number of entries of the arrays in use.
  [[nodiscard]] int lanes() const { return rows * kLanes; }
  /// Index in the grid of the voxel of entry n.
  [[nodiscard]] VoxelIndex voxel_of(int n) const {
    return voxel_at(origin, row[std::size_t(n / kLanes)] * kLanes + n % kLanes);
  }
  [[nodiscard]] MaterialId material_of(int n) const { return uniform ? one_material : material[std::size_t(n)]; }
  /// [1] Change of w at entry n per distance along its normal.
  [[nodiscard]] float scale_of(int n) const { return smooth[std::size_t(n)] > 0 ? float(kSmoothScale) : 1.0F; }
};

/// The voxel grid in the frame T of the head: voxel (i, j, k) is at `origin + voxel_steps * (i, j, k)`.
struct GridInHead {
  Vec3 origin;       ///< [m] centre of voxel (0,0,0) in T
  Mat3 voxel_steps;  ///< [m] columns: from one voxel to the next along i, j, k, in T

  GridInHead(const Pose& X_TV, double voxel_size) : origin(X_TV.translation), voxel_steps(X_TV.rotation * voxel_size) {}

  [[nodiscard]] Vec3 position(const VoxelIndex& index) const {
    return origin + voxel_steps * Vec3(index[0], index[1], index[2]);
  }
};

/// How the force of a partly filled voxel is computed.
enum class Quadrature {
  automatic,     ///< sub_voxel for laws that integrate over parts of voxels, centroid for laws evaluated at points
                 ///< (default)
  centroid,      ///< at the centroid of the filled part, as it was when the workpiece was built
  voxel_center,  ///< at the voxel's centre: equally exact on average, but the force ripples on surfaces along the grid
  sub_voxel      ///< integrated over the filled part, which ends at a plane across n (VoxelSection)
};

constexpr auto names_of(Of<Quadrature>) {
  using enum Quadrature;
  return std::array{
      Named{automatic, "automatic"},
      Named{centroid, "centroid"},
      Named{voxel_center, "voxel_center"},
      Named{sub_voxel, "sub_voxel"},
  };
}

/// Whether the head may reach into a block; false only if it certainly does not.
/// @param motion  [m] of any point of the head, at most
template <class Springs>
[[nodiscard]] bool may_touch(const Springs& springs, const GridInHead& grid, const VoxelIndex& block_origin,
                             float voxel_size, float motion = 0) {
  constexpr float kHalf = (kBlockEdge - 1) / 2.0F;
  const Vec3 c = grid.position(block_origin) + grid.voxel_steps * Vec3::Constant(double(kHalf));
  // Farthest quadrature point from the block's centre: 3.5 voxels to the outermost centre and half a voxel beyond it.
  const float reach = 1.7320508F * (kHalf + 0.5F) * voxel_size + motion;
  const auto rho = float(std::sqrt(c.x() * c.x() + c.y() * c.y()));
  return springs.margin(rho, float(c.z())) > -reach;
}

/// Adds row `row` of the block, whose lanes have been written, to the contact, with its materials.
inline void keep_row(const BlockView& block, int row, unsigned inside, ContactBlock& out) {
  if (block.material != nullptr) {
    const MaterialId* ids = block.material + row * kLanes;
    std::copy_n(ids, kLanes, out.material.begin() + out.rows * kLanes);
    if (out.rows == 0) out.one_material = ids[std::countr_zero(inside)];
    for (unsigned bits = inside; bits != 0; bits &= bits - 1)
      out.uniform &= ids[std::countr_zero(bits)] == out.one_material;
  }
  out.row[out.rows] = std::uint8_t(row);
  out.inside[out.rows] = std::uint8_t(inside);
  out.samples += std::popcount(inside);
  ++out.rows;
}

/// Stage `sample_contact`: fills `out` with the samples of one block inside the head.
/// @param quadrature  not automatic
/// @realtime no allocation, no lock; O(512)
template <class Springs>
void sample_contact(const Springs& springs, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) {
  HAPTICUT_ASSERT(quadrature != Quadrature::automatic);
  const Eigen::Vector3f base = grid.position(block.origin).cast<float>();
  const Eigen::Matrix3f steps = grid.voxel_steps.cast<float>();
  const bool at_centroid = block.centroid != nullptr && quadrature == Quadrature::centroid;
  constexpr float kStep = 1.0F / CentroidOffset::kSteps;
  const bool sub_voxel = quadrature == Quadrature::sub_voxel;
  const float size = steps.col(0).norm();
  const Eigen::Matrix3f axes = steps / size;

  out.sub_voxel = sub_voxel;
  out.origin = block.origin;
  out.rows = out.samples = 0;
  out.uniform = true;
  out.one_material = block.uniform_material;
  for (int row = 0; row < kBlockRows; ++row) {
    const auto solid = block.solid == nullptr ? 0xffU : unsigned(block.solid[row >> 3] >> (8 * (row & 7)) & 0xff);
    if (solid == 0) continue;
    unsigned inside = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int voxel = row * kLanes + lane, n = out.rows * kLanes + lane;
      float i = float(row >> 3), j = float(row & 7), k = float(lane);
      if (at_centroid) {
        const CentroidOffset offset = CentroidOffset::unpacked(std::uint32_t(block.centroid[voxel]));
        i += float(offset.steps[0]) * kStep;
        j += float(offset.steps[1]) * kStep;
        k += float(offset.steps[2]) * kStep;
      }
      const float x = base.x() + steps(0, 0) * i + steps(0, 1) * j + steps(0, 2) * k;
      const float y = base.y() + steps(1, 0) * i + steps(1, 1) * j + steps(1, 2) * k;
      const float z = base.z() + steps(2, 0) * i + steps(2, 1) * j + steps(2, 2) * k;
      const float rho = std::sqrt(x * x + y * y);
      const MeridianSpring<float> spring = springs.spring(rho, z);
      const float radial = spring.n_radial / std::max(rho, 1e-12F);
      const float fill = block.fill == nullptr ? 1.0F : block.fill[voxel];
      const float depth = sub_voxel ? formulas::distance_below(spring.depth, spring.scale()) : spring.depth;
      bool is_inside = depth > 0 && (solid >> lane & 1U) != 0;
      out.exposed[n] = spring.depth < size ? 1.0F : 0.0F;
      if (sub_voxel) {
        const formulas::Triple<float> normal = {radial * x, radial * y, spring.n_axial};
        out.max_component[n] = formulas::largest_component(axes, normal);
        const VoxelSection<float> section(out.max_component[n], out.min_width);
        const auto part = formulas::FilledPart<float>::of(section, depth / size, fill);
        is_inside = part.top > 0 && fill > 0 && (solid >> lane & 1U) != 0;
        out.top[n] = is_inside ? part.top * size : 0.0F;
        out.immersed[n] = is_inside ? section.volume(part.height, part.top) : 0.0F;
        out.exposed[n] = section.area_at(-part.far);
      }
      if (!is_inside) out.exposed[n] = 0;
      inside |= is_inside ? 1U << lane : 0U;
      out.x[n] = x;
      out.y[n] = y;
      out.z[n] = z;
      out.depth[n] = is_inside ? depth : 0.0F;
      out.smooth[n] = spring.smooth;
      out.normal_x[n] = radial * x;
      out.normal_y[n] = radial * y;
      out.normal_z[n] = spring.n_axial;
      out.fill[n] = is_inside ? fill : 0.0F;
    }
    if (inside == 0) continue;
    keep_row(block, row, inside, out);
  }
}

}  // namespace hapticut
