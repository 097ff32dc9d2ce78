// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/cutting.hpp"
#include "support/touch_gains.hpp"

/// @file
/// A simulation in the loop of a device, tick by tick in the hands of a test.
namespace hapticut::test::loop_rig {

inline constexpr double kRadius = 1.5e-3;  // [m] of the ball

/// A mock that is said to render the contacts of these tests, so that it may be driven directly.
inline std::unique_ptr<Device> stiff_mock(const std::string& path, double seconds = 0) {
  MockOptions options;
  options.path = scripted_path(path);
  options.device = device_model("touch");
  options.device.rendered_stiffness = 1e6;
  options.end = seconds;
  return std::make_unique<MockDevice>(std::move(options));
}

using test::touch_gains;  // of the device that `stiff_mock` says to be stiffer

inline Workpiece block(double voxel = 2e-4, double depth = 8e-3) {
  return build_block({Vec3(-8e-3, -8e-3, -depth), Vec3(8e-3, 8e-3, 0)}, voxel, plain_material());
}
inline Tool ball(double radius = kRadius, double speed = 3000) {
  return Tool(SphereHead{radius}, RayHandle{0}, Spindle{speed * units::rad_per_s});
}
inline double radius_of(const Tool& tool) { return std::get<SphereHead>(tool.head().shape()).radius; }

inline SimulationConfig config(bool coupled = false) {
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  config.reserved_blocks = 4096;
  config.contact_time = coupled ? ContactTime::end : ContactTime::middle;
  return config;
}

/// A run as fast as it goes, whose process is not its own.
inline RunOptions simulated_run() {
  RunOptions run;
  run.simulated_time = true;
  run.stop_on_signals = false;
  return run;
}

/// Ticks of a hand that a test moves along z, and tells the model between them.
class Rig {
 public:
  explicit Rig(double speed = 3000, bool coupled = false)
      : simulation(block(), ball(kRadius, speed), config(coupled)), model(simulation, *device, options(coupled)) {}

  /// @param height  [m] of the ball's lowest point over the face, tick by tick
  /// @param at      what happens before which tick, and what is to be seen after it
  void run(int ticks, const std::function<double(int)>& height, const std::function<void(int)>& before,
           const std::function<void(int)>& after) {
    RunOptions run = simulated_run();
    run.guard.arming.ramp = run.guard.arming.short_ramp = 0.02;
    report = device->run(
        [&](const DeviceState& reading) {
          DeviceState state = reading;
          state.X_BS.translation.z() = height(n);
          before(n);
          DeviceCommand command{model.step(state, 1e-3, snapshot), false, model.contact()};
          commanded = command.wrench.force;
          after(n);
          command.stop = ++n >= ticks;
          return command;
        },
        run);
  }
  bool tell(LoopCommand command) {
    model.check(command);
    return model.obey(command);
  }
  [[nodiscard]] std::uint64_t events(SafetyEvent event) const { return report.events[std::size_t(event)]; }

  std::unique_ptr<Device> device = stiff_mock("rest");
  Simulation simulation;
  SimulationModel model;
  LoopSnapshot snapshot;
  RunReport report;
  Vec3 commanded = Vec3::Zero();
  int n = 0;

 private:
  SimulationModelOptions options(bool coupled) const {
    SimulationModelOptions options;
    options.map.X_WB = Pose::from_translation(Vec3(0, 0, kRadius));
    options.undo_blocks = 2000;
    if (coupled) options.coupling = touch_gains();
    return options;
  }
};

/// In the air, down to a depth from tick 300 on in 0.1 s, where it stays; up again from tick `up` on.
inline std::function<double(int)> press(double depth, int up = 1 << 30) {
  return [=](int n) {
    if (n >= up) return 3e-3;
    return 1e-3 - (1e-3 + depth) * std::clamp(n - 300, 0, 100) / 100;
  };
}

}  // namespace hapticut::test::loop_rig
