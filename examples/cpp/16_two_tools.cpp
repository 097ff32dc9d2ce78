// SPDX-License-Identifier: Apache-2.0
// Two tools at one workpiece: one cuts, the other one follows its cuts. docs/other-scenes.md.
#include <cmath>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <span>

using namespace hapticut;
using namespace hapticut::units;

/// Removes the voxels that another simulation has emptied.
void follow(Simulation& follower, std::span<const RemovedVoxel> removed) {
  const auto block_of = [](const RemovedVoxel& voxel) {
    return VoxelIndex{block_start(voxel.index[0]), block_start(voxel.index[1]), block_start(voxel.index[2])};
  };
  for (std::size_t n = 0; n < removed.size();) {
    BlockVoxels emptied;
    emptied.origin = block_of(removed[n]);
    for (; n < removed.size() && block_of(removed[n]) == emptied.origin; ++n) {
      const auto [i, j, k] = removed[n].index;
      emptied.voxels.add(block_offset(i - emptied.origin[0], j - emptied.origin[1], k - emptied.origin[2]));
    }
    if (!follower.remove_voxels(emptied)) std::cout << "reserve more blocks\n";
  }
}

/// [m] Depth of the hole under the origin.
double depth_of(const Simulation& simulation) {
  const std::optional<RayHit> floor = simulation.workpiece().first_hit(Vec3(0, 0, 5 * mm), Vec3(0, 0, -1));
  return floor ? -floor->point_W.z() : 0;
}

int main() {
  std::cout.precision(3);
  const Box box{Vec3(-4, -4, -3) * mm, Vec3(4, 4, 0) * mm};
  const Workpiece bone = build_block(box, 0.1 * mm, presets::trabecular_bone());
  Simulation drilling(bone.clone(), Tool(SphereHead{1 * mm}, RayHandle{0}, common_spindle(40000 * rpm)));
  SimulationConfig cuts_nothing;
  cuts_nothing.removal = RemovalLaw::none;
  Simulation probing(bone.clone(), Tool(SphereHead{0.4 * mm}), cuts_nothing);

  const double dt = 1 * ms;
  const auto drill_to = [&](double depth, int steps) {
    for (int n = 1; n <= steps; ++n) {
      const double z = 1 * mm - depth * n / steps;
      const StepResult& cut =
          drilling.step(Pose::from_translation(Vec3(0, 0, z)), {Vec3(0, 0, -depth / (steps * dt)), Vec3::Zero()}, dt);
      follow(probing, cut.removed_voxels);
    }
  };
  drill_to(1 * mm, 500);
  std::cout << "hole: " << depth_of(drilling) / mm << " mm deep, for the probe " << depth_of(probing) / mm << " mm\n";

  double z = 1 * mm;  // the probe goes down until it feels 0.2 N
  while (z > -2 * mm && probing.step(Pose::from_translation(Vec3(0, 0, z)), {}, dt).force.z() < 0.2) z -= 0.005 * mm;
  std::cout << "the probe feels the floor at " << (0.4 * mm - z) / mm << " mm\n";

  // Another drill for the same hand. It is exchanged in the hole, so it waits until the hand has left the material.
  PreparedTool larger(Tool(SphereHead{1.3 * mm}, RayHandle{0}, common_spindle(40000 * rpm)),
                      drilling.workpiece().voxel_size(), drilling.config());
  const bool exchanged = drilling.exchange(larger);
  const StepStatus inside = drilling.step(Pose::from_translation(Vec3::Zero()), {}, dt).status;
  const StepStatus above = drilling.step(Pose::from_translation(Vec3(0, 0, 3 * mm)), {}, dt).status;
  std::cout << "exchanged: " << std::boolalpha << exchanged << ", in the hole: " << describe(inside)
            << ", above it: " << describe(above) << '\n';
}
