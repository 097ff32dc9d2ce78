// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "hapticut/core/mesh.hpp"
#include "hapticut/loop/commands.hpp"
#include "hapticut/loop/snapshot.hpp"
#include "hapticut/surface/surface_page.hpp"
#include "hapticut/tool/tool.hpp"

/// @file
/// The messages between the server and its page: binary WebSocket messages at `/socket`, little-endian.
///
/// Each message begins with four bytes: kind (u8), version of the protocol (u8, kProtocolVersion), two zero bytes. A
/// page that receives another version reads no further and says so. Types: u8 ... u64 unsigned, i16, i32 signed, f32,
/// f64; vec is 3 f64; pose is 12 f64, the rotation row by row and then the translation; text is UTF-8, and text16 has
/// its length before it (u16). Units are SI.
///
/// To the page:
///
///     1 hello        first message of a scene; all that was sent before is void. writer u32 (1: this page may send
///                    commands), voxel size f64 [m], X_WV pose, number of materials u32, for each: red, green, blue,
///                    length u8, name; number of guard states u32, for each: value u32, name text16, sentence text16;
///                    the bits of StepStatus in the same form
///     2 page         origin 3 i32, version u64, vertices u32, indices u32, then 12 bytes a vertex, u16 an index:
///                    see SurfacePage
///     3 snapshot     arming u32, tick u64, X_WT pose of the HEAD (not of the handle), force vec [N], torque vec [N m],
///                    removed volume f64 [m^3], dissipated energy f64 [J], contact depth f64 [m], spindle speed f64
///                    [rad/s], voxels in contact u32, status u32, status of all steps so far u32, undo marks u32, redo
///                    marks u32, flags u32 (1 undoing, 2 redoing, 4 force held), workpiece u32, blocks waiting u32,
///                    contact point vec [m] (zero without a contact)
///     4 sound        samples per second u32, number u32, samples i16, one channel
///     5 tool         X_HT pose, handle u32 (0 ray, 1 L), its length, neck [m], bend [rad], z of the tip [m] 4 f64,
///                    number of edges u32, for each: rho, z of its end, radius (0: straight, < 0: hollow) 3 f64 [m],
///                    cutting u32
///     6 controls     number u32, for each: id u16, kind u8 (Control::Kind), zero u8, value, min, max 3 f64, then
///                    panel, label, unit, choices (separated by |) 4 text16
///     7 trace        first tick u64, number u32, for each tick: force 3 f32 [N], torque 3 f32 [N m]
///     8 notice       severity u32 (Severity), length u32, text
///     9 instruments  X_WG pose of the head where the hand wants it, power f64 [W], ticks u64, missed ticks u64,
///                    width of a bucket f64 [s], number u32, ticks by lateness u32 each, number of materials u32,
///                    removed volume of each f64 [m^3]
///
/// From the page, at most kMaxCommand bytes:
///
///     1 spindle speed   f64 [rad/s], at most a million rpm
///     2 undo mark, 3 undo, 4 redo, 7 emergency stop   nothing
///     5 hold the force  u8: 1 hold, 0 release
///     6 hand            X_WH pose of the handle, within 1 km, a rotation to 1e-3; u8: 1 while the button is pressed.
///                       `hapticut view` ignores it until it has received an 8 since the last hello
///     8 look at         vec [m], each coordinate within 1 km: pages near this point come first
///     9 set a control   id u16, value f64
///     10 load           name or path, 1 ... 120 bytes without control characters
///
/// The server closes the connection with code 1008 after a message that is malformed, comes from a page that may not
/// send commands, or exceeds the rate of commands; and with code 1009 after a message longer than kMaxCommand.
namespace hapticut::view {

inline constexpr std::uint8_t kProtocolVersion = 4;
inline constexpr std::size_t kMaxCommand = 128;  ///< bytes; a page never has reason to send more

using Message = std::vector<std::uint8_t>;

// --- to the page ----------------------------------------------------------------------------------------------------

enum class MessageKind : std::uint8_t {
  hello = 1,
  page = 2,
  snapshot = 3,
  sound = 4,
  tool = 5,
  controls = 6,
  trace = 7,
  notice = 8,
  instruments = 9,
};

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

/// With the sentences of every state of the guard and of every bit of a step, for the page has no list of its own.
/// @param writer  this page may send commands
[[nodiscard]] Message encode_hello(const Scene& scene, bool writer);
[[nodiscard]] Message encode(const SurfacePage& page);
[[nodiscard]] Message encode(const LoopSnapshot& snapshot);

/// @param samples  -1 ... 1, of one channel
[[nodiscard]] Message encode_sound(std::span<const float> samples, std::uint32_t sample_rate);

/// One thing that a page can turn, as the program describes it; the page draws it.
struct Control {
  enum class Kind : std::uint8_t { number = 0, on_off = 1, choice = 2, button = 3 };

  std::uint16_t id = 0;  ///< names it in SetControl
  Kind kind = Kind::number;
  double value = 0;          ///< of a switch 0 or 1, of a choice its number, of a button 1: it can be pressed
  double min = 0, max = 1;   ///< what is accepted
  std::string panel, label;  ///< where it stands, what it is called
  std::string unit;
  std::string choices = {};  ///< names with | between them
};

/// Force and torque of a tick, for curves.
struct TraceSample {
  std::array<float, 3> force;   ///< [N]
  std::array<float, 3> torque;  ///< [N·m]
};

/// What a notice is about.
enum class Severity : std::uint32_t { tells = 0, warns = 1, failed = 2 };

/// What a page shows beside the scene.
struct Instruments {
  Pose X_WG;                             ///< the head where the hand wants it
  double power = 0;                      ///< [W] of the tool
  std::uint64_t ticks = 0, missed = 0;   ///< since the loop began; ticks that came more than a period late
  double bucket = 0;                     ///< [s] width of the buckets below
  std::vector<std::uint32_t> latency{};  ///< ticks by how late they were, the last bucket with all that were later
  std::vector<double> removed{};         ///< [m^3] by material from 1
};

[[nodiscard]] Message encode(const Tool& tool);
[[nodiscard]] Message encode(std::span<const Control> controls);
[[nodiscard]] Message encode(const Instruments& instruments);
[[nodiscard]] Message encode_notice(Severity severity, std::string_view text);

/// @param first  tick of the first sample
[[nodiscard]] Message encode_trace(std::uint64_t first, std::span<const TraceSample> samples);

// --- from the page --------------------------------------------------------------------------------------------------

inline constexpr Range kPlaces = Range::between(-1e3, 1e3);  ///< [m] of a point that a page may name

/// Where the pointer wants the hand.
struct MoveHand {
  Pose X_WH;
  bool pressed = false;
};

constexpr auto fields_of(Of<MoveHand>) {
  return std::tuple{field("X_WH", &MoveHand::X_WH, "of the handle"),
                    field("pressed", &MoveHand::pressed, "the button")};
}

/// The emergency stop.
struct Stop {};

constexpr auto fields_of(Of<Stop>) { return std::tuple{}; }

struct LookAt {
  Vec3 p_WQ = Vec3::Zero();
};

constexpr auto fields_of(Of<LookAt>) { return std::tuple{field("p_WQ", &LookAt::p_WQ, "m", kPlaces, "in W")}; }

/// Turns what `Control::id` names. Whether there is such a one, and whether the value is within its range, knows who
/// described it.
struct SetControl {
  std::uint16_t id = 0;
  double value = 0;
};

constexpr auto fields_of(Of<SetControl>) {
  return std::tuple{field("id", &SetControl::id, "1", "of a control"),
                    field("value", &SetControl::value, "1", "in the control's unit")};
}

/// Another scene, by its name or the path of a file.
struct Load {
  std::string name;  ///< UTF-8 without control characters, at most kMaxName bytes
};
inline constexpr std::size_t kMaxName = 120;

constexpr auto fields_of(Of<Load>) { return std::tuple{field("name", &Load::name, "of a scene, or a file's path")}; }

/// Said by the server itself: the writer has gone. A hand without a device must stop, and a real one be faded out.
struct WriterLeft {};

/// The place of a command, from 1, is its kind, and its fields are what follows; what has no fields_of is no command of
/// a page. A new one stands before WriterLeft, which comes last, for no page sends it. It raises kProtocolVersion, here
/// and in web/src/protocol.ts: a server closes its door to a page that sends what it does not know.
using ViewCommand = std::variant<commands::SetSpindleSpeed, commands::SetUndoMark, commands::Undo, commands::Redo,
                                 commands::HoldForce, MoveHand, Stop, LookAt, SetControl, Load, WriterLeft>;

/// @return nothing when the message is not one of these in every byte: another version or length, a number that is not
///         finite, a matrix that is no rotation, a value that has no meaning
[[nodiscard]] std::optional<ViewCommand> decode_command(std::span<const std::uint8_t> message);

}  // namespace hapticut::view
