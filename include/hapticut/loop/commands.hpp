// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "hapticut/core/description.hpp"
#include "hapticut/force/effects/axis_mask.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/loop/workspace_map.hpp"
#include "hapticut/simulation/exchange.hpp"
#include "hapticut/simulation/output.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// Commands to a model while the loop runs, sent by `RealtimeLoop::send`. The loop applies them between two ticks, in
/// the order of sending. The sender allocates all memory in the constructor of the command. The loop only swaps
/// pointers; the replaced objects go back in the command and are freed outside the loop.
///
/// After `SetTool`, `SetMaterials`, `ExchangeWorkpiece`, `Undo` and `Redo` the guard waits until the tool is free
/// (`SafetyEvent::model_swapped`), because the tool may be inside material. docs/files.md lists the setters of
/// Simulation that end a recording; a command that calls one ends it too.
namespace commands {

/// A command without fields.
template <class Word>
requires std::is_empty_v<Word>
constexpr auto fields_of(Of<Word>) { return std::tuple{}; }

/// Sets the spindle's speed while there is a force.
struct SetSpindleSpeed {
  AngularSpeed speed = {};  ///< [rad/s] 0: the spindle stands
};

constexpr auto fields_of(Of<SetSpindleSpeed>) {
  return std::tuple{
      field("speed", &SetSpindleSpeed::speed, "rad/s", range_of(&Spindle::speed), "0: the spindle stands")};
}

/// Opens the clutch: the hand moves, the tool stays.
struct OpenClutch {};

/// Closes the clutch: the tool follows the hand again, from its present pose.
struct CloseClutch {};

/// Sets how far the tool moves with the hand.
struct SetScale {
  double scale = 1;  ///< [1] distance in the world per distance of the hand
};

constexpr auto fields_of(Of<SetScale>) {
  return std::tuple{field("scale", &SetScale::scale, "1", range_of(&WorkspaceMapOptions::scale),
                          "distance in the world per distance of the hand")};
}

/// Marks the state of the workpiece in this tick. Refused without SimulationModelOptions::undo_blocks.
struct SetUndoMark {};

/// Returns the workpiece to the last mark. This takes as many ticks as needed, without a force. Refused without a mark.
struct Undo {};

/// Redoes the last undo. This takes as many ticks as needed, without a force. Refused when something was cut since.
struct Redo {};

/// Holds the last force, wherever the hand moves. The spindle stands meanwhile, because nothing may be cut that the
/// hand cannot feel. After `hold` = false the hand feels the contact again once the tool was free. An exchange or an
/// undo ends the hold.
struct HoldForce {
  bool hold = true;  ///< false: end the hold
};

constexpr auto fields_of(Of<HoldForce>) { return std::tuple{field("hold", &HoldForce::hold, "false: end the hold")}; }

/// Sets whether and how material is removed.
struct SetRemoval {
  RemovalLaw removal = RemovalLaw::none;  ///< none: the spindle cuts nothing
};

constexpr auto fields_of(Of<SetRemoval>) {
  return std::tuple{field("removal", &SetRemoval::removal, "none: the spindle cuts nothing")};
}

/// Sets which components of the force are on: Effects::enabled.
struct SetForceMask {
  AxisMask enabled;  ///< the new value
};

constexpr auto fields_of(Of<SetForceMask>) {
  return std::tuple{field("enabled", &SetForceMask::enabled, "the new value")};
}

/// Sets the dry friction: see SimulationConfig::friction.
struct SetFriction {
  std::optional<DryFriction> friction;  ///< empty: the friction of each material
};

constexpr auto fields_of(Of<SetFriction>) {
  return std::tuple{field("friction", &SetFriction::friction, "empty: the friction of each material")};
}

/// Sets the effects that are added to the force, and its limits.
struct SetEffects {
  Effects effects;  ///< the new value
};

constexpr auto fields_of(Of<SetEffects>) { return std::tuple{field("effects", &SetEffects::effects, "the new value")}; }

/// Exchanges the tool: see Simulation::set.
struct SetTool {
  /// @param voxel_size  [m] of the workpiece; the loop refuses the command if its workpiece has another one
  /// @param config      of the simulation
  /// @throws Error when the head does not suit the voxels or the law
  SetTool(Tool tool, double voxel_size, const SimulationConfig& config);

  PreparedTool tool;
};

/// Exchanges the constants of the materials: see Simulation::set. Refused when the number of materials
/// differs from that of the workpiece.
struct SetMaterials {
  /// @param config  of the simulation
  /// @throws Error when a stiffness is out of range
  SetMaterials(MaterialTable materials, const SimulationConfig& config);

  PreparedMaterials materials;
};

/// Exchanges workpiece and tool for those of a prepared simulation: see Simulation::exchange(Simulation&). All blocks
/// of the new workpiece are sent, some with each tick, with another ChangedBlock::workpiece. The sender has the
/// workpiece and can draw it at once.
struct ExchangeWorkpiece {
  /// @param prepared  with memory for undo, if needed
  explicit ExchangeWorkpiece(Simulation prepared);

  std::unique_ptr<Simulation> simulation;
};

}  // namespace commands

/// A command to the loop. Its position in this list, from 1, is its code in C. Add new commands at the end.
using LoopCommand =
    std::variant<commands::SetSpindleSpeed, commands::OpenClutch, commands::CloseClutch, commands::SetScale,
                 commands::SetUndoMark, commands::Undo, commands::Redo, commands::HoldForce, commands::SetRemoval,
                 commands::SetForceMask, commands::SetFriction, commands::SetEffects, commands::SetTool,
                 commands::SetMaterials, commands::ExchangeWorkpiece>;

/// Calls `visit(n, Of<T>{})` for the n-th alternative T of a variant, from n = 1, until it returns true.
template <class Variant, class Visit>
constexpr bool find_alternative(Visit&& visit) {
  return [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    return (visit(kIndex + 1, Of<std::variant_alternative_t<kIndex, Variant>>{}) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

}  // namespace hapticut
