// SPDX-License-Identifier: Apache-2.0
#include "io/recording/recording_columns.hpp"

#include <cstring>
#include <type_traits>

namespace hapticut {
namespace {

/// A matrix in row-major order, as other programs expect it.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor | Eigen::DontAlign>;

/// Stored type of a scalar or a matrix.
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
template <>
struct StoredType<Mat3> {
  using type = RowMajor;
};
template <class T>
requires std::is_enum_v<T>
struct StoredType<T> {
  using type = std::underlying_type_t<T>;
};

/// Accessor from a step (const or not) to a member of one of its members.
template <class... Members>
auto at(Members... members) {
  return [=](auto& s) -> auto& { return (s.*....*members); };
}

/// Accessor from a step to a member of the object of `access`.
template <class Access, class Member>
auto member_of(Access access, Member member) {
  return [=](auto& s) -> auto& { return access(s).*member; };
}

class ColumnList {
 public:
  std::vector<Column> columns;

  /// Adds one column, or two for a pose, a velocity or a wrench.
  /// @param access  accessor from a step to the member of the column
  template <class Access>
  void add(Column::Side side, const std::string& name, const char* unit, const char* frame, const std::string& meaning,
           Access access) {
    using Member = std::remove_cvref_t<decltype(access(std::declval<RecordedStep&>()))>;
    if constexpr (std::is_same_v<Member, Pose>) {
      add(side, name + "_rotation", "1", frame, meaning + ", row by row", member_of(access, &Pose::rotation));
      add(side, name + "_translation", "m", frame, meaning, member_of(access, &Pose::translation));
    } else if constexpr (std::is_same_v<Member, Twist>) {
      add(side, name + "_linear", "m/s", frame, meaning, member_of(access, &Twist::linear));
      add(side, name + "_angular", "rad/s", frame, meaning, member_of(access, &Twist::angular));
    } else if constexpr (std::is_same_v<Member, Wrench>) {
      add(side, name + "_force", "N", frame, meaning, member_of(access, &Wrench::force));
      add(side, name + "_torque", "N m", frame, meaning, member_of(access, &Wrench::torque));
    } else {
      using Stored = typename StoredType<Member>::type;
      Column c{name, unit, frame, meaning, side};
      if constexpr (std::is_arithmetic_v<Stored>) c.kind = value_type_of<Stored>();
      if constexpr (std::is_same_v<Member, Vec3>) c.shape = {3};
      if constexpr (std::is_same_v<Member, Mat3>) c.shape = {3, 3};
      c.bytes = sizeof(Stored);
      c.numbers = c.bytes / size_of(c.kind);
      c.pack = [access](const RecordedStep& s, std::byte* row) {
        const auto stored = Stored(access(s));
        std::memcpy(row, static_cast<const void*>(&stored), sizeof stored);
      };
      c.unpack = [access](RecordedStep& s, const std::byte* row) {
        Stored stored{};
        std::memcpy(static_cast<void*>(&stored), row, sizeof stored);
        access(s) = Member(stored);
      };
      columns.push_back(std::move(c));
    }
  }

  /// Adds a column for each number of a described struct.
  /// @param prefix  prefix of their names: "energy_"
  /// @param access  accessor from a step to the struct
  template <class Access>
  void add_fields(Column::Side side, const std::string& prefix, const char* frame, Access access) {
    using Struct = std::remove_cvref_t<decltype(access(std::declval<RecordedStep&>()))>;
    for_each_field<Struct>([&](const auto& field) {
      using Type = typename std::remove_cvref_t<decltype(field)>::Type;
      if constexpr (!std::is_same_v<Type, Pose> && !std::is_same_v<Type, Twist>)
        add(side, prefix + field.name, *field.unit != '\0' ? field.unit : "1", frame, field.text,
            member_of(access, field.member));
    });
  }
};

std::vector<Column> make_columns() {
  using enum Column::Side;
  using Step = RecordedStep;
  const char *const W = "W", *const B = "B", *const none = "", *const about_z = "about +z of T";
  const char* const about_handle = "on the tool about Ho, in W";
  const char* const about_stylus = "on the stylus about its point, in B";
  ColumnList list;
  list.add(input, "number", "1", none, "number of the step since the recording began", at(&Step::number));
  list.add(input, "time", "s", none, "end of the step", at(&Step::time));
  list.add(input, "pose", "", "X_WH", "pose of the handle", at(&Step::input, &StepInput::X_WH));
  list.add(input, "velocity", "", W, "velocity of the handle at Ho", at(&Step::input, &StepInput::V_WH));
  list.add(input, "dt", "s", none, "time since the last step", at(&Step::input, &StepInput::dt));
  list.add(input, "spindle_setting", "rad/s", about_z, "set speed of the spindle", at(&Step::spindle_setting));
  list.add(input, "reserved_blocks", "1", none, "requested free blocks for cutting", at(&Step::reserved_blocks));
  list.add(input, "free_blocks", "1", none, "free blocks for cutting before the step", at(&Step::free_blocks));
  list.add(input, "hand_released", "1", none, "1: release_hand was called before the step", at(&Step::hand_released));
  list.add(input, "halted", "1", none, "1: the spindle was halted before the step", at(&Step::halted));
  list.add(input, "spindle_set", "1", none, "1: its speed was set before the step, after the last halt",
           at(&Step::spindle_set));
  list.add(input, "spindle_held", "1", none, "1: it is held at standstill", at(&Step::spindle_held));
  list.add(input, "output_path", "1", none, "OutputPath: direct, coupled, kept", at(&Step::path));
  list.add(input, "hand", "", "X_WD", "pose of the hand, with a coupling", at(&Step::hand, &HandOutput::X_WD));
  list.add(input, "coupling", "", "on the hand about its Ho, in W", "wrench of the coupling",
           at(&Step::hand, &HandOutput::wrench));
  list.add(input, "coupling_dt", "s", none, "time since the last output of the coupling",
           at(&Step::hand, &HandOutput::dt));
  list.add(result, "force", "N", about_handle, "force on the hand", at(&Step::force));
  list.add(result, "torque", "N m", about_handle, "torque on the hand", at(&Step::torque));
  list.add(result, "model", "", about_handle, "wrench of the model, before effects and limits", at(&Step::model));
  list.add(result, "removed_volume", "m^3", none, "volume removed by the step", at(&Step::removed_volume));
  list.add(result, "removed_voxels", "1", none, "number of voxels emptied by the step", at(&Step::removed_voxels));
  list.add(result, "removed_voxels_hash", "1", none, "hash of their indices and materials",
           at(&Step::removed_voxels_hash));
  list.add_fields(result, "contact_", none, at(&Step::contact));
  list.add_fields(result, "energy_", none, at(&Step::energy));
  list.add_fields(result, "spindle_", about_z, at(&Step::spindle));
  list.add(result, "sub_steps", "1", none, "number of sub-steps; 0: the input was rejected", at(&Step::sub_steps));
  list.add(result, "status", "1", none, "bits of StepStatus", at(&Step::status));
  const auto state = at(&Step::device, &DeviceTick::state);
  const auto output = at(&Step::device, &DeviceTick::output);
  list.add(device, "device", "", "X_BS", "pose of the stylus", member_of(state, &DeviceState::X_BS));
  list.add(device, "device_velocity", "", B, "velocity of the stylus at its point",
           member_of(state, &DeviceState::velocity));
  list.add_fields(device, "device_", none, state);
  list.add(device, "commanded", "", about_stylus, "commanded wrench before the step",
           member_of(output, &DeviceOutput::commanded));
  list.add(device, "applied", "", about_stylus, "applied wrench before the step",
           member_of(output, &DeviceOutput::applied));
  list.add(device, "output_limits", "1", none, "bits of OutputChange", member_of(output, &DeviceOutput::changes));
  list.add(device, "arming", "1", none, "ArmingState", at(&Step::device, &DeviceTick::arming));
  return std::move(list.columns);
}

}  // namespace

const std::vector<Column>& recording_columns() {
  static const std::vector<Column> columns = make_columns();
  return columns;
}

double number_at(const Column& column, const std::byte* row, std::size_t element) {
  return with_value_type(column.kind, [&](auto number) {
    std::memcpy(&number, row + element * sizeof number, sizeof number);
    return double(number);
  });
}

}  // namespace hapticut
