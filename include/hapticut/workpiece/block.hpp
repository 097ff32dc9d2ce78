// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hapticut/core/spatial.hpp"
#include "hapticut/workpiece/block_mask.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// A block: 8 x 8 x 8 voxels, the unit of storage and of work. A block is one leaf of the OpenVDB trees that store the
/// workpiece; this file describes it without OpenVDB.
namespace hapticut {

inline constexpr int kBlockEdge = 8;                                       ///< voxels along an edge
inline constexpr int kBlockVoxels = kBlockEdge * kBlockEdge * kBlockEdge;  ///< 512

using VoxelIndex = std::array<int, 3>;

/// Place of voxel (x, y, z) of a block, 0 <= x, y, z < 8, in the block's arrays: z is the fastest index.
[[nodiscard]] constexpr int block_offset(int x, int y, int z) { return (x << 6) | (y << 3) | z; }

/// The inverse of `block_offset`: (x, y, z) of the voxel at a place of the arrays.
[[nodiscard]] constexpr VoxelIndex place_in_block(int voxel) { return {voxel >> 6, voxel >> 3 & 7, voxel & 7}; }

/// Index in the grid of a voxel of the block that begins at `origin`.
[[nodiscard]] constexpr VoxelIndex voxel_at(const VoxelIndex& origin, int voxel) {
  const VoxelIndex place = place_in_block(voxel);
  return {origin[0] + place[0], origin[1] + place[1], origin[2] + place[2]};
}

/// A box of voxels, both ends included.
struct IndexBox {
  VoxelIndex min = {0, 0, 0};
  VoxelIndex max = {-1, -1, -1};

  [[nodiscard]] bool empty() const { return max[0] < min[0] || max[1] < min[1] || max[2] < min[2]; }
  [[nodiscard]] std::int64_t voxels() const {
    if (empty()) return 0;
    return std::int64_t(max[0] - min[0] + 1) * (max[1] - min[1] + 1) * (max[2] - min[2] + 1);
  }
};

/// Index of the first voxel of the block that contains voxel coordinate `i` along one axis.
[[nodiscard]] constexpr int block_start(int i) { return i & ~(kBlockEdge - 1); }

/// How the voxel grid lies in the world: voxel (i, j, k) is centred at `X_WV * (voxel_size * (i, j, k))`.
struct GridFrame {
  double voxel_size = 1e-4;  ///< [m] edge of a voxel
  Pose X_WV;                 ///< pose of the grid: position of the centre of voxel (0,0,0) and directions of its axes

  [[nodiscard]] Vec3 center(const VoxelIndex& index) const {
    return X_WV * (voxel_size * Vec3(index[0], index[1], index[2]));
  }
  [[nodiscard]] bool operator==(const GridFrame& other) const {
    return voxel_size == other.voxel_size && X_WV.rotation == other.X_WV.rotation &&
           X_WV.translation == other.X_WV.translation;
  }
};

/// Centroid of the filled part of a voxel, relative to the voxel's centre, in steps of 1/1024 of a voxel edge. Laws
/// that are evaluated at points use it as quadrature point: the error is that of the midpoint rule, without ripple
/// (docs/decisions/0002-quadrature.md). The default law integrates over the filled part instead.
struct CentroidOffset {
  static constexpr int kSteps = 1024;  ///< steps per voxel edge
  std::array<std::int16_t, 3> steps = {0, 0, 0};

  /// @param offset [voxel edges] each component in [-0.5, 0.5]
  [[nodiscard]] static CentroidOffset from_offset(const Vec3& offset) {
    const auto round = [](double v) {
      const double bounded = v < -0.5 ? -0.5 : v > 0.5 ? 0.5 : v;
      return std::int16_t(bounded * kSteps + (bounded < 0 ? -0.5 : 0.5));
    };
    return {{round(offset.x()), round(offset.y()), round(offset.z())}};
  }

  /// Three 10-bit numbers in one word, as stored; 0 is the centre. An offset of +0.5 is clipped by one step.
  [[nodiscard]] std::uint32_t packed() const {
    const auto field = [](int v) { return std::uint32_t(v > 511 ? 511 : v) & 0x3ffu; };
    return field(steps[0]) | field(steps[1]) << 10 | field(steps[2]) << 20;
  }
  [[nodiscard]] static CentroidOffset unpacked(std::uint32_t word) {
    const auto field = [word](int shift) { return std::int16_t(std::int32_t(word << (22 - shift)) >> 22); };
    return {{field(0), field(10), field(20)}};
  }
  [[nodiscard]] bool operator==(const CentroidOffset&) const = default;
};

/// The content of one block, written by builders and read by exporters: plain arrays, 512 entries each.
struct BlockContent {
  std::array<MaterialId, kBlockVoxels> material;      ///< kEmpty in empty voxels
  std::array<float, kBlockVoxels> fill;               ///< [1] filled fraction, 0 ... 1; 0 where material is kEmpty
  std::array<CentroidOffset, kBlockVoxels> centroid;  ///< centroid of the filled part; zero in full and empty voxels
};

/// The kind of block that a builder returns: a uniform block needs no arrays.
struct BlockKind {
  bool uniform = true;           ///< every voxel is full of `material`, or the whole block is empty (kEmpty)
  MaterialId material = kEmpty;  ///< only for uniform blocks

  [[nodiscard]] static BlockKind empty() { return {true, kEmpty}; }
  [[nodiscard]] static BlockKind solid(MaterialId material) { return {true, material}; }
  [[nodiscard]] static BlockKind mixed() { return {false, kEmpty}; }
};

/// One block of a workpiece as the step reads it. A null pointer means that all 512 entries are equal, so that
/// homogeneous interiors need no memory.
struct BlockView {
  VoxelIndex origin = {0, 0, 0};           ///< index of the block's first voxel
  MaterialId uniform_material = kEmpty;    ///< material of every voxel, if `material` is null
  const MaterialId* material = nullptr;    ///< [512] or null: uniform
  const std::uint64_t* solid = nullptr;    ///< 8 words, bit `block_offset`: not yet empty; null with `material`
  const float* fill = nullptr;             ///< [512] filled fractions or null: every solid voxel is full
  const std::int32_t* centroid = nullptr;  ///< [512] packed CentroidOffset or null: quadrature at the voxel centres

  [[nodiscard]] bool empty() const { return material == nullptr && uniform_material == kEmpty; }

  /// Whether voxel `block_offset` is not yet empty.
  [[nodiscard]] bool is_solid(int voxel) const { return solid == nullptr ? !empty() : BlockMask::has(solid, voxel); }
  /// Material of a voxel; kEmpty if the voxel is empty.
  [[nodiscard]] MaterialId material_of(int voxel) const {
    if (!is_solid(voxel)) return kEmpty;
    return material != nullptr ? material[voxel] : uniform_material;
  }
  /// [1] Filled fraction of a voxel; 0 if the voxel is empty.
  [[nodiscard]] float fill_of(int voxel) const {
    if (fill != nullptr) return fill[voxel];
    return is_solid(voxel) ? 1.0F : 0.0F;
  }

  /// The voxels that are not yet empty.
  [[nodiscard]] BlockMask solid_voxels() const {
    if (solid == nullptr) return empty() ? BlockMask{} : BlockMask::all();
    BlockMask mask;
    std::copy_n(solid, mask.words.size(), mask.words.begin());
    return mask;
  }
  /// The voxels that are not yet empty and filled to at least `min_fill` [1].
  [[nodiscard]] BlockMask filled_voxels(float min_fill) const {
    BlockMask mask = solid_voxels();
    if (fill == nullptr) return mask;
    for (std::size_t x = 0; x < mask.words.size(); ++x) {
      std::uint64_t filled = 0;
      for (std::size_t n = 0; n < 64; ++n) filled |= std::uint64_t(fill[64 * x + n] >= min_fill) << n;
      mask.words[x] &= filled;
    }
    return mask;
  }

  /// Copies material and fill of every voxel.
  /// @param material_of_each  [512] kEmpty in empty voxels
  /// @param fill_of_each      [512] 0 in empty voxels
  void copy_to(std::array<MaterialId, kBlockVoxels>& material_of_each,
               std::array<float, kBlockVoxels>& fill_of_each) const {
    material_of_each.fill(kEmpty);
    fill_of_each.fill(0);
    solid_voxels().for_each([&](int voxel) {
      material_of_each[std::size_t(voxel)] = material_of(voxel);
      fill_of_each[std::size_t(voxel)] = fill_of(voxel);
    });
  }
};

/// A block with write access to its fills, for code that cuts.
struct CuttableBlock {
  BlockView view;
  float* fill = nullptr;  ///< [512] the fills of `view.fill`; null if the block has no array of fills yet
};

}  // namespace hapticut
