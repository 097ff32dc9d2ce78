// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"

/// @file
/// Published measurements that the simulation is run with; published.hpp has all.
namespace hapticut::experiments {

/// A drilling test of Orelaja, Wang et al. 2020 (J Healthc Eng 8817422, Table 6): mean of the maximum thrust and
/// torque.
struct PublishedDrilling {
  const char* id;  ///< rows of thrust and torque
  const char* material;
  double thrust;  ///< [N]
  double torque;  ///< [N·m]

  static constexpr double kRadius = 1.25 * units::mm;
  static constexpr AngularSpeed kSpeed = 1000 * units::rpm;
  /// [m] Assumed, because the source gives no feed. kappa, and predictions for the same feed per revolution, do not
  /// depend on it; u is inversely proportional to it.
  static constexpr double kFeedPerTurn = 0.1 * units::mm;

  [[nodiscard]] DrillingTest test() const {
    return {kRadius, kSpeed, kFeedPerTurn * kSpeed / (2 * units::kPi), thrust, torque};
  }
  [[nodiscard]] Calibration constants() const {
    const DrillingTest one = test();
    return calibrate({&one, 1}, ChipTerm::edge_pressure);  // one test cannot identify the edge term, so it is 0
  }
};

inline constexpr std::array<PublishedDrilling, 3> kPublishedDrillings = {
    {{"B1a, B1d", "bovine bone", 20.07, 41.2 * units::N_mm},
     {"B1b, B1e", "porcine bone", 11.25, 37.0 * units::N_mm},
     {"B1c, B1f", "artificial bone", 5.62, 13.6 * units::N_mm}}};

/// Enamel under a diamond bur (DC4: Fais et al. 2010, Braz J Oral Sci 9:39). The source gives mass, time and load.
/// Bur and speed of a usual high-speed handpiece, and kappa of the preset, are assumptions.
struct DiamondBur {
  static constexpr double kRadius = 0.6 * units::mm;
  static constexpr double kSpeed = 300000 * units::rpm;
  static constexpr double kCuttingRatio = 0.5;
  static constexpr double kLoad = 0.065 * 9.80665;                    ///< [N] middle of 50 ... 80 g
  static constexpr double kRemoval = 0.1117e-3 / 2950 / (12.0 * 60);  ///< [m^3/s]

  /// [W] Power of the bur's side under a load.
  [[nodiscard]] static constexpr double power(double load) { return kCuttingRatio * load * kSpeed * kRadius; }
  /// [J/m^3] u of enamel with this bur.
  [[nodiscard]] static constexpr double energy() { return power(kLoad) / kRemoval; }
};

/// A carbide bur at high speed, pushed along its axis into tooth (DC9: White 1998, Proc SPIE 3248). The source gives
/// the rates. Load, blades and speed under load of a usual handpiece are assumptions.
struct CarbideBur {
  static constexpr double kRadius = 0.42 * units::mm;
  static constexpr double kSpeed = 250000 * units::rpm;
  static constexpr double kLoad = 0.98;                   ///< [N]
  static constexpr double kInEnamel = 0.273 * units::mm;  ///< [m/s]
  static constexpr double kInDentin = 0.493 * units::mm;  ///< [m/s]
  static constexpr double kScatter = 0.17;                ///< [1] scatter of the rate in enamel, as the source gives it
};

}  // namespace hapticut::experiments
