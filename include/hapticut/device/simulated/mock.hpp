// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/plant.hpp"

namespace hapticut {

/// A path that a mock device's hand wants to follow: from the time since the start [s] to X_BS.
using ScriptedPath = std::function<Pose(double time)>;

/// The paths that have a name.
///
/// `rest`   stays at the origin
/// `press`  goes down (-z) from 5 mm to -5 mm in 2 s, and stays
/// `line`   the same, then to and fro along x over 20 mm
/// `circle` the same, then round a circle of 8 mm radius in the xy plane
/// `spiral` the same, then a spiral that grows from 0 to 8 mm radius and shrinks again, 1 mm deeper every 10 s
/// @throws Error that lists the names there are
[[nodiscard]] ScriptedPath scripted_path(const std::string& name);

/// What a mock device is made of.
struct MockOptions {
  ScriptedPath path;             ///< null: rest
  DeviceModel device;            ///< see device_model
  HandModel hand;                ///< see hand_model
  bool rigid = true;             ///< true: the stylus is on the path whatever the force; false: force and hand move it
  bool dry_friction = true;      ///< of the device, when not rigid
  bool encoder = true;           ///< positions in steps of the encoder, when not rigid
  double velocity_filter = 100;  ///< [Hz] of the reported velocity
  double period = 1e-3;          ///< [s] of simulated time per tick
  double end = 0;                ///< [s] after which there are no more readings; 0: never
};

/// A device that is not there: it follows a script, held by a simulated hand that its force can move. The motion knows
/// no wall clock: the n-th reading is that of n periods, so every run gives the same readings for the same forces.
class MockDevice : public PolledDevice {
 public:
  /// @throws Error when an option is out of range
  explicit MockDevice(MockOptions options, std::string name = "mock");
  ~MockDevice() override;

  [[nodiscard]] const Plant& plant() const { return plant_; }

 protected:
  void begin_run(const RunOptions& options) override;
  bool read(DeviceState& state) noexcept override;
  Wrench write(const Wrench& wrench) noexcept override;
  [[nodiscard]] bool is_simulated() const override { return true; }

 private:
  MockOptions options_;
  Plant plant_;
  std::uint64_t tick_ = 0;
  Pose X_BS_last_;
  Twist velocity_;
};

/// "mock:PATH", or "mock:PATH,device=touch,hand=nominal,seconds=10"; without a hand the mock is rigid.
[[nodiscard]] std::unique_ptr<MockDevice> open_mock(const std::string& text);
[[nodiscard]] DeviceDriver mock_driver();

}  // namespace hapticut
