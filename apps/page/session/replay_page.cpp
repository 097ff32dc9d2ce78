// SPDX-License-Identifier: Apache-2.0
#include "page/session/replay_page.hpp"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "hapticut/surface/surface_stream.hpp"
#include "io/atomic_file.hpp"
#include "page/session/material_under.hpp"
#include "page/session/view_session.hpp"
#include "reports/progress.hpp"

namespace hapticut::apps {
namespace {

constexpr double kPicture = 1.0 / 30;  // [s]
constexpr const char* kStyle = "<link rel=\"stylesheet\" href=\"page.css\">";
constexpr const char* kScript = "<script src=\"page.js\"></script>";

/// Messages with their times, in order.
class Stream {
 public:
  Stream() { add_bytes("HCRP\1\0\0\0", 8); }
  void add(double time, const view::Message& message) {
    const auto length = std::uint32_t(message.size());
    add_bytes(&time, sizeof time);
    add_bytes(&length, sizeof length);
    add_bytes(message.data(), message.size());
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  void add_bytes(const void* bytes, std::size_t count) {
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    bytes_.insert(bytes_.end(), first, first + count);
  }
  std::vector<std::uint8_t> bytes_;
};

std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes) {
  constexpr int kGzip = 15 + 16;
  z_stream stream{};
  if (deflateInit2(&stream, 6, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error("the recording cannot be compressed: there is not enough memory.");
  std::vector<std::uint8_t> out(deflateBound(&stream, uLong(bytes.size())));
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = uInt(bytes.size());
  stream.next_out = out.data();
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * (bytes.size() / 3 + 1));
  for (std::size_t n = 0; n < bytes.size(); n += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - n);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8U | (k < have ? bytes[n + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= have ? kDigits[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream || text.empty())
    throw Error("'" + path.string() + "' cannot be read; build the page again, or set --page to its folder.");
  return text;
}

void write_text(const std::filesystem::path& path, const void* bytes, std::size_t count) {
  write_atomically(path, std::string_view(static_cast<const char*>(bytes), count));
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw Error("the built page has another version than this program: build it again.");
  text.replace(at, what.size(), by);
}

/// What a page shows of a step.
class ReplayWriter {
 public:
  explicit ReplayWriter(const Recording& recording) : recording_(recording) {}

  void add(const Simulation& simulation, const RecordedStep& step) {
    if (!surface_) begin(simulation, step);
    const double time = step.time - begin_;
    surface_->update(simulation.workpiece(), simulation.changed_blocks().origins);
    trace_.push_back(sample(step));
    shown_.tool.removed_volume += step.removed_volume;
    removed_ = simulation.totals().removed_volume;
    for (std::size_t id = 1; id <= std::size_t(materials_); ++id) pressed_[id] += simulation.normal_forces()[id];
    last_ = step;
    if (time + 1e-9 < next_) return;
    next_ = time + kPicture;
    under_ =
        material_under(simulation.workpiece(), recording_.tool().head(), step.input.X_WH * recording_.tool().X_HT());
    show();
  }
  /// Shows the changes since the last picture.
  void end() {
    if (!trace_.empty()) show();
  }
  [[nodiscard]] const Stream& stream() const { return stream_; }

 private:
  static view::TraceSample sample(const RecordedStep& step) {
    view::TraceSample sample{};
    for (Eigen::Index n = 0; n < 3; ++n) {
      sample.force[std::size_t(n)] = float(step.force[n]);
      sample.torque[std::size_t(n)] = float(step.model.torque[n]);
    }
    return sample;
  }
  void begin(const Simulation& simulation, const RecordedStep& step) {
    begin_ = step.time;
    materials_ = simulation.workpiece().materials().size();
    surface_ = std::make_unique<SurfaceStream>(recording_.workpiece());
    stream_.add(0, view::encode_hello(shown_scene(simulation.workpiece()), false));
    stream_.add(0, view::encode(recording_.tool()));
    add_pages(0);
  }
  void add_pages(double time) {
    SurfacePage page;
    while (surface_->next_page(page)) stream_.add(time, view::encode(page));
  }
  void show() {
    const RecordedStep& step = last_;
    const double time = step.time - begin_;
    add_pages(time);
    shown_.tick = step.number;
    shown_.arming = recording_.has_device() ? step.device.arming : ArmingState::on;
    shown_.X_WT = step.input.X_WH * recording_.tool().X_HT();
    shown_.tool.force = step.force;
    shown_.tool.torque = step.torque;
    shown_.tool.contact_depth = step.contact.depth;
    shown_.tool.contact_voxels = step.contact.voxels;
    shown_.tool.contact_point_W = step.contact.point_W;
    shown_.tool.spindle_speed = step.spindle.speed;
    shown_.tool.status = step.status;
    const double before = shown_.tool.dissipated;
    shown_.tool.dissipated = step.energy.losses();
    stream_.add(time, view::encode(shown_));
    view::Instruments instruments;
    instruments.X_WG = shown_.X_WT;
    instruments.power = std::max(0.0, shown_.tool.dissipated - before) / kPicture;
    instruments.ticks = step.number;
    instruments.removed.assign(removed_.begin() + 1, removed_.begin() + 1 + materials_);
    for (std::size_t id = 1; id <= std::size_t(materials_); ++id)
      instruments.forces.push_back(std::exchange(pressed_[id], 0.0) / double(trace_.size()));
    instruments.under = under_;
    stream_.add(time, view::encode(instruments));
    stream_.add(time, view::encode_trace(first_, trace_));
    first_ += trace_.size();
    trace_.clear();
  }

  const Recording& recording_;
  Stream stream_;
  std::unique_ptr<SurfaceStream> surface_;
  LoopSnapshot shown_;
  RecordedStep last_;
  ByMaterial<double> removed_{};  // [m^3] by material
  ByMaterial<double> pressed_{};  // [N] sum of the normal forces since the last picture
  MaterialId under_ = kEmpty;
  int materials_ = 0;
  std::vector<view::TraceSample> trace_;
  std::uint64_t first_ = 0;
  double begin_ = 0, next_ = 0;
};

}  // namespace

std::vector<std::uint8_t> replay_stream(const Recording& recording) {
  ProgressBar progress("replaying", std::size_t(recording.size()));
  ReplayWriter writer(recording);
  ReplayOptions options;
  options.on_step = [&](const Simulation& simulation, const RecordedStep& step) { writer.add(simulation, step); };
  options.progress = [&](std::uint64_t steps) { progress.advance_to(std::size_t(steps)); };
  (void)replay(recording, options);
  writer.end();
  return compressed(writer.stream().bytes());
}

void write_replay_page(const Recording& recording, const std::filesystem::path& page,
                       const std::filesystem::path& target) {
  std::string html = text_of(page / "index.html"), script = text_of(page / "page.js");
  for (std::size_t at = 0; (at = script.find("</script", at)) != std::string::npos; at += 9)
    script.insert(at + 1, 1, '\\');
  replace(html, kStyle, std::string("<style>").append(text_of(page / "page.css")).append("</style>"));
  std::string inside("<script id=\"recording\" type=\"application/octet-stream\">");
  inside.append(base64(replay_stream(recording))).append("</script>\n<script>").append(script).append("</script>");
  replace(html, kScript, inside);
  write_text(target, html.data(), html.size());
}

void write_replay_folder(const Recording& recording, const std::filesystem::path& page,
                         const std::filesystem::path& folder) {
  std::string html = text_of(page / "index.html");
  replace(html, kScript, std::string("<div id=\"recording\" data-from=\"recording.bin\" hidden></div>\n") + kScript);
  write_text(folder / "index.html", html.data(), html.size());
  for (const char* name : {"page.css", "page.js"}) {
    const std::string text = text_of(page / name);
    write_text(folder / name, text.data(), text.size());
  }
  const std::vector<std::uint8_t> stream = replay_stream(recording);
  write_text(folder / "recording.bin", stream.data(), stream.size());
}

}  // namespace hapticut::apps
