// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "experiments/setup/cutting.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/touch_gains.hpp"

/// @file
/// A simulation in the loop of a device, driven tick by tick by a test.
namespace hapticut::test::scripted_loop {

inline constexpr double kRadius = 1.5e-3;  // [m] radius of the ball

/// A mock that states a stiffness for the contacts of these tests, so that it may be driven directly.
inline std::unique_ptr<Device> stiff_mock(const std::string& path, double seconds = 0) {
  MockOptions options;
  options.path = scripted_path(path);
  options.device = device_model("touch");
  options.device.rendered_stiffness = 1e6;
  options.end = seconds;
  return std::make_unique<MockDevice>(std::move(options));
}

using test::touch_gains;  // gains of the real device; `stiff_mock` states a higher stiffness

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

/// Options of a run at full speed that changes nothing in the process.
inline RunOptions simulated_run() {
  RunOptions run;
  run.simulated_time = true;
  run.stop_on_signals = false;
  return run;
}

/// A loop whose hand a test moves along z, with commands between the ticks.
class ScriptedLoop {
 public:
  explicit ScriptedLoop(double speed = 3000, bool coupled = false)
      : simulation(block(), ball(kRadius, speed), config(coupled)), model(simulation, *device, options(coupled)) {}

  /// @param height         [m] height of the lowest point of the ball over the face, for each tick
  /// @param before, after  actions and expectations before and after each tick
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
    return model.apply(command);
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

/// Height of a hand that is in the air, goes down to a depth from tick 300 on within 0.1 s, stays there, and goes up
/// from tick `up` on.
inline std::function<double(int)> press(double depth, int up = 1 << 30) {
  return [=](int n) {
    if (n >= up) return 3e-3;
    return 1e-3 - (1e-3 + depth) * std::clamp(n - 300, 0, 100) / 100;
  };
}

}  // namespace hapticut::test::scripted_loop
