// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/device/device.hpp"
#include "hapticut/realtime/triple_buffer.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::cli {

/// A hand that is a pointer in a page. Its base is the world and its stylus the head of the tool, so that the tip
/// stays where the pointer is, whatever the handle.
///
/// Poses come some sixty times a second and become a smooth path of a thousand: a critically damped follower of
/// 10 ms, no faster than a hand that works. The hand itself does not yield; the coupling stretches, and what is shown
/// apart, hand and tool, is the resistance.
class PointerHand final : public PolledDevice {
 public:
  /// @param around  [m] where it may go, in W
  explicit PointerHand(const Box& around);

  static constexpr int kPress = 0;  ///< the button

  /// Where the head shall be, and whether the pointer presses. One thread.
  void move_to(const Pose& X_WT, bool pressed) { wanted_.write({X_WT, pressed}); }

  /// Puts the hand at a pose.  @pre no run is under way
  void put(const Pose& X_WT);

 protected:
  void begin_run(const RunOptions& options) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override { return wrench; }
  [[nodiscard]] bool is_simulated() const override { return true; }

 private:
  struct Wanted {
    Pose X_WT;
    bool pressed = false;
  };

  Box around_;
  TripleBuffer<Wanted> wanted_;
  Pose X_WT_;
  Twist velocity_;
  double period_ = 1e-3, begin_ = 0;
  bool simulated_ = false;
  std::uint64_t tick_ = 0;
};

}  // namespace hapticut::cli
