// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact_stages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/reserve.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/lumped.hpp"

namespace hapticut {
namespace {

constexpr int kListedSubSteps = 64;  // whose changed blocks are listed one by one before repetitions are dropped

/// What the contact is computed with in single precision: far beyond any material, and squares of it are still finite.
constexpr double kSoftest = 1, kStiffest = 1e25;  // [N/m^4]

/// The box of voxels that the head can reach, cut to `bounds`.
IndexBox reach_of(const HeadBox& box, const Pose& X_VT, double voxel_size, const IndexBox& bounds) noexcept {
  const Vec3 center = X_VT * Vec3(0.5 * (box.min + box.max)) / voxel_size;
  const Vec3 half = X_VT.rotation.cwiseAbs() * (0.5 * (box.max - box.min)) / voxel_size;
  IndexBox voxels;
  for (int axis = 0; axis < 3; ++axis) {
    // Half a voxel more: the quadrature point of a surface voxel lies off its centre.
    const double low = std::ceil(center[axis] - half[axis] - 0.5);
    const double high = std::floor(center[axis] + half[axis] + 0.5);
    voxels.min[axis] = int(std::clamp(low, double(bounds.min[axis]), bounds.max[axis] + 1.0));
    voxels.max[axis] = int(std::clamp(high, bounds.min[axis] - 1.0, double(bounds.max[axis])));
  }
  return voxels;
}

}  // namespace

ContactMaterials ContactStages::constants_of(const MaterialTable& table, double reference_stiffness) {
  ContactMaterials constants = {};
  constants[kEmpty].cutting_energy = 1;  // empty lanes are computed like others and must not divide by zero
  for (int id = 1; id <= table.size(); ++id) {
    const Material& m = table[MaterialId(id)];
    const double stiffness = m.relative_stiffness * reference_stiffness;
    require_between(
        stiffness, kSoftest, kStiffest,
        ("SimulationConfig::reference_stiffness times relative_stiffness of '" + m.name + "' [N/m^4]").c_str());
    constants[std::size_t(id)] = {float(stiffness), float(m.damping), float(m.cutting_ratio),
                                  float(m.specific_cutting_energy), float(std::sqrt(2 * m.edge_pressure / stiffness))};
  }
  return constants;
}

ContactStages::Room::Room(const ToolHead& head, double voxel_size, const SimulationConfig& config)
    : most_voxels(hapticut::most_voxels(head, voxel_size)), most_blocks(hapticut::most_blocks(head, voxel_size)) {
  reserve_touched(blocks, most_blocks);
  reserve_touched(emptied, most_blocks);
  reserve_touched(changed, most_blocks * std::size_t(std::min(config.longest_sweep, kListedSubSteps)));
}

ContactStages::ContactStages(const Workpiece& workpiece, const ToolHead& head, const SimulationConfig& config)
    : law_(std::dynamic_pointer_cast<const FoundationLaw>(config.law) ? nullptr : config.law),
      quadrature_(config.quadrature),
      voxel_volume_(std::pow(workpiece.voxel_size(), 3)),
      voxel_budget_(config.voxel_budget),
      bounds_(workpiece.bounds()) {
  ContactMaterials materials = constants_of(workpiece.materials(), config.reference_stiffness);
  exchange_materials(materials);
  if (law_ != nullptr && voxel_budget_ != 0)
    throw Error("SimulationConfig::voxel_budget = " + std::to_string(voxel_budget_) +
                " was given with a law of your own; only the default law has a level of detail. Leave it at 0.");
  Room room(head, workpiece.voxel_size(), config);
  exchange_room(room);
}

void ContactStages::exchange_room(Room& room) noexcept {
  forget_changes();
  emptied_.clear();
  blocks_.clear();
  std::swap(most_voxels_, room.most_voxels);
  std::swap(most_blocks_, room.most_blocks);
  std::swap(changed_, room.changed);
  std::swap(blocks_, room.blocks);
  std::swap(emptied_, room.emptied);
  turn_ = 0;
}

void ContactStages::exchange_materials(ContactMaterials& materials) noexcept {
  const double share = cutting_share_;
  set_cutting_share(1);
  std::swap(materials_, materials);
  for (std::size_t id = 0; id < materials_.size(); ++id) cutting_ratios_[id] = materials_[id].cutting_ratio;
  damped_ = std::any_of(materials_.begin(), materials_.end(), [](const auto& m) { return m.damping != 0; });
  set_cutting_share(share);
}

namespace {

WorstCase worst_case_of(std::size_t most_voxels, std::size_t most_blocks, const SimulationConfig& config) noexcept {
  const std::size_t budget = config.voxel_budget == 0 ? most_voxels : config.voxel_budget;
  const std::size_t parts = (most_voxels + budget - 1) / budget;
  return {most_blocks, std::min(most_voxels, budget), config.longest_sweep, int(parts)};
}

}  // namespace

WorstCase ContactStages::Room::worst_case(const SimulationConfig& config) const noexcept {
  return worst_case_of(most_voxels, most_blocks, config);
}

WorstCase ContactStages::worst_case(const SimulationConfig& config) const noexcept {
  return worst_case_of(most_voxels_, most_blocks_, config);
}

/// Into how many parts the voxels of the blocks found must be divided to stay within the budget.
int ContactStages::level_of_detail() const noexcept {
  if (voxel_budget_ == 0 || most_voxels_ <= voxel_budget_) return 1;
  std::size_t solid = 0;
  for (const BlockView& block : blocks_)
    for (int slab = 0; slab < kBlockEdge; ++slab)
      solid += block.solid == nullptr ? 64 : std::size_t(std::popcount(block.solid[slab]));
  return std::max(1, int((std::min(solid, most_voxels_) + voxel_budget_ - 1) / voxel_budget_));
}

void ContactStages::set_cutting_share(double share) noexcept {
  if (std::exchange(cutting_share_, share) == share) return;
  for (std::size_t id = 1; id < materials_.size(); ++id)
    materials_[id].cutting_ratio = float(share) * cutting_ratios_[id];
}

void ContactStages::find_blocks(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at) noexcept {
  blocks_.clear();
  const double size = workpiece.voxel_size();
  const IndexBox voxels = reach_of(head.bounding_box(), at.X_VT, size, bounds_);
  if (voxels.empty()) return;
  const GridInHead grid(at.X_VT.inverse(), size);
  head.visit_springs<float>([&](const auto& springs) {
    for (int i = block_start(voxels.min[0]); i <= voxels.max[0]; i += kBlockEdge)
      for (int j = block_start(voxels.min[1]); j <= voxels.max[1]; j += kBlockEdge)
        for (int k = block_start(voxels.min[2]); k <= voxels.max[2]; k += kBlockEdge) {
          const VoxelIndex origin = {i, j, k};
          if (!may_touch(springs, grid, origin, float(size))) continue;
          const BlockView block = workpiece.block(origin);
          if (!block.empty()) blocks_.push_back(block);
        }
  });
}

Encounter ContactStages::evaluate_contact(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                                          RemovalRecord& removal) noexcept {
  Encounter encounter;
  if (law_ == nullptr)
    press_blocks(workpiece, head, at, removal, encounter);
  else
    ask_law(workpiece, head, at, removal, encounter);
  encounter.drop_what_is_not_finite();
  return encounter;
}

kernels::ContactJob ContactStages::job_at(const Workpiece& workpiece, const ToolHead& head,
                                          const HeadPlacement& at) const noexcept {
  const int level = level_of_detail();
  kernels::ContactJob job = {head,
                             GridInHead(at.X_VT.inverse(), workpiece.voxel_size()),
                             at.motion,
                             materials_,
                             quadrature_,
                             damped_,
                             unsigned(level),
                             turn_};
  job.motion.turns = float(level);
  return job;
}

/// FoundationLaw, block by block in one pass of vector instructions.
void ContactStages::press_blocks(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                                 RemovalRecord& removal, Encounter& encounter) noexcept {
  const kernels::ContactJob job = job_at(workpiece, head, at);
  kernels::ContactSums sums;
  const bool cuts = at.motion.spin != 0 && at.motion.removal != RemovalLaw::none;
  for (auto next = blocks_.begin(); next != blocks_.end();) {
    std::size_t count = 0;
    while (next != blocks_.end() && count < kPressedAtOnce) {
      const BlockView& block = *next++;
      const bool writable = cuts && can_cut(block, workpiece);
      encounter.blocks_exhausted |= cuts && !writable;
      if (writable && block.fill != nullptr) workpiece.remember(block);
      tasks_[count++] = {block, fill_target(block), writable, {}};
      if (cuts && block.fill == nullptr) break;  // its new fills must be kept before another block needs their place
    }
    kernels::press_blocks(job, std::span(tasks_).first(count), sums);
    for (const kernels::PressTask& task : std::span(tasks_).first(count)) keep_change(task, workpiece);
  }
  take_sums(job, sums, encounter);
  for (int id = 1; id <= workpiece.materials().size(); ++id) {
    const double volume = sums.taken[std::size_t(id)] * voxel_volume_;
    if (volume == 0) continue;
    encounter.energies.cutting += double(materials_[std::size_t(id)].cutting_energy) * volume;
    removal.add_volume(MaterialId(id), volume);
  }
}

/// What the kernel's sums mean. Voxels that waited for their turn are represented by those that had it; what was taken
/// is exact.
void ContactStages::take_sums(const kernels::ContactJob& job, const kernels::ContactSums& sums,
                              Encounter& encounter) const noexcept {
  using kernels::ContactSums;
  const double weight = job.level_of_detail;
  encounter.level_of_detail = int(job.level_of_detail);
  const auto total = [&](ContactSums::Term term) { return weight * sums.total(term) * voxel_volume_; };
  Resultant& resultant = encounter.resultant;
  resultant.wrench_T.force =
      -Vec3(total(ContactSums::kForceX), total(ContactSums::kForceY), total(ContactSums::kForceZ));
  resultant.wrench_T.torque =
      -Vec3(total(ContactSums::kTorqueX), total(ContactSums::kTorqueY), total(ContactSums::kTorqueZ));
  if (job.motion.spin != 0) resultant.wrench_T.torque.z() -= total(ContactSums::kCouple) / double(job.motion.spin);
  resultant.voxels = sums.voxels * encounter.level_of_detail;
  resultant.volume = weight * sums.total(ContactSums::kFill);
  resultant.depth = double(sums.depth);
  LawEnergies& energies = encounter.energies;
  const double middle = total(ContactSums::kElasticMiddle), change = total(ContactSums::kElasticChange);
  const double taken = total(ContactSums::kTakenElastic) / weight;
  energies.elastic_before = middle - change;
  energies.elastic = middle + change - taken;
  energies.released = taken - 2 * total(ContactSums::kLag) - total(ContactSums::kHelped) / weight;
  energies.damping = total(ContactSums::kDamping);
  energies.rubbing = total(ContactSums::kRubbing) / weight;  // over all the time since the last turn
  energies.credited = total(ContactSums::kCredited) / weight;
}

Encounter ContactStages::probe_contact(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                                       Stiffness& stiffness_T) noexcept {
  if (law_ != nullptr) {
    stiffness_T.setZero();
    Encounter encounter;
    feel_law(workpiece, head, at, encounter, [](const BlockView&, bool) {});
    encounter.drop_what_is_not_finite();
    return encounter;
  }
  const kernels::ContactJob job = job_at(workpiece, head, at);
  kernels::ContactSums sums;
  kernels::StiffnessSums stiffness;
  const bool cuts = at.motion.spin != 0 && at.motion.removal != RemovalLaw::none;
  for (auto next = blocks_.begin(); next != blocks_.end();) {
    std::size_t count = 0;
    for (; next != blocks_.end() && count < kPressedAtOnce; ++next)  // nobody reads the new fills
      tasks_[count++] = {*next, new_fill_.data(), cuts && can_cut(*next, workpiece), {}};
    kernels::press_blocks(job, std::span(tasks_).first(count), sums, &stiffness);
  }
  Encounter encounter;
  take_sums(job, sums, encounter);
  stiffness_T = stiffness.total(double(job.level_of_detail) * voxel_volume_);
  return encounter;
}

/// Any other law, stage by stage on the samples of one block.
/// @param leave  called with what was sampled and left in `contact_`, and whether the law may remove any of it
template <class Leave>
void ContactStages::feel_law(const Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at,
                             Encounter& encounter, const Leave& leave) noexcept {
  const GridInHead grid(at.X_VT.inverse(), workpiece.voxel_size());
  HeadMotion motion = at.motion;
  WholeContact whole;
  if (law_->needs_moments()) {
    for (const BlockView& block : blocks_) {
      kernels::sample_contact(head, block, grid, quadrature_, contact_);
      add_moments(contact_, motion, materials_, whole.moments);
    }
    if (whole.moments.volume > 0) whole.lumped = law_->lump(head, motion, whole.moments);
    encounter.add(whole.lumped);
    motion.whole = &whole;
  }
  HeadMotion without_removal = motion;
  without_removal.removal = RemovalLaw::none;
  for (const BlockView& block : blocks_) {
    kernels::sample_contact(head, block, grid, quadrature_, contact_);
    if (contact_.samples == 0) continue;
    const bool removes = motion.removal != RemovalLaw::none, writable = removes && can_cut(block, workpiece);
    encounter.blocks_exhausted |= removes && !writable;
    const LawTotals totals = law_->evaluate(writable ? motion : without_removal, materials_, contact_);
    encounter.add(totals);
    kernels::sum_resultant(contact_, encounter.resultant);
    leave(block, totals.may_remove && writable);
  }
}

/// The same, and takes away what the law removes.
void ContactStages::ask_law(Workpiece& workpiece, const ToolHead& head, const HeadPlacement& at, RemovalRecord& removal,
                            Encounter& encounter) noexcept {
  std::array<double, 256> taken = {};
  feel_law(workpiece, head, at, encounter, [&](const BlockView& block, bool may_remove) {
    if (!may_remove) return;
    if (block.fill != nullptr) workpiece.remember(block);
    float* fill_after = fill_target(block);
    keep_change({block, fill_after, true, find_changes(contact_, block, fill_after, taken)}, workpiece);
  });
  for (int id = 1; id <= workpiece.materials().size(); ++id)
    removal.add_volume(MaterialId(id), taken[std::size_t(id)] * voxel_volume_);
}

/// Whether what is cut from a block can be written down. Where no reserved block is left, material is felt but not cut.
bool ContactStages::can_cut(const BlockView& block, const Workpiece& workpiece) noexcept {
  return block.fill != nullptr || workpiece.has_reserve_for(block.origin);
}

/// Where the new fills of a block are written: into the block itself, once it has fills of its own.
float* ContactStages::fill_target(const BlockView& block) noexcept {
  return block.fill != nullptr ? const_cast<float*>(block.fill) : new_fill_.data();
}

/// Gives a block that was cut for the first time fills of its own, and notes its emptied voxels.
void ContactStages::keep_change(const kernels::PressTask& task, Workpiece& workpiece) noexcept {
  const auto& [block, fill_after, may_cut, change] = task;
  if (change.strips == 0) return;
  workpiece.forget_redo();
  list_change(block.origin);
  if (block.fill == nullptr) {
    float* fill = workpiece.writable_fill(block.origin);
    HAPTICUT_ASSERT(fill != nullptr);  // can_cut said so
    for (std::uint32_t strips = change.strips; strips != 0; strips &= strips - 1) {
      const int first = BlockChange::kStrip * std::countr_zero(strips);
      std::copy_n(fill_after + first, BlockChange::kStrip, fill + first);
    }
  }
  if (change.any_emptied) emptied_.push_back({block, change.emptied});
}

void ContactStages::forget_changes() noexcept {
  changed_.clear();
  changed_blocks_ = {};
}

void ContactStages::list_change(const VoxelIndex& origin) noexcept {
  if (!changed_blocks_.complete) return;
  if (changed_.size() == changed_.capacity()) {  // only in sweeps of very many sub-steps, and in great undos
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    // Sorting again for a few more would take the longer, the fuller the list is.
    changed_blocks_.complete = 4 * changed_.size() <= 3 * changed_.capacity();
  }
  if (changed_blocks_.complete) changed_.push_back(origin);
  changed_blocks_.origins = changed_;
}

void ContactStages::remove_material(Workpiece& workpiece, RemovalRecord& removal) noexcept {
  for (const EmptiedBlock& entry : emptied_) empty_voxels(entry.block, entry.emptied, workpiece, removal);
  emptied_.clear();
  ++turn_;
}

std::size_t ContactStages::undo(Workpiece& workpiece, std::size_t most) noexcept {
  std::size_t undone = 0;
  do {  // one at least, or who asks for none would never arrive
    const auto origin = workpiece.undo_block();
    if (!origin) break;
    list_change(*origin);
  } while (++undone < most);
  turn_ = 0;
  return undone;
}

bool ContactStages::redo(Workpiece& workpiece, std::size_t most) noexcept {
  turn_ = 0;
  std::size_t redone = 0;
  do {
    const auto origin = workpiece.redo_block();
    if (!origin) return true;
    list_change(*origin);
  } while (++redone < most);
  return false;
}

void ContactStages::start_afresh(const Workpiece& workpiece) {
  bounds_ = workpiece.bounds();
  turn_ = 0;
}

}  // namespace hapticut
