// SPDX-License-Identifier: Apache-2.0
// C1-C16, C19: a head held still in material. Voxels of a twentieth of the radius, where a partly filled grid is within
// a percent (docs/decisions/0002-quadrature.md).
#include <cmath>

#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/tolerances.hpp"

namespace hapticut::validation {
namespace {

using units::deg;
using units::kPi;
using units::mm;

constexpr double kVoxel = 0.05 * mm;
constexpr double kFine = 0.01;  // [1] tolerance of a wrench on this grid

Pose ball_at(double depth) { return Pose::from_translation(Vec3(0, 0, kR - depth)); }

Simulation pressed(const ToolHead& head, double depth, const Handle& handle = RayHandle{0},
                   const Material& material = plain_material()) {
  return Simulation(half_space(head.largest_radius(), depth, kVoxel, material), Tool(head, handle), static_config());
}

std::vector<Check> ball() {
  std::vector<Check> checks;
  for (const double share : {0.5, 1.0, 1.4}) {
    const double d = share * kR;
    Simulation simulation = pressed(SphereHead{kR}, d);
    checks.push_back({"C1 d=" + std::to_string(share).substr(0, 3) + "R", "ball in a half space, vertical force", "N",
                      forms::cap_force(kStiffness, kR, d), hold(simulation, ball_at(d)).force.z(), kFine});
  }
  return checks;
}

std::vector<Check> ball_stiffness_and_energy() {
  const double d = 2 * kR / 3, h = 0.1 * kR;
  Simulation simulation = pressed(SphereHead{kR}, kR);
  const auto force = [&](double at) { return hold(simulation, ball_at(at)).force.z(); };
  const double slope = (8 * (force(d + h) - force(d - h)) - (force(d + 2 * h) - force(d - 2 * h))) / (12 * h);
  Simulation slow(half_space(kR, kR, kVoxel), Tool(SphereHead{kR}), [] {
    SimulationConfig config = static_config();
    config.longest_sweep = 64;
    return config;
  }());
  for (int i = 0; i <= 500; ++i) (void)slow.step(ball_at(0.5 * kR * i / 500), {}, 1e-3);
  const EnergyLedger& energy = slow.last_result().energy;
  return {{"C2", "ball, stiffness at d = 2R/3, its greatest", "N/m", forms::largest_cap_stiffness(kStiffness, kR),
           slope, kFine},
          {"C3", "ball, work of the hand down to R/2", "J", forms::cap_energy(kStiffness, kR, 0.5 * kR),
           energy.hand_work, kFine},
          {"C3 stored", "ball, what is stored is what the hand paid and what entered", "J",
           energy.hand_work + energy.entered, energy.elastic, kSinglePrecision},
          {"C3 entered", "what entered: (l/d)^2/130, by the least width of a section", "J", 0, energy.entered,
           kFineSteps, energy.hand_work}};
}

std::vector<Check> cone() {
  const double d = 0.8 * kR;
  std::vector<Check> checks;
  for (const int angle : {30, 45}) {
    const double a = angle * deg;
    Simulation simulation = pressed(ConeHead{a, 1.5 * kR}, d);
    checks.push_back({"C4 " + std::to_string(angle) + " deg", "cone, half-apex angle " + std::to_string(angle) + " deg",
                      "N", forms::cone_force(kStiffness, a, d),
                      hold(simulation, Pose::from_translation(Vec3(0, 0, -d))).force.z(), kRim});
  }
  return checks;
}

std::vector<Check> flat() {
  const double d = 0.6 * kR, into_wall = 0.3 * kR, c = kR - into_wall;
  const auto press = [&](FlatRule rule) {
    Simulation simulation = pressed(FlatHead{kR, 3 * kR, rule}, d);
    return hold(simulation, Pose::from_translation(Vec3(0, 0, -d))).force.z();
  };
  std::vector<Check> checks = {{"C5", "flat head on its bottom, rule bottom_only", "N",
                                forms::flat_bottom_force(kStiffness, kR, d), press(FlatRule::bottom_only), kFine},
                               {"C6", "flat head on its bottom, rule nearest", "N",
                                forms::flat_nearest_force(kStiffness, kR, d), press(FlatRule::nearest), kRim}};
  // The side of the cylinder in the wall x > c, over a height in the middle of it; the hand is at the bottom's centre.
  const double z0 = 0.9 * kR, z1 = 1.7 * kR;
  Simulation side(build_block({Vec3(c, -1.11 * kR, z0), Vec3(1.2 * kR, 1.13 * kR, z1)}, kVoxel, plain_material()),
                  Tool(FlatHead{kR, 3 * kR, FlatRule::side_only}), static_config());
  const StepResult& result = hold(side, Pose{});
  checks.push_back({"C7", "side of a cylinder in a wall", "N",
                    forms::side_wall_force(kStiffness, kR, into_wall, z1 - z0), result.force.x(), kRim});
  checks.push_back({"C8", "its torque about the bottom's centre", "N m",
                    forms::side_wall_torque(kStiffness, kR, into_wall, z0, z1, 0), result.torque.y(), kRim});
  const double x0 = 0.4 * kR;
  Simulation edge(
      build_block({Vec3(-1.17 * kR, -1.11 * kR, -0.9 * kR), Vec3(x0, 1.13 * kR, 0)}, kVoxel, plain_material()),
      Tool(FlatHead{kR, 3 * kR, FlatRule::bottom_only}), static_config());
  const StepResult& over_edge = hold(edge, Pose::from_translation(Vec3(0, 0, -d)));
  checks.push_back({"C9 force", "flat bottom over a straight edge", "N", forms::edge_force(kStiffness, kR, d, x0),
                    over_edge.force.z(), kFine});
  checks.push_back(
      {"C9 torque", "its torque", "N m", forms::edge_torque(kStiffness, kR, d, x0), over_edge.torque.y(), kRim});
  return checks;
}

std::vector<Check> layers() {
  const double d = 0.8 * kR, t = 0.3 * kR;
  const auto force = [&](const std::vector<Layer>& slab, double voxel) {
    const Box box{Vec3(-1.13, -1.15, -2) * mm, Vec3(1.13, 1.15, 0) * mm};
    Simulation simulation(build_layered_slab(box, voxel, slab), Tool(SphereHead{kR}), static_config());
    return hold(simulation, ball_at(d)).force.z();
  };
  const auto material = [](const char* name, double stiffness) {
    Material m = plain_material();
    m.name = name;
    m.relative_stiffness = stiffness;
    return m;
  };
  std::vector<Layer> graded;
  constexpr int kLayers = 60;
  graded.reserve(kLayers);
  for (int i = 0; i < kLayers; ++i)
    graded.push_back({material(("layer " + std::to_string(i)).c_str(), 1 + (i + 0.5) * kVoxel / (0.5 * mm)), kVoxel});
  const Vec3 gradient(0, 0, -kStiffness / (0.5 * mm));  // [N/m^5]
  return {{"C10", "ball through a layer into a softer one", "N",
           forms::layered_cap_force(kStiffness, 0.3 * kStiffness, t, kR, d),
           force({{material("hard", 1), t}, {material("soft", 0.3), 1.2 * mm}}, kVoxel), kFine},
          {"C10 breakthrough", "ball through a plate", "N", forms::layered_cap_force(kStiffness, 0, t, kR, d),
           force({{material("hard", 1), t}}, kVoxel), kRim},
          {"C12", "stiffness that grows with depth", "N", forms::graded_cap_force(kStiffness, gradient, kR, d).z(),
           force(graded, kVoxel), kFine}};
}

// C11: the wrench is that of the pressure k_v w^2/2 on the surface of the material, here the plane z = 0 under a tilted
// cone, whose base stays above it.
std::vector<Check> pressure_identity() {
  const double a = 35 * deg;
  const ConeHead cone{a, 2 * kR};
  const Pose X_WT{rotation_from_vector(Vec3(0.25, 0.35, 0)), Vec3(0.013, 0.021, -0.7) * mm};
  Simulation simulation(half_space(2 * kR, 1 * kR, kVoxel), Tool(cone), static_config());
  const StepResult& result = hold(simulation, X_WT);
  const auto depth = [=](double rho, double z) { return z * std::sin(a) - rho * std::cos(a); };
  const Wrench expected = forms::wrench_on_plane(kStiffness, depth, X_WT, {}, Vec3(0, 0, 0.7 * kR), 2 * kR, 600);
  return {{"C11 force", "tilted cone against a plane quadrature, error of the force vector", "N", 0,
           (result.force - expected.force).norm(), kFine, expected.force.norm()},
          {"C11 torque", "the same of the torque vector", "N m", 0, (result.torque - expected.torque).norm(), kFine,
           expected.torque.norm()}};
}

std::vector<Check> closed_path() {
  SimulationConfig config = static_config();
  config.longest_sweep = 64;
  // Around an edge, where on a plane each half of the way would undo the other.
  Simulation simulation(
      build_block({Vec3(-1.61, -1.87, -1.13) * mm, Vec3(0.21, 1.85, 0) * mm}, kVoxel, plain_material()),
      Tool(SphereHead{kR}), config);
  double work = 0, turnover = 0, before = 0, torque = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = 2 * kPi * i / 1000;
    const StepResult& result =
        simulation.step(Pose::from_translation(Vec3(0.3 * kR * std::sin(t), 0.2 * kR * std::sin(2 * t),
                                                    kR - 0.4 * kR * (1 - std::cos(t)))),
                        {}, 1e-3);
    work = result.energy.hand_work;
    turnover += std::abs(work - before);
    torque = std::max(torque, result.torque.norm() / (kR * std::max(result.force.norm(), 1e-3)));
    before = work;
  }
  return {{"C13", "closed path without removal: work", "J", forms::kWorkOfAClosedPath, work, kInvariant, turnover},
          {"C14", "ball: torque about its centre", "N m", 0, torque, kSinglePrecision, 1}};
}

std::vector<Check> handle_and_damping() {
  // C19: power is the same at the handle and at the head.
  const LHandle handle{60 * mm, 15 * mm, 60 * deg};
  Simulation simulation(half_space(kR, kR, kVoxel), Tool(SphereHead{kR}, handle), static_config());
  const Pose X_WH = ball_at(0.6 * kR) * simulation.tool().X_HT().inverse();
  const StepResult& felt = hold(simulation, X_WH);
  const Vec3 arm = ball_at(0.6 * kR).translation - X_WH.translation;
  const Twist twist{Vec3(0.02, -0.01, -0.03), Vec3(0.4, 1.1, -0.7)};
  const double at_handle = forms::power({felt.force, felt.torque}, twist);
  const double at_head =
      forms::power({felt.force, forms::ball_torque(Vec3::Zero(), felt.force)}, transport(twist, arm));

  // C15: a ball that enters at speed v, damping included.
  Material damped = plain_material();
  damped.damping = 5;
  const double d = 0.5 * kR, v = 0.05;
  Simulation still = pressed(SphereHead{kR}, d, RayHandle{0}, damped);
  const double spring = hold(still, ball_at(d)).force.z();
  const double moving = hold(still, ball_at(d), {Vec3(0, 0, -v), Vec3::Zero()}).force.z();
  const double expected = forms::ball_damping_force(kStiffness, damped.damping, kR, d, v);

  // C16: the force of an axial motion is that of the pressure on the head's section at the surface.
  const double depth = 0.5 * kR;
  Simulation axial = pressed(ConeHead{50 * deg, kR}, depth);
  const auto on_section = [=](double rho) { return depth * std::sin(50 * deg) - rho * std::cos(50 * deg); };
  const double section = forms::section_force(kStiffness, on_section, depth * std::tan(50 * deg));
  return {{"C15", "Hunt-Crossley damping of a ball that enters", "N", expected, moving - spring, kRim},
          {"C16", "axial force is the pressure on the section, cone", "N", section,
           hold(axial, Pose::from_translation(Vec3(0, 0, -depth))).force.z(), kRim},
          {"C19", "power at the handle is power at the head", "W", at_head, at_handle, kSinglePrecision}};
}

}  // namespace

std::vector<Experiment> static_experiments() {
  return {{"ball", ball},
          {"ball, stiffness and energy", ball_stiffness_and_energy},
          {"cone", cone},
          {"flat", flat},
          {"layers", layers},
          {"pressure identity", pressure_identity},
          {"closed path", closed_path},
          {"handle and damping", handle_and_damping}};
}

}  // namespace hapticut::validation
