// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/laws/lumped.hpp"

namespace hapticut {

/// A rigid punch on an elastic half space (thesis Table 5.1; Boussinesq, Hertz, Sneddon 1965), at depth d:
///
///     flat    F = 2 R E* d                        U = R E* d^2
///     sphere  F = 4/3 E* sqrt(R) d^1.5            U = 8/15 E* sqrt(R) d^2.5
///     cone    F = 2/pi E* tan(alpha) d^2          U = 2/(3 pi) E* tan(alpha) d^3      alpha: half-apex angle
///
/// E* = E/(1 - nu^2). All formulas are for a punch at a right angle to a flat surface; this limits the law, and is the
/// thesis's reason not to use it. d is the depth at which a half space would fill the same volume of the head, along
/// the mean direction into the material. So any contact gives a force, and a perpendicular one gives exactly that of
/// the table. A spinning head rubs under F with the materials' cutting ratio, and the power of the rubbing cuts.
class ContactMechanicsLaw final : public LumpedLaw {
 public:
  /// The number of the law, which has no default.
  struct Constants {
    double effective_modulus = 0;  ///< [Pa] effective modulus E/(1 - nu^2) of the material
  };

  /// @param effective_modulus  [Pa] > 0, E* = E/(1 - nu^2)
  /// @throws Error naming the constant, its value and the allowed range
  explicit ContactMechanicsLaw(double effective_modulus) : ContactMechanicsLaw(Constants{effective_modulus}) {}
  explicit ContactMechanicsLaw(const Constants& constants);
  [[nodiscard]] const Constants& constants() const { return c_; }

  void require_head(const ToolHead& head) const override {
    if (head.visit([](const auto& shape) { return power_of(shape); }) == 0)
      throw Error("ContactMechanicsLaw was given " + head.description() +
                  "; it has formulas for a sphere, a cone and a flat head. Choose one of these, or FoundationLaw.");
  }

  [[nodiscard]] LumpedForce lump(const ToolHead& head, const HeadMotion& m,
                                 const ContactMoments& moments) const noexcept override {
    const Vec3 n = moments.normal();
    const double d = depth_of(head, moments.volume);
    // The force acts at the centroid; about its own axis a head of revolution has no torque of normal forces.
    const Vec3 centroid = moments.first_moment / moments.volume;
    const Vec3 tilting(double(m.angular_velocity.x()), double(m.angular_velocity.y()), 0);
    // Half of its advance along n in this sub-step, for the energies at both ends.
    const double half = 0.5 * (m.velocity.cast<double>() + tilting.cross(centroid)).dot(n) * double(m.duration);
    LumpedForce lumped;
    lumped.elastic_before = energy(head, std::max(0.0, d - half));
    lumped.elastic = energy(head, std::max(0.0, d + half));
    const double normal = force(head, d);
    lumped.wrench_T.force = -normal * n;
    lumped.wrench_T.torque = centroid.cross(lumped.wrench_T.force);
    lumped.wrench_T.torque.z() = 0;
    add_rubbing(m, moments, normal, lumped);
    return lumped;
  }

  /// [N] at depth d [m].
  [[nodiscard]] double force(const ToolHead& head, double d) const {
    return head.visit([&](const auto& shape) { return force_of(shape, c_.effective_modulus, d); });
  }

  /// [J] at depth d [m].
  [[nodiscard]] double energy(const ToolHead& head, double d) const {
    return force(head, d) * d / head.visit([](const auto& shape) { return power_of(shape); });
  }

  /// [m] depth at which a half space fills this volume [m^3] of a head, tip first; at most the height of the head.
  [[nodiscard]] static double depth_of(const ToolHead& head, double volume) {
    return head.visit([&](const auto& shape) { return depth_in(shape, volume); });
  }

 private:
  // The power of d in the energy; 0: the shape has no formula.
  [[nodiscard]] static double power_of(const FlatHead& /*head*/) { return 2; }
  [[nodiscard]] static double power_of(const SphereHead& /*head*/) { return 2.5; }
  [[nodiscard]] static double power_of(const ConeHead& /*head*/) { return 3; }
  [[nodiscard]] static double power_of(const auto& /*head*/) { return 0; }

  [[nodiscard]] static double force_of(const FlatHead& flat, double E, double d) { return 2 * flat.radius * E * d; }
  [[nodiscard]] static double force_of(const SphereHead& sphere, double E, double d) {
    return 4.0 / 3 * E * std::sqrt(sphere.radius) * std::pow(d, 1.5);
  }
  [[nodiscard]] static double force_of(const ConeHead& cone, double E, double d) {
    return 2 / units::kPi * E * std::tan(cone.half_angle) * d * d;
  }
  [[nodiscard]] static double force_of(const auto& /*head*/, double /*E*/, double /*d*/) { return 0; }

  [[nodiscard]] static double depth_in(const FlatHead& flat, double volume) {
    return std::min(volume / (units::kPi * flat.radius * flat.radius), flat.height);
  }
  [[nodiscard]] static double depth_in(const ConeHead& cone, double volume) {
    return std::min(std::cbrt(3 * volume / (units::kPi * std::pow(std::tan(cone.half_angle), 2))), cone.height);
  }
  // pi d^2 (R - d/3) = V is, with z = 1 - d/R and s = V over the ball's volume, z^3 - 3 z + 2 - 4 s = 0; z = 2 cos t.
  [[nodiscard]] static double depth_in(const SphereHead& sphere, double volume) {
    const double fraction = std::clamp(volume / sphere.volume(), 0.0, 1.0);
    return sphere.radius * (1 - 2 * std::cos((2 * units::kPi - std::acos(2 * fraction - 1)) / 3));
  }
  [[nodiscard]] static double depth_in(const auto& /*head*/, double /*volume*/) { return 0; }

  Constants c_;
};

constexpr auto fields_of(Of<ContactMechanicsLaw::Constants>) {
  return std::tuple{field("effective_modulus", &ContactMechanicsLaw::Constants::effective_modulus, "Pa",
                          Range::positive(), "effective modulus E/(1 - nu^2) of the material")};
}

inline ContactMechanicsLaw::ContactMechanicsLaw(const Constants& constants) : c_(constants) {
  require_fields_within(c_, "ContactMechanicsLaw::");
}

}  // namespace hapticut
