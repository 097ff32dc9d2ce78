// SPDX-License-Identifier: Apache-2.0
#include "hapticut/build/mesh_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "build/crossings.hpp"
#include "build/lost_parts.hpp"
#include "build/orient.hpp"
#include "build/surface_check.hpp"
#include "build/volume_sampling.hpp"  // kMaxSubsamples
#include "build/voxel_amounts.hpp"
#include "build/winding_number.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/block_grid.hpp"

namespace hapticut {
namespace {

using Triangle = WindingNumber::Triangle;

constexpr double kInside = 0.5;
constexpr double kUncertain = 0.2;   // distance from one half: closer winding numbers mean a hole nearby
constexpr double kDecided = 0.05;    // distance from 0 or 1: closer winding numbers mean no hole nearby
constexpr double kConsistent = 0.2;  // allowed difference between two computations of a winding number
constexpr int kOpenSubsamples = 4;   // points per edge if every point needs its own winding number
/// Allowed fraction of the voxels that a surface cuts with loose edges in them. An incisor's crown that is open at the
/// neck has 1 %, loose triangles have 20 % or more.
constexpr double kMaxRaggedFraction = 0.1;

/// A shell for the voxeliser.
class ShellSampler {
 public:
  ShellSampler(const TriangleMesh& mesh, double voxel_size) : winding_(mesh), measure_(measure_surface(mesh)) {
    require_no_lost_part(mesh, winding_, voxel_size);
  }

  [[nodiscard]] const SurfaceMeasure& measure() const { return measure_; }

  enum class Voxel : std::uint8_t { outside, inside, cut, open, unknown };

  /// Classification of the voxels of one block.
  struct Block {
    bool uniform = true;
    bool inside = false;                     // the whole block, if uniform
    std::array<Voxel, kBlockVoxels> voxels;  // if not uniform
    std::vector<std::uint32_t> first;        // [513] voxel n is cut by cutting[first[n]] ... cutting[first[n + 1]]
    std::vector<const Triangle*> cutting;
    int cut = 0;            // sampled voxels that triangles cut
    int ragged = 0;         // those with loose edges: the triangles do not explain the winding number
    bool overlaps = false;  // the surface winds more than once around a point

    [[nodiscard]] Voxel at(int n) const {
      if (!uniform) return voxels[std::size_t(n)];
      return inside ? Voxel::inside : Voxel::outside;
    }
  };

  /// @param corner  lower corner of the block's first voxel
  void enter(const Vec3& corner, double voxel_size, Block& block) const {
    const double edge = kBlockEdge * voxel_size;
    std::vector<const Triangle*> touching;
    winding_.append_touching(corner, corner + Vec3::Constant(edge), touching);
    block.cutting.clear();
    block.uniform = touching.empty() && uniform_without_triangles(corner, edge, block.inside);
    if (block.uniform) return;
    sort_into_voxels(touching, corner, voxel_size, block);
    classify(corner, voxel_size, block);
  }

  /// Calls `mark(index of the subsample)` for the points of a voxel's lattice that are inside.
  template <class Mark>
  void subsample(Block& block, int n, const Vec3& center, double voxel_size, int points, const Mark& mark) const {
    const auto* begin = block.cutting.data() + block.first[std::size_t(n)];
    const auto* end = block.cutting.data() + block.first[std::size_t(n) + 1];
    // Within a voxel the winding number of a closed surface changes only at the triangles that cut the voxel. One value
    // and the crossings from there give the values at all points. The start is off every lattice, so that no segment
    // runs along edges.
    const Vec3 start = center + voxel_size * Vec3(0.0137, -0.0211, 0.0173);
    const Crossings crossings(start, begin, end);
    const double at_start = winding_.at(start);
    const auto explained = [&](double side) {
      const Vec3 check = center + voxel_size * side * Vec3(1, 0.97, 0.95);
      return std::abs(winding_.at(check) - at_start - crossings.to(check)) < kConsistent;
    };
    const bool decided = std::abs(at_start - std::round(at_start)) < kDecided;
    const bool consistent = explained(0.43) && (decided || explained(-0.43));
    if (begin != end) {
      ++block.cut;
      block.ragged += consistent ? 0 : 1;
    }
    const auto offset = [](int k, int count) { return (k + 0.5) / count - 0.5; };
    const int direct = std::min(points, kOpenSubsamples);
    std::array<bool, kOpenSubsamples * kOpenSubsamples * kOpenSubsamples> known;
    if (!consistent)
      for (int m = 0; m < direct * direct * direct; ++m) {
        const Vec3 at(offset(m / (direct * direct), direct), offset(m / direct % direct, direct),
                      offset(m % direct, direct));
        known[std::size_t(m)] = winding_.at(center + voxel_size * at) > kInside;
      }
    for (int a = 0, m = 0; a < points; ++a)
      for (int b = 0; b < points; ++b)
        for (int c = 0; c < points; ++c, ++m) {
          bool inside;
          if (consistent) {
            const Vec3 at(offset(a, points), offset(b, points), offset(c, points));
            const double w = at_start + crossings.to(center + voxel_size * at);
            inside = w > kInside;
            block.overlaps |= std::abs(w - kInside) > 1;
          } else {
            const auto coarse = [&](int k) { return k * direct / points; };
            const int nearest = (coarse(a) * direct + coarse(b)) * direct + coarse(c);
            inside = known[std::size_t(nearest)];
          }
          if (inside) mark(m);
        }
  }

 private:
  /// A block without triangles is completely inside or outside, unless a hole runs through it.
  bool uniform_without_triangles(const Vec3& corner, double edge, bool& inside) const {
    const Vec3 half = Vec3::Constant(edge / 2);
    double w = winding_.at(corner + half);
    inside = w > kInside;
    for (int n = 0; n < 8 && std::abs(w - kInside) >= kUncertain && inside == (w > kInside); ++n)
      w = winding_.at(corner + edge * Vec3(n >> 2, n >> 1 & 1, n & 1));
    return std::abs(w - kInside) >= kUncertain && inside == (w > kInside);
  }

  /// Finds which voxels are inside. Two voxels without triangles that share a face are on the same side of a surface,
  /// unless a hole is near. Near a hole the winding number is not close to 0 or 1.
  void classify(const Vec3& corner, double voxel_size, Block& block) const {
    for (std::size_t n = 0; n < kBlockVoxels; ++n)
      block.voxels[n] = block.first[n] != block.first[n + 1] ? Voxel::cut : Voxel::unknown;
    for (int n = 0; n < kBlockVoxels; ++n) {
      Voxel& voxel = block.voxels[std::size_t(n)];
      if (voxel != Voxel::unknown) continue;
      const VoxelIndex at = place_in_block(n);
      const double w = winding_.at(corner + voxel_size * Vec3(at[0] + 0.5, at[1] + 0.5, at[2] + 0.5));
      voxel = std::abs(w - kInside) < kUncertain ? Voxel::open : w > kInside ? Voxel::inside : Voxel::outside;
      if (std::abs(w - std::round(w)) >= kDecided) continue;
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
          VoxelIndex next = at;
          next[std::size_t(axis)] += side;
          if (next[std::size_t(axis)] < 0 || next[std::size_t(axis)] >= kBlockEdge) continue;
          Voxel& neighbour = block.voxels[std::size_t(block_offset(next[0], next[1], next[2]))];
          if (neighbour == Voxel::unknown) neighbour = voxel;
        }
    }
  }

  static void sort_into_voxels(const std::vector<const Triangle*>& touching, const Vec3& corner, double voxel_size,
                               Block& block) {
    std::vector<std::pair<std::uint32_t, const Triangle*>> pairs;
    for (const Triangle* t : touching) {
      const Vec3 low = ((*t)[0].cwiseMin((*t)[1]).cwiseMin((*t)[2]) - corner) / voxel_size;
      const Vec3 high = ((*t)[0].cwiseMax((*t)[1]).cwiseMax((*t)[2]) - corner) / voxel_size;
      IndexBox voxels;
      for (int axis = 0; axis < 3; ++axis) {
        voxels.min[std::size_t(axis)] = int(std::floor(std::clamp(low[axis] - 1e-9, 0.0, kBlockEdge - 1.0)));
        voxels.max[std::size_t(axis)] = int(std::floor(std::clamp(high[axis] + 1e-9, 0.0, kBlockEdge - 1.0)));
      }
      for_each_voxel(voxels, [&](const VoxelIndex& at) {
        if (touches_cube(*t, corner + voxel_size * Vec3(at[0] + 0.5, at[1] + 0.5, at[2] + 0.5), voxel_size / 2))
          pairs.emplace_back(std::uint32_t(block_offset(at[0], at[1], at[2])), t);
      });
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    block.first.assign(kBlockVoxels + 1, 0);
    for (const auto& [voxel, t] : pairs) {
      ++block.first[voxel + 1];
      block.cutting.push_back(t);
    }
    for (std::size_t n = 0; n < kBlockVoxels; ++n) block.first[n + 1] += block.first[n];
  }

  WindingNumber winding_;
  SurfaceMeasure measure_;
};

std::string mm_text(double length) { return format_number(length / units::mm) + " mm"; }

/// Number of voxels found of a shell; written by several threads.
struct Found {
  std::atomic<std::int64_t> inside{0};  // voxels that are inside, completely or partly
  std::atomic<std::int64_t> cut{0};     // by triangles
  std::atomic<std::int64_t> ragged{0};  // cut by triangles with loose edges
  std::atomic<std::int64_t> points{0};  // points of the voxels' lattices that are inside
  std::atomic<bool> overlaps{false};
};

class ShellsFiller {
 public:
  ShellsFiller(const std::vector<MeshShell>& shells, const GridFrame& frame, int points)
      : shells_(shells), frame_(frame), points_(points), found_(shells.size()) {
    for (const MeshShell& shell : shells)
      samplers_.push_back(std::make_unique<ShellSampler>(oriented(shell.mesh), frame.voxel_size));
  }

  BlockKind operator()(const VoxelIndex& origin, BlockContent& content) {
    const double h = frame_.voxel_size;
    std::vector<ShellSampler::Block> blocks(shells_.size());
    bool uniform = true;
    MaterialId material = kEmpty;
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      samplers_[s]->enter(frame_.center(origin) - Vec3::Constant(h / 2), h, blocks[s]);
      uniform &= blocks[s].uniform;
      if (blocks[s].uniform && blocks[s].inside) {
        found_[s].inside += kBlockVoxels;
        material = shells_[s].material;
      }
    }
    if (uniform) {
      const std::int64_t all = kBlockVoxels * std::int64_t(points_ * points_ * points_);
      for (std::size_t s = 0; s < shells_.size(); ++s)
        if (blocks[s].inside) found_[s].points += all;
      points_of_[material] += all;
      return material == kEmpty ? BlockKind::empty() : BlockKind::solid(material);
    }

    std::vector<MaterialId> points(std::size_t(points_ * points_ * points_));
    ByMaterial<int> count{};
    for (int n = 0; n < kBlockVoxels; ++n)
      fill_voxel(blocks, n, frame_.center(voxel_at(origin, n)), points, count, content);
    for (std::size_t id = 0; id < count.size(); ++id)
      if (count[id] > 0) points_of_[id] += count[id];
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      found_[s].cut += blocks[s].cut;
      found_[s].ragged += blocks[s].ragged;
      if (blocks[s].overlaps) found_[s].overlaps = true;
    }
    return BlockKind::mixed();
  }

  /// Checks the shells after filling.  @param length  [m] of all shells together
  /// @param warn  may be empty; as MeshImport::warn
  /// @throws Error if a shell encloses nothing, or if it is too open
  void check(double length, const Workpiece& workpiece, const std::function<void(const std::string&)>& warn) const {
    const double volume_of_point = std::pow(frame_.voxel_size / points_, 3);
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      const std::string which = shells_.size() > 1 ? "surface " + std::to_string(s + 1) : "the surface";
      if (found_[s].inside == 0)
        throw Error(
            which + " encloses nothing that voxels of " + mm_text(frame_.voxel_size) + " can show, and the model is " +
            mm_text(length) + " long; " +
            (length < 4 * frame_.voxel_size ? "check its unit (" + "unit_mm"_name + " of read_mesh)" : "close it") +
            ", or choose smaller voxels.");
      const double cut = double(found_[s].cut), ragged = double(found_[s].ragged);
      if (ragged > kMaxRaggedFraction * cut)
        throw Error(which + " is too open to decide what is inside: its triangles have loose edges in " +
                    format_number(ragged) + " of the " + format_number(cut) + " voxels they cut. Close its holes.");
      check_surface(samplers_[s]->measure(), which, double(found_[s].points) * volume_of_point, found_[s].overlaps,
                    frame_.voxel_size, warn);
    }
    if (!warn) return;
    ByMaterial<double> wanted{};
    for (std::size_t id = 0; id < wanted.size(); ++id) wanted[id] = double(points_of_[id]) * volume_of_point;
    if (const std::string found = differences_of(workpiece, wanted, "surfaces"); !found.empty())
      warn(found + "Choose smaller voxels.");
  }

 private:
  void fill_voxel(std::vector<ShellSampler::Block>& blocks, int n, const Vec3& center, std::vector<MaterialId>& points,
                  ByMaterial<int>& count, BlockContent& content) {
    using Voxel = ShellSampler::Voxel;
    bool whole = true;  // no surface within the voxel so far
    MaterialId material = kEmpty;
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      const MaterialId id = shells_[s].material;
      const Voxel voxel = blocks[s].at(n);
      if (voxel == Voxel::outside) continue;
      if (voxel == Voxel::inside) {
        ++found_[s].inside;
        found_[s].points += points_ * points_ * points_;
        whole = true;
        material = id;
        continue;
      }
      if (whole) std::fill(points.begin(), points.end(), material);
      whole = false;
      int inside = 0;
      samplers_[s]->subsample(blocks[s], n, center, frame_.voxel_size, points_, [&](int m) {
        points[std::size_t(m)] = id;
        ++inside;
      });
      found_[s].points += inside;
      if (inside > 0) ++found_[s].inside;
    }
    content.centroid[n] = {};
    content.material[n] = material;
    content.fill[n] = material == kEmpty ? 0.0F : 1.0F;
    if (whole)
      count[material] += points_ * points_ * points_;
    else
      combine(points, n, count, content);
  }

  /// @param all_points  of the block, by material
  void combine(const std::vector<MaterialId>& points, int n, ByMaterial<int>& all_points, BlockContent& content) const {
    ByMaterial<int> count{};
    Vec3 sum = Vec3::Zero();
    int filled = 0;
    for (int a = 0, m = 0; a < points_; ++a)
      for (int b = 0; b < points_; ++b)
        for (int c = 0; c < points_; ++c, ++m) {
          const MaterialId id = points[std::size_t(m)];
          ++count[id];
          if (id == kEmpty) continue;
          ++filled;
          sum += Vec3(a, b, c);
        }
    for (std::size_t id = 0; id < count.size(); ++id) all_points[id] += count[id];
    count[kEmpty] = 0;
    const int all = points_ * points_ * points_;
    content.material[n] =
        filled == 0 ? kEmpty : MaterialId(std::max_element(count.begin(), count.end()) - count.begin());
    content.fill[n] = float(double(filled) / all);
    if (filled > 0 && filled < all)
      content.centroid[n] = CentroidOffset::from_offset(((sum / filled).array() + 0.5) / points_ - 0.5);
  }

  const std::vector<MeshShell>& shells_;
  GridFrame frame_;
  int points_;
  std::vector<Found> found_;
  ByMaterial<std::atomic<std::int64_t>> points_of_{};  // by the material of the last surface around them
  std::vector<std::unique_ptr<ShellSampler>> samplers_;
};

void validate(const std::vector<MeshShell>& shells, const MaterialTable& materials, const MeshImport& options) {
  require_positive(options.voxel_size, "MeshImport::voxel_size [m]");
  require_between(options.subsamples, 1, kMaxSubsamples, "MeshImport::subsamples");
  if (shells.empty()) throw Error("a workpiece from meshes needs at least one surface.");
  for (const MeshShell& shell : shells) {
    if (shell.mesh.triangles.empty()) throw Error("a surface has no triangles; it encloses nothing.");
    if (shell.material != kEmpty) (void)materials[shell.material];  // throws when it is not in the table
    for (const Vec3& v : shell.mesh.vertices)
      if (!is_finite(v)) throw Error("a surface has a vertex that is not finite; repair the mesh.");
    for (const auto& t : shell.mesh.triangles)
      for (const std::uint32_t v : t)
        if (v >= shell.mesh.vertices.size())
          throw Error("a triangle names vertex " + std::to_string(v) + ", but the surface has only " +
                      std::to_string(shell.mesh.vertices.size()) + " vertices.");
  }
}

}  // namespace

Workpiece build_from_shells(const std::vector<MeshShell>& shells, MaterialTable materials, const MeshImport& options) {
  validate(shells, materials, options);
  Eigen::AlignedBox3d around;
  for (const MeshShell& shell : shells)
    for (const auto& t : shell.mesh.triangles)
      for (const std::uint32_t v : t) around.extend(shell.mesh.vertices[v]);
  const double length = around.sizes().maxCoeff();
  const Vec3 voxels = around.sizes() / options.voxel_size;
  if (!(voxels.maxCoeff() < 1e9))
    throw Error("the surface is " + mm_text(length) + " long, that is " + format_number(voxels.maxCoeff()) +
                " voxels; check its unit (" + "unit_mm"_name + " of read_mesh), or choose a larger voxel size.");
  const WorkEstimate estimate = estimate_work(shells, options);
  if (options.observer) options.observer(estimate);
  require_allowed(estimate, options.large);
  IndexBox domain;
  for (int axis = 0; axis < 3; ++axis) {
    domain.min[std::size_t(axis)] = 0;
    domain.max[std::size_t(axis)] = int(std::ceil(voxels[axis] - 1e-6)) - 1;
  }
  const GridFrame frame{options.voxel_size,
                        Pose::from_translation(around.min() + Vec3::Constant(options.voxel_size / 2))};
  ShellsFiller filler(shells, frame, options.subsamples);
  Workpiece workpiece = Workpiece::from_blocks(domain, frame, std::move(materials), std::ref(filler));
  filler.check(length, workpiece, options.warn);
  if (workpiece.empty()) throw Error("the workpiece is empty: the last surfaces make cavities of everything inside.");
  return workpiece;
}

Workpiece build_from_mesh(const TriangleMesh& mesh, Material material, const MeshImport& options) {
  return build_from_shells({{mesh, 1}}, MaterialTable({std::move(material)}), options);
}

}  // namespace hapticut
