// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "hapticut/core/abi.hpp"

namespace hapticut {

/// What the time stamps of the readings tell about the ticks of a loop.
/// @realtime no allocation, no lock
class TickClock {
 public:
  /// The time since the last tick, for those who need it.
  struct Elapsed {
    double for_speeds = 0;  ///< [s] at least a fifth of the period: what a motion is divided by
    double for_ramps = 0;   ///< [s] at most what the readings say, so that a fast loop does not shorten a fade-in
    double for_poses = 0;   ///< [s] with the time of a pause, in which a hand may go far
    double late = 0;        ///< [s] beyond the period; 0 if not known
  };

  /// The ticks of about a second.
  struct Pace {
    double period = 0;  ///< [s] mean time of a tick
    double rate = 0;    ///< [Hz] rate of good readings
  };

  /// @param period  [s] of the ticks
  /// @param pause   [s] the longest delay that matters
  TickClock(double period, double pause) : period_(period), pause_(pause) {}

  void restart() noexcept;

  /// @param time     [s] of the reading
  /// @param repeats  the device has no newer reading, and its clock stands
  /// @param waited   [s] since the last tick by a clock of the loop; infinite: not known. A driver may count its
  /// readings in place of their time, or repeat them
  Elapsed tick(double time, bool repeats, double waited = std::numeric_limits<double>::infinity()) noexcept;

  /// Counts a reading that is used.
  void count_good() noexcept { ++good_; }

  /// The pace of the ticks, at the end of each second or of each thousand ticks.
  [[nodiscard]] std::optional<Pace> pace() noexcept;

 private:
  double period_, pause_;
  bool started_ = false;
  double clock_ = 0;          // [s] time of the readings, but it goes on while they stand
  int ticks_ = 0, good_ = 0;  // since the last pace
  double watched_ = 0;        // [s] since then
};

}  // namespace hapticut
