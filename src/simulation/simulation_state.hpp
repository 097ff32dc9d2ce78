// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "simulation/contact_stages.hpp"
#include "simulation/stage_timer.hpp"

/// @file
/// What a simulation holds, and the stages of its step.
namespace hapticut {

/// One equal part of the tool's motion during a step, seen where the contact is evaluated: at its middle or its end.
struct SubStep {
  double duration;     // [s]
  Pose X_WH;           // of the handle
  Pose X_WT;           // of the head
  Twist path_T;        // of To along the path, in T
  HeadPlacement head;  // the same for the stages that see voxels
};

/// What the contact takes of the motor.
struct SpindleLoad {
  double torque = 0;        // [N·m] about +z; of a stalled head, what it would take to turn it
  double hand_speed = 0;    // [m/s] of the head's fastest point, but for the spin
  double first_torque = 0;  // [N·m] of the sub-step before
  double first_speed = 0;   // [rad/s] of the motor, as that tells
  bool settled = false;     // they were nearly those of the sub-step
};

/// Who is told of steps.
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
  void start_afresh() noexcept;

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
  [[nodiscard]] bool take_up(bool coupled) noexcept;
  [[nodiscard]] bool is_put_elsewhere(const Pose& pose, const Twist& velocity, double dt) const noexcept;
  [[nodiscard]] bool is_jump(int sub_steps) const noexcept;
  [[nodiscard]] bool jumps_into_material(const Pose& pose) noexcept;
  [[nodiscard]] bool follow_jump() noexcept;
  void place_at(const Pose& pose) noexcept;
  [[nodiscard]] int plan_sweep(const Pose& from, const Pose& pose) const noexcept;
  [[nodiscard]] SubStep plan_sub_step(const Pose& from, int index, double duration, const Twist& path,
                                      const Twist& felt) const noexcept;
  [[nodiscard]] std::span<const CuttableBlock> find_blocks(const SubStep& sub_step) noexcept;
  void drive_spindle(std::span<const CuttableBlock> blocks, SubStep& sub_step) noexcept;
  void set_spin(HeadMotion& motion) const noexcept;
  [[nodiscard]] double turning_spin() const noexcept;
  void load_spindle(double torque, SubStep& sub_step) noexcept;
  [[nodiscard]] double torque_to_spin(const Encounter& encounter) const noexcept;
  void book_stalled(const SubStep& sub_step, Encounter& encounter) noexcept;
  void advance_spindle(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void update_cutting_share() noexcept;
  [[nodiscard]] Encounter press_and_cut(std::span<const CuttableBlock> blocks, const SubStep& sub_step) noexcept;
  void remove_emptied() noexcept;
  void hold_deep_contact(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] DeepContact::Outcome hold(const SubStep& sub_step, const Encounter& encounter,
                                          DeepContact& deep) noexcept;
  void add_friction(const SubStep& sub_step, Encounter& encounter) noexcept;
  [[nodiscard]] LimitSurface::Outcome pull_of_anchor(const SubStep& sub_step, const Encounter& encounter,
                                                     LimitSurface& anchor) noexcept;
  [[nodiscard]] Encounter press_standing(const SubStep& sub_step) noexcept;
  void book_energy(const SubStep& sub_step, const Encounter& encounter) noexcept;
  void transport_to_handle(const SubStep& sub_step, const Encounter& encounter, double share) noexcept;
  [[nodiscard]] Contact contact_of(const SubStep& sub_step, const Encounter& encounter) const noexcept;
  void give_output(HandCoupling* coupling) noexcept;
  void finish_step(int sub_steps, const Twist& path) noexcept;
  void reject(StepStatus status) noexcept;
  void tell_of_step(const Simulation& simulation) const noexcept {
    for (StepObserver* observer : observers.all())
      observer->on_step({simulation, steps - 1, input, free_blocks, after_release, after_halt, motor.setting(),
                         output_path, hand, result});
  }
  void tell_of_exchange() noexcept {
    ++exchanges;
    for (StepObserver* observer : observers.all()) observer->on_exchange();
  }

  // The same without a change: `Simulation::probe`.
  [[nodiscard]] bool touches(const Pose& pose) noexcept;
  [[nodiscard]] ContactProbe probe_path(const Pose& from, const Pose& pose, int sub_steps, const Twist& velocity,
                                        double dt) noexcept;
  [[nodiscard]] Stiffness measure_stiffness(const Pose& from, const Pose& pose, int sub_steps, const Twist& velocity,
                                            double dt, ProbedMotions motions, const Wrench& felt) noexcept;
  [[nodiscard]] ContactProbe probe_sub_step(const SubStep& sub_step, DeepContact& deep,
                                            LimitSurface& friction) noexcept;

  Workpiece workpiece;
  Tool tool;
  bool chooses_stiffness;  // by the head and the materials that are there
  SimulationConfig config;

  // Derived from them at set-up.
  ContactStages contact_stages;
  Pose X_VW;
  double voxel_volume = 0;    // [m^3]
  double head_stiffness = 0;  // [N/m^4] stiffness_for_head

  // What one step hands to the next.
  bool has_pose = false;
  bool other_cutter = false;          // than the one that materials are made for
  bool parted = false;                // from its hand, by an exchange
  Pose X_WH;                          // at the end of the last accepted step
  bool after_refusal = false;         // the last step's input was refused
  std::optional<Vec3> mean_velocity;  // [m/s] of To, in W, of the last time
  std::optional<Pose> jumped_to;      // what the last step was given, when that was a jump
  SpindleMotor motor;
  SpindleLoad load;
  double cutting_share = 1;  // [1] of the cutting ratio: what slow heads and stalled ones have of it
  DeepContact deep_contact;  // in W
  LimitSurface anchor;       // of dry friction, in W
  Output output;

  StepInput input;  // of the last step
  std::uint64_t steps = 0;
  std::size_t free_blocks = 0;       // when the last step began
  bool hand_released_since = false;  // the last step
  bool after_release = false;        // the last step was
  bool held = false;                 // the spindle, which then stands
  double held_setting = 0;           // [rad/s] that was asked of it
  bool halted_since = false;         // the spindle, since the last step
  bool after_halt = false;           // the last step was
  OutputPath output_path = OutputPath::direct;
  HandOutput hand;  // of the coupling, in the last step
  std::uint64_t exchanges = 0;
  Observers observers;

  RemovalRecord removal;
  ByMaterial<double> taken_volume = {};  // [m^3] by MaterialId
  StepResult result;
  mutable StageTimes times;
};

}  // namespace hapticut
