// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_columns.hpp"

namespace hapticut {
namespace {

template <class T>
constexpr ColumnKind kind_of() {
  if constexpr (std::is_same_v<T, double>) return ColumnKind::real;
  if constexpr (std::is_same_v<T, std::uint8_t>) return ColumnKind::flag;
  if constexpr (std::is_same_v<T, std::int32_t>) return ColumnKind::int32;
  if constexpr (std::is_same_v<T, std::uint32_t>) return ColumnKind::uint32;
  if constexpr (std::is_same_v<T, std::uint64_t>) return ColumnKind::uint64;
}

/// A matrix row by row, as all programs but Eigen expect.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor | Eigen::DontAlign>;

/// The number that a scalar is stored as.
template <class T>
struct StoredType {
  using type = T;
};
template <>
struct StoredType<bool> {
  using type = std::uint8_t;
};
template <>
struct StoredType<int> {
  using type = std::int32_t;
};
template <class T>
requires std::is_enum_v<T>
struct StoredType<T> {
  using type = std::underlying_type_t<T>;
};

/// @param access  from a step to the member that the column holds
template <class Access>
Column column(Column::Side side, const char* name, const char* unit, const char* frame, const char* meaning,
              Access access) {
  using Member = std::remove_cvref_t<decltype(access(std::declval<RecordedStep&>()))>;
  Column c{name, unit, frame, meaning, side};
  if constexpr (std::is_same_v<Member, Vec3>) {
    c.shape = {3};
    c.numbers = 3;
    c.pack = [access](const RecordedStep& s, std::byte* row) { std::memcpy(row, access(s).data(), sizeof(Vec3)); };
    c.unpack = [access](RecordedStep& s, const std::byte* row) { std::memcpy(access(s).data(), row, sizeof(Vec3)); };
  } else if constexpr (std::is_same_v<Member, Mat3>) {
    c.shape = {3, 3};
    c.numbers = 9;
    c.pack = [access](const RecordedStep& s, std::byte* row) {
      const RowMajor rows = access(s);
      std::memcpy(row, rows.data(), sizeof(RowMajor));
    };
    c.unpack = [access](RecordedStep& s, const std::byte* row) {
      RowMajor rows = RowMajor::Zero();
      std::memcpy(rows.data(), row, sizeof(RowMajor));
      access(s) = rows;
    };
  } else {
    using Stored = typename StoredType<Member>::type;
    c.kind = kind_of<Stored>();
    c.bytes = sizeof(Stored);
    c.pack = [access](const RecordedStep& s, std::byte* row) {
      const auto number = Stored(access(s));
      std::memcpy(row, &number, sizeof number);
    };
    c.unpack = [access](RecordedStep& s, const std::byte* row) {
      Stored number;
      std::memcpy(&number, row, sizeof number);
      access(s) = Member(number);
    };
  }
  if (c.bytes == 0) c.bytes = c.numbers * sizeof(double);
  return c;
}

// The member of a step, for reading and for writing.
// NOLINTBEGIN(bugprone-macro-parentheses): the path to a member cannot stand in parentheses
#define HAPTICUT_MEMBER(path) \
  [](auto& s) -> auto& { return s.path; }
// NOLINTEND(bugprone-macro-parentheses)

/// A column for each field of a struct that describes itself.
/// @param prefix  in front of their names: "energy_"
/// @param access  from a step to the struct
template <class Access>
std::vector<Column> columns_of(Column::Side side, const std::string& prefix, const char* frame, Access access) {
  using Struct = std::remove_cvref_t<decltype(access(std::declval<RecordedStep&>()))>;
  std::vector<Column> columns;
  for_each_field<Struct>([&](const auto& field) {
    const auto member = field.member;
    columns.push_back(column(
        side, (prefix + field.name).c_str(), field.unit, frame, field.text,
        [ access, member ](auto& s) -> auto& { return access(s).*member; }));
  });
  return columns;
}

std::vector<Column> make_columns() {
  using enum Column::Side;
  const char *const W = "W", *const B = "B", *const none = "";
  const char* const about_handle = "on the tool about Ho, in W";
  const char* const about_stylus = "on the stylus about its point, in B";
  const std::vector<Column> contact = columns_of(result, "contact_", none, HAPTICUT_MEMBER(contact)),
                            energy = columns_of(result, "energy_", none, HAPTICUT_MEMBER(energy)),
                            spindle = columns_of(result, "spindle_", "about +z of T", HAPTICUT_MEMBER(spindle));
  std::vector<Column> columns = {
      column(input, "number", "1", none, "steps since the recording began", HAPTICUT_MEMBER(number)),
      column(input, "time", "s", none, "at the end of the step", HAPTICUT_MEMBER(time)),
      column(input, "pose_rotation", "1", "X_WH", "of the handle, row by row", HAPTICUT_MEMBER(input.pose.rotation)),
      column(input, "pose_translation", "m", "X_WH", "of the handle", HAPTICUT_MEMBER(input.pose.translation)),
      column(input, "velocity_linear", "m/s", W, "of Ho", HAPTICUT_MEMBER(input.velocity.linear)),
      column(input, "velocity_angular", "rad/s", W, "of the handle", HAPTICUT_MEMBER(input.velocity.angular)),
      column(input, "dt", "s", none, "since the last step", HAPTICUT_MEMBER(input.dt)),
      column(input, "spindle_setting", "rad/s", "about +z of T", "asked of the spindle",
             HAPTICUT_MEMBER(spindle_setting)),
      column(input, "reserved_blocks", "1", none, "blocks for cutting that were asked for",
             HAPTICUT_MEMBER(reserved_blocks)),
      column(input, "free_blocks", "1", none, "blocks for cutting left before the step", HAPTICUT_MEMBER(free_blocks)),
      column(input, "let_go", "1", none, "1: the hand had let go before the step", HAPTICUT_MEMBER(let_go)),
      column(input, "halted", "1", none, "1: the spindle had been halted before the step", HAPTICUT_MEMBER(halted)),
      column(input, "output_path", "1", none, "OutputPath: direct, coupled, kept", HAPTICUT_MEMBER(path)),
      column(input, "hand_rotation", "1", "X_WD", "of the hand behind a coupling, row by row",
             HAPTICUT_MEMBER(hand.X_WD.rotation)),
      column(input, "hand_translation", "m", "X_WD", "of the hand behind a coupling",
             HAPTICUT_MEMBER(hand.X_WD.translation)),
      column(input, "coupling_force", "N", "on the hand about its Ho, in W", "of the coupling",
             HAPTICUT_MEMBER(hand.wrench.force)),
      column(input, "coupling_torque", "N m", "on the hand about its Ho, in W", "of the coupling",
             HAPTICUT_MEMBER(hand.wrench.torque)),
      column(input, "coupling_dt", "s", none, "since the coupling last gave something", HAPTICUT_MEMBER(hand.dt)),
      column(result, "force", "N", about_handle, "what the hand feels", HAPTICUT_MEMBER(force)),
      column(result, "torque", "N m", about_handle, "what the hand feels", HAPTICUT_MEMBER(torque)),
      column(result, "model_force", "N", about_handle, "before effects and limits", HAPTICUT_MEMBER(model.force)),
      column(result, "model_torque", "N m", about_handle, "before effects and limits", HAPTICUT_MEMBER(model.torque)),
      column(result, "removed_volume", "m^3", none, "taken away by the step", HAPTICUT_MEMBER(removed_volume)),
      column(result, "removed_voxels", "1", none, "emptied by the step", HAPTICUT_MEMBER(removed_voxels)),
      column(result, "removed_voxels_hash", "1", none, "of their indices and materials",
             HAPTICUT_MEMBER(removed_voxels_hash)),
  };
  for (const auto& part : {contact, energy, spindle}) columns.insert(columns.end(), part.begin(), part.end());
  const std::vector<Column> others = {
      column(result, "sub_steps", "1", none, "0: the input was rejected", HAPTICUT_MEMBER(sub_steps)),
      column(result, "status", "1", none, "bits of StepStatus", HAPTICUT_MEMBER(status)),
      column(device, "device_rotation", "1", "X_BS", "of the stylus, row by row",
             HAPTICUT_MEMBER(device.state.X_BS.rotation)),
      column(device, "device_translation", "m", "X_BS", "of the stylus",
             HAPTICUT_MEMBER(device.state.X_BS.translation)),
      column(device, "device_velocity_linear", "m/s", B, "of the stylus point",
             HAPTICUT_MEMBER(device.state.velocity.linear)),
      column(device, "device_velocity_angular", "rad/s", B, "of the stylus",
             HAPTICUT_MEMBER(device.state.velocity.angular)),
      column(device, "device_buttons", "1", none, "bit n: button n", HAPTICUT_MEMBER(device.state.buttons)),
      column(device, "device_time", "s", none, "of the device's clock", HAPTICUT_MEMBER(device.state.time)),
      column(device, "device_sequence", "1", none, "of the reading", HAPTICUT_MEMBER(device.state.sequence)),
      column(device, "device_epoch", "1", none, "of the calibration", HAPTICUT_MEMBER(device.state.epoch)),
      column(device, "device_temperature", "1", none, "of the hottest motor",
             HAPTICUT_MEMBER(device.state.temperature)),
      column(device, "device_valid", "1", none, "0: the pose means nothing", HAPTICUT_MEMBER(device.state.valid)),
      column(device, "device_fault", "1", none, "DeviceFault", HAPTICUT_MEMBER(device.state.fault)),
      column(device, "commanded_force", "N", about_stylus, "until the step",
             HAPTICUT_MEMBER(device.output.commanded.force)),
      column(device, "commanded_torque", "N m", about_stylus, "until the step",
             HAPTICUT_MEMBER(device.output.commanded.torque)),
      column(device, "applied_force", "N", about_stylus, "until the step",
             HAPTICUT_MEMBER(device.output.applied.force)),
      column(device, "applied_torque", "N m", about_stylus, "until the step",
             HAPTICUT_MEMBER(device.output.applied.torque)),
      column(device, "output_limits", "1", none, "bits of OutputChange", HAPTICUT_MEMBER(device.output.changes)),
      column(device, "arming", "1", none, "ArmingState", HAPTICUT_MEMBER(device.arming)),
  };
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

#undef HAPTICUT_MEMBER

template <class Number>
double number_in(const std::byte* row, std::size_t element) {
  Number number;
  std::memcpy(&number, row + element * sizeof number, sizeof number);
  return double(number);
}

}  // namespace

const std::vector<Column>& recording_columns() {
  static const std::vector<Column> columns = make_columns();
  return columns;
}

double number_at(const Column& column, const std::byte* row, std::size_t element) {
  switch (column.kind) {
    case ColumnKind::flag:
      return number_in<std::uint8_t>(row, element);
    case ColumnKind::int32:
      return number_in<std::int32_t>(row, element);
    case ColumnKind::uint32:
      return number_in<std::uint32_t>(row, element);
    case ColumnKind::uint64:
      return number_in<std::uint64_t>(row, element);
    case ColumnKind::real:
      break;
  }
  return number_in<double>(row, element);
}

}  // namespace hapticut
