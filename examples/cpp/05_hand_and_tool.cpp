// SPDX-License-Identifier: Apache-2.0
// Step 2 of docs/tutorial.md: a virtual coupling lies between the hand and the tool.
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

int main() {
  std::cout.precision(3);
  const Box box{Vec3(-12, -6, -4) * mm, Vec3(12, 6, 0) * mm};  // the top of the bone is at z = 0
  const Tool ball(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm));
  SimulationConfig config;
  config.contact_time = ContactTime::end;  // a coupling needs the contact at the end of the step
  Simulation simulation(build_block(box, 0.2 * mm, presets::trabecular_bone()), ball, config);
  VirtualCoupling coupling(simulation, CouplingGains{});  // 700 N/m, 12 N s/m, a tool of 50 g

  const Vec3 start(-16 * mm, 0, 1 * mm);  // beside the block; the ball's lowest point is at z = -0.5 mm
  const Twist feed{Vec3(8 * mm_per_s, 0, 0), Vec3::Zero()};
  double removed = 0;                         // [m^3]
  for (int tick = 1; tick <= 3000; ++tick) {  // 3 s at 1 kHz
    const Pose hand = Pose::from_translation(start + tick * ms * feed.linear);
    const CoupledResult& result = coupling.step(hand, feed, 1 * ms);
    removed += result.removed_volume;
    const Vec3 stretch = hand.translation - result.X_WH.translation;
    if (tick % 1000 == 0)
      std::cout << tick << " ms: force " << result.hand.force.transpose() << " N, tool " << stretch.norm() / mm
                << " mm away from the hand, " << removed / mm3 << " mm^3 removed\n";
  }
}
