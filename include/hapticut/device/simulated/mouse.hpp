// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/plant.hpp"

namespace hapticut {

/// Keys that move a mouse device, in the base frame: +x right, +y up, +z towards the user.
enum class MoveKey : std::uint8_t { left, right, down, up, away, nearer, turn_left, turn_right, count };

constexpr auto names_of(Of<MoveKey>) {
  using enum MoveKey;
  return std::array{
      Named{left, "left"}, Named{right, "right"},   Named{down, "down"},           Named{up, "up"},
      Named{away, "away"}, Named{nearer, "nearer"}, Named{turn_left, "turn_left"}, Named{turn_right, "turn_right"},
  };
}

/// How pointer and keys move the simulated hand.
struct MouseOptions {
  double per_pixel = 0.05e-3;      ///< [m] way of the hand per pixel of the pointer
  double per_notch = 0.5e-3;       ///< [m] way along z per notch of the wheel; forwards moves away from the user
  double key_speed = 0.02;         ///< [m/s] speed of the hand while a key is held
  double key_angular_speed = 1.0;  ///< [rad/s] angular speed about z while a key is held
  double reach = 0.08;             ///< [m] half the edge of the cube that the hand stays in
  /// [m/s] largest speed of the set point, because a pointer jumps and a hand does not
  double max_speed = 0.3;
  std::string_view device = "touch";  ///< model of the simulated device, see device_model
  std::string_view hand = "firm";     ///< model of the simulated hand, see hand_model
};

constexpr auto fields_of(Of<MouseOptions>) {
  using O = MouseOptions;
  return std::tuple{
      field("per_pixel", &O::per_pixel, "m", Range::positive(), "way of the hand per pixel of the pointer"),
      field("per_notch", &O::per_notch, "m", Range::positive(),
            "way along z per notch of the wheel; forwards moves away from the user"),
      field("key_speed", &O::key_speed, "m/s", Range::not_negative(), "speed of the hand while a key is held"),
      field("key_angular_speed", &O::key_angular_speed, "rad/s", Range::not_negative(),
            "angular speed about z while a key is held"),
      field("reach", &O::reach, "m", Range::positive(), "half the edge of the cube that the hand stays in"),
      field("max_speed", &O::max_speed, "m/s", Range::positive(),
            "largest speed of the set point, because a pointer jumps and a hand does not"),
      field("device", &O::device, "model of the simulated device, see device_model"),
      field("hand", &O::hand, "model of the simulated hand, see hand_model"),
  };
}

/// A device for users without a haptic device. Pointer, wheel, buttons and keys of any window toolkit move the set
/// point of a simulated hand, and the force pushes that hand as it would push a real hand. The user feels no force, but
/// sees tool and set point separate where the material resists.
///
/// The events may come from any thread. Positions are relative to the pointer's position at the start of the run. There
/// are no torques: the keys rotate the stylus, for every device model.
class MouseDevice : public PolledDevice {
 public:
  /// @throws Error when an option is out of range
  explicit MouseDevice(const MouseOptions& options = {});
  ~MouseDevice() override;

  /// Reports that the pointer moved by (dx, dy) pixels, y downwards.
  void pointer_moved(double dx, double dy) noexcept;

  /// Reports that the wheel turned by a number of notches, forwards positive.
  void wheel_turned(double notches) noexcept;

  /// Reports that a button, 0 ... 31, was pressed or released.
  void button(int number, bool pressed) noexcept;

  /// Reports that a key was pressed or released.
  void key(MoveKey key, bool pressed) noexcept;

  /// [m] The set point of the hand, for a second cursor. Any thread.
  [[nodiscard]] Vec3 set_point() const noexcept;

 protected:
  void begin_run(const RunOptions& options) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override;
  [[nodiscard]] bool is_simulated() const override { return true; }

 private:
  struct Inputs;

  MouseOptions options_;
  Plant plant_;
  std::unique_ptr<Inputs> inputs_;
  std::uint64_t tick_ = 0;
  double period_ = 1e-3, begin_ = 0, angle_ = 0;
  bool simulated_ = false;
  Pose target_;
  Vec3 wanted_ = Vec3::Zero();
};

[[nodiscard]] DeviceDriver mouse_driver();

}  // namespace hapticut
