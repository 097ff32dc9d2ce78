// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hapticut/core/description.hpp"
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
  ScriptedPath path;
  DeviceModel device;
  HandModel hand;
  bool rigid = true;
  bool dry_friction = true;
  bool encoder = true;
  double velocity_filter = 100;
  double end = 0;
};

constexpr auto fields_of(Of<MockOptions>) {
  using O = MockOptions;
  return std::tuple{
      field("path", &O::path,
            "function from time [s] to the pose X_BS, in Python of shape (4, 4), that the hand wants to follow; null: "
            "rest"),
      field("device", &O::device, "see device_model; without a mass: touch"),
      field("hand", &O::hand, "see hand_model"),
      field("rigid", &O::rigid, "true: the stylus is on the path whatever the force; false: force and hand move it"),
      field("dry_friction", &O::dry_friction, "of the device, when not rigid"),
      field("encoder", &O::encoder, "positions in steps of the encoder, when not rigid"),
      field("velocity_filter", &O::velocity_filter, "Hz", Range::not_negative(),
            "of the reported velocity; 0: not filtered"),
      field("end", &O::end, "s", Range::not_negative(), "after which there are no more readings; 0: never"),
  };
}

/// A device that is not there: it follows a script, held by a simulated hand that its force can move. The motion knows
/// no wall clock: the n-th reading is that of n periods of the run, so every run gives the same readings for the same
/// forces.
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
  double period_ = 1e-3;
  Plant plant_;
  std::uint64_t tick_ = 0;
  Pose X_BS_last_;
  Twist velocity_;
};

/// "mock:PATH", or "mock:PATH,device=touch,hand=nominal,seconds=10"; without a hand the mock is rigid.
[[nodiscard]] std::unique_ptr<MockDevice> open_mock(const std::string& text);
[[nodiscard]] DeviceDriver mock_driver();

}  // namespace hapticut
