// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>

#include "hapticut/device/simulated/plant.hpp"

/// @file
/// The closed loop of a device, the hand that holds it and the model that computes the force, in simulated time.
namespace hapticut {

/// The model under test: maps a reading of the device to the wrench that it must render until the next reading.
using ForceModel = std::function<Wrench(const DeviceState&)>;

/// A virtual wall that fills z < `height`: `F = -K p - B p'` along z with p the penetration, never pulling. This is the
/// reference model; its stability limits are known in closed form, for `one_sided = false`. A one-sided wall does not
/// hold the device: from the start of the default `StabilitySearch`, `max_stable_stiffness` returns 0 for some devices.
struct LinearWall {
  double stiffness = 0;   ///< [N/m] K
  double damping = 0;     ///< [N·s/m] B, on the backward difference of the position
  double filter = 0;      ///< [Hz] cut-off of the low-pass filter of that difference; 0: no filter
  bool one_sided = true;  ///< false: it also pulls, so it is linear
  double height = 0;      ///< [m]

  Wrench operator()(const DeviceState& state);

 private:
  double last_ = 0, last_time_ = 0, speed_ = 0;
  bool started_ = false;
};

/// Device, hand and timing of the loop.
struct ClosedLoopConfig {
  DeviceModel device;
  HandModel hand;
  int delay = 0;               ///< [ticks] 0 ... 8, from a force to the tick that applies it, in addition to the hold
  double period = 1e-3;        ///< [s]
  bool dry_friction = false;   ///< Coulomb friction of the device
  bool encoder = false;        ///< positions are rounded to steps of the encoder
  bool saturation = false;     ///< the device renders no more than its peak force
  bool rotation = false;       ///< the gimbal rotates under torque
  double velocity_filter = 0;  ///< [Hz] filter of the velocity in readings, as in drivers; 0: plain difference
};

/// The loop: reads, computes, holds the force for one period, and repeats. Deterministic, without a clock.
class ClosedLoop {
 public:
  /// @throws Error when a number is out of range
  explicit ClosedLoop(const ClosedLoopConfig& config);

  /// Places the device at rest at a pose, with no delayed force.
  void reset(const Pose& X_BS);

  /// The present reading of the device.
  [[nodiscard]] const DeviceState& read();

  /// Accepts the wrench for the last reading, and moves device and hand by one period.
  /// @throws Error when the wrench is not finite
  void write(const Wrench& wrench);

  /// `write` in fine steps, with a call of the observer after each, for events within a tick.
  /// @throws Error when the wrench is not finite
  void write(const Wrench& wrench, const std::function<void(const Plant&, const Wrench& applied)>& observer);

  /// A tick without output of the model: the device holds the last wrench, or the fraction of it that a watchdog
  /// allows.
  /// @param scale  [1] 0 ... 1
  /// @throws Error when the scale is out of range
  void miss_tick(double scale = 1);

  /// Reads the device, calls the model, and writes its wrench.
  /// @throws Error when the model is an empty function or its wrench is not finite
  void tick(const ForceModel& model);

  [[nodiscard]] Plant& plant() { return plant_; }
  [[nodiscard]] const Plant& plant() const { return plant_; }
  [[nodiscard]] const ClosedLoopConfig& config() const { return config_; }
  [[nodiscard]] const Wrench& applied() const { return applied_; }  ///< during the last period

  /// [J] Work of the rendered force on device and hand since the reset; exact, because the force is held:
  /// `E += F(n) (x(n+1) - x(n)) + tau(n) log(R(n+1) R(n)^T)`.
  [[nodiscard]] double generated_energy() const { return generated_energy_; }

  /// [J] Dissipation of the device's viscous friction alone, since the reset.
  [[nodiscard]] double device_dissipation() const { return device_dissipation_; }

 private:
  void apply(const Wrench& wrench);
  template <typename Motion>
  void advance(const Motion& motion);

  ClosedLoopConfig config_;
  Plant plant_;
  static constexpr int kMaxDelay = 8;
  std::array<Wrench, kMaxDelay> delayed_;
  int next_ = 0;
  Wrench applied_, written_;
  DeviceState state_;
  Twist smooth_velocity_;
  Pose X_BS_read_;
  bool started_ = false;
  double time_ = 0, generated_energy_ = 0, device_dissipation_ = 0;
};

}  // namespace hapticut
