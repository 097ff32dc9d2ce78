// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// How the passivity controller watches. Energies in [J], for the translation; the rotation has its own instance.
struct PassivityOptions {
  bool enabled = true;
  double credit = 5e-3;  ///< [J] that the model may have absorbed and give back later: more is forgotten
  double allowance = 0;  ///< [J] that the model may generate, for a device whose own friction takes it
  double greatest = 0;   ///< [N or N·m] of the damping; 0: the device's peak
  /// [N·s/m or N·m·s/rad] of the damping at most; 0: no bound. Without one, a force of any size answers the smallest
  /// motion. SafetyGuard fills in what the device can render.
  double greatest_damping = 0;
  double slowest = 1e-6;  ///< [m/s or rad/s] below which nothing is damped
  double free = 1e-3;     ///< [N or N·m] a shorter force counts as zero
  int delay = 0;          ///< [ticks] 0 ... 8 between a written force and the one that acts, beyond the hold
  int free_ticks = 20;    ///< without a force after which the account is closed
};

/// Watches how much energy a model puts into a hand, and takes out by damping what it should not have.
///
/// The account is exact for a force that is held between ticks (Stramigioli et al., Ryu et al.):
///
///     W(n) = W(n-1) - F(n-1) · (x(n) - x(n-1)),   F on the device as it was applied,
///
/// W > 0 is energy that went into the model. When W falls below minus the allowance, a damping force `-a v` is added
/// with `a = -W / (v^2 T)`, bounded by a damping and a force (time-domain passivity control, Hannaford and Ryu 2002).
/// It acts one tick late and is bounded by the device: a strong help, not a proof.
///
/// A spindle that drags the tool sideways does generate energy; the controller then holds the hand back gently, which
/// is what a guard is for.
/// @realtime no allocation, no lock
class PassivityController {
 public:
  /// @throws Error when an option is out of range
  PassivityController(const PassivityOptions& options, double greatest);

  /// @param force     [N] that the model asks for
  /// @param applied   [N] written to the device at the last tick
  /// @param motion    [m] of the device since the last tick
  /// @param dt        [s] since the last tick
  /// @return [N] the force with what damping it takes
  [[nodiscard]] Vec3 control(const Vec3& force, const Vec3& applied, const Vec3& motion, double dt) noexcept;

  void restart() noexcept;

  [[nodiscard]] double stored() const { return stored_; }  ///< [J] W
  [[nodiscard]] double taken() const { return taken_; }    ///< [N] length of the damping force of the last tick

 private:
  PassivityOptions options_;
  double greatest_;
  double stored_ = 0, taken_ = 0;
  int free_ = 0;
  static constexpr int kLongestDelay = 8;
  std::array<Vec3, kLongestDelay> under_way_;
  int next_ = 0;
};

}  // namespace hapticut
