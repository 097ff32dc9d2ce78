// SPDX-License-Identifier: Apache-2.0
// C20-C32, C34: steady cutting. The closed forms hold for an engaged layer that is thin against the head; what the
// layers of these cases leave is in the tolerances (docs/model.md, accuracy).
#include <cmath>

#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/tolerances.hpp"

namespace hapticut::validation {
namespace {

using units::deg;
using units::kPi;
using units::mm;

/// A cut of plain_material.
constexpr forms::SteadyCut cut_of(double feed_speed, double spin) { return {3e8, 0.5, spin, feed_speed}; }

constexpr double kLayer = kR / 40;  // engaged layer of C20-C22 and C24, on voxels of half of it
constexpr double kThinnest = 0.01;  // [1] with such a layer, fed axially

// On voxels of a tenth of the radius, in the layer that the simulation chooses:
constexpr double kWall = 0.03;    // [1] fed sideways
constexpr double kBall = 0.03;    // [1] the same where depths meet the surface at all angles
constexpr double kBottom = 0.06;  // [1] the thrust of a ball, whose layer is thickest at the bottom; plunges near d = R

// --- axial: a flat head into a half space ----------------------------------------------------------------------------

constexpr double kAxialFeed = 2e-3, kAxialSpin = 2000;

struct Axial {
  double feed_speed = kAxialFeed;
  double voxel = 0.05 * mm;
  double dt = 1e-3;
  double kappa = 0.5;
  double edge_pressure = 0;
  RemovalLaw removal = RemovalLaw::constant_energy;
  double stiffness = 1e14;  // an engaged layer of R/9 at the rim
  double travel = 2 * mm;

  [[nodiscard]] forms::SteadyCut form() const {
    forms::SteadyCut cut = cut_of(feed_speed, kAxialSpin);
    cut.cutting_ratio = kappa;
    cut.edge_pressure = edge_pressure;
    return cut;
  }
};

/// The engaged layer of a fortieth of the radius, until the cut is steady and ten layers more.
Axial axial_with_thin_layer() {
  Axial cut;
  cut.stiffness = forms::stiffness_for_layer(cut.form(), kLayer, kR);
  cut.voxel = kLayer / 2;
  cut.travel = 0.6 * mm;
  return cut;
}

Simulation axial_simulation(const Axial& cut, double depth) {
  SimulationConfig config;
  config.reference_stiffness = cut.stiffness;
  config.removal = cut.removal;
  Material material = plain_material();
  material.cutting_ratio = cut.kappa;
  material.edge_pressure = cut.edge_pressure;
  return Simulation(
      build_block({Vec3(-1.31, -1.27, -(depth / mm) - 0.313) * mm, Vec3(1.31, 1.27, 0) * mm}, cut.voxel, material),
      Tool(FlatHead{kR, depth + 2 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kAxialSpin * units::rad_per_s}),
      config);
}

SteadyState axial(const Axial& cut) {
  Simulation simulation = axial_simulation(cut, cut.travel);
  return feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -cut.feed_speed), cut.travel, cut.dt);
}

std::vector<Check> axial_constant_energy() {
  const Axial cut = axial_with_thin_layer();
  const SteadyState s = axial(cut);
  return {{"C20 thrust", "flat head fed axially, law A", "N", forms::axial_cutting_force_of_a_flat_head(cut.form(), kR),
           s.force.z(), kThinnest},
          {"C20 torque", "its torque", "N m", forms::axial_cutting_torque_of_a_flat_head(cut.form(), kR), s.torque.z(),
           kThinnest},
          {"C30", "power of motor and hand over the cutting energy of the removed volume", "J",
           s.energy.cutting + s.energy.elastic + s.energy.released + s.energy.rubbing - s.energy.credited,
           s.energy.motor_work + s.energy.hand_work, kInvariant},
          {"C32", "torque over thrust of a flat head: kappa R/2", "m",
           forms::torque_over_thrust_of_chips(cut.kappa, kR), -s.torque.z() / s.force.z(), kThinLayer},
          {"C34", "filled volume under a flat head: (4 pi/3) R^2 delta(R)", "m^3",
           forms::engaged_volume_under_a_flat_head(kR, kLayer), s.engaged_volume, kThickLayer},
          {"ledger", "energy balance of the whole cut", "J", 0, s.energy.imbalance() + s.energy.entered,
           kSinglePrecision, s.energy.motor_work + s.energy.hand_work}};
}

std::vector<Check> axial_invariance() {
  Axial coarse, fine, quick;
  coarse.voxel = 0.05 * mm;
  fine.voxel = 0.025 * mm;
  quick.dt = 1e-4;
  const SteadyState a = axial(coarse), b = axial(fine), c = axial(quick);
  return {
      {"invariance l", "thrust of C20 with voxels of 0.025 instead of 0.05 mm", "N", a.force.z(), b.force.z(),
       kPartialVoxels},
      {"invariance dt", "thrust of C20 with steps of 0.1 instead of 1 ms", "N", a.force.z(), c.force.z(), kInvariant}};
}

std::vector<Check> axial_elastic_release() {
  Axial cut = axial_with_thin_layer();
  cut.removal = RemovalLaw::elastic_release;
  const SteadyState s = axial(cut);
  return {{"C21 thrust", "flat head fed axially, law G", "N",
           forms::axial_cutting_force_with_elastic_release(cut.form(), kR), s.force.z(), kThinnest},
          {"C21 power", "T omega + F v is u dV/dt", "W", forms::cutting_power(cut.form(), kPi * kR * kR * kAxialFeed),
           -s.torque.z() * kAxialSpin + s.force.z() * kAxialFeed, kThinnest}};
}

std::vector<Check> axial_edge_pressure() {
  Axial cut = axial_with_thin_layer();
  cut.edge_pressure = 1e6;
  const SteadyState s = axial(cut);
  return {{"C22 thrust", "flat head fed axially, with edge pressure", "N",
           forms::axial_cutting_force_of_a_flat_head(cut.form(), kR), s.force.z(), kThinnest},
          {"C22 torque", "its torque", "N m", forms::axial_cutting_torque_of_a_flat_head(cut.form(), kR), s.torque.z(),
           kThinnest}};
}

/// So slow that the edge carries nineteen parts of twenty.
std::vector<Check> axial_edge_dominated() {
  Axial cut;
  cut.edge_pressure = 2e6;
  cut.feed_speed = 0.1 * kAxialFeed;
  const SteadyState s = axial(cut);
  return {{"C32 edge", "torque over thrust of a flat head whose edge rubs: 2 kappa R/3", "m",
           forms::torque_over_thrust_of_edges(cut.kappa, kR), -s.torque.z() / s.force.z(), kThinLayer}};
}

/// A hand that pushes with a constant force: its speed adapts until the cut pushes back as much.
std::vector<Check> constant_hand_force() {
  Axial cut;
  cut.voxel = 0.1 * mm;
  cut.stiffness = 0;
  cut.edge_pressure = 3e5;
  Simulation simulation = axial_simulation(cut, 8 * mm);
  const double chips = forms::axial_cutting_force_of_a_flat_head(cut_of(kAxialFeed, kAxialSpin), kR);
  const double hand = kPi * kR * kR * cut.edge_pressure + 0.75 * chips;
  const double inertia = 0.2 * chips / kAxialFeed;  // [N s/m] settles in a few times 0.2 s
  double depth = 0, speed = 0.5 * kAxialFeed, mean = 0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    depth += speed * 1e-3;
    const StepResult& result =
        simulation.step(Pose::from_translation(Vec3(0.0293 * mm, 0.0113 * mm, -depth)), {}, 1e-3);
    speed += (hand - result.force.z()) / inertia * 1e-3;
    if (i >= kSteps / 2) mean += speed / (kSteps - kSteps / 2.0);
  }
  return {{"C23", "feed speed under a constant force of the hand", "m/s",
           forms::feed_of_a_flat_head_under(hand, cut.form(), kR), mean, kThinLayer}};
}

std::vector<Check> twist_drill() {
  Axial cut;
  cut.kappa = 1;  // 1/sin(90 deg)
  const SteadyState s = axial(cut);
  const Wrench drill = forms::twist_drill_wrench(cut.form(), 2 * kR, kPi);
  return {{"C31 thrust", "default law with kappa = 1/sin(beta/2): the twist drill's thrust", "N", drill.force.z(),
           s.force.z(), kThinLayer},
          {"C31 torque", "and torque, K_s a D^2/8", "N m", drill.torque.z(), s.torque.z(), kPartialVoxels}};
}

// --- lateral ---------------------------------------------------------------------------------------------------------

constexpr double kFeed = 5e-3, kSpin = 1000;
constexpr forms::SteadyCut kLateral = cut_of(kFeed, kSpin);

constexpr double kGrid = 0.1 * mm;

SteadyState mill(const ToolHead& head, const Box& box, const Vec3& start, double travel) {
  Simulation simulation(build_block(box, kGrid, plain_material()),
                        Tool(head, RayHandle{0}, Spindle{kSpin * units::rad_per_s}));
  return feed(simulation, start, Vec3(kFeed, 0, 0), travel, kTick, 0.75);
}

std::vector<Check> milling() {
  const double h = 0.5 * mm;
  const Wrench in_slot = forms::slotting_wrench(kLateral, kR, h),
               at_side = forms::side_milling_wrench(kLateral, kR, h, 0, kPi / 2);
  const FlatHead cylinder{kR, 4 * mm, FlatRule::side_only};
  const SteadyState slot =
      mill(cylinder, {Vec3(0, -1.3, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm}, Vec3(-1.023, 0.011, -1.5) * mm, 3.3 * mm);
  // Half immersion: material only at y > 0, so the engaged angles go from the feed to +y.
  const SteadyState side =
      mill(cylinder, {Vec3(0, 0, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm}, Vec3(-1.023, 0, -1.5) * mm, 3.3 * mm);
  return {{"C24 against the feed", "slotting with a cylinder", "N", in_slot.force.x(), slot.force.x(), kWall},
          {"C24 across", "its side force", "N", in_slot.force.y(), slot.force.y(), kWall},
          {"C24 torque", "its torque", "N m", in_slot.torque.z(), slot.torque.z(), kWall},
          {"C25 against the feed", "side milling, engaged over a quarter turn", "N", at_side.force.x(), side.force.x(),
           kWall},
          {"C25 across", "its side force", "N", at_side.force.y(), side.force.y(), kWall},
          {"C25 torque", "its torque", "N m", at_side.torque.z(), side.torque.z(), kWall}};
}

std::vector<Check> balls() {
  const double d = 0.6 * kR;
  const Wrench in_groove = forms::groove_wrench(kLateral, kR, d), below = forms::buried_ball_wrench(kLateral, kR);
  const SteadyState groove = mill(SphereHead{kR}, {Vec3(0, -1.3, -0.7) * mm, Vec3(3.4, 1.3, 0) * mm},
                                  Vec3(-1.023 * mm, 0.011 * mm, kR - d), 3.2 * mm);
  const SteadyState buried = mill(SphereHead{kR}, {Vec3(0, -1.3, -1.3) * mm, Vec3(3.4, 1.3, 1.3) * mm},
                                  Vec3(-1.023, 0.011, 0.017) * mm, 3.2 * mm);
  return {
      {"C26 against the feed", "ball in a groove of depth 0.6 R", "N", in_groove.force.x(), groove.force.x(), kBall},
      {"C26 across", "its side force", "N", in_groove.force.y(), groove.force.y(), kBall},
      {"C26 thrust", "its thrust", "N", in_groove.force.z(), groove.force.z(), kBottom},
      {"C26 torque", "its torque", "N m", in_groove.torque.z(), groove.torque.z(), kBall},
      {"C27 against the feed", "buried ball fed sideways", "N", below.force.x(), buried.force.x(), kBall},
      {"C27 across", "its side force", "N", below.force.y(), buried.force.y(), kBall},
      {"C27 torque", "its torque", "N m", below.torque.z(), buried.torque.z(), kBall}};
}

std::vector<Check> plunges() {
  const double depth = 0.9 * mm, alpha = 45 * deg, speed = 1e-3;
  const auto plunge = [&](const ToolHead& head, double tip) {
    Simulation simulation(build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, kGrid, plain_material()),
                          Tool(head, RayHandle{0}, Spindle{kSpin * units::rad_per_s}));
    // The last 0.06 mm, centred on the depth.
    const double travel = depth + 0.03 * mm;
    return feed(simulation, Vec3(0.029 * mm, 0.013 * mm, tip), Vec3(0, 0, -speed), travel, kTick,
                1 - 0.06 * mm / travel);
  };
  const SteadyState ball = plunge(SphereHead{kR}, kR), cone = plunge(ConeHead{alpha, 2 * mm}, 0);
  const forms::SteadyCut cut = cut_of(speed, kSpin);
  const Wrench of_ball = forms::ball_plunge_wrench(cut, kR, depth),
               of_cone = forms::cone_plunge_wrench(cut, alpha, depth);
  return {{"C28 thrust", "ball plunged to 0.9 R", "N", of_ball.force.z(), ball.force.z(), kBottom},
          {"C28 torque", "its torque", "N m", of_ball.torque.z(), ball.torque.z(), kBottom},
          {"C29 thrust", "cone plunged to 0.9 mm", "N", of_cone.force.z(), cone.force.z(), kBottom},
          {"C29 torque", "its torque", "N m", of_cone.torque.z(), cone.torque.z(), kBottom}};
}

}  // namespace

std::vector<Experiment> cutting_experiments() {
  return {{"axial, law A", axial_constant_energy},
          {"axial, invariance", axial_invariance},
          {"axial, law G", axial_elastic_release},
          {"axial, edge pressure", axial_edge_pressure},
          {"flat head, edge dominated", axial_edge_dominated},
          {"constant hand force", constant_hand_force},
          {"twist drill", twist_drill},
          {"milling", milling},
          {"balls", balls},
          {"plunges", plunges}};
}

}  // namespace hapticut::validation
