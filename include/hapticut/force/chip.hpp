// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/contact/cut_voxel.hpp"

/// @file
/// Cutting energy that depends on the chip. A lip that takes a chip of thickness h spends, per volume,
///
///     u_eff = u (1 + h_e/h + sqrt(h_s/h)),    h = v/f_z,   f_z = z |omega|/(2 pi)
///
/// v is the speed at which the interface recedes, z the number of lips. h_e is a force per length of lip, u h_e, which
/// ploughs and removes nothing; h_s is the size effect of thin chips. At a pressure p and a slip s the interface
/// therefore recedes by
///
///     q = kappa s (p - p_e)/u = v + sqrt(h_s f_z v) + h_e f_z    v(q) = 0 up to q = h_e f_z, and then y^2,
///                                                            y = 2 (q - h_e f_z)/(b + sqrt(b^2 + 4 (q - h_e f_z))),
///                                                            b = sqrt(h_s f_z)
///
/// In the elastic layer of the foundation the pressure at depth t is k_v t^2/2. A voxel between the depths t_1 < t_2
/// contributes v(q(t_2)) - v(q(t_1)), so the sum over a column is v at the pressure on its top, however thick the layer
/// is. Between two depths this equals the law of a constant energy u/sigma_c above a threshold q_0, the chord of v(q):
///
///     sigma_c = (y_1 + y_2)/(y_1 + y_2 + b)         q_0 = h_e f_z + b y_1 y_2/(y_1 + y_2)
///
/// so the equation of the layer (LayerRecession) does not change. In a voxel that contains the bottom of the layer, any
/// chord through the top gives the same sum. There the other end of the chord is the speed of the head, to which the
/// recession tends. It is the mean velocity over some time (HeadMotion::ripple), because otherwise the root would make
/// cuts cheaper the more the tool of a coupling trembles. It is reduced when more than half of the voxel is in the
/// layer, to zero when all of it is.
///
/// When a head passes along a wall that it has finished, it takes no chip, and the constants of thin chips do not
/// apply: the wall would press on the head for ever, with the pressure at which edges cut. So within half a degree of
/// the feed, h_e and h_s are scaled with the speed towards the surface or away from it (`formulas::ChippingLips`).
/// docs/decisions/0010-chips.md compares this with the alternatives.
namespace hapticut {

namespace formulas {
#include "hapticut/formulas/chip.inl"
}  // namespace formulas

using formulas::ChipChord;

}  // namespace hapticut
