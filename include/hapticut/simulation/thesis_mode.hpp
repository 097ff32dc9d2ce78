// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/simulation/config.hpp"

namespace hapticut {

/// Parameters that the thesis leaves to the scene.
struct ThesisMode {
  ThesisLaw::Constants law;            ///< springs, dampers, spin torque and removal
  double update_rate = 1000;           ///< [Hz] > 0 at which the step will be called
  double tool_mass = 0;                ///< [kg] >= 0; 0: no weight
  Vec3 center_of_mass = Vec3::Zero();  ///< [m] the tool's centre of mass from Ho, in H
  double handle_torque_scale = 1;      ///< [1] zeta of its handles
};

/// The whole model of the thesis (Uener 2007, chapters 5 and 6) as one configuration, to reproduce it and to compare
/// with it:
///
/// | eqs. | what | where |
/// |---|---|---|
/// | 5.5-5.8 | springs and dampers of whole voxels, spin torque | ThesisLaw |
/// | 5.15-5.16 | a voxel is removed when its power reaches a threshold proportional to its stiffness | ThesisLaw |
/// | Table 5.2 | stick and slip of the standing head | Material::static_friction, dynamic_friction |
/// | 5.9 | weight, if the tool has a mass | Gravity |
/// | 5.10 | 0.3 N at 500 Hz along the spindle (6.5) | Vibration |
/// | 5.11-5.14 | torque at the handle | HandleTorque::thesis |
/// | Table 6.1 | filter of 0.5 N and 0.005 N | DeltaFilter |
///
/// Stiffness and damping are `Material::relative_stiffness`, > 0 (the thesis has 0 ... 1), and `Material::damping`.
/// Forces are taken at the voxels' centres, however much of them is left, and a ball can pop through (D15). Parts of
/// the thesis that are no longer legible are interpreted; each header says which. Two things differ from the printed
/// text, because they cannot be computed as printed: friction changes to the spin torque while the spindle turns
/// (friction.hpp), and the vibration is left out below 500 Hz / 0.45 = 1111 Hz. At the 1 kHz of the thesis it is zero
/// at every sample (D9), so there it makes no difference.
/// @throws Error naming the field, its value and the allowed range
[[nodiscard]] SimulationConfig thesis_mode(const ThesisMode& mode = {});

}  // namespace hapticut
