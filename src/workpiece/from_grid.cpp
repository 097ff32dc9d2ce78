// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/openvdb.hpp"
#include "workpiece/grids.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

using openvdb::Coord;

constexpr int kPatchEdge = kBlockEdge + 2;  // a block and one voxel around it
constexpr float kVoxelReach = 0.8661F;      // [voxels] from the centre of a voxel to its corner, rounded up
constexpr float kFull = 1.001F;             // upper limit for a full voxel, with rounding of half floats

bool is_level_set(const openvdb::FloatGrid& grid, GridKind kind) {
  if (kind != GridKind::from_class) return kind == GridKind::level_set;
  if (grid.getGridClass() == openvdb::GRID_LEVEL_SET) return true;
  if (grid.getGridClass() == openvdb::GRID_FOG_VOLUME) return false;
  throw Error("grid '" + grid.getName() + "' is marked neither as a level set nor as a fog volume; set its kind with " +
              "GridImport::kind"_name + ".");
}

/// Values of the voxels of one block and of those around it, in voxels (level set) or fractions (fog volume).
struct Patch {
  std::array<float, kPatchEdge * kPatchEdge * kPatchEdge> values;

  [[nodiscard]] float at(int x, int y, int z) const {  // -1 ... 8
    const int n = ((x + 1) * kPatchEdge + y + 1) * kPatchEdge + z + 1;
    return values[std::size_t(n)];
  }

  /// Trilinear value at an offset from the centre of voxel (x, y, z).  @param offset [voxels] within +-0.5
  [[nodiscard]] double interpolated(int x, int y, int z, const Vec3& offset) const {
    const int x0 = x - (offset.x() < 0 ? 1 : 0), y0 = y - (offset.y() < 0 ? 1 : 0), z0 = z - (offset.z() < 0 ? 1 : 0);
    const double u = offset.x() + (x - x0), v = offset.y() + (y - y0), w = offset.z() + (z - z0);
    const auto along_z = [&](int i, int j) { return (1 - w) * double(at(i, j, z0)) + w * double(at(i, j, z0 + 1)); };
    return (1 - u) * ((1 - v) * along_z(x0, y0) + v * along_z(x0, y0 + 1)) +
           u * ((1 - v) * along_z(x0 + 1, y0) + v * along_z(x0 + 1, y0 + 1));
  }
};

class GridSampler {
 public:
  GridSampler(const openvdb::FloatGrid& grid, const openvdb::Int32Grid* ids, bool level_set, int subsamples)
      : grid_(grid),
        ids_(ids),
        level_set_(level_set),
        subsamples_(subsamples),
        // Level sets store distances in world units; the sampler uses distances in voxels.
        scale_(level_set ? float(1 / grid.voxelSize()[0]) : 1.0F) {}

  BlockKind operator()(const VoxelIndex& origin, BlockContent& content) const {
    const Coord at = to_coord(origin);
    if (grid_.tree().probeConstLeaf(at) == nullptr) {
      float value = 0;
      const bool active = grid_.tree().probeValue(at, value);
      check(value, active);
      const bool empty = level_set_ ? value * scale_ >= kVoxelReach : !(active && value > 0);
      const bool full = level_set_ ? value * scale_ <= -kVoxelReach : active && value >= 1;
      if (empty) return BlockKind::empty();
      if (full && uniform_id(at)) return BlockKind::solid(id_at(at));
    }
    const Patch patch = gather(at);
    for (int n = 0; n < kBlockVoxels; ++n) {
      const auto [x, y, z] = place_in_block(n);
      content.centroid[n] = {};
      if (level_set_)
        cover(patch, x, y, z, content.fill[n], content.centroid[n]);
      else
        content.fill[n] = std::clamp(patch.at(x, y, z), 0.0F, 1.0F);
      content.material[n] = content.fill[n] > 0 ? id_at(at.offsetBy(x, y, z)) : kEmpty;
    }
    return BlockKind::mixed();
  }

 private:
  void check(float value, bool active) const {
    if (!std::isfinite(value)) throw Error("grid '" + grid_.getName() + "' has a value that is not finite.");
    if (!level_set_ && active && value > kFull)
      throw Error("grid '" + grid_.getName() + "' has the value " + format_number(double(value), 1) +
                  ", but values of a fog volume are filled fractions, 0 to 1. Scale the values in the program that "
                  "wrote the grid, or save its surface as a level set.");
  }

  Patch gather(const Coord& at) const {
    Patch patch;
    const auto accessor = grid_.getConstUnsafeAccessor();
    std::size_t n = 0;
    for (int x = -1; x <= kBlockEdge; ++x)
      for (int y = -1; y <= kBlockEdge; ++y)
        for (int z = -1; z <= kBlockEdge; ++z) {
          float value = 0;
          const bool active = accessor.probeValue(at.offsetBy(x, y, z), value);
          check(value, active);
          patch.values[n++] = level_set_ || active ? value * scale_ : 0.0F;
        }
    return patch;
  }

  void cover(const Patch& patch, int x, int y, int z, float& fill, CentroidOffset& centroid) const {
    const float distance = patch.at(x, y, z);
    fill = distance < 0 ? 1.0F : 0.0F;
    if (subsamples_ == 1 || std::abs(distance) >= kVoxelReach) return;
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    for (int a = 0; a < subsamples_; ++a)
      for (int b = 0; b < subsamples_; ++b)
        for (int c = 0; c < subsamples_; ++c) {
          const Vec3 offset = (Vec3(a, b, c).array() + 0.5) / subsamples_ - 0.5;
          // The part of a cell that a plane along the grid at this distance covers.
          const double weight = std::clamp(0.5 - patch.interpolated(x, y, z, offset) * subsamples_, 0.0, 1.0);
          volume += weight;
          moment += weight * offset;
        }
    fill = float(volume / (subsamples_ * subsamples_ * subsamples_));
    if (fill > 0 && fill < 1) centroid = CentroidOffset::from_offset(moment / volume);
  }

  [[nodiscard]] bool uniform_id(const Coord& at) const {
    return ids_ == nullptr || ids_->tree().probeConstLeaf(at) == nullptr;
  }

  [[nodiscard]] MaterialId id_at(const Coord& at) const {
    if (ids_ == nullptr) return 1;
    const std::int32_t id = ids_->tree().getValue(at);
    if (id < 1 || id > kMaxMaterials)
      throw Error("a voxel that is not empty has material id " + std::to_string(id) +
                  " in the grid of materials; ids are 1 to 255 and must be in the material table.");
    return MaterialId(id);
  }

  const openvdb::FloatGrid& grid_;
  const openvdb::Int32Grid* ids_;
  bool level_set_;
  int subsamples_;
  float scale_;
};

Workpiece build_from(const openvdb::FloatGrid& grid, const openvdb::Int32Grid* ids, MaterialTable materials,
                     const GridImport& options) {
  require_between(options.subsamples, 1, 32, "GridImport::subsamples");
  const GridFrame frame = frame_of(grid.transform(), options.unit);
  const bool level_set = is_level_set(grid, options.kind);
  const auto band = double(grid.background());
  if (level_set && band < 0)
    throw Error("level set '" + grid.getName() +
                "' is inside out: its distances must be positive outside. Change their sign in the program that wrote "
                "the grid.");
  if (level_set && !(band > 0.87 * grid.voxelSize()[0]))
    throw Error("level set '" + grid.getName() + "' stores distances up to " + format_number(band) +
                ", but its voxels are " + format_number(grid.voxelSize()[0]) +
                " wide. Save it with distances in the unit of its transform, of at least one voxel on each side.");
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (box.empty()) throw Error("grid '" + grid.getName() + "' has no active voxels, so it contains no workpiece.");
  Workpiece workpiece = Workpiece::from_blocks({to_index(box.min()), to_index(box.max())}, frame, std::move(materials),
                                               GridSampler(grid, ids, level_set, options.subsamples));
  if (workpiece.empty())
    throw Error("grid '" + grid.getName() + "' encloses nothing: none of its voxels is " +
                (level_set ? "inside the surface." : "filled."));
  return workpiece;
}

}  // namespace

Workpiece workpiece_from_grid(const openvdb::FloatGrid& grid, Material material, const GridImport& options) {
  return build_from(grid, nullptr, MaterialTable({std::move(material)}), options);
}

Workpiece workpiece_from_grids(const openvdb::FloatGrid& grid, const openvdb::Int32Grid& ids, MaterialTable materials,
                               const GridImport& options) {
  if (grid.transform() != ids.transform())
    throw Error(
        "the grid of filled fractions and the grid of materials have different transforms; they must share one "
        "index space.");
  return build_from(grid, &ids, std::move(materials), options);
}

}  // namespace hapticut
