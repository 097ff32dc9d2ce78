// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "hapticut/core/volume.hpp"
#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// Sampling of a dense volume by the voxels of a workpiece with the same axes.
///
/// Most blocks consist of one material and are recognised from the samples that they touch. Only voxels that a surface
/// cuts are sampled point by point.
namespace hapticut {

inline constexpr int kMaxSubsamples = 16;

/// A point between two samples along one axis.
struct PointOnAxis {
  int low = 0;       ///< the sample below
  int high = 0;      ///< the sample above; equal to `low` at the border
  float weight = 0;  ///< [1] weight of the sample above
  bool inside = false;
};

/// The cell around one point: the values at the corners (x fastest) and the position of the point along each edge.
template <class Sample>
struct Cell {
  std::array<Sample, 8> corner;
  std::array<float, 3> weight;  ///< [1] 0 ... 1
  std::array<float, 3> step;    ///< [samples] distance of neighbouring points along each axis

  /// Interpolates `value_of(corner)`.
  /// @param variation  receives the change of the interpolated value across the small box around the point
  template <class ValueOf>
  [[nodiscard]] float interpolate(const ValueOf& value_of, float& variation) const {
    std::array<float, 8> v;
    for (std::size_t n = 0; n < 8; ++n) v[n] = value_of(corner[n]);
    const auto [x, y, z] = weight;
    const float v00 = v[0] + x * (v[1] - v[0]), v10 = v[2] + x * (v[3] - v[2]);
    const float v01 = v[4] + x * (v[5] - v[4]), v11 = v[6] + x * (v[7] - v[6]);
    const float low = v00 + y * (v10 - v00), high = v01 + y * (v11 - v01);
    const float along_x =
        (1 - z) * ((1 - y) * (v[1] - v[0]) + y * (v[3] - v[2])) + z * ((1 - y) * (v[5] - v[4]) + y * (v[7] - v[6]));
    const float along_y = (1 - z) * (v10 - v00) + z * (v11 - v01);
    variation = std::abs(along_x) * step[0] + std::abs(along_y) * step[1] + std::abs(high - low) * step[2];
    return low + z * (high - low);
  }
};

/// [1] Covered fraction of the small box around a point that is `excess` inside, if the field changes by `variation`
/// across the box. Exact for a plane that is parallel to a face of the box.
/// @param inside  whether the point counts as inside; decides if the field does not change across the box
[[nodiscard]] inline float covered_fraction(float excess, float variation, bool inside) {
  if (std::abs(excess) >= variation / 2) return inside ? 1.0F : 0.0F;
  return 0.5F + excess / variation;
}

/// Fills the blocks of a workpiece from a volume.
///
/// A `Field` defines the meaning of samples:
/// * `Sample`: type of the samples.
/// * `Extent`: a summary of several samples, grown by `extend(extent, sample)`.
/// * `uniform(extent)`: the single material between these samples (kEmpty if empty), or nothing.
/// * `all_solid(extent)`: whether every point between the samples has a material.
/// * `surely_cut(extent)`: whether both of these are certainly false.
/// * `Tally`: the sums over a voxel.
/// * `count(cell, tally)`: counts one point and returns the covered fraction of the box around it.
/// * `material(tally, place, cell_at)`: the material of the voxel at a place among the samples; `cell_at` gives the
/// cell of
///   a place.
/// * `reach(material)`: number of samples around a voxel of that material that may change it.
template <class Field>
class VolumeFiller {
 public:
  using Sample = typename Field::Sample;

  /// @param samples  the samples in use; points more than half a spacing beyond them are empty
  /// @param first    [samples] position of the centre of voxel (0,0,0) among the samples
  /// @param step     [samples] size of a voxel along each axis
  /// @param subsamples  points per edge of a voxel that the surface cuts
  /// @param sparse      points per edge that suffice to see every sample
  /// @param antialias  false: with one subsample, voxels are full or empty
  VolumeFiller(const Volume<Sample>& volume, const Field& field, const IndexBox& samples, const Vec3& first,
               const Vec3& step, int subsamples, int sparse, bool antialias)
      : volume_(volume),
        field_(field),
        samples_(samples),
        first_(first),
        step_(step),
        subsamples_(subsamples),
        sparse_(sparse) {
    // Without a box, a point is either inside or outside.
    if (antialias) box_ = (step / subsamples).cast<float>();
  }

  BlockKind operator()(const VoxelIndex& origin, BlockContent& content) const {
    Points points;
    bool whole_block_inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      bool any_inside = false;
      for (int n = 0; n < kBlockEdge * subsamples_; ++n) {
        const PointOnAxis& point = points[axis][n] = point_on(axis, origin[axis], n, subsamples_);
        any_inside |= point.inside;
        whole_block_inside &= point.inside;
      }
      if (!any_inside) return BlockKind::empty();
    }
    const VoxelIndex last = {kBlockEdge - 1, kBlockEdge - 1, kBlockEdge - 1};
    if (const auto material = field_.uniform(extent_of(points, {0, 0, 0}, last))) {
      if (*material == kEmpty) return BlockKind::empty();
      const int reach = field_.reach(*material);
      if (whole_block_inside && (reach == 0 || field_.uniform(extent_of(points, {0, 0, 0}, last, reach))))
        return BlockKind::solid(*material);
    }
    Points sparse;
    for (int axis = 0; axis < 3; ++axis)
      for (int n = 0; n < kBlockEdge * sparse_; ++n) sparse[axis][n] = point_on(axis, origin[axis], n, sparse_);
    for (int n = 0; n < kBlockVoxels; ++n) fill_voxel(points, sparse, origin, place_in_block(n), n, content);
    return BlockKind::mixed();
  }

 private:
  using Points = std::array<std::array<PointOnAxis, kBlockEdge * kMaxSubsamples>, 3>;

  /// Point `n` of the block along an axis, `per_voxel` to a voxel.
  [[nodiscard]] PointOnAxis point_on(int axis, int block_origin, int n, int per_voxel) const {
    return point_at(axis, first_[axis] + (block_origin - 0.5 + (n + 0.5) / per_voxel) * step_[axis]);
  }

  /// @param place  [samples]
  [[nodiscard]] PointOnAxis point_at(int axis, double place) const {
    const int min = samples_.min[axis], max = samples_.max[axis];
    PointOnAxis point;
    point.inside = place >= min - 0.5 - 1e-9 && place <= max + 0.5 + 1e-9;
    const double clamped = std::clamp(place, double(min), double(max));
    point.low = std::min(int(std::floor(clamped)), std::max(max - 1, min));
    point.high = std::min(point.low + 1, max);
    point.weight = float(clamped - point.low);
    return point;
  }

  /// Summary of the samples around the voxels `from` ... `to` of a block, and of `reach` more samples to each side;
  /// stops early if a surface surely cuts them.
  [[nodiscard]] typename Field::Extent extent_of(const Points& points, const VoxelIndex& from, const VoxelIndex& to,
                                                 int reach = 0) const {
    VoxelIndex low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::max(points[axis][from[axis] * subsamples_].low - reach, samples_.min[axis]);
      high[axis] = std::min(points[axis][(to[axis] + 1) * subsamples_ - 1].high + reach, samples_.max[axis]);
    }
    typename Field::Extent extent;
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        const Sample* row = &volume_.at(0, j, k);
        for (int i = low[0]; i <= high[0]; ++i) field_.extend(extent, row[i]);
      }
      if (field_.surely_cut(extent)) return extent;
    }
    return extent;
  }

  void fill_voxel(const Points& points, const Points& sparse, const VoxelIndex& origin, const VoxelIndex& voxel, int n,
                  BlockContent& content) const {
    content.material[n] = kEmpty;
    content.fill[n] = 0;
    content.centroid[n] = {};
    const auto extent = extent_of(points, voxel, voxel);
    const auto uniform = field_.uniform(extent);
    if (uniform && *uniform == kEmpty) return;
    const bool inside = all_inside(points, voxel);
    const auto material_of = [&](const typename Field::Tally& tally, const Vec3& centroid) {
      const Vec3 center(origin[0] + voxel[0], origin[1] + voxel[1], origin[2] + voxel[2]);
      return field_.material(tally, first_ + (center + centroid).cwiseProduct(step_),
                             [this](const Vec3& place) { return cell_at(place); });
    };
    if (inside && (uniform || field_.all_solid(extent))) {
      content.material[n] =
          uniform && field_.reach(*uniform) == 0 ? *uniform : material_of(tally_of_full(sparse, voxel), Vec3::Zero());
      content.fill[n] = 1;
      return;
    }

    typename Field::Tally tally{};
    double covered = 0;
    Vec3 moment = Vec3::Zero();
    for (int c = 0; c < subsamples_; ++c)
      for (int b = 0; b < subsamples_; ++b) {
        const PointOnAxis& y = points[1][voxel[1] * subsamples_ + b];
        const PointOnAxis& z = points[2][voxel[2] * subsamples_ + c];
        if (!y.inside || !z.inside) continue;
        const Rows rows = rows_at(y, z);
        for (int a = 0; a < subsamples_; ++a) {
          const PointOnAxis& x = points[0][voxel[0] * subsamples_ + a];
          if (!x.inside) continue;
          const double share = double(field_.count(cell_at(rows, x, y, z), tally));
          if (share == 0) continue;
          covered += share;
          moment += share * Vec3(a, b, c);
        }
      }
    const double fill = covered / (subsamples_ * subsamples_ * subsamples_);
    if (fill < kNegligible) return;
    const Vec3 centroid = ((moment / covered).array() + 0.5) / subsamples_ - 0.5;
    content.material[n] = material_of(tally, centroid);
    content.fill[n] = fill > 1 - kNegligible ? 1.0F : float(fill);
    if (content.fill[n] == 1) return;
    content.centroid[n] = CentroidOffset::from_offset(centroid);
  }

  /// Tally of a full voxel, with the fewest points that see every sample.
  [[nodiscard]] typename Field::Tally tally_of_full(const Points& sparse, const VoxelIndex& voxel) const {
    typename Field::Tally tally{};
    for (int c = 0; c < sparse_; ++c)
      for (int b = 0; b < sparse_; ++b) {
        const PointOnAxis& y = sparse[1][voxel[1] * sparse_ + b];
        const PointOnAxis& z = sparse[2][voxel[2] * sparse_ + c];
        const Rows rows = rows_at(y, z);
        for (int a = 0; a < sparse_; ++a)
          (void)field_.count(cell_at(rows, sparse[0][voxel[0] * sparse_ + a], y, z), tally);
      }
    return tally;
  }

  [[nodiscard]] bool all_inside(const Points& points, const VoxelIndex& voxel) const {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside &=
          points[axis][voxel[axis] * subsamples_].inside && points[axis][(voxel[axis] + 1) * subsamples_ - 1].inside;
    return inside;
  }

  /// The four rows of samples around a line along x: below and above in y at the lower z, then both at the upper z.
  using Rows = std::array<const Sample*, 4>;
  [[nodiscard]] Rows rows_at(const PointOnAxis& y, const PointOnAxis& z) const {
    return {&volume_.at(0, y.low, z.low), &volume_.at(0, y.high, z.low), &volume_.at(0, y.low, z.high),
            &volume_.at(0, y.high, z.high)};
  }

  [[nodiscard]] Cell<Sample> cell_at(const Rows& rows, const PointOnAxis& x, const PointOnAxis& y,
                                     const PointOnAxis& z) const {
    Cell<Sample> cell;
    for (std::size_t n = 0; n < 4; ++n) {
      cell.corner[2 * n] = rows[n][x.low];
      cell.corner[2 * n + 1] = rows[n][x.high];
    }
    cell.weight = {x.weight, y.weight, z.weight};
    cell.step = {box_.x(), box_.y(), box_.z()};
    return cell;
  }
  [[nodiscard]] Cell<Sample> cell_at(const Vec3& place) const {
    const PointOnAxis y = point_at(1, place.y()), z = point_at(2, place.z());
    return cell_at(rows_at(y, z), point_at(0, place.x()), y, z);
  }

  /// [1] filled fraction; smaller than the resolution of a centroid step
  static constexpr double kNegligible = 1.0 / 2048;

  const Volume<Sample>& volume_;
  const Field& field_;
  IndexBox samples_;
  Vec3 first_, step_;
  int subsamples_, sparse_;
  Eigen::Vector3f box_ = Eigen::Vector3f::Zero();  ///< [samples] size of the box around a point
};

}  // namespace hapticut
