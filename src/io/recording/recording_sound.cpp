// SPDX-License-Identifier: Apache-2.0
// Export of recordings to WAV.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/interruption.hpp"
#include "hapticut/sound/drill_sound.hpp"
#include "io/atomic_file.hpp"
#include "io/byte_reader.hpp"
#include "io/recording/recording_access.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kStepsHeardAtOnce = 4096;
constexpr std::uint32_t kHeadBytes = 44;
constexpr double kMaxBytes = 4e9;  // lengths have 32 bits

/// RIFF, its format chunk (PCM, one channel, 16 bits) and the head of its data.
std::string wav_head(std::uint32_t rate, std::uint32_t data_bytes) {
  std::string head = "RIFF";
  append_bytes_of(head, kHeadBytes - 8 + data_bytes);
  head += "WAVEfmt ";
  append_bytes_of(head, std::uint32_t(16));
  append_bytes_of(head, std::uint16_t(1));
  append_bytes_of(head, std::uint16_t(1));
  append_bytes_of(head, rate);
  append_bytes_of(head, 2 * rate);
  append_bytes_of(head, std::uint16_t(2));
  append_bytes_of(head, std::uint16_t(16));
  head += "data";
  append_bytes_of(head, data_bytes);
  return head;
}

/// Samples of a recording, in the order of its steps.
class Listener {
 public:
  Listener(const Recording& recording, std::uint32_t rate) : rate_(rate), sound_(options_for(recording)) {}

  /// Adds the sound of a step.
  std::span<const float> listen(const RecordedStep& step) {
    const double dissipated = step.energy.losses(), dt = step.input.dt;
    const bool is_time = std::isfinite(dt) && dt > 0;  // a rejected step may have any dt
    SoundInput input;
    input.spindle_speed = step.spindle.speed;
    input.touching = step.contact.voxels > 0;
    if (is_time) {
      input.power = std::max(0.0, dissipated - dissipated_) / dt;
      input.removal_rate = step.removed_volume / dt;
      time_ += std::min(dt, 1.0);
    }
    dissipated_ = dissipated;
    const auto end = std::uint64_t(std::llround(time_ * rate_));
    samples_.resize(std::size_t(end - heard_));
    heard_ = end;
    sound_.render(samples_, rate_, input);
    return samples_;
  }

 private:
  static SoundOptions options_for(const Recording& recording) {
    SoundOptions options;
    options.flutes = recording.tool().cutter().lips;
    return options;
  }

  double rate_;  // [Hz]
  DrillSound sound_;
  double dissipated_ = 0, time_ = 0;  // [J], [s]
  std::uint64_t heard_ = 0;           // samples
  std::vector<float> samples_;
};

}  // namespace

void write_wav(const Recording& recording, const std::filesystem::path& path, double sample_rate) {
  require_within(sample_rate, Range::between(8000, 192'000), "the sample rate [Hz]");
  require_other_file(recording, path);
  const auto rate = std::uint32_t(std::lround(sample_rate));
  write_atomically(path, [&](std::ostream& stream) {
    stream << wav_head(rate, 0);  // the lengths are written at the end
    Listener listener(recording, rate);
    std::string text;
    double bytes = 0;
    for (std::uint64_t first = 0; first < recording.size(); first += kStepsHeardAtOnce)
      for (const RecordedStep& step : recording.read(first, kStepsHeardAtOnce)) {
        look_for_interruption();
        text.clear();
        for (const float sample : listener.listen(step))
          append_bytes_of(text, std::int16_t(std::lround(sample * 32767.0F)));
        bytes += double(text.size());
        if (bytes > kMaxBytes)
          throw Error("'" + path.string() +
                      "' would be longer than the 4 GB that a WAV file can have; the recording is "
                      "too long. Choose a lower sample rate.");
        stream << text;
      }
    stream.seekp(0);
    stream << wav_head(rate, std::uint32_t(bytes));
  });
}

}  // namespace hapticut
