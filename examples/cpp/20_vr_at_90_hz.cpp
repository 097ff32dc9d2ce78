// SPDX-License-Identifier: Apache-2.0
// A controller without motors, at the 90 Hz of a headset. docs/other-scenes.md.
#include <algorithm>
#include <cmath>
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

constexpr double kFrame = 1.0 / 90;  // [s]

/// The pose of the controller in a frame: it strokes at up to 125 mm/s over the bone, and comes 1 mm too deep.
Pose controller(int frame) {
  const double t = frame * kFrame;
  return Pose::from_translation(Vec3(20 * mm * std::sin(2 * kPi * t), 0, std::max(0.5 * mm, 4 * mm - 2.5 * mm * t)));
}

/// Moves the tool through one frame in equal steps of about a millisecond.
void follow(VirtualCoupling& coupling, const Pose& from, const Pose& to) {
  constexpr int kSteps = 11;
  const Twist twist = twist_between(from, to, kFrame);
  for (int n = 1; n <= kSteps; ++n) coupling.step(advance(from, twist, n * kFrame / kSteps), twist, kFrame / kSteps);
}

Simulation bone(ContactTime contact_time) {
  SimulationConfig config;
  config.contact_time = contact_time;
  const Box box{Vec3(-25, -4, -4) * mm, Vec3(25, 4, 0) * mm};
  return {build_block(box, 0.2 * mm, presets::cortical_bone()),
          Tool(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm)), config};
}

int main() {
  std::cout.precision(3);
  Simulation simulation = bone(ContactTime::end);
  VirtualCoupling coupling(simulation, CouplingGains{});
  double gap = 0, push = 0;
  for (int frame = 1; frame <= 180; ++frame) {
    follow(coupling, controller(frame - 1), controller(frame));
    const CoupledResult& tool = coupling.last_result();
    gap = std::max(gap, (tool.X_WH.translation - controller(frame).translation).norm());  // draw the tool at tool.X_WH
    push = std::max(push, tool.hand.force.norm());                                        // pulse of the controller
  }
  std::cout << "behind a coupling: removed " << simulation.totals().removed_volume[1] / mm3 << " mm^3, the tool up to "
            << gap / mm << " mm from the controller, push up to " << push << " N\n";

  // One step for each frame, without a coupling: the bone cannot stop a hand that feels nothing.
  Simulation direct = bone(ContactTime::middle);
  int sub_steps = 0;
  StepStatus status = StepStatus::ok;
  double force = 0;
  for (int frame = 1; frame <= 180; ++frame) {
    const Twist twist = twist_between(controller(frame - 1), controller(frame), kFrame);
    const StepResult& result = direct.step(controller(frame), twist, kFrame);
    sub_steps = std::max(sub_steps, result.sub_steps);
    status |= result.status;
    force = std::max(force, result.force.norm());
  }
  std::cout << "one step a frame:  removed " << direct.totals().removed_volume[1] / mm3 << " mm^3, up to " << sub_steps
            << " sub-steps, force up to " << force << " N, " << describe(status) << '\n';

  // A controller that is lost for a moment jumps.
  const Pose far = Pose::from_translation(Vec3(0, 0, 60 * mm));
  std::cout << "a jump of 60 mm:   " << describe(direct.step(far, {}, kFrame).status) << ", then "
            << describe(direct.step(far, {}, kFrame).status) << '\n';
}
