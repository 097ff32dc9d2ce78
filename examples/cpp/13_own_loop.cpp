// SPDX-License-Identifier: Apache-2.0
// A loop that is not RealtimeLoop, with all its parts, in simulated time on a mock: docs/your-own-loop.md.
#include <algorithm>
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

/// Your driver: it reads a pose and writes a wrench. Here it is a mock that a simulated hand holds.
struct Driver : MockDevice {
  Driver()
      : MockDevice({.path = scripted_path("line"),
                    .device = device_model("touch"),
                    .hand = hand_model("nominal"),
                    .rigid = false}) {}  // force and hand move it
  using MockDevice::begin_run, MockDevice::read, MockDevice::write;
};

/// Tells the guard whether the tool touches anything, and which energy lies behind the force. Scales of 1.
ModelContact contact_behind(const CoupledResult& felt, const StepResult& step, double motor_work_before) {
  ModelContact contact;
  contact.touching = has_any(felt.status, kRejected | StepStatus::tool_waits) || step.contact.voxels > 0;
  contact.stored = std::max(0.0, step.energy.elastic + step.energy.anchored + felt.energy.spring + felt.energy.kinetic);
  contact.motor = step.energy.motor_work - motor_work_before;
  return contact;
}

int main() {
  Driver driver;
  const Box box{Vec3(-12, -6, -4) * mm, Vec3(12, 6, 0) * mm};
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  config.reserved_blocks = 4096;  // cutting takes its memory from here
  Simulation simulation(build_block(box, 0.2 * mm, presets::trabecular_bone()),
                        Tool(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm)), config);
  simulation.history().reserve(4096);

  WorkspaceMapOptions placement;
  placement.X_WB.translation.z() = 3 * mm;
  WorkspaceMap map(placement);
  VirtualCoupling coupling(simulation, gains_in_world(coupling_gains(driver.capabilities()), placement));
  SpindleInterlock interlock;
  SafetyGuard guard(driver.capabilities(), GuardOptions{});  // GuardOptions::period is 1 ms

  PreparedTool next_tool(Tool(SphereHead{1 * mm}, RayHandle{0}, common_spindle(40000 * rpm)),
                         simulation.workpiece().voxel_size(), simulation.config());
  VirtualCoupling::Lists next_lists(next_tool.worst_case(), simulation.config());

  simulation.history().mark();
  driver.begin_run({});
  guard.start();
  DeviceState reading;
  Wrench wrench;         // on the stylus, in B
  ModelContact contact;  // that causes it
  int waited = 0;        // ticks without a new reading
  bool undoing = false;
  double removed = 0, max_force = 0, force_at_exchange = 0;  // [m^3], [N], [N]
  for (int tick = 0; tick < 6000 && driver.read(reading); ++tick) {
    if (tick == 3000 && simulation.exchange(next_tool)) coupling.exchange_lists(next_lists);
    if (tick == 5000) undoing = true;
    if (tick == 3000 || undoing) {
      coupling.park(VirtualCoupling::Rejoin::free);
      interlock.interrupt();
      guard.requests().interrupt(SafetyEvent::model_swapped);
    }
    const DeviceState& hand = guard.admit(reading);
    const bool holds = guard.repeats() && hand.valid && !undoing;
    const double dt = (1 + waited) * guard.period();  // [s] since the last reading
    waited = holds ? waited + 1 : 0;
    if (holds) {
      contact.motor = 0;
    } else {
      wrench = {};
      contact = {};
      contact.touching = true;  // until a step says otherwise
    }
    if (undoing) {
      undoing = !simulation.history().undo(64);  // 64 blocks in each tick
    } else if (!hand.valid) {
      coupling.park(VirtualCoupling::Rejoin::near);
      interlock.interrupt();
      simulation.spindle().hold(true);
    } else if (!holds) {
      interlock.update(simulation, guard.state());
      const double motor_work = simulation.last_result().energy.motor_work;
      const CoupledResult& felt = coupling.step(map.to_world(hand.X_BS), map.to_world(hand.X_BS, hand.velocity), dt);
      wrench = map.to_device(hand.X_BS, felt.hand);
      contact = contact_behind(felt, simulation.last_result(), motor_work);
      removed += felt.removed_volume;
    }
    const Wrench allowed = guard.limit(wrench, contact);
    guard.report_applied(driver.write(allowed));
    max_force = std::max(max_force, allowed.force.norm());
    if (tick == 3000) force_at_exchange = allowed.force.norm();
  }
  driver.write({});  // no force
  guard.stop();
  std::cout << "removed " << removed / mm3 << " mm^3, force up to " << max_force << " N, at the exchange "
            << force_at_exchange << " N, undone: " << simulation.workpiece().amounts()[0].volume / mm3
            << " mm^3 again, the tool "
            << (has_any(coupling.last_result().status, StepStatus::tool_waits) ? "waits" : "cuts") << '\n';
}
