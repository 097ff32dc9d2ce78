// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// Settings of the passivity controller. They apply to torques and rotations as well, which a lever converts to forces
/// and distances (PassivityController).
struct PassivityOptions {
  bool enabled = true;  ///< whether the controller watches and damps
  /// [J] limit of the absorbed energy that the model may return later; 0: the energy that the model reports as stored,
  /// or no limit
  double credit = 0;
  double allowance = 0;  ///< [J] energy that the model may generate, for a device whose own friction absorbs it

  /// [N/m] stiffness of the stiffest contact that counts as passive; 0: that which the device renders.
  /// Holding the force of a passive spring between ticks returns energy, k |dx|^2/2 per tick, or 1 + 2 delay times as
  /// much with `delay`. The controller tolerates this energy. SafetyGuard fills in the stiffness that the device
  /// renders.
  double stiffness = 0;
  double max_force = 0;  ///< [N] limit of the damping force; 0: the device's peak

  /// [N s/m] limit of the damping; 0: no limit.
  /// Without a bound, the smallest motion could cause any force. SafetyGuard fills in the damping that the device can
  /// render.
  double max_damping = 0;
  double min_speed = 1e-6;  ///< [m/s] speed below which nothing is damped
  double free = 1e-3;       ///< [N] force below which the contact counts as free
  int delay = 0;            ///< [ticks] delay between writing a force and its effect, beyond the hold
};

constexpr auto fields_of(Of<PassivityOptions>) {
  using O = PassivityOptions;
  return std::tuple{
      field("enabled", &O::enabled, "whether the controller watches and damps"),
      field("credit", &O::credit, "J", Range::not_negative(),
            "limit of the absorbed energy that the model may return later; 0: the energy that the model reports as "
            "stored, or no limit"),
      field("allowance", &O::allowance, "J", Range::not_negative(),
            "energy that the model may generate, for a device whose own friction absorbs it"),
      field("stiffness", &O::stiffness, "N/m", Range::not_negative(),
            "stiffness of the stiffest contact that counts as passive; 0: that which the device renders"),
      field("max_force", &O::max_force, "N", Range::not_negative(), "limit of the damping force; 0: the device's peak"),
      field("max_damping", &O::max_damping, "N s/m", Range::not_negative(), "limit of the damping; 0: no limit"),
      field("min_speed", &O::min_speed, "m/s", Range::positive(), "speed below which nothing is damped"),
      field("free", &O::free, "N", Range::not_negative(), "force below which the contact counts as free"),
      field("delay", &O::delay, "ticks", Range::between(0, 8),
            "delay between writing a force and its effect, beyond the hold"),
  };
}

/// Measures how much energy a model puts into a hand, and removes by damping the energy that it should not put in.
///
/// The account covers the contact only: the applied force without its effects (weight, vibration). It is exact for a
/// force that is held between ticks (Stramigioli et al., Ryu et al.). It stays open as long as there is a force:
///
///     W(n) = min(W(n-1) - F · dx + (1 + 2 delay) k |dx|^2/2,  stored),   dx = x(n) - x(n-1)
///
/// F is the force of the last tick. If the encoders stand still for some ticks and then step by dx, the hand has moved
/// during all of these ticks. F is then the mean force since the last encoder step, over at most 20 ms. Otherwise each
/// step would be paired with the rest of the response to the step before, which the hand did not feel.
/// Torques and rotations enter the same account as T/lever and lever dtheta: when a hand pivots about the tool's tip,
/// force and torque each do work, but their sum does none.
///
/// W > 0 is energy that the model has absorbed and stored; energy lost by cutting and rubbing is not counted. The term
/// with k is the energy that holding the force of a passive spring returns. When W falls below minus the allowance, the
/// controller adds a damping force `-a v` that pays the debt back in 20 ms, limited by max_damping and max_force
/// (time-domain passivity control, Hannaford and Ryu 2002, but slower). The damping is limited by the device, so it
/// helps strongly but proves nothing. The account is closed when the force ends.
///
/// A spindle that drags the tool sideways does generate energy. The controller then holds the hand back slightly, as a
/// guard should. If the model reports the work of its motor, that work is added to W. Then all energy that the hand may
/// get is known: a force that pushes the hand on is reduced to the power of the motor, what W gives in 20 ms, and
/// k |dx|^2/2 per tick. This keeps from the hand the work that a rotation of the tool does when no motor renders the
/// torque. In contact F is then the mean force or the last force, whichever gives the hand more energy.
///
/// What the controller takes or adds changes by at most 0.02 N per tick, or the controller would make a smooth force
/// buzz. v is therefore the mean velocity over 10 ms or half a millimetre, so that it does not step with the encoders.
/// What is taken is kept while the reading stands still, for at most 20 ms, and it never exceeds the push itself. Until
/// it has grown, the hand gets energy: this is the debt that the damping pays back. The limit is higher where nobody
/// feels single ticks: it grows with the sixth power of the speed of a hand faster than 0.15 m/s, and by four times
/// what the force itself changes beyond 0.05 N per tick, but never makes the force change more than this limit beyond
/// its own change. A hand that strikes a wall (in the first 0.1 s of a touch, faster than 0.07 m/s, with a force that
/// changes as that of 0.8 times the device's stiffness) is damped at once, without means and limit.
/// @realtime no allocation, no lock
class PassivityController {
 public:
  /// @param max_force   [N] of the damping, if PassivityOptions::max_force is 0
  /// @param lever       [m] sqrt(rotational stiffness/stiffness) of the device; 0: torque is not watched
  /// @param max_torque  [N·m] of the damping
  /// @throws Error when an option is out of range
  PassivityController(const PassivityOptions& options, double max_force, double lever = 0, double max_torque = 0);

  /// The input of one tick.
  struct Tick {
    Wrench commanded;                  ///< by the model
    Wrench effects;                    ///< the part of `commanded` that is not contact
    Wrench applied;                    ///< written to the device at the last tick
    Vec3 motion = Vec3::Zero();        ///< [m] displacement of the device since the last tick
    Vec3 rotation = Vec3::Zero();      ///< [rad] rotation vector of the device since the last tick
    double dt = 0;                     ///< [s] since the last tick
    std::optional<double> stored;      ///< [J] energy stored in the model; empty: not known
    std::optional<double> motor = {};  ///< [J] work of the model's motor since the last tick; empty: not known
    bool in_air = false;               ///< the tool touches nothing
  };

  /// @return the commanded wrench, reduced and damped
  [[nodiscard]] Wrench control(const Tick& tick) noexcept;

  void restart() noexcept;

  [[nodiscard]] double stored() const { return stored_; }                ///< [J] W
  [[nodiscard]] double damping_force() const { return damping_force_; }  ///< [N] norm of the last tick's change

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  [[nodiscard]] Vector6 compared(const Wrench& wrench) const noexcept;
  [[nodiscard]] Vector6 contact_that_acted(const Tick& tick) noexcept;
  [[nodiscard]] double work_of(const Vector6& acted, const Vector6& motion, double dt) noexcept;
  void follow(const Vector6& motion, double motor, const Vector6& of_contact, double dt) noexcept;
  void change_towards(const Vector6& reduction, const Vector6& damping, const Vector6& of_contact) noexcept;

  PassivityOptions options_;
  double max_force_, lever_, max_torque_;
  double stored_ = 0, damping_force_ = 0;
  double commanded_ = 0;   // [N] at the last tick
  Vector6 effects_;        // [N] part of it that is not contact
  Vector6 mean_;           // [N] mean of what acted since the reading last changed, along each axis
  Vector6 still_;          // [ticks] time since then
  Vector6 velocity_;       // [m/s] mean of the hand's
  Vector6 path_;           // [m] motion, where the past counts less and less
  double motor_work_ = 0;  // [J] work of the model's motor, likewise
  double time_ = 0;        // [s] likewise
  double stands_ = 0;      // [s] time since the reading last changed
  Vector6 reduction_;      // [N] reduction of a push
  Vector6 damping_;        // [N]
  Vector6 slope_;          // [N/s] mean change of the commanded force
  Vector6 last_contact_;   // [N] commanded at the last tick
  double touched_ = 0;     // [s] since the force began
  double rough_ = 0;       // [1] how far beyond a smooth force it changes; infinite: the hand strikes a wall
  static constexpr auto kMaxDelay = std::size_t(range_of(&PassivityOptions::delay).high);
  std::array<Vector6, kMaxDelay> delayed_;
  int next_ = 0;
};

}  // namespace hapticut
