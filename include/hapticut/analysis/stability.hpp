// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/core/description.hpp"

/// Measurements in the closed loop, in simulated time, with the same numbers in every run.
namespace hapticut {

/// Makes a new model of a given stiffness [N/m], or of another parameter that a search varies.
using ModelFactory = std::function<ForceModel(double stiffness)>;

/// Start and criteria of a search for a stability limit.
struct StabilitySearch {
  Pose start;                   ///< X_BS at rest
  Pose target;                  ///< set point of the hand
  double settle = 0;            ///< [s] time before the nudge
  double nudge = 1e-4;          ///< [m/s] speed along -z, small enough that the model responds linearly
  double window = 1;            ///< [s] longer than a period of the slowest mode
  int windows = 4;              ///< [1] a loop is unstable if its swing grows from the second last window to the last
  double low = 5;               ///< [N/m] lower end of the search; another unit for another parameter
  double high = 1e6;            ///< [N/m] upper end of the search, above low
  double coarse_factor = 1.15;  ///< [1] step of the scan for the first unstable value
  double tolerance = 1e-3;      ///< [1] relative, of the result
  double forgotten = 1e-9;      ///< [1] remaining fraction of the nudge at which the search stops waiting
};

constexpr auto fields_of(Of<StabilitySearch>) {
  using S = StabilitySearch;
  constexpr Range kDuration = Range::between(0, 1e4);
  return std::tuple{
      field("start", &S::start, "X_BS at rest"),
      field("target", &S::target, "set point of the hand"),
      field("settle", &S::settle, "s", kDuration, "time before the nudge"),
      field("nudge", &S::nudge, "m/s", Range::positive(),
            "speed along -z, small enough that the model responds linearly"),
      field("window", &S::window, "s", {0, 1e4, true, false}, "longer than a period of the slowest mode"),
      field("windows", &S::windows, "1", Range::between(1, 1e6),
            "a loop is unstable if its swing grows from the second last window to the last"),
      field("low", &S::low, "N/m", Range::positive(), "lower end of the search; another unit for another parameter"),
      field("high", &S::high, "N/m", Range::positive(), "upper end of the search, above low"),
      field("coarse_factor", &S::coarse_factor, "1", Range::between(1.001, 10),
            "step of the scan for the first unstable value"),
      field("tolerance", &S::tolerance, "1", Range::between(1e-9, 1), "relative, of the result"),
      field("forgotten", &S::forgotten, "1", Range::between(0, 1),
            "remaining fraction of the nudge at which the search stops waiting"),
  };
}

/// Whether a small nudge dies out: the difference between a nudged run and an undisturbed one shrinks.
/// @throws Error when a number is not finite or out of range, or when the model returns a wrench that is not finite
[[nodiscard]] bool is_stable(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                             const StabilitySearch& search = {});

/// The lowest stiffness at which the loop begins to be unstable; `search.high` when it is stable throughout, 0 when it
/// is unstable at `search.low`.
///
/// For a linear wall (LinearWall with `one_sided = false`) and a released device without delay this is K = 2 b / T
/// (Colgate and Schenkel), with a delay t_d and small K it is b / (T/2 + t_d) (Gil et al.).
/// @throws Error like `is_stable`, and when `search.low` is not below `search.high`
[[nodiscard]] double max_stable_stiffness(const ClosedLoopConfig& config, const ModelFactory& factory,
                                          const StabilitySearch& search = {});

/// Result of a free flight into the material.
struct Bounce {
  double restitution = 0;       ///< [1] speed out over speed in, maximum over the entry phases; 0: it stayed
  double mean_restitution = 0;  ///< [1] mean over the entry phases
  double generated_energy = 0;  ///< [J] energy from the model in a contact, maximum over the phases
  double penetration = 0;       ///< [m] maximum
  double peak_force = 0;        ///< [N] maximum
};

/// A bounce test: the device flies along -z into the surface z = `height` at a given speed, with `phases` different
/// times of entry between two ticks.
struct BounceTest {
  double height = 0;        ///< [m] height of the surface
  double speed = 0.1;       ///< [m/s] speed along -z
  int phases = 40;          ///< [1] number of flights
  double time_limit = 0.4;  ///< [s] end of a flight
};

constexpr auto fields_of(Of<BounceTest>) {
  using T = BounceTest;
  return std::tuple{
      field("height", &T::height, "m", Range::between(-10, 10), "height of the surface"),
      field("speed", &T::speed, "m/s", {0, 100, true, false}, "speed along -z"),
      field("phases", &T::phases, "1", Range::between(1, 100000), "number of flights"),
      field("time_limit", &T::time_limit, "s", {0, 1e4, true, false}, "end of a flight"),
  };
}

/// Lets the device fly into the surface, once for each phase.
/// @throws Error when a number is not finite or out of range, or when the model returns a wrench that is not finite
[[nodiscard]] Bounce measure_bounce(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                                    const BounceTest& test = {});

/// Vibration of a hand that presses steadily.
struct Buzz {
  double position_rms = 0;            ///< [m] deviation of the tip from its mean, along z
  double frequency = 0;               ///< [Hz] half the rate of its crossings of the mean
  double force_peak_to_peak = 0;      ///< [N] along z
  double generated_power = 0;         ///< [W] mean power from the model
  double max_force = 0;               ///< [N] over the whole run
  [[nodiscard]] bool buzzes() const;  ///< rms > 50 um, or force > 0.3 N p-p, or > 5 mW
};

/// A press test: the hand flies in, and then its target is `depth` below the surface z = `height`.
struct PressTest {
  double height = 0;     ///< [m] height of the surface
  double depth = 0.010;  ///< [m] depth of the hand's target below the surface
  double speed = 0.05;   ///< [m/s] speed of the approach
  double approach = 0;   ///< [s] that the hand waits 2 mm above the surface before it presses; at most seconds
  double seconds = 4;    ///< [s] duration of the run
  double measured = 1;   ///< [s] time at the end of the run that is measured; at most seconds
};

constexpr auto fields_of(Of<PressTest>) {
  using T = PressTest;
  return std::tuple{
      field("height", &T::height, "m", Range::between(-10, 10), "height of the surface"),
      field("depth", &T::depth, "m", Range::between(0, 10), "depth of the hand's target below the surface"),
      field("speed", &T::speed, "m/s", Range::between(0, 100), "speed of the approach"),
      field("approach", &T::approach, "s", Range::between(0, 1e4),
            "that the hand waits 2 mm above the surface before it presses; at most seconds"),
      field("seconds", &T::seconds, "s", {0, 1e4, true, false}, "duration of the run"),
      field("measured", &T::measured, "s", {0, 1e4, true, false},
            "time at the end of the run that is measured; at most seconds"),
  };
}

/// Lets the hand press, and measures at the end of the run.
/// @throws Error when a number is not finite or out of range, or when the model returns a wrench that is not finite
[[nodiscard]] Buzz measure_buzz(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                                const PressTest& test = {});

}  // namespace hapticut
