// SPDX-License-Identifier: Apache-2.0
// Step 3 of docs/tutorial.md: a device moves the tool at 1 kHz, behind its guard.
//   09_device_in_the_loop [DEVICE]     mock:line,hand=nominal; other devices need their driver (docs/devices.md)
#include <chrono>
#include <cstddef>
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
  loop_options.run.seconds = 6;
  loop_options.run.simulated_time = is_mock;  // a mock needs no real time: the loop runs as fast as it can
  loop_options.region = model.region();       // send the changed blocks of the whole workpiece
  RealtimeLoop loop(*device, model, loop_options);
  loop.start();
  std::size_t blocks = 0;
  while (loop.is_running()) {
    [[maybe_unused]] const Pose& X_WT = loop.latest().X_WT;   // draw the tool here
    for (ChangedBlock block; loop.receive(block);) ++blocks;  // redraw these blocks
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const RunReport report = loop.wait();
  const LoopSnapshot& end = loop.latest();
  std::cout.precision(3);
  std::cout << report.ticks << " ticks (" << report.end << "), guard " << name_of(report.arming) << ", removed "
            << end.tool.removed_volume / mm3 << " mm^3, force up to " << end.max_applied << " N, " << blocks
            << " changed blocks\n";
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
