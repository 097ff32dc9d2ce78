// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hapticut/force/law.hpp"
#include "hapticut/workpiece/cut_voxel.hpp"

/// @file
/// Cutting energy that depends on the chip. A lip that takes a chip of thickness h spends, per volume,
///
///     u_eff = u (1 + h_e/h + sqrt(h_s/h)),    h = v/f_z,   f_z = z |omega|/(2 pi)
///
/// v is the speed at which the interface recedes, z the number of lips. h_e is a force per length of lip, u h_e, which
/// ploughs and removes nothing; h_s is the size effect of thin chips. At a pressure p and a slip s the interface
/// therefore recedes by
///
///     q = kappa s p/u = v + sqrt(h_s f_z v) + h_e f_z        v(q) = 0 up to q = h_e f_z, and then y^2,
///                                                            y = 2 (q - h_e f_z)/(b + sqrt(b^2 + 4 (q - h_e f_z))),
///                                                            b = sqrt(h_s f_z)
///
/// In the elastic layer of the foundation the pressure at depth t is k_v t^2/2. A voxel between the depths t_1 < t_2
/// contributes v(q(t_2)) - v(q(t_1)), so the sum over a column is v at the pressure on its top, however thick the layer
/// is. Between two depths this equals the law of a constant energy u/sigma_c above a threshold q_0, the chord of v(q):
///
///     sigma_c = (y_1 + y_2)/(y_1 + y_2 + b)         q_0 = h_e f_z + b y_1 y_2/(y_1 + y_2)
///
/// so the equation of the layer (LayerRecession) does not change. In a voxel that holds the bottom of the layer, any
/// chord through the top gives the same sum. There the other end of the chord is the speed of the head, to which the
/// recession tends. It is the mean velocity over some time (HeadMotion::ripple), because otherwise the root would make
/// cuts cheaper the more the tool of a coupling trembles. It is reduced when more than half of the voxel is in the
/// layer, to zero when all of it is.
///
/// When a head passes along a wall that it has finished, it takes no chip, and the constants of thin chips do not
/// apply: the wall would press on the head for ever, with the pressure at which edges cut. So within half a degree of
/// the feed, h_e and h_s are scaled with the speed towards the surface (`chip_factor`). docs/decisions/0010-chips.md
/// compares this with the alternatives.
namespace hapticut {

/// The energy and the threshold depth of the cut of a voxel, in place of u and w0.
template <class Real>
struct ChipChord {
  Real energy;         ///< [J/m^3] u/sigma_c
  CutDepth<Real> cut;  ///< [m] depth from which the pressure exceeds the threshold, p_e included

  static constexpr Real kMinRoots = Real(1e-9);  ///< [sqrt(m/s)] of y_1 + y_2
  static constexpr Real kGrazing =
      Real(0.01);  ///< [1] part of the feed towards a surface from which on lips take a chip
  static constexpr Real kMinFeed = Real(1e-6);  ///< [m/s] of a head that only presses

  /// [1] Factor of h_e and h_s.
  /// @param speed  [m/s] of the head towards the surface or away from it
  /// @param feed   [m/s] speed of the head in any direction
  static Real chip_factor(Real speed, Real feed) {
    return std::min(Real(1), (std::abs(speed) / kGrazing + kMinFeed) / std::max(feed, kMinFeed));
  }

  /// @param tooth_rate  [1/s] f_z
  /// @param rate        [1/(m s)] kappa k_v s/(2 u) >= 0, with the damping's factor
  /// @param top,bottom  [m] depths of the part of a voxel; bottom <= 0: it holds the bottom of the layer
  /// @param speed,feed  [m/s] of the head towards the surface or away from it, and in any direction
  static ChipChord of(const ContactMaterial& material, Real tooth_rate, Real rate, Real top, Real bottom, Real speed,
                      Real feed) {
    const Roots root_of_speed(material, tooth_rate, rate, speed, feed);
    const Real b = root_of_speed.b, at_top = root_of_speed(top);
    const Real outside =
        std::min(Real(1), -2 * bottom / (top - bottom));  // [1] 1 when half of the voxel or more is below the layer
    const Real other = bottom > 0 ? root_of_speed(bottom) : outside * std::sqrt(std::max(Real(0), speed));
    const Real dearer = 1 + b / std::max(at_top + other, kMinRoots);  // 1/sigma_c
    const Real excess = rate > 0 ? at_top * at_top * dearer / rate : Real(0);
    return {material.cutting_energy * dearer, {std::sqrt(std::max(Real(0), top * top - excess)), excess}};
  }

  /// [m/s] Speed v(q) at which a column recedes whose top is at a depth; without chips where `tooth_rate` is 0.
  static Real recession_at(Real depth, const ContactMaterial& material, Real tooth_rate, Real rate, Real speed,
                           Real feed) {
    const Real root = Roots(material, tooth_rate, rate, speed, feed)(depth);
    return root * root;
  }

 private:
  /// sqrt(v(q)) at depths of the layer.
  struct Roots {
    Real rate, edge, square, b, w0;
    Roots(const ContactMaterial& material, Real tooth_rate, Real cut_rate, Real speed, Real feed) : rate(cut_rate) {
      const Real chips = tooth_rate * chip_factor(speed, feed);
      edge = material.edge_length * chips, square = material.size_length * chips;
      b = std::sqrt(square), w0 = material.cutting_depth;
    }
    Real operator()(Real depth) const {
      const Real q = std::max(Real(0), rate * (depth * depth - w0 * w0) - edge);
      return 2 * q / std::max(b + std::sqrt(square + 4 * q), kMinRoots);
    }
  };
};

}  // namespace hapticut
