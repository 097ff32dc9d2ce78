// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/material_set.hpp"
#include "simulation/contact_stages.hpp"
#include "simulation/head_stiffness.hpp"
#include "simulation/loaded_spindle.hpp"
#include "simulation/stage_timer.hpp"
#include "simulation/sweep.hpp"
#include "simulation/tool_motion.hpp"

/// The state of a simulation, and the stages of its step.
namespace hapticut {

/// The springs that a contact has beside the foundation. They remember where they began.
struct Springs {
  DeepContact deep;     // its vectors are in W
  LimitSurface anchor;  // anchor of dry friction, in W
};

/// The side of the hand in a step.
struct HandSide {
  bool released = false;                 // the hand was released since the last step
  bool was_released = false;             // the hand was released before this step
  OutputPath path = OutputPath::direct;  // path of the force
  HandOutput coupled;                    // answer of the coupling, in the last step that it answered
  Output output;
};

/// Counters and sums since construction or reset.
struct RunningTotals {
  std::uint64_t steps = 0;
  std::uint64_t exchanges = 0, replacements = 0;    // also from before a reset; replacements of the whole workpiece
  bool altered = false;                             // the workpiece was changed, but not by a step
  ByMaterial<double> detached_volume = {};          // [m^3] by MaterialId
  MaterialSet touched, first_touched;               // for the first time, in the last step
  ByMaterial<std::uint64_t> first_touch_step = {};  // `steps` in which a material was first touched; 0: not yet

  void begin_step() noexcept {
    ++steps;
    first_touched = {};
  }
  void note_touches(const MaterialSet& found) noexcept {  ///< of materials that were not touched before
    touched.insert(found);
    first_touched.insert(found);
    found.for_each([&](MaterialId id) { first_touch_step[id] = steps; });
  }
  /// Goes on counting exchanges, for a workpiece that replaces the one with the given totals.
  void replace(const RunningTotals& replaced) noexcept {
    exchanges = replaced.exchanges;
    replacements = replaced.replacements + 1;
  }
};

/// Adds the contact of a sub-step to a probe: its wrench, and its stiffness with that of the springs.
/// @param acting  the springs after the sub-step
void add_to(ContactProbe& probe, const SubStep& sub_step, const Encounter& encounter, const Springs& acting) noexcept;

/// Whether some material is for another kind of cutter.
[[nodiscard]] bool any_for_other_cutter(const MaterialTable& materials, CutterKind cutter) noexcept;

/// @throws Error when a head does not suit voxels of a size [m]
void validate_head(const ToolHead& head, double voxel_size);

struct Simulation::State {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their making
  State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config);
  void set_contact_materials() noexcept;
  void set_material_friction() noexcept;
  void forget_pose() noexcept;

  // The stages of a step, in their order.
  [[nodiscard]] StageTimer timed(double StageTimes::*stage) const noexcept {
    return StageTimer(config.stage_times ? &(times.*stage) : nullptr);
  }
  void begin_step(const StepInput& given) noexcept;
  void take_step(HandCoupling* coupling) noexcept;
  [[nodiscard]] StepStatus check_step_input() const noexcept {
    const StageTimer timer = timed(&StageTimes::check_input);
    return check_input(config, input.X_WH, input.V_WH, input.dt);
  }
  [[nodiscard]] StepStatus find_start(bool coupled) noexcept;
  [[nodiscard]] Sweep plan_sweep(const Pose& from, const Pose& to) const noexcept;
  void take_sub_steps(const HandlePath& path, Springs& acting, ContactProbe* probe) noexcept;
  [[nodiscard]] SubStep plan_sub_step(const HandlePath& path, int index) const noexcept;
  [[nodiscard]] std::span<const FoundBlock> find_blocks(const SubStep& sub_step) noexcept;
  void drive_spindle(std::span<const FoundBlock> blocks, SubStep& sub_step) noexcept;
  [[nodiscard]] Encounter press_and_cut(std::span<const FoundBlock> blocks, const SubStep& sub_step,
                                        bool cuts) noexcept;
  void remove_emptied() noexcept;
  void tether_deep_ball(const SubStep& sub_step, Encounter& encounter, DeepContact& deep) noexcept;
  void add_friction(const SubStep& sub_step, Encounter& encounter, LimitSurface& anchor) noexcept;
  void book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void transport_to_handle(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void advance_spindle(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void give_output(HandCoupling* coupling) noexcept;
  void finish_step(const HandlePath& path) noexcept;
  void reject(StepStatus status) noexcept;

  // Parts of the stages.
  [[nodiscard]] bool start_tool(bool coupled) noexcept;
  [[nodiscard]] bool is_placed_elsewhere(const Pose& X_WH, const Twist& V_WH, double dt) const noexcept;
  [[nodiscard]] bool is_jump() const noexcept;
  [[nodiscard]] bool jumps_into_material(const Pose& X_WH) noexcept;
  [[nodiscard]] StepStatus follow_jump() noexcept;
  void place_at(const Pose& X_WH) noexcept;
  [[nodiscard]] Sweep sweep_between(const Pose& from, const Pose& to) const noexcept;
  void set_spin(HeadPlacement& head) const noexcept;
  void book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept;
  void note_status(const Encounter& encounter) noexcept;
  [[nodiscard]] double load_to_cut() const noexcept;
  [[nodiscard]] DeepContact::Pull tether(const SubStep& sub_step, const Encounter& encounter,
                                         DeepContact& deep) noexcept;

  // Questions: `Simulation::probe`.
  [[nodiscard]] bool touches(const Pose& X_WH, double deeper_than = 0) noexcept;
  [[nodiscard]] bool is_in_material(const Pose& X_WH) noexcept;
  [[nodiscard]] ContactProbe probe_path(const HandlePath& path, Springs acting) noexcept;
  [[nodiscard]] Stiffness measure_stiffness(const HandlePath& path, const Pose& to, const Springs& acting, int axes,
                                            const Wrench& felt) noexcept;

  // To the observers.
  void tell_of_step(const Simulation& simulation) const noexcept {
    for (StepObserver* observer : observers.all())
      observer->on_step({simulation, totals.steps - 1, input, free_blocks, hand.was_released, spindle.was_halted(),
                         spindle.was_set(), spindle.is_held(), spindle.motor().setting(), hand.path, hand.coupled,
                         result});
  }
  void tell_of_exchange() noexcept {
    ++totals.exchanges;
    for (StepObserver* observer : observers.all()) observer->on_exchange();
  }

  Workpiece workpiece;
  Tool tool;
  bool chooses_stiffness;  // from the head and the materials
  SimulationConfig config;

  // Derived from them at set-up.
  ContactStages contact_stages;
  Pose X_VW;
  HeadStiffness head_stiffness;
  bool other_cutter = false;  // the materials are for another kind of cutter
  double thickest_chip = 0;   // [m] crowded_chip(tool)

  // What one step hands to the next. A recording stores or repeats all of it, and a copy has it: a new member that a
  // step depends on needs a line in the table of src/io/recording/recorder.cpp and a place in simulation_memory.cpp.
  ToolMotion motion;
  LoadedSpindle spindle;
  Springs springs;
  double crushing_depth = 0;  // [m] value of the last sub-step (ContactStages::rim_crushing_depth)
  HandSide hand;

  // The last step.
  StepInput input;
  std::size_t free_blocks = 0;  // when it began
  RemovalRecord removal;
  StepResult result;
  mutable StageTimes times;

  RunningTotals totals;
  StepObservers observers;
};

}  // namespace hapticut
