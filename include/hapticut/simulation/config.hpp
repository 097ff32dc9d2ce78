// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/simulation/output.hpp"
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// Where on its way the head meets the material in a sub-step.
enum class ContactTime {
  middle,  ///< second order in dt: for poses that come from a hand or a script (default)
  end      ///< first order, but unconditionally stable for poses that were solved for: what an implicit coupling needs
};

constexpr auto names_of(Of<ContactTime>) {
  using enum ContactTime;
  return std::array{
      Named{middle, "middle"},
      Named{end, "end"},
  };
}

/// [s/m] What keeps burs calm behind a coupling at any rate, device and bone, with some margin; of a quiet press
/// nothing is felt of it (docs/decisions/0021-hand-to-the-end.md).
inline constexpr double kCalmingDamping = 300;

/// How a simulation computes. Every field has a default that works; all are checked when the simulation is made.
struct SimulationConfig {
  /// That of each material must be within 1 ... 1e25. A regularisation, not a material constant: cutting forces do not
  /// depend on it while the engaged layer is thin. 0: a layer of a hundredth of the head's radius in the stiffest of
  /// the materials (`stiffness_for_head`), also when tool or materials are exchanged; where the quadrature is one of
  /// points, kStiffnessOfPoints. A device that is driven without a coupling renders much less: see force/stiffness.hpp.
  double reference_stiffness = 0;

  /// On top of each Material::damping. Behind a coupling the drag of the spin, which follows the contact's force, feeds
  /// a vibration of the tool that the contact has to calm; a device that is driven directly would shake with the noise
  /// of its velocity. Empty: kCalmingDamping where the contact_time is `end`, else 0.
  std::optional<double> contact_damping;

  RemovalLaw removal = RemovalLaw::constant_energy;
  Quadrature quadrature = Quadrature::automatic;

  /// With `end`, springs push harder than what they store in the sub-step: the difference is booked as damping, and the
  /// ledger of each sub-step closes by it; EnergyLedger::entered is what came out of nothing then.
  ContactTime contact_time = ContactTime::middle;

  std::shared_ptr<const ForceLaw> law = std::make_shared<FoundationLaw>();  // never null
  std::optional<DryFriction> friction;

  /// See force/deep_contact.hpp. Only under a law that `holds_deep_contact`, the default one; the others' forces stay
  /// as their formulas give them.
  bool deep_contact = true;

  HandleTorque handle_torque = HandleTorque::full_wrench;
  double handle_torque_scale = 1;

  Effects effects;
  double update_rate = 1000;

  /// About 2.8 kB each. A cavity needs about two per patch of 8 x 8 voxels of its wall.
  std::size_t reserved_blocks = 2048;

  /// Voxels beyond it are removed all the same.
  std::size_t removed_voxel_capacity = 0;

  /// Where the blocks that the head touches hold more, only every n-th strip of 16 voxels is evaluated in a sub-step,
  /// in turn, and counts n times: the deadline holds, the force is that of a coarser quadrature, and
  /// StepStatus::detail_reduced and Contact::level_of_detail, which is n, say so. In a groove cut at n = 5 the force
  /// stays within 7 % (the just noticeable difference) and the removed volume within 2 %. All solid voxels of those
  /// blocks are counted, so n is larger than needed, about twice for a ball of 30 voxels across. Only with the default
  /// law.
  std::size_t voxel_budget = 0;

  bool stage_times = false;

  double min_dt = 1e-6;
  double max_dt = 0.1;

  /// A step that moves the head by more than half a voxel is cut into equal sub-steps.
  int max_sweep = 64;
};

constexpr auto fields_of(Of<SimulationConfig>) {
  using C = SimulationConfig;
  return std::tuple{
      field("reference_stiffness", &C::reference_stiffness, "N/m^4", Range::between(0, 1e25),
            "k_v, foundation stiffness of a material of relative stiffness 1; 0: what suits the head's radius"),
      field("contact_damping", &C::contact_damping, "s/m", Range::between(0, 1e6),
            "chi, Hunt and Crossley's damping of all contact; empty: 300 at the end of a step, 0 at its middle"),
      field("removal", &C::removal, "how material is taken away"),
      field("quadrature", &C::quadrature, "where in a partly filled voxel its force is taken"),
      field("contact_time", &C::contact_time, "where on its way the head meets the material"),
      field("law", &C::law, "the force law"),
      field("friction", &C::friction,
            "dry friction of the standing head, the same everywhere; empty: each material's own"),
      field("deep_contact", &C::deep_contact, "a ball pushed beyond its radius keeps pushing back"),
      field("handle_torque", &C::handle_torque, "how force and torque at the head are felt at the handle"),
      field("handle_torque_scale", &C::handle_torque_scale, "1", Range::between(-1e6, 1e6),
            "zeta of HandleTorque::thesis; no part of the full wrench"),
      field("effects", &C::effects, "what is added to the model's force, and what the output is limited to"),
      field("update_rate", &C::update_rate, "Hz", Range::positive(),
            "at which the step will be called; only the vibration's check needs it"),
      field("reserved_blocks", &C::reserved_blocks, "1", Range::between(1, 1e8),
            "blocks (8^3 voxels) that may become partly cut before Simulation::reserve_blocks has to be called again"),
      field("removed_voxel_capacity", &C::removed_voxel_capacity, "1", Range::between(0, 1e9),
            "longest list of removed voxels of one step; 0: as many as the head holds"),
      field("voxel_budget", &C::voxel_budget, "1", Range::between(0, 1e9),
            "most voxels that one sub-step may evaluate, at least 4096; 0: no limit"),
      field("stage_times", &C::stage_times, "measure Simulation::stage_times"),
      field("min_dt", &C::min_dt, "s", Range::positive(), "shorter steps are rejected"),
      field("max_dt", &C::max_dt, "s", Range::between(0, 1), "longer steps are rejected"),
      field("max_sweep", &C::max_sweep, "1", Range::between(1, 100000),
            "most sub-steps of one step; what needs more is a jump, not a motion, and is rejected"),
  };
}

/// @throws Error naming the field, its value and the allowed range
void validate(const SimulationConfig& config);

/// The same with what is left to the simulation: what `reference_stiffness` 0 and Quadrature::automatic stand for with
/// this head in these materials. Simulation::config is the outcome for those that it has.
[[nodiscard]] SimulationConfig complete(SimulationConfig config, const ToolHead& head, const MaterialTable& materials);

}  // namespace hapticut
