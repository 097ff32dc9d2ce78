// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace hapticut {

/// Where the work went (docs/model.md, energy ledger). Everything is accumulated since construction, but `elastic` and
/// `anchored`, which are the energies stored at the end of the last step. All in [J]; all losses are never negative.
///
///     hand_work + motor_work + entered + credited
///         = elastic + cutting + released + damping + rubbing + anchored + sliding
///
struct EnergyLedger {
  double hand_work = 0;   ///< work done by the hand on the tool
  double motor_work = 0;  ///< work done by the spindle motor on the tool
  double elastic = 0;     ///< stored in the foundation now
  double cutting = 0;     ///< specific cutting energy times removed volume
  double released = 0;    ///< elastic energy of removed material that did not help cutting
  double damping = 0;     ///< Hunt-Crossley damping
  double rubbing = 0;     ///< tangential work where nothing is cut: below the edge pressure, or with removal off
  double anchored = 0;    ///< stored in the anchor of dry friction now
  double sliding = 0;     ///< dissipated by dry friction of the standing head
  double credited = 0;    ///< cutting energy of the last thousandth of a voxel, which is taken away without work

  /// Elastic energy of material that came under the cutting surface without having been pressed there, less that of
  /// material that left it still pressed: where the tool appears out of nowhere, and where material passes a face
  /// behind which the depth does not begin at zero (the side of FlatRule::bottom_only, the base of a cone). Else zero
  /// within the error of the quadrature.
  double entered = 0;

  /// [J] what the right side lacks; 0 when the ledger closes.
  [[nodiscard]] double imbalance() const {
    return hand_work + motor_work + entered + credited -
           (elastic + cutting + released + damping + rubbing + anchored + sliding);
  }

  /// [1] imbalance relative to what was turned over; 0 before any work.
  [[nodiscard]] double closure() const {
    const double turnover = std::abs(hand_work) + std::abs(motor_work) + std::abs(entered);
    return turnover > 0 ? imbalance() / turnover : 0.0;
  }
};

}  // namespace hapticut
