// SPDX-License-Identifier: Apache-2.0
// Commands: their senders make them, and a SimulationModel applies them between two ticks.
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
#include "loop/command_ranges.hpp"

namespace hapticut {

static_assert(std::is_nothrow_move_constructible_v<LoopCommand> && std::is_nothrow_move_assignable_v<LoopCommand>);

namespace commands {

SetTool::SetTool(Tool given_tool, double voxel_size, const SimulationConfig& config)
    : tool(std::move(given_tool), voxel_size, config) {}

SetMaterials::SetMaterials(MaterialTable table, const SimulationConfig& config) : materials(std::move(table), config) {}

ExchangeWorkpiece::ExchangeWorkpiece(Simulation prepared)
    : simulation(std::make_unique<Simulation>(std::move(prepared))) {}

}  // namespace commands

// --- for the senders -------------------------------------------------------------------------------------------------

commands::SetTool SimulationModel::prepare_tool(Tool tool) const { return {std::move(tool), voxel_size_, config_}; }

commands::SetMaterials SimulationModel::prepare_materials(MaterialTable materials) const {
  return {std::move(materials), config_};
}

commands::ExchangeWorkpiece SimulationModel::prepare_workpiece(Workpiece workpiece, Tool tool) const {
  Simulation simulation(std::move(workpiece), std::move(tool), config_);
  if (undo_blocks_ > 0) simulation.history().reserve(undo_blocks_);
  return commands::ExchangeWorkpiece(std::move(simulation));
}

/// Checks the gains of the coupling in the world.
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
                ", puts the coupling out of range: " + error.sentence() + " Choose scales closer to 1.");
  }
}

bool SimulationModel::begin_restoring(Restoring what, std::size_t marks) noexcept {
  if (restoring_ != Restoring::none || marks == 0) return false;
  restoring_ = what;
  tool_.force_held = false;
  feel_nothing(StepStatus::ok);
  if (coupling_) coupling_->park(VirtualCoupling::Rejoin::free);
  return true;
}

/// Clears the force and the contact. The tool may touch something.
void SimulationModel::feel_nothing(StepStatus status) noexcept {
  tool_.force = tool_.torque = Vec3::Zero();
  tool_.contact_depth = tool_.spindle_speed = 0;
  tool_.contact_voxels = 0;
  tool_.contact_point_W.setZero();
  tool_.effort = {};
  tool_.status = status;
  touches_ = true;
}

/// The material that the tool is in now must not be felt at once.
void SimulationModel::after_exchange() noexcept {
  tool_.force_held = false;
  interlock_.interrupt();
  skip_force_ = true;
  feel_nothing(StepStatus::ok);
  if (coupling_) coupling_->park(VirtualCoupling::Rejoin::free);
  if (spindle_needs_force_) simulation_->spindle().hold(true);  // otherwise it would cut while it slows down
  device_->interrupt(SafetyEvent::model_swapped);
}

// --- check and effect of each command -------------------------------------------------------------------------------

/// @tparam Model  const for checks in the sending thread
template <class Model>
struct SimulationModel::Commands {
  Model& m;

  static void require_unsent(bool has_all) {
    if (!has_all) throw Error("the command was already sent and has no content any more; prepare another one.");
  }

  /// A command without a check of its own: its numbers are within the ranges of `fields_of`.
  template <Described Command>
  void check(const Command& command) const {
    require_in_range(command);
  }

  void check(const commands::SetSpindleSpeed& command) const { validate(Spindle{command.speed}); }

  bool apply(const commands::SetSpindleSpeed& command) noexcept {
    if (!(std::abs(command.speed) <= kMaxSpindleSpeed)) return false;
    m.simulation_->spindle().set_speed(command.speed);
    return true;
  }

  bool apply(const commands::OpenClutch&) noexcept {
    m.map_.disengage(m.X_BS_);
    return true;
  }

  bool apply(const commands::CloseClutch&) noexcept {
    m.map_.engage(m.X_BS_);
    m.skip_force_ = true;
    m.interlock_.interrupt();  // nothing is cut in this tick; the guard's state follows only in the next one
    m.touches_ = true;         // or may touch something
    m.device_->interrupt(SafetyEvent::reclutched);
    return true;
  }

  void check(const commands::SetScale& command) const {
    require_within(command.scale, range_of(&commands::SetScale::scale), "SetScale::scale");
    WorkspaceMapOptions map = m.first_map_;
    map.scale = command.scale;
    m.require_gains_within(map);
    m.require_renderable(m.contact_stiffness_, m.config_, m.relative_stiffness_, command.scale);
  }

  bool apply(const commands::SetScale& command) noexcept {
    if (!m.map_.set_scale(command.scale, m.X_BS_)) return false;
    if (m.coupling_) m.coupling_->set_gains(gains_in_world(*m.gains_, m.map_.options()));
    m.device_->interrupt(SafetyEvent::reclutched);
    return true;
  }

  bool apply(const commands::SetUndoMark&) noexcept {
    return m.restoring_ == Restoring::none && m.simulation_->history().mark();
  }

  bool apply(const commands::Undo&) noexcept {
    return m.begin_restoring(Restoring::undo, m.simulation_->workpiece().marks());
  }

  bool apply(const commands::Redo&) noexcept {
    return m.begin_restoring(Restoring::redo, m.simulation_->workpiece().redo_marks());
  }

  void check(const commands::SetTool& command) const {
    require_unsent(!command.tool.empty());
    m.require_renderable(max_contact_stiffness(command.tool.tool().head()), m.config_, m.relative_stiffness_,
                         m.first_map_.scale);
  }

  bool apply(commands::SetTool& command) noexcept {
    if (!m.simulation_->exchange(command.tool)) return false;
    m.after_exchange();
    return true;
  }

  void check(const commands::SetMaterials& command) const {
    require_unsent(!command.materials.empty());
    m.require_renderable(m.contact_stiffness_, m.config_, max_relative_stiffness(command.materials.materials()),
                         m.first_map_.scale);
  }

  bool apply(commands::SetMaterials& command) noexcept {
    if (!m.simulation_->exchange(command.materials)) return false;
    m.after_exchange();
    return true;
  }

  void check(const commands::SetFriction& command) const {
    if (command.friction) validate(*command.friction);
  }

  bool apply(const commands::SetFriction& command) noexcept {
    m.simulation_->set(command.friction);
    return true;
  }

  void check(const commands::SetEffects& command) const { validate(command.effects, m.config_.update_rate); }

  bool apply(const commands::SetEffects& command) noexcept {
    m.simulation_->set(command.effects);
    return true;
  }

  bool apply(const commands::SetForceMask& command) noexcept {
    Effects effects = m.simulation_->config().effects;
    effects.enabled = command.enabled;
    m.simulation_->set(effects);
    return true;
  }

  bool apply(const commands::SetRemoval& command) noexcept {
    m.simulation_->set(command.removal);
    return true;
  }

  bool apply(const commands::HoldForce& command) noexcept {
    if (command.hold == m.tool_.force_held) return true;
    if (command.hold) {
      if (m.restoring_ != Restoring::none || m.skip_force_) return false;  // there is no force to hold
      m.tool_.force_held = true;
      return true;
    }
    // The tool has moved meanwhile: a new contact must not be felt at once.
    m.tool_.force_held = false;
    m.skip_force_ = true;
    m.device_->interrupt(SafetyEvent::reclutched);
    return true;
  }

  void check(const commands::ExchangeWorkpiece& command) const {
    require_unsent(command.simulation != nullptr);
    const Simulation& other = *command.simulation;
    if (m.gains_ && other.config().contact_time != ContactTime::end)
      throw Error(
          "the other workpiece's simulation evaluates contact in the middle of a step, so the coupling would "
          "oscillate. "
          "Make it with " +
          "SimulationConfig::contact_time"_name + " = " + "ContactTime::end"_name + ".");
    m.require_renderable(max_contact_stiffness(other.tool().head()), other.config(),
                         max_relative_stiffness(other.workpiece().materials()), m.first_map_.scale);
  }

  bool apply(commands::ExchangeWorkpiece& command) noexcept {
    if (m.gains_ && command.simulation->config().contact_time != ContactTime::end) return false;
    m.simulation_->exchange(*command.simulation);
    m.restoring_ = Restoring::none;
    m.books_energy_ = m.simulation_->config().law->is_foundation();
    ++m.tool_.workpiece;
    m.after_exchange();
    return true;
  }
};

void SimulationModel::check(const LoopCommand& command) const {
  std::visit([this](const auto& what) { Commands<const SimulationModel>{*this}.check(what); }, command);
}

bool SimulationModel::apply(LoopCommand& command) noexcept {
  bool applied = false;  // not std::visit, because that may throw
  find_alternative<LoopCommand>([&]<class Command>(std::size_t, Of<Command>) noexcept {
    auto* what = std::get_if<Command>(&command);
    if (what != nullptr) applied = Commands<SimulationModel>{*this}.apply(*what);
    return what != nullptr;
  });
  return applied;
}

}  // namespace hapticut
