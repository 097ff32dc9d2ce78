// SPDX-License-Identifier: Apache-2.0
// Marks of a workpiece, and undo and redo block by block, without an allocation.
#include "workpiece/undo.hpp"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "workpiece/state.hpp"

namespace hapticut {
namespace {

constexpr double kMaxBlocks = 1 << 27;  // size of the table

void save_content(const BlockView& block, SavedBlock& entry) noexcept {
  entry.has_voxels = block.material != nullptr;
  entry.has_fill = block.fill != nullptr;
  entry.uniform_material = block.uniform_material;
  if (entry.has_voxels) {
    entry.solid = block.solid_voxels();
    std::copy_n(block.material, kBlockVoxels, entry.material.begin());
  }
  if (entry.has_fill) std::copy_n(block.fill, kBlockVoxels, entry.fill.begin());
}

}  // namespace

UndoJournal::UndoJournal(const IndexBox& bounds, std::size_t capacity) : blocks_(bounds) {
  if (blocks_.count() > kMaxBlocks)
    throw Error("the workpiece spans " + format_number(blocks_.count()) + " blocks; at most " +
                format_number(kMaxBlocks) + " are allowed with undo. Crop it.");
  const auto refuse = [&](const char* why) {
    throw Error("undo needs memory for " + std::to_string(capacity) + " blocks, " +
                format_number(double(capacity) * sizeof(SavedBlock) * 1e-9) + " GB; " + why +
                ". Reserve as many blocks as are cut between marks, typically some thousands.");
  };
  if (capacity > kMaxCapacity) refuse(("at most " + std::to_string(kMaxCapacity) + " blocks are allowed").c_str());
  try {
    saved_.assign(std::size_t(blocks_.count()), 0);
    ring_.resize(capacity);
    marks_.reserve(kMarks);
    undone_.reserve(kMarks);
  } catch (const std::bad_alloc&) {
    refuse("the system does not have that much");
  }
}

void UndoJournal::drop_oldest_mark() noexcept {
  oldest_ = (oldest_ + marks_.front().blocks) % ring_.size();
  count_ -= marks_.front().blocks;
  marks_.erase(marks_.begin());
}

void UndoJournal::forget_redo() noexcept {
  redoing_ = false;
  undone_.clear();
  if (!marks_.empty()) marks_.back().undone = 0;
}

void UndoJournal::set_mark() noexcept {
  // A mark that is partly undone cannot be redone across another mark.
  if (half_way()) forget_redo();
  if (marks_.size() + undone_.size() == kMarks) {
    if (marks_.empty())
      undone_.erase(undone_.begin());  // the last one to redo
    else
      drop_oldest_mark();
  }
  marks_.push_back({++last_number_, 0});
}

void UndoJournal::save(const BlockView& block) noexcept {
  if (marks_.empty()) return;
  std::uint32_t& saved = saved_[*blocks_.number_of(block.origin)];
  if (saved == marks_.back().number) return;
  forget_redo();  // this block overwrites the undone ones
  while (count_ == ring_.size() && !marks_.empty()) drop_oldest_mark();
  if (marks_.empty()) return;
  SavedBlock& entry = ring_[(oldest_ + count_++) % ring_.size()];
  ++marks_.back().blocks;
  entry.origin = block.origin;
  entry.saved_before = std::exchange(saved, marks_.back().number);
  save_content(block, entry);
}

SavedBlock* UndoJournal::undo_into() noexcept {
  redoing_ = false;
  if (marks_.empty()) return nullptr;
  Mark& mark = marks_.back();
  if (mark.blocks == 0) {
    undone_.push_back(mark);
    marks_.pop_back();
    return nullptr;
  }
  --mark.blocks;
  ++mark.undone;
  SavedBlock& entry = ring_[(oldest_ + --count_) % ring_.size()];
  saved_[*blocks_.number_of(entry.origin)] = entry.saved_before;
  return &entry;
}

SavedBlock* UndoJournal::redo_into() noexcept {
  if (!redoing_ && !half_way()) {
    if (undone_.empty()) return nullptr;
    marks_.push_back(undone_.back());
    undone_.pop_back();
  }
  redoing_ = half_way();
  if (!redoing_) return nullptr;
  Mark& mark = marks_.back();
  SavedBlock& entry = ring_[(oldest_ + count_++) % ring_.size()];
  ++mark.blocks;
  --mark.undone;
  entry.saved_before = std::exchange(saved_[*blocks_.number_of(entry.origin)], mark.number);
  return &entry;
}

// --- Workpiece -------------------------------------------------------------------------------------------------------

void Workpiece::reserve_undo(std::size_t blocks) {
  state_->journal = blocks == 0 || empty() ? nullptr : std::make_unique<UndoJournal>(bounds(), blocks);
}

std::size_t Workpiece::undo_blocks() const noexcept { return state_->journal ? state_->journal->capacity() : 0; }

bool Workpiece::set_mark() noexcept {
  if (state_->journal) state_->journal->set_mark();
  return state_->journal != nullptr;
}

std::size_t Workpiece::marks() const noexcept { return state_->journal ? state_->journal->marks() : 0; }

std::size_t Workpiece::redo_marks() const noexcept { return state_->journal ? state_->journal->redo_marks() : 0; }

void Workpiece::forget_redo() noexcept {
  if (state_->journal) state_->journal->forget_redo();
}

void Workpiece::remember(const BlockView& block) noexcept {
  if (state_->journal) state_->journal->save(block);
}

std::optional<VoxelIndex> Workpiece::undo_block() noexcept {
  SavedBlock* saved = state_->journal ? state_->journal->undo_into() : nullptr;
  if (saved == nullptr) return std::nullopt;
  exchange_block(*saved);
  return saved->origin;
}

std::optional<VoxelIndex> Workpiece::redo_block() noexcept {
  SavedBlock* saved = state_->journal ? state_->journal->redo_into() : nullptr;
  if (saved == nullptr) return std::nullopt;
  exchange_block(*saved);
  return saved->origin;
}

void Workpiece::exchange_block(SavedBlock& other) noexcept {
  SavedBlock wanted = other;  // 2.7 kB of the stack
  save_content(block(other.origin), other);
  restore_content(wanted);
}

/// Sets a block to its saved content.
void Workpiece::restore_content(const SavedBlock& content) noexcept {
  State& state = *state_;
  state.change_layout();
  BlockPool& pool = state.pool;
  const openvdb::Coord at = to_coord(content.origin);
  const State::BranchCache& branches = state.branches_at(at);
  auto* materials = branches.material;
  auto* fills = branches.fill;
  HAPTICUT_ASSERT(materials != nullptr && fills != nullptr);  // the block has been cut
  const openvdb::Index n = Branch<MaterialTree>::coordToOffset(at);

  // Nodes return to the pool before others are acquired. Undo runs in the reverse order of the cuts, so that the pool
  // has at least as many nodes as at the time of the cut. Redo runs in the order of the cuts: a block needs no more
  // nodes than at its first cut, and emptied blocks return theirs at once.
  if (!content.has_fill && fills->isChildMaskOn(n))
    pool.fill_leaves.emplace_back(fills->stealNode<Leaf<FillTree>>(at, 1.0F, false));
  if (!content.has_voxels) {
    if (materials->isChildMaskOn(n))
      pool.material_leaves.emplace_back(
          materials->stealNode<Leaf<MaterialTree>>(at, content.uniform_material, content.uniform_material != kEmpty));
    else
      materials->addTile(Branch<MaterialTree>::LEVEL, at, content.uniform_material, content.uniform_material != kEmpty);
    return;
  }
  if (!materials->isChildMaskOn(n)) materials->addLeaf(acquire_node(pool.material_leaves, at));
  auto* leaf = materials->probeLeaf(at);
  std::copy(content.material.begin(), content.material.end(), leaf->buffer().data());
  auto mask = leaf->getValueMask();
  for (std::size_t word = 0; word < content.solid.words.size(); ++word)
    mask.getWord<openvdb::Index64>(openvdb::Index(word)) = content.solid.words[word];
  leaf->setValueMask(mask);
  if (!content.has_fill) return;
  if (!fills->isChildMaskOn(n)) fills->addLeaf(acquire_node(pool.fill_leaves, at));
  std::copy(content.fill.begin(), content.fill.end(), fills->probeLeaf(at)->buffer().data());
}

}  // namespace hapticut
