// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/units.hpp"

/// @file
/// C44 and C45: how much grain and passing teeth make a force vary.
namespace hapticut::closed_forms {

/// C44: coefficient of variation of the force in a material whose cutting energy varies by sigma over cells of edge l,
/// `sigma l/sqrt(A)`. For cells that are small compared with the contact.
/// @param grain         [1] sigma
/// @param grain_length  [m] l
/// @param area          [m^2] A = (Int f dA)^2/Int f^2 dA of the force f per area, along the whole force
[[nodiscard]] inline double grain_variation(double grain, double grain_length, double area) {
  return grain * grain_length / std::sqrt(area);
}

/// C44: the area A of the side of a cylinder with diamond grains that mills a slot as wide as itself, `(2 pi/3) R H`:
/// the pressure is proportional to cos(q), q the angle from the feed, and f to its square. For the force along the feed
/// alone it is A/(1 + kappa^2/3), for thin chips of blades, whose pressure goes as the root of cos(q), 2.29 R H.
/// @param R, H  [m] radius of the cylinder, depth of the slot
/// @return [m^2]
[[nodiscard]] inline double cutting_area_of_a_slot(double R, double H) { return 2 * units::kPi / 3 * R * H; }

/// C45: coefficient of variation of a force that passing teeth change, `sqrt((a_1^2 + a_z^2)/2)`; the mean stays.
/// @param once_per_turn, per_tooth  [1] a_1 and a_z, of those parts that a step of the loop does not leave out
[[nodiscard]] inline double tooth_passing_variation(double once_per_turn, double per_tooth) {
  return std::sqrt((once_per_turn * once_per_turn + per_tooth * per_tooth) / 2);
}

}  // namespace hapticut::closed_forms
