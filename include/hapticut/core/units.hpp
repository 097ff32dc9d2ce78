// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <type_traits>

/// @file
/// Conversion factors from practical units to SI: `0.6 * units::mm` is a length in metres. All values inside the
/// library are in SI units.
namespace hapticut {

/// [rad/s] An angular speed. It must be written with its unit, `40000 * units::rpm`, because values in rpm and in rad/s
/// look alike: `Spindle{40000}` does not compile. It converts to a number in rad/s.
class AngularSpeed {
 public:
  constexpr AngularSpeed() = default;
  /// Zero, the only number that needs no unit.
  constexpr AngularSpeed(std::nullptr_t /*zero*/) {}        // NOLINT(google-explicit-constructor): like a literal
  constexpr operator double() const { return rad_per_s_; }  // NOLINT(google-explicit-constructor): a number in rad/s

  [[nodiscard]] static constexpr AngularSpeed in_rad_per_s(double speed) {
    AngularSpeed one;
    one.rad_per_s_ = speed;
    return one;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend constexpr AngularSpeed operator*(Number number, AngularSpeed unit) {
    return in_rad_per_s(double(number) * unit.rad_per_s_);
  }
  constexpr AngularSpeed operator-() const { return in_rad_per_s(-rad_per_s_); }

 private:
  double rad_per_s_ = 0;
};

namespace units {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double mm = 1e-3;                ///< [m]
inline constexpr double um = 1e-6;                ///< [m]
inline constexpr double ms = 1e-3;                ///< [s]
inline constexpr double mm_per_s = 1e-3;          ///< [m/s]
inline constexpr double deg = kPi / 180;          ///< [rad]
inline constexpr double mN_m = 1e-3;              ///< [N·m]
inline constexpr double N_mm = 1e-3;              ///< [N·m]
inline constexpr double mm3 = 1e-9;               ///< [m^3]
inline constexpr double N_per_mm3_per_mm = 1e12;  ///< [N/m^4] stiffness of the volumetric foundation

/// Revolutions per minute.
inline constexpr AngularSpeed rpm = AngularSpeed::in_rad_per_s(2 * kPi / 60);
inline constexpr AngularSpeed rad_per_s = AngularSpeed::in_rad_per_s(1);

}  // namespace units
}  // namespace hapticut
