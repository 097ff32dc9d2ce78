// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <hapticut/hapticut.hpp>
#include <iostream>

int main() {
  using namespace hapticut;
  using namespace hapticut::units;
  const Box box{Vec3(-3, -3, -4) * mm, Vec3(3, 3, 0) * mm};
  Simulation simulation(build_block(box, 0.1 * mm, presets::cortical_bone()),
                        Tool(SphereHead{1.5 * mm}, RayHandle{20 * mm}, common_spindle(40000 * rpm)));
  const Twist feed{Vec3(0, 0, -2 * mm), Vec3::Zero()};  // 2 mm/s downwards
  std::size_t removed = 0;                              // voxels
  for (int tick = 1; tick <= 1000; ++tick) {            // one second at 1 kHz
    const Vec3 hand(0, 0, (1.5 + 20) * mm - 0.002 * mm * tick);
    const StepResult& result = simulation.step(Pose::from_translation(hand), feed, 1 * ms);
    removed += result.removed_voxels.size();
    if (tick % 250 == 0)
      std::cout << tick << " ms: " << result.force.z() << " N, spindle torque " << result.spindle.torque / N_mm
                << " N mm, " << removed << " voxels removed\n";
  }
}
