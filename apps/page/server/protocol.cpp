// SPDX-License-Identifier: Apache-2.0
#include "hapticut/view/protocol.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hapticut::view {
namespace {

static_assert(std::endian::native == std::endian::little, "vertices and indices are sent as they are stored");

constexpr double kRotationTolerance = 1e-3;  // allowed error of a matrix in single precision

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
  /// Adds a text after its length of 16 bits.
  Writer& add_text(std::string_view text) {
    const auto length = std::uint16_t(std::min<std::size_t>(text.size(), 65535));
    return add(length).add_bytes(text.data(), length);
  }
  void reserve(std::size_t bytes) { message_.reserve(bytes); }
  [[nodiscard]] Message finish() { return std::move(message_); }

 private:
  Message message_;
};

/// Adds value, name and sentence of each enumerator that has a sentence.
template <NamedEnum E>
void add_sentences(Writer& message) {
  const auto all = names_of(Of<E>{});
  const auto has = [](const Named<E>& one) { return one.words != nullptr; };
  message.add(std::uint32_t(std::ranges::count_if(all, has)));
  for (const Named<E>& one : all)
    if (has(one)) message.add(std::uint32_t(one.value)).add_text(one.name).add_text(one.words);
}

/// Length of the character that a text begins with; 0 when it is not UTF-8 or is a control character.
std::size_t character_length(std::span<const std::uint8_t> text) {
  const std::uint8_t first = text[0];
  if (first < 0x80) return first < 0x20 || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = first & (0x7fU >> length);
  for (const std::uint8_t next : text.subspan(1, length - 1)) {
    if ((next & 0xc0U) != 0x80U) return 0;
    code = code << 6U | (next & 0x3fU);
  }
  constexpr std::uint32_t kFirstOfLength[] = {0xa0, 0x800, 0x10000};  // 0x80 ... 0x9f are control characters
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code >= kFirstOfLength[length - 2] && code <= 0x10ffff && !surrogate ? length : 0;
}

bool is_printable_utf8(std::span<const std::uint8_t> text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text = text.subspan(length);
  }
  return true;
}

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Reads a number. After the end of the message it is 0, and `is_complete` is false.
  template <class Number>
  Number read() {
    Number number = 0;
    if (bytes_.size() - at_ < sizeof number) {
      failed_ = true;
      return number;
    }
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }
  // Fields of commands, by their type.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void read(Number& number, const Range& range) {
    number = read<Number>();
    refuse_if(!range.contains(number));
  }
  void read(AngularSpeed& speed, const Range& range) {
    double rad_per_s = 0;
    read(rad_per_s, range);
    speed = rad_per_s * units::rad_per_s;
  }
  void read(bool& on, const Range& /*range*/) {
    const auto byte = read<std::uint8_t>();
    refuse_if(byte > 1);
    on = byte == 1;
  }
  void read(Vec3& vector, const Range& range) {
    for (double& number : vector) read(number, range);
  }
  void read(Pose& pose, const Range& /*range*/) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) read(pose.rotation(row, column), Range::any());
    read(pose.translation, kPlaces);
    const Mat3 excess = pose.rotation * pose.rotation.transpose() - Mat3::Identity();
    refuse_if(!(excess.cwiseAbs().maxCoeff() < kRotationTolerance) || !(pose.rotation.determinant() > 0));
  }
  /// Reads the rest of the message.
  void read(std::string& text, const Range& /*range*/) {
    const std::span<const std::uint8_t> rest = bytes_.subspan(at_);
    at_ = bytes_.size();
    refuse_if(rest.empty() || rest.size() > kMaxName || !is_printable_utf8(rest));
    text.assign(rest.begin(), rest.end());
  }
  template <Described Command>
  void read(Command& command) {
    for_each_field<Command>([&](const auto& field) { read(command.*field.member, field.range); });
  }
  void refuse_if(bool wrong) { failed_ = failed_ || wrong; }

  [[nodiscard]] bool is_complete() const { return !failed_ && at_ == bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

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
  return message.finish();
}

Message encode(const SurfacePage& page) {
  Writer message(MessageKind::page);
  message.reserve(32 + sizeof(SurfaceVertex) * page.vertices.size() + 2 * page.indices.size());
  for (const int index : page.origin) message.add(std::int32_t(index));
  message.add(page.version).add(std::uint32_t(page.vertices.size())).add(std::uint32_t(page.indices.size()));
  message.add_bytes(page.vertices.data(), sizeof(SurfaceVertex) * page.vertices.size());
  message.add_bytes(page.indices.data(), 2 * page.indices.size());
  return message.finish();
}

Message encode(const LoopSnapshot& snapshot) {
  const ToolSnapshot& tool = snapshot.tool;
  Writer message(MessageKind::snapshot);
  const std::uint32_t flags = (tool.undoing ? 1U : 0U) | (tool.redoing ? 2U : 0U) | (tool.force_held ? 4U : 0U);
  message.add(std::uint32_t(snapshot.arming)).add(snapshot.tick).add(snapshot.X_WT).add(tool.force).add(tool.torque);
  message.add(tool.removed_volume).add(tool.dissipated).add(tool.contact_depth).add(tool.spindle_speed);
  message.add(std::uint32_t(tool.contact_voxels)).add(std::uint32_t(tool.status)).add(std::uint32_t(tool.status_seen));
  message.add(std::uint32_t(tool.undo_marks)).add(std::uint32_t(tool.redo_marks)).add(flags);
  message.add(tool.workpiece).add(std::uint32_t(snapshot.blocks_waiting)).add(tool.contact_point_W);
  return message.finish();
}

Message encode_sound(std::span<const float> samples, std::uint32_t sample_rate) {
  Writer message(MessageKind::sound);
  message.reserve(12 + 2 * samples.size());
  message.add(sample_rate).add(std::uint32_t(samples.size()));
  for (const float sample : samples)
    message.add(std::int16_t(std::lround(32767.0F * std::clamp(std::isfinite(sample) ? sample : 0.0F, -1.0F, 1.0F))));
  return message.finish();
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
  return message.finish();
}

Message encode(std::span<const Control> controls) {
  Writer message(MessageKind::controls);
  message.add(std::uint32_t(controls.size()));
  for (const Control& control : controls) {
    message.add(control.id).add(std::uint8_t(control.kind)).add(std::uint8_t(0));
    message.add(control.value).add(control.min).add(control.max);
    message.add(control.low).add(control.typical).add(control.high);
    message.add_text(control.panel).add_text(control.label).add_text(control.unit).add_text(control.choices);
    message.add_text(control.idle).add_text(control.source);
  }
  return message.finish();
}

Message encode(const Instruments& instruments) {
  Writer message(MessageKind::instruments);
  message.add(instruments.X_WG).add(instruments.power).add(instruments.ticks).add(instruments.missed);
  message.add(instruments.bucket).add(std::uint32_t(instruments.latency.size()));
  for (const std::uint32_t ticks : instruments.latency) message.add(ticks);
  message.add(std::uint32_t(instruments.removed.size()));
  for (const double volume : instruments.removed) message.add(volume);
  message.add(std::uint32_t(instruments.forces.size()));
  for (const double force : instruments.forces) message.add(force);
  return message.add(std::uint32_t(instruments.under)).finish();
}

Message encode(const Heat& heat) {
  Writer message(MessageKind::heat);
  message.reserve(200 + 24 * heat.structures.size() + heat.cells.size());
  message.add(heat.X_WC).add(heat.cell_size);
  for (const std::uint32_t cells : heat.dims) message.add(cells);
  message.add(heat.first).add(heat.step).add(heat.body).add(heat.threshold);
  message.add(std::uint32_t(heat.structures.size()));
  for (const Heat::Structure& one : heat.structures) message.add(one.now).add(one.peak).add(one.time_above);
  return message.add_bytes(heat.cells.data(), heat.cells.size()).finish();
}

Message encode_notice(Severity severity, std::string_view text) {
  Writer message(MessageKind::notice);
  return message.add(std::uint32_t(severity))
      .add(std::uint32_t(text.size()))
      .add_bytes(text.data(), text.size())
      .finish();
}

Message encode_trace(std::uint64_t first, std::span<const TraceSample> samples) {
  static_assert(sizeof(TraceSample) == 24);
  Writer message(MessageKind::trace);
  message.add(first).add(std::uint32_t(samples.size())).add_bytes(samples.data(), samples.size_bytes());
  return message.finish();
}

std::optional<ViewCommand> decode_command(std::span<const std::uint8_t> message) {
  Reader reader(message);
  const auto kind = reader.read<std::uint8_t>();
  reader.refuse_if(reader.read<std::uint8_t>() != kProtocolVersion);
  reader.refuse_if(reader.read<std::uint16_t>() != 0);
  ViewCommand command;
  const bool found = find_alternative<ViewCommand>([&]<class Command>(std::size_t n, Of<Command>) {
    if (n != kind) return false;
    if constexpr (Described<Command>) reader.read(command.emplace<Command>());
    return Described<Command>;
  });
  return found && reader.is_complete() ? std::optional(std::move(command)) : std::nullopt;
}

}  // namespace hapticut::view
