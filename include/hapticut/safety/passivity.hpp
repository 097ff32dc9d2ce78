// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// How the passivity controller watches. Forces and ways stand for torques and turns as well, compared by a lever
/// (PassivityController).
struct PassivityOptions {
  bool enabled = true;
  double credit = 0;
  double allowance = 0;

  /// What a force that is held between ticks gives back of a passive spring, k |dx|^2/2 a tick, is not held against
  /// it; with `delay`, 1 + 2 delay times as much. SafetyGuard fills in what the device renders.
  double stiffness = 0;
  double greatest = 0;

  /// Without a bound, a force of any size answers the smallest motion. SafetyGuard fills in what the device can render.
  double max_damping = 0;
  double slowest = 1e-6;
  double free = 1e-3;
  int delay = 0;
};

constexpr auto fields_of(Of<PassivityOptions>) {
  using O = PassivityOptions;
  return std::tuple{
      field("enabled", &O::enabled, "false: watches nothing and damps nothing"),
      field("credit", &O::credit, "J", Range::not_negative(),
            "that the model may have absorbed and give back later: more is forgotten; 0: what it says that it has "
            "stored, or all of it"),
      field("allowance", &O::allowance, "J", Range::not_negative(),
            "that the model may generate, for a device whose own friction takes it"),
      field("stiffness", &O::stiffness, "N/m", Range::not_negative(),
            "of the stiffest contact that counts as passive; 0: what the device renders"),
      field("greatest", &O::greatest, "N", Range::not_negative(), "of the damping; 0: the device's peak"),
      field("max_damping", &O::max_damping, "N s/m", Range::not_negative(), "of the damping at most; 0: no bound"),
      field("slowest", &O::slowest, "m/s", Range::positive(), "below which nothing is damped"),
      field("free", &O::free, "N", Range::not_negative(), "a shorter force counts as zero"),
      field("delay", &O::delay, "ticks", Range::between(0, 8),
            "between a written force and the one that acts, beyond the hold"),
  };
}

/// Watches how much energy a model puts into a hand, and takes out by damping what it should not have.
///
/// The account is of the contact: the force that was applied less its effects (weight, vibration). It is exact for a
/// force that is held between ticks (Stramigioli et al., Ryu et al.), and open while there is a force:
///
///     W(n) = min(W(n-1) - F · dx + (1 + 2 delay) k |dx|^2/2,  stored),   dx = x(n) - x(n-1)
///
/// F is the force of the last tick. Where encoders stood still for some ticks and then step by dx, the hand has moved
/// in all of them, and F is the mean since their last step (at most of the last 20 ms): otherwise each step would seem
/// to go with what is left of the answer to the one before, which no hand felt. Forces and ways have torques and turns
/// with them, T/lever and lever dtheta, in one account: of a hand that pivots about the tool's tip force and torque
/// each do work, and together none.
///
/// W > 0 is energy that went into the model and that it has stored; what it cut and rubbed away is forgotten. The term
/// with k is what holding the force of a passive spring gives back by itself. When W falls below minus the allowance,
/// a damping force `-a v` is added with `a = -W / (v^2 T)`, bounded by a damping and a force (time-domain passivity
/// control, Hannaford and Ryu 2002). It acts one tick late and is bounded by the device: a strong help, not a proof.
/// With the last force the account is closed: nothing is damped in free air.
///
/// A spindle that drags the tool sideways does generate energy; the controller then holds the hand back gently, which
/// is what a guard is for. Where the model says what its motor gave, that is added to W. Then all that the hand may get
/// is known, and in advance as well: of a force that pushes the hand on as it moves now, and a quarter faster, no more
/// is given than W + k |dx|^2/2 covers. It is what keeps the work from the hand that a turn of the tool does where no
/// motor renders the torque. In contact F is then the mean or the last force, whichever gives the hand more.
/// @realtime no allocation, no lock
class PassivityController {
 public:
  /// @param greatest         [N] of the damping, where the options do not say it
  /// @param lever            [m] sqrt(rotational stiffness/stiffness) of the device; 0: no torque is watched
  /// @param max_torque  [N m] of the damping
  /// @throws Error when an option is out of range
  PassivityController(const PassivityOptions& options, double greatest, double lever = 0, double max_torque = 0);

  /// What is known in a tick.
  struct Tick {
    Wrench asked;                      ///< by the model
    Wrench effects;                    ///< of it what is not of contact
    Wrench applied;                    ///< written to the device at the last tick
    Vec3 motion = Vec3::Zero();        ///< [m] of the device since the last tick
    Vec3 turn = Vec3::Zero();          ///< [rad] the same
    double dt = 0;                     ///< [s] since the last tick
    std::optional<double> stored;      ///< [J] by the model; empty: not known
    std::optional<double> motor = {};  ///< [J] that its motor gave since the last tick; empty: not known
    bool in_air = false;               ///< the tool touches nothing
  };

  /// @return the wrench with what damping it takes
  [[nodiscard]] Wrench control(const Tick& tick) noexcept;

  void restart() noexcept;

  [[nodiscard]] double stored() const { return stored_; }  ///< [J] W
  [[nodiscard]] double taken() const { return taken_; }    ///< [N] length of the damping force of the last tick

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  [[nodiscard]] Vector6 compared(const Wrench& wrench) const noexcept;
  [[nodiscard]] double work_of(const Vector6& acted, const Vector6& motion, double dt) noexcept;

  PassivityOptions options_;
  double max_, lever_, max_torque_;
  double stored_ = 0, taken_ = 0;
  double asked_ = 0;  // [N] for at the last tick
  Vector6 effects_;   // [N] of that
  Vector6 mean_;      // [N] that acted since the reading last stepped, along each axis
  Vector6 still_;     // [ticks] since then
  static constexpr auto kMaxDelay = std::size_t(range_of(&PassivityOptions::delay).high);
  std::array<Vector6, kMaxDelay> under_way_;
  int next_ = 0;
};

}  // namespace hapticut
