// SPDX-License-Identifier: Apache-2.0
// Closed forms of every standing head whose depth vanishes on its surface: C13, C16 and C19.
#include <algorithm>
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/tool/catalogue.hpp"

namespace hapticut::experiments {
namespace any_head {

/// A head, and its depth on the section at height z above its lowest point as a function of the distance to its axis.
struct HeadCase {
  ToolHead head;
  std::function<double(double rho, double z)> depth;

  /// Origin of the head when its lowest point is `below` the surface.
  [[nodiscard]] Vec3 origin_at(double below) const { return {0, 0, -below - head.bounding_box().min.z()}; }
};

/// Ball, cone, flat head, and a round end made from a profile.
const std::vector<HeadCase>& heads() {
  static const std::vector<HeadCase> all = [] {
    const double R = 0.9 * mm, r = 0.8 * mm, a = 35 * deg;
    return std::vector<HeadCase>{
        {SphereHead{R}, [=](double rho, double z) { return R - std::hypot(rho, z - R); }},
        {ConeHead{a, 1.3 * mm}, [=](double rho, double z) { return z * std::sin(a) - rho * std::cos(a); }},
        {FlatHead{r, 1.4 * mm}, [=](double rho, double z) { return std::min(z, r - rho); }},
        {round_end_cylinder_head(2 * r, 1.4 * mm),
         [=](double rho, double z) { return r - std::hypot(rho, std::min(0.0, z - r)); }}};
  }();
  return all;
}

HeadCase bottom_only() {
  const double r = 0.8 * mm;
  return {FlatHead{r, 1.4 * mm, FlatRule::bottom_only}, [=](double rho, double z) { return rho < r ? z : 0.0; }};
}

std::vector<Check> section() {
  Refined smooth("C16", "ball, cone, round end at 0.3 and 0.6 mm: axial force is the pressure on the section",
                 kSecondOrder, "0.7 (l/d)^2");
  // The error of C5 and C6: lattice points in the disk, of order 1.5, and the end of the springs at z = 0.
  Refined rimmed("C16 flat", "flat head, rules nearest and bottom_only: axial force is the pressure on the section",
                 kRimOrder, "lattice points in a disk", kOfRimOrder);
  std::vector<HeadCase> cases = heads();
  cases.push_back(bottom_only());
  for (const HeadCase& c : cases)
    for (const double depth : {0.3 * mm, 0.6 * mm}) {
      const double reach = c.head.max_radius();
      const double expected = forms::section_force(
          kStiffness, [&](double rho) { return c.depth(rho, depth); }, reach);
      const Convergence errors = converge(0.08 * mm, [&](double l, const Vec3& phase) {
        Simulation simulation(box_at_phase(half_space(reach, depth, l), l, phase), Tool(c.head), static_config());
        return rest_ok_at(simulation, c.origin_at(depth)).force.z() / expected - 1;
      });
      if (std::holds_alternative<FlatHead>(c.head.shape()))
        rimmed.add(errors, [&](double l) { return 0.7 * std::pow(l / reach, 1.5) + 0.4 * std::pow(l / depth, 2); });
      else
        smooth.add(errors, second_order(0.7, depth));
    }
  return joined({smooth.checks(), rimmed.checks()});
}

SimulationConfig swept() {
  SimulationConfig config = static_config();
  config.max_sweep = 64;
  return config;
}

const StepResult& step_well(Simulation& simulation, const Pose& pose) {
  const StepResult& result = simulation.step(pose, {}, kTick);
  if (result.status != StepStatus::ok) throw Error("a step of the path has the status " + describe(result.status));
  return result;
}

/// [1] Net work over turnover on a closed path around the edge of a quarter space, with a tilt.
double work_around_an_edge(const HeadCase& c, double l, const Vec3& phase) {
  const Box quarter = {Vec3(-2.4 * mm, -2.4 * mm, -2 * mm), Vec3(0, 2.4 * mm, 0)};
  Simulation simulation(box_at_phase(quarter, l, phase), Tool(c.head, LHandle{3 * mm, 1 * mm, 0.7}), swept());
  const Pose X_TH = simulation.tool().X_HT().inverse();
  double start = 0, before = 0, total = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = 2 * kPi * i / kSteps;
    const Pose X_WT = {
        rotation_from_vector(Vec3(0.25 * std::sin(t), 0.2 * std::sin(2 * t), 0.9 * std::sin(t))),
        Vec3(-0.1 + 0.45 * std::cos(t), 0.2 * std::sin(t), 0.1 + 0.25 * std::sin(t)) * mm + c.origin_at(0.35 * mm)};
    const StepResult& result = step_well(simulation, X_WT * X_TH);
    if (i == 0) start = before = result.energy.hand_work;  // stored energy at the place where the head appeared
    total += std::abs(result.energy.hand_work - before);
    before = result.energy.hand_work;
  }
  if (!(total > 1e-7)) throw Error("the closed path of C13 does no work.");
  return (before - start - forms::kWorkOfAClosedPath) / total;
}

// The force of a voxel is not the gradient of an energy where its section turns with the normal; this error falls with
// the voxel size. The midpoint rule in time adds 4e-6, and 2e-5 where the direction of the springs jumps inside the
// material: on a cone's axis, and between wall and bottom of a flat head.
std::vector<Check> closed_path() {
  Refined work("C13", "ball, cone, flat head, round end on a closed path around an edge: net work", kSecondOrder,
               "1.2e-4 (l/0.05 mm)^2, sections that turn", {0.25, "and the midpoint rule in time"});
  for (const HeadCase& c : heads())
    work.add(converge(0.2 * mm, [&](double l, const Vec3& phase) { return work_around_an_edge(c, l, phase); }),
             second_order(1.2e-4, 0.05 * mm));
  return work.checks();
}

// C19 is true up to rounding on every grid, because it is an identity of the computed values.
constexpr std::array kGrids = {0.16 * mm, 0.08 * mm, 0.04 * mm};
constexpr double kRounding = 2e-6;  // [1] the two poses of the head agree to double precision; the samples are single
const Box kBlock = {Vec3(-3, -3, -3) * mm, Vec3(3, 3, 0) * mm};

struct Transported {
  Largest force, torque, power, elsewhere;

  void add(const HeadCase& c, const Workpiece& workpiece, int n) {
    const auto vector = [n](int k) { return Vec3(2 * phase(7 * n + k) - Vec3::Ones()); };  // vector in a cube of edge 2
    const Vec3 size = phase(7 * n);
    const Handle handle = n % 2 == 0 ? Handle(RayHandle{20 * mm * size.x()})
                                     : Handle(LHandle{20 * mm * size.x(), 10 * mm * size.y(), kPi * vector(0).z()});
    Simulation at_hand(workpiece.clone(), Tool(c.head, handle), static_config());
    Simulation at_head(workpiece.clone(), Tool(c.head), static_config());
    const HeadBox box = c.head.bounding_box();
    const Mat3 R_WT = rotation_from_vector(kPi * vector(1));
    const Pose X_WT = {R_WT, Vec3(0, 0, 0.7 * size.z() - 0.5) * mm - R_WT * Vec3(0.5 * (box.min + box.max))};
    const Pose X_WH = X_WT * at_hand.tool().X_HT().inverse();
    const StepResult felt = rest_ok_at(at_hand, X_WH), direct = rest_ok_at(at_head, X_WT);
    if (!(direct.force.norm() > 0)) throw Error("a head of C19 touches nothing.");

    const Vec3 p_HoTo_W = X_WT.translation - X_WH.translation;
    const double lever = p_HoTo_W.norm() + 1 * mm, rounding = kRounding * direct.force.norm();
    force.add((felt.force - direct.force).norm(), rounding);
    torque.add((felt.torque - transport(Wrench{direct.force, direct.torque}, p_HoTo_W).torque).norm(),
               rounding * lever);
    const Twist hand = {0.1 * vector(2), 5 * vector(3)}, head = transport(hand, p_HoTo_W);
    const double of_hand = forms::power({felt.force, felt.torque}, hand),
                 of_head = forms::power({direct.force, direct.torque}, head);
    const double scale = head.linear.norm() + hand.angular.norm() * lever;
    power.add(of_hand - of_head, rounding * scale);
    const Vec3 p_HoP_W = 20 * mm * vector(4);
    const double at_p = forms::power(transport(Wrench{felt.force, felt.torque}, -p_HoP_W), transport(hand, p_HoP_W));
    elsewhere.add(at_p - of_hand, 1e-12 * (1 + direct.force.norm() * scale));
  }
};

/// [1] Work in the ledger, booked at the head, over the work summed from force and motion of the hand.
double booked_work(const HeadCase& c, double l) {
  Simulation simulation(box_at_phase(kBlock, l, phase(5)), Tool(c.head, LHandle{8 * mm, 3 * mm, 1.2}), swept());
  const Pose X_TH = simulation.tool().X_HT().inverse();
  const auto pose = [&](double t) {
    return Pose{rotation_from_vector(Vec3(0.3 * t, -0.2 * t, 0.8 * t)),
                c.origin_at(0) + Vec3(0.2 * t, 0.1 * t, -0.5 * t) * mm} *
           X_TH;
  };
  constexpr int kSteps = 400;
  double work = 0;
  Pose before = pose(0);
  for (int i = 0; i <= kSteps; ++i) {
    const Pose now = pose(double(i) / kSteps);
    const StepResult& result = step_well(simulation, now);
    work -= forms::power({result.force, result.torque}, twist_between(before, now, kTick)) * kTick;
    before = now;
  }
  return simulation.last_result().energy.hand_work / work;
}

std::vector<Check> handles() {
  Transported felt;
  Largest booked;
  for (const HeadCase& c : heads())
    for (const double l : kGrids) {
      const Workpiece workpiece = box_at_phase(kBlock, l, phase(4));
      for (int n = 0; n < 20; ++n) felt.add(c, workpiece, n);
      booked.add(booked_work(c, l) - 1, 1e-6);
    }
  const char* reason = "2e-6, single precision";
  return {
      felt.force.check("C19 force", "4 heads, 3 grids, 20 handles and poses: force at the handle, error", reason),
      felt.torque.check("C19 torque", "torque at the handle, transported, error", reason),
      felt.power.check("C19", "power at the handle is power at the head, error", reason),
      felt.elsewhere.check("C19 elsewhere", "power at any other point, error", "1e-12, double precision"),
      booked.check("C19 ledger", "work in the ledger against that of the hand along a path", "1e-6, single precision")};
}

}  // namespace any_head

std::vector<Experiment> any_head_experiments() {
  return {// Proves: normal force.
          {"axial force of any head", any_head::section},
          {"closed path", any_head::closed_path},
          // Proves: full wrench.
          {"handles", any_head::handles}};
}

}  // namespace hapticut::experiments
