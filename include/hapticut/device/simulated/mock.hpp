// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/plant.hpp"

namespace hapticut {

/// A path for the set point of a mock device's hand: maps the time since the start [s] to X_BS.
using ScriptedPath = std::function<Pose(double time)>;

/// A path by its name.
///
/// `rest`   stays at the origin
/// `press`  moves down (-z) from 5 mm to -5 mm in 2 s, and stays there
/// `line`   like `press`, then moves to and fro along x over 20 mm
/// `circle` like `press`, then moves along a circle of 8 mm radius in the xy plane
/// `spiral` like `press`, then a spiral whose radius grows to 8 mm and shrinks again, 1 mm deeper every 10 s
/// @throws Error that lists the known names
[[nodiscard]] ScriptedPath scripted_path(const std::string& name);

/// Options of a mock device.
struct MockOptions {
  /// Function from time [s] to the set point X_BS of the hand, of shape (4, 4) in Python; null: rest
  ScriptedPath path;
  DeviceModel device;            ///< see device_model; a mass of 0 means touch
  HandModel hand;                ///< see hand_model
  bool rigid = true;             ///< true: the stylus follows the path exactly; false: force and hand move it
  bool dry_friction = true;      ///< whether the device has it, when not rigid
  bool encoder = true;           ///< whether positions have the steps of the encoder, when not rigid
  double velocity_filter = 100;  ///< [Hz] cut-off of the filter of the reported velocity; 0: no filter
  double end = 0;                ///< [s] time after which there are no more readings; 0: never
};

constexpr auto fields_of(Of<MockOptions>) {
  using O = MockOptions;
  return std::tuple{
      field("path", &O::path,
            "function from time [s] to the set point X_BS of the hand, of shape (4, 4) in Python; null: rest"),
      field("device", &O::device, "see device_model; a mass of 0 means touch"),
      field("hand", &O::hand, "see hand_model"),
      field("rigid", &O::rigid, "true: the stylus follows the path exactly; false: force and hand move it"),
      field("dry_friction", &O::dry_friction, "whether the device has it, when not rigid"),
      field("encoder", &O::encoder, "whether positions have the steps of the encoder, when not rigid"),
      field("velocity_filter", &O::velocity_filter, "Hz", Range::not_negative(),
            "cut-off of the filter of the reported velocity; 0: no filter"),
      field("end", &O::end, "s", Range::not_negative(), "time after which there are no more readings; 0: never"),
  };
}

/// A simulated device that follows a script. A simulated hand holds it, and the force can move that hand. The motion
/// does not depend on the wall clock: the n-th reading is that after n periods of the run, so equal forces give equal
/// readings in every run.
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

/// Opens a mock device by the text behind "mock:": "PATH" or "PATH,device=touch,hand=nominal,seconds=10". Without a
/// hand the mock is rigid.
[[nodiscard]] std::unique_ptr<MockDevice> open_mock(const std::string& text);
[[nodiscard]] DeviceDriver mock_driver();

}  // namespace hapticut
