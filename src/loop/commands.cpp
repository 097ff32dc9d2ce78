// SPDX-License-Identifier: Apache-2.0
// Commands: made by their senders, obeyed by a SimulationModel between two ticks.
#include "hapticut/loop/commands.hpp"

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/loop/simulation_model.hpp"

namespace hapticut {

static_assert(std::is_nothrow_move_constructible_v<LoopCommand> && std::is_nothrow_move_assignable_v<LoopCommand>);

namespace commands {

SetTool::SetTool(Tool given_tool, double voxel_size, const SimulationConfig& config)
    : tool(std::move(given_tool), voxel_size, config), lists(tool.worst_case(), config) {}

SetMaterials::SetMaterials(MaterialTable table, const SimulationConfig& config) : materials(std::move(table), config) {}

ExchangeWorkpiece::ExchangeWorkpiece(Simulation prepared)
    : simulation(std::make_unique<Simulation>(std::move(prepared))),
      bounds(simulation->workpiece().bounds()),
      lists(simulation->worst_case(), simulation->config()) {}

}  // namespace commands

// --- the sender's side ----------------------------------------------------------------------------------------------

commands::SetTool SimulationModel::prepare_tool(Tool tool) const { return {std::move(tool), voxel_size_, config_}; }

commands::SetMaterials SimulationModel::prepare_materials(MaterialTable materials) const {
  return {std::move(materials), config_};
}

commands::ExchangeWorkpiece SimulationModel::prepare_workpiece(Workpiece workpiece, Tool tool) const {
  Simulation simulation(std::move(workpiece), std::move(tool), config_);
  if (undo_blocks_ > 0) simulation.reserve_undo(undo_blocks_);
  return commands::ExchangeWorkpiece(std::move(simulation));
}

void SimulationModel::check(const LoopCommand& command) const {
  if (const auto* spindle = std::get_if<commands::SetSpindleSpeed>(&command)) validate(Spindle{spindle->speed});
  if (const auto* scale = std::get_if<commands::SetScale>(&command)) check_scale(scale->scale);
  if (const auto* friction = std::get_if<commands::SetFriction>(&command))
    if (friction->friction) validate(*friction->friction);
  if (const auto* effects = std::get_if<commands::SetEffects>(&command))
    validate(effects->effects, config_.update_rate);
  const auto* tool = std::get_if<commands::SetTool>(&command);
  const auto* materials = std::get_if<commands::SetMaterials>(&command);
  const auto* other = std::get_if<commands::ExchangeWorkpiece>(&command);
  if ((tool && tool->tool.empty()) || (materials && materials->materials.empty()) || (other && !other->simulation))
    throw Error("the command was sent already, and what it brings with it; prepare another one.");
  if (other && gains_ && other->simulation->config().contact_time != ContactTime::end)
    throw Error(
        "the other workpiece's simulation evaluates contact in the middle of a step, where the coupling would swing. "
        "Make it with SimulationConfig::contact_time = ContactTime::end.");
  const double scale = first_map_.scale;
  if (tool)
    require_renderable(largest_contact_stiffness(tool->tool.tool().head()), config_, relative_stiffness_, scale);
  if (materials)
    require_renderable(contact_stiffness_, config_, largest_relative_stiffness(materials->materials.materials()),
                       scale);
  if (other)
    require_renderable(largest_contact_stiffness(other->simulation->tool().head()), other->simulation->config(),
                       largest_relative_stiffness(other->simulation->workpiece().materials()), scale);
}

/// Whether the coupling has gains in the world.
void SimulationModel::require_gains_within(const WorkspaceMapOptions& map) const {
  if (!gains_) return;
  validate(*gains_);
  try {
    validate(gains_in_world(*gains_, map));
  } catch (const Error& error) {
    throw Error("the scale of " + format_number(map.scale) +
                " m in the world per metre of the hand, with a force scale "
                "of " +
                format_number(map.force_scale) + " and a torque scale of " + format_number(map.torque_scale) +
                ", takes the coupling out of its range: " + error.what() + " Choose scales nearer to 1.");
  }
}

void SimulationModel::check_scale(double scale) const {
  require_within(scale, range_of(&WorkspaceMapOptions::scale), "SetScale::scale");
  WorkspaceMapOptions map = first_map_;
  map.scale = scale;
  require_gains_within(map);
  require_renderable(contact_stiffness_, config_, relative_stiffness_, scale);
}

// --- the loop's side ------------------------------------------------------------------------------------------------

bool SimulationModel::obey(LoopCommand& command) noexcept {
  bool obeyed = false;  // std::visit may throw, as far as its type says
  const auto apply_if = [&](auto* what) noexcept {
    if (what != nullptr) obeyed = apply(*what);
    return what != nullptr;
  };
  [&]<std::size_t... kKind>(std::index_sequence<kKind...>) { (void)(apply_if(std::get_if<kKind>(&command)) || ...); }
  (std::make_index_sequence<std::variant_size_v<LoopCommand>>());
  return obeyed;
}

bool SimulationModel::apply(const commands::SetSpindleSpeed& command) noexcept {
  if (!(std::abs(command.speed) <= kFastestSpindle)) return false;
  simulation_->set_spindle_speed(command.speed);
  return true;
}

bool SimulationModel::apply(const commands::OpenClutch& /*command*/) noexcept {
  map_.release(X_BS_);
  return true;
}

bool SimulationModel::apply(const commands::CloseClutch& /*command*/) noexcept {
  map_.engage(X_BS_);
  unfelt_ = true;
  interlock_.interrupt();  // it cuts nothing in this tick; the guard's state says so only from the next one on
  touches_ = true;         // for all that is known
  device_->interrupt(SafetyEvent::reclutched);
  return true;
}

bool SimulationModel::apply(const commands::SetScale& command) noexcept {
  if (!map_.set_scale(command.scale, X_BS_)) return false;
  if (coupling_) coupling_->set_gains(gains_in_world(*gains_, map_.options()));
  device_->interrupt(SafetyEvent::reclutched);
  return true;
}

bool SimulationModel::apply(const commands::SetUndoMark& /*command*/) noexcept {
  return travel_ == Travel::none && simulation_->set_undo_mark();
}

bool SimulationModel::apply(const commands::Undo& /*command*/) noexcept {
  return begin(Travel::back, simulation_->undo_marks());
}

bool SimulationModel::apply(const commands::Redo& /*command*/) noexcept {
  return begin(Travel::forth, simulation_->redo_marks());
}

bool SimulationModel::begin(Travel way, std::size_t marks) noexcept {
  if (travel_ != Travel::none || marks == 0) return false;
  travel_ = way;
  tool_.force_held = false;
  feel_nothing(StepStatus::ok);
  if (coupling_) coupling_->leave(VirtualCoupling::Rejoin::free);
  return true;
}

/// Nothing that was felt counts any more, and nobody knows what is touched.
void SimulationModel::feel_nothing(StepStatus status) noexcept {
  tool_.force = tool_.torque = Vec3::Zero();
  tool_.contact_depth = tool_.spindle_speed = 0;
  tool_.contact_voxels = 0;
  tool_.contact_point.setZero();
  tool_.effort = {};
  tool_.status = status;
  touches_ = true;
}

/// The material that the tool is in now must not be felt at once.
void SimulationModel::after_exchange() noexcept {
  tool_.force_held = false;
  interlock_.interrupt();
  unfelt_ = true;
  feel_nothing(StepStatus::ok);
  if (coupling_) coupling_->leave(VirtualCoupling::Rejoin::free);
  if (spindle_needs_force_) simulation_->hold_spindle(true);  // or it would cut while it runs down
  device_->interrupt(SafetyEvent::model_swapped);
}

bool SimulationModel::apply(commands::SetTool& command) noexcept {
  if (!simulation_->exchange(command.tool)) return false;
  if (coupling_) coupling_->exchange_lists(command.lists);
  after_exchange();
  return true;
}

bool SimulationModel::apply(commands::SetMaterials& command) noexcept {
  if (!simulation_->exchange(command.materials)) return false;
  after_exchange();
  return true;
}

bool SimulationModel::apply(const commands::SetFriction& command) noexcept {
  simulation_->set_friction(command.friction);
  return true;
}

bool SimulationModel::apply(const commands::SetEffects& command) noexcept {
  simulation_->set_effects(command.effects);
  return true;
}

bool SimulationModel::apply(const commands::SetForceMask& command) noexcept {
  Effects effects = simulation_->config().effects;
  effects.enabled = command.enabled;
  simulation_->set_effects(effects);
  return true;
}

bool SimulationModel::apply(const commands::SetRemoval& command) noexcept {
  simulation_->set_removal(command.removal);
  return true;
}

bool SimulationModel::apply(const commands::HoldForce& command) noexcept {
  if (command.hold == tool_.force_held) return true;
  if (command.hold) {
    if (travel_ != Travel::none || unfelt_) return false;  // nothing is felt that could be held
    tool_.force_held = true;
    return true;
  }
  // The tool went on meanwhile: what it has met is not to be felt at once.
  tool_.force_held = false;
  unfelt_ = true;
  device_->interrupt(SafetyEvent::reclutched);
  return true;
}

bool SimulationModel::apply(commands::ExchangeWorkpiece& command) noexcept {
  if (gains_ && command.simulation->config().contact_time != ContactTime::end) return false;
  simulation_->exchange(*command.simulation);
  std::swap(bounds_, command.bounds);
  if (coupling_) coupling_->exchange_lists(command.lists);
  travel_ = Travel::none;
  books_energy_ = simulation_->config().law->is_foundation();
  ++tool_.workpiece;
  after_exchange();
  return true;
}

}  // namespace hapticut
