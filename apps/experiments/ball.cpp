// SPDX-License-Identifier: Apache-2.0
// A ball pressed into a half space, with the spindle standing: C1-C3, C14 and C15.
#include <algorithm>
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"

namespace hapticut::experiments {
namespace pressed_ball {

constexpr double kCoarsest = 0.1 * mm;  // voxel size, then 0.05 and 0.025 mm
constexpr double kFinest = kCoarsest / 4;

Simulation ball(double depth, double voxel_size, const Vec3& phase, const Handle& handle = RayHandle{0},
                const MaterialTable& materials = materials_of_stiffness({1})) {
  return Simulation(box_at_phase(half_space(kR, depth, voxel_size), voxel_size, phase, materials),
                    Tool(SphereHead{kR}, handle), static_config());
}

Vec3 center_at(double depth) { return {0, 0, kR - depth}; }

/// [1] Error of the force over (l/d)^2: root mean square over the fills f of the voxels that the surface z = 0 cuts.
///
/// A full voxel has the spring of its centre instead of its mean. A cut voxel has the direction of its centre instead
/// of its filled part, and this part is assumed to lie beyond a plane across n. Together the error is k_v l^2 (pi/12)
/// d^2 (1 - 6 f (1 - f)), with mean zero; 6 f (1 - f) deviates from 1 by sqrt(0.2). When the ball's centre is below z =
/// 0, the material lies on the near side of the plane: the error is k_v l^2 f (1 - f) times the integral of |n_z| over
/// the surface, 2 pi (d - R) (2 R - d), on average a sixth of it.
double error_of_cap(double d) {
  const double error = d <= kR ? std::sqrt(0.2) * kPi / 12 * d * d : kPi / 3 * (d - kR) * (2 * kR - d);
  return error * d * d / forms::cap_force(1, kR, d);
}

constexpr std::array kDepths = {0.2 * kR, 0.5 * kR, 1.0 * kR, 1.4 * kR};

std::vector<Check> force() {
  Refined error("C1", "ball in a half space at 0.2, 0.5, 1 and 1.4 R, force vector", kSecondOrder,
                "1.2 of the error by the fills of cut voxels");
  Largest off;
  for (const double depth : kDepths) {
    const double expected = forms::cap_force(kStiffness, kR, depth), constant = error_of_cap(depth);
    const Convergence c = converge(kCoarsest, [&](double l, const Vec3& phase) {
      Simulation simulation = ball(depth, l, phase);
      return (rest_ok_at(simulation, center_at(depth)).force - Vec3(0, 0, expected)).norm() / expected;
    });
    error.add(c, second_order(1.2 * constant, depth));
    off.add(c.error[2] / (constant * std::pow(c.size[2] / depth, 2)) - 1, 0.3);
  }
  return joined({error.checks(),
                 {off.check("C1 fills", "error relative to the prediction by the fills", "30 % of twelve phases")}});
}

/// [1] Root mean square error of the force over shifts of the grid. @param n  normal of the surface in the grid's axes
double error_on(const Vec3& normal, double voxel) {
  const double depth = 0.4 * kR;
  double square = 0;
  constexpr int kShifts = 6;
  for (int n = 0; n < kShifts; ++n) {
    const Vec3 surface = voxel * Vec3(0.11, 0.37, 0.13) * n;  // a point of the surface
    const BodyDescription body = {{Vec3::Constant(-1.8 * mm), Vec3::Constant(1.8 * mm)},
                                  [&](const Vec3& p) { return normal.dot(p - surface); },
                                  [](const Vec3&) { return MaterialId(1); }};
    Simulation simulation(build_body(body, voxel, MaterialTable({plain_material()})), Tool(SphereHead{kR}),
                          static_config());
    const double force = rest_ok_at(simulation, Vec3(surface + normal * (kR - depth))).force.dot(normal);
    square += std::pow(force / forms::cap_force(kStiffness, kR, depth) - 1, 2) / kShifts;
  }
  return std::sqrt(square);
}

/// Two errors of second order, of the curvature and of the assumed far side, cancel when directions mix.
std::vector<Check> askew() {
  const Vec3 tilted = Vec3(0.3, 0.2, 1).normalized();
  const double coarse = error_on(tilted, 0.2 * mm), fine = error_on(tilted, 0.1 * mm),
               coarse_along = error_on(Vec3::UnitZ(), 0.2 * mm), fine_along = error_on(Vec3::UnitZ(), 0.1 * mm);
  return {error_of("C1 askew", "ball at 0.4 R in a surface askew to voxels of 0.2 mm, error", coarse,
                   {0.006, "errors that cancel"}),
          order_of("C1 askew", 3, std::log2(coarse / fine), {0.7 / 3, "of six shifts"}),
          error_of("C1 along", "ball at 0.4 R in a surface along the grid, error", coarse_along,
                   {0.019, "curvature, far side"}),
          order_of("C1 along", 2, std::log2(coarse_along / fine_along), {0.1, "of six shifts"})};
}

/// Every spring points to the centre, on any grid.
std::vector<Check> torque() {
  constexpr double kRounding = 1e-6;  // [1] samples in single precision
  const Handle bent = LHandle{12 * mm, 5 * mm, 1.1};
  Largest at_center, at_hand;
  for (const double depth : kDepths)
    for (const double l : {kCoarsest, kCoarsest / 2, kCoarsest / 4}) {
      const Pose X_WT = {rotation_from_vector(Vec3(0.3, -0.8, 0.5)), center_at(depth)};
      Simulation on_handle = ball(depth, l, phase(1), bent), straight = ball(depth, l, phase(1));
      const Pose X_WH = X_WT * on_handle.tool().X_HT().inverse();
      const StepResult& felt = rest_ok_at(on_handle, X_WH);
      const double force = felt.force.norm();
      at_center.add(rest_ok_at(straight, X_WT).torque.norm(), kRounding * force * kR);
      at_hand.add((felt.torque - forms::ball_torque(X_WT.translation - X_WH.translation, felt.force)).norm(),
                  kRounding * force * 13 * mm);
    }
  return {at_center.check("C14", "ball, torque about its centre", "1e-6 F R, single precision"),
          at_hand.check("C14 hand", "torque at a bent handle, error", "1e-6 F 13 mm, single precision")};
}

/// Derivative of the force from five depths 0.1 R apart. It is exact for C1, a quartic, so only voxels cause errors.
double stiffness_at(Simulation& simulation, double depth) {
  const double h = 0.1 * kR;
  const auto force = [&](double d) { return rest_ok_at(simulation, center_at(d)).force.z(); };
  return (8 * (force(depth + h) - force(depth - h)) - (force(depth + 2 * h) - force(depth - 2 * h))) / (12 * h);
}

std::vector<Check> stiffness() {
  Refined error("C2", "ball, stiffness at 0.4 and 0.7 R", kSecondOrder, "(l/R)^2");
  for (const double depth : {0.4 * kR, 0.7 * kR}) {
    const double expected = forms::cap_stiffness(kStiffness, kR, depth);
    error.add(converge(kCoarsest,
                       [&](double l, const Vec3& phase) {
                         Simulation simulation = ball(kR, l, phase);
                         return stiffness_at(simulation, depth) / expected - 1;
                       }),
              second_order(1, kR));
  }
  Simulation simulation = ball(kR, kFinest, phase(2));
  double stiffest = 0, at = 0;
  for (int step = 0; step < 25; ++step) {
    const double depth = (0.3 + 0.02 * step) * kR;
    const double stiffness = stiffness_at(simulation, depth);
    if (stiffness > stiffest) stiffest = stiffness, at = depth;
  }
  return joined(
      {error.checks(),
       {{"C2 greatest", "largest stiffness of the ball", "N/m", forms::max_cap_stiffness(kStiffness, kR), stiffest,
         kCutVoxels},
        {"C2 place", "depth of the largest stiffness, over R", "1", 2.0 / 3, at / kR, {0.05, "a flat maximum"}, 1}}});
}

std::vector<Check> energy() {
  Refined error("C3", "ball at 0.2, 0.5 and 1 R, stored energy", kSecondOrder, "as C1, of cut voxels");
  for (const double depth : {0.2 * kR, 0.5 * kR, 1.0 * kR}) {
    const double expected = forms::cap_energy(kStiffness, kR, depth);
    // Error of the energy, similar to that of the force: k_v l^2 (pi/36) d^3 (1 - 6 f (1 - f)).
    const double constant = std::sqrt(0.2) * kStiffness * kPi / 36 * std::pow(depth, 5) / expected;
    error.add(converge(kCoarsest,
                       [&](double l, const Vec3& phase) {
                         Simulation simulation = ball(depth, l, phase);
                         return rest_ok_at(simulation, center_at(depth)).energy.elastic / expected - 1;
                       }),
              second_order(1.2 * constant, depth));
  }
  const double depth = 0.5 * kR;
  Simulation slow = ball(depth, kFinest, phase(3));
  for (int i = 0; i <= 500; ++i) (void)slow.step(Pose::from_translation(center_at(depth * i / 500)), {}, kTick);
  const EnergyLedger& spent = slow.last_result().energy;
  // The section of a voxel is at least 0.3 edges wide, so the voxel stores too much energy when the normal is near an
  // axis of the grid.
  Largest entered;
  entered.add(spent.entered, 0.01 * std::pow(kFinest / depth, 2) * spent.elastic);
  return joined({error.checks(),
                 {{"C3 work", "work of the hand down to R/2", "J", forms::cap_energy(kStiffness, kR, depth),
                   spent.hand_work, kFineVoxels},
                  {"C3 paid", "stored energy is the work of the hand and `entered`", "J",
                   spent.hand_work + spent.entered, spent.elastic, kSinglePrecision},
                  entered.check("C3 entered", "energy that entered", "(l/d)^2/100 of what is stored")}});
}

constexpr double kDamping = 20, kSpeed = 0.02;  // [s/m] chi, [m/s]

MaterialTable damped() {
  Material material;
  material.name = "damped";
  material.damping = kDamping;
  return MaterialTable({material});
}

double damping_force(double depth) { return forms::ball_damping_force(kStiffness, kDamping, kR, depth, kSpeed); }

std::vector<Check> damping() {
  Refined error("C15", "Hunt-Crossley damping of a ball that enters at 0.3 and 0.8 R", kSecondOrder, "0.3 (l/d)^2");
  for (const double depth : {0.3 * kR, 0.8 * kR})
    error.add(converge(kCoarsest,
                       [&](double l, const Vec3& phase) {
                         Simulation simulation = ball(depth, l, phase, RayHandle{0}, damped());
                         const double still = rest_ok_at(simulation, center_at(depth)).force.z();
                         const Twist down = {Vec3(0, 0, -kSpeed), Vec3::Zero()};
                         const double moving = rest_ok_at(simulation, center_at(depth), down).force.z();
                         return (moving - still) / damping_force(depth) - 1;
                       }),
              second_order(0.3, depth));
  const double dt = 1e-4, depth = 0.8 * kR;
  Simulation descent = ball(depth, kFinest, phase(4), RayHandle{0}, damped());
  double loss = 0;  // [J]
  Largest off;
  for (int i = 1; kSpeed * dt * i <= depth; ++i) {
    const Pose pose = Pose::from_translation(center_at(kSpeed * dt * i));
    const double force = descent.step(pose, {Vec3(0, 0, -kSpeed), Vec3::Zero()}, dt).force.z();
    const double middle = kSpeed * dt * (i - 0.5);
    loss += damping_force(middle) * kSpeed * dt;
    if (middle < 0.3 * kR) continue;
    off.add(force / (forms::cap_force(kStiffness, kR, middle) + damping_force(middle)) - 1, 0.004);
  }
  const EnergyLedger& spent = descent.last_result().energy;
  return joined({error.checks(),
                 {off.check("C15 descent", "force along a descent from 0.3 to 0.8 R, error", "0.5 (l/d)^2 at 0.3 R"),
                  {"C15 work", "work of the damper in the ledger", "J", loss, spent.damping, kFineVoxels},
                  error_of("C15 ledger", "energy balance of the descent, over the turnover", test::unbooked(spent),
                           kSinglePrecision)}});
}

}  // namespace pressed_ball

std::vector<Experiment> ball_experiments() {
  return {// Proves: normal force.
          {"ball", pressed_ball::force},
          {"ball, askew", pressed_ball::askew},
          // Proves: torque.
          {"ball, torque", pressed_ball::torque},
          {"ball, stiffness", pressed_ball::stiffness},
          {"ball, energy", pressed_ball::energy},
          // Proves: damping.
          {"ball, damping", pressed_ball::damping}};
}

}  // namespace hapticut::experiments
