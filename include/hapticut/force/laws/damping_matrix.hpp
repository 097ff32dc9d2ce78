// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/force/laws/lumped.hpp"

namespace hapticut {

/// Resistance to the motion of a spinning head (thesis 5.1, 5.2, after its [15]): a viscous force, and a part of it
/// that the spin rotates sideways.
///
///     F = -M V,   M = m (I + mu [omega_hat]x),   m = K_alpha K_beta K_omega K_eps F(H, L)
///
/// The source tabulates the factors K for the head, the material, the speed and the layer; here they are one product,
/// `resistance`. F(H, L), its "function for the contact area", is that area: the filled volume in the head over its
/// maximum depth, which is half a voxel below the deepest centre: a layer of whole voxels would otherwise meet a flat
/// head like a wall, because its volume enters at once. The force needs motion: at rest it is zero, and a surface does
/// not push back. Its only work is -m |V|^2, which cuts while the spindle turns. For any head.
class DampingMatrixLaw final : public LumpedLaw {
 public:
  /// The numbers of the law.
  struct Constants {
    double resistance = 1e8;  ///< [N s/m^3] viscous resistance of the motion per contact area, the product of the K
    double friction = 0.3;    ///< [1] mu, ratio of the sideways force, caused by the spin, to the resistance
  };

  /// @throws Error naming the constant, its value and the allowed range
  explicit DampingMatrixLaw(const Constants& constants);
  [[nodiscard]] const Constants& constants() const { return c_; }

  [[nodiscard]] LumpedForce lump(const ToolHead&, const HeadMotion& m,
                                 const ContactMoments& moments) const noexcept override {
    if (!(moments.depth > 0)) return {};
    const Vec3 V = m.velocity.cast<double>();
    const double factor = c_.resistance * moments.volume / (moments.depth + double(m.voxel_size) / 2);
    const Vec3 axis(0, 0, m.spin == 0 ? 0.0 : std::copysign(1.0, double(m.spin)));
    LumpedForce lumped;
    lumped.wrench_T.force = -factor * (V + c_.friction * axis.cross(V));
    const double power = factor * V.squaredNorm();
    // The force acts at To, so only V does work.
    if (moments.rubbing_speed > 0 && m.spin != 0)
      lumped.cutting_power = power;
    else
      lumped.damped = power * double(m.duration);
    return lumped;
  }

 private:
  Constants c_;
};

constexpr auto fields_of(Of<DampingMatrixLaw::Constants>) {
  using C = DampingMatrixLaw::Constants;
  return std::tuple{
      field("resistance", &C::resistance, "N s/m^3", Range::positive(),
            "viscous resistance of the motion per contact area, the product of the K"),
      field("friction", &C::friction, "1", Range::not_negative(),
            "mu, ratio of the sideways force, caused by the spin, to the resistance"),
  };
}

inline DampingMatrixLaw::DampingMatrixLaw(const Constants& constants) : c_(constants) {
  require_fields_within(c_, "DampingMatrixLaw::");
}

}  // namespace hapticut
