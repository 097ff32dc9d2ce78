// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/core/device_state.hpp"
#include "hapticut/simulation/simulation.hpp"

/// @file
/// The virtual coupling: the hand feels hard bone although its device renders only a soft spring.
namespace hapticut {

/// The spring and damper between the hand's handle and that of the simulated tool, and the mass of the latter.
struct CouplingGains {
  double mass = 0.05;
  double stiffness = 700;
  double damping = 12;
  double max_force = std::numeric_limits<double>::infinity();
  double max_torque = std::numeric_limits<double>::infinity();

  /// A device without motors for torque needs 0; the torque of the contact is then passed through.
  double angular_stiffness = 0;
  double angular_damping = 0;
  double inertia = 2e-5;
  int newton_steps = 100;
};

constexpr auto fields_of(Of<CouplingGains>) {
  using G = CouplingGains;
  return std::tuple{
      field("mass", &G::mass, "kg", Range::positive(), "of the simulated tool, at its handle point"),
      field("stiffness", &G::stiffness, "N/m", Range::positive(), "k_T"),
      field("damping", &G::damping, "N s/m", Range::between(0, 1e6), "b_T"),
      field("max_force", &G::max_force, "N", Range::limit(), "of spring and damper together"),
      field("max_torque", &G::max_torque, "N m", Range::limit(), "of spring and damper together"),
      field("angular_stiffness", &G::angular_stiffness, "N m/rad", Range::between(0, 1e6),
            "k_R; 0: the tool has the orientation of the hand"),
      field("angular_damping", &G::angular_damping, "N m s/rad", Range::between(0, 1e6), "b_R"),
      field("inertia", &G::inertia, "kg m^2", Range::positive(),
            "of the simulated tool about its handle point, the same about all axes"),
      field("newton_steps", &G::newton_steps, "1", Range::between(32, 400),
            "at most in a tick, shared by its parts; one a part is enough where the tool moves steadily, corners of "
            "hard faces take ten"),
  };
}

/// @throws Error naming the field, its value and the allowed range
void validate(const CouplingGains& gains);

/// Gains that respect what the device says it renders: its stiffness, the damping that just keeps the tool from
/// swinging but no more than the device's, and no more force and torque than its peak. The tool's inertia goes with its
/// mass.
/// @param mass  [kg] of the simulated tool; by default 0.05, or less where the device's damping would be below 0.7 of
/// the critical one
/// @throws Error when the device promises no stiffness, or so little damping that a tool of this mass would ring, at
/// less than half of the critical damping (the message has the largest mass that does not), or by default one of less
/// than a gram
[[nodiscard]] CouplingGains coupling_gains(const DeviceCapabilities& device, std::optional<double> mass = {});

/// Where the work of the hand went on its way to the tool, since it took the tool; accumulated, but `spring` and
/// `kinetic`, which are stored at the end of the last tick.
struct CouplingEnergy {
  double hand_work = 0;
  double tool_work = 0;
  double spring = 0;
  double damper = 0;
  double kinetic = 0;
  double implicit = 0;
  double turnover = 0;

  /// [J] hand_work less everything else; 0 when the ledger closes. Left over: what is not solved to the last digit.
  [[nodiscard]] double imbalance() const { return hand_work - tool_work - spring - damper - kinetic - implicit; }

  /// [1] relative to the turnover.
  [[nodiscard]] double closure() const { return turnover > 0 ? imbalance() / turnover : 0.0; }
};

constexpr auto fields_of(Of<CouplingEnergy>) {
  using E = CouplingEnergy;
  return std::tuple{
      field("hand_work", &E::hand_work, "J", "work done by the hand on the coupling"),
      field("tool_work", &E::tool_work, "J", "what of it reached the simulation: EnergyLedger::hand_work"),
      field("spring", &E::spring, "J", "stored in the coupling"),
      field("damper", &E::damper, "J", "dissipated in it, and in the brake"),
      field("kinetic", &E::kinetic, "J", "of the simulated tool"),
      field("implicit", &E::implicit, "J", "what the implicit steps of spring and mass dissipate, never negative"),
      field("turnover", &E::turnover, "J",
            "hand_work, tool_work, damper and implicit of each step without their signs"),
  };
}

/// What one tick of the coupling gives.
struct CoupledResult {
  Wrench hand;      ///< about Ho of the hand, in W: what the hand feels, with effects and limits
  Wrench coupling;  ///< the same without them
  Pose X_WH;        ///< of the simulated tool's handle: what is to be shown
  Twist V_WH;       ///< of its Ho, in W
  std::span<const RemovedVoxel> removed_voxels;  ///< emptied in this tick; valid until the next one
  double removed_volume = 0;                     ///< [m^3] taken away in this tick
  ChangedBlocks changed_blocks;                  ///< in this tick
  int parts = 0;                                 ///< steps of the simulation: more than one where the tool is fast
  int newton_steps = 0;                          ///< in all of them
  int level_of_detail = 1;                       ///< Contact::level_of_detail, the largest of them
  StepStatus status = StepStatus::ok;            ///< of the simulation's steps
  CouplingEnergy energy;
};

/// A simulation behind a virtual coupling.
///
/// The simulated tool of mass m hangs on a spring and a damper between it and the hand (thesis 5.4), and is pushed by
/// the material. Each tick solves for its twist V at the end, all forces taken there (backward Euler):
///
///     M (V - V_before)/dt = F_contact(X) + k_T (x_hand - x) + b_T (v_hand - v),   X = X_before moved by V dt
///
/// by Newton's method with the contact's stiffness from `Simulation::probe`, starting from the twist of the last tick.
/// Then the simulation takes its step to X. Where the tool would move by more than half a voxel, the tick is cut into
/// up to eight equal parts, which share its Newton steps. So the contact is stable however stiff the material is, the
/// tool stays on the surface, and the hand feels at most the coupling.
///
/// In a corner of faces that a spinning head drags along, whose sides cut with a ratio of 3 and more, there is no
/// steady balance: the motor throws the tool about. A tool that turns is braked, as the flesh of a hand would brake it,
/// also where it breaks through a plate: beyond the hand's speed and v_0 = 0.1 m/s by b (1 - v_0/v) V, b = 60 N s/m.
/// The hand does not feel the brake, and StepStatus::tool_braked says so.
///
/// Gains: k_T and b_T must be what the device renders stably at its rate; see docs/devices.md.
class VirtualCoupling {
 public:
  /// @param simulation  with SimulationConfig::contact_time = end; it must outlive the coupling, which steps it
  /// @throws Error when a gain is out of range, or the simulation evaluates contact elsewhere
  VirtualCoupling(Simulation& simulation, const CouplingGains& gains);

  /// The hand has moved: moves the tool after it, through the material.
  ///
  /// At first, and after `reset`, the tool is put where the hand is when that is in no material, and waits until
  /// then; where the simulation had a tool somewhere before the coupling was made, it waits there for the hand. After
  /// `park` it waits for the hand, and likewise (Rejoin::free) after an exchange of the simulation's workpiece, tool
  /// or materials: `undo`, `redo`, `restore`, `reset`, `set_tool` ...; and when the hand has turned by nearly half a
  /// turn against a tool that could not follow.
  /// @param X_WD      pose of the hand's handle at the end of the tick
  /// @param V_WD      velocity [m/s] of its Ho and [rad/s], in W, as the device estimates it; drives the damper. One
  /// that says
  ///                  thirty times the way of the poses, as mm/s do, is StepStatus::velocity_rejected
  /// @param dt        [s] since the last call
  /// @return valid until the next call. An input that is refused, or to which no motion of a hand leads
  /// (StepStatus::jump_rejected), gives no force, and the tool stays where it was. It goes on from there when the hand
  /// comes back within 2 mm of where it was, is put where the hand is when that is in no material, and waits otherwise:
  /// StepStatus::tool_waits.
  /// @realtime no allocation, no lock, no exception; at most the contacts of `worst_case`
  const CoupledResult& step(const Pose& X_WD, const Twist& V_WD, double dt) noexcept;

  /// The most that a tick may have to do: that of a step in as many contacts as Newton's method may ask for, and one a
  /// part that cuts. A law of your own is asked four times in a contact, seven times where the coupling turns the tool.
  [[nodiscard]] WorstCase worst_case() const;

  /// What the parts of a tick have changed, together: as long as a tool may make the lists.
  struct Lists {
    Lists(const WorstCase& worst_case, const SimulationConfig& config);
    std::vector<RemovedVoxel> removed;
    std::vector<VoxelIndex> changed;
  };

  /// Goes on with other lists, because the simulation has another tool; `lists` are the old ones then. What that tool
  /// is in must not be felt: `park` or `reset` as well.
  /// @realtime no allocation, no lock; O(1)
  void exchange_lists(Lists& lists) noexcept;

  /// Lets go: the next tick puts the tool where the hand is, or the first one in which that is in no material.
  void reset() noexcept {
    waits_ = waits_ || held_;
    held_ = false;
  }

  /// When a tool that was left goes with its hand again.
  enum class Rejoin : std::uint8_t {
    near,  ///< when the hand is within 2 mm of where it was, and goes on from there; or as `free`
    free,  ///< the same where the tool touches nothing by then; or when it would touch nothing where the hand is: put
           ///< there
  };

  /// Leaves the tool where it is, standing; before the first step, where the hand will be. Until they join, `step`
  /// gives no force: StepStatus::tool_waits.
  /// @realtime no allocation, no lock; O(1)
  void park(Rejoin rejoin) noexcept;

  /// Other gains from the next step on; what spring and tool store more by that is CouplingEnergy::hand_work. While the
  /// tool is pulled the force jumps.  @pre they are valid
  void set_gains(const CouplingGains& gains) noexcept;

  [[nodiscard]] const CouplingGains& gains() const { return gains_; }
  [[nodiscard]] const CoupledResult& last_result() const { return result_; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }

 private:
  /// Spring and damper within their limit: the force is that in a ball of its size that is nearest to their sum, so
  /// that the damper takes whatever the spring, which has an energy of its own in it, does not store.
  struct Limited {
    Vec3 force, spring;  // [N] or [N m] of both, and of the spring alone
    Mat3 slope;          // [1] of the force against the sum
  };
  [[nodiscard]] static Limited limited(const Vec3& spring, const Vec3& damper, double largest) noexcept;

  /// The coupling with the tool at a pose.
  struct Pull {
    Vec3 stretch, turn;  // [m], [rad] from the tool to the hand
    Limited linear, angular;
    Wrench wrench;     // on the tool
    Vec3 brake;        // [N] on the tool alone, and
    Mat3 brake_slope;  // [N s/m] against its velocity
  };

  static constexpr int kMaxParts = 8;
  static constexpr int kMinSteps = 2;  // that are kept for each part
  // What may lack after many steps, by itself [N] and of the largest force [1].
  static constexpr double kFarBalance = 10e-3, kFarShare = 1e-2;

  [[nodiscard]] int plan_parts(double dt) const noexcept;
  void begin_tick() noexcept;
  class Answer;
  class NewtonSearch;

  /// A part of a tick.
  struct Part {
    Pose X_WD;    // of the hand, at its end
    double dt;    // [s]
    int left;     // of the tick, after it
    double tick;  // [s] all of it
  };

  StepStatus move(const Part& part, const Twist& hand_path, const Twist& hand) noexcept;
  void keep_lists(const StepResult& stepped) noexcept;
  [[nodiscard]] Pull pull(const Pose& X_WH, const Twist& tool, const Pose& X_WD, const Twist& hand) const noexcept;
  void brake(Pull& pull, const Vec3& tool, const Vec3& hand) const noexcept;
  [[nodiscard]] double kinetic_energy(const Twist& tool) const noexcept;
  [[nodiscard]] double spring_energy(const Pull& pull) const noexcept;
  void book(const Pull& before, const Pull& after, const Twist& tool_before, const Twist& hand_path, double tool_work,
            double dt) noexcept;
  void begin_grip(const Pose& pose, const Twist& velocity, double dt) noexcept;
  void part_after_exchange() noexcept;
  [[nodiscard]] bool velocity_fits(const Pose& pose, const Twist& velocity, double dt) noexcept;
  [[nodiscard]] bool is_jump(const Pose& pose, double dt) const noexcept;
  [[nodiscard]] bool is_rotated_away(const Pose& pose) const noexcept;
  [[nodiscard]] bool is_near(const Pose& pose) const noexcept;
  [[nodiscard]] bool may_continue_from_here(const Pose& pose) const noexcept;
  [[nodiscard]] double reach() const noexcept;
  const CoupledResult& wait(StepStatus status) noexcept;
  [[nodiscard]] bool turns() const { return gains_.angular_stiffness > 0; }

  Simulation* simulation_;
  CouplingGains gains_;
  bool held_ = false;
  bool is_somewhere_ = false;  // the tool, since it was first put somewhere
  bool waits_ = true;          // at first, and since it was left, or an input refused
  Rejoin rejoin_ = Rejoin::near;
  Pose X_WD_;  // of the hand, at the end of the last part

  /// How far the hand has moved lately, by its poses and by its velocities.
  struct Way {
    double linear = 0, angular = 0, time = 0;  // [m], [rad], [s] of a tenth of a second, fading
    void add(const Twist& velocity, double dt) noexcept;
  };
  std::optional<Pose> given_;  // pose of the hand in the last tick
  Way by_pose_, by_velocity_;

  Lists lists_;
  CoupledResult result_;
};

constexpr auto names_of(Of<VirtualCoupling::Rejoin>) {
  using enum VirtualCoupling::Rejoin;
  return std::array{Named{near, "near"}, Named{free, "free"}};
}

}  // namespace hapticut
