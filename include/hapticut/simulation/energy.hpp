// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// Where the work went (docs/model.md, energy ledger). All in [J]. All terms are accumulated since construction or
/// Simulation::reset, except the stored energies, which are those at the end of the last step. Losses are never
/// negative, with two exceptions: `damping`, when the given velocity lags so far behind the poses that the damper
/// pulls; and `released` with RemovalLaw::elastic_release, which subtracts an estimate of the energy that helped
/// cutting (measured: down to -0.6 % of the work). How the work is divided among the losses depends on the stiffness:
/// in bone, a stiffer foundation moves work from `cutting` to `rubbing`. The sum of the losses does not depend on it.
///
///     hand_work + motor_work + credited + entered = stored() + losses()
///
struct EnergyLedger {
  // Work on the tool
  double hand_work = 0;   ///< [J] work done by the hand on the tool
  double motor_work = 0;  ///< [J] work done by the spindle motor on the tool

  // Stored
  double elastic = 0;   ///< [J] stored in the foundation now
  double anchored = 0;  ///< [J] stored in the anchor of dry friction now

  // Losses
  /// [J] specific cutting energy times removed volume; thin chips cost a multiple of it, the part of their layer above
  /// its threshold
  double cutting = 0;
  /// [J] compressive strength times crushed volume, less what came under the surface without being pressed there
  double crushed = 0;
  /// [J] elastic energy of removed material that did not help cutting.
  /// With ContactTime::middle also that of crushed material as it leaves (negative `entered`), beyond what entered
  /// before.
  double released = 0;
  /// [J] Hunt-Crossley damping, and the excess work of springs that are evaluated at the end of a sub-step
  double damping = 0;
  /// [J] tangential work that removes nothing: of edges, of thin chips below the threshold of their layer, on smooth
  /// sides and walls, under the edge pressure, with removal off
  double rubbing = 0;
  double sliding = 0;  ///< [J] dissipated by dry friction of the standing head

  // Corrections
  /// [J] cutting energy of material that is removed without work: the last millionth of a voxel (with other laws than
  /// FoundationLaw a thousandth), and rounding errors of single precision
  double credited = 0;

  /// [J] elastic energy of material that entered or left the head without work.
  /// Elastic energy of material that came under the cutting surface without having been pressed there, less that of
  /// material that left it while still pressed. This happens when the tool appears inside material, and when material
  /// passes a face behind which the depth does not begin at zero (the side of FlatRule::bottom_only, the base of a
  /// cone). Otherwise it is zero within the error of the quadrature. `imbalance` and `closure` show it, with
  /// the other sign. With ContactTime::end it is the part that `damping` did not take in the same sub-step.
  double entered = 0;

  /// [J] sum of the magnitudes of hand_work, motor_work and entered of each sub-step.
  /// Counts energy that came in even if it went out again, so it only grows. An imbalance is judged relative to it.
  double turnover = 0;

  /// [J] stored in springs now
  [[nodiscard]] double stored() const { return elastic + anchored; }
  /// [J] that became heat, chips and new surface
  [[nodiscard]] double losses() const { return cutting + crushed + released + damping + rubbing + sliding; }

  /// [J] work that no term accounts for; `-entered` within single precision.
  [[nodiscard]] double imbalance() const { return hand_work + motor_work + credited - stored() - losses(); }

  /// [1] imbalance relative to the turnover, so also -entered/turnover within single precision; 0 before any work.
  [[nodiscard]] double closure() const { return turnover > 0 ? imbalance() / turnover : 0.0; }
};

constexpr auto fields_of(Of<EnergyLedger>) {
  using E = EnergyLedger;
  return std::tuple{
      field("hand_work", &E::hand_work, "J", "work done by the hand on the tool"),
      field("motor_work", &E::motor_work, "J", "work done by the spindle motor on the tool"),
      field("elastic", &E::elastic, "J", "stored in the foundation now"),
      field("anchored", &E::anchored, "J", "stored in the anchor of dry friction now"),
      field("cutting", &E::cutting, "J",
            "specific cutting energy times removed volume; thin chips cost a multiple of it, the part of their layer "
            "above its threshold"),
      field("crushed", &E::crushed, "J",
            "compressive strength times crushed volume, less what came under the surface without being pressed there"),
      field("released", &E::released, "J", "elastic energy of removed material that did not help cutting"),
      field("damping", &E::damping, "J",
            "Hunt-Crossley damping, and the excess work of springs that are evaluated at the end of a sub-step"),
      field(
          "rubbing", &E::rubbing, "J",
          "tangential work that removes nothing: of edges, of thin chips below the threshold of their layer, on smooth "
          "sides and walls, under the edge pressure, with removal off"),
      field("sliding", &E::sliding, "J", "dissipated by dry friction of the standing head"),
      field("credited", &E::credited, "J",
            "cutting energy of material that is removed without work: the last millionth of a voxel (with other laws "
            "than FoundationLaw a thousandth), and rounding errors of single precision"),
      field("entered", &E::entered, "J", "elastic energy of material that entered or left the head without work"),
      field("turnover", &E::turnover, "J",
            "sum of the magnitudes of hand_work, motor_work and entered of each sub-step"),
  };
}

}  // namespace hapticut
