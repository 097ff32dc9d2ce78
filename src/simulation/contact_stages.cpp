// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact_stages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/laws/lumped.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "simulation/reach.hpp"
#include "workpiece/reserved_nodes.hpp"

namespace hapticut {
namespace {

constexpr double kCancelled = 1e-4;  // [1] resultant over the normal forces: rounding error of single precision

/// Number of blocks without fills that can get some, wherever they are.
std::size_t free_blocks(const Workpiece& workpiece) noexcept {
  const ReservedNodes nodes = reserved_nodes(workpiece);
  return std::min({nodes.material_leaves, nodes.fill_leaves, nodes.fill_branches});
}

}  // namespace

ContactStages::ContactStages(Workpiece& workpiece, const ToolHead& head, const SimulationConfig& config)
    : workpiece_(workpiece),
      head_(head),
      law_(config.law),
      quadrature_(config.quadrature),
      grain_seed_(config.grain ? std::optional(std::uint32_t(config.grain_seed)) : std::nullopt),
      voxel_volume_(std::pow(workpiece.voxel_size(), 3)),
      voxel_budget_(config.voxel_budget),
      bounds_(workpiece.bounds()) {
  require_contact_stiffness(workpiece.materials(), config.reference_stiffness);
  set_materials(
      contact_materials(workpiece.materials(), config.reference_stiffness, config.contact_damping.value_or(0)));
  if (quadrature_ != Quadrature::sub_voxel && law_->integrates_parts())
    throw Error("SimulationConfig::quadrature"_name + " = " + std::string(name_or_null(quadrature_)) +
                " was given with a law that integrates over parts of voxels, as FoundationLaw does; points are for "
                "other laws. Leave it automatic.");
  if (quadrature_ == Quadrature::sub_voxel && !law_->integrates_parts())
    throw Error("SimulationConfig::quadrature"_name +
                " = sub_voxel was given with a law that computes the force at points. Choose "
                "automatic or centroid, FoundationLaw, or a law that integrates_parts().");
  if (!law_->is_foundation() && voxel_budget_ != 0)
    throw Error(
        "SimulationConfig::voxel_budget"_name + " = " + std::to_string(voxel_budget_) +
        " was given with a law other than FoundationLaw, but only FoundationLaw has a level of detail. Leave it at 0.");
  if (!law_->is_foundation() && config.grain)
    throw Error("SimulationConfig::grain"_name +
                " = true was given with a law other than FoundationLaw, but only FoundationLaw has a grain. Leave it "
                "false.");
  Buffers buffers(head, workpiece.voxel_size(), config);
  exchange_buffers(buffers);
}

/// Number of subsets into which the voxels inside the head must be divided to stay within the budget. The voxels are
/// counted only when the blocks have more than the budget.
int ContactStages::level_of_detail(std::span<const FoundBlock> blocks, const kernels::ContactJob& job) const noexcept {
  if (voxel_budget_ == 0 || max_voxels_ <= voxel_budget_) return 1;
  std::size_t solid = 0, inside = 0;
  for (const FoundBlock& block : blocks) solid += std::size_t(block.view.solid_voxels().count());
  if (solid <= voxel_budget_) return 1;
  std::array<std::uint16_t, kernels::ReachedVoxels::kCapacity> listed;
  for (const FoundBlock& block : blocks)
    inside += std::size_t(kernels::find_voxels(job, block.view, 0, listed.data()).count);
  return std::max(1, int((inside + voxel_budget_ - 1) / voxel_budget_));
}

std::span<const FoundBlock> ContactStages::find_blocks(const HeadPlacement& at) noexcept {
  // The centroid of a surface voxel lies half a voxel off its centre, along an axis of the grid.
  const double beyond = quadrature_ == Quadrature::sub_voxel ? double(kVoxelReach) : 0.5;
  const kernels::ContactJob job = job_at(at);
  const bool stands_as_ball = at.motion.spin == 0 && head_.ball() != nullptr;
  return near_.find(workpiece_, job, at.X_VT, bounds_, beyond, law_->is_foundation() && !stands_as_ball);
}

Encounter ContactStages::press_and_cut(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                       RemovalRecord& removal) noexcept {
  std::fill_n(pressed_.begin(), workpiece_.materials().size() + 1, 0.0);
  return evaluate(blocks, at, &removal, Asked::force);
}

Encounter ContactStages::probe(std::span<const FoundBlock> blocks, const HeadPlacement& at, Asked asked) noexcept {
  return evaluate(blocks, at, nullptr, asked);
}

/// @param removal  null: no block is changed
Encounter ContactStages::evaluate(std::span<const FoundBlock> blocks, const HeadPlacement& at, RemovalRecord* removal,
                                  Asked asked) noexcept {
  Encounter encounter;
  if (!law_->is_foundation()) {
    encounter = ask_law(blocks, at, removal);
  } else if (at.motion.cuts() || !at.motion.crushes) {
    encounter = run_kernels(blocks, at, removal, asked);
  } else {  // a head that does not cut rarely crushes, so crushing is evaluated only when something is that deep
    HeadPlacement without_crushing = at;
    without_crushing.motion.crushes = false;
    encounter = run_kernels(blocks, without_crushing, nullptr, asked);
    if (crushes(encounter, at.motion)) encounter = run_kernels(blocks, at, removal, asked);
  }
  encounter.drop_if_not_finite();
  return encounter;
}

/// Whether some material may be deeper than its crushing depth, which is less below a smooth surface (a ball has none).
bool ContactStages::crushes(const Encounter& encounter, const HeadMotion& motion) const noexcept {
  const double scale = head_.ball() != nullptr ? 1 : kSmoothScale;
  return scale * encounter.resultant.depth > crushing_depth(motion, scale);
}

/// [m] Depth at which the first material may be crushed, for the largest closing speed of the head; a smooth surface
/// has a scale.
double ContactStages::crushing_depth(const HeadMotion& motion, double scale) const noexcept {
  const HeadBox box = head_.bounding_box();
  const double extent = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).norm();
  const double max_speed = double(motion.felt_velocity.norm()) + extent * double(motion.felt_angular_velocity.norm());
  const auto damping = FoundationLaw::Damping::of(materials_.max_damping() * float(scale * max_speed));
  return double(damping.crushing_depth(materials_.min_crushing_depth()));
}

double ContactStages::rim_crushing_depth(const Resultant& resultant, const HeadMotion& motion) const noexcept {
  const bool may_be_rim = head_.ball() == nullptr && !is_point_thin(resultant);
  if (!may_be_rim || motion.spin != 0 || !motion.crushes) return 0;
  const double depth = crushing_depth(motion);
  return resultant.depth > depth ? depth : 0.0;
}

Contact ContactStages::contact_of(const Encounter& encounter, const Pose& X_WT) const noexcept {
  const Resultant& resultant = encounter.resultant;
  Contact contact;
  contact.voxels = resultant.voxels;
  contact.volume = resultant.volume * voxel_volume_;
  contact.depth = resultant.depth;
  contact.level_of_detail = encounter.level_of_detail;
  if (!(resultant.normal_force > 0)) return contact;
  contact.point_W = X_WT * Vec3(resultant.moment_T / resultant.normal_force);
  if (const double push = resultant.push_T.norm(); push > kCancelled * resultant.normal_force)
    contact.normal_W = X_WT.rotation * resultant.push_T / push;
  contact.area = resultant.area * std::pow(workpiece_.voxel_size(), 2);
  if (contact.area > 0) contact.pressure = resultant.normal_force / contact.area;
  return contact;
}

/// FoundationLaw, a few blocks at once.
Encounter ContactStages::run_kernels(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                     RemovalRecord* removal, Asked asked) noexcept {
  const bool removes = at.motion.cuts() || at.motion.crushes, stands = at.motion.spin == 0;
  const bool rubs = stands && materials_.any_friction();
  const bool keeps = removes && removal != nullptr;
  kernels::ContactJob job = job_at(at);
  job.level_of_detail = unsigned(level_of_detail(blocks, job));
  job.motion.level_of_detail = float(job.level_of_detail);
  job.writes_fills = keeps;
  kernels::ContactSums sums;
  if (keeps) sums.pressed = &pressed_;
  kernels::StiffnessSums stiffness;
  kernels::FrictionSums friction;
  bool exhausted = false;
  for (std::size_t first = 0; first < blocks.size();) {
    std::size_t count = 0, fresh = 0;
    const std::size_t room = keeps ? free_blocks(workpiece_) : 0;
    while (first + count < blocks.size() && count < kBlocksAtOnce) {
      const FoundBlock& block = blocks[first + count];
      const bool writable = removes && can_cut(block);
      exhausted |= removes && !writable;
      float* after = !keeps ? nullptr : writable ? fill_target(block, count) : new_fills_[count].data();
      tasks_[count++] = {block.view, after, writable, {}, {}};
      if (job.level_of_detail == 1) tasks_[count - 1].reached = block.reached;
      if (keeps && block.fill == nullptr && ++fresh >= room) break;  // each may take a block of the reserve
    }
    kernels::evaluate_blocks(job, std::span(tasks_).first(count), sums,
                             asked == Asked::stiffness ? &stiffness : nullptr, rubs ? &friction : nullptr);
    if (keeps)
      for (std::size_t n = 0; n < count; ++n) keep_change(blocks[first + n], tasks_[n].change, tasks_[n].fill_after);
    first += count;
  }
  Encounter encounter = encounter_of(job, sums);
  if (asked == Asked::stiffness) encounter.stiffness_T = stiffness.total(voxel_volume_, double(job.level_of_detail));
  encounter.blocks_exhausted = exhausted;
  if (stands) encounter.friction_T = friction.total(voxel_volume_, double(job.level_of_detail));
  if (keeps) record(sums.removed, *removal);
  if (keeps)
    for (int id = 1; id <= workpiece_.materials().size(); ++id)
      pressed_[std::size_t(id)] *= double(job.level_of_detail) * voxel_volume_;
  return encounter;
}

/// @param removed  [voxels] by MaterialId
void ContactStages::record(const ByMaterial<double>& removed, RemovalRecord& removal) const noexcept {
  for (int id = 1; id <= workpiece_.materials().size(); ++id)
    if (removed[std::size_t(id)] != 0) removal.add_volume(MaterialId(id), removed[std::size_t(id)] * voxel_volume_);
}

kernels::ContactJob ContactStages::job_at(const HeadPlacement& at) noexcept {
  return {head_,
          GridInHead(at.X_VT.inverse(), workpiece_.voxel_size()),
          at.motion,
          materials_.with(at.cutting_share),
          materials_.max_damping() > 0,
          1,
          subset_};
}

Encounter ContactStages::encounter_of(const kernels::ContactJob& job, const kernels::ContactSums& sums) const noexcept {
  const kernels::ContactTotals totals = kernels::totals_of(job, sums, voxel_volume_);
  Encounter encounter;
  encounter.resultant = totals.resultant;
  encounter.energies = totals.energies;
  encounter.level_of_detail = int(job.level_of_detail);
  return encounter;
}

/// Any other law, stage by stage on the samples of one block.
/// @param removal  null: no block is changed
Encounter ContactStages::ask_law(std::span<const FoundBlock> blocks, const HeadPlacement& at,
                                 RemovalRecord* removal) noexcept {
  Encounter encounter;
  const GridInHead grid(at.X_VT.inverse(), workpiece_.voxel_size());
  const ContactMaterials& materials = materials_.with(at.cutting_share);
  HeadMotion motion = at.motion;
  contact_.min_width = motion.min_width;
  WholeContact whole;
  if (law_->needs_moments()) {
    for (const FoundBlock& block : blocks) {
      kernels::sample_contact(head_, block.view, grid, quadrature_, contact_);
      add_moments(contact_, motion, materials, whole.moments);
    }
    if (whole.moments.volume > 0) whole.lumped = law_->lump(head_, motion, whole.moments);
    encounter.add(whole.lumped);
    motion.whole = &whole;
  }
  HeadMotion without_removal = motion;
  without_removal.removal = RemovalLaw::none;
  ByMaterial<double> removed = {};  // [voxels]
  for (const FoundBlock& block : blocks) {
    kernels::sample_contact(head_, block.view, grid, quadrature_, contact_);
    if (contact_.samples == 0) continue;
    const bool removes = motion.removal != RemovalLaw::none, writable = removes && can_cut(block);
    encounter.blocks_exhausted |= removes && !writable;
    const LawTotals totals = law_->evaluate(writable ? motion : without_removal, materials, contact_);
    encounter.add(totals);
    kernels::sum_resultant(contact_, encounter.resultant);
    if (removal != nullptr && motion.cuts()) add_pressed(contact_, 1, pressed_);
    if (motion.spin == 0) encounter.friction_T.add(contact_, motion, materials);
    if (removal == nullptr || !totals.may_remove || !writable) continue;
    float* after = fill_target(block, 0);
    keep_change(block, find_changes(contact_, block.view, after, removed), after);
  }
  if (removal != nullptr) record(removed, *removal);
  return encounter;
}

/// Whether new fills of a block can be stored. When no reserved block is left, material is felt but not cut.
bool ContactStages::can_cut(const CuttableBlock& block) const noexcept {
  return block.fill != nullptr || workpiece_.has_reserve_for(block.view.origin);
}

/// Where the new fills of a block are written: into the block itself if it already has own fills. While there is
/// something to redo, they are written elsewhere, because only a change of the block may end the redo.
/// @param place  in the group of blocks that are evaluated together
float* ContactStages::fill_target(const CuttableBlock& block, std::size_t place) noexcept {
  if (block.fill == nullptr || workpiece_.redo_marks() > 0) return new_fills_[place].data();
  workpiece_.remember(block.view);
  return block.fill;
}

/// Stores the new fills of a block that were not written in place, and lists its emptied voxels.
void ContactStages::keep_change(const CuttableBlock& block, const BlockChange& change, const float* after) noexcept {
  if (!change.any_changed) return;
  if (after != block.fill) {
    if (block.fill != nullptr) workpiece_.remember(block.view);
    float* fill = block.fill != nullptr ? block.fill : workpiece_.writable_fill(block.view.origin);
    HAPTICUT_ASSERT(fill != nullptr);  // because can_cut
    for (std::uint32_t strips = change.strips; strips != 0; strips &= strips - 1) {
      const int first = BlockChange::kStrip * std::countr_zero(strips);
      std::copy_n(after + first, BlockChange::kStrip, fill + first);
    }
  }
  workpiece_.forget_redo();
  list_change(block.view.origin);
  if (change.any_emptied) emptied_.push_back({block.view, change.emptied});
}

void ContactStages::forget_changes() noexcept {
  changed_.clear();
  changed_blocks_ = {};
}

void ContactStages::change_all() noexcept {
  changed_.clear();
  changed_blocks_ = {{}, false};
}

void ContactStages::list_change(const VoxelIndex& origin) noexcept {
  if (!changed_blocks_.complete) return;
  if (changed_.size() == changed_.capacity()) {  // only in steps of very many sub-steps, and in large undos
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    // Sorting again for every few new entries would take too long.
    changed_blocks_.complete = 4 * changed_.size() <= 3 * changed_.capacity();
  }
  if (changed_blocks_.complete) changed_.push_back(origin);
  changed_blocks_.origins = changed_;
}

void ContactStages::remove_emptied(RemovalRecord& removal) noexcept {
  for (const EmptiedBlock& entry : emptied_) empty_voxels(entry.block, entry.emptied, workpiece_, removal);
  emptied_.clear();
  ++subset_;
}

std::size_t ContactStages::undo(std::size_t max_blocks) noexcept {
  std::size_t undone = 0;
  do {  // at least one, or a caller that passes 0 would never finish
    const auto origin = workpiece_.undo_block();
    if (!origin) break;
    list_change(*origin);
  } while (++undone < max_blocks);
  subset_ = 0;
  return undone;
}

bool ContactStages::redo(std::size_t max_blocks) noexcept {
  subset_ = 0;
  std::size_t redone = 0;
  do {
    const auto origin = workpiece_.redo_block();
    if (!origin) return true;
    list_change(*origin);
  } while (++redone < max_blocks);
  return false;
}

void ContactStages::restart() {
  change_all();
  pressed_ = {};
  bounds_ = workpiece_.bounds();
  subset_ = 0;
}

}  // namespace hapticut
