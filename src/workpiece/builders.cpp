// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/builders.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "workpiece/coverage.hpp"

namespace hapticut {
namespace {

constexpr double kNoise = 1e-6;  // [voxels] a voxel counts if more of it is filled

std::string text_of(const Vec3& p) {
  return "(" + format_number(p.x()) + ", " + format_number(p.y()) + ", " + format_number(p.z()) + ")";
}

void validate(const Box& box, double voxel_size) {
  require_positive(voxel_size, "voxel size [m]");
  require_metres(voxel_size, kMaxVoxelSize, "voxel size [m]");
  if (!is_finite(box.min) || !is_finite(box.max) || !((box.max - box.min).minCoeff() > 0))
    throw Error("the box of a workpiece is from " + text_of(box.min) + " to " + text_of(box.max) +
                " m; it must be finite and have max > min along every axis.");
  if (!((box.max - box.min).maxCoeff() / voxel_size < 1e9))
    throw Error("the box of a workpiece is " + format_number((box.max - box.min).maxCoeff() / voxel_size) +
                " voxels long; choose a larger voxel size.");
}

/// Grid whose voxel (0,0,0) fills the lower corner of the box.
GridFrame frame_at_corner(const Box& box, double voxel_size) {
  return {voxel_size, Pose::from_translation(box.min + Vec3::Constant(voxel_size / 2))};
}

IndexBox voxels_of(const Box& box, double voxel_size) {
  IndexBox voxels;
  for (int axis = 0; axis < 3; ++axis) {
    voxels.min[axis] = 0;
    voxels.max[axis] = int(std::ceil((box.max[axis] - box.min[axis]) / voxel_size - kNoise)) - 1;
  }
  return voxels;
}

}  // namespace

Workpiece build_body(const BodyDescription& body, double voxel_size, MaterialTable materials, int subsamples) {
  validate(body.box, voxel_size);
  require_between(subsamples, 1, 32, "subsamples per voxel edge");
  const GridFrame frame = frame_at_corner(body.box, voxel_size);
  const double voxel_reach = std::sqrt(3.0) / 2 * voxel_size;
  const double block_reach = kBlockEdge * voxel_reach;

  const auto fill_block = [&](const VoxelIndex& origin, BlockContent& content) {
    const Vec3 block_center = frame.center(origin) + Vec3::Constant((kBlockEdge - 1) / 2.0 * voxel_size);
    const double block_distance = body.distance(block_center);
    if (block_distance > block_reach) return BlockKind::empty();
    const bool wholly_inside = block_distance <= -block_reach;
    BlockCoverage block(body.distance, frame, origin, subsamples);
    for (int n = 0; n < kBlockVoxels; ++n) {
      const auto [x, y, z] = place_in_block(n);
      const Vec3 center = frame.center({origin[0] + x, origin[1] + y, origin[2] + z});
      const double distance = wholly_inside ? -voxel_reach : block.at_center(x, y, z);
      content.material[n] = kEmpty;
      content.fill[n] = 0;
      content.centroid[n] = {};
      if (distance > voxel_reach) continue;
      if (distance <= -voxel_reach) {
        content.material[n] = body.material(center);
        content.fill[n] = 1;
        continue;
      }
      const Coverage coverage = block.coverage(x, y, z);
      if (coverage.fill == 0) continue;
      content.material[n] = body.material(center + voxel_size * coverage.offset);
      content.fill[n] = float(coverage.fill);
      if (coverage.fill < 1) content.centroid[n] = CentroidOffset::from_offset(coverage.offset);
    }
    return BlockKind::mixed();
  };
  return Workpiece::from_blocks(voxels_of(body.box, voxel_size), frame, std::move(materials), fill_block);
}

Workpiece build_block(const Box& box, double voxel_size, Material material) {
  return build_layered_slab(box, voxel_size, {{std::move(material), box.max.z() - box.min.z()}});
}

Workpiece build_layered_slab(const Box& box, double voxel_size, const std::vector<Layer>& layers) {
  validate(box, voxel_size);
  if (layers.empty()) throw Error("a layered slab needs at least one layer.");
  MaterialTable materials;
  std::vector<double> bottoms;  // [m] height at which each layer ends
  double height = box.max.z();
  for (const Layer& layer : layers) {
    require_positive(layer.thickness, "Layer::thickness [m]");
    materials.add(layer.material);
    bottoms.push_back(std::max(height -= layer.thickness, box.min.z()));
  }
  const GridFrame frame = frame_at_corner(box, voxel_size);

  // All faces are axis-aligned. The fill of a voxel is exactly the product of its covered fractions along x, y and z,
  // and its centroid is the middle of the covered intervals. A voxel that an inner face cuts gets the material with the
  // larger part.
  struct Covered {
    double fraction, middle;  // [voxel edges], middle from the voxel's centre
  };
  const double lowest = std::max(box.min.z(), bottoms.back());
  const auto covered = [&](int axis, int index) -> Covered {
    const double center = frame.X_WV.translation[axis] + voxel_size * index;
    const double from = std::max(-0.5, ((axis == 2 ? lowest : box.min[axis]) - center) / voxel_size);
    const double to = std::min(0.5, (box.max[axis] - center) / voxel_size);
    if (to - from >= 1 - kNoise) return {1, 0};
    return to > from ? Covered{to - from, (from + to) / 2} : Covered{0, 0};
  };
  const auto material_at = [&](double z) {
    std::size_t layer = 0;
    while (layer + 1 < bottoms.size() && z < bottoms[layer]) ++layer;
    return MaterialId(layer + 1);
  };
  const auto material_of_row = [&](int index) {
    return material_at(frame.X_WV.translation.z() + voxel_size * (index + covered(2, index).middle));
  };
  const IndexBox voxels = voxels_of(box, voxel_size);
  double top = box.max.z();  // [m] top of the layer
  for (std::size_t n = 0; n < layers.size() && top - box.min.z() > kNoise * voxel_size; top = bottoms[n++]) {
    const int row = std::min(int((top - box.min.z()) / voxel_size), voxels.max[2]);
    const auto is_of_layer = [&](int k) {
      return k >= 0 && covered(2, k).fraction > kNoise && material_of_row(k) == MaterialId(n + 1);
    };
    if (!is_of_layer(row) && !is_of_layer(row - 1) && !is_of_layer(row - 2))
      throw Error("layer " + std::to_string(n + 1) + " of the slab, '" + layers[n].material.name + "', is " +
                  format_number(layers[n].thickness / units::mm) + " mm thick; no row of voxels of " +
                  format_number(voxel_size / units::mm) + " mm lies mostly in it. Choose smaller voxels.");
  }
  const auto fill_block = [&](const VoxelIndex& origin, BlockContent& content) {
    std::array<std::array<Covered, kBlockEdge>, 3> along;
    bool full = true;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < kBlockEdge; ++i) {
        along[axis][i] = covered(axis, origin[axis] + i);
        full &= along[axis][i].fraction == 1;
      }
    const MaterialId highest = material_of_row(origin[2] + kBlockEdge - 1);
    if (full && material_of_row(origin[2]) == highest) return BlockKind::solid(highest);
    for (int n = 0; n < kBlockVoxels; ++n) {
      const VoxelIndex at = place_in_block(n);
      const Covered &x = along[0][at[0]], &y = along[1][at[1]], &z = along[2][at[2]];
      const double fill = x.fraction * y.fraction * z.fraction;
      content.material[n] = fill > kNoise ? material_of_row(origin[2] + at[2]) : kEmpty;
      content.fill[n] = fill > kNoise ? float(fill) : 0;
      content.centroid[n] = fill < 1 ? CentroidOffset::from_offset({x.middle, y.middle, z.middle}) : CentroidOffset{};
    }
    return BlockKind::mixed();
  };
  return Workpiece::from_blocks(voxels, frame, std::move(materials), fill_block);
}

Workpiece build_sphere(const Vec3& center, double radius, double voxel_size, Material material) {
  require_positive(radius, "sphere radius [m]");
  const Vec3 reach = Vec3::Constant(radius);
  return build_body({{center - reach, center + reach},
                     [center, radius](const Vec3& p) { return (p - center).norm() - radius; },
                     [](const Vec3&) { return MaterialId(1); }},
                    voxel_size, MaterialTable({std::move(material)}));
}

}  // namespace hapticut
