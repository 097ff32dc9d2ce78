// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

namespace hapticut {

/// Where the work went (docs/model.md, energy ledger). Everything is accumulated since construction, but what is
/// stored, which is that of the end of the last step. All in [J]. No loss is ever negative, but for two: `damping`
/// where the velocity that is given lags behind the poses so far that the damper pulls, and `released` with
/// RemovalLaw::elastic_release, which takes from it what is estimated to have helped cutting; 0.6 % of the work was
/// seen below zero. How losses share the work depends on the stiffness: in bone the stiffer the foundation is, the more
/// of it is `rubbing` in place of `cutting`. Their sum does not.
///
///     hand_work + motor_work + credited + entered = stored() + losses()
///
struct EnergyLedger {
  // Work on the tool
  double hand_work = 0;
  double motor_work = 0;

  // Stored
  double elastic = 0;
  double anchored = 0;

  // Losses
  double cutting = 0;
  double crushed = 0;
  double released = 0;
  double damping = 0;
  double rubbing = 0;
  double sliding = 0;

  // Corrections
  double credited = 0;

  /// Elastic energy of material that came under the cutting surface without having been pressed there, less that of
  /// material that left it still pressed: where the tool appears out of nowhere, and where material passes a face
  /// behind which the depth does not begin at zero (the side of FlatRule::bottom_only, the base of a cone). Else zero
  /// within the error of the quadrature. No work brought it in, so that `closure` does not count it. With
  /// ContactTime::end, what of that is more than `damping` took in the same sub-step.
  double entered = 0;

  /// What came in and went out again as well, so that it only grows; by it an imbalance is judged.
  double turnover = 0;

  /// [J] in springs now
  [[nodiscard]] double stored() const { return elastic + anchored; }
  /// [J] what became heat, chips and new surface
  [[nodiscard]] double losses() const { return cutting + crushed + released + damping + rubbing + sliding; }

  /// [J] work that is found nowhere; `-entered` within single precision.
  [[nodiscard]] double imbalance() const { return hand_work + motor_work + credited - stored() - losses(); }

  /// [1] imbalance relative to the turnover; 0 before any work.
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
            "of removed volume: the specific cutting energy, and where chips are thin as many times it as their "
            "layer takes above its threshold"),
      field("crushed", &E::crushed, "J", "compressive strength times crushed volume"),
      field("released", &E::released, "J", "elastic energy of removed material that did not help cutting"),
      field("damping", &E::damping, "J",
            "Hunt-Crossley damping, and what springs take that are met at the end of a sub-step"),
      field("rubbing", &E::rubbing, "J",
            "tangential work that removes nothing: of edges and of what thin chips take below the threshold of their "
            "layer, on smooth sides and walls, under the edge pressure, with removal off"),
      field("sliding", &E::sliding, "J", "dissipated by dry friction of the standing head"),
      field("credited", &E::credited, "J",
            "cutting energy of what is taken away without work: the last millionth of a voxel (under other laws "
            "than FoundationLaw a thousandth), and what single precision rounds"),
      field("entered", &E::entered, "J", "elastic energy of material that came in or left without having been pressed"),
      field("turnover", &E::turnover, "J", "hand_work, motor_work and entered of each sub-step without their signs"),
  };
}

}  // namespace hapticut
