// SPDX-License-Identifier: Apache-2.0
#include "experiments/grid_cuts.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/tolerances.hpp"

namespace hapticut::experiments {
namespace {

using units::deg;
using units::mm;

constexpr double kQuick = 10 * mm;  // [m/s] on the way to the beginning of a cut

/// Steps along a line and calls `see` with the result of each step.
template <class See>
void go(Simulation& simulation, const Way& way, const Vec3& from, const Vec3& to, double speed, double tick,
        const See& see) {
  const int steps = int(std::lround((to - from).norm() / (speed * tick)));
  const Vec3 velocity = (to - from).normalized() * speed;
  for (int n = 0; n < steps; ++n) {
    const Pose pose = {way.R_VT, way.R_VT * (from + velocity * (tick * (n + 1))) + way.p_V};
    see(double(n) / steps, simulation.step(pose, {way.R_VT * velocity, Vec3::Zero()}, tick));
  }
}

/// The worst errors of all directions and stiffnesses.
struct Worst {
  double mean = 0, torque = 0, ripple = 0, closure = 0;  // [1]

  void include(const Worst& other) {
    mean = std::max(mean, other.mean);
    torque = std::max(torque, other.torque);
    ripple = std::max(ripple, other.ripple);
    closure = std::max(closure, other.closure);
  }
};

Worst errors_of(const Course& course, const Wrench& expected) {
  const double size = expected.force.norm();
  return {(course.mean - expected.force).cwiseAbs().maxCoeff() / size,
          std::abs(course.torque_z / expected.torque.z() - 1), course.ripple.maxCoeff() / size,
          std::abs(course.closure)};
}

Worst worst_of(const GridCut& cut, const std::vector<Way>& ways, double voxel, const std::vector<double>& foundations) {
  Worst worst;
  for (const Way& way : ways) {
    const Workpiece block = oriented_block(way, cut.box, voxel, cut.material());
    for (const double stiffness : foundations) {
      Simulation simulation = cut.at_begin(way, block.clone(), stiffness);
      worst.include(errors_of(follow(simulation, cut, way), cut.expected));
    }
  }
  return worst;
}

constexpr const char* kOfGrid = "measured, worst of grid";

std::vector<Check> checks_of(const std::string& id, const std::string& of, const Worst& worst, const Limits& limits) {
  return {error_of(id, of + "force off by", worst.mean, {limits.mean, kOfGrid}),
          error_of(id + " torque", of + "torque off by", worst.torque, {limits.torque, kOfGrid}),
          error_of(id + " ripple", of + "ripple", worst.ripple, {limits.ripple, kOfGrid}),
          error_of(id + " ledger", of + "closure", worst.closure, kSinglePrecision)};
}

/// Additional error of a cut on soft foundations, whose layer is not thin, over layer/R.
Check on_soft_foundations(const GridCut& cut, const Limits& limits, double voxel, double& closure) {
  double more = 0;
  for (const double stiffness : {1e14, 1e15}) {
    if (stiffness >= limits.stiff_from) continue;
    const Worst worst = worst_of(cut, ways(voxel), voxel, {stiffness});
    const double beyond = std::max(worst.mean - limits.mean, worst.torque - limits.torque);
    more = std::max(more, beyond / cut.layer(stiffness));
    closure = std::max(closure, worst.closure);
  }
  const char* which = limits.stiff_from > 1e15 ? "; k_v = 1e14, 1e15; " : "; k_v = 1e14; ";
  return error_of(cut.id + " soft", cut.what + which + "additional error to that on stiff foundations, over layer/R",
                  more, {limits.soft, "a layer that is not thin"});
}

}  // namespace

std::vector<Way> ways(double voxel) {
  const auto about = [](double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle * deg, axis).toRotationMatrix();
  };
  const Vec3 between = Vec3(0.1, 0.2, 0.3) * voxel;
  return {{Mat3::Identity(), Vec3::Zero()},
          {Mat3::Identity(), Vec3(0.37, 0.21, 0.43) * voxel},
          {about(10, Vec3::UnitY()), between},
          {about(29, Vec3::UnitZ()) * about(17, Vec3::UnitX()), between},
          {about(45, Vec3::UnitY()), between},
          {about(45, Vec3::UnitZ()), between},
          {Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(1, 1, 1)).toRotationMatrix(), between}};
}

Workpiece oriented_block(const Way& way, const Box& box_T, double voxel, const Material& material) {
  const Vec3 middle = (box_T.min + box_T.max) / 2, half = (box_T.max - box_T.min) / 2;
  const Vec3 reach = way.R_VT.cwiseAbs() * half, center = way.R_VT * middle + way.p_V;
  const auto on_grid = [&](const Vec3& p) { return Vec3((p / voxel).array().floor() * voxel); };
  const BodyDescription body = {
      {on_grid(center - reach) - Vec3::Constant(2 * voxel), on_grid(center + reach) + Vec3::Constant(3 * voxel)},
      [=](const Vec3& p) { return ((way.R_VT.transpose() * (p - way.p_V) - middle).cwiseAbs() - half).maxCoeff(); },
      [](const Vec3&) { return MaterialId(1); }};
  return build_body(body, voxel, MaterialTable({material}));
}

forms::SteadyCut slow_cut_with_chips(double edge, double size) {
  forms::SteadyCut cut = kSlowCut;
  cut.tooth_rate = tooth_rate(GridCut::kCutter, cut.spin);
  const double chip = cut.feed_speed / cut.tooth_rate;
  cut.edge_length = edge * chip;
  cut.size_length = size * chip;
  return cut;
}

Material GridCut::material() const {
  Material material = plain_material();
  material.edge_pressure = cut.edge_pressure;
  material.edge_length = cut.edge_length;
  material.size_length = cut.size_length;
  return material;
}

Simulation GridCut::at_begin(const Way& way, Workpiece block, double stiffness) const {
  SimulationConfig config;
  config.reference_stiffness = stiffness;
  Simulation simulation(std::move(block), Tool(head, RayHandle{0}, Spindle{cut.spin * units::rad_per_s}, kCutter),
                        config);
  go(simulation, way, start, begin, kQuick, kTick, [](double /*part*/, const StepResult& /*result*/) {});
  return simulation;
}

Course follow(Simulation& simulation, const GridCut& cut, const Way& way) {
  Course course;
  std::vector<Vec3> forces;
  go(simulation, way, cut.begin, cut.end, cut.cut.feed_speed, cut.tick, [&](double part, const StepResult& result) {
    if (part < 1 - cut.measured) return;
    forces.emplace_back(way.R_VT.transpose() * result.force);
    course.torque_z += (way.R_VT.transpose() * result.torque).z();
  });
  const double count = double(forces.size());
  course.torque_z /= count;
  for (const Vec3& force : forces) course.mean += force / count;
  Vec3 slope = Vec3::Zero();
  const auto place = [&](std::size_t n) { return double(n) - (count - 1) / 2; };
  for (std::size_t n = 0; n < forces.size(); ++n) slope += place(n) * forces[n] * 12 / (count * (count * count - 1));
  for (std::size_t n = 0; n < forces.size(); ++n)
    course.ripple += (forces[n] - course.mean - place(n) * slope).cwiseAbs2() / count;
  course.ripple = course.ripple.cwiseSqrt();
  course.closure = test::unbooked(simulation.last_result().energy);
  return course;
}

GridCut milled(const char* id, const char* what, const ToolHead& head, const Box& box, double height,
               const Wrench& expected) {
  return {id,  what,    head, box, Vec3(-1.5 * mm, 0, height), Vec3(0.1 * mm, 0, height), Vec3(1.1 * mm, 0, height),
          0.7, expected};
}

double GridCut::layer(double stiffness) const {
  return std::sqrt(2 * cut.chip() / (cut.cutting_ratio * kR * stiffness)) / kR;
}

std::vector<Check> in_every_direction(const GridCut& cut, const Limits& limits, double voxel) {
  const bool coarse = voxel > 0.07 * mm;
  std::vector<double> foundations = {1e16, 0, 1e17};  // 0: the default
  if (coarse && limits.stiff_from < 1e16) foundations.push_back(limits.stiff_from);
  Worst worst = worst_of(cut, ways(voxel), voxel, foundations);
  std::vector<Check> soft;
  if (coarse) soft.push_back(on_soft_foundations(cut, limits, voxel, worst.closure));
  return joined(
      {checks_of(cut.id + (coarse ? " grid 0.1 mm" : " grid 0.05 mm"), cut.what + "; ", worst, limits), soft});
}

std::vector<Check> along_the_faces(const GridCut& cut, const Limits& limits, const std::vector<double>& foundations) {
  std::vector<Way> turned;
  for (const double angle : {0.0, 29.0, 45.0})
    turned.push_back({Eigen::AngleAxisd(angle * deg, Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()});
  return checks_of(cut.id + " faces", cut.what + ", along the faces of voxels; ",
                   worst_of(cut, turned, 0.1 * mm, foundations), limits);
}

std::vector<Check> tilted(const GridCut& cut, const Limits& limits, const std::vector<double>& foundations) {
  const std::vector<Way> all = ways(0.1 * mm);
  return checks_of(cut.id + " tilted", cut.what + ", tilted in the grid; ",
                   worst_of(cut, {all[2], all[4], all[6]}, 0.1 * mm, foundations), limits);
}

std::vector<Check> in_every_direction(const GridCut& cut, const Limits& coarse, const Limits& fine) {
  return joined({in_every_direction(cut, coarse, 0.1 * mm), in_every_direction(cut, fine, 0.05 * mm)});
}

}  // namespace hapticut::experiments
