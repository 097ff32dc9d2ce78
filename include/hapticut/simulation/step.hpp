// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/simulation/energy.hpp"
#include "hapticut/workpiece/removal.hpp"

namespace hapticut {

/// What the hand does in one step.
struct StepInput {
  Pose X_WH;
  Twist V_WH;
  double dt = 0;
};

constexpr auto fields_of(Of<StepInput>) {
  return std::tuple{
      field("X_WH", &StepInput::X_WH, "pose of the handle at the end of the step"),
      field("V_WH", &StepInput::V_WH, "velocity of Ho and angular velocity, in W"),
      field("dt", &StepInput::dt, "s", "since the last step"),
  };
}

/// What a step has to report, as bits; 0 = nothing. Each says what happened to the output, and the cure.
enum class StepStatus : std::uint32_t {
  ok = 0,

  /// The pose held a number that is not finite, or its matrix was not a rotation. No force, workpiece untouched.
  /// Cure: check the device's matrix; re-orthonormalise it (`orthonormalized`) when it is only inexact.
  pose_rejected = 1U << 0,
  /// The velocity held a number that is not finite, or was above 1e6 m/s or rad/s; or, behind a coupling, the
  /// velocities say thirty times the way of the poses. No force, workpiece untouched. Cure: check the velocity
  /// estimate, and that it is in m/s and rad/s.
  velocity_rejected = 1U << 1,
  /// dt was not within SimulationConfig::min_dt ... max_dt. No force, workpiece untouched.
  /// Cure: pass the seconds since the last call; after a pause call with a fresh pose and the nominal period.
  dt_rejected = 1U << 2,
  /// The head moved farther than SimulationConfig::max_sweep half voxels, or turned by more than a radian, or was
  /// more than 2 mm away after refused inputs: a jump, not a motion. No force, workpiece untouched, and the tool stays
  /// where it was. It goes on from there when the next pose is near it. A second pose in a row near this one is
  /// believed, and the tool put there; but a head that turns not into material farther away than its radius or turned
  /// by more than a radian (tool_waits). Cure: bring the hand back smoothly, or raise max_sweep; readings that flip
  /// come of the device.
  jump_rejected = 1U << 3,

  /// A quarter of the reserved blocks or fewer are left. Output unaffected. Cure: Simulation::reserve_blocks soon.
  blocks_low = 1U << 4,
  /// Some material was felt but not cut, because no reserved block was left. Cure: Simulation::reserve_blocks, outside
  /// the step; raise SimulationConfig::reserved_blocks.
  blocks_exhausted = 1U << 5,
  /// More voxels were emptied than the list holds; they are gone and their volume is counted, but not all are listed.
  /// Cure: raise SimulationConfig::removed_voxel_capacity.
  removed_list_full = 1U << 6,

  /// The spindle is loaded beyond its largest power, or at its limit of power or torque: it slows down, and more load
  /// stalls it. Cure: press less, or Spindle::power_limit, torque_limit, droop.
  power_limited = 1U << 8,
  /// The head is in FoundationLaw's material by a layer thicker than a tenth of its radius, weighed by the force that
  /// its depths carry: the foundation is too soft for the feed or the load. Forces of a cut come out wrong; a head that
  /// stands passes through, as through rubber. Cure: leave SimulationConfig::reference_stiffness to its default, or
  /// raise it (with a virtual coupling, where a device must not feel it directly), or feed slower and press less.
  engaged_layer_thick = 1U << 9,
  /// The step was too long for the vibration's frequency, which was left out. Cure: call the step at
  /// SimulationConfig::update_rate, or lower Vibration::frequency.
  vibration_left_out = 1U << 10,
  /// The head touched more voxels than SimulationConfig::voxel_budget: only a part of them was evaluated, in turn with
  /// the others. Cure: larger voxels, a smaller head, or a larger budget.
  detail_reduced = 1U << 11,
  /// The force law gave a force or an energy that is not a finite number. No force from it; what it has cut stays cut.
  /// Cure: check the law of your own.
  force_not_finite = 1U << 12,
  /// The load holds the spindle, and nothing is cut. Cure: press less; it runs again by itself.
  spindle_stalled = 1U << 13,
  /// The iteration of a coupling ended before its forces were in balance: what is left is work that nobody did
  /// (CouplingEnergy::imbalance). Cure: a heavier tool, a lower reference_stiffness, or more
  /// CouplingGains::newton_steps.
  not_in_balance = 1U << 14,
  /// The hand is inside material that the tool has not cut its way into: after a refused input or a jump, an exchange
  /// of workpiece, tool or materials (`undo`, `restore`, `set_tool` ...), or VirtualCoupling::reset. No force,
  /// nothing is cut, for as long as it is in there. Cure: move the hand out of the material; after a refused input also
  /// back to the tool. A script that is to go on in the material calls `reset` with the workpiece; behind a coupling it
  /// begins outside of it.
  tool_waits = 1U << 15,
  /// The head pressed harder than a material's compressive_strength and crushed it: one that stands, or where one that
  /// turns does not cut, as at the middle of a drill's point. Cure: press less, or feed slower; a head that stands may
  /// turn.
  material_crushed = 1U << 16,
  /// The head is in material, and its spindle has no speed, so that nothing is cut. Cure: make the tool with a spindle,
  /// `Tool(head, handle, Spindle{40000 * units::rpm})`; RemovalLaw::none where nothing shall be cut.
  spindle_stands = 1U << 17,
  /// The tool cuts with another kind of cutter (Cutter::kind) than the one that a material's constants are for
  /// (Material::cutter): forces and removal are off by as much as tenfold. Cure: `find_preset(name,
  /// tool.cutter().kind)`, or a tool with a `Cutter` of the material's kind; clear Material::cutter of constants
  /// that are meant so.
  other_cutter = 1U << 18,
  /// The turning tool of a coupling was faster than the hand by more than 0.1 m/s: the drag of the spindle threw it
  /// about, or it broke through, and a brake held it, which the hand does not feel (VirtualCoupling). Cure: press less;
  /// in corners, a material whose cutting_ratio was
  /// measured on lips belongs to a head with lips, as `twist_drill_head`.
  tool_braked = 1U << 19,
  /// The material in contact is about a point of the head, of a needle or a slender cone, that is thinner than 1.5
  /// voxels: it is met or missed by half a voxel, and how deep it sinks is off by as much. Cure: smaller voxels.
  point_thin = 1U << 20,
};

constexpr auto names_of(Of<StepStatus>) {
  using enum StepStatus;
  return std::array{
      Named{ok, "ok"},
      Named{pose_rejected, "pose_rejected",
            "The pose of the hand is no rotation, so there is no force: check the device."},
      Named{velocity_rejected, "velocity_rejected",
            "The speed of the hand is no number, or not that of its way, so there is no force: check the device."},
      Named{dt_rejected, "dt_rejected",
            "A step came at the wrong time, so there is no force: close other programs that use the processor."},
      Named{jump_rejected, "jump_rejected", "The hand jumped, so there is no force: bring it back smoothly."},
      Named{blocks_low, "blocks_low", "The memory for cut blocks is nearly full: restart soon, or cut less."},
      Named{blocks_exhausted, "blocks_exhausted",
            "The memory for cut blocks is full, so nothing more is cut: restart."},
      Named{removed_list_full, "removed_list_full",
            "More was cut at once than can be listed; the sums are right: feed slower."},
      Named{power_limited, "power_limited", "The spindle is at its limit: press less."},
      Named{
          engaged_layer_thick, "engaged_layer_thick",
          "The stiffness is too soft for the feed or the load, so forces come out wrong: feed slower, or press less."},
      Named{vibration_left_out, "vibration_left_out",
            "The vibration is too fast for the loop, so it is left out: lower its frequency."},
      Named{detail_reduced, "detail_reduced",
            "The head touches more voxels than a step can look at: take a smaller head, or press less."},
      Named{force_not_finite, "force_not_finite",
            "The force came out as no number, so there is none: lift the tool off, and check the materials."},
      Named{spindle_stalled, "spindle_stalled",
            "The spindle is stalled, so nothing is cut: press less, and it runs again by itself."},
      Named{not_in_balance, "not_in_balance",
            "The force of the hand and that of the material are not in balance: press less, or move slower."},
      Named{tool_waits, "tool_waits",
            "The hand is inside material that the tool has not cut, so it feels and cuts nothing until the hand has "
            "left it: bring it out of the material, or back to the tool."},
      Named{material_crushed, "material_crushed",
            "The head crushes the material where it does not cut it: press less, or feed slower."},
      Named{spindle_stands, "spindle_stands", "The spindle of this tool has no speed, so nothing is cut: give it one."},
      Named{other_cutter, "other_cutter",
            "The materials are made for another kind of cutter, so forces come out wrong: take one with the other."},
      Named{tool_braked, "tool_braked",
            "The tool breaks through, or is thrown about in a corner, and is braked: press less, or slow the spindle."},
      Named{point_thin, "point_thin",
            "The point of the head is thinner than the voxels, so it sinks too deep or too little: take smaller ones."},
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

/// The bits of an input that was not accepted.
inline constexpr StepStatus kRejected =
    StepStatus::pose_rejected | StepStatus::velocity_rejected | StepStatus::dt_rejected | StepStatus::jump_rejected;

/// The material that the head touches, where the last sub-step evaluates it.
struct Contact {
  int voxels = 0;
  double volume = 0;
  double depth = 0;
  int level_of_detail = 1;
  Vec3 point_W = Vec3::Zero();
  Vec3 normal_W = Vec3::Zero();
  double area = 0;
  double pressure = 0;
};

constexpr auto fields_of(Of<Contact>) {
  return std::tuple{
      field("voxels", &Contact::voxels, "1", "voxels inside the head that are not empty"),
      field("volume", &Contact::volume, "m^3", "their filled volume"),
      field("depth", &Contact::depth, "m", "greatest depth below the cutting surface"),
      field("level_of_detail", &Contact::level_of_detail, "1",
            "n: an n-th of the voxels was evaluated; see SimulationConfig::voxel_budget"),
      field("point_W", &Contact::point_W, "m",
            "in W: the mean place of the forces along the normals, where an arrow begins, by the middles of voxels, so "
            "within half a voxel; zero without a contact"),
      field("normal_W", &Contact::normal_W, "1",
            "in W: the direction of those forces' sum on the tool, a unit vector; zero without a contact, and where "
            "they cancel"),
      field("area", &Contact::area, "m^2", "of the head's surface that is in material"),
      field("pressure", &Contact::pressure, "Pa", "mean of the forces along the normals over that area"),
  };
}

/// Along which motions a probe shall know the stiffness. It only matters for custom laws, which evaluate the contact
/// once more for every motion.
enum class ProbedMotions { all, translations };

constexpr auto names_of(Of<ProbedMotions>) {
  using enum ProbedMotions;
  return std::array{
      Named{all, "all"},
      Named{translations, "translations"},
  };
}

/// What a step would feel, without taking it.
struct ContactProbe {
  Wrench wrench;
  Stiffness stiffness = Stiffness::Zero();
  Contact contact;
  bool sliding = false;
};

constexpr auto fields_of(Of<ContactProbe>) {
  using P = ContactProbe;
  return std::tuple{
      field("wrench", &P::wrench, "about Ho, in W, on the tool; without effects and limits"),
      field("stiffness", &P::stiffness,
            "about Ho, in W, by which the wrench falls with a small motion; symmetric where the head does not spin"),
      field("contact", &P::contact, "what the head would touch"),
      field("sliding", &P::sliding, "dry friction drags its anchor along: see LimitSurface"),
  };
}

/// The spindle during the step.
struct SpindleState {
  double speed = 0;
  double torque = 0;
};

constexpr auto fields_of(Of<SpindleState>) {
  return std::tuple{
      field("speed", &SpindleState::speed, "rad/s", "signed about +z of T"),
      field("torque", &SpindleState::torque, "N m",
            "that the motor delivers about +z of T: it drives a cut when it has the sign of the speed"),
  };
}

/// The blocks that a step has changed, for pictures and copies of the workpiece.
struct ChangedBlocks {
  std::span<const VoxelIndex> origins;  ///< first voxels, some more than once; valid until the next step
  bool complete = true;                 ///< false: more than could be listed, so any block may have changed
};

/// What one step returns.
struct StepResult {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  std::span<const RemovedVoxel> removed_voxels;
  double removed_volume = 0;
  Contact contact;
  Wrench model;
  EnergyLedger energy;
  SpindleState spindle;
  int sub_steps = 0;
  StepStatus status = StepStatus::ok;
};

constexpr auto fields_of(Of<StepResult>) {
  using R = StepResult;
  return std::tuple{
      field("force", &R::force, "N", "on the tool, what the hand feels, in W"),
      field("torque", &R::torque, "N m", "on the tool about Ho, what the hand feels, in W"),
      field("removed_voxels", &R::removed_voxels, "emptied by this call; valid until the next one"),
      field("removed_volume", &R::removed_volume, "m^3", "taken away by this call, partly emptied voxels included"),
      field("contact", &R::contact, "what the head touches"),
      field("model", &R::model,
            "about Ho, in W: what the contact gives, before coupling, effects and limits; mean over the step"),
      field("energy", &R::energy, "accumulated since construction"),
      field("spindle", &R::spindle, "speed and torque of this step"),
      field("sub_steps", &R::sub_steps, "1", "0 when the input was rejected"),
      field("status", &R::status, "bits of StepStatus; 0 = nothing to report"),
  };
}

}  // namespace hapticut
