// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/lumped.hpp"

namespace hapticut {

/// A round burr whose contact is Hertz's (Agus, Giachetti, Gobbetti, Zanetti, Zorcolo: Mastoidectomy simulation with
/// combined visual and haptic feedback, 2002; [1], [2] of the thesis).
///
/// The burr of radius R describes the bone by two sums over the voxels inside it. They give the depth h and the
/// direction n of an equivalent flat surface:
///
///     M0 = Sum rho_i = pi R^3 (h/R)^2 (1 - h/3R),   M1 = Sum rho_i r_i = |M1| n
///     F_e = -C1 R^2 (h/R)^1.5 n                       elastic force on the burr
///     F_mu: Coulomb friction of F_e along the slip of the surface, ratio kappa of the materials
///     mass flux = alpha mu P omega r                  power of the friction over the cost of a volume: 1/alpha = u
///
/// The original distributes the flux over the contact like Hertz's pressure. Here it is distributed like depth times
/// slip, the removal of all laws of the library, with the same total.
class HertzianBurrLaw final : public LumpedLaw {
 public:
  /// The number of the law, which has no default.
  struct Constants {
    double stiffness = 0;  ///< [Pa] constant C1 of the elastic force C1 R^2 (h/R)^1.5
  };

  /// @param stiffness  [Pa] > 0, C1
  /// @throws Error naming the constant, its value and the allowed range
  explicit HertzianBurrLaw(double stiffness) : HertzianBurrLaw(Constants{stiffness}) {}
  explicit HertzianBurrLaw(const Constants& constants);
  [[nodiscard]] const Constants& constants() const { return c_; }

  void require_head(const ToolHead& head) const override {
    if (head.ball() == nullptr)
      throw Error("HertzianBurrLaw was given " + head.description() +
                  "; it has a formula for a round burr only. Choose SphereHead, or FoundationLaw for other heads.");
  }

  [[nodiscard]] LumpedForce lump(const ToolHead& head, const HeadMotion& m,
                                 const ContactMoments& moments) const noexcept override {
    const double R = head.ball()->radius;
    const double arm = moments.first_moment.norm();
    if (!(arm > 1e-9 * R * moments.volume)) return {};  // buried: no direction
    const Vec3 n = moments.first_moment / arm;
    const double h = ContactMechanicsLaw::depth_of(head, moments.volume);
    const double half = 0.5 * m.velocity.cast<double>().dot(n) * double(m.duration);
    LumpedForce lumped;
    lumped.elastic_before = energy(R, std::max(0.0, h - half));
    lumped.elastic = energy(R, std::max(0.0, h + half));
    const double normal = force(R, h);
    lumped.wrench_T.force = -normal * n;
    add_rubbing(m, moments, normal, lumped);
    return lumped;
  }

  /// [N] at depth h [m] of a burr of radius R [m].
  [[nodiscard]] double force(double R, double h) const { return c_.stiffness * R * R * std::pow(h / R, 1.5); }

  /// [J] Integral of the force over h.
  [[nodiscard]] double energy(double R, double h) const { return force(R, h) * h / 2.5; }

 private:
  Constants c_;
};

constexpr auto fields_of(Of<HertzianBurrLaw::Constants>) {
  return std::tuple{field("stiffness", &HertzianBurrLaw::Constants::stiffness, "Pa", Range::positive(),
                          "constant C1 of the elastic force C1 R^2 (h/R)^1.5")};
}

inline HertzianBurrLaw::HertzianBurrLaw(const Constants& constants) : c_(constants) {
  require_fields_within(c_, "HertzianBurrLaw::");
}

}  // namespace hapticut
