// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"

/// @file
/// Dry friction of a head that does not spin (thesis 5.2.3 and Table 5.2; docs/model.md, friction of the standing
/// head).
namespace hapticut {

/// Dry friction between the standing head and the material.
///
/// mu_s is the force along the surface, per newton across it, at which the head begins to slide; mu_d is the force that
/// keeps it sliding. With 0.3, a head that is pressed with 1 N resists up to 0.3 N. Friction belongs to a pair of
/// surfaces. All materials of a workpiece meet the same head, so each material has its own numbers, and no rule
/// combines those of two surfaces. Only a head that stands or nearly stands needs them: a spinning head slides
/// everywhere, and `Material::cutting_ratio` describes its drag.
struct DryFriction {
  double static_friction = 0.3;   ///< [1] mu_s, not below dynamic_friction
  double dynamic_friction = 0.3;  ///< [1] mu_d
  /// [N/m] k_t of the sticking anchor; 0: in proportion to the stiffness along the normals
  double tangential_stiffness = 0;
};

constexpr auto fields_of(Of<DryFriction>) {
  using F = DryFriction;
  return std::tuple{
      field("static_friction", &F::static_friction, "1", Range::not_negative(), "mu_s, not below dynamic_friction"),
      field("dynamic_friction", &F::dynamic_friction, "1", Range::not_negative(), "mu_d"),
      field("tangential_stiffness", &F::tangential_stiffness, "N/m", Range::not_negative(),
            "k_t of the sticking anchor; 0: in proportion to the stiffness along the normals"),
  };
}

/// @throws Error naming the constant, its value and the allowed range
inline void validate(const DryFriction& friction) {
  require_fields_within(friction, "DryFriction::");
  if (friction.dynamic_friction > friction.static_friction)
    throw Error(
        "DryFriction::dynamic_friction"_name + " = " +
        format_number(friction.dynamic_friction, friction.static_friction) + "; must not exceed static_friction = " +
        format_number(friction.static_friction, friction.dynamic_friction) + ". Lower it, or raise static_friction.");
}

/// [1] Stiffness of an elastic contact across its normal over that along it, 2 (1 - nu)/(2 - nu) for nu = 0.3 (Mindlin
/// 1949, J Appl Mech 16:259).
inline constexpr double kTangentialShare = 0.82;

/// [m/s] Speed of the head's rim from which on the cutting ratio alone describes the tangential force.
inline constexpr double kFullSpinSpeed = 0.01;

/// Fraction of the friction that is dry friction of a standing head: 1 while the spindle stands, 0 from a rim speed of
/// `kFullSpinSpeed` on, and a smooth step between.
///
/// While it is between 0 and 1, dry friction acts with this fraction of its coefficients and the cutting ratio with the
/// rest, so starting and stopping the spindle changes the force continuously.
/// @param spin    [rad/s]
/// @param radius  [m] maximum radius of the head
[[nodiscard]] inline double dry_friction_fraction(double spin, double radius) {
  const double t = std::min(1.0, std::abs(spin) * radius / kFullSpinSpeed);
  return 1 - t * t * (3 - 2 * t);
}

}  // namespace hapticut
