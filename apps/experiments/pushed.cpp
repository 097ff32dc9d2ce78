// SPDX-License-Identifier: Apache-2.0
// C23, C24, C28 and C36: speed of a tool under a constant force of the hand, in every direction of the grid.
#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/grid_cuts.hpp"
#include "experiments/vocabulary.hpp"

namespace hapticut::experiments {
namespace pushed_cuts {

constexpr Tolerance kPushed = {0.04, "measured, worst of grid"};  // tolerance of the speed

/// [N/m^4] Lowest stiffness with a thin enough layer for balls and chips; at 1e14 they are off by 10 and 12 %.
constexpr double kThin = 1e15;

/// Speed of a cut that is pushed along its feed, and its force.
struct Push {
  double speed, force;  // [m/s], [N]
};

/// A constant force of the hand through a damper, which is soft against a layer of bone and stiff against the hand.
Push push(Simulation& simulation, const GridCut& cut, const Way& way, double hand) {
  constexpr double kDamper = 1000, kStep = 2.5e-4, kMaxSpeed = 5 * mm;  // [N s/m], [s], [m/s]
  constexpr int kSteps = 1200, kFrom = 600;
  const Vec3 along = (cut.end - cut.begin).normalized();
  double way_gone = 0, force = 0, begin = 0;
  Push pushed = {};
  for (int n = 0; n < kSteps; ++n) {
    const double speed = std::clamp((hand - force) / kDamper, -kMaxSpeed, kMaxSpeed);
    way_gone += speed * kStep;
    const Pose pose = {way.R_VT, way.R_VT * (cut.begin + way_gone * along) + way.p_V};
    const StepResult& result = simulation.step(pose, {way.R_VT * along * speed, Vec3::Zero()}, kStep);
    force = -(way.R_VT.transpose() * result.force).dot(along);
    if (n == kFrom) begin = way_gone;
    if (n >= kFrom) pushed.force += force / (kSteps - kFrom);
  }
  pushed.speed = (way_gone - begin) / (kStep * (kSteps - kFrom));
  return pushed;
}

/// The worst error over all directions and over the stiffnesses from `softest` up.
/// @param speed_under  [m/s] of the closed form under a force [N]
template <class SpeedUnder>
Check pushed(const char* id, const char* what, const GridCut& cut, double hand, double voxel,
             const SpeedUnder& speed_under, double softest = 1e14, const Tolerance& tolerance = kPushed,
             bool upright = false) {
  double worst = 0;
  for (const Way& way : upright ? std::vector<Way>{ways(voxel)[1]} : ways(voxel)) {
    const Workpiece block = oriented_block(way, cut.box, voxel, cut.material());
    for (const double stiffness : {1e14, 1e15, 1e16, 0.0, 1e17}) {
      if (stiffness > 0 && stiffness < softest) continue;
      Simulation simulation = cut.at_begin(way, block.clone(), stiffness);
      const Push found = push(simulation, cut, way, hand);
      worst = std::max(worst, std::abs(found.speed / speed_under(found.force) - 1));
    }
  }
  return error_of(id, std::string(what) + "; speed off by", worst, tolerance);
}

/// Cuts whose force is proportional to the speed.
auto in_proportion(const GridCut& cut) {
  const Vec3 along = (cut.end - cut.begin).normalized();
  return [speed = cut.cut.feed_speed, of = -cut.expected.force.dot(along)](double force) { return speed * force / of; };
}

GridCut drill_with(const forms::SteadyCut& cut) {
  return {"",
          "",
          FlatHead{kR, 8 * mm, FlatRule::bottom_only},
          kBlock,
          Vec3(0, 0, 0.1) * mm,
          Vec3(0, 0, -0.3) * mm,
          Vec3(0, 0, -0.9) * mm,
          1,
          {},
          cut};
}

std::vector<Check> drills() {
  std::vector<Check> checks;
  for (const double edge : {0.0, 5e5}) {
    forms::SteadyCut cut = kSlowCut;
    cut.edge_pressure = edge;
    const double hand = forms::axial_cutting_force_of_a_flat_head(cut, kR);
    for (const double voxel : {0.1 * mm, 0.05 * mm})
      checks.push_back(pushed(edge > 0 ? (voxel > 0.07 * mm ? "C23 pushed edge 0.1 mm" : "C23 pushed edge 0.05 mm")
                                       : (voxel > 0.07 * mm ? "C23 pushed 0.1 mm" : "C23 pushed 0.05 mm"),
                              edge > 0 ? "flat head pushed, p_e = 0.5 MPa" : "flat head pushed", drill_with(cut), hand,
                              voxel, [=](double force) { return forms::feed_of_a_flat_head_under(force, cut, kR); }));
  }
  return checks;
}

/// Chips of edges, thin chips and both, under 90 or 100 % of the force that gives the feed of `kSlowCut`.
std::vector<Check> drills_with_chips() {
  struct Chips {
    const char* id;
    const char* what;
    double edge, size, share;  // [1] edge and size over the chip, share of the force
    Tolerance tolerance = kPushed;
    bool upright = false;
  };
  constexpr Tolerance kEdges = {0.05, "measured, worst of grid"};
  std::vector<Check> checks;
  for (const Chips& c : {Chips{"C36 pushed 0.1 mm", "flat head pushed, chips, k_v from 1e15", 1, 2, 1},
                         Chips{"C36 edges pushed", "flat head pushed, chips of edges", 2, 0, 0.9, kEdges},
                         Chips{"C36 edges pushed upright", "flat head pushed, chips of edges, axis along the grid", 2,
                               0, 0.9, kPushed, true},
                         Chips{"C36 thin pushed", "flat head pushed, thin chips", 0, 4, 0.9}}) {
    const forms::SteadyCut chips = slow_cut_with_chips(c.edge, c.size);
    checks.push_back(pushed(
        c.id, c.what, drill_with(chips), c.share * forms::axial_chip_wrench(chips, kR).force.z(), 0.1 * mm,
        [=](double force) { return forms::feed_with_chips_under(force, chips, kR); }, kThin, c.tolerance, c.upright));
  }
  return checks;
}

/// In the steady state a force below the threshold of the edges cuts nothing. The threshold comes from an edge pressure
/// or from ploughing lips.
std::vector<Check> below_the_edges() {
  const Way upright = ways(0.1 * mm)[1];
  const auto speed = [&](const forms::SteadyCut& cut, double hand) {
    const GridCut drill = drill_with(cut);
    Simulation simulation =
        drill.at_begin(upright, oriented_block(upright, drill.box, 0.1 * mm, drill.material()), 1e16);
    for (int n = 0; n < 2; ++n) (void)push(simulation, drill, upright, hand);
    return push(simulation, drill, upright, hand).speed;
  };
  forms::SteadyCut edge = kSlowCut;
  edge.edge_pressure = 5e5;
  const forms::SteadyCut lips = slow_cut_with_chips(2, 0);
  forms::SteadyCut standing = lips;
  standing.feed_speed = 0;
  return {error_of("C23 pushed, stands", "flat head pushed with 95 % of its edge pressure: speed",
                   speed(edge, 0.95 * kPi * kR * kR * edge.edge_pressure), {1e-6, "1 um/s"}, "m/s"),
          error_of("C36 pushed, stands", "flat head pushed with 90 % of the threshold of its lips: speed",
                   speed(lips, 0.9 * forms::axial_chip_wrench(standing, kR).force.z()), {2e-5, "20 um/s"}, "m/s")};
}

std::vector<Check> slots_and_balls() {
  const GridCut slot = milled("", "", FlatHead{kR, 4 * mm, FlatRule::side_only}, kPlate, -1.5 * mm,
                              forms::slotting_wrench(kSlowCut, kR, 1 * mm));
  GridCut ball = {"",
                  "",
                  SphereHead{kR},
                  kBlock,
                  Vec3(0, 0, 1.1) * mm,
                  Vec3(0, 0, -0.1) * mm,
                  Vec3(0, 0, -0.7) * mm,
                  1,
                  forms::ball_plunge_wrench(kSlowCut, kR, kR)};
  ball.box.min.z() = -2.2 * mm;
  return {pushed("C24 pushed 0.1 mm", "cylinder pushed along a slot", slot, -slot.expected.force.x(), 0.1 * mm,
                 in_proportion(slot)),
          pushed("C28 pushed 0.1 mm", "ball pushed down beyond its radius, k_v from 1e15", ball,
                 ball.expected.force.z(), 0.1 * mm, in_proportion(ball), kThin)};
}

}  // namespace pushed_cuts

std::vector<Experiment> pushed_experiments() {
  using namespace pushed_cuts;
  return {{"pushed drills", drills},
          // Proves: chips.
          {"pushed drills with chips", drills_with_chips},
          // Proves: edge pressure.
          {"pushed below the edges", below_the_edges},
          {"pushed along a slot and down", slots_and_balls}};
}

}  // namespace hapticut::experiments
