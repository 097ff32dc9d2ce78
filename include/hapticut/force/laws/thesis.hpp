// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/core/description.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/stiffness.hpp"

namespace hapticut {

/// The model of the thesis as printed (Uener 2007, eqs. 5.5-5.8, 5.15, 5.16), to reproduce it and to compare with it.
///
/// For every voxel i inside the head, whole or partly filled, of depth w, direction n and material stiffness k_i:
///
///     F_i   = -k_i l w_i n_i - b_i V                                      spring and damper of one voxel
///     F     = Sum F_i,   T = Sum (X_i - To) x F_i + T_spin z
///     T_spin = -lambda sgn(omega) (|omega|/omega_0)^m R Sum k_i l w_i     omega_0 = 1 rad/s
///     P_i   = lambda (|omega|/omega_0)^m R k_i l w_i |omega|              power generated at the voxel
///     voxel i is removed, whole and in this step, iff  P_i >= c k_i       power required
///
/// b_i = b + chi_i k_i l0^2: b is the same in all materials; chi is Material::damping, and its part is the damper that
/// Hunt and Crossley's spring has at the depth l0 in a voxel of l0.
///
/// The thesis gives no number for c. Here a force F_c and a speed omega_c give it, with which a flat head of R_1 = 1 mm
/// begins to cut a material of stiffness 1:
///
///     c = lambda (omega_c/omega_0)^m omega_c R_1 n_c l^2,   F_c = pi R_1^2 k_1 Sum_(j = 0)^(j < n_c) (n_c - j)
///
/// n_c is the depth in voxels, j counts the layers of voxels below the head, and k_1 = kStiffnessOfPoints l0^2. So
/// voxels go that are deeper than w_c = (omega_c/|omega|)^(m+1) (R_1/R) n_c l. F_c does not depend on the voxel size,
/// because c grows as l^2. It belongs to a reference_stiffness of kStiffnessOfPoints, and grows with it. A material of
/// stiffness s begins to be cut at s F_c. Balls and cones begin at less, the less the smaller the voxels (D1). lambda
/// is in both powers, so it changes the torque and not what is cut.
///
/// Interpretations of the text: the repulsive sign (as printed, the springs pull the tool in); the arm X_i - To (along
/// the spring, as printed, the torque is zero, D3); the second lines of 5.6-5.8, of which only a constant lambda, a
/// power of the spindle's speed and a cross product are legible; and the required power, "related to the stiffness", as
/// proportional to it. V is the velocity of the head as the device gives it, R the maximum radius of the head.
///
/// k_i = k_v l0^2, with k_v = relative stiffness times SimulationConfig::reference_stiffness, so thesis and default
/// model agree at the voxel size l0. At other sizes they differ: the sums grow as l^-2 and, for the damper, l^-3 under
/// refinement (D1, D2). Removal costs no energy (D7): the ledger books the springs' energy of removed voxels as
/// released, the spin torque's work as rubbing, the damper's as damping. The damper follows the hand's velocity, not
/// the slip of the surface (D10). So when the head rotates, with the handpiece or the spindle, the damper may give
/// energy; it is only dissipative for a head that does not rotate.
class ThesisLaw final : public ForceLaw {
 public:
  /// The numbers of the law.
  struct Constants {
    /// [m] l0, voxel size at which its force equals that of the foundation law
    double reference_voxel_size = 1e-4;
    /// [N s/m] b, damping coefficient of one voxel, on top of that of its material
    double damping = 0;
    /// [1] lambda, ratio of the spin torque to normal force times radius
    double spin_torque = 0.3;
    double spin_exponent = 0;  ///< [1] m, exponent of the spindle speed in the spin torque
    /// [N] F_c, force at which a flat head of 1 mm radius with springs at its bottom begins to cut a material of
    /// relative stiffness 1, if no reference stiffness is set; 0: it removes what it touches
    double cutting_force = 0.5;
    AngularSpeed cutting_speed = 10'000 * units::rpm;  ///< [rad/s] omega_c, speed at which this force is enough
  };

  /// @throws Error naming the constant, its value and the allowed range
  explicit ThesisLaw(const Constants& constants);

  [[nodiscard]] const Constants& constants() const { return c_; }

  /// w_c, the depth from which voxels are removed.
  /// @param radius      [m] maximum of the head, R
  /// @param voxel_size  [m] l
  /// @return [m] infinite when the spindle stands
  [[nodiscard]] double removal_depth(AngularSpeed spin, double radius, double voxel_size) const noexcept {
    if (spin == 0) return std::numeric_limits<double>::infinity();
    const double over = c_.cutting_force / force_of_one(c_.reference_voxel_size);
    const double layers = std::floor((std::sqrt(1 + 8 * over) - 1) / 2);
    const double voxels = layers + (over - layers * (layers + 1) / 2) / (layers + 1);  // n_c
    return std::pow(c_.cutting_speed / std::abs(spin), c_.spin_exponent + 1) * kStatedRadius / radius * voxels *
           voxel_size;
  }

  /// The Constants::cutting_force for a removal depth at cutting_speed.
  [[nodiscard]] static double cutting_force_for(double removal_depth, double radius, double voxel_size,
                                                double reference_voxel_size = 1e-4) {
    const double voxels = removal_depth * radius / (kStatedRadius * voxel_size), layers = std::floor(voxels);
    return force_of_one(reference_voxel_size) * (layers + 1) * (voxels - layers / 2);
  }

  LawTotals evaluate(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) const noexcept override {
    const double l = double(m.voxel_size), dt = double(m.duration), spin = double(m.spin), R = double(m.head_radius);
    const double l0_squared = c_.reference_voxel_size * c_.reference_voxel_size;
    const double spin_ratio = spin == 0 ? 0 : c_.spin_torque * std::pow(std::abs(spin), c_.spin_exponent);
    const bool removes = spin != 0 && m.removal != RemovalLaw::none;
    const double removal_depth = this->removal_depth(spin * units::rad_per_s, R, l);
    const Vec3 V = m.velocity.cast<double>(), Omega = m.angular_velocity.cast<double>(),
               turning = Omega + Vec3(0, 0, spin);
    const Vec3 felt = m.felt_velocity.cast<double>();

    LawTotals totals;
    totals.may_remove = removes;
    double normal_sum = 0;
    for (int i = 0; i < b.lanes(); ++i) {
      const auto n = std::size_t(i);
      b.force_x[n] = b.force_y[n] = b.force_z[n] = 0;
      b.fill_after[n] = b.fill[n];
      if (!(b.fill[n] > 0)) continue;
      const double w = double(b.depth[n]);
      const Vec3 r(double(b.x[n]), double(b.y[n]), double(b.z[n]));
      const Vec3 direction(double(b.normal_x[n]), double(b.normal_y[n]), double(b.normal_z[n]));
      const ContactMaterial& material = materials[b.material_of(i)];
      const double k = double(material.stiffness) * l0_squared, scale = double(b.scale_of(i));
      const Vec3 damper = (c_.damping + double(material.damping) * k * l0_squared) * felt;
      const double normal = scale * k * l * w;
      const Vec3 force = -normal * direction - damper;
      b.force_x[n] = float(force.x());
      b.force_y[n] = float(force.y());
      b.force_z[n] = float(force.z());
      normal_sum += normal;

      const Vec3 velocity = V + Omega.cross(r);
      const double advance = scale * velocity.dot(direction) * dt;
      const double before = std::max(0.0, w - advance / 2), after = std::max(0.0, w + advance / 2);
      totals.energies.elastic_before += 0.5 * k * l * before * before;
      totals.energies.damping += damper.dot(V + turning.cross(r)) * dt;
      if (removes && w >= removal_depth) {  // P_i >= c k_i
        b.fill_after[n] = 0;
        totals.energies.released += 0.5 * k * l * after * after;
      } else {
        totals.energies.elastic += 0.5 * k * l * after * after;
      }
    }
    totals.spin_couple = -std::copysign(spin_ratio * R * normal_sum, spin);
    totals.energies.rubbing = -totals.spin_couple * spin * dt;
    return totals;
  }

 private:
  static constexpr double kStatedRadius = 1e-3;  ///< [m] R_1

  /// [N] pi R_1^2 k_1, of a flat head that is one voxel deep in a material of stiffness 1.
  static double force_of_one(double reference_voxel_size) noexcept {
    return units::kPi * kStatedRadius * kStatedRadius * kStiffnessOfPoints * reference_voxel_size *
           reference_voxel_size;
  }

  Constants c_;
};

constexpr auto fields_of(Of<ThesisLaw::Constants>) {
  using C = ThesisLaw::Constants;
  return std::tuple{
      field("reference_voxel_size", &C::reference_voxel_size, "m", Range::positive(),
            "l0, voxel size at which its force equals that of the foundation law"),
      field("damping", &C::damping, "N s/m", Range::not_negative(),
            "b, damping coefficient of one voxel, on top of that of its material"),
      field("spin_torque", &C::spin_torque, "1", Range::not_negative(),
            "lambda, ratio of the spin torque to normal force times radius"),
      field("spin_exponent", &C::spin_exponent, "1", Range::between(-10, 10),
            "m, exponent of the spindle speed in the spin torque"),
      field("cutting_force", &C::cutting_force, "N", Range::not_negative(),
            "F_c, force at which a flat head of 1 mm radius with springs at its bottom begins to cut a material of "
            "relative stiffness 1, if no reference stiffness is set; 0: it removes what it touches"),
      field("cutting_speed", &C::cutting_speed, "rad/s", Range::positive(),
            "omega_c, speed at which this force is enough"),
  };
}

inline ThesisLaw::ThesisLaw(const Constants& constants) : c_(constants) { require_fields_within(c_, "ThesisLaw::"); }

}  // namespace hapticut
