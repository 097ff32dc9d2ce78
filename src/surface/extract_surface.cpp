// SPDX-License-Identifier: Apache-2.0
#include "hapticut/surface/extract_surface.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <unordered_map>

#include "core/interruption.hpp"
#include "surface/block_codes.hpp"
#include "surface/block_mesher.hpp"

namespace hapticut {
namespace {

using surface::BlockNet;
using surface::BlockSamples;
using surface::NetVertex;

/// Views of all blocks that are not uniform, and the materials of the others.
struct ViewedBlocks {
  explicit ViewedBlocks(const Workpiece& workpiece) : codes(workpiece.bounds(), kBlockEdge) {
    workpiece.for_each_block([&](const BlockView& view) {
      if (view.material == nullptr && view.fill == nullptr) {
        codes[view.origin] = view.uniform_material;
        return;
      }
      codes[view.origin] = surface::BlockCodes::kMixed + std::uint32_t(views.size());
      views.push_back(view);
    });
  }

  surface::BlockCodes codes;
  std::vector<BlockView> views;
};

/// @param only  kEmpty: all materials
void read_views(const ViewedBlocks& blocks, const surface::CodesAround& around, MaterialId only,
                BlockSamples& samples) {
  surface::read_samples(
      samples, [&](const std::array<int, 3>& neighbour, int first, int count, float* fill, MaterialId* material) {
        const std::uint32_t code = around.at(neighbour);
        const BlockView* view =
            code < surface::BlockCodes::kMixed ? nullptr : &blocks.views[code - surface::BlockCodes::kMixed];
        for (int n = 0; n < count; ++n) {
          const int voxel = first + n;
          MaterialId id = view == nullptr ? MaterialId(code) : view->material_of(voxel);
          if (only != kEmpty && id != only) id = kEmpty;
          material[n] = id;
          fill[n] = id == kEmpty ? 0.0F : view == nullptr ? 1.0F : view->fill_of(voxel);
        }
      });
}

/// The nets of one slab of blocks, in the order of the blocks.
struct SlabNets {
  std::vector<VoxelIndex> origins;
  std::vector<BlockNet> nets;
};

std::vector<SlabNets> mesh_slabs(const ViewedBlocks& blocks, MaterialId only) {
  const auto& [nx, ny, nz] = blocks.codes.dims();
  const VoxelIndex first = blocks.codes.first();
  std::vector<SlabNets> slabs(std::size_t(std::max(0, nx)));
  tbb::parallel_for(tbb::blocked_range<int>(0, nx), [&, ny = ny, nz = nz](const tbb::blocked_range<int>& range) {
    BlockSamples samples;
    BlockNet net;
    for (int x = range.begin(); x < range.end(); ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z) {
          look_for_interruption();
          const VoxelIndex origin = {first[0] + kBlockEdge * x, first[1] + kBlockEdge * y, first[2] + kBlockEdge * z};
          const surface::CodesAround around(blocks.codes, origin);
          if (only == kEmpty && around.are_plain()) continue;
          read_views(blocks, around, only, samples);
          surface::mesh_block(samples, net);
          if (net.triangles.empty()) continue;
          slabs[std::size_t(x)].origins.push_back(origin);
          slabs[std::size_t(x)].nets.push_back(net);
        }
  });
  return slabs;
}

struct CellHash {
  std::size_t operator()(const VoxelIndex& cell) const {
    std::uint64_t hash = 0;
    for (const int i : cell) hash = (hash ^ std::uint32_t(i)) * 0x9e3779b97f4a7c15U;
    return std::size_t(hash >> 20);
  }
};

/// Joins nets; a vertex that several blocks share, because their seam passes its cell, becomes one.
class Welder {
 public:
  explicit Welder(const GridFrame& frame) : frame_(frame) {}

  void add(const VoxelIndex& origin, const BlockNet& net) {
    numbers_.clear();
    for (const NetVertex& vertex : net.vertices) numbers_.push_back(number_of(origin, vertex));
    for (const auto& t : net.triangles)
      welded.mesh.triangles.push_back({numbers_[t[0]], numbers_[t[1]], numbers_[t[2]]});
  }

  WorkpieceSurface welded;

 private:
  std::uint32_t number_of(const VoxelIndex& origin, const NetVertex& vertex) {
    const auto next = std::uint32_t(welded.mesh.vertices.size());
    const auto at_seam = [](int cell) { return cell < 0 || cell == kBlockEdge - 1; };
    if (at_seam(vertex.cell[0]) || at_seam(vertex.cell[1]) || at_seam(vertex.cell[2])) {
      VoxelIndex cell;
      for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = origin[axis] + vertex.cell[axis];
      const auto [place, is_new] = at_seams_.try_emplace(cell, next);
      if (!is_new) return place->second;
    }
    Vec3 p_V;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p_V[Eigen::Index(axis)] = origin[axis] + vertex.cell[axis] + double(vertex.in_cell[axis]);
    welded.mesh.vertices.push_back(frame_.X_WV * (frame_.voxel_size * p_V));
    welded.normals.push_back(
        (frame_.X_WV.rotation * Vec3(double(vertex.normal[0]), double(vertex.normal[1]), double(vertex.normal[2])))
            .normalized());
    welded.materials.push_back(vertex.material);
    return next;
  }

  const GridFrame& frame_;
  std::unordered_map<VoxelIndex, std::uint32_t, CellHash> at_seams_;
  std::vector<std::uint32_t> numbers_;  // numbers of a net's vertices in the mesh
};

WorkpieceSurface surface_of(const Workpiece& workpiece, MaterialId only) {
  const ViewedBlocks blocks(workpiece);
  Welder welder(workpiece.frame());
  for (const SlabNets& slab : mesh_slabs(blocks, only))
    for (std::size_t n = 0; n < slab.nets.size(); ++n) {
      look_for_interruption();
      welder.add(slab.origins[n], slab.nets[n]);
    }
  return std::move(welder.welded);
}

}  // namespace

WorkpieceSurface extract_surface(const Workpiece& workpiece) { return surface_of(workpiece, kEmpty); }

TriangleMesh extract_surface(const Workpiece& workpiece, MaterialId material) {
  (void)workpiece.materials()[material];  // throws when there is none
  return std::move(surface_of(workpiece, material).mesh);
}

}  // namespace hapticut
