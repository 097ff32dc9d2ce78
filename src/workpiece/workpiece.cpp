// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/workpiece.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/interruption.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

constexpr double kMaxReservedBlocks = 1e8;  // as the limit of SimulationConfig::reserved_blocks

using openvdb::Coord;

/// [voxel edges] Centroid of the filled part of a voxel, from the voxel's centre.
Vec3 centroid_in(const BlockView& block, int voxel) {
  if (block.centroid == nullptr) return Vec3::Zero();
  const CentroidOffset offset = CentroidOffset::unpacked(std::uint32_t(block.centroid[voxel]));
  return Vec3(offset.steps[0], offset.steps[1], offset.steps[2]) / CentroidOffset::kSteps;
}

/// The child of a branch node at the place of a block; null if the branch has a tile there.
template <class BranchNode>
const typename BranchNode::ChildNodeType* child_at(const BranchNode* branch, const Coord& block_origin) noexcept {
  if (branch == nullptr) return nullptr;
  const openvdb::Index n = BranchNode::coordToOffset(block_origin);
  return branch->getChildMask().isOn(n) ? branch->getTable()[n].getChild() : nullptr;
}

/// The child of a branch node at the place of a block, for writing; null if the branch has a tile there.
template <class BranchNode>
typename BranchNode::ChildNodeType* writable_child_at(BranchNode* branch, const Coord& block_origin) noexcept {
  return branch == nullptr ? nullptr : branch->probeLeaf(block_origin);
}

template <class LeafNode>
const typename LeafNode::ValueType* values_of(const LeafNode* leaf) noexcept {
  return leaf == nullptr ? nullptr : leaf->buffer().data();
}

/// The 512 active bits of a leaf as 8 words, word x, bit 8 y + z.
template <class LeafNode>
const std::uint64_t* mask_words(const LeafNode& leaf) noexcept {
  static_assert(LeafNode::NodeMaskType::WORD_COUNT == 8);
  using Mask = typename LeafNode::NodeMaskType;  // only the non-const overload gives the address of the words
  return &const_cast<Mask&>(leaf.getValueMask()).template getWord<openvdb::Index64>(0);
}

}  // namespace

Workpiece::Workpiece(std::unique_ptr<State> state) : state_(std::move(state)) {}
Workpiece::Workpiece(Workpiece&&) noexcept = default;
Workpiece& Workpiece::operator=(Workpiece&&) noexcept = default;
Workpiece::~Workpiece() = default;

Workpiece WorkpieceAccess::make(const GridFrame& frame, MaterialTable materials, std::unique_ptr<VoxelTrees> trees) {
  auto state = std::make_unique<Workpiece::State>();
  state->frame = frame;
  state->materials = std::move(materials);
  state->trees = std::move(trees);
  return Workpiece(std::move(state));
}

Workpiece Workpiece::clone() const {
  return WorkpieceAccess::make(state_->frame, state_->materials, copy_of(*state_->trees));
}

const GridFrame& Workpiece::frame() const { return state_->frame; }
const MaterialTable& Workpiece::materials() const { return state_->materials; }

void Workpiece::set_materials(MaterialTable materials) {
  if (materials.size() != state_->materials.size())
    throw Error("a table of " + std::to_string(materials.size()) + " materials was given for a workpiece with " +
                std::to_string(state_->materials.size()) + "; change the constants, not the number of materials.");
  state_->materials = std::move(materials);
}

bool Workpiece::exchange_materials(MaterialTable& materials) noexcept {
  if (materials.size() != state_->materials.size()) return false;
  std::swap(materials, state_->materials);
  return true;
}

bool Workpiece::empty() const { return state_->trees->material.activeVoxelCount() == 0; }
std::int64_t Workpiece::solid_voxels() const { return std::int64_t(state_->trees->material.activeVoxelCount()); }

IndexBox Workpiece::bounds() const {
  openvdb::CoordBBox box;
  if (!state_->trees->material.evalActiveVoxelBoundingBox(box)) return {};
  return {to_index(box.min()), to_index(box.max())};
}

std::size_t Workpiece::memory_bytes() const {
  const VoxelTrees& trees = *state_->trees;
  return std::size_t(trees.material.memUsage() + trees.fill.memUsage() + trees.centroid.memUsage());
}

std::size_t Workpiece::pool_bytes() const {
  const BlockPool& pool = state_->pool;
  std::size_t bytes = 0;
  for (const auto& leaf : pool.material_leaves) bytes += leaf->memUsage();
  for (const auto& leaf : pool.fill_leaves) bytes += leaf->memUsage();
  for (const auto& branch : pool.fill_branches) bytes += branch->memUsage();
  return bytes;
}

std::vector<MaterialAmount> Workpiece::amounts() const {
  const double voxel_volume = std::pow(voxel_size(), 3);
  std::vector<MaterialAmount> amounts;
  ByMaterial<double> filled = {};  // [voxels]
  ByMaterial<Vec3> moments;        // [voxels^2] moments about the centre of voxel (0, 0, 0), along the grid's axes
  moments.fill(Vec3::Zero());
  const auto add = [&](const MaterialId material, const VoxelIndex& first, const Vec3& offset, double fill) {
    filled[material] += fill;
    moments[material] += fill * (Vec3(first[0], first[1], first[2]) + offset);
  };
  for (int id = 1; id <= materials().size(); ++id)
    amounts.push_back({MaterialId(id), 0, 0, 0, Vec3::Constant(std::numeric_limits<double>::quiet_NaN())});
  for_each_block([&](const BlockView& block) {
    if (block.material == nullptr) {
      amounts[block.uniform_material - 1U].voxels += kBlockVoxels;
      add(block.uniform_material, block.origin, Vec3::Constant((kBlockEdge - 1) / 2.0), kBlockVoxels);
      return;
    }
    for (int n = 0; n < kBlockVoxels; ++n) {
      if (!block.is_solid(n)) continue;
      amounts[block.material[n] - 1U].voxels += 1;
      add(block.material[n], voxel_at(block.origin, n), centroid_in(block, n), double(block.fill_of(n)));
    }
  });
  for (MaterialAmount& amount : amounts) {
    amount.volume = filled[amount.material] * voxel_volume;
    amount.mass = amount.volume * materials()[amount.material].density;
    if (filled[amount.material] > 0)
      amount.center = frame().X_WV * (voxel_size() / filled[amount.material] * moments[amount.material]);
  }
  return amounts;
}

MaterialId Workpiece::material_at(const VoxelIndex& index) const {
  std::uint8_t id = kEmpty;
  return state_->trees->material.probeValue(to_coord(index), id) ? id : kEmpty;
}

double Workpiece::fill_at(const VoxelIndex& index) const {
  return material_at(index) == kEmpty ? 0.0 : double(state_->trees->fill.getValue(to_coord(index)));
}

CentroidOffset Workpiece::centroid_at(const VoxelIndex& index) const {
  return CentroidOffset::unpacked(std::uint32_t(state_->trees->centroid.getValue(to_coord(index))));
}

void Workpiece::for_each_block(const std::function<void(const BlockView&)>& function) const {
  const auto visit = [&](const VoxelIndex& block_origin) {
    look_for_interruption();
    const BlockView view = block(block_origin);
    if (!view.empty()) function(view);
  };
  const auto& root = state_->trees->material.root();
  for (auto trunk = root.cbeginChildOn(); trunk; ++trunk) {
    // Branch by branch in the order of the trunk's table; inactive tiles are empty.
    for (openvdb::Index n = 0; n < Trunk<MaterialTree>::NUM_VALUES; ++n) {
      if (!trunk->isChildMaskOn(n) && !trunk->isValueMaskOn(n)) continue;
      const Coord first = trunk->offsetToGlobalCoord(n);
      for_each_block_origin({to_index(first), to_index(first.offsetBy(kBranchEdge - 1))}, visit);
    }
  }
}

std::uint64_t Workpiece::hash() const {
  // FNV-1a over whole words. A uniform block has the same hash as its content voxel by voxel.
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  const auto mix = [](std::uint64_t hash, std::uint64_t word) {
    hash ^= word;
    hash *= kPrime;
    return hash ^ (hash >> 29);
  };
  const auto voxel_word = [](MaterialId material, float fill) {
    return std::uint64_t(material) << 32 | std::bit_cast<std::uint32_t>(fill);
  };
  ByMaterial<std::uint64_t> uniform = {};
  std::uint64_t total = 0xcbf29ce484222325ULL;
  for_each_block([&](const BlockView& block) {
    std::uint64_t content = 0xcbf29ce484222325ULL;
    if (block.material == nullptr && block.fill == nullptr) {
      std::uint64_t& known = uniform[block.uniform_material];
      if (known == 0) {
        known = content;
        for (int n = 0; n < kBlockVoxels; ++n) known = mix(known, voxel_word(block.uniform_material, 1.0F));
      }
      content = known;
    } else {
      for (int n = 0; n < kBlockVoxels; ++n) {
        const MaterialId material = block.material_of(n);
        content = mix(content, material != kEmpty ? voxel_word(material, block.fill_of(n)) : 0);
      }
    }
    for (const int i : block.origin) total = mix(total, std::uint64_t(std::uint32_t(i)));
    total = mix(total, content);
  });
  return total;
}

void Workpiece::reserve_blocks(std::size_t count) {
  require_between(double(count), 0, kMaxReservedBlocks, "Workpiece::reserve_blocks: count");
  State& state = *state_;
  BlockPool& pool = state.pool;
  pool.target = count;
  state.cache = {};
  state.change_layout();

  // Tiles larger than a block become branch nodes of block-sized tiles, and the fill tree gets the trunk nodes above
  // them. Cutting then inserts only one leaf (and at most one branch of the fill tree) at a time, always from the pool.
  std::size_t branches = 0;
  for (auto trunk = state.trees->material.root().beginChildOn(); trunk; ++trunk) {
    for (openvdb::Index n = 0; n < Trunk<MaterialTree>::NUM_VALUES; ++n) {
      if (trunk->isValueMaskOn(n)) {
        const std::uint8_t id = trunk->getTable()[n].getValue();
        trunk->addChild(new Branch<MaterialTree>(trunk->offsetToGlobalCoord(n), id, true));
      }
    }
    branches += trunk->getChildMask().countOn();
    if (state.trees->fill.probeConstNode<Trunk<FillTree>>(trunk->origin()) == nullptr)
      state.trees->fill.root().addChild(new Trunk<FillTree>(trunk->origin(), 1.0F, false));
  }

  const std::size_t branch_count = std::min(branches, std::max<std::size_t>(8, count / 32));
  while (pool.fill_branches.size() < branch_count)
    pool.fill_branches.push_back(std::make_unique<Branch<FillTree>>(Coord(0), 1.0F, false));
  while (pool.fill_leaves.size() < count) {
    pool.fill_leaves.push_back(std::make_unique<Leaf<FillTree>>(Coord(0), 1.0F, true));
    pool.fill_leaves.back()->buffer().data();
  }
  while (pool.material_leaves.size() < count)
    pool.material_leaves.push_back(std::make_unique<Leaf<MaterialTree>>(Coord(0), kEmpty, true));
  // Blocks that cutting empties return to the pool, including blocks that did not come from it.
  const std::size_t material_leaves = state.trees->material.leafCount();
  const std::size_t fill_leaves = state.trees->fill.leafCount();
  pool.material_leaves.reserve(pool.material_leaves.size() + material_leaves);
  pool.fill_leaves.reserve(pool.fill_leaves.size() + fill_leaves);
}

std::size_t Workpiece::reserved_blocks() const {
  return std::min(state_->pool.fill_leaves.size(), state_->pool.material_leaves.size());
}

const Workpiece::State::BranchCache& Workpiece::State::branches_at(const Coord& block_origin) const noexcept {
  const Coord origin(branch_start(block_origin.x()), branch_start(block_origin.y()), branch_start(block_origin.z()));
  if (cache.valid && cache.origin == origin) return cache;
  cache.valid = true;
  cache.origin = origin;
  cache.material = trees->material.probeNode<Branch<MaterialTree>>(origin);
  cache.fill = trees->fill.probeNode<Branch<FillTree>>(origin);
  cache.centroid = trees->centroid.probeConstNode<Branch<CentroidTree>>(origin);
  cache.tile = kEmpty;
  if (cache.material == nullptr) {
    std::uint8_t id = kEmpty;
    if (trees->material.probeValue(origin, id)) cache.tile = id;
  }
  return cache;
}

BlockView Workpiece::block(const VoxelIndex& origin) const noexcept {
  const Coord at = to_coord(origin);
  const State::BranchCache& branches = state_->branches_at(at);
  BlockView view;
  view.origin = origin;
  if (branches.material == nullptr) {
    view.uniform_material = branches.tile;
  } else if (const auto* leaf = child_at(branches.material, at)) {
    view.material = values_of(leaf);
    view.solid = mask_words(*leaf);
  } else {
    const openvdb::Index n = Branch<MaterialTree>::coordToOffset(at);
    view.uniform_material = branches.material->isValueMaskOn(n) ? branches.material->getTable()[n].getValue() : kEmpty;
  }
  view.fill = values_of(child_at(branches.fill, at));
  view.centroid = values_of(child_at(branches.centroid, at));
  return view;
}

std::uint64_t Workpiece::layout() const noexcept { return state_->layout; }

CuttableBlock Workpiece::cuttable_block(const VoxelIndex& origin) noexcept {
  const BlockView view = block(origin);
  if (view.fill == nullptr) return {view, nullptr};
  const Coord at = to_coord(origin);
  return {view, writable_child_at(state_->branches_at(at).fill, at)->buffer().data()};
}

bool Workpiece::has_reserve_for(const VoxelIndex& origin) const noexcept {
  const BlockPool& pool = state_->pool;
  const Coord at = to_coord(origin);
  const State::BranchCache& branches = state_->branches_at(at);
  const auto enough = [](bool there, const auto& reserve) { return there || !reserve.empty(); };
  return enough(branches.fill != nullptr, pool.fill_branches) &&
         enough(child_at(branches.fill, at) != nullptr, pool.fill_leaves) &&
         enough(child_at(branches.material, at) != nullptr, pool.material_leaves);
}

float* Workpiece::writable_fill(const VoxelIndex& origin) noexcept {
  if (!has_reserve_for(origin)) return nullptr;
  State& state = *state_;
  if (state.journal) state.journal->save(block(origin));
  BlockPool& pool = state.pool;
  const Coord at = to_coord(origin);
  const State::BranchCache& branches = state.branches_at(at);
  HAPTICUT_ASSERT(branches.material != nullptr);  // reserve_blocks left no larger tile

  auto* fill_leaf = writable_child_at(branches.fill, at);
  const auto* material_leaf = child_at(branches.material, at);
  if (fill_leaf == nullptr || material_leaf == nullptr) state.change_layout();
  if (branches.fill == nullptr) {
    auto* trunk = state.trees->fill.probeNode<Trunk<FillTree>>(at);
    HAPTICUT_ASSERT(trunk != nullptr);
    trunk->addChild(acquire_node(pool.fill_branches, branches.origin));
    state.cache.valid = false;
  }
  auto* fill_branch = state.branches_at(at).fill;
  auto* material_branch = state.cache.material;

  if (material_leaf == nullptr) {
    const openvdb::Index n = Branch<MaterialTree>::coordToOffset(at);
    const std::uint8_t id = material_branch->getTable()[n].getValue();
    auto* leaf = acquire_node(pool.material_leaves, at);
    leaf->setValuesOn();
    std::fill_n(leaf->buffer().data(), kBlockVoxels, id);
    material_branch->addLeaf(leaf);
  }
  if (fill_leaf == nullptr) {
    auto* leaf = acquire_node(pool.fill_leaves, at);
    float* fill = leaf->buffer().data();
    const auto* solid = child_at(material_branch, at);
    for (int n = 0; n < kBlockVoxels; ++n) fill[n] = solid->isValueOn(openvdb::Index(n)) ? 1.0F : 0.0F;
    fill_branch->addLeaf(leaf);
    return fill;
  }
  return fill_leaf->buffer().data();
}

void Workpiece::empty_voxels(const VoxelIndex& origin, const BlockMask& emptied) noexcept {
  State& state = *state_;
  const Coord at = to_coord(origin);
  const State::BranchCache& branches = state.branches_at(at);
  auto* material_leaf = writable_child_at(branches.material, at);
  auto* fill_leaf = writable_child_at(branches.fill, at);
  HAPTICUT_ASSERT(material_leaf != nullptr && fill_leaf != nullptr);

  float* fill = fill_leaf->buffer().data();
  auto mask = material_leaf->getValueMask();
  for (std::size_t word = 0; word < emptied.words.size(); ++word)
    mask.getWord<openvdb::Index64>(openvdb::Index(word)) &= ~emptied.words[word];
  emptied.for_each([&](int voxel) { fill[voxel] = 0.0F; });
  material_leaf->setValueMask(mask);
  if (!mask.isOff()) return;

  // Nothing is left: both leaves return to the pool. Its vectors have capacity for every leaf of the trees.
  state.change_layout();
  auto& pool = state.pool;
  HAPTICUT_ASSERT(pool.material_leaves.size() < pool.material_leaves.capacity());
  HAPTICUT_ASSERT(pool.fill_leaves.size() < pool.fill_leaves.capacity());
  pool.material_leaves.emplace_back(branches.material->stealNode<Leaf<MaterialTree>>(at, kEmpty, false));
  pool.fill_leaves.emplace_back(branches.fill->stealNode<Leaf<FillTree>>(at, 1.0F, false));
}

}  // namespace hapticut
