// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/material_set.hpp"
#include "simulation/contact_stages.hpp"
#include "simulation/head_stiffness.hpp"
#include "simulation/stage_timer.hpp"

/// The state of a simulation, and the stages of its step.
namespace hapticut {

/// One equal part of the tool's motion during a step, seen where the contact is evaluated: at its middle or its end.
struct SubStep {
  double duration;     // [s]
  Pose X_WH;           // of the handle
  Pose X_WT;           // of the head
  Twist path_T;        // of To along the path, in T
  HeadPlacement head;  // of the head, for the stages that see voxels
};

/// How a step is divided. Each sub-step but the first moves the head by half a voxel, and the first by the rest. A path
/// that is slightly longer and needs one more sub-step thus has nearly the same force, which an implicit coupling
/// needs. Each may be divided once more into equal parts, which follow a crushed layer.
struct Sweep {
  int sub_steps = 1;
  double rest = 0;  // [1] of the step's duration, each sub-step but the first
  int parts = 1;    // of each sub-step

  [[nodiscard]] int count() const noexcept { return sub_steps * parts; }
  /// [1] Duration, end, and weight of the force of a part of a sub-step. At the end of sub-steps, the force of the last
  /// part is that of the sub-step, as without parts.
  [[nodiscard]] double duration(int index) const noexcept { return whole(index / parts) / parts; }
  [[nodiscard]] double end(int index) const noexcept {
    const int later_sub_steps = sub_steps - 1 - index / parts, later_parts = parts - 1 - index % parts;
    return 1 - later_sub_steps * rest - later_parts * duration(index);
  }
  [[nodiscard]] double weight(int index, ContactTime time) const noexcept {
    if (time == ContactTime::middle) return duration(index);
    return index % parts == parts - 1 ? whole(index / parts) : 0.0;
  }

 private:
  [[nodiscard]] double whole(int sub_step) const noexcept { return sub_step > 0 ? rest : 1 - (sub_steps - 1) * rest; }
};

/// The load of the contact on the motor.
struct SpindleLoad {
  double torque = 0;        // [N·m] about +z; of a stalled head, the torque that would turn it
  double hand_speed = 0;    // [m/s] maximum speed of the head's points without the spin
  double first_torque = 0;  // [N·m] prediction from the sub-step before
  double first_speed = 0;   // [rad/s] of the motor under that torque
  bool settled = false;     // the prediction was nearly right
};

/// The observers of a simulation.
struct Observers {
  std::array<StepObserver*, Simulation::kMaxObservers> places = {};
  std::size_t count = 0;
  [[nodiscard]] std::span<StepObserver* const> all() const noexcept { return {places.data(), count}; }
};

/// @throws Error when a head does not suit voxels of a size [m]
void validate_head(const ToolHead& head, double voxel_size);

struct Simulation::State {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of their making
  State(Workpiece given_workpiece, Tool given_tool, SimulationConfig given_config);
  void prepare_workpiece();
  void set_contact_materials() noexcept;
  void set_material_friction() noexcept;
  void compare_cutters() noexcept;
  void halt() noexcept;
  void set_motor(double setting) noexcept;
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
  [[nodiscard]] bool start_tool(bool coupled) noexcept;
  [[nodiscard]] bool is_placed_elsewhere(const Pose& X_WH, const Twist& V_WH, double dt) const noexcept;
  [[nodiscard]] bool is_jump() const noexcept;
  [[nodiscard]] bool jumps_into_material(const Pose& X_WH) noexcept;
  [[nodiscard]] StepStatus follow_jump() noexcept;
  void place_at(const Pose& X_WH) noexcept;
  [[nodiscard]] Sweep plan_sweep(const Pose& from, const Pose& to) const noexcept;
  [[nodiscard]] Sweep sweep_between(const Pose& from, const Pose& to) const noexcept;
  [[nodiscard]] double farthest_between(const Pose& from, const Pose& to) const noexcept;
  [[nodiscard]] double crushing_depth_in(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  [[nodiscard]] int sub_steps_between(const Pose& from, const Pose& to) const noexcept {
    return sweep_between(from, to).sub_steps;
  }
  [[nodiscard]] SubStep plan_sub_step(const Pose& from, double end, double duration, const Twist& path,
                                      const Twist& felt) const noexcept;
  [[nodiscard]] std::span<const FoundBlock> find_blocks(const SubStep& sub_step) noexcept;
  void drive_spindle(std::span<const FoundBlock> blocks, SubStep& sub_step) noexcept;
  void set_spin(HeadPlacement& head) const noexcept;
  [[nodiscard]] double turning_spin() const noexcept;
  void load_spindle(double torque, SubStep& sub_step) noexcept;
  [[nodiscard]] double torque_to_spin(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  void book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept;
  void advance_spindle(const SubStep& sub_step, const Encounter& encounter) noexcept;
  [[nodiscard]] double cutting_share() const noexcept;
  [[nodiscard]] Encounter press_and_cut(std::span<const FoundBlock> blocks, const SubStep& sub_step) noexcept;
  void note_touches(std::span<const FoundBlock> blocks, const SubStep& sub_step) noexcept;
  void remove_emptied() noexcept;
  void hold_deep_contact(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] DeepContact::Outcome hold(const SubStep& sub_step, const Encounter& encounter,
                                          DeepContact& deep) noexcept;
  void add_friction(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] LimitSurface::Outcome pull_of_anchor(const SubStep& sub_step, const Encounter& encounter,
                                                     LimitSurface& anchor) noexcept;
  void book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void transport_to_handle(const SubStep& sub_step, const Encounter& encounter, double weight) noexcept;
  [[nodiscard]] Contact contact_of(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  void give_output(HandCoupling* coupling) noexcept;
  void finish_step(int sub_steps, const Twist& path) noexcept;
  void reject(StepStatus status) noexcept;
  void tell_of_step(const Simulation& simulation) const noexcept {
    for (StepObserver* observer : observers.all())
      observer->on_step({simulation, steps - 1, input, free_blocks, after_release, after_halt, after_set, held,
                         motor.setting(), output_path, hand, result});
  }
  void tell_of_exchange() noexcept {
    ++exchanges;
    for (StepObserver* observer : observers.all()) observer->on_exchange();
  }

  // Stages without a change: `Simulation::probe`.
  [[nodiscard]] bool touches(const Pose& X_WH, double deeper_than = 0) noexcept;
  [[nodiscard]] bool is_in_material(const Pose& X_WH) noexcept;
  [[nodiscard]] ContactProbe probe_path(const Pose& from, const Pose& to, const Sweep& sweep, const Twist& V_WH,
                                        double dt) noexcept;
  [[nodiscard]] Stiffness measure_stiffness(const Pose& from, const Pose& to, const Sweep& sweep, const Twist& V_WH,
                                            double dt, int axes, const Wrench& felt) noexcept;
  [[nodiscard]] ContactProbe probe_sub_step(const SubStep& sub_step, DeepContact& deep,
                                            LimitSurface& friction) noexcept;

  Workpiece workpiece;
  Tool tool;
  bool chooses_stiffness;  // from the head and the materials
  SimulationConfig config;

  // Derived from them at set-up.
  ContactStages contact_stages;
  Pose X_VW;
  double voxel_volume = 0;  // [m^3]
  HeadStiffness head_stiffness;

  // What one step hands to the next. A recording holds or repeats all of it, and a copy has it: a new member that a
  // step depends on needs a line in the table of src/io/recording/recorder.cpp and a place in simulation_memory.cpp.
  bool has_pose = false;
  bool other_cutter = false;          // the materials are for another kind of cutter
  bool parted = false;                // the tool from its hand, by an exchange
  Pose last_X_WH;                     // at the end of the last accepted step
  bool after_refusal = false;         // the last step's input was refused
  std::optional<Vec3> mean_velocity;  // [m/s] of To, in W, over the last steps
  std::optional<Pose> jumped_to;      // input of the last step, if that was a jump
  SpindleMotor motor;
  SpindleLoad load;
  DeepContact deep_contact;   // in W
  double crushing_depth = 0;  // [m] of the last sub-step (crushing_depth_in)
  LimitSurface anchor;        // of dry friction, in W
  Output output;

  StepInput input;  // of the last step
  std::uint64_t steps = 0;
  std::size_t free_blocks = 0;       // when the last step began
  bool hand_released_since = false;  // the hand was released since the last step
  bool after_release = false;        // the hand was released before this step
  bool held = false;                 // the spindle is held at standstill
  double held_setting = 0;           // [rad/s] its speed setting meanwhile
  bool halted_since = false;         // the spindle was halted since the last step
  bool after_halt = false;           // the spindle was halted before this step
  bool set_since = false;            // the speed of the motor was set since the last step, after its last halt
  bool after_set = false;            // the speed of the motor was set before this step, after its last halt
  bool altered = false;              // the workpiece was changed, but not by a step
  OutputPath output_path = OutputPath::direct;
  HandOutput hand;  // of the coupling, in the last step
  std::uint64_t exchanges = 0;
  std::uint64_t replacements = 0;  // of the whole workpiece
  Observers observers;

  RemovalRecord removal;
  ByMaterial<double> detached_volume = {};          // [m^3] by MaterialId
  MaterialSet touched, first_touched;               // since construction or reset; for the first time, in the last step
  ByMaterial<std::uint64_t> first_touch_step = {};  // `steps` in which a material was first touched; 0: not yet
  StepResult result;
  mutable StageTimes times;
};

}  // namespace hapticut
