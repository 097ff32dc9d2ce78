// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <type_traits>

/// @file
/// Factors from the units of the dental chair to SI: `0.6 * units::mm` is a length in metres.
/// The library itself holds SI only.
namespace hapticut {

/// [rad/s] How fast something turns. It is made with its unit, `40000 * units::rpm`, for turns a minute and rad/s are
/// too near each other to be told apart: `Spindle{40000}` does not compile. It reads as a number in rad/s.
class AngularSpeed {
 public:
  constexpr AngularSpeed() = default;
  /// 0, which needs no unit; no other number fits.
  constexpr AngularSpeed(std::nullptr_t /*zero*/) {}        // NOLINT(google-explicit-constructor): as a literal is
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

/// Turns a minute.
inline constexpr AngularSpeed rpm = AngularSpeed::in_rad_per_s(2 * kPi / 60);
inline constexpr AngularSpeed rad_per_s = AngularSpeed::in_rad_per_s(1);

}  // namespace units
}  // namespace hapticut
