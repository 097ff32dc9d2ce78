// SPDX-License-Identifier: Apache-2.0
// Which materials the head touches for the first time.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "simulation/contact_stages.hpp"

namespace hapticut {
namespace {

/// The materials that are looked for: those of a table that are not known yet.
class Unknown {
 public:
  Unknown(int materials, const MaterialSet& known) noexcept : materials_(materials), known_(known) {
    known_.insert(kEmpty);
    list();
  }

  [[nodiscard]] bool none() const noexcept { return count_ == 0; }
  [[nodiscard]] bool has(MaterialId id) const noexcept { return !known_.has(id); }
  void remove(MaterialId id) noexcept {
    known_.insert(id);
    list();
  }

  /// False only if a block certainly contains none of them. Most blocks are left out here, so this must be fast.
  [[nodiscard]] bool may_be_in(const BlockView& block) const noexcept {
    if (block.material == nullptr) return has(block.uniform_material);
    if (count_ <= few_.size())
      return std::any_of(few_.begin(), few_.begin() + std::ptrdiff_t(count_),
                         [&](MaterialId id) { return std::memchr(block.material, id, kBlockVoxels) != nullptr; });
    return std::any_of(block.material, block.material + kBlockVoxels, [&](MaterialId id) { return has(id); });
  }

  /// Their voxels in a block that is not uniform.
  [[nodiscard]] BlockMask voxels_in(const BlockView& block) const noexcept {
    BlockMask voxels;
    for (int n = 0; n < kBlockVoxels; ++n)
      voxels.words[std::size_t(n) / 64] |= std::uint64_t(has(block.material[n])) << (unsigned(n) % 64);
    return voxels & block.solid_voxels();
  }

 private:
  void list() noexcept {
    count_ = 0;
    for (int id = 1; id <= materials_; ++id) {
      if (!has(MaterialId(id))) continue;
      if (count_ < few_.size()) few_[count_] = MaterialId(id);
      ++count_;
    }
  }

  const int materials_;
  MaterialSet known_;
  std::array<MaterialId, 8> few_ = {};  // the first of them
  std::size_t count_ = 0;
};

}  // namespace

MaterialSet ContactStages::find_touched(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                        const MaterialSet& known) noexcept {
  MaterialSet found;
  const int materials = workpiece_.materials().size();
  if (known.size() >= materials || blocks.empty()) return found;
  Unknown unknown(materials, known);
  const kernels::ContactJob job = job_at(at);
  for (const FoundBlock& block : blocks) {
    if (!unknown.may_be_in(block.view)) continue;
    BlockView view = block.view;
    BlockMask voxels;
    if (view.material != nullptr) {
      voxels = unknown.voxels_in(view);
      view.solid = voxels.words.data();
    }
    sample_reached(job, view);
    for (int row = 0; row < contact_.rows; ++row) {
      for (unsigned lanes = contact_.inside[std::size_t(row)]; lanes != 0; lanes &= lanes - 1) {
        const MaterialId id = contact_.material_of(row * kLanes + std::countr_zero(lanes));
        if (!unknown.has(id)) continue;
        found.insert(id);
        unknown.remove(id);
      }
    }
    if (unknown.none()) break;
  }
  return found;
}

/// Samples the voxels of a block that are in contact, as the law sees them. With parts of voxels this is the scalar
/// reference, so blocks out of reach are left out first.
void ContactStages::sample_reached(const kernels::ContactJob& job, const BlockView& block) noexcept {
  contact_.rows = contact_.samples = 0;
  contact_.min_width = job.motion.min_width;
  std::array<std::uint16_t, kernels::ReachedVoxels::kCapacity> listed;
  if (quadrature_ != Quadrature::sub_voxel)
    kernels::sample_contact(head_, block, job.grid, quadrature_, contact_);
  else if (kernels::find_voxels(job, block, 0, listed.data()).count > 0)
    head_.visit_springs<float>(
        [&](const auto& springs) { hapticut::sample_contact(springs, block, job.grid, quadrature_, contact_); });
}

}  // namespace hapticut
