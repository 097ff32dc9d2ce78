// SPDX-License-Identifier: Apache-2.0
// Step 1 of docs/tutorial.md: a ball cuts a groove in bone, and the material pushes back.
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

int main() {
  std::cout.precision(3);
  const Box box{Vec3(-12, -6, -4) * mm, Vec3(12, 6, 0) * mm};  // the top of the bone is at z = 0
  const Tool ball(SphereHead{1.5 * mm}, RayHandle{0}, common_spindle(40000 * rpm));
  Simulation simulation(build_block(box, 0.2 * mm, presets::trabecular_bone()), ball);

  const Vec3 start(-16 * mm, 0, 1 * mm);  // beside the block; the ball's lowest point is at z = -0.5 mm
  const Twist feed{Vec3(8 * mm_per_s, 0, 0), Vec3::Zero()};
  double removed = 0;                         // [m^3]
  for (int tick = 1; tick <= 3000; ++tick) {  // 3 s at 1 kHz
    const Pose hand = Pose::from_translation(start + tick * ms * feed.linear);
    const StepResult& result = simulation.step(hand, feed, 1 * ms);
    removed += result.removed_volume;
    if (tick % 1000 == 0)
      std::cout << tick << " ms: force " << result.force.transpose() << " N, " << removed / mm3 << " mm^3 removed\n";
  }
}
