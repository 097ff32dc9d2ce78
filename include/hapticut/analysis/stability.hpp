// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hapticut/analysis/closed_loop.hpp"

/// Measurements in the closed loop, in simulated time, with the same numbers in every run.
namespace hapticut {

/// Makes a new model of a given stiffness [N/m], or of another parameter that a search varies.
using ModelFactory = std::function<ForceModel(double stiffness)>;

/// Start and criteria of a search for a stability limit.
struct StabilitySearch {
  Pose start;                   ///< X_BS at rest
  Pose target;                  ///< set point of the hand
  double settle = 0;            ///< [s] before the nudge
  double nudge = 1e-4;          ///< [m/s] along -z, small enough that the model responds linearly
  double window = 1;            ///< [s] longer than a period of the slowest mode
  int windows = 4;              ///< a loop is unstable if its swing grows from the second last window to the last
  double low = 5, high = 1e6;   ///< range of the search
  double coarse_factor = 1.15;  ///< of the scan for the first unstable value
  double tolerance = 1e-3;      ///< [1] relative, of the result
  double forgotten = 1e-9;      ///< [1] remaining fraction of the nudge at which the search stops waiting
};

/// Whether a small nudge dies out: the difference between a nudged run and an undisturbed one shrinks.
[[nodiscard]] bool is_stable(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                             const StabilitySearch& search = {});

/// The lowest stiffness at which the loop begins to be unstable; `search.high` when it is stable throughout, 0 when it
/// is unstable at `search.low`.
///
/// For a linear wall and a released device without delay this is K = 2 b / T (Colgate and Schenkel), with a delay t_d
/// and small K it is b / (T/2 + t_d) (Gil et al.).
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
  double height = 0;   ///< [m]
  double speed = 0.1;  ///< [m/s]
  int phases = 40;
  double time_limit = 0.4;  ///< [s]
};

/// Lets the device fly into the surface, once for each phase.
[[nodiscard]] Bounce measure_bounce(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                                    const BounceTest& test = {});

/// Vibration of a hand that presses steadily.
struct Buzz {
  double position_rms = 0;            ///< [m] of the tip about its mean, along z
  double frequency = 0;               ///< [Hz] half the rate of its crossings of the mean
  double force_peak_to_peak = 0;      ///< [N] along z
  double generated_power = 0;         ///< [W] mean power from the model
  double max_force = 0;               ///< [N] over the whole run
  [[nodiscard]] bool buzzes() const;  ///< rms > 50 um, or force > 0.3 N p-p, or > 5 mW
};

/// A press test: the hand flies in, and then its target is `depth` below the surface z = `height`.
struct PressTest {
  double height = 0;     ///< [m]
  double depth = 0.010;  ///< [m]
  double speed = 0.05;   ///< [m/s] of the approach
  double approach = 0;   ///< [s] that the hand waits 2 mm above the surface before it presses
  double seconds = 4;    ///< [s] of the run
  double measured = 1;   ///< [s] at its end
};

/// Lets the hand press, and measures at the end of the run.
[[nodiscard]] Buzz measure_buzz(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                                const PressTest& test = {});

}  // namespace hapticut
