// SPDX-License-Identifier: Apache-2.0
// Checkpoints: a run goes on from a saved workpiece. docs/other-scenes.md.
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

constexpr double kDt = 1 * ms, kFeed = 2 * mm;  // [s], [m/s]

/// Feeds the drill on, from step `first` on.
/// @return the last result
StepResult feed(Simulation& simulation, int first, int steps) {
  StepResult last;
  for (int n = first; n < first + steps; ++n) {
    const Pose X_WH = Pose::from_translation(Vec3(0, 0, 0.85 * mm - kFeed * n * kDt));
    last = simulation.step(X_WH, {Vec3(0, 0, -kFeed), Vec3::Zero()}, kDt);
  }
  return last;
}

int main() {
  std::cout.precision(3);
  const Box box{Vec3(-3, -3, -3) * mm, Vec3(3, 3, 0) * mm};
  Simulation simulation(build_block(box, 0.1 * mm, presets::dentin()),
                        Tool(SphereHead{0.8 * mm}, RayHandle{0}, common_spindle(40000 * rpm)));
  feed(simulation, 1, 300);
  const Workpiece checkpoint = simulation.workpiece().clone();
  const WorkpieceSnapshot snapshot = simulation.workpiece().snapshot();
  const double before = simulation.totals().removed_volume[1];
  const StepResult on = feed(simulation, 301, 200);
  std::cout << "without a break: " << on.force.z() << " N, removed "
            << (simulation.totals().removed_volume[1] - before) / mm3 << " mm^3 more\n";

  for (int attempt = 0; attempt < 2; ++attempt) {
    simulation.reset(checkpoint.clone());
    const StepResult again = feed(simulation, 301, 200);
    std::cout << "after reset:     " << again.force.z() << " N, removed " << simulation.totals().removed_volume[1] / mm3
              << " mm^3, " << describe(again.status) << '\n';
  }

  simulation.history().restore(snapshot);
  std::cout << "after restore:   " << describe(feed(simulation, 301, 200).status) << '\n';
  simulation.history().restore(snapshot);
  simulation.step(Pose::from_translation(Vec3(0, 0, 2 * mm)), {}, kDt);  // the hand leaves the material
  std::cout << "and above it:    " << describe(simulation.last_result().status) << '\n';
}
