// SPDX-License-Identifier: Apache-2.0
// Step 4 of docs/tutorial.md: the tool is changed while the loop runs.
//   12_change_the_tool [DEVICE]     mock:line,hand=nominal; other devices need their driver (docs/devices.md)
#include <chrono>
#include <cstdint>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <string>
#include <thread>

using namespace hapticut;
using namespace hapticut::units;

int main(int argc, char** argv) try {
  const std::string name = argc > 1 ? argv[1] : "mock:line,hand=nominal";
  const bool is_mock = name.starts_with("mock:");
  const auto device = open_device(name);

  const Box box{Vec3(-12, -6, -4) * mm, Vec3(12, 6, 0) * mm};  // the top of the bone is at z = 0
  const Tool ball(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm));
  SimulationConfig config;
  config.contact_time = ContactTime::end;  // a coupling needs the contact at the end of the step
  Simulation simulation(build_block(box, 0.2 * mm, presets::trabecular_bone()), ball, config);

  SimulationModelOptions options;
  options.coupling = coupling_gains(device->capabilities());
  options.map.X_WB.translation.z() = 3 * mm;  // the mock presses to 2 mm below the top of the bone
  if (!is_mock)
    options.map.X_WB.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // a device's y axis points up, the world's z axis does
  SimulationModel model(simulation, *device, options);

  RealtimeLoopOptions loop_options;
  loop_options.run.simulated_time = is_mock;  // a mock needs no real time: the loop runs as fast as it can
  RealtimeLoop loop(*device, model, loop_options);
  const auto wait_until = [&loop](std::uint64_t tick) {
    while (loop.is_running() && loop.latest().tick < tick) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  loop.start();
  wait_until(3000);
  const double before = loop.latest().tool.removed_volume;  // [m^3] by the large ball
  const Tool small_ball(SphereHead{1 * mm}, RayHandle{0}, common_spindle(40000 * rpm));
  loop.send(model.prepare_tool(small_ball));  // memory is allocated here; the loop swaps pointers between two ticks
  wait_until(loop.latest().tick + 3000);
  const RunReport report = loop.stop();
  const LoopSnapshot& end = loop.latest();
  std::cout.precision(3);
  std::cout << report.ticks << " ticks (" << report.end << "), guard " << name_of(report.arming) << ", tools changed "
            << report.events[std::size_t(SafetyEvent::model_swapped)] << ", removed " << before / mm3
            << " mm^3 with the large ball, " << (end.tool.removed_volume - before) / mm3
            << " mm^3 with the small one\n";
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
