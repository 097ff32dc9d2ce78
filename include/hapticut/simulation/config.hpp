// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "hapticut/core/description.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/output.hpp"
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// The moment of a sub-step at which the contact is evaluated.
enum class ContactTime {
  middle,  ///< second order in dt: for poses that a hand or a script gives (default)
  end      ///< first order, but unconditionally stable for poses that an implicit coupling has solved for
};

constexpr auto names_of(Of<ContactTime>) {
  using enum ContactTime;
  return std::array{
      Named{middle, "middle"},
      Named{end, "end"},
  };
}

/// [s/m] Contact damping that keeps burs calm behind a coupling, with any device and bone at any rate, with some
/// margin. In a quiet press the hand does not feel it (docs/decisions/0021-hand-to-the-end.md).
inline constexpr double kCalmingDamping = 300;

/// How a simulation computes. Every field has a default that works. The constructor of Simulation checks all fields.
struct SimulationConfig {
  /// [N/m^4] k_v, foundation stiffness of a material of relative stiffness 1; 0: chosen from the head's radius.
  /// k_v of each material must be within 1 ... 1e25. This stiffness is a regularisation, not a material constant:
  /// cutting forces do not depend on it while the engaged layer is thin. 0: chosen so that the layer is a hundredth of
  /// the head's radius in a material of relative stiffness 1 (`stiffness_for_head`), again after each exchange of the
  /// tool; with a quadrature of points, kStiffnessOfPoints. A device that is driven without a coupling renders much
  /// less: see force/stiffness.hpp.
  double reference_stiffness = 0;

  /// [N/m] stiffness of a device that feels the step without a coupling, which limits a chosen reference_stiffness; 0:
  /// none.
  /// A reference_stiffness of 0 is then chosen so low that the head's contact with the stiffest material is not stiffer
  /// (`stiffness_for_device`). Cutting forces are too low where StepStatus::engaged_layer_thick says so.
  /// See `for_device`.
  double device_stiffness = 0;

  /// [s/m] chi, Hunt and Crossley's damping of all contact; empty: 300 for FoundationLaw at the end of a step, else 0.
  /// It is added to each Material::damping. Behind a coupling, the drag of the spin follows the contact's force. This
  /// feeds a vibration of the tool, which the contact has to damp. A device that is driven directly would shake with
  /// the noise of its velocity. The 300 are kCalmingDamping.
  std::optional<double> contact_damping;

  RemovalLaw removal = RemovalLaw::constant_energy;  ///< how material is removed
  /// Where in a partly filled voxel the force is evaluated
  Quadrature quadrature = Quadrature::automatic;

  /// When in a sub-step the contact is evaluated.
  /// With `end`, springs push harder than the energy that they store in the sub-step. The difference is booked as
  /// damping, which closes the ledger of each sub-step. EnergyLedger::entered then has the energy that no work
  /// brought in.
  ContactTime contact_time = ContactTime::middle;

  std::shared_ptr<const ForceLaw> law = std::make_shared<FoundationLaw>();  ///< the force law, never null
  /// Dry friction of the standing head, the same everywhere; empty: each material's own
  std::optional<DryFriction> friction;

  /// The cutting energy differs from place to place by each Material::grain.
  /// Only with FoundationLaw. Off by default, because without it results are smooth, and closed forms hold.
  bool grain = false;
  std::size_t grain_seed = 1;  ///< [1] another seed gives another grain, with the same statistics

  /// A ball pushed beyond its radius keeps pushing back.
  /// See force/deep_contact.hpp. Only with a law that `tethers_deep_ball`, which is the default law. The forces of
  /// other laws stay as their formulas give them.
  bool deep_contact = true;

  /// How force and torque at the head are felt at the handle
  HandleTorque handle_torque = HandleTorque::full_wrench;
  /// [1] zeta of HandleTorque::thesis; the full wrench does not use it
  double handle_torque_scale = 1;

  /// Additions to the model's force, and limits of the output
  Effects effects;
  /// [Hz] rate of calls of the step; only the check of the vibration uses it
  double update_rate = 1000;

  /// [1] blocks (8^3 voxels) that may become partly cut before Simulation::reserve_blocks has to be called again.
  /// About 2.8 kB each. A cavity needs about two for each patch of 8 x 8 voxels of its wall.
  std::size_t reserved_blocks = 2048;

  /// A step lists the voxels that it removes; without the list, StepResult::removed_voxels is empty.
  /// The list of a step is for the caller, observers and recordings, which count its voxels. A loop reads no list: the
  /// coupling of a SimulationModel copies none, and a simulation that only a loop steps, without a recording, can do
  /// without. Changed blocks and the removed volume do not need it.
  bool list_removed_voxels = true;

  /// [1] maximum number of removed voxels that a step lists; 0: as many as the head contains.
  /// Voxels beyond it are removed, but not listed.
  std::size_t removed_voxel_capacity = 0;

  /// [1] maximum number of voxels that a sub-step evaluates, at least 4096; 0: no limit.
  /// When the head touches more voxels, a sub-step evaluates only every n-th strip of 16 voxels, in turn, and counts it
  /// n times. The deadline is met; the force is that of a coarser quadrature. StepStatus::detail_reduced reports it,
  /// and Contact::level_of_detail is n. The force is then too low: in a groove of a ball of 3 mm in dentin by 2 ... 3 %
  /// at n = 2, 4 ... 6 % at n = 3, and 9 % and more from n = 4 on (voxels of 0.04 and 0.05 mm). The removed volume is
  /// right within 0.4 % up to n = 6. n follows from the voxels inside the head, and includes voxels just outside,
  /// because their parts may reach inside.
  /// Only with the default law.
  std::size_t voxel_budget = 0;

  bool stage_times = false;  ///< measure Simulation::stage_times

  double min_dt = 1e-6;  ///< [s] shorter steps are rejected
  double max_dt = 0.1;   ///< [s] longer steps are rejected

  /// [1] maximum number of sub-steps of a step; a motion that needs more is a jump and is rejected.
  /// A step that moves the head by more than half a voxel is split into sub-steps.
  int max_sweep = 64;

  /// The configuration for a loop of your own that gives the force of each step to a device, without a coupling and a
  /// guard: its device_stiffness, and limits of the output that the device can follow. With the defaults, which suit
  /// scripts and couplings, the first touch of a hand would be a blow.
  /// @throws Error when the device states no stiffness or no peak force
  [[nodiscard]] static SimulationConfig for_device(const DeviceCapabilities& device);
};

constexpr auto fields_of(Of<SimulationConfig>) {
  using C = SimulationConfig;
  return std::tuple{
      field("reference_stiffness", &C::reference_stiffness, "N/m^4", Range::between(0, 1e25),
            "k_v, foundation stiffness of a material of relative stiffness 1; 0: chosen from the head's radius"),
      field("device_stiffness", &C::device_stiffness, "N/m", Range::not_negative(),
            "stiffness of a device that feels the step without a coupling, which limits a chosen reference_stiffness; "
            "0: none"),
      field(
          "contact_damping", &C::contact_damping, "s/m", Range::between(0, 1e6),
          "chi, Hunt and Crossley's damping of all contact; empty: 300 for FoundationLaw at the end of a step, else 0"),
      field("removal", &C::removal, "how material is removed"),
      field("quadrature", &C::quadrature, "where in a partly filled voxel the force is evaluated"),
      field("contact_time", &C::contact_time, "when in a sub-step the contact is evaluated"),
      field("law", &C::law, "the force law, never null"),
      field("friction", &C::friction,
            "dry friction of the standing head, the same everywhere; empty: each material's own"),
      field("grain", &C::grain, "the cutting energy differs from place to place by each Material::grain"),
      field("grain_seed", &C::grain_seed, "1", Range::between(0, 4294967295),
            "another seed gives another grain, with the same statistics"),
      field("deep_contact", &C::deep_contact, "a ball pushed beyond its radius keeps pushing back"),
      field("handle_torque", &C::handle_torque, "how force and torque at the head are felt at the handle"),
      field("handle_torque_scale", &C::handle_torque_scale, "1", Range::between(-1e6, 1e6),
            "zeta of HandleTorque::thesis; the full wrench does not use it"),
      field("effects", &C::effects, "additions to the model's force, and limits of the output"),
      field("update_rate", &C::update_rate, "Hz", Range::positive(),
            "rate of calls of the step; only the check of the vibration uses it"),
      field("reserved_blocks", &C::reserved_blocks, "1", Range::between(1, 1e8),
            "blocks (8^3 voxels) that may become partly cut before Simulation::reserve_blocks has to be called again"),
      field("list_removed_voxels", &C::list_removed_voxels,
            "a step lists the voxels that it removes; without the list, StepResult::removed_voxels is empty"),
      field("removed_voxel_capacity", &C::removed_voxel_capacity, "1", Range::between(0, 1e9),
            "maximum number of removed voxels that a step lists; 0: as many as the head contains"),
      field("voxel_budget", &C::voxel_budget, "1", Range::between(0, 1e9),
            "maximum number of voxels that a sub-step evaluates, at least 4096; 0: no limit"),
      field("stage_times", &C::stage_times, "measure Simulation::stage_times"),
      field("min_dt", &C::min_dt, "s", Range::positive(), "shorter steps are rejected"),
      field("max_dt", &C::max_dt, "s", Range::between(0, 1), "longer steps are rejected"),
      field("max_sweep", &C::max_sweep, "1", Range::between(1, 100000),
            "maximum number of sub-steps of a step; a motion that needs more is a jump and is rejected"),
  };
}

/// @throws Error naming the field, its value and the allowed range
void validate(const SimulationConfig& config);

/// Replaces the values that are left to the simulation: `reference_stiffness` 0, Quadrature::automatic and an empty
/// contact_damping, for this head in these materials. Simulation::config returns the completed configuration.
[[nodiscard]] SimulationConfig complete(SimulationConfig config, const ToolHead& head, const MaterialTable& materials);

}  // namespace hapticut
