// SPDX-License-Identifier: Apache-2.0
#include "hapticut/surface/surface_stream.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "surface/block_codes.hpp"
#include "surface/block_mesher.hpp"

namespace hapticut {
namespace {

using surface::BlockCodes;
using surface::BlockNet;
using surface::BlockSamples;
using surface::CodesAround;
using surface::NetVertex;

constexpr int kSteps = SurfaceVertex::kStepsPerVoxel;
constexpr float kFull = 32768;  // a fill of 1 in 16 bits; a power of two, so that 1 and 0.5 are exact
constexpr int kBlocksOfPage = SurfacePage::kBlocks * SurfacePage::kBlocks * SurfacePage::kBlocks;
static_assert(kBlocksOfPage == 64, "one word marks the blocks of a page");

/// The copy of a block that is not uniform. A voxel without fill has no material.
struct StoredBlock {
  std::array<std::uint16_t, kBlockVoxels> fill;  // [1/32768]
  std::array<MaterialId, kBlockVoxels> material;

  void set(std::size_t n, MaterialId id, float filled) {
    const float bounded = id == kEmpty ? 0.0F : std::clamp(filled, 0.0F, 1.0F);
    const float steps = bounded * kFull + 0.5F;  // its integer part is rounded to nearest
    fill[n] = std::uint16_t(steps);
    material[n] = fill[n] == 0 ? kEmpty : id;
  }

  /// @return kMixed when it is not uniform
  [[nodiscard]] std::uint32_t code() const {
    const auto full = std::uint16_t(material[0] == kEmpty ? 0 : int(kFull));
    for (std::size_t n = 0; n < kBlockVoxels; ++n)
      if (material[n] != material[0] || fill[n] != full) return BlockCodes::kMixed;
    return material[0];
  }
};

struct BlockMesh {
  int block;  // number in the page, 0 ... 63
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint16_t> indices;
};

struct Page {
  std::uint64_t dirty = 0;        // bit: this block must be meshed
  bool waits = false;             // is in the heap
  bool resend = false;            // is returned even if unchanged
  std::vector<BlockMesh> meshes;  // meshes of blocks with a surface, in order
};

struct WaitingPage {
  double distance;  // [voxels^2]
  std::uint32_t page;
  /// Order of a max-heap: the nearest page comes first.
  bool operator<(const WaitingPage& other) const {
    return distance != other.distance ? distance > other.distance : page > other.page;
  }
};

/// A position rounded within its cell, which is position >> 9. So vertices of different cells never coincide, and a
/// vertex that two blocks or two pages share is the same in both.
std::int16_t rounded_position(int voxel, float in_cell) {
  const float steps = in_cell * float(kSteps) + 0.5F;  // its integer part is rounded to nearest
  return std::int16_t(kSteps * voxel + std::clamp(int(steps), 0, kSteps - 1));
}

void copy_view(const BlockView& view, StoredBlock& block) {
  for (int n = 0; n < kBlockVoxels; ++n) block.set(std::size_t(n), view.material_of(n), view.fill_of(n));
}

std::int8_t rounded_normal(float component) { return std::int8_t(std::lround(component * 127.0F)); }

}  // namespace

struct SurfaceStream::State {
  explicit State(const Workpiece& workpiece) : frame(workpiece.frame()), codes(workpiece.bounds(), SurfacePage::kEdge) {
    for (std::size_t axis = 0; axis < 3; ++axis) page_dims[axis] = codes.dims()[axis] / SurfacePage::kBlocks;
    pages.resize(codes.count() / kBlocksOfPage);
    for (int axis = 0; axis < 3; ++axis)
      focus[axis] = codes.first()[std::size_t(axis)] + 0.5 * kBlockEdge * codes.dims()[std::size_t(axis)];
  }

  [[nodiscard]] std::uint32_t page_of(const VoxelIndex& voxel) const {
    std::uint32_t number = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      number = number * std::uint32_t(page_dims[axis]) +
               std::uint32_t((voxel[axis] - codes.first()[axis]) / SurfacePage::kEdge);
    return number;
  }
  [[nodiscard]] VoxelIndex origin_of_page(std::uint32_t number) const {
    const int n = int(number), nz = page_dims[2], ny = page_dims[1];
    return {codes.first()[0] + SurfacePage::kEdge * (n / (ny * nz)),
            codes.first()[1] + SurfacePage::kEdge * (n / nz % ny), codes.first()[2] + SurfacePage::kEdge * (n % nz)};
  }
  [[nodiscard]] double distance_of(std::uint32_t page) const {
    const VoxelIndex origin = origin_of_page(page);
    const double half = 0.5 * (SurfacePage::kEdge - 1);
    return (Vec3(origin[0] + half, origin[1] + half, origin[2] + half) - focus).squaredNorm();
  }

  void enqueue(std::uint32_t number) {
    if (std::exchange(pages[number].waits, true)) return;
    waiting.push_back({distance_of(number), number});
    std::push_heap(waiting.begin(), waiting.end());
  }

  void mark(const VoxelIndex& origin) {
    if (!codes.contains(origin)) return;
    const std::uint32_t page = page_of(origin);
    int block = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      block = block * SurfacePage::kBlocks + (origin[axis] & (SurfacePage::kEdge - 1)) / kBlockEdge;
    pages[page].dirty |= std::uint64_t(1) << block;
    enqueue(page);
  }

  [[nodiscard]] StoredBlock as_stored(std::uint32_t code) const {
    if (code >= BlockCodes::kMixed) return *stored[code - BlockCodes::kMixed];
    StoredBlock block;
    block.fill.fill(std::uint16_t(code == kEmpty ? 0 : int(kFull)));
    block.material.fill(MaterialId(code));
    return block;
  }

  void store(const VoxelIndex& origin, const StoredBlock& block) {
    std::uint32_t& code = codes[origin];
    const std::uint32_t now = block.code();
    if (now < BlockCodes::kMixed) {
      if (code >= BlockCodes::kMixed) free_codes.push_back(code);
      code = now;
      return;
    }
    if (code < BlockCodes::kMixed) {
      if (free_codes.empty()) {
        free_codes.push_back(BlockCodes::kMixed + std::uint32_t(stored.size()));
        stored.push_back(std::make_unique<StoredBlock>());
      }
      code = free_codes.back();
      free_codes.pop_back();
    }
    *stored[code - BlockCodes::kMixed] = block;
  }

  /// Stores a block, and marks the blocks that share a changed sample.
  void replace(const VoxelIndex& origin, const StoredBlock& block) {
    const StoredBlock before = as_stored(codes.at(origin));
    std::array<int, 3> low = {kBlockEdge, kBlockEdge, kBlockEdge}, high = {-1, -1, -1};
    for (int n = 0; n < kBlockVoxels; ++n) {
      const auto place = std::size_t(n);
      if (before.fill[place] == block.fill[place] && before.material[place] == block.material[place]) continue;
      const VoxelIndex at = place_in_block(n);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
    if (high[0] < 0) return;
    store(origin, block);
    const auto first = [&](std::size_t axis) { return low[axis] < BlockSamples::kMargin ? -1 : 0; };
    const auto last = [&](std::size_t axis) { return high[axis] >= kBlockEdge - BlockSamples::kMargin ? 1 : 0; };
    for_each_voxel({{first(0), first(1), first(2)}, {last(0), last(1), last(2)}}, [&](const VoxelIndex& step) {
      mark({origin[0] + kBlockEdge * step[0], origin[1] + kBlockEdge * step[1], origin[2] + kBlockEdge * step[2]});
    });
  }

  void read(const CodesAround& around) {
    surface::read_samples(
        samples, [&](const std::array<int, 3>& neighbour, int first, int count, float* fill, MaterialId* material) {
          const std::uint32_t code = around.at(neighbour);
          if (code < BlockCodes::kMixed) {
            std::fill_n(fill, count, code == kEmpty ? 0.0F : 1.0F);
            std::fill_n(material, count, MaterialId(code));
            return;
          }
          const StoredBlock& block = *stored[code - BlockCodes::kMixed];
          for (int n = 0; n < count; ++n)
            fill[n] = float(block.fill[std::size_t(first) + std::size_t(n)]) * (1 / kFull);
          std::copy_n(&block.material[std::size_t(first)], count, material);
        });
  }

  void mesh(const VoxelIndex& page, const VoxelIndex& origin, BlockMesh& mesh) {
    mesh.vertices.clear();
    mesh.indices.clear();
    const CodesAround around(codes, origin);
    if (around.are_plain()) return;
    read(around);
    surface::mesh_block(samples, net);
    ++meshed;
    for (const NetVertex& vertex : net.vertices) {
      SurfaceVertex& packed = mesh.vertices.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        packed.position[axis] = rounded_position(origin[axis] - page[axis] + vertex.cell[axis], vertex.in_cell[axis]);
        packed.normal[axis] = rounded_normal(vertex.normal[axis]);
      }
      packed.material = vertex.material;
    }
    for (const auto& triangle : net.triangles)
      mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
  }

  /// Meshes the dirty blocks of a page.  @return whether the page has changed
  bool refresh(std::uint32_t number) {
    Page& page = pages[number];
    const VoxelIndex first = origin_of_page(number);
    bool changed = false;
    for (std::uint64_t bits = std::exchange(page.dirty, 0); bits != 0; bits &= bits - 1) {
      const int block = std::countr_zero(bits);
      mesh(first,
           {first[0] + kBlockEdge * (block >> 4), first[1] + kBlockEdge * (block >> 2 & 3),
            first[2] + kBlockEdge * (block & 3)},
           fresh);
      const auto place = std::lower_bound(page.meshes.begin(), page.meshes.end(), block,
                                          [](const BlockMesh& one, int other) { return one.block < other; });
      const bool was = place != page.meshes.end() && place->block == block;
      if (fresh.vertices.empty()) {
        if (was) page.meshes.erase(place), changed = true;
        continue;
      }
      if (was && place->vertices == fresh.vertices && place->indices == fresh.indices) continue;
      changed = true;
      fresh.block = block;
      if (was)
        *place = fresh;
      else
        page.meshes.insert(place, fresh);
    }
    return changed;
  }

  void hand_out(std::uint32_t number, SurfacePage& to) {
    to.origin = origin_of_page(number);
    to.version = ++version;
    to.vertices.clear();
    to.indices.clear();
    for (const BlockMesh& one : pages[number].meshes) {
      const auto before = std::uint16_t(to.vertices.size());
      to.vertices.insert(to.vertices.end(), one.vertices.begin(), one.vertices.end());
      for (const std::uint16_t index : one.indices) to.indices.push_back(std::uint16_t(before + index));
    }
  }

  GridFrame frame;
  BlockCodes codes;
  std::array<int, 3> page_dims;
  std::vector<Page> pages;
  std::vector<std::unique_ptr<StoredBlock>> stored;  // by code - kMixed
  std::vector<std::uint32_t> free_codes;             // codes that no block uses
  std::vector<WaitingPage> waiting;                  // heap
  Vec3 focus;                                        // [voxels]
  std::uint64_t version = 0, meshed = 0;
  BlockSamples samples;
  BlockNet net;
  BlockMesh fresh;
};

SurfaceStream::SurfaceStream(const Workpiece& workpiece) : state_(std::make_unique<State>(workpiece)) {
  State& s = *state_;
  StoredBlock block;
  workpiece.for_each_block([&](const BlockView& view) {
    if (view.material == nullptr && view.fill == nullptr) {
      s.codes[view.origin] = view.uniform_material;
      return;
    }
    copy_view(view, block);
    s.store(view.origin, block);
  });
  // A surface crosses edges of blocks that are not empty, or of the blocks before their lower faces.
  workpiece.for_each_block([&](const BlockView& view) {
    s.mark(view.origin);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      VoxelIndex before = view.origin;
      before[axis] -= kBlockEdge;
      s.mark(before);
    }
  });
}

SurfaceStream::~SurfaceStream() = default;
SurfaceStream::SurfaceStream(SurfaceStream&&) noexcept = default;
SurfaceStream& SurfaceStream::operator=(SurfaceStream&&) noexcept = default;

bool SurfaceStream::update(const VoxelIndex& origin, const MaterialId* material, const float* fill) {
  if (!state_->codes.contains(origin)) return false;
  StoredBlock block;
  for (std::size_t n = 0; n < kBlockVoxels; ++n) block.set(n, material[n], fill[n]);
  state_->replace(origin, block);
  return true;
}

bool SurfaceStream::update(const Workpiece& workpiece, std::span<const VoxelIndex> origins) {
  bool inside = true;
  StoredBlock block;
  for (const VoxelIndex& origin : origins) {
    if (!state_->codes.contains(origin)) {
      inside = false;
      continue;
    }
    copy_view(workpiece.block(origin), block);
    state_->replace(origin, block);
  }
  return inside;
}

bool SurfaceStream::next_page(SurfacePage& page) {
  State& s = *state_;
  while (!s.waiting.empty()) {
    std::pop_heap(s.waiting.begin(), s.waiting.end());
    const std::uint32_t number = s.waiting.back().page;
    s.waiting.pop_back();
    s.pages[number].waits = false;
    const bool asked = std::exchange(s.pages[number].resend, false), changed = s.refresh(number);
    if (!asked && !changed) continue;
    s.hand_out(number, page);
    return true;
  }
  return false;
}

void SurfaceStream::look_at(const Vec3& p_WQ) {
  if (!p_WQ.allFinite()) throw Error("the point to look at is not finite; give the position of the tool in W.");
  State& s = *state_;
  s.focus = (s.frame.X_WV.inverse() * p_WQ) / s.frame.voxel_size;
  for (WaitingPage& one : s.waiting) one.distance = s.distance_of(one.page);
  std::make_heap(s.waiting.begin(), s.waiting.end());
}

void SurfaceStream::resend() {
  for (std::size_t n = 0; n < state_->pages.size(); ++n) {
    if (state_->pages[n].meshes.empty()) continue;
    state_->pages[n].resend = true;
    state_->enqueue(std::uint32_t(n));
  }
}

const GridFrame& SurfaceStream::frame() const { return state_->frame; }
std::size_t SurfaceStream::waiting() const { return state_->waiting.size(); }
std::uint64_t SurfaceStream::blocks_meshed() const { return state_->meshed; }

std::size_t SurfaceStream::memory_bytes() const {
  const State& s = *state_;
  std::size_t bytes = s.codes.count() * sizeof(std::uint32_t) + s.pages.capacity() * sizeof(Page) +
                      s.stored.size() * (sizeof(StoredBlock) + sizeof(void*)) +
                      s.waiting.capacity() * sizeof(WaitingPage);
  for (const Page& page : s.pages) {
    bytes += page.meshes.capacity() * sizeof(BlockMesh);
    for (const BlockMesh& one : page.meshes)
      bytes += one.vertices.capacity() * sizeof(SurfaceVertex) + one.indices.capacity() * sizeof(std::uint16_t);
  }
  return bytes;
}

}  // namespace hapticut
