// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hapticut/contact/removal.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/simulation/energy.hpp"

namespace hapticut {

/// The motion of the hand in one step. `fields_of` below has unit, range and meaning of each field.
struct StepInput {
  Pose X_WH;      ///< pose of the handle at the end of the step
  Twist V_WH;     ///< velocity of Ho and angular velocity, in W
  double dt = 0;  ///< [s] time since the last step
};

constexpr auto fields_of(Of<StepInput>) {
  return std::tuple{
      field("X_WH", &StepInput::X_WH, "pose of the handle at the end of the step"),
      field("V_WH", &StepInput::V_WH, "velocity of Ho and angular velocity, in W"),
      field("dt", &StepInput::dt, "s", "time since the last step"),
  };
}

/// Reports of a step, as bits; 0 = nothing. Each comment says what happened to the output, and the cure.
enum class StepStatus : std::uint32_t {
  ok = 0,

  /// The pose had a number that is not finite, or its matrix was not a rotation. No force, workpiece untouched. Cure:
  /// check the device's matrix; if it is only inexact, re-orthonormalise it (`orthonormalized`).
  pose_rejected = 1U << 0,
  /// The velocity had a number that is not finite, or was above 1e6 m/s or rad/s; or, behind a coupling, it was thirty
  /// times the velocity of the poses. No force, workpiece untouched. Cure: check the velocity estimate, and that it is
  /// in m/s and rad/s.
  velocity_rejected = 1U << 1,
  /// dt was not within SimulationConfig::min_dt ... max_dt. No force, workpiece untouched. Cure: pass the seconds since
  /// the last call; after a pause pass a new pose and the nominal period.
  dt_rejected = 1U << 2,
  /// The head moved farther than SimulationConfig::max_sweep half voxels, or rotated by more than a radian, or was more
  /// than 2 mm away after rejected inputs: a jump, not a motion. No force, workpiece untouched, and the tool stays
  /// where it was. It continues from there when the next pose is near it. If a second pose in a row is near the jump's,
  /// the tool is placed there; but a turning head is not placed in material (tool_waits) when it would move farther
  /// than its radius or rotate by more than a radian. Cure: bring the hand back smoothly, or raise max_sweep. Poses
  /// that jump to and fro are a fault of the device.
  jump_rejected = 1U << 3,

  /// A quarter of the reserved blocks or fewer are left. Output unaffected. Cure: call Simulation::reserve_blocks soon.
  blocks_low = 1U << 4,
  /// Some material was felt but not cut, because no reserved block was left. Cure: call Simulation::reserve_blocks
  /// outside the step, or raise SimulationConfig::reserved_blocks.
  blocks_exhausted = 1U << 5,
  /// More voxels were emptied than the list takes. All are removed and their volume is counted, but not all are listed.
  /// Cure: raise SimulationConfig::removed_voxel_capacity.
  removed_list_full = 1U << 6,
  // Bit 7 is free: it never had a meaning.

  /// The spindle is loaded beyond its maximum power, or at its limit of power or torque: it slows down, and more load
  /// stalls it. Cure: press less, or change Spindle::power_limit, torque_limit, droop.
  power_limited = 1U << 8,
  /// The engaged layer of FoundationLaw is thicker than a tenth of the head's radius, weighted by the force at each
  /// depth: the foundation is too soft for the feed or the load. Cutting forces are wrong, and a standing head sinks
  /// through as through rubber. Cure: leave SimulationConfig::reference_stiffness at its default, or raise it (behind a
  /// virtual coupling, because a device must not feel it directly), or feed slower and press less.
  engaged_layer_thick = 1U << 9,
  /// The step was too long for the vibration's frequency, so the vibration was left out. Cure: call the step at
  /// SimulationConfig::update_rate, or lower Vibration::frequency.
  vibration_left_out = 1U << 10,
  /// The head touched more voxels than SimulationConfig::voxel_budget: only a part of them was evaluated, in turn with
  /// the other parts. Cure: larger voxels, a smaller head, or a larger budget.
  detail_reduced = 1U << 11,
  /// The force law returned a force or an energy that is not a finite number. Its force was dropped; what it has cut
  /// stays cut. Cure: check the custom law.
  force_not_finite = 1U << 12,
  /// The load has stopped the spindle, and nothing is cut. Cure: press less; the spindle then starts again.
  spindle_stalled = 1U << 13,
  /// The iteration of a coupling ended before its forces were in balance. The remainder is work without a source
  /// (CouplingEnergy::imbalance). Cure: a heavier tool, a lower reference_stiffness, or more
  /// CouplingGains::newton_steps.
  not_in_balance = 1U << 14,
  /// The hand is inside material that the tool has not cut its way into: after a rejected input or a jump, an exchange
  /// of workpiece, tool or materials (`undo`, `restore`, Simulation::set ...), or VirtualCoupling::reset. No force, and
  /// nothing is cut, while it is in there. Cure: move the hand out of the material, or after a rejected input back to
  /// the tool. A script that must continue inside the material calls `reset` with the workpiece; behind a coupling it
  /// begins outside.
  tool_waits = 1U << 15,
  /// More than a tenth of the removed material, by its energy, was crushed, because the head appeared in it or pressed
  /// harder than its compressive_strength: a standing head does so, and one that turns too slowly for its feed. Less is
  /// ordinary, as below the middle of a drill's point, and only EnergyLedger::crushed shows it. Cure: press less, or
  /// feed slower; start the spindle of a standing head.
  material_crushed = 1U << 16,
  /// The head is in material, and its spindle has no speed, so nothing is cut. Cure: make the tool with a spindle,
  /// `Tool(head, handle, Spindle{40000 * units::rpm})`, or use RemovalLaw::none when nothing must be cut.
  spindle_stands = 1U << 17,
  /// The tool cuts with another kind of cutter (Cutter::kind) than the one that a material's constants are for
  /// (Material::cutter): forces and removal are wrong by up to a factor of ten. Cure: `find_preset(name,
  /// tool.cutter().kind)`, or a tool with a `Cutter` of the material's kind; clear Material::cutter when the constants
  /// are meant for this cutter.
  other_cutter = 1U << 18,
  /// The tool of a coupling, with its spindle turning, was faster than the hand by more than 0.1 m/s, because the drag
  /// of the spindle threw it about or because it broke through. A brake held it, which the hand does not feel
  /// (VirtualCoupling), with more than a tenth of the force between tool and material. Cure: press less. In corners: a
  /// material whose cutting_ratio was measured on lips needs a head with lips, such as `twist_drill_head`.
  tool_braked = 1U << 19,
  /// The contact is at a point of the head, of a needle or a slender cone, that is thinner than 1.5 voxels. It hits or
  /// misses material by half a voxel, and its depth has the same error. Cure: smaller voxels.
  point_thin = 1U << 20,
  /// A twist drill turns in material that it does not cut: the whole load is below Contact::load_to_cut, which its
  /// edges carry without a chip. Cure: press harder than that, or take a sharper drill (Sharpness).
  edges_carry_load = 1U << 21,
};

constexpr auto names_of(Of<StepStatus>) {
  using enum StepStatus;
  return std::array{
      Named{ok, "ok"},
      Named{pose_rejected, "pose_rejected",
            "The pose of the hand is not a rigid transform, so there is no force: check the device."},
      Named{velocity_rejected, "velocity_rejected",
            "The velocity of the hand is not a number or does not fit its motion, so there is no force: check the "
            "device."},
      Named{dt_rejected, "dt_rejected",
            "A step came at the wrong time, so there is no force: close other programs that use the processor."},
      Named{jump_rejected, "jump_rejected", "The hand jumped, so there is no force: bring it back smoothly."},
      Named{blocks_low, "blocks_low", "The memory for cut blocks is nearly full: restart soon, or cut less."},
      Named{blocks_exhausted, "blocks_exhausted",
            "The memory for cut blocks is full, so nothing more is cut: restart."},
      Named{removed_list_full, "removed_list_full",
            "More voxels were cut in a step than it can list; the volumes are right: feed slower."},
      Named{power_limited, "power_limited", "The spindle is at its limit: press less."},
      Named{engaged_layer_thick, "engaged_layer_thick",
            "The stiffness is too low for the feed or the load, so forces are wrong: feed slower, or press less."},
      Named{vibration_left_out, "vibration_left_out",
            "The vibration is too fast for the loop, so it is left out: lower its frequency."},
      Named{detail_reduced, "detail_reduced",
            "The head touches more voxels than a step can evaluate: use a smaller head, or press less."},
      Named{force_not_finite, "force_not_finite",
            "The force is not a number, so none is given: lift the tool off, and check the materials."},
      Named{spindle_stalled, "spindle_stalled",
            "The spindle is stalled, so nothing is cut: press less, and it starts again."},
      Named{not_in_balance, "not_in_balance",
            "The force of the hand and that of the material are not in balance: press less, or move slower."},
      Named{tool_waits, "tool_waits",
            "The hand is inside material that the tool has not cut, so it feels and cuts nothing until the hand has "
            "left it: bring it out of the material, or back to the tool."},
      Named{material_crushed, "material_crushed",
            "The head crushes the material where it does not cut it: press less, or feed slower."},
      Named{spindle_stands, "spindle_stands", "The spindle of this tool has no speed, so nothing is cut: set a speed."},
      Named{other_cutter, "other_cutter",
            "The materials are for another kind of cutter, so forces are wrong: change the tool or the materials."},
      Named{tool_braked, "tool_braked",
            "The tool breaks through, or is thrown about in a corner, and is braked: press less, or slow the spindle."},
      Named{point_thin, "point_thin",
            "The point of the head is thinner than the voxels, so its depth is wrong: use smaller voxels."},
      Named{edges_carry_load, "edges_carry_load",
            "The edges of the drill carry the whole load, so it hardly cuts: press harder, or take a sharper drill."},
  };
}

[[nodiscard]] constexpr StepStatus operator|(StepStatus a, StepStatus b) {
  return StepStatus(std::uint32_t(a) | std::uint32_t(b));
}
constexpr StepStatus& operator|=(StepStatus& a, StepStatus b) { return a = a | b; }

/// Whether any of the given bits is set.
[[nodiscard]] constexpr bool has_any(StepStatus status, StepStatus bits) {
  return (std::uint32_t(status) & std::uint32_t(bits)) != 0;
}

/// The names of all bits that are set: "ok", "power_limited", "blocks_low | engaged_layer_thick".
[[nodiscard]] inline std::string describe(StepStatus status) {
  std::string names;
  for_each_bit<StepStatus>([&](StepStatus bit, std::string_view name) {
    if (has_any(status, bit)) names += (names.empty() ? "" : " | ") + std::string(name);
  });
  return names.empty() ? "ok" : names;
}

/// The bits of a rejected input.
inline constexpr StepStatus kRejected =
    StepStatus::pose_rejected | StepStatus::velocity_rejected | StepStatus::dt_rejected | StepStatus::jump_rejected;

/// The material that the head touches, in the last sub-step. `fields_of` below has unit, range and meaning of each
/// field.
struct Contact {
  int voxels = 0;           ///< [1] voxels inside the head that are not empty
  double volume = 0;        ///< [m^3] their filled volume
  double depth = 0;         ///< [m] maximum depth below the cutting surface
  int level_of_detail = 1;  ///< [1] n: one n-th of the voxels was evaluated; see SimulationConfig::voxel_budget
  /// [m] the mean point of the normal forces in W, where an arrow begins; from the centres of voxels, so exact within
  /// half a voxel; zero without a contact
  Vec3 point_W = Vec3::Zero();
  /// [1] the direction of the sum of the normal forces on the tool in W, a unit vector; zero without a contact, and
  /// when they cancel
  Vec3 normal_W = Vec3::Zero();
  double area = 0;      ///< [m^2] area of the head's surface that is in material
  double pressure = 0;  ///< [Pa] mean of the normal forces over that area
  /// [N] thrust that the edges of a twist drill carry without a chip in what it touches, u h_e z R/kappa; 0: other
  /// cutters, a spindle that stands
  double load_to_cut = 0;
};

constexpr auto fields_of(Of<Contact>) {
  return std::tuple{
      field("voxels", &Contact::voxels, "1", "voxels inside the head that are not empty"),
      field("volume", &Contact::volume, "m^3", "their filled volume"),
      field("depth", &Contact::depth, "m", "maximum depth below the cutting surface"),
      field("level_of_detail", &Contact::level_of_detail, "1",
            "n: one n-th of the voxels was evaluated; see SimulationConfig::voxel_budget"),
      field("point_W", &Contact::point_W, "m",
            "the mean point of the normal forces in W, where an arrow begins; from the centres of voxels, so exact "
            "within half a voxel; zero without a contact"),
      field("normal_W", &Contact::normal_W, "1",
            "the direction of the sum of the normal forces on the tool in W, a unit vector; zero without a contact, "
            "and when they cancel"),
      field("area", &Contact::area, "m^2", "area of the head's surface that is in material"),
      field("pressure", &Contact::pressure, "Pa", "mean of the normal forces over that area"),
      field("load_to_cut", &Contact::load_to_cut, "N",
            "thrust that the edges of a twist drill carry without a chip in what it touches, u h_e z R/kappa; 0: other "
            "cutters, a spindle that stands"),
  };
}

/// Directions in which a probe reports stiffness. This only matters for custom laws, which evaluate the contact once
/// more for every direction.
enum class ProbedMotions { all, translations, none };

constexpr auto names_of(Of<ProbedMotions>) {
  using enum ProbedMotions;
  return std::array{
      Named{all, "all"},
      Named{translations, "translations"},
      Named{none, "none"},
  };
}

/// The contact that a step would meet, without taking the step.
struct ContactProbe {
  Wrench wrench;  ///< wrench on the tool about Ho, in W; without effects and limits
  /// How the wrench about Ho falls with a small motion, in W; symmetric when the head does not spin
  Stiffness stiffness = Stiffness::Zero();
  Contact contact;       ///< what the head would touch
  bool sliding = false;  ///< dry friction slides: see LimitSurface
  int evaluations = 1;   ///< [1] evaluations of the contact, with those that measured the stiffness
  int blocks = 0;        ///< [1] blocks of 8 x 8 x 8 voxels with material that the head may touch
};

constexpr auto fields_of(Of<ContactProbe>) {
  using P = ContactProbe;
  return std::tuple{
      field("wrench", &P::wrench, "wrench on the tool about Ho, in W; without effects and limits"),
      field("stiffness", &P::stiffness,
            "how the wrench about Ho falls with a small motion, in W; symmetric when the head does not spin"),
      field("contact", &P::contact, "what the head would touch"),
      field("sliding", &P::sliding, "dry friction slides: see LimitSurface"),
      field("evaluations", &P::evaluations, "1", "evaluations of the contact, with those that measured the stiffness"),
      field("blocks", &P::blocks, "1", "blocks of 8 x 8 x 8 voxels with material that the head may touch"),
  };
}

/// The spindle during the step. `fields_of` below has unit, range and meaning of each field.
struct SpindleState {
  double speed = 0;   ///< [rad/s] signed about +z of T
  double torque = 0;  ///< [N m] torque of the motor about +z of T: it drives a cut when it has the sign of the speed
};

constexpr auto fields_of(Of<SpindleState>) {
  return std::tuple{
      field("speed", &SpindleState::speed, "rad/s", "signed about +z of T"),
      field("torque", &SpindleState::torque, "N m",
            "torque of the motor about +z of T: it drives a cut when it has the sign of the speed"),
  };
}

/// The blocks that a step has changed, for renderers and copies of the workpiece.
struct ChangedBlocks {
  std::span<const VoxelIndex> origins;  ///< first voxels of blocks, some more than once; valid until the next step
  bool complete = true;                 ///< false: not all could be listed, so any block may have changed
};

/// The result of one step. `fields_of` below has unit, range and meaning of each field.
struct StepResult {
  Vec3 force = Vec3::Zero();                     ///< [N] output: on the tool, as the hand feels it, in W
  Vec3 torque = Vec3::Zero();                    ///< [N m] output: on the tool about Ho, as the hand feels it, in W
  std::span<const RemovedVoxel> removed_voxels;  ///< emptied by this call; valid until the next one
  double removed_volume = 0;                     ///< [m^3] removed by this call, including from partly emptied voxels
  Contact contact;                               ///< what the head touches
  /// Wrench of the contact about Ho, in W: before coupling, effects and limits; mean over the step
  Wrench model;
  EnergyLedger energy;                 ///< accumulated since construction or reset
  SpindleState spindle;                ///< speed and torque of this step
  int sub_steps = 0;                   ///< [1] 0 when the input was rejected
  StepStatus status = StepStatus::ok;  ///< bits of StepStatus; 0 = nothing to report
};

constexpr auto fields_of(Of<StepResult>) {
  using R = StepResult;
  return std::tuple{
      field("force", &R::force, "N", "output: on the tool, as the hand feels it, in W"),
      field("torque", &R::torque, "N m", "output: on the tool about Ho, as the hand feels it, in W"),
      field("removed_voxels", &R::removed_voxels, "emptied by this call; valid until the next one"),
      field("removed_volume", &R::removed_volume, "m^3", "removed by this call, including from partly emptied voxels"),
      field("contact", &R::contact, "what the head touches"),
      field("model", &R::model,
            "wrench of the contact about Ho, in W: before coupling, effects and limits; mean over the step"),
      field("energy", &R::energy, "accumulated since construction or reset"),
      field("spindle", &R::spindle, "speed and torque of this step"),
      field("sub_steps", &R::sub_steps, "1", "0 when the input was rejected"),
      field("status", &R::status, "bits of StepStatus; 0 = nothing to report"),
  };
}

}  // namespace hapticut
