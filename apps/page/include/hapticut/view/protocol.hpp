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
///     6 controls     number u32, for each: id u16, kind u8 (Control::Kind), zero u8, value, min, max, low, typical,
///                    high 6 f64, then panel, label, unit, choices (separated by |), idle, source 6 text16
///     7 trace        first tick u64, number u32, for each tick: force 3 f32 [N], torque 3 f32 [N m]
///     8 notice       severity u32 (Severity), length u32, text
///     9 instruments  X_WG pose of the head where the hand wants it, power f64 [W], ticks u64, missed ticks u64,
///                    width of a bucket f64 [s], number u32, ticks by lateness u32 each, number of materials u32,
///                    removed volume of each f64 [m^3], number of materials u32, force on each f64 [N], material under
///                    the tip u32 (0: none)
///     10 heat        X_WC pose of the cells (origin in the centre of the first one), width of a cell f64 [m], cells
///                    along x, y, z 3 u32 (0: heat is off), temperature of byte 1, of a step between bytes, of the
///                    body, of the threshold 4 f64 [deg C], number of materials u32, for each: maximum now, peak 2 f64
///                    [deg C], time above the threshold f64 [s]; then a byte for each cell, x fastest (0: no material)
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

inline constexpr std::uint8_t kProtocolVersion = 6;
inline constexpr std::size_t kMaxCommand = 128;  ///< [bytes] maximum length of a message from a page

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
  heat = 10,
};

/// Name and colour of a material.
struct ShownMaterial {
  std::string name;
  Color color;
};

/// The first information for a page.
struct Scene {
  GridFrame frame;                       ///< grid of the surface's pages
  std::vector<ShownMaterial> materials;  ///< by id from 1
};

/// Encodes the greeting: the scene, and the sentences for all states of the guard and all bits of StepStatus.
/// @param writer  whether this page may send commands
[[nodiscard]] Message encode_hello(const Scene& scene, bool writer);
[[nodiscard]] Message encode(const SurfacePage& page);
[[nodiscard]] Message encode(const LoopSnapshot& snapshot);

/// @param samples  -1 ... 1, of one channel
[[nodiscard]] Message encode_sound(std::span<const float> samples, std::uint32_t sample_rate);

/// A control of a page. The program describes it, and the page draws it.
struct Control {
  enum class Kind : std::uint8_t { number = 0, on_off = 1, choice = 2, button = 3 };

  std::uint16_t id = 0;  ///< identifies the control in SetControl
  Kind kind = Kind::number;
  double value = 0;          ///< on_off: 0 or 1; choice: its number; button: 1 if it can be pressed
  double min = 0, max = 1;   ///< accepted values
  std::string panel, label;  ///< panel that shows it, and its label
  std::string unit;
  std::string choices = {};               ///< names, separated by |
  std::string idle = {};                  ///< why it does nothing at present; empty: it acts
  double low = 0, typical = 0, high = 0;  ///< known range and usual value, if there is a source
  std::string source = {};                ///< who measured them; empty: nothing is known
};

/// Force and torque of a tick, for the curves.
struct TraceSample {
  std::array<float, 3> force;   ///< [N]
  std::array<float, 3> torque;  ///< [N·m]
};

/// How severe a notice is.
enum class Severity : std::uint32_t { info = 0, warning = 1, error = 2 };

/// Values that a page shows beside the scene.
struct Instruments {
  Pose X_WG;                             ///< pose of the head at the set point of the hand
  double power = 0;                      ///< [W] power of the tool
  std::uint64_t ticks = 0, missed = 0;   ///< since the loop began; `missed`: ticks that were more than a period late
  double bucket = 0;                     ///< [s] width of the buckets of `latency`
  std::vector<std::uint32_t> latency{};  ///< number of ticks by lateness; the last bucket has all later ones
  std::vector<double> removed{};         ///< [m^3] by material id from 1
  std::vector<double> forces{};  ///< [N] normal force on the head by material id from 1; 0 while it cuts nothing
  MaterialId under = kEmpty;     ///< material at the tip, or the next one along the axis of the tool
};

/// Temperatures of the workpiece in cells, for its colours.
struct Heat {
  /// Effect on one material.
  struct Structure {
    double now = 0, peak = 0;  ///< [deg C] maximum now, and so far
    double time_above = 0;     ///< [s] time above the threshold
  };
  Pose X_WC;                            ///< pose of the cells; the origin is in the centre of the first one
  double cell_size = 0;                 ///< [m]
  std::array<std::uint32_t, 3> dims{};  ///< cells along x, y, z; 0: there is no heat to show
  double first = 0, step = 0;           ///< [deg C] temperature of byte 1, and between two bytes
  double body = 37, threshold = 47;     ///< [deg C] temperature at the beginning, and that of the line
  std::vector<Structure> structures{};  ///< by material id from 1
  std::vector<std::uint8_t> cells{};    ///< temperatures, x fastest; 0: no material
};

[[nodiscard]] Message encode(const Tool& tool);
[[nodiscard]] Message encode(std::span<const Control> controls);
[[nodiscard]] Message encode(const Instruments& instruments);
[[nodiscard]] Message encode(const Heat& heat);
[[nodiscard]] Message encode_notice(Severity severity, std::string_view text);

/// @param first  tick of the first sample
[[nodiscard]] Message encode_trace(std::uint64_t first, std::span<const TraceSample> samples);

// --- from the page --------------------------------------------------------------------------------------------------

inline constexpr Range kPlaces = Range::between(-1e3, 1e3);  ///< [m] accepted coordinates of points

/// Moves the set point of the hand to the pointer.
struct MoveHand {
  Pose X_WH;             ///< pose of the handle
  bool pressed = false;  ///< whether the button is pressed
};

constexpr auto fields_of(Of<MoveHand>) {
  return std::tuple{field("X_WH", &MoveHand::X_WH, "pose of the handle"),
                    field("pressed", &MoveHand::pressed, "whether the button is pressed")};
}

/// Triggers the emergency stop.
struct Stop {};

constexpr auto fields_of(Of<Stop>) { return std::tuple{}; }

/// Sets the point that the user looks at; pages of the surface near it come first.
struct LookAt {
  Vec3 p_WQ = Vec3::Zero();  ///< [m] the point looked at, in W
};

constexpr auto fields_of(Of<LookAt>) {
  return std::tuple{field("p_WQ", &LookAt::p_WQ, "m", kPlaces, "the point looked at, in W")};
}

/// Sets the value of a control. The program that described the control checks the id and the range.
struct SetControl {
  std::uint16_t id = 0;  ///< [1] Control::id
  double value = 0;      ///< [1] the new value, in the control's unit
};

constexpr auto fields_of(Of<SetControl>) {
  return std::tuple{field("id", &SetControl::id, "1", "Control::id"),
                    field("value", &SetControl::value, "1", "the new value, in the control's unit")};
}

/// Loads another scene, by its name or the path of a file.
struct Load {
  std::string name;  ///< name of a scene, or path of a file: UTF-8 without control characters, at most kMaxName bytes
};
inline constexpr std::size_t kMaxName = 120;

constexpr auto fields_of(Of<Load>) {
  return std::tuple{
      field("name", &Load::name,
            "name of a scene, or path of a file: UTF-8 without control characters, at most kMaxName bytes")};
}

/// Sent by the server, not by a page: the page that could send commands has disconnected. A simulated hand must stop,
/// and the force of a real device must fade out.
struct WriterLeft {};

/// All commands. The position of a command in this list, from 1, is its kind, and its fields follow in the message. A
/// struct without fields_of cannot come from a page. Add new commands before WriterLeft, and raise kProtocolVersion
/// here and in apps/page/web/src/protocol.ts, because the server disconnects a page that sends unknown commands.
using ViewCommand = std::variant<commands::SetSpindleSpeed, commands::SetUndoMark, commands::Undo, commands::Redo,
                                 commands::HoldForce, MoveHand, Stop, LookAt, SetControl, Load, WriterLeft>;

/// Decodes a command.
/// @return nothing when any byte of the message is invalid: another version or length, a number that is not finite, a
///         matrix that is not a rotation, a value without a meaning
[[nodiscard]] std::optional<ViewCommand> decode_command(std::span<const std::uint8_t> message);

}  // namespace hapticut::view
