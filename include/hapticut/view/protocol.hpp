// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/force/effects/axis_mask.hpp"
#include "hapticut/loop/commands.hpp"
#include "hapticut/loop/snapshot.hpp"
#include "hapticut/surface/surface_page.hpp"

/// @file
/// What the server of the page and the page say to each other: binary messages, little-endian, each with a head of four
/// bytes: its kind, the version of the protocol, and two that are 0. docs/view.md has the tables.
namespace hapticut::view {

inline constexpr std::uint8_t kProtocolVersion = 1;
inline constexpr std::size_t kLongestCommand = 128;  ///< bytes; a page never has reason to send more

using Message = std::vector<std::uint8_t>;

// --- to the page
// ------------------------------------------------------------------------------------------------------

enum class MessageKind : std::uint8_t { hello = 1, page = 2, snapshot = 3, sound = 4 };

/// What a material is called and how it is shown.
struct ShownMaterial {
  std::string name;
  Color color;
};

/// What a page must know before anything else.
struct Scene {
  GridFrame frame;                       ///< of the pages
  std::vector<ShownMaterial> materials;  ///< by id from 1
};

/// @param writer  this page may send commands
[[nodiscard]] Message encode_hello(const Scene& scene, bool writer);
[[nodiscard]] Message encode(const SurfacePage& page);
[[nodiscard]] Message encode(const LoopSnapshot& snapshot);

/// @param samples  -1 ... 1, of one channel
[[nodiscard]] Message encode_sound(std::span<const float> samples, std::uint32_t sample_rate);

// --- from the page
// ----------------------------------------------------------------------------------------------------

enum class CommandKind : std::uint8_t {
  set_spindle_speed = 1,
  set_undo_mark = 2,
  undo = 3,
  redo = 4,
  hold_force = 5,
  set_removal = 6,
  set_force_mask = 7,
  move_hand = 8,
  stop = 9,
  look_at = 10,
};

/// Where the pointer wants the hand.
struct MoveHand {
  Pose X_WH;
  bool pressed = false;
};

/// The emergency stop.
struct Stop {};

struct LookAt {
  Vec3 p_WQ = Vec3::Zero();  ///< [m]
};

/// Said by the server itself: the writer has gone. A hand without a device must stop, and a real one be faded out.
struct WriterLeft {};

using ViewCommand =
    std::variant<commands::SetSpindleSpeed, commands::SetUndoMark, commands::Undo, commands::Redo, commands::HoldForce,
                 commands::SetRemoval, commands::SetForceMask, MoveHand, Stop, LookAt, WriterLeft>;

/// @return nothing when the message is not one of these in every byte: another version or length, a number that is not
///         finite, a matrix that is no rotation, a value that has no meaning
[[nodiscard]] std::optional<ViewCommand> decode_command(std::span<const std::uint8_t> message);

}  // namespace hapticut::view
