// SPDX-License-Identifier: Apache-2.0
// The sound of a drill, measured in the samples.
#include "hapticut/sound/drill_sound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::drill_sound_test {
namespace {

using units::kPi;
using units::rpm;

constexpr double kRate = 48'000;  // [Hz]

using Samples = std::vector<float>;

Samples heard(DrillSound& sound, const SoundInput& input, double seconds, double rate = kRate) {
  Samples samples(std::size_t(seconds * rate));
  sound.render(samples, rate, input);
  return samples;
}

/// Samples of an input after a warm-up time `before`.
Samples lasting(const SoundInput& input, double before = 0.5, double seconds = 0.5) {
  DrillSound sound;
  (void)heard(sound, input, before);
  return heard(sound, input, seconds);
}

/// Amplitude of one frequency, by the correlation with it under a Hann window.
double strength_at(const Samples& samples, double frequency, double rate = kRate) {
  double cosine = 0, sine = 0, weight = 0;
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double window = 1 - std::cos(2 * kPi * double(n) / double(samples.size()));
    const double angle = 2 * kPi * frequency * double(n) / rate;
    cosine += window * samples[n] * std::cos(angle), sine += window * samples[n] * std::sin(angle), weight += window;
  }
  return 2 * std::hypot(cosine, sine) / weight;
}

/// [Hz] The strongest frequency within 20 % of a guess.
double strongest_near(const Samples& samples, double guess, double rate = kRate) {
  double best = 0, found = 0;
  for (double f = 0.8 * guess; f < 1.2 * guess; f += std::max(0.5, 0.001 * guess))
    if (const double strength = strength_at(samples, f, rate); strength > best) best = strength, found = f;
  return found;
}

double rms(const Samples& samples, std::size_t first = 0) {
  double sum = 0;
  for (std::size_t n = first; n < samples.size(); ++n) sum += double(samples[n]) * double(samples[n]);
  return std::sqrt(sum / double(samples.size() - first));
}

/// [Hz] Geometric mean of the frequencies, weighted by power.
double middle_of(const Samples& samples) {
  double sum = 0, weighed = 0;
  for (double f = 300; f < 20'000; f *= 1.01) {
    const double power = f * std::pow(strength_at(samples, f), 2);  // bandwidth proportional to frequency
    sum += power, weighed += power * std::log(f);
  }
  return std::exp(weighed / sum);
}

TEST(DrillSound, TonesAreThoseOfTheSpindleAndItsFlutes) {
  for (const double speed : {10'000 * rpm, -40'000 * rpm, 200'000 * rpm, 400'000 * rpm}) {
    const Samples samples = lasting({speed, 0, 0, false});
    const double frequency = std::abs(speed) / (2 * kPi);
    EXPECT_NEAR(strongest_near(samples, frequency) / frequency, 1, 0.01);
    EXPECT_GT(strength_at(samples, frequency), 0.05);
    if (6 * frequency > 0.4 * kRate) continue;
    EXPECT_NEAR(strongest_near(samples, 6 * frequency) / (6 * frequency), 1, 0.01);
    EXPECT_GT(strength_at(samples, 6 * frequency), 0.02);
  }
}

TEST(DrillSound, NoToneIsAliased) {
  const double frequency = 400'000 / 60.0;  // 6.7 kHz; the flutes' 40 kHz would be heard at 8 kHz
  const Samples samples = lasting({2 * kPi * frequency, 0, 0, false});
  EXPECT_LT(strength_at(samples, kRate - 6 * frequency), 1e-4);
  EXPECT_LT(strength_at(samples, 6 * frequency - kRate / 2), 1e-4);
}

TEST(DrillSound, PitchSagsWithTheSpindleAndRunsUpAndDown) {
  DrillSound sound;
  SoundInput input{40'000 * rpm, 0, 0, false};
  const Samples first = heard(sound, input, 0.03);
  EXPECT_LT(strongest_near(first, 450), 620) << "it runs up to 667 Hz";
  (void)heard(sound, input, 0.5);
  input.spindle_speed *= 0.8;  // under load
  (void)heard(sound, input, 0.3);
  EXPECT_NEAR(strongest_near(heard(sound, input, 0.3), 533), 533.3, 5.3);
  input.spindle_speed = 0;
  const Samples last = heard(sound, input, 0.5);
  EXPECT_GT(rms(Samples(last.begin(), last.begin() + 480)), 0.05) << "it runs down";
}

TEST(DrillSound, IsSilentWhenItStands) {
  DrillSound sound;
  for (const float sample : heard(sound, {}, 0.1)) ASSERT_EQ(sample, 0);
  (void)heard(sound, {40'000 * rpm, 3, 1e-9, true}, 0.5);
  (void)heard(sound, {}, 0.6);  // runs down
  for (const float sample : heard(sound, {}, 0.1)) ASSERT_EQ(sample, 0);
}

TEST(DrillSound, LevelGrowsWithPower) {
  double before = -1;
  for (const double power : {0.0, 0.01, 0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0, 100.0}) {
    const double level = rms(lasting({0, power, power / 1e9, false}, 0.3, 1));
    EXPECT_GT(level, 1.02 * before) << power << " W";
    before = level;
    // The noise band has the level that the header documents, whatever its centre.
    EXPECT_NEAR(level, 0.5 * 0.24 * std::sqrt(power / (power + 2)), 0.05 * level + 1e-6) << power << " W";
  }
}

TEST(DrillSound, HarderMaterialSoundsBrighterAndRubbingBrightest) {
  double before = 0;
  for (const double energy : {1e7, 1e8, 1e9, 1e10}) {
    const double middle = middle_of(lasting({0, 2, 2 / energy, false}));
    EXPECT_GT(middle, 1.3 * before) << energy;
    EXPECT_GT(middle, 1000);
    EXPECT_LT(middle, 11'000);
    before = middle;
  }
  EXPECT_NEAR(middle_of(lasting({0, 2, 0, false})) / before, 1, 0.05) << "it rubs";
}

TEST(DrillSound, ClicksAtFirstTouchOnce) {
  DrillSound sound;
  (void)heard(sound, {}, 0.2);
  const SoundInput touching{0, 0, 0, true};
  const Samples click = heard(sound, touching, 0.07);
  EXPECT_GT(*std::max_element(click.begin(), click.end()), 0.1F);
  EXPECT_NEAR(strongest_near(click, 3000), 3000, 60);
  EXPECT_EQ(rms(heard(sound, touching, 0.2)), 0) << "the click has ended and does not repeat";
  // A contact that is lost for some milliseconds does not count as a new touch.
  (void)heard(sound, {}, 0.01);
  EXPECT_EQ(rms(heard(sound, touching, 0.1)), 0);
  (void)heard(sound, {}, 0.05);
  EXPECT_GT(rms(heard(sound, touching, 0.1)), 0.01);
}

TEST(DrillSound, IsEqualForBuffersOfAnyLength) {
  const SoundInput input{40'000 * rpm, 3, 1e-9, true};
  DrillSound at_once, in_parts;
  const Samples whole = heard(at_once, input, 0.5);
  Samples parts(whole.size());
  std::size_t first = 0, length = 1;
  while (first < parts.size()) {
    const std::size_t count = std::min(length, parts.size() - first);
    in_parts.render(std::span(parts).subspan(first, count), kRate, input);
    first += count;
    length = length * 7 % 1021 + 1;
  }
  EXPECT_EQ(whole, parts);
}

TEST(DrillSound, HasNoStepWhereABufferEndsAndTheInputChanges) {
  DrillSound sound;
  SoundInput input;
  Samples all;
  // Everything except the click changes at each buffer, as much as possible.
  for (int buffer = 0; buffer < 200; ++buffer) {
    input.spindle_speed = buffer % 2 == 0 ? 60'000 * rpm : 10'000 * rpm;
    const Samples samples = heard(sound, input, 0.008);
    all.insert(all.end(), samples.begin(), samples.end());
  }
  // A tone of amplitude a and frequency f has second differences of a (2 pi f/rate)^2 at most; those of the flutes are
  // the largest. A step of a thousandth would stand out.
  const double bound = 0.5 * (0.3 + 0.1 * 4 + 0.15 * 36) * std::pow(2 * kPi * 1000 / kRate, 2);
  for (std::size_t n = 2; n < all.size(); ++n) ASSERT_LT(std::abs(all[n] - 2 * all[n - 1] + all[n - 2]), bound) << n;
  // The noise of a cut swells; it does not begin abruptly.
  DrillSound cut;
  (void)heard(cut, {}, 0.1);
  const Samples first = heard(cut, {0, 100, 1e-9, false}, 0.001);
  EXPECT_LT(*std::max_element(first.begin(), first.end()), 0.05F);
}

TEST(DrillSound, StaysWithinFullScaleAndTakesAnyInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  SoundOptions loud;
  loud.volume = 1;
  DrillSound sound(loud);
  for (const SoundInput& input : {SoundInput{1e9, 1e9, 1e-30, true}, SoundInput{nan, nan, nan, false},
                                  SoundInput{infinity, -infinity, infinity, true}, SoundInput{-1e5, -3, -1, false},
                                  SoundInput{4000, 1e-300, 1e300, true}})
    for (const double rate : {8000.0, 44'100.0, 192'000.0})
      for (const float sample : heard(sound, input, 0.1, rate)) ASSERT_LE(std::abs(sample), 1.0F);
  Samples samples(10, 3.0F);
  for (const double rate : {0.0, -1.0, nan, infinity, 1e6}) {
    sound.render(samples, rate, {4000, 1, 1e-9, true});
    for (const float sample : samples) ASSERT_EQ(sample, 0) << rate;
    samples.assign(10, 3.0F);
  }
  sound.render({}, kRate, {});
}

TEST(DrillSound, RefusesOptionsThatMakeNoSense) {
  EXPECT_THROW(DrillSound({.flutes = 0}), Error);
  EXPECT_THROW(DrillSound({.volume = 1.5}), Error);
  EXPECT_THROW(DrillSound({.half_power = 0}), Error);
}

}  // namespace
}  // namespace hapticut::drill_sound_test
