// SPDX-License-Identifier: Apache-2.0
// The smallest program for a haptic device: its pose goes into the step, and the force of the step to its motors. The
// configuration suits the device, so no coupling is needed; with one, a bur feels stiffer and cuts more
// (docs/tutorial.md). Usage: 22_step_on_a_device [name of a device]
#include <algorithm>
#include <hapticut/hapticut.hpp>
#include <iostream>

int main(int argc, char** argv) {
  using namespace hapticut;
  using namespace hapticut::units;
  const auto device = open_device(argc > 1 ? argv[1] : "mock:press,hand=nominal,seconds=3");
  Simulation simulation(
      build_block({Vec3(-30, -30, -30) * mm, Vec3(30, 30, 0) * mm}, 0.2 * mm, presets::cortical_bone()),
      Tool(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm)),
      SimulationConfig::for_device(device->capabilities()));
  double max_force = 0;  // [N]
  device->run([&](const DeviceState& hand) {
    const StepResult& result = simulation.step(hand.X_BS, hand.velocity, 1 * ms);
    max_force = std::max(max_force, result.force.norm());
    DeviceCommand command;
    command.wrench = {result.force, result.torque};
    command.contact.touching = result.contact.voxels > 0;  // lets the guard begin in the air
    return command;
  });
  std::cout << "up to " << max_force << " N, " << simulation.totals().removed_volume[1] / mm3 << " mm^3 removed\n";
}
