// SPDX-License-Identifier: Apache-2.0
// One tool between two workpieces that move against each other. docs/other-scenes.md.
#include <algorithm>
#include <hapticut/hapticut.hpp>
#include <iostream>

using namespace hapticut;
using namespace hapticut::units;

const Box kFloor{Vec3(-4, -4, -3) * mm, Vec3(4, 4, 0) * mm};
const Box kWall{Vec3(1, -4, 0) * mm, Vec3(4, 4, 4) * mm};

Tool drill() { return Tool(SphereHead{0.8 * mm}, RayHandle{0}, common_spindle(40000 * rpm)); }

/// Both boxes as one workpiece, for a comparison: what does not move may be one workpiece.
Workpiece both_in_one(double voxel) {
  const auto distance_to = [](const Box& box, const Vec3& p) {
    const Vec3 outside = (box.min - p).cwiseMax(p - box.max);
    return outside.maxCoeff() < 0 ? outside.maxCoeff() : outside.cwiseMax(0.0).norm();
  };
  BodyDescription body;
  body.box = {kFloor.min, kWall.max};
  body.distance = [=](const Vec3& p) { return std::min(distance_to(kFloor, p), distance_to(kWall, p)); };
  body.material = [](const Vec3&) { return MaterialId(1); };
  return build_body(body, voxel, MaterialTable({presets::dentin()}));
}

int main() {
  std::cout.precision(3);
  const double voxel = 0.1 * mm, dt = 1 * ms;
  Simulation floor(build_block(kFloor, voxel, presets::dentin()), drill());
  Simulation wall(build_block(kWall, voxel, presets::dentin()), drill());
  Simulation together(both_in_one(voxel), drill());

  Vec3 sum, same;                   // [N] on the hand, in the last step
  for (int n = 1; n <= 400; ++n) {  // into the corner
    const Pose X_WH = Pose::from_translation(Vec3(0.1, 0, 0.9) * mm + Vec3(1, 0, -1) * (0.8 * mm * n * dt));
    const Twist V_WH{Vec3(1, 0, -1) * 0.8 * mm, Vec3::Zero()};
    // Both workpieces stand still here. One that moves gets the hand's pose in its own frame: 15_moving_workpiece.cpp.
    sum = floor.step(X_WH, V_WH, dt).force + wall.step(X_WH, V_WH, dt).force;
    same = together.step(X_WH, V_WH, dt).force;
  }
  const auto removed = [](const Simulation& s) { return s.totals().removed_volume[1] / mm3; };
  std::cout << "force: " << sum.transpose() << " N, of one workpiece with both: " << same.transpose() << " N\n"
            << "removed: " << removed(floor) << " + " << removed(wall)
            << " mm^3, of one workpiece: " << removed(together) << " mm^3\n";

  // Behind couplings: each has its own simulated tool, and each renders half of what the device can.
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  const Tool standing(SphereHead{0.8 * mm});
  Simulation behind_floor(build_block(kFloor, voxel, presets::dentin()), standing, config);
  Simulation behind_wall(build_block(kWall, voxel, presets::dentin()), standing, config);
  CouplingGains half;
  half.stiffness /= 2;
  half.damping /= 2;
  half.mass /= 2;
  VirtualCoupling to_floor(behind_floor, half), to_wall(behind_wall, half);
  Wrench on_hand;
  for (int n = 0; n <= 1500; ++n) {  // 1 mm down into the floor, without a touch of the wall
    const double z = 0.9 * mm - 1.1 * mm * std::min(n, 1000) / 1000;
    const Pose X_WD = Pose::from_translation(Vec3(-1 * mm, 0, z));
    const Twist V_WD{Vec3(0, 0, n <= 1000 ? -1.1 * mm : 0), Vec3::Zero()};
    on_hand.force = to_floor.step(X_WD, V_WD, dt).hand.force + to_wall.step(X_WD, V_WD, dt).hand.force;
  }
  std::cout << "1 mm into one of them: " << on_hand.force.z() << " N; the tools are "
            << (to_floor.last_result().X_WH.translation - to_wall.last_result().X_WH.translation).norm() / mm
            << " mm apart\n";
}
