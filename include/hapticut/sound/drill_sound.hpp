// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// State of a drill that determines its sound.
struct SoundInput {
  double spindle_speed = 0;  ///< [rad/s] speed of either sign, under the load of the cut
  double power = 0;          ///< [W] that becomes chips and heat
  double removal_rate = 0;   ///< [m^3/s] volume that is cut away
  bool touching = false;     ///< the head touches the workpiece
};

constexpr auto fields_of(Of<SoundInput>) {
  using I = SoundInput;
  return std::tuple{
      field("spindle_speed", &I::spindle_speed, "rad/s", "speed of either sign, under the load of the cut"),
      field("power", &I::power, "W", Range::not_negative(), "that becomes chips and heat"),
      field("removal_rate", &I::removal_rate, "m^3/s", Range::not_negative(), "volume that is cut away"),
      field("touching", &I::touching, "the head touches the workpiece"),
  };
}

/// Options of the sound.
struct SoundOptions {
  int flutes = 6;         ///< [1] edges that pass in a revolution: Cutter::lips
  double volume = 0.5;    ///< [1] volume of the sum; full scale is 1
  double half_power = 2;  ///< [W] power at which the noise has half of its maximum power
};

constexpr auto fields_of(Of<SoundOptions>) {
  using O = SoundOptions;
  return std::tuple{
      field("flutes", &O::flutes, "1", Range::between(1, 1000), "edges that pass in a revolution: Cutter::lips"),
      field("volume", &O::volume, "1", Range::between(0, 1), "volume of the sum; full scale is 1"),
      field("half_power", &O::half_power, "W", Range::positive(),
            "power at which the noise has half of its maximum power"),
  };
}

/// The sound of a drill, computed sample by sample from the state of the loop, without a recording:
///
///     tone   f = |spindle_speed|/(2 pi), 2 f, and flutes f, where the sample rate allows them (to 0.45 of it)
///     noise  in a band, of rms 0.24 sqrt(P/(P + half_power)); its middle is at 2.5 kHz where the work per removed
///            volume is 1e8 J/m^3, an octave higher for ten times as much: 1.25 ... 10 kHz. Rubbing removes nothing,
///            so it hisses
///     click  of 3 kHz for some milliseconds, when the head touches after it was free for 30 ms
///
/// The sag of an air turbine and the stall of a motor are in `spindle_speed`. Pitch and levels follow the input within
/// some hundredths of a second, so the sound has no step at the end of a buffer, and a spindle without a ramp is heard
/// to run up and down.
class DrillSound {
 public:
  /// @throws Error when an option is out of range
  explicit DrillSound(const SoundOptions& options = {});

  /// Computes the next samples of one channel. The size of the buffers does not matter.
  /// @param samples      overwritten; -1 ... 1
  /// @param sample_rate  [Hz] 8000 ... 384 000; silence at any other
  /// @param input        from now on; numbers that are not finite count as 0
  /// @realtime no allocation, no lock; O(samples), about 0.1 us each
  void render(std::span<float> samples, double sample_rate, const SoundInput& input) noexcept;

 private:
  struct Target;
  [[nodiscard]] float next(const Target& target) noexcept;
  [[nodiscard]] double tone(double sample_rate) noexcept;
  [[nodiscard]] double noise(double sample_rate) noexcept;
  [[nodiscard]] double click(const Target& target) noexcept;

  SoundOptions options_;
  double speed_ = 0, phase_ = 0;         // [Hz] as heard; [revolutions] 0 ... 1
  double noise_level_ = 0, pitch_ = 0;   // [1]; [octaves] above 2.5 kHz
  std::array<double, 2> band_ = {0, 0};  // state of the filter
  double free_ = 1, since_touch_ = 1;    // [s] not touching; since the click
  std::uint32_t random_ = 0x9e3779b9;
};

}  // namespace hapticut
