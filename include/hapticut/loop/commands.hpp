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
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/exchange.hpp"
#include "hapticut/simulation/output.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// What a model can be told while the loop runs, by `RealtimeLoop::send`: obeyed between two ticks, in the order in
/// which it was sent. What needs memory is made by the sender, in the constructor of the command; the loop swaps
/// pointers, and what was in place before goes back in the command, to be freed outside of the loop.
///
/// After `SetTool`, `SetMaterials`, `ExchangeWorkpiece`, `Undo` and `Redo` the guard waits until the tool is free
/// (`SafetyEvent::model_swapped`), for material may be where the tool is. docs/files.md says which commands end a
/// recording.
namespace commands {

/// A command without fields.
template <class Word>
requires std::is_empty_v<Word>
constexpr auto fields_of(Of<Word>) { return std::tuple{}; }

/// The spindle's speed while there is a force.
struct SetSpindleSpeed {
  AngularSpeed speed = {};
};

constexpr auto fields_of(Of<SetSpindleSpeed>) {
  return std::tuple{field("speed", &SetSpindleSpeed::speed, "rad/s", range_of(&Spindle::speed), "0: it stands")};
}

/// The hand moves, the tool stays.
struct OpenClutch {};

/// The tool follows again, from where it is.
struct CloseClutch {};

/// How far the tool moves with the hand.
struct SetScale {
  double scale = 1;
};

constexpr auto fields_of(Of<SetScale>) {
  return std::tuple{field("scale", &SetScale::scale, "1", range_of(&WorkspaceMapOptions::scale), "world over hand")};
}

/// Marks the workpiece as it is in this tick. Without SimulationModelOptions::undo_blocks it is refused.
struct SetUndoMark {};

/// Puts the workpiece back to the last mark, over as many ticks as it takes and without a force. Without a mark it is
/// refused.
struct Undo {};

/// Goes forth again to what was undone last, the same way. When something has been cut since, it is refused.
struct Redo {};

/// The hand goes on feeling what it felt last, wherever it moves, and the spindle stands, for what the hand cannot feel
/// is not cut; or it feels the contact again, after the tool was free. An exchange or an undo ends it.
struct HoldForce {
  bool hold = true;
};

constexpr auto fields_of(Of<HoldForce>) { return std::tuple{field("hold", &HoldForce::hold, "false: no longer")}; }

/// Whether and how material is removed.
struct SetRemoval {
  RemovalLaw removal = RemovalLaw::none;
};

constexpr auto fields_of(Of<SetRemoval>) {
  return std::tuple{field("removal", &SetRemoval::removal, "none: the spindle cuts nothing")};
}

/// Which components of the force are on: Effects::enabled.
struct SetForceMask {
  AxisMask enabled;
};

constexpr auto fields_of(Of<SetForceMask>) {
  return std::tuple{field("enabled", &SetForceMask::enabled, "from now on")};
}

/// Dry friction: see SimulationConfig::friction.
struct SetFriction {
  std::optional<DryFriction> friction;
};

constexpr auto fields_of(Of<SetFriction>) {
  return std::tuple{field("friction", &SetFriction::friction, "empty: each material's own")};
}

/// What is added to the force and what limits it.
struct SetEffects {
  Effects effects;
};

constexpr auto fields_of(Of<SetEffects>) { return std::tuple{field("effects", &SetEffects::effects, "from now on")}; }

/// Another tool for the same workpiece: see Simulation::set_tool.
struct SetTool {
  /// @param voxel_size  [m] of the workpiece that is in place when the command is obeyed; otherwise it is refused
  /// @param config      that the simulation was made with
  /// @throws Error when the head does not suit the voxels or the law
  SetTool(Tool tool, double voxel_size, const SimulationConfig& config);

  PreparedTool tool;
  VirtualCoupling::Lists lists;  ///< as long as the tool needs them, where there is a coupling
};

/// Other constants of the materials: see Simulation::set_materials. Another number of materials than the workpiece has
/// is refused.
struct SetMaterials {
  /// @param config  that the simulation was made with
  /// @throws Error when a stiffness is out of range
  SetMaterials(MaterialTable materials, const SimulationConfig& config);

  PreparedMaterials materials;
};

/// Another workpiece, with the tool for it, from a simulation that was made for it: see
/// Simulation::exchange(Simulation&). All blocks of it come, some with each tick, with another ChangedBlock::workpiece;
/// the sender, who has the workpiece, can make a picture of it at once.
struct ExchangeWorkpiece {
  /// @param prepared  with memory for undo, where it is wanted
  explicit ExchangeWorkpiece(Simulation prepared);

  std::unique_ptr<Simulation> simulation;
  VirtualCoupling::Lists lists;  ///< as long as it needs them, where there is a coupling
};

}  // namespace commands

/// A message into the loop. The place of a command, from 1, is its code in C; new ones come last.
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
