// SPDX-License-Identifier: Apache-2.0
// C24-C29: steady cuts along a surface, and plunges. The closed forms are for a thin engaged layer; the tolerances
// include the error of the layers of these cases (docs/validation.md).
#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/steady_cuts.hpp"

namespace hapticut::experiments {
namespace lateral_cuts {

/// A cut of plain_material.
constexpr forms::SteadyCut cut_of(double feed_speed, double spin) { return {3e8, 0.5, spin, feed_speed}; }

constexpr double kLayer = kR / 40;  // engaged layer of C24; voxels are half as thick

// Tolerances with voxels of a tenth of the radius and the default layer:
constexpr Tolerance kWall = {0.03, "default layer"};
constexpr Tolerance kBall = {0.03, "default layer"};                    // the surface has all angles
constexpr Tolerance kBottom = {0.06, "layer, thickest at the bottom"};  // thrust of a ball; plunges near d = R

constexpr double kFeed = 5e-3, kSpin = 1000;
constexpr forms::SteadyCut kLateral = cut_of(kFeed, kSpin);

constexpr double kGrid = 0.1 * mm;

struct Mill {
  ToolHead head;
  Box box;
  Vec3 start;
  double travel, from;
  double layer = 0;  // [m] engaged layer; 0: the default
  double voxel = kGrid;
  double spin = kSpin;

  [[nodiscard]] SteadyState run() const {
    SimulationConfig config;
    if (layer > 0) config.reference_stiffness = forms::stiffness_for_layer(kLateral, layer, kR);
    Simulation simulation(build_block(box, voxel, plain_material()),
                          Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    return feed(simulation, start, Vec3(kFeed, 0, 0), travel, kTick, from);
  }
};

std::vector<Check> milling() {
  const double h = 0.5 * mm;
  const Wrench in_slot = forms::slotting_wrench(kLateral, kR, h),
               at_side = forms::side_milling_wrench(kLateral, kR, h, 0, kPi / 2);
  const FlatHead cylinder{kR, 4 * mm, FlatRule::side_only};
  const SteadyState slot = Mill{cylinder,
                                {Vec3(0, -1.3, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm},
                                Vec3(-1.023, 0.011, -1.5) * mm,
                                3.3 * mm,
                                0.7,
                                kLayer,
                                kLayer / 2}
                               .run();
  // Half immersion: the material is at y > 0, so the engaged angles go from the feed to +y.
  const SteadyState side =
      Mill{cylinder, {Vec3(0, 0, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm}, Vec3(-1.023, 0, -1.5) * mm, 3.3 * mm, 0.75}.run();
  Mill turned = {cylinder, {Vec3(0, -1.3, -0.5) * mm, Vec3(3, 1.3, 0) * mm}, Vec3(-1.023, 0, -1.5) * mm, 2.5 * mm, 0.7,
                 0.1 * mm};
  const SteadyState right = turned.run();
  turned.spin = -kSpin;
  const SteadyState left = turned.run();
  constexpr Tolerance kMirrored = {1e-4, "single precision, a sum"};
  return joined(
      {compared("C24", "slotting with a cylinder", in_slot, slot, kOfThinLayer),
       {{"C24 other way", "spin the other way: force against the feed", "N", right.force.x(), left.force.x(),
         kMirrored},
        {"C24 other way, across", "spin the other way: side force", "N", -right.force.y(), left.force.y(), kMirrored},
        {"C24 other way, torque", "spin the other way: torque", "N m", -right.torque.z(), left.torque.z(), kMirrored}},
       compared("C25", "side milling, engaged over a quarter turn", at_side, side, kWall)});
}

std::vector<Check> balls() {
  const double d = 0.6 * kR;
  const Wrench in_groove = forms::groove_wrench(kLateral, kR, d), below = forms::buried_ball_wrench(kLateral, kR);
  const SteadyState groove = Mill{SphereHead{kR},
                                  {Vec3(0, -1.3, -0.7) * mm, Vec3(3.4, 1.3, 0) * mm},
                                  Vec3(-1.023 * mm, 0.011 * mm, kR - d),
                                  3.2 * mm,
                                  0.75}
                                 .run();
  Mill deep = {SphereHead{kR},
               {Vec3(0, -1.3, -1.3) * mm, Vec3(3.4, 1.3, 1.3) * mm},
               Vec3(-1.023, 0.011, 0.017) * mm,
               3.2 * mm,
               0.75};
  const SteadyState buried = deep.run();
  deep.layer = 0.1 * mm;
  const SteadyState soft = deep.run();
  return joined({compared("C26", "ball in a groove of depth 0.6 R", in_groove, groove, kBall, kBottom),
                 compared("C27", "buried ball fed sideways", below, buried, kBall),
                 {{"C30 ball", "ball: cutting energy over u times the removed volume, layer of R/10", "1", 1,
                   soft.energy.cutting / (plain_material().specific_cutting_energy * soft.removed_volume), kFineSteps},
                  error_of("C30 ball, ledger", "ball: energy balance over the turnover", test::unbooked(soft.energy),
                           kFineSteps)}});
}

std::vector<Check> plunges() {
  const double depth = 0.9 * mm, alpha = 45 * deg, speed = 1e-3;
  const auto plunge = [&](const ToolHead& head, double tip) {
    Simulation simulation(build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, kGrid, plain_material()),
                          Tool(head, RayHandle{0}, Spindle{kSpin * units::rad_per_s}));
    // The mean over the last 0.06 mm, centred on the depth.
    const double travel = depth + 0.03 * mm;
    return feed(simulation, Vec3(0.029 * mm, 0.013 * mm, tip), Vec3(0, 0, -speed), travel, kTick,
                1 - 0.06 * mm / travel);
  };
  const SteadyState ball = plunge(SphereHead{kR}, kR), cone = plunge(ConeHead{alpha, 2 * mm}, 0);
  const forms::SteadyCut cut = cut_of(speed, kSpin);
  return joined(
      {compared("C28", "ball plunged to 0.9 R", forms::ball_plunge_wrench(cut, kR, depth), ball, kBottom),
       compared("C29", "cone plunged to 0.9 mm", forms::cone_plunge_wrench(cut, alpha, depth), cone, kBottom)});
}

}  // namespace lateral_cuts

std::vector<Experiment> cutting_experiments() {
  using namespace lateral_cuts;
  return {// Proves: tangential force of the spin.
          {"milling", milling},
          {"balls", balls},
          {"plunges", plunges}};
}

}  // namespace hapticut::experiments
