// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/device/device.hpp"
#include "hapticut/realtime/triple_buffer.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::apps {

/// A device whose hand is the pointer of a page. Its base is the world and its stylus the head of the tool, so the tip
/// follows the pointer for any handle.
///
/// A critically damped follower (10 ms) turns about sixty poses per second into a smooth path of 1000 poses per second.
/// Its speed is limited to that of a working hand. The hand does not yield to forces: the coupling stretches, and the
/// distance between the drawn hand and tool shows the resistance.
class PointerHand final : public PolledDevice {
 public:
  /// @param around  [m] range of the tip, in W
  explicit PointerHand(const Box& around);

  static constexpr int kPress = 0;  ///< number of the button

  /// Sets the target pose of the head and whether the pointer is pressed. Call from one thread only.
  void move_to(const Pose& X_WT, bool pressed) { target_.write({X_WT, pressed}); }

  /// Moves the hand to a pose.
  /// @pre no run is in progress
  void put(const Pose& X_WT);

 protected:
  void begin_run(const RunOptions& options) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override { return wrench; }
  [[nodiscard]] bool is_simulated() const override { return true; }

 private:
  struct Target {
    Pose X_WT;
    bool pressed = false;
  };

  Box around_;
  TripleBuffer<Target> target_;
  Pose X_WT_;
  Twist velocity_;
  double period_ = 1e-3, begin_ = 0;
  bool simulated_ = false;
  std::uint64_t tick_ = 0;
};

}  // namespace hapticut::apps
