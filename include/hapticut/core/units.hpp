// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Factors from the units of the dental chair to SI: `0.6 * units::mm` is a length in metres.
/// The library itself holds SI only.
namespace hapticut::units {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double mm = 1e-3;                ///< [m]
inline constexpr double um = 1e-6;                ///< [m]
inline constexpr double ms = 1e-3;                ///< [s]
inline constexpr double mm_per_s = 1e-3;          ///< [m/s]
inline constexpr double rpm = 2 * kPi / 60;       ///< [rad/s]
inline constexpr double deg = kPi / 180;          ///< [rad]
inline constexpr double mN_m = 1e-3;              ///< [N·m]
inline constexpr double N_mm = 1e-3;              ///< [N·m]
inline constexpr double mm3 = 1e-9;               ///< [m^3]
inline constexpr double N_per_mm3_per_mm = 1e12;  ///< [N/m^4] stiffness of the volumetric foundation

}  // namespace hapticut::units
