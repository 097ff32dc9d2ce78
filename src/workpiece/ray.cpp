// SPDX-License-Identifier: Apache-2.0
// Rays through a workpiece.
#include "hapticut/workpiece/ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "workpiece/state.hpp"

namespace hapticut {
namespace {

constexpr double kLevel = 0.5;  // [1] the surface, as that of extract_surface
constexpr double kFlat = 1e-9;  // [1 per voxel] a slope of the fill that is only rounding

/// A part of a ray, by the distance [voxels] from its origin.
struct Stretch {
  double begin, end;
  [[nodiscard]] bool empty() const { return !(begin <= end); }
};

/// A ray in the voxel grid, with the centres of voxels at whole numbers.
struct GridRay {
  Vec3 origin;     // [voxels]
  Vec3 direction;  // [1]

  [[nodiscard]] Vec3 at(double t) const { return origin + t * direction; }

  /// The part of a stretch that is inside a box.
  [[nodiscard]] Stretch within(const Vec3& min, const Vec3& max, Stretch part) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1 / direction[axis];  // may be infinite
      double near = (min[axis] - origin[axis]) * inverse, far = (max[axis] - origin[axis]) * inverse;
      if (near > far) std::swap(near, far);
      if (direction[axis] != 0) {
        part = {std::max(part.begin, near), std::min(part.end, far)};
      } else if (origin[axis] < min[axis] || origin[axis] > max[axis]) {
        return {0, -1};
      }
    }
    return part;
  }

  /// Calls `function(first corner, part of the ray)` for each cube of a lattice that the ray crosses, in their order,
  /// until it returns true.
  template <class Function>
  bool for_each_cube(int edge, const Stretch& part, const Function& function) const {
    const Vec3 from = at(part.begin);
    VoxelIndex cube;
    std::array<double, 3> next;  // [voxels] where the ray leaves the cube along each axis
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto n = Eigen::Index(axis);
      cube[axis] = edge * int(std::floor(from[n] / edge));
      if (direction[n] < 0 && from[n] == cube[axis]) cube[axis] -= edge;
      next[axis] = face(cube, edge, axis);
    }
    for (double t = part.begin; t <= part.end;) {
      const auto axis = std::size_t(std::min_element(next.begin(), next.end()) - next.begin());
      const double leaves = std::max(t, next[axis]);
      if (function(cube, Stretch{t, std::min(leaves, part.end)})) return true;
      if (!(leaves < part.end)) return false;
      t = leaves;
      cube[axis] += direction[Eigen::Index(axis)] > 0 ? edge : -edge;
      next[axis] = face(cube, edge, axis);
    }
    return false;
  }

 private:
  [[nodiscard]] double face(const VoxelIndex& cube, int edge, std::size_t axis) const {
    const double along = direction[Eigen::Index(axis)];
    if (along == 0) return std::numeric_limits<double>::infinity();
    return (cube[axis] + (along > 0 ? edge : 0) - origin[Eigen::Index(axis)]) / along;
  }
};

/// The first place where the cubic through four values at 0, 1, 2, 3 is not negative; negative if there is none.
double first_rise(const std::array<double, 4>& g) {
  if (g[0] >= 0) return 0;
  const double d1 = g[1] - g[0], d2 = g[2] - 2 * g[1] + g[0], d3 = g[3] - 3 * g[2] + 3 * g[1] - g[0];
  const auto value = [&](double x) { return g[0] + x * (d1 + (x - 1) / 2 * (d2 + (x - 2) / 3 * d3)); };
  // Between its turning points the cubic is monotone.
  const double a = d3 / 2, b = d2 - d3, c = d1 - d2 / 2 + d3 / 3;  // coefficients of the slope
  std::array<double, 3> ends = {3, 3, 3};
  if (const double root = b * b - 4 * a * c; root >= 0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
    double low = a != 0 ? q / a : -1, high = q != 0 ? c / q : -1;
    if (low > high) std::swap(low, high);
    std::size_t count = 0;
    for (const double turn : {low, high})
      if (turn > 0 && turn < 3) ends[count++] = turn;
  }
  double from = 0;
  for (double to : ends) {
    if (value(to) < 0) {
      from = to;
      continue;
    }
    for (int n = 0; n < 60 && from < to; ++n) {
      const double middle = 0.5 * (from + to);
      if (middle == from || middle == to) break;
      (value(middle) < 0 ? from : to) = middle;
    }
    return to;
  }
  return -1;
}

/// The fills of the blocks around a cube of 8 x 8 x 8 cells, each between eight centres of voxels.
class Cells {
 public:
  Cells(const Workpiece& workpiece, MaterialId material) : workpiece_(workpiece), material_(material) {}

  /// Moves to the cells between the centres of `origin` and `origin` + 8.
  /// @return false if no cell contains anything of the material
  bool move_to(const VoxelIndex& origin) {
    bool any = false;
    for (std::size_t n = 0; n < 8; ++n) {
      blocks_[n] = workpiece_.block({origin[0] + (n & 4U ? kBlockEdge : 0), origin[1] + (n & 2U ? kBlockEdge : 0),
                                     origin[2] + (n & 1U ? kBlockEdge : 0)});
      any |= may_contain(blocks_[n]);
    }
    origin_ = origin;
    return any;
  }

  /// Loads the corners of a cell.  @return false if they are all below the level
  bool load(VoxelIndex cell) {
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis)  // rounding may lead beyond the last cell
      cell[axis] = std::clamp(cell[axis], origin_[axis], origin_[axis] + kBlockEdge - 1);
    for (int n = 0; n < 8; ++n) {
      const int i = cell[0] - origin_[0] + (n >> 2), j = cell[1] - origin_[1] + (n >> 1 & 1),
                k = cell[2] - origin_[2] + (n & 1);
      const BlockView& block = blocks_[std::size_t((i >> 3) << 2 | (j >> 3) << 1 | k >> 3)];
      const int voxel = block_offset(i & 7, j & 7, k & 7);
      const MaterialId id = block.material_of(voxel);
      const bool counts = id != kEmpty && (material_ == kEmpty || id == material_);
      id_[std::size_t(n)] = counts ? id : kEmpty;
      fill_[std::size_t(n)] = counts ? double(block.fill_of(voxel)) : 0.0;
      any |= fill_[std::size_t(n)] >= kLevel;
    }
    cell_ = Vec3(cell[0], cell[1], cell[2]);
    return any;
  }

  /// [1] The fill between the corners, trilinear.
  [[nodiscard]] double fill_at(const Vec3& p) const {
    double sum = 0;
    for (int n = 0; n < 8; ++n) sum += weight(n, p) * fill_[std::size_t(n)];
    return sum;
  }
  [[nodiscard]] Vec3 slope_at(const Vec3& p) const {
    Vec3 sum = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 low = p, high = p;
      low[axis] = cell_[axis], high[axis] = cell_[axis] + 1;
      sum[axis] = fill_at(high) - fill_at(low);
    }
    return sum;
  }
  /// The material with the largest share in the fill of a point.
  [[nodiscard]] MaterialId material_at(const Vec3& p) const {
    double largest = -1;
    MaterialId id = kEmpty;
    for (int n = 0; n < 8; ++n) {
      const double share = weight(n, p) * fill_[std::size_t(n)];
      if (id_[std::size_t(n)] == kEmpty || share <= largest) continue;
      largest = share;
      id = id_[std::size_t(n)];
    }
    return id;
  }

 private:
  [[nodiscard]] bool may_contain(const BlockView& block) const {
    if (block.empty()) return false;
    if (material_ == kEmpty) return true;
    if (block.material == nullptr) return block.uniform_material == material_;
    return std::memchr(block.material, material_, kBlockVoxels) != nullptr;
  }
  [[nodiscard]] double weight(int corner, const Vec3& p) const {
    const Vec3 from = (p - cell_).cwiseMax(0).cwiseMin(1);
    return ((corner & 4) != 0 ? from.x() : 1 - from.x()) * ((corner & 2) != 0 ? from.y() : 1 - from.y()) *
           ((corner & 1) != 0 ? from.z() : 1 - from.z());
  }

  const Workpiece& workpiece_;
  const MaterialId material_;  // kEmpty: any
  std::array<BlockView, 8> blocks_;
  VoxelIndex origin_ = {};
  Vec3 cell_ = Vec3::Zero();
  std::array<double, 8> fill_ = {};
  std::array<MaterialId, 8> id_ = {};
};

}  // namespace

std::optional<RayHit> Workpiece::first_hit(const Vec3& origin_W, const Vec3& direction_W, double max_length,
                                           MaterialId material) const noexcept {
  const double length = direction_W.stableNorm();
  if (!is_finite(origin_W) || !is_finite(direction_W) || !(length > 0) || !(max_length >= 0)) return std::nullopt;
  const Pose X_VW = frame().X_WV.inverse();
  const double size = voxel_size();
  const GridRay ray{X_VW * origin_W / size, X_VW.rotation * direction_W.stableNormalized()};
  openvdb::CoordBBox box;  // around all nodes of the tree
  for (auto trunk = state_->trees->material.root().cbeginChildOn(); trunk; ++trunk)
    box.expand(trunk->getNodeBoundingBox());
  if (box.empty()) return std::nullopt;
  const auto corner = [](const openvdb::Coord& c) { return Vec3(c.x(), c.y(), c.z()); };
  const Stretch part =
      ray.within(corner(box.min().offsetBy(-1)), corner(box.max().offsetBy(1)), {0, max_length / size});
  if (part.empty()) return std::nullopt;

  Cells cells(*this, material);
  std::optional<RayHit> hit;
  ray.for_each_cube(kBlockEdge, part, [&](const VoxelIndex& origin, const Stretch& in_block) {
    if (!cells.move_to(origin)) return false;
    return ray.for_each_cube(1, in_block, [&](const VoxelIndex& cell, const Stretch& in_cell) {
      if (!cells.load(cell)) return false;
      const double third = (in_cell.end - in_cell.begin) / 3;
      std::array<double, 4> beyond;  // [1] the level; along a line the fill is a cubic
      for (int n = 0; n < 4; ++n) beyond[std::size_t(n)] = cells.fill_at(ray.at(in_cell.begin + n * third)) - kLevel;
      const double rise = first_rise(beyond);
      if (rise < 0) return false;
      const double t = in_cell.begin + rise * third;
      const Vec3 p = ray.at(t), inwards = cells.slope_at(p);
      hit.emplace();
      hit->distance = t * size;
      hit->point_W = frame().X_WV * Vec3(size * p);
      if (const double steep = inwards.norm(); steep > kFlat)
        hit->normal_W = frame().X_WV.rotation * (-inwards / steep);
      hit->material = cells.material_at(p);
      return true;
    });
  });
  return hit;
}

}  // namespace hapticut
