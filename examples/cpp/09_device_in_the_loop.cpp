// SPDX-License-Identifier: Apache-2.0
// A device cuts bone behind a virtual coupling, in the real-time loop, while a screen looks on:
//   09_device_in_the_loop [DEVICE]     mock:spiral,hand=nominal; replay:FILE; openhaptics; ... (docs/devices.md)
#include <chrono>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <string>
#include <thread>

int main(int argc, char** argv) try {
  using namespace hapticut;
  using namespace hapticut::units;
  const std::string name = argc > 1 ? argv[1] : "mock:spiral,hand=nominal";
  const bool is_mock = name.starts_with("mock:");
  const auto device = open_device(name);

  const Box box{Vec3(-15, -15, -10) * mm, Vec3(15, 15, 0) * mm};
  SimulationConfig config;
  config.contact_time = ContactTime::end;  // what the coupling needs
  Simulation simulation(build_block(box, 0.25 * mm, presets::cortical_bone()),
                        Tool(SphereHead{1.5 * mm}, RayHandle{0}, Spindle{30000 * rpm}),  // the ball is at the stylus
                        config);

  SimulationModelOptions options;
  options.map.X_WB.translation.z() = 1.5 * mm;  // the ball stands on the bone where the stylus is at its origin
  if (!is_mock)
    options.map.X_WB.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // y of a device points up, z of the world does
  options.coupling = coupling_gains(device->capabilities());
  options.undo_blocks = 4096;
  SimulationModel model(simulation, *device, options);

  RealtimeLoopOptions loop_options;
  loop_options.run.seconds = 6;
  loop_options.run.simulated_time = is_mock;  // as fast as it goes
  loop_options.region = model.region();       // pictures of all of it
  RealtimeLoop loop(*device, model, loop_options);
  loop.send(commands::SetUndoMark{});
  loop.start();
  std::size_t blocks = 0;
  while (loop.is_running()) {
    [[maybe_unused]] const Pose& tool = loop.latest().X_WT;   // where to draw it
    for (ChangedBlock block; loop.receive(block);) ++blocks;  // what to draw anew
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  const RunReport report = loop.wait();
  std::cout << report.ticks << " ticks (" << report.end << "), guard " << hapticut::name_of(report.arming)
            << ", removed " << simulation.removed_volume_by_material()[1] / mm3 << " mm^3, at most "
            << loop.latest().max_applied << " N, " << blocks << " changed blocks\n";

  while (!simulation.undo(64)) {  // between runs; in a run: loop.send(commands::Undo{})
  }
  std::cout << "undone: " << simulation.workpiece().amounts()[0].volume / mm3 << " mm^3 of bone again\n";
} catch (const hapticut::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
