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

/// @throws Error when a head does not suit voxels of a size [m]
void validate_head(const ToolHead& head, double voxel_size);

struct Simulation::State {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their making
  State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config);
  void prepare_workpiece();
  void set_contact_materials() noexcept;
  void set_material_friction() noexcept;
  void compare_cutters() noexcept;
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
  [[nodiscard]] double farthest_between(const Pose& from, const Pose& to) const noexcept;
  [[nodiscard]] double crushing_depth_in(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  [[nodiscard]] int sub_steps_between(const Pose& from, const Pose& to) const noexcept {
    return sweep_between(from, to).sub_steps;
  }
  void set_spin(HeadPlacement& head) const noexcept;
  [[nodiscard]] double torque_to_spin(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  void book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] DeepContact::Pull tether(const SubStep& sub_step, const Encounter& encounter,
                                         DeepContact& deep) noexcept;
  void note_touches(std::span<const FoundBlock> blocks, const SubStep& sub_step) noexcept;
  [[nodiscard]] Contact contact_of(const SubStep& sub_step, const Encounter& encounter) const noexcept;

  // Questions: `Simulation::probe`.
  [[nodiscard]] bool touches(const Pose& X_WH, double deeper_than = 0) noexcept;
  [[nodiscard]] bool is_in_material(const Pose& X_WH) noexcept;
  void add_to(ContactProbe& probe, const SubStep& sub_step, const Encounter& encounter, const Springs& acting,
              int blocks) const noexcept;
  [[nodiscard]] ContactProbe probe_path(const HandlePath& path, Springs acting) noexcept;
  [[nodiscard]] Stiffness measure_stiffness(const HandlePath& path, const Pose& to, const Springs& acting, int axes,
                                            const Wrench& felt) noexcept;

  // To the observers.
  void tell_of_step(const Simulation& simulation) const noexcept {
    for (StepObserver* observer : observers.all())
      observer->on_step({simulation, steps - 1, input, free_blocks, hand.was_released, spindle.was_halted_,
                         spindle.was_set_, spindle.is_held(), spindle.motor_.setting(), hand.path, hand.coupled,
                         result});
  }
  void tell_of_exchange() noexcept {
    ++exchanges;
    for (StepObserver* observer : observers.all()) observer->on_exchange();
  }

  Workpiece workpiece;
  Tool tool;
  bool chooses_stiffness;  // from the head and the materials
  SimulationConfig config;

  // Derived from them at set-up.
  ContactStages contact_stages;
  Pose X_VW;
  double voxel_volume = 0;  // [m^3]
  HeadStiffness head_stiffness;
  bool other_cutter = false;  // the materials are for another kind of cutter

  // What one step hands to the next. A recording stores or repeats all of it, and a copy has it: a new member that a
  // step depends on needs a line in the table of src/io/recording/recorder.cpp and a place in simulation_memory.cpp.
  ToolMotion motion;
  SpindleDrive spindle;
  Springs springs;
  double crushing_depth = 0;  // [m] value of the last sub-step (crushing_depth_in)
  HandSide hand;

  // The last step.
  StepInput input;
  std::size_t free_blocks = 0;  // when it began
  RemovalRecord removal;
  StepResult result;
  mutable StageTimes times;

  // Since construction or reset.
  std::uint64_t steps = 0;
  std::uint64_t exchanges = 0;
  std::uint64_t replacements = 0;                   // replacements of the whole workpiece
  bool altered = false;                             // the workpiece was changed, but not by a step
  ByMaterial<double> detached_volume = {};          // [m^3] by MaterialId
  MaterialSet touched, first_touched;               // for the first time, in the last step
  ByMaterial<std::uint64_t> first_touch_step = {};  // `steps` in which a material was first touched; 0: not yet
  StepObservers observers;
};

}  // namespace hapticut
