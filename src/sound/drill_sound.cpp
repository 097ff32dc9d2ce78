// SPDX-License-Identifier: Apache-2.0
#include "hapticut/sound/drill_sound.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

using units::kPi;

constexpr double kMinRate = 8000, kMaxRate = 384'000;  // [Hz]
constexpr double kMaxShare = 0.45;   // [1] highest tone over the sample rate; a higher one would alias
constexpr double kFadeShare = 0.05;  // [1] range over the sample rate, in which a tone fades below that limit
constexpr double kPitchTime = 0.03, kLevelTime = 0.01;  // [s] lag of the sound
constexpr double kMinSpeed = 0.05;                      // [Hz] below it the spindle stands
constexpr double kMinLevel = 1e-5;                      // [1] below it there is silence
constexpr double kToneSpeed = 300;                      // [Hz] at which a tone has half of its strength
constexpr double kNoise = 0.24;                         // [1] maximum rms
constexpr double kMiddle = 2500, kQuality = 1.2;        // [Hz], [1] centre and quality of the band
constexpr double kPlainEnergy = 1e8;                    // [J/m^3] at the centre
constexpr double kLowestOctave = -1, kMaxOctave = 2;    // octaves from the centre
constexpr double kClickTone = 3000, kClickTime = 0.004, kClickRise = 0.0005, kClick = 0.5;  // [Hz], [s], [s], [1]
constexpr double kClickLasts = 0.06, kFreeBeforeClick = 0.03;                               // [s]

double finite_or_0(double value) { return std::isfinite(value) ? value : 0.0; }

/// [1] Share of a tone that the sample rate can represent.
double audible_share(double frequency, double sample_rate) {
  return std::clamp((kMaxShare * sample_rate - frequency) / (kFadeShare * sample_rate), 0.0, 1.0);
}

}  // namespace

/// The targets of the input, and the rates at which a sample follows them.
struct DrillSound::Target {
  double sample_rate;
  double speed;          // [Hz]
  double level, octave;  // level of the noise, octave of its centre
  bool touching;
  double follow_pitch, follow_level;  // [1] part of the difference that a sample makes up for

  Target(const SoundInput& input, const SoundOptions& options, double rate)
      : sample_rate(rate),
        speed(std::min(std::abs(finite_or_0(input.spindle_speed)) / (2 * kPi), rate)),
        touching(input.touching),
        follow_pitch(1 - std::exp(-1 / (kPitchTime * rate))),
        follow_level(1 - std::exp(-1 / (kLevelTime * rate))) {
    const double power = std::max(0.0, finite_or_0(input.power));
    const double removed = std::max(0.0, finite_or_0(input.removal_rate));
    level = std::sqrt(power / (power + options.half_power));
    // Rubbing removes nothing: its energy per volume is infinite.
    const double of_plain = removed * kPlainEnergy;  // [W]
    octave = of_plain > 0 && power > 0 ? std::log10(power / of_plain) : kMaxOctave;
    octave = std::clamp(octave, kLowestOctave, kMaxOctave);
  }
};

DrillSound::DrillSound(const SoundOptions& options) : options_(options) {
  require_fields_within(options, "SoundOptions::");
}

void DrillSound::render(std::span<float> samples, double sample_rate, const SoundInput& input) noexcept {
  if (!(sample_rate >= kMinRate && sample_rate <= kMaxRate)) {
    std::fill(samples.begin(), samples.end(), 0.0F);
    return;
  }
  const Target target(input, options_, sample_rate);
  for (float& sample : samples) sample = next(target);
}

float DrillSound::next(const Target& target) noexcept {
  speed_ += target.follow_pitch * (target.speed - speed_);
  if (target.speed == 0 && speed_ < kMinSpeed) speed_ = 0;
  noise_level_ += target.follow_level * (target.level - noise_level_);
  if (target.level == 0 && noise_level_ < kMinLevel) noise_level_ = 0;
  if (target.level > 0) pitch_ += target.follow_pitch * (target.octave - pitch_);
  const double sum = tone(target.sample_rate) + noise(target.sample_rate) + click(target);
  return float(options_.volume * std::clamp(sum, -1.0, 1.0));
}

double DrillSound::tone(double sample_rate) noexcept {
  if (speed_ == 0) return 0;
  phase_ += speed_ / sample_rate;
  phase_ -= std::floor(phase_);
  const double strength = speed_ / (speed_ + kToneSpeed);
  const auto partial = [&](double multiple, double level) {
    const double share = audible_share(multiple * speed_, sample_rate);
    return share > 0 ? level * share * std::sin(2 * kPi * multiple * phase_) : 0.0;
  };
  double sum = partial(1, 0.3) + partial(2, 0.1);
  if (options_.flutes > 2) sum += partial(options_.flutes, 0.15);
  return strength * sum;
}

double DrillSound::noise(double sample_rate) noexcept {
  random_ ^= random_ << 13, random_ ^= random_ >> 17, random_ ^= random_ << 5;
  if (noise_level_ == 0) {
    band_ = {0, 0};
    return 0;
  }
  // A band-pass of two trapezoidal integrators, which stays stable while its centre moves.
  const double white = double(random_) * (2.0 / 4294967296.0) - 1;
  const double middle = std::min(kMiddle * std::exp2(pitch_), 0.4 * sample_rate);
  const double g = std::tan(kPi * middle / sample_rate), k = 1 / kQuality;
  const double a = 1 / (1 + g * (g + k));
  const double band = a * (band_[0] + g * (white - band_[1])), low = band_[1] + g * band;
  band_ = {2 * band - band_[0], 2 * low - band_[1]};
  // This filter, with gain k, passes the fraction g k a of white noise of variance 1/3.
  return kNoise * noise_level_ * k * band / std::sqrt(g * k * a / 3);
}

double DrillSound::click(const Target& target) noexcept {
  const double dt = 1 / target.sample_rate;
  since_touch_ += dt;
  if (!target.touching) {
    free_ += dt;
  } else {
    if (free_ >= kFreeBeforeClick) since_touch_ = 0;
    free_ = 0;
  }
  if (since_touch_ > kClickLasts) return 0;
  const double rise = std::min(1.0, since_touch_ / kClickRise);
  return kClick * rise * std::exp(-since_touch_ / kClickTime) * std::sin(2 * kPi * kClickTone * since_touch_);
}

}  // namespace hapticut
