// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hapticut/core/description.hpp"
#include "hapticut/device/simulated/device_models.hpp"

namespace hapticut {

/// Which parts of the mechanics are simulated.
struct PlantOptions {
  double period = 1e-3;      ///< [s] time for which a force is held: one tick of the servo loop
  double fine_step = 20e-6;  ///< [s] duration of Plant::advance_fine
  /// Whether the device has Coulomb friction; integrated with steps of 10 us instead of exactly
  bool dry_friction = false;
  bool encoder = false;   ///< whether positions are read in steps of the encoder
  bool rotation = false;  ///< whether torque rotates the gimbal; otherwise the gimbal follows the set point
};

constexpr auto fields_of(Of<PlantOptions>) {
  using O = PlantOptions;
  return std::tuple{
      field("period", &O::period, "s", Range::positive(), "time for which a force is held: one tick of the servo loop"),
      field("fine_step", &O::fine_step, "s", Range::positive(), "duration of Plant::advance_fine"),
      field("dry_friction", &O::dry_friction,
            "whether the device has Coulomb friction; integrated with steps of 10 us instead of exactly"),
      field("encoder", &O::encoder, "whether positions are read in steps of the encoder"),
      field("rotation", &O::rotation, "whether torque rotates the gimbal; otherwise the gimbal follows the set point"),
  };
}

/// A device in a hand, moved by the force that it renders: the mechanics of `ClosedLoop` and of the mock device.
///
/// Per axis, with the tip x, the hand x_h and the set point x_0 of the hand:
///
///     m x'' = F - b x' - f_c sign(x') + pad,     m_h x_h'' = -pad - b_h x_h' + k_h (x_0 - x_h)
///
/// The hand is bonded to the tip (x_h = x, masses add) when the pad has no stiffness. Without dry friction a tick is
/// exact for a force that is held over it (matrix exponential). So the only error of a stability limit is that of the
/// search.
/// @realtime no allocation after construction
class Plant {
 public:
  /// @throws Error when a number is not finite or out of range
  Plant(const DeviceModel& device, const HandModel& hand, const PlantOptions& options);

  /// Puts the plant at rest at a pose, which also becomes the set point.
  void reset(const Pose& X_BS);

  /// Sets the set point of the hand.
  void set_target(const Pose& X_BS);
  [[nodiscard]] const Pose& target() const { return X_BS_target_; }

  /// Gives tip and hand a velocity.  @param velocity [m/s] in B
  void set_velocity(const Vec3& velocity);

  /// Advances by one period with a wrench held on the stylus.  @param wrench [N], [N·m] in B
  void advance(const Wrench& wrench);

  /// Advances by PlantOptions::fine_step, for events within a tick.  @param wrench [N], [N·m] in B
  void advance_fine(const Wrench& wrench);

  [[nodiscard]] Pose pose() const;              ///< exact
  [[nodiscard]] Pose measured_pose() const;     ///< with the steps of the encoder
  [[nodiscard]] Twist velocity() const;         ///< exact
  [[nodiscard]] double kinetic_energy() const;  ///< [J] energy of the translation of tip and hand

  [[nodiscard]] const DeviceModel& device() const { return device_; }
  [[nodiscard]] const HandModel& hand() const { return hand_; }
  [[nodiscard]] const PlantOptions& options() const { return options_; }

 private:
  using Axes = Eigen::Matrix<double, 4, 3, Eigen::DontAlign>;  // rows: tip, its velocity, hand, its velocity

  // Exact motion over a step with held force and set point: state' = state * s + force * f + target * t.
  struct Propagator {
    Eigen::Matrix<double, 4, 4, Eigen::DontAlign> state;
    Eigen::Matrix<double, 4, 1, Eigen::DontAlign> force, target;
  };

  [[nodiscard]] bool has_pad() const { return hand_.pad_stiffness > 0; }
  [[nodiscard]] Propagator propagator(double step) const;
  void move(double duration, const Propagator& propagator, const Wrench& wrench);
  void translate(const Propagator& propagator, const Vec3& force);
  void translate_with_friction(double duration, const Vec3& force);
  void rotate(double duration, const Vec3& torque);

  DeviceModel device_;
  HandModel hand_;
  PlantOptions options_;
  double tip_mass_, tip_damping_;
  Propagator tick_, fine_;
  Axes axes_ = Axes::Zero();
  Mat3 R_BS_ = Mat3::Identity();
  Vec3 angular_velocity_ = Vec3::Zero();
  Pose X_BS_target_;
};

}  // namespace hapticut
