// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/simulation/output.hpp"
#include "hapticut/tool/handle.hpp"

namespace hapticut {

/// Where on its way the head meets the material in a sub-step.
enum class ContactTime {
  middle,  ///< second order in dt: for poses that come from a hand or a script (default)
  end      ///< first order, but unconditionally stable for poses that were solved for: what an implicit coupling needs
};

/// How a simulation computes. Every field has a default that works; all are checked when the simulation is made.
struct SimulationConfig {
  /// [N/m^4] > 0, k_v of a material of relative stiffness 1; that of each material must be within 1 ... 1e25. A
  /// regularisation, not a material constant: cutting forces do not depend on it while the engaged layer is thin. See
  /// force/stiffness.hpp for the bounds that accuracy and a directly driven device put on it.
  double reference_stiffness = 1e13;

  RemovalLaw removal = RemovalLaw::constant_energy;
  Quadrature quadrature = Quadrature::centroid;

  /// With `end`, springs that are being pressed push harder than what they store in the sub-step; the difference is
  /// booked as damping. Laws of one's own that do not read HeadMotion::lead store what they would half a sub-step
  /// later, and the difference is booked as EnergyLedger::entered.
  ContactTime contact_time = ContactTime::middle;

  /// The force law; null: FoundationLaw.
  std::shared_ptr<const ForceLaw> law;

  /// Dry friction of the standing head, the same everywhere; empty: each material's own.
  std::optional<DryFriction> friction;

  /// A ball pushed beyond its radius keeps pushing back (force/deep_contact.hpp), under a law that
  /// `holds_deep_contact`: the default one. The others' forces stay as their formulas give them.
  bool deep_contact = true;

  HandleTorque handle_torque = HandleTorque::full_wrench;
  double handle_torque_scale = 1;  ///< [1] finite: zeta of HandleTorque::thesis; no part of the full wrench

  /// What is added to the model's force, and what the output is limited to.
  Effects effects;
  double update_rate = 1000;  ///< [Hz] > 0 at which the step will be called; only the vibration's check needs it

  /// Blocks (8^3 voxels) that may become partly cut before `Simulation::reserve_blocks` has to be called again; about
  /// 2.8 kB each. A cavity needs about two per patch of 8 x 8 voxels of its wall.
  std::size_t reserved_blocks = 2048;

  /// Longest list of removed voxels of one step; 0: as many as the head holds. Voxels beyond it are removed all the
  /// same.
  std::size_t removed_voxel_capacity = 0;

  /// Most voxels that one sub-step may evaluate; 0: no limit. Where the blocks that the head touches hold more, only
  /// every second (third ...) strip of 16 voxels is evaluated in a sub-step, in turn, and counts twice (three times
  /// ...): the deadline holds, the force is that of a coarser quadrature, and StepStatus::detail_reduced and
  /// Contact::turns say so. In a groove cut with five turns the force stays within 7 % (the just noticeable
  /// difference) and the removed volume within 2 %. All solid voxels of those blocks are counted, so the turns are more
  /// than needed, about twice as many for a ball of 30 voxels across. Only with the default law.
  std::size_t voxel_budget = 0;

  bool stage_times = false;  ///< measure Simulation::stage_times

  double shortest_dt = 1e-6;  ///< [s] steps outside shortest_dt ... longest_dt are rejected
  double longest_dt = 0.1;    ///< [s]

  /// A step that moves the head by more than half a voxel is cut into equal sub-steps; one that needs more than this
  /// many is a jump, not a motion, and is rejected.
  int longest_sweep = 64;
};

/// @throws Error naming the field, its value and the allowed range
void validate(const SimulationConfig& config);

}  // namespace hapticut
