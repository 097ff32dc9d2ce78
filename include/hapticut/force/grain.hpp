// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "hapticut/force/law.hpp"
#include "hapticut/workpiece/block.hpp"

namespace hapticut {

/// The grain of materials: a cutting energy u g that differs from place to place, fixed in the workpiece.
///
/// g is log-normal with the mean 1 and the coefficient of variation `Material::grain`, in sixteen classes of equal
/// probability. It is the same within a cubic cell with an edge of `Material::grain_length`, along the axes of the grid
/// and counted from the world's origin, and independent between cells: a number of the cell and of the seed alone. So
/// neither the size of the voxels nor the rate of the steps changes it.
///
/// Cells are at least two voxels wide. Where this makes them wider than the grain's length, they depend on the voxels
/// and vary less in the same ratio, so a force over many cells varies as much (`closed_forms::grain_variation`).
class Grain {
 public:
  static constexpr int kClasses = 16;
  using Classes = std::array<float, kClasses>;

  /// @param materials  with their `grain` and `grain_length`
  /// @param seed       another seed gives another grain
  /// @realtime no allocation, no lock; O(materials)
  void set(const ContactMaterials& materials, const GridFrame& frame, std::uint32_t seed) noexcept {
    clear();
    voxel_size_ = frame.voxel_size;
    first_ = frame.X_WV.rotation.transpose() * frame.X_WV.translation;
    seed_ = mixed(seed);
    for (std::size_t id = 0; id < materials.size(); ++id) {
      const ContactMaterial& m = materials[id];
      if (!(m.grain > 0 && m.grain_length > 0)) continue;
      const double cell = std::max(double(m.grain_length), kMinVoxels * voxel_size_);
      per_length_[id] = 1 / cell;
      classes_[id] = classes_of(double(m.grain) * double(m.grain_length) / cell);
      any_ = true;
    }
  }
  /// No material has a grain from now on.
  void clear() noexcept { per_length_ = {}, any_ = false; }

  [[nodiscard]] bool any() const noexcept { return any_; }  ///< some material has a grain
  [[nodiscard]] bool has(MaterialId id) const noexcept { return per_length_[id] > 0; }

  /// [1] g at the centre of a voxel; 1 in a material without grain. A centre on a face belongs to the cell above it.
  /// @realtime no allocation, no lock; O(1)
  [[nodiscard]] float at(MaterialId id, const VoxelIndex& voxel) const noexcept {
    if (!has(id)) return 1;
    std::uint32_t bits = seed_;
    for (std::size_t axis = 0; axis < 3; ++axis) bits = mixed(bits + cell_at(id, axis, voxel[axis]));
    return classes_[id][bits % kClasses];
  }

  /// `at` in one block and material: what neighbours share is computed once.
  class OfBlock {
   public:
    /// @param grain   must outlive it and not change
    /// @param origin  of the block
    /// @realtime no allocation, no lock; O(1)
    void enter(const Grain& grain, MaterialId id, const VoxelIndex& origin) noexcept {
      classes_ = grain.has(id) ? &grain.classes_[id] : nullptr;
      row_ = -1;
      if (classes_ == nullptr) return;
      for (int n = 0; n < kBlockEdge; ++n) {
        after_first_[n] = mixed(grain.seed_ + grain.cell_at(id, 0, origin[0] + n));
        for (std::size_t axis = 1; axis < 3; ++axis) others_[axis - 1][n] = grain.cell_at(id, axis, origin[axis] + n);
      }
    }
    /// @param offset  `block_offset` of a voxel
    /// @pre entered
    /// @realtime no allocation, no lock; O(1)
    [[nodiscard]] float at(int offset) noexcept {
      if (classes_ == nullptr) return 1;
      const int row = offset / kBlockEdge;
      if (row != row_) row_ = row, bits_ = mixed(after_first_[row / kBlockEdge] + others_[0][row % kBlockEdge]);
      return (*classes_)[mixed(bits_ + others_[1][offset % kBlockEdge]) % kClasses];
    }

   private:
    const Classes* classes_ = nullptr;       // null: no grain
    std::uint32_t after_first_[kBlockEdge];  // bits, by the place along that axis
    std::uint32_t others_[2][kBlockEdge];    // cells along the other two
    int row_ = -1;
    std::uint32_t bits_ = 0;  // after the second axis, in that row
  };

  /// [1] g of each class, from low to high.
  /// @param variation  [1] coefficient of variation, at most 1
  [[nodiscard]] static Classes classes_of(double variation) noexcept {
    const double spread = std::sqrt(std::log1p(variation * variation));
    const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2)); };  // probability of a normal deviate
    std::array<double, kClasses> means;  // of the log-normal number in each class
    double reached = 0, variance = 0;
    for (std::size_t n = 0; n < kClasses; ++n) {
      const double up_to = n + 1 < kClasses ? below(kQuantiles[n] - spread) : 1;
      means[n] = kClasses * (up_to - reached);
      variance += (means[n] - 1) * (means[n] - 1) / kClasses;
      reached = up_to;
    }
    Classes classes;  // spread so that they vary as much as the number itself
    for (std::size_t n = 0; n < kClasses; ++n) classes[n] = float(1 + (means[n] - 1) * variation / std::sqrt(variance));
    return classes;
  }

 private:
  static constexpr int kMinVoxels = 2;  // along an edge of a cell
  /// Normal deviates at 1/16 ... 15/16 of the probability.
  static constexpr std::array<double, kClasses - 1> kQuantiles = {
      -1.5341205443525463, -1.1503493803760083, -0.8871465590188760, -0.6744897501960817,
      -0.4887764111146695, -0.3186393639643752, -0.1573106846101707, 0,
      0.1573106846101707,  0.3186393639643752,  0.4887764111146695,  0.6744897501960817,
      0.8871465590188760,  1.1503493803760083,  1.5341205443525463};

  [[nodiscard]] std::uint32_t cell_at(MaterialId id, std::size_t axis, int voxel) const noexcept {
    constexpr double kRounding = 1e-6;  // [1] far more than that of a place
    const double place = (first_[int(axis)] + voxel_size_ * voxel) * per_length_[id];
    return std::uint32_t(std::int32_t(std::floor(place + kRounding)));
  }

  /// A number that looks random, from another: multiplications and shifts that change every bit with half a chance.
  [[nodiscard]] static constexpr std::uint32_t mixed(std::uint32_t bits) noexcept {
    bits = (bits ^ bits >> 16) * 0x7feb352dU;
    bits = (bits ^ bits >> 15) * 0x846ca68bU;
    return bits ^ bits >> 16;
  }

  double voxel_size_ = 0;      // [m]
  Vec3 first_ = Vec3::Zero();  // [m] centre of voxel (0,0,0), along the axes of the grid
  std::uint32_t seed_ = 0;
  bool any_ = false;
  ByMaterial<double> per_length_ = {};  // [1/m] cells per length; 0: no grain
  ByMaterial<Classes> classes_ = {};    // [1] g
};

}  // namespace hapticut
