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

/// How pointer and keys move the hand.
struct MouseOptions {
  double per_pixel = 0.05e-3;
  double per_notch = 0.5e-3;
  double key_speed = 0.02;
  double key_turn = 1.0;
  double reach = 0.08;
  double fastest = 0.3;
  std::string_view device = "touch";
  std::string_view hand = "firm";
};

constexpr auto fields_of(Of<MouseOptions>) {
  using O = MouseOptions;
  return std::tuple{
      field("per_pixel", &O::per_pixel, "m", Range::positive(), "of the hand per pixel of the pointer"),
      field("per_notch", &O::per_notch, "m", Range::positive(),
            "along z per notch of the wheel; forwards goes away from the user"),
      field("key_speed", &O::key_speed, "m/s", Range::not_negative(), "while a key is held"),
      field("key_turn", &O::key_turn, "rad/s", Range::not_negative(), "about z while a key is held"),
      field("reach", &O::reach, "m", Range::positive(), "half the edge of the cube that the hand stays in"),
      field("fastest", &O::fastest, "m/s", Range::positive(), "of the set point: a pointer jumps, a hand does not"),
      field("device", &O::device, "mechanics of the simulated device, see device_model"),
      field("hand", &O::hand, "and of the hand, see hand_model"),
  };
}

/// A device for people without one: pointer, wheel, buttons and keys of any window toolkit move the set point of a
/// simulated hand, and the force pushes that hand as it would push a real one. It is not felt, but tool and set point
/// part where the material resists.
///
/// The events may come from any thread. Positions are relative to the point where the run began: what moved before it
/// does not count. There are no torques: the stylus turns with the keys, whatever device it stands for.
class MouseDevice : public PolledDevice {
 public:
  /// @throws Error when an option is out of range
  explicit MouseDevice(const MouseOptions& options = {});
  ~MouseDevice() override;

  /// The pointer moved by so many pixels, y downwards as windows count.
  void pointer_moved(double dx, double dy) noexcept;

  /// The wheel turned by so many notches, forwards positive.
  void wheel_turned(double notches) noexcept;

  /// A button, 0 ... 31, was pressed or let go.
  void button(int number, bool pressed) noexcept;

  /// A key was pressed or let go.
  void key(MoveKey key, bool pressed) noexcept;

  /// Where the hand wants to be: for a second cursor. Any thread.
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
  double period_ = 1e-3, begin_ = 0, turn_ = 0;
  bool simulated_ = false;
  Pose target_;
  Vec3 wanted_ = Vec3::Zero();
};

[[nodiscard]] DeviceDriver mouse_driver();

}  // namespace hapticut
