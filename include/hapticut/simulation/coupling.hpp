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
#include "hapticut/simulation/simulation.hpp"

/// The virtual coupling. It lets the hand feel hard bone although the device renders only a soft spring.
namespace hapticut {

/// The spring and damper between the hand's handle and the handle of the simulated tool, and the mass of that tool.
struct CouplingGains {
  /// [kg] mass of the simulated tool, at its handle point
  double mass = 0.05;
  double stiffness = 700;                                       ///< [N/m] k_T; 0.7 N/mm are 700 N/m
  double damping = 12;                                          ///< [N s/m] b_T
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] largest force of spring and damper together
  double max_torque = std::numeric_limits<double>::infinity();  ///< [N m] largest torque of spring and damper together

  /// [N m/rad] k_R; 0: the tool has the orientation of the hand.
  /// A device without motors for torque needs 0; the torque of the contact then passes to the hand unchanged.
  double angular_stiffness = 0;
  double angular_damping = 0;  ///< [N m s/rad] b_R
  /// [kg m^2] inertia of the simulated tool about its handle point, equal about all axes
  double inertia = 2e-5;
  /// [1] Newton steps of a tick, for contacts of 250 voxels and more; smaller ones have as many as take the same time,
  /// a tick of two sub-ticks twice as many, and one of more, or of two in at least 1.5 ms, four times. It needs one
  /// in steady motion, and three in a cut. To measure the stiffness of a custom law takes as long as six, or three
  /// without torque
  int newton_steps = 9;
};

constexpr auto fields_of(Of<CouplingGains>) {
  using G = CouplingGains;
  return std::tuple{
      field("mass", &G::mass, "kg", Range::between(1e-4, 10), "mass of the simulated tool, at its handle point"),
      field("stiffness", &G::stiffness, "N/m", Range::between(5, 1e6), "k_T; 0.7 N/mm are 700 N/m"),
      field("damping", &G::damping, "N s/m", Range::between(0, 1e6), "b_T"),
      field("max_force", &G::max_force, "N", Range::limit(), "largest force of spring and damper together"),
      field("max_torque", &G::max_torque, "N m", Range::limit(), "largest torque of spring and damper together"),
      field("angular_stiffness", &G::angular_stiffness, "N m/rad", Range::between(0, 1e6),
            "k_R; 0: the tool has the orientation of the hand"),
      field("angular_damping", &G::angular_damping, "N m s/rad", Range::between(0, 1e6), "b_R"),
      field("inertia", &G::inertia, "kg m^2", Range::positive(),
            "inertia of the simulated tool about its handle point, equal about all axes"),
      field("newton_steps", &G::newton_steps, "1", Range::between(8, 400),
            "Newton steps of a tick, for contacts of 250 voxels and more; smaller ones have as many as take the same "
            "time, a tick of two sub-ticks twice as many, and one of more, or of two in at least 1.5 ms, four times. "
            "It needs one in steady motion, and three in a cut. To measure the stiffness of a custom law takes as long "
            "as six, or three without torque"),
  };
}

/// @throws Error naming the field, its value and the allowed range
void validate(const CouplingGains& gains);

/// Where the work of the hand went on its way to the tool, since the hand took the tool. All terms are accumulated,
/// except `spring` and `kinetic`, which are the energies stored at the end of the last tick.
struct CouplingEnergy {
  double hand_work = 0;  ///< [J] work done by the hand on the coupling
  /// [J] the part of it that reached the simulation, by the contact's wrench at the end of each step;
  /// EnergyLedger::hand_work is that along the path
  double tool_work = 0;
  double spring = 0;    ///< [J] stored in the coupling
  double damper = 0;    ///< [J] dissipated in the coupling and in the brake
  double kinetic = 0;   ///< [J] energy of the simulated tool
  double implicit = 0;  ///< [J] dissipated by the implicit integration of spring and mass, never negative
  double turnover = 0;  ///< [J] sum of the magnitudes of hand_work, tool_work, damper and implicit of each step

  /// [J] hand_work less everything else; 0 when the ledger closes. The remainder is the error of the iteration.
  [[nodiscard]] double imbalance() const { return hand_work - tool_work - spring - damper - kinetic - implicit; }

  /// [1] imbalance relative to the turnover; 0 before any work.
  [[nodiscard]] double closure() const { return turnover > 0 ? imbalance() / turnover : 0.0; }
};

constexpr auto fields_of(Of<CouplingEnergy>) {
  using E = CouplingEnergy;
  return std::tuple{
      field("hand_work", &E::hand_work, "J", "work done by the hand on the coupling"),
      field("tool_work", &E::tool_work, "J",
            "the part of it that reached the simulation, by the contact's wrench at the end of each step; "
            "EnergyLedger::hand_work is that along the path"),
      field("spring", &E::spring, "J", "stored in the coupling"),
      field("damper", &E::damper, "J", "dissipated in the coupling and in the brake"),
      field("kinetic", &E::kinetic, "J", "energy of the simulated tool"),
      field("implicit", &E::implicit, "J", "dissipated by the implicit integration of spring and mass, never negative"),
      field("turnover", &E::turnover, "J",
            "sum of the magnitudes of hand_work, tool_work, damper and implicit of each step"),
  };
}

/// The result of one tick of the coupling.
struct CoupledResult {
  Wrench hand;      ///< about Ho of the hand, in W: what the hand feels, with effects and limits
  Wrench coupling;  ///< about Ho of the hand, in W, without effects and limits
  Pose X_WH;        ///< pose of the simulated tool's handle, to be displayed
  Twist V_WH;       ///< velocity of the handle's origin Ho, in W
  std::span<const RemovedVoxel> removed_voxels;  ///< emptied in this tick; valid until the next one
  double removed_volume = 0;                     ///< [m^3] removed in this tick
  ChangedBlocks changed_blocks;                  ///< blocks that changed in this tick
  int sub_ticks = 0;                             ///< steps of the simulation: more than one where the tool is fast
  int newton_steps = 0;                          ///< sum over the simulation's steps
  int level_of_detail = 1;                       ///< the maximum Contact::level_of_detail of these steps
  StepStatus status = StepStatus::ok;            ///< bits of the simulation's steps and of the coupling
  MaterialSet first_touched;                     ///< materials of this tick: Simulation::first_touched of all its steps
  CouplingEnergy energy;
};

/// A simulation behind a virtual coupling.
///
/// A spring and a damper connect the simulated tool of mass m to the hand (thesis 5.4), and the material pushes it.
/// Each tick solves for its twist V at the end of the tick, with all forces taken there (backward Euler):
///
///     M (V - V_before)/dt = F_contact(X) + k_T (x_hand - x) + b_T (v_hand - v),   X = X_before moved by V dt
///
/// by Newton's method, with the contact's stiffness from `Simulation::probe`, starting from the twist of the last tick.
/// Then the simulation takes its step to X. If the tool would move by more than half a voxel, the tick is split into up
/// to eight equal sub-ticks, which share its Newton steps. So the contact is stable however stiff the material is, the
/// tool stays on the surface, and the hand feels at most the coupling.
///
/// The search has few steps, because it must end within the tick, and where the force jumps, as at an edge of the head,
/// there is no balance. What is left of it accelerates the tool in the next sub-tick, as far as this makes no energy,
/// so that the forces are in balance in the mean of some sub-ticks.
///
/// In a corner between faces that cut with a ratio of 3 or more, a spinning head has no steady balance: the motor
/// throws the tool about. So a tool whose spindle turns is braked, as the flesh of a hand would brake it. The brake
/// also acts when the tool breaks through a plate. At a speed v of the tool and v_h of the hand its
/// force is -b (1 - (v_h + v_0)/v) V if v > v_h + v_0, else 0, with v_0 = 0.1 m/s and b = 60 N s/m. The hand does not
/// feel the brake. StepStatus::tool_braked reports a brake above a tenth of the force between tool and material.
///
/// Gains: k_T and b_T must be what the device renders stably at its rate; see docs/devices.md.
class VirtualCoupling {
 public:
  /// Lists of what all sub-ticks of a tick have changed, with memory for the longest lists that a tool can make.
  struct Lists {
    /// No lists: CoupledResult::removed_voxels stays empty, and `changed_blocks` is not complete.
    Lists() = default;
    Lists(const WorstCase& worst_case, const SimulationConfig& config);
    std::vector<RemovedVoxel> removed;
    std::vector<VoxelIndex> changed;
  };

  /// @param simulation  with SimulationConfig::contact_time = end; it must outlive the coupling, which steps it
  /// @throws Error when a gain is out of range, or the simulation evaluates contact elsewhere
  VirtualCoupling(Simulation& simulation, const CouplingGains& gains);
  /// Likewise, with other lists: none (`Lists{}`) where nobody reads them.
  VirtualCoupling(Simulation& simulation, const CouplingGains& gains, Lists lists);

  /// Takes the motion of the hand, and moves the tool after it through the material.
  ///
  /// In the first tick, and after `reset`, the tool is placed at the hand as soon as it would touch no material there;
  /// until then it waits. If the simulation already had a tool in the workpiece before the coupling was made, that tool
  /// waits where it is. The tool also waits for the hand after `park`; after an exchange of the simulation's workpiece,
  /// tool or materials (`undo`, `redo`, `restore`, `reset`, another tool ...; as Rejoin::free); and when the hand has
  /// rotated by nearly half a revolution against a tool that could not follow.
  /// @param X_WD      pose of the hand's handle at the end of the tick
  /// @param V_WD      velocity [m/s] of its Ho and angular velocity [rad/s], in W, as the device estimates it; drives
  /// the damper. A velocity thirty times that of the poses, such as one in mm/s, is StepStatus::velocity_rejected
  /// @param dt        [s] since the last call
  /// @return valid until the next call. A rejected input, or one to which no motion of a hand leads
  /// (StepStatus::jump_rejected), gives no force, and the tool stays where it was. It continues from there when the
  /// hand comes back to within 2 mm of its last pose, is placed at the hand when it would touch no material there, and
  /// waits otherwise: StepStatus::tool_waits.
  /// @realtime no allocation, no lock, no exception; at most the contacts of `worst_case`
  const CoupledResult& step(const Pose& X_WD, const Twist& V_WD, double dt) noexcept;

  /// Upper bound on the work of a tick: the bound of a step, for as many contacts as Newton's method may evaluate plus
  /// one for each sub-tick. For a custom law this includes what measures its stiffness.
  [[nodiscard]] WorstCase worst_case() const;

  /// Swaps in lists for another tool of the simulation; `lists` receives the old ones. Call `park` or `reset` as well,
  /// so that the hand does not feel the material that the new tool is in.
  /// @realtime no allocation, no lock; O(1)
  void exchange_lists(Lists& lists) noexcept;

  /// Releases the tool from the hand. The next tick in which it would touch no material places it at the hand.
  void reset() noexcept {
    waits_ = waits_ || gripped_;
    gripped_ = false;
    given_.reset();
  }

  /// When a parked tool follows its hand again.
  enum class Rejoin : std::uint8_t {
    near,  ///< when the hand is within 2 mm of where it was, and the tool continues from its place; or as `free`
    free,  ///< as `near`, if the tool touches nothing at its place; or when it would touch nothing at the hand, where
           ///< it is then placed
  };

  /// Parks the tool: it stays where it is, at rest, until the hand rejoins it. Before the first step it is parked where
  /// the hand will be. Until they join, `step` gives no force: StepStatus::tool_waits.
  /// @realtime no allocation, no lock; O(1)
  void park(Rejoin rejoin) noexcept;

  /// Sets the gains from the next step on. Energy that this adds to spring and tool is CouplingEnergy::hand_work. While
  /// the spring is stretched, the force jumps.  @pre they are valid
  void set_gains(const CouplingGains& gains) noexcept;

  [[nodiscard]] const CouplingGains& gains() const { return gains_; }
  [[nodiscard]] const CoupledResult& last_result() const { return result_; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }

 private:
  /// Spring and damper within their limit: their sum, shortened to the limit. The damper receives whatever part of it
  /// the spring, which stores energy within the same limit, does not account for.
  struct Limited {
    Vec3 force, spring;  // [N] or [N m] of both, and of the spring alone
    Mat3 slope;          // [1] slope of the force against the sum
  };
  [[nodiscard]] static Limited limited(const Vec3& spring, const Vec3& damper, double max_size) noexcept;

  /// The coupling with the tool at a pose.
  struct CouplingForces {
    Vec3 stretch, rotation;  // [m], [rad] from the tool to the hand
    Limited linear, angular;
    Wrench wrench;     // on the tool
    Vec3 brake;        // [N] on the tool alone
    Mat3 brake_slope;  // [N s/m] how it falls with the velocity
  };

  static constexpr int kMaxSubTicks = 8;
  // Residual that is accepted after many steps: an absolute part [N], and a part of the largest force [1].
  static constexpr double kFarBalance = 10e-3, kFarFraction = 1e-2;

  [[nodiscard]] int plan_sub_ticks(double dt) const noexcept;
  void begin_tick() noexcept;
  class CoupledOutput;
  class NewtonSearch;

  /// An equal piece of a tick.
  struct SubTick {
    Pose X_WD;    // pose of the hand at its end
    double dt;    // [s]
    int left;     // sub-ticks of the tick after this one
    double tick;  // [s] duration of the whole tick
  };

  const CoupledResult& follow(const StepInput& hand) noexcept;
  StepStatus move(const SubTick& sub_tick, const Twist& hand_path, const Twist& hand) noexcept;
  void keep_lists(const StepResult& stepped) noexcept;
  [[nodiscard]] CouplingForces forces_at(const Pose& X_WH, const Twist& tool, const Pose& X_WD,
                                         const Twist& hand) const noexcept;
  void brake(CouplingForces& forces, const Vec3& tool, const Vec3& hand) const noexcept;
  [[nodiscard]] Twist accelerated() const noexcept;
  [[nodiscard]] Twist remainder_of(const Wrench& on_tool, const Twist& before, double dt) const noexcept;
  [[nodiscard]] double kinetic_energy(const Twist& tool) const noexcept;
  [[nodiscard]] double spring_energy(const CouplingForces& forces) const noexcept;
  void book(const CouplingForces& before, const CouplingForces& after, const Twist& tool_before, const Twist& hand_path,
            double tool_work, double dt) noexcept;
  void begin_grip(const Pose& X_WD, const Twist& V_WD, double dt) noexcept;
  void separate_after_exchange() noexcept;
  [[nodiscard]] bool velocity_fits(const Pose& X_WD, const Twist& V_WD, double dt) noexcept;
  [[nodiscard]] static bool is_jump(const Pose& from, const Pose& to, double dt) noexcept;
  [[nodiscard]] bool is_rotated_away(const Pose& X_WD) const noexcept;
  [[nodiscard]] bool is_near(const Pose& X_WD) const noexcept;
  [[nodiscard]] bool may_continue_from_here(const Pose& X_WD) const noexcept;
  [[nodiscard]] double reach() const noexcept;
  const CoupledResult& suspend(StepStatus status) noexcept;
  [[nodiscard]] bool has_torque() const { return gains_.angular_stiffness > 0; }

  Simulation* simulation_;
  CouplingGains gains_;
  bool gripped_ = false;
  bool is_placed_ = false;  // the tool has had a pose
  bool waits_ = true;       // at first, while parked, and after a rejected input
  Rejoin rejoin_ = Rejoin::near;
  Pose X_WD_;  // pose of the hand at the end of the last sub-tick

  /// Distance that the hand has moved lately, by its poses or by its velocities.
  struct Distance {
    double linear = 0, angular = 0, time = 0;  // [m], [rad], [s]; what is older than 0.1 s fades
    void add(const Twist& velocity, double dt) noexcept;
  };
  std::optional<Pose> given_;  // pose of the hand in the last tick
  Distance by_pose_, by_velocity_;

  Lists lists_;
  CoupledResult result_;
  int evaluated_ = 0;  // contacts in this tick, by the search
  Twist remainder_;    // that the last search left, and that V takes on in the next sub-tick
};

constexpr auto names_of(Of<VirtualCoupling::Rejoin>) {
  using enum VirtualCoupling::Rejoin;
  return std::array{Named{near, "near"}, Named{free, "free"}};
}

}  // namespace hapticut
