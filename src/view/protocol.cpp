// SPDX-License-Identifier: Apache-2.0
#include "hapticut/view/protocol.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hapticut::view {
namespace {

static_assert(std::endian::native == std::endian::little, "vertices and indices are sent as they lie in memory");

constexpr double kFarthest = 1e3;            // [m] of a point that a page may name
constexpr double kRotationTolerance = 1e-3;  // of a matrix in single precision

class Writer {
 public:
  explicit Writer(MessageKind kind) { message_ = {std::uint8_t(kind), kProtocolVersion, 0, 0}; }

  template <class Number>
  Writer& add(Number number) {
    static_assert(std::is_arithmetic_v<Number>);
    return add_bytes(&number, sizeof number);
  }
  Writer& add(const Vec3& v) { return add(v.x()).add(v.y()).add(v.z()); }
  Writer& add(const Pose& pose) {
    for (int row = 0; row < 3; ++row) add(Vec3(pose.rotation.row(row)));
    return add(pose.translation);
  }
  Writer& add_bytes(const void* bytes, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    message_.insert(message_.end(), first, first + count);
    return *this;
  }
  /// With its length before it, of 16 bits.
  Writer& add_text(std::string_view text) {
    const auto length = std::uint16_t(std::min<std::size_t>(text.size(), 65535));
    return add(length).add_bytes(text.data(), length);
  }
  void reserve(std::size_t bytes) { message_.reserve(bytes); }
  [[nodiscard]] Message take() { return std::move(message_); }

 private:
  Message message_;
};

/// Value, name and sentence of each that has one.
template <NamedEnum E>
void add_sentences(Writer& message) {
  const auto all = names_of(Of<E>{});
  const auto has = [](const Named<E>& one) { return one.words != nullptr; };
  message.add(std::uint32_t(std::ranges::count_if(all, has)));
  for (const Named<E>& one : all)
    if (has(one)) message.add(std::uint32_t(one.value)).add_text(one.name).add_text(one.words);
}

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// 0 where the message has ended, which `is_complete` then denies.
  template <class Number>
  Number take() {
    Number number = 0;
    if (bytes_.size() - at_ < sizeof number) {
      failed_ = true;
      return number;
    }
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }
  double take_number() {
    const auto number = take<double>();
    failed_ = failed_ || !std::isfinite(number);
    return number;
  }
  bool take_bool() {
    const auto byte = take<std::uint8_t>();
    failed_ = failed_ || byte > 1;
    return byte == 1;
  }
  Vec3 take_point() {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = take_number();
    failed_ = failed_ || !(point.cwiseAbs().maxCoeff() <= kFarthest);
    return point;
  }
  Pose take_pose() {
    Pose pose;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) pose.rotation(row, column) = take_number();
    pose.translation = take_point();
    const Mat3 excess = pose.rotation * pose.rotation.transpose() - Mat3::Identity();
    failed_ = failed_ || !(excess.cwiseAbs().maxCoeff() < kRotationTolerance) || !(pose.rotation.determinant() > 0);
    return pose;
  }
  /// All that is left, as text.
  std::string take_text(std::size_t most) {
    const std::span<const std::uint8_t> rest = bytes_.subspan(at_);
    at_ = bytes_.size();
    const auto is_control = [](std::uint8_t byte) { return byte < 0x20 || byte == 0x7f; };
    refuse_if(rest.empty() || rest.size() > most || std::any_of(rest.begin(), rest.end(), is_control));
    return {rest.begin(), rest.end()};
  }
  void refuse_if(bool wrong) { failed_ = failed_ || wrong; }

  [[nodiscard]] bool is_complete() const { return !failed_ && at_ == bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

std::optional<ViewCommand> payload_of(CommandKind kind, Reader& reader) {
  switch (kind) {
    case CommandKind::set_spindle_speed: {
      const double speed = reader.take_number();
      reader.refuse_if(std::abs(speed) > kFastestSpindle);
      return commands::SetSpindleSpeed{speed * units::rad_per_s};
    }
    case CommandKind::set_undo_mark:
      return commands::SetUndoMark{};
    case CommandKind::undo:
      return commands::Undo{};
    case CommandKind::redo:
      return commands::Redo{};
    case CommandKind::hold_force:
      return commands::HoldForce{reader.take_bool()};
    case CommandKind::move_hand: {
      MoveHand command;
      command.X_WH = reader.take_pose();
      command.pressed = reader.take_bool();
      return command;
    }
    case CommandKind::stop:
      return Stop{};
    case CommandKind::look_at:
      return LookAt{reader.take_point()};
    case CommandKind::set_control: {
      const auto id = reader.take<std::uint16_t>();
      reader.refuse_if(reader.take<std::uint16_t>() != 0);
      return SetControl{id, reader.take_number()};
    }
    case CommandKind::load:
      return Load{reader.take_text(kLongestName)};
  }
  return std::nullopt;
}

}  // namespace

Message encode_hello(const Scene& scene, bool writer) {
  Writer message(MessageKind::hello);
  message.add(std::uint32_t(writer ? 1 : 0)).add(scene.frame.voxel_size).add(scene.frame.X_WV);
  message.add(std::uint32_t(scene.materials.size()));
  for (const ShownMaterial& material : scene.materials) {
    const auto length = std::uint8_t(std::min<std::size_t>(material.name.size(), 255));
    message.add(material.color.red).add(material.color.green).add(material.color.blue).add(length);
    message.add_bytes(material.name.data(), length);
  }
  add_sentences<ArmingState>(message);
  add_sentences<StepStatus>(message);
  return message.take();
}

Message encode(const SurfacePage& page) {
  Writer message(MessageKind::page);
  message.reserve(32 + sizeof(SurfaceVertex) * page.vertices.size() + 2 * page.indices.size());
  for (const int index : page.origin) message.add(std::int32_t(index));
  message.add(page.version).add(std::uint32_t(page.vertices.size())).add(std::uint32_t(page.indices.size()));
  message.add_bytes(page.vertices.data(), sizeof(SurfaceVertex) * page.vertices.size());
  message.add_bytes(page.indices.data(), 2 * page.indices.size());
  return message.take();
}

Message encode(const LoopSnapshot& snapshot) {
  const ToolSnapshot& tool = snapshot.tool;
  Writer message(MessageKind::snapshot);
  const std::uint32_t flags = (tool.undoing ? 1U : 0U) | (tool.redoing ? 2U : 0U) | (tool.force_held ? 4U : 0U);
  message.add(std::uint32_t(snapshot.arming)).add(snapshot.tick).add(snapshot.X_WT).add(tool.force).add(tool.torque);
  message.add(tool.removed_volume).add(tool.dissipated).add(tool.contact_depth).add(tool.spindle_speed);
  message.add(std::uint32_t(tool.contact_voxels)).add(std::uint32_t(tool.status)).add(std::uint32_t(tool.seen));
  message.add(std::uint32_t(tool.undo_marks)).add(std::uint32_t(tool.redo_marks)).add(flags);
  message.add(tool.workpiece).add(std::uint32_t(snapshot.blocks_waiting)).add(tool.contact_point);
  return message.take();
}

Message encode_sound(std::span<const float> samples, std::uint32_t sample_rate) {
  Writer message(MessageKind::sound);
  message.reserve(12 + 2 * samples.size());
  message.add(sample_rate).add(std::uint32_t(samples.size()));
  for (const float sample : samples)
    message.add(std::int16_t(std::lround(32767.0F * std::clamp(std::isfinite(sample) ? sample : 0.0F, -1.0F, 1.0F))));
  return message.take();
}

Message encode(const Tool& tool) {
  Writer message(MessageKind::tool);
  const auto* bent = std::get_if<LHandle>(&tool.handle());
  message.add(tool.X_HT()).add(std::uint32_t(bent != nullptr ? 1 : 0));
  message.add(bent != nullptr ? bent->length : std::get<RayHandle>(tool.handle()).length);
  message.add(bent != nullptr ? bent->neck : 0.0).add(bent != nullptr ? bent->bend : 0.0);
  const Profile profile = tool.head().profile();
  message.add(profile.tip).add(std::uint32_t(profile.edges.size()));
  for (const ProfileEdge& edge : profile.edges)
    message.add(edge.rho).add(edge.z).add(edge.radius).add(std::uint32_t(edge.kind == EdgeKind::cutting ? 1 : 0));
  return message.take();
}

Message encode(std::span<const Control> controls) {
  Writer message(MessageKind::controls);
  message.add(std::uint32_t(controls.size()));
  for (const Control& control : controls) {
    message.add(control.id).add(std::uint8_t(control.kind)).add(std::uint8_t(0));
    message.add(control.value).add(control.min).add(control.max);
    message.add_text(control.panel).add_text(control.label).add_text(control.unit).add_text(control.choices);
  }
  return message.take();
}

Message encode(const Instruments& instruments) {
  Writer message(MessageKind::instruments);
  message.add(instruments.X_WG).add(instruments.power).add(instruments.ticks).add(instruments.missed);
  message.add(instruments.bucket).add(std::uint32_t(instruments.latency.size()));
  for (const std::uint32_t ticks : instruments.latency) message.add(ticks);
  message.add(std::uint32_t(instruments.removed.size()));
  for (const double volume : instruments.removed) message.add(volume);
  return message.take();
}

Message encode_notice(Severity severity, std::string_view text) {
  Writer message(MessageKind::notice);
  return message.add(std::uint32_t(severity))
      .add(std::uint32_t(text.size()))
      .add_bytes(text.data(), text.size())
      .take();
}

Message encode_trace(std::uint64_t first, std::span<const TraceSample> samples) {
  static_assert(sizeof(TraceSample) == 24);
  Writer message(MessageKind::trace);
  message.add(first).add(std::uint32_t(samples.size())).add_bytes(samples.data(), samples.size_bytes());
  return message.take();
}

std::optional<ViewCommand> decode_command(std::span<const std::uint8_t> message) {
  Reader reader(message);
  const auto kind = CommandKind(reader.take<std::uint8_t>());
  reader.refuse_if(reader.take<std::uint8_t>() != kProtocolVersion);
  reader.refuse_if(reader.take<std::uint16_t>() != 0);
  std::optional<ViewCommand> command = payload_of(kind, reader);
  if (!reader.is_complete()) command.reset();
  return command;
}

}  // namespace hapticut::view
