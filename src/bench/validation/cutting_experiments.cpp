// SPDX-License-Identifier: Apache-2.0
// C20-C32, C34: steady cutting. The closed forms hold for an engaged layer that is thin against the head; what the
// layers of these cases leave is in the tolerances (model: what accuracy to expect).
#include <cmath>

#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/tolerances.hpp"

namespace hapticut::validation {
namespace {

using units::deg;
using units::kPi;
using units::mm;

constexpr double kU = 3e8, kKappa = 0.5;  // of plain_material
constexpr double kLayer = kR / 40;        // engaged layer of C20-C22 and C24, on voxels of half of it
constexpr double kThinnest = 0.01;        // [1] with such a layer, fed axially
constexpr double kSlot = 0.02;            // [1] with such a layer, fed sideways
constexpr double kThrustOfBall = 0.1;     // [1] its layer is thickest at the bottom, where the thrust is
constexpr double kBall = 0.06;            // [1] the same where depths meet the surface at all angles

// --- axial: a flat head into a half space ----------------------------------------------------------------------------

constexpr double kAxialFeed = 2e-3, kAxialSpin = 2000;

struct Axial {
  double feed_speed = kAxialFeed;
  double voxel = 0.05 * mm;
  double dt = 1e-3;
  double kappa = kKappa;
  double edge_pressure = 0;
  RemovalLaw removal = RemovalLaw::constant_energy;
  double stiffness = 1e14;  // an engaged layer of R/9 at the rim
  double travel = 2 * mm;
};

/// The engaged layer of a fortieth of the radius, until the cut is steady and ten layers more.
Axial axial_with_thin_layer() {
  Axial cut;
  cut.stiffness = 2 * kU * kAxialFeed / (kKappa * kAxialSpin * kR * kLayer * kLayer);
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
      Tool(FlatHead{kR, depth + 2 * mm, FlatRule::bottom_only}, RayHandle{}, Spindle{kAxialSpin}), config);
}

Steady axial(const Axial& cut) {
  Simulation simulation = axial_simulation(cut, cut.travel);
  return feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -cut.feed_speed), cut.travel, 0.5, cut.dt);
}

const double kThrust = 2 * kPi * kR * kU * kAxialFeed / (kKappa * kAxialSpin);
const double kTorque = -kU * kPi * kR * kR * kAxialFeed / kAxialSpin;

std::vector<Check> axial_constant_energy() {
  const Steady s = axial(axial_with_thin_layer());
  return {{"C20 thrust", "flat head fed axially, law A", "N", kThrust, s.force.z(), kThinnest},
          {"C20 torque", "its torque", "N m", kTorque, s.torque.z(), kThinnest},
          {"C30", "power of motor and hand over the cutting energy of the removed volume", "J",
           s.energy.cutting + s.energy.elastic + s.energy.released + s.energy.rubbing - s.energy.credited,
           s.energy.motor_work + s.energy.hand_work, kInvariant},
          {"C32", "torque over thrust of a flat head: kappa R/2", "m", kKappa * kR / 2, -s.torque.z() / s.force.z(),
           kThinLayer},
          {"C34", "filled volume under a flat head: (2 pi^1.5/3) R^2 delta(R)", "m^3",
           2 * std::pow(kPi, 1.5) / 3 * kR * kR * kLayer, s.engaged_volume, kThickLayer},
          {"ledger", "energy balance of the whole cut", "J", 0, s.energy.imbalance(), kSinglePrecision,
           s.energy.motor_work + s.energy.hand_work}};
}

std::vector<Check> axial_invariance() {
  Axial coarse, fine, quick;
  coarse.voxel = 0.05 * mm;
  fine.voxel = 0.025 * mm;
  quick.dt = 1e-4;
  const Steady a = axial(coarse), b = axial(fine), c = axial(quick);
  return {
      {"invariance l", "thrust of C20 with voxels of 0.025 instead of 0.05 mm", "N", a.force.z(), b.force.z(),
       kPartialVoxels},
      {"invariance dt", "thrust of C20 with steps of 0.1 instead of 1 ms", "N", a.force.z(), c.force.z(), kInvariant}};
}

std::vector<Check> axial_elastic_release() {
  Axial cut = axial_with_thin_layer();
  cut.removal = RemovalLaw::elastic_release;
  const Steady s = axial(cut);
  const double speed = kKappa * kAxialSpin;
  return {{"C21 thrust", "flat head fed axially, law G", "N",
           2 * kPi * kU * kAxialFeed / speed * (kR - kAxialFeed / speed * std::log1p(speed * kR / kAxialFeed)),
           s.force.z(), kThinnest},
          {"C21 power", "T omega + F v is u dV/dt", "W", kU * kPi * kR * kR * kAxialFeed,
           -s.torque.z() * kAxialSpin + s.force.z() * kAxialFeed, kThinnest}};
}

std::vector<Check> axial_edge_pressure() {
  Axial cut = axial_with_thin_layer();
  cut.edge_pressure = 1e6;
  const Steady s = axial(cut);
  const double edge = kPi * kR * kR * cut.edge_pressure;
  return {{"C22 thrust", "flat head fed axially, with edge pressure", "N", edge + kThrust, s.force.z(), kThinnest},
          {"C22 torque", "its torque", "N m", kTorque - 2 * kPi / 3 * kKappa * cut.edge_pressure * std::pow(kR, 3),
           s.torque.z(), kThinnest}};
}

/// So slow that the edge carries nineteen parts of twenty.
std::vector<Check> axial_edge_dominated() {
  Axial cut;
  cut.edge_pressure = 2e6;
  cut.feed_speed = 0.1 * kAxialFeed;
  const Steady s = axial(cut);
  return {{"C32 edge", "torque over thrust of a flat head whose edge rubs: 2 kappa R/3", "m", 2.0 / 3 * kKappa * kR,
           -s.torque.z() / s.force.z(), kThinLayer}};
}

/// A hand that pushes with a constant force: its speed adapts until the cut pushes back as much.
std::vector<Check> constant_hand_force() {
  Axial cut;
  cut.voxel = 0.1 * mm;
  cut.edge_pressure = 3e5;
  Simulation simulation = axial_simulation(cut, 8 * mm);
  const double edge = kPi * kR * kR * cut.edge_pressure, hand = edge + 0.75 * kThrust;
  const double inertia = 0.2 * kThrust / kAxialFeed;  // [N s/m] settles in a few times 0.2 s
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
           kKappa * kAxialSpin * (hand - edge) / (2 * kPi * kR * kU), mean, kThinLayer}};
}

std::vector<Check> twist_drill() {
  Axial cut;
  cut.kappa = 1;  // 1/sin(90 deg)
  const Steady s = axial(cut);
  const double a = 2 * kPi * kAxialFeed / kAxialSpin;
  return {{"C31 thrust", "default law with kappa = 1/sin(beta/2): the twist drill's thrust", "N", kU * a * kR,
           s.force.z(), kThinLayer},
          {"C31 torque", "and torque, K_s a D^2/8", "N m", -kU * a * kR * kR / 2, s.torque.z(), kPartialVoxels}};
}

// --- lateral ---------------------------------------------------------------------------------------------------------

constexpr double kFeed = 5e-3, kSpin = 1000;

SimulationConfig with_layer(double layer, double feed_speed = kFeed) {
  SimulationConfig config;
  config.reference_stiffness = 2 * kU * feed_speed / (kKappa * kSpin * kR * layer * layer);
  return config;
}

Steady mill(const ToolHead& head, const Box& box, const Vec3& start, double layer, double travel,
            double voxel = 0.05 * mm) {
  Simulation simulation(build_block(box, voxel, plain_material()), Tool(head, RayHandle{}, Spindle{kSpin}),
                        with_layer(layer));
  return feed(simulation, start, Vec3(kFeed, 0, 0), travel, 0.75);
}

std::vector<Check> milling() {
  const double h = 0.5 * mm, unit = kU * kFeed * h / kSpin;
  const FlatHead cylinder{kR, 4 * mm, FlatRule::side_only};
  const Steady slot = mill(cylinder, {Vec3(0, -1.3, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm}, Vec3(-1.023, 0.011, -1.5) * mm,
                           kLayer, 3.3 * mm, kLayer / 2);
  // Half immersion: material only at y > 0, so the engaged angles go from the feed to +y.
  const Steady side =
      mill(cylinder, {Vec3(0, 0, -0.5) * mm, Vec3(3.5, 1.3, 0) * mm}, Vec3(-1.023, 0, -1.5) * mm, 0.05 * mm, 3.3 * mm);
  return {{"C24 against the feed", "slotting with a cylinder", "N", -kPi / 2 * unit / kKappa, slot.force.x(), kSlot},
          {"C24 across", "its side force", "N", -kPi / 2 * unit, slot.force.y(), kSlot},
          {"C24 torque", "its torque", "N m", -2 * unit * kR, slot.torque.z(), kSlot},
          {"C25 against the feed", "side milling, engaged over a quarter turn", "N",
           -unit / kKappa * kPi / 4 + unit / 2, side.force.x(), kThickLayer},
          {"C25 across", "its side force", "N", -unit / kKappa / 2 - unit * kPi / 4, side.force.y(), kBall},
          {"C25 torque", "its torque", "N m", -unit * kR, side.torque.z(), kThinLayer}};
}

std::vector<Check> balls() {
  const double unit = kU * kFeed * kR / kSpin;
  const double d = 0.6 * kR, theta = std::acos(1 - d / kR), g = theta - std::sin(theta) * std::cos(theta);
  const Steady groove = mill(SphereHead{kR}, {Vec3(0, -1.3, -0.7) * mm, Vec3(3.4, 1.3, 0) * mm},
                             Vec3(-1.023 * mm, 0.011 * mm, kR - d), 0.03 * mm, 3.2 * mm, 0.03 * mm);
  const Steady buried = mill(SphereHead{kR}, {Vec3(0, -1.3, -1.3) * mm, Vec3(3.4, 1.3, 1.3) * mm},
                             Vec3(-1.023, 0.011, 0.017) * mm, 0.05 * mm, 3.2 * mm);
  return {
      {"C26 against the feed", "ball in a groove of depth 0.6 R", "N", -kPi / 4 * unit * g / kKappa, groove.force.x(),
       kBall},
      {"C26 across", "its side force", "N", -kPi / 2 * unit * (1 - std::cos(theta)), groove.force.y(), kBall},
      {"C26 thrust", "its thrust", "N", unit / kKappa * std::pow(std::sin(theta), 2), groove.force.z(), kThrustOfBall},
      {"C26 torque", "its torque", "N m", -unit * kR * g, groove.torque.z(), kBall},
      {"C27 against the feed", "buried ball fed sideways", "N", -kPi * kPi / 4 * unit / kKappa, buried.force.x(),
       kBall},
      {"C27 across", "its side force", "N", -kPi * unit, buried.force.y(), kBall},
      {"C27 torque", "its torque", "N m", -kPi * unit * kR, buried.torque.z(), kBall}};
}

std::vector<Check> plunges() {
  const double depth = 0.9 * mm, theta = std::acos(1 - depth / kR), alpha = 45 * deg, a = depth * std::tan(alpha);
  const double speed = 1e-3;
  const auto plunge = [&](const ToolHead& head, double tip) {
    Simulation simulation(
        build_block({Vec3(-1.4, -1.4, -1.5) * mm, Vec3(1.4, 1.4, 0) * mm}, 0.05 * mm, plain_material()),
        Tool(head, RayHandle{}, Spindle{kSpin}), with_layer(0.05 * mm, speed));
    // The last 0.06 mm, centred on the depth.
    const double travel = depth + 0.03 * mm;
    return feed(simulation, Vec3(0.029 * mm, 0.013 * mm, tip), Vec3(0, 0, -speed), travel, 1 - 0.06 * mm / travel);
  };
  const Steady ball = plunge(SphereHead{kR}, kR), cone = plunge(ConeHead{alpha, 2 * mm}, 0);
  constexpr double kAsymptotic = 0.13;  // [1] near d = R, as the model says
  return {{"C28 thrust", "ball plunged to 0.9 R", "N",
           kPi * kR * kU * speed / (kKappa * kSpin) * (theta + std::sin(theta) * std::cos(theta)), ball.force.z(),
           kAsymptotic},
          {"C28 torque", "its torque", "N m", -kU * kPi * std::pow(kR * std::sin(theta), 2) * speed / kSpin,
           ball.torque.z(), kAsymptotic},
          {"C29 thrust", "cone plunged to 0.9 mm", "N", 2 * kPi * kU * speed * std::sin(alpha) * a / (kKappa * kSpin),
           cone.force.z(), kAsymptotic},
          {"C29 torque", "its torque", "N m", -kU * kPi * a * a * speed / kSpin, cone.torque.z(), kAsymptotic}};
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
