// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/laws/lumped.hpp"

namespace hapticut {

/// A twist drill that chips bone (Allotta, Belmonte, Bosio, Dario 1996; [33] of the thesis).
///
///     F = K_s a (D/2) sin(beta/2),   M = K_s a D^2/8,   a = 2 pi v_f/|omega|
///
/// D is the diameter of the drill in the material, beta its point angle, v_f its feed speed towards the tip. M acts
/// against the spin, F pushes back along the axis; when the drill retreats or stands, both are zero. M omega = K_s pi
/// D^2/4 v_f is exactly the cost of the fed volume, if K_s is the material's u. F v_f is lost to friction. Material
/// with cutting ratio 0 is not cut, whatever the power. This is the steady state of the default law with kappa =
/// 1/sin(beta/2) and p_e = 0 (C31).
///
/// A cone is a drill with a point angle of twice its half angle, a flat head one of 180 degrees. A profile is a drill
/// if only a straight edge at its tip cuts, as that of `twist_drill_head`. A hollow tip, whose rim leads, has a point
/// angle above 180 degrees.
class TwistDrillLaw final : public LumpedLaw {
 public:
  /// The numbers of the law.
  struct Constants {
    double specific_energy = 1e8;           ///< [J/m^3] K_s, specific energy of the chips
    double max_feed_per_revolution = 1e-3;  ///< [m] feed per revolution above which thrust and torque stay constant
  };

  /// @throws Error naming the constant, its value and the allowed range
  explicit TwistDrillLaw(const Constants& constants);
  [[nodiscard]] const Constants& constants() const { return c_; }

  void require_head(const ToolHead& head) const override {
    if (!(point_angle(head) > 0))
      throw Error(
          "TwistDrillLaw was given " + head.description() +
          ", which has no point angle; it has formulas for a cone, a flat head and a profile of which only a straight "
          "edge at the tip cuts. Choose one of these, such as twist_drill_head, or FoundationLaw.");
  }

  [[nodiscard]] LumpedForce lump(const ToolHead& head, const HeadMotion& m,
                                 const ContactMoments& moments) const noexcept override {
    const double feed = std::max(0.0, -double(m.velocity.z())), spin = double(m.spin);
    if (spin == 0 || feed == 0) return {};
    const double radius = std::min(moments.radius, head.cutting_radius());
    const double a = std::min(2 * units::kPi * feed / std::abs(spin), c_.max_feed_per_revolution);
    const double couple = torque(2 * radius, a);
    LumpedForce lumped;
    lumped.wrench_T.force.z() = thrust(2 * radius, a, point_angle(head));
    lumped.wrench_T.torque.z() = -std::copysign(couple, spin);
    lumped.damped = lumped.wrench_T.force.z() * feed * double(m.duration);
    const double power =
        std::max(0.0, couple * (std::abs(spin) + std::copysign(1.0, spin) * double(m.angular_velocity.z())));
    if (moments.rubbing_speed > 0)
      lumped.cutting_power = power;
    else
      lumped.damped += power * double(m.duration);
    return lumped;
  }

  /// [N] Thrust of a drill of diameter D [m] and point angle [rad] at feed per revolution a [m].
  [[nodiscard]] double thrust(double diameter, double a, double point_angle) const {
    return c_.specific_energy * a * diameter / 2 * std::sin(point_angle / 2);
  }
  /// [N·m] Torque of a drill of diameter D [m] at feed per revolution a [m].
  [[nodiscard]] double torque(double diameter, double a) const {
    return c_.specific_energy * a * diameter * diameter / 8;
  }
  /// [rad] full angle of the point; 0: the head is not a drill.
  [[nodiscard]] static double point_angle(const ToolHead& head) {
    return head.visit([](const auto& shape) { return angle_of(shape); });
  }

 private:
  [[nodiscard]] static double angle_of(const ConeHead& cone) { return 2 * cone.half_angle; }
  [[nodiscard]] static double angle_of(const FlatHead& /*its bottom is the point*/) { return units::kPi; }
  [[nodiscard]] static double angle_of(const auto& shape) {
    const auto& edges = shape.edges();
    const ProfileEdge& point = edges.front();
    const auto cutting = [](const ProfileEdge& edge) { return edge.kind == EdgeKind::cutting; };
    if (!cutting(point) || point.radius != 0 || std::count_if(edges.begin(), edges.end(), cutting) > 1) return 0;
    return 2 * std::atan2(point.rho, point.z - shape.tip());
  }

  Constants c_;
};

constexpr auto fields_of(Of<TwistDrillLaw::Constants>) {
  using C = TwistDrillLaw::Constants;
  return std::tuple{
      field("specific_energy", &C::specific_energy, "J/m^3", Range::positive(), "K_s, specific energy of the chips"),
      field("max_feed_per_revolution", &C::max_feed_per_revolution, "m", Range::positive(),
            "feed per revolution above which thrust and torque stay constant"),
  };
}

inline TwistDrillLaw::TwistDrillLaw(const Constants& constants) : c_(constants) {
  require_fields_within(c_, "TwistDrillLaw::");
}

}  // namespace hapticut
