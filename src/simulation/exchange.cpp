// SPDX-License-Identifier: Apache-2.0
// Exchanges between two steps: tool, materials, friction, removal, another workpiece.
#include "hapticut/simulation/exchange.hpp"

#include <algorithm>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/reserve.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/stiffness.hpp"
#include "simulation/removed_list.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {

// --- prepared elsewhere ---------------------------------------------------------------------------------------------

struct PreparedTool::State {
  Tool tool;
  double voxel_size;  // [m]
  ContactStages::Buffers buffers;
  WorstCase worst_case;
  std::vector<RemovedVoxel> removed;
  HeadStiffness stiffness;
  double thickest_chip;  // [m]
};

PreparedTool::PreparedTool(Tool tool, double voxel_size, const SimulationConfig& config) {
  require_positive(voxel_size, "PreparedTool: voxel_size [m]");
  validate_head(tool.head(), voxel_size);
  config.law->require_head(tool.head());
  ContactStages::Buffers buffers(tool.head(), voxel_size, config);
  const WorstCase worst = buffers.worst_case(config);
  std::vector<RemovedVoxel> removed;
  reserve_touched(removed, removed_list_size(config, buffers.max_voxels));
  const HeadStiffness stiffness = stiffness_of(tool.head(), config);
  const double thickest_chip = crowded_chip(tool);
  state_ = std::make_unique<State>(
      State{std::move(tool), voxel_size, std::move(buffers), worst, std::move(removed), stiffness, thickest_chip});
}

PreparedTool::PreparedTool(PreparedTool&&) noexcept = default;
PreparedTool& PreparedTool::operator=(PreparedTool&&) noexcept = default;
PreparedTool::~PreparedTool() = default;

const Tool& PreparedTool::tool() const noexcept { return state_->tool; }
double PreparedTool::voxel_size() const noexcept { return state_->voxel_size; }
WorstCase PreparedTool::worst_case() const noexcept { return state_->worst_case; }

struct PreparedMaterials::State {
  MaterialTable materials;
};

PreparedMaterials::PreparedMaterials(MaterialTable materials, const SimulationConfig& config) {
  require_contact_stiffness(materials, config.reference_stiffness);
  state_ = std::make_unique<State>(State{std::move(materials)});
}

PreparedMaterials::PreparedMaterials(PreparedMaterials&&) noexcept = default;
PreparedMaterials& PreparedMaterials::operator=(PreparedMaterials&&) noexcept = default;
PreparedMaterials::~PreparedMaterials() = default;

const MaterialTable& PreparedMaterials::materials() const noexcept { return state_->materials; }

// --- between steps --------------------------------------------------------------------------------------------------

/// Sets the constants of the materials for the contact, with the chosen stiffness if it was left to the simulation.
void Simulation::State::set_contact_materials() noexcept {
  if (chooses_stiffness) config.reference_stiffness = head_stiffness.in(workpiece.materials());
  contact_stages.set_materials(
      contact_materials(workpiece.materials(), config.reference_stiffness, config.contact_damping.value_or(0)));
  set_material_friction();
}

/// Sets the friction of each material against a standing head.
void Simulation::State::set_material_friction() noexcept {
  for (int id = 1; id <= workpiece.materials().size(); ++id) {
    const Material& m = *workpiece.materials().find(MaterialId(id));
    const DryFriction own = {m.static_friction, m.dynamic_friction, m.tangential_stiffness};
    contact_stages.set_friction(MaterialId(id), config.friction.value_or(own));
  }
}

bool any_for_other_cutter(const MaterialTable& materials, CutterKind cutter) noexcept {
  return std::ranges::any_of(materials.all(), [&](const Material& m) { return m.cutter.value_or(cutter) != cutter; });
}

/// Makes the next step the first of the tool.
void Simulation::State::forget_pose() noexcept {
  motion.forget_place();
  tell_of_exchange();
}

bool Simulation::exchange(PreparedTool& prepared) noexcept {
  State& s = *state_;
  PreparedTool::State& p = *prepared.state_;
  if (p.voxel_size != s.workpiece.voxel_size()) return false;
  const WorstCase worst = s.contact_stages.worst_case(s.config);
  std::swap(s.tool, p.tool);
  s.contact_stages.exchange_buffers(p.buffers);
  s.removal.exchange_list(p.removed);
  std::swap(s.head_stiffness, p.stiffness);
  p.worst_case = worst;
  s.set_contact_materials();
  s.result.removed_voxels = {};
  s.spindle.exchange(s.tool.spindle());
  std::swap(s.thickest_chip, p.thickest_chip);
  s.other_cutter = any_for_other_cutter(s.workpiece.materials(), s.tool.cutter().kind);
  s.forget_pose();
  return true;
}

bool Simulation::exchange(PreparedMaterials& prepared) noexcept {
  State& s = *state_;
  PreparedMaterials::State& p = *prepared.state_;
  if (!s.workpiece.exchange_materials(p.materials)) return false;
  s.set_contact_materials();
  s.other_cutter = any_for_other_cutter(s.workpiece.materials(), s.tool.cutter().kind);
  s.forget_pose();
  return true;
}

void Simulation::exchange(Simulation& prepared) noexcept {
  const bool spindle_held = state_->spindle.is_held();
  state_->spindle.hold(false);
  std::swap(state_, prepared.state_);
  state_->spindle.hold(spindle_held);
  const State& old = *prepared.state_;
  State& s = *state_;
  s.config.effects = old.config.effects;
  s.config.friction = old.config.friction;
  s.config.removal = old.config.removal;
  s.set_material_friction();
  s.totals.replace(old.totals);
  s.motion.separate_as(old.motion);
  std::swap(s.observers, prepared.state_->observers);
  s.contact_stages.change_all();
  s.forget_pose();
  prepared.state_->tell_of_exchange();
}

void Simulation::set(Tool tool) {
  PreparedTool prepared(std::move(tool), state_->workpiece.voxel_size(), state_->config);
  [[maybe_unused]] const bool fits = exchange(prepared);
  HAPTICUT_ASSERT(fits);
}

void Simulation::set(MaterialTable materials) {
  PreparedMaterials prepared(std::move(materials), state_->config);
  if (!exchange(prepared))
    throw Error("a table of " + std::to_string(prepared.materials().size()) +
                " materials was given for a workpiece of " + std::to_string(state_->workpiece.materials().size()) +
                "; change the constants, not the number of materials.");
}

void Simulation::set(const std::optional<DryFriction>& friction) {
  if (friction) validate(*friction);
  state_->config.friction = friction;
  state_->set_material_friction();
  state_->tell_of_exchange();
}

void Simulation::set(RemovalLaw removal) noexcept {
  if (std::exchange(state_->config.removal, removal) != removal) state_->tell_of_exchange();
}

}  // namespace hapticut
