// SPDX-License-Identifier: Apache-2.0
// Figures 7.1-7.3 of the thesis, C33: a head steps into a cube, and each step removes all engaged material; with the
// thesis's model and with the default model.
#include <cmath>
#include <memory>
#include <vector>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/force/laws/thesis.hpp"

namespace hapticut::experiments {
namespace figures {

struct Stepping {
  std::vector<double> volume, force, torque;  // per step
};

constexpr double kHead = 0.3 * mm;  // R and H: 0.3 in the units of the thesis's scene
constexpr double kStep = 0.02 * mm, kVoxel = 0.01 * mm;
constexpr int kSteps = 14;
constexpr double kRelative = 0.4;  // [1] stiffness

const FlatHead kFlat{kHead, kHead, FlatRule::bottom_only};
const ConeHead kCone{45 * deg, kHead};
const SphereHead kBall{kHead};

Simulation cube(const ToolHead& head, const SimulationConfig& config, double spin) {
  Material material = plain_material();
  material.relative_stiffness = kRelative;
  return Simulation(build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, kVoxel, material),
                    Tool(head, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
}

/// Thesis mode: the tool jumps by a step and rests for a tick; all touched voxels are removed.
Stepping step_down(const ToolHead& head) {
  SimulationConfig config;
  config.max_sweep = 1;
  config.reference_stiffness = 1e13;
  ThesisLaw::Constants constants;
  constants.required_power = 0;
  config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation = cube(head, config, 1000);
  Stepping stepping;
  for (int i = 0; i <= kSteps; ++i) {
    const StepResult& result =
        hold(simulation, Pose::from_translation(Vec3(0, 0, -head.bounding_box().min.z() - kStep * i)));
    if (i == 0) continue;
    stepping.volume.push_back(result.removed_volume);
    stepping.force.push_back(result.force.z());
    stepping.torque.push_back(-result.torque.z());
  }
  return stepping;
}

/// Default model: the tool is fed by a step in 20 ms with a thin engaged layer; means over the step.
Stepping feed_down(const ToolHead& head) {
  SimulationConfig config;
  config.reference_stiffness = 1e17;  // a layer of 2 um, a tenth of a step
  Simulation simulation = cube(head, config, 20000);
  Stepping stepping;
  for (int i = 0; i < kSteps; ++i) {
    double volume = 0, force = 0, torque = 0;
    for (int tick = 1; tick <= 20; ++tick) {
      const double depth = kStep * (i + tick / 20.0), z = -head.bounding_box().min.z() - depth;
      const StepResult& result = simulation.step(Pose::from_translation(Vec3(0.0013 * mm, 0.0021 * mm, z)),
                                                 {Vec3(0, 0, -kStep / 0.02), Vec3::Zero()}, kTick);
      volume += result.removed_volume;
      force += result.force.z() / 20;
      torque -= result.torque.z() / 20;
    }
    stepping.volume.push_back(volume);
    stepping.force.push_back(force);
    stepping.torque.push_back(torque);
  }
  return stepping;
}

/// Number of steps whose value does not exceed `share` [1] of the value of the step before.
int falls(const std::vector<double>& values, double share = 1) {
  int count = 0;
  for (std::size_t i = 1; i < values.size(); ++i) count += values[i] > share * values[i - 1] ? 0 : 1;
  return count;
}

constexpr double kWhole = 0.02, kSlope = 0.1, kRound = 0.05;  // [1]
constexpr const char* kVoxels = "whole voxels: 2 %, slopes 10 %, balls 5 %";

std::vector<Check> of_the_thesis() {
  const Stepping flat = step_down(kFlat), cone = step_down(kCone), ball = step_down(kBall);
  Largest volume, constant, cone_volume, ball_volume;
  double total_cone = 0, total_ball = 0;
  for (std::size_t i = 0; i < flat.volume.size(); ++i) {
    const double d = kStep * double(i + 1);
    volume.add(flat.volume[i] / forms::step_volume_of_a_flat_head(kHead, kStep) - 1, kWhole);
    constant.add(flat.force[i] / flat.force[0] - 1, 1e-3);
    constant.add(flat.torque[i] / flat.torque[0] - 1, 1e-3);
    total_cone += cone.volume[i], total_ball += ball.volume[i];
    if (i < 3) continue;
    cone_volume.add(total_cone / forms::step_volume_of_a_cone(45 * deg, d, d) - 1, i + 1 < 14 ? kSlope : 0.05);
    ball_volume.add(total_ball / forms::step_volume_of_a_ball(kHead, d, d) - 1, kRound);
  }
  // At voxel size l the thesis's springs are those of k_v = k / l0^2 times (l0/l)^2.
  const double k_v = kRelative * 1e13 * std::pow(0.1 * mm / kVoxel, 2);
  const int falling = falls(cone.volume) + falls(cone.force) + falls(cone.torque) + falls(ball.volume, 0.98);
  return {
      volume.check("C33 flat volume", "thesis 7.1: volume per step of the flat head, error", kVoxels),
      constant.check("C33 flat is constant", "flat head: force and torque over those of the first step",
                     "0.1 %, constant"),
      {"C33 flat force", "flat head: force per step", "N", forms::step_force_of_a_flat_head(k_v, kHead, kStep),
       flat.force[5], kRim},
      cone_volume.check("C33 cone volume", "7.2: volume of the cone until each step, error", kVoxels),
      // The layer is two voxels thick, so the sum over whole voxels is off by a few percent.
      {"C33 cone force", "cone: force of the thirteenth step", "N",
       forms::step_force_of_a_cone(k_v, 45 * deg, 12.5 * kStep, kStep), cone.force[12], kWholeVoxels},
      ball_volume.check("C33 sphere volume", "7.3: volume of the sphere until each step, error", kVoxels),
      {"C33 sphere force", "sphere: force of the seventh step", "N",
       forms::step_force_of_a_ball(k_v, kHead, 6.5 * kStep, kStep), ball.force[6], kWholeVoxels},
      error_of("C33 rise", "steps in which the cone's volume, force and torque, or the sphere's volume, do not rise",
               falling, {0, "none"})};
}

/// The volume of a step is that of the thesis, and its force is that of the steady cut in the middle of the step: C20
/// for the flat head, C29 for the cone, C28 for the ball. The first step builds up the engaged layer, which lags on
/// slopes.
std::vector<Check> of_the_default() {
  const forms::SteadyCut cut{3e8, 0.5, 20000, kStep / 0.02};
  const Stepping flat = feed_down(kFlat), cone = feed_down(kCone), ball = feed_down(kBall);
  const double steady = forms::axial_cutting_force_of_a_flat_head(cut, kHead);
  const double couple = -forms::axial_cutting_torque_of_a_flat_head(cut, kHead);
  Largest volume, thrust, torque, cones, balls;
  for (std::size_t i = 1; i < flat.force.size(); ++i) {
    volume.add(flat.volume[i] / forms::step_volume_of_a_flat_head(kHead, kStep) - 1, kWhole);
    thrust.add(flat.force[i] / steady - 1, 0.05);
    torque.add(flat.torque[i] / couple - 1, kWhole);
    if (i < 5) continue;
    const double d = kStep * double(i + 1), middle = d - kStep / 2;
    cones.add(cone.volume[i] / forms::step_volume_of_a_cone(45 * deg, d, kStep) - 1, i < 13 ? kSlope : 0.05);
    cones.add(cone.force[i] / forms::cone_plunge_wrench(cut, 45 * deg, middle).force.z() - 1, kSlope);
    balls.add(ball.volume[i] / forms::step_volume_of_a_ball(kHead, d, kStep) - 1, kRound);
    balls.add(ball.force[i] / forms::ball_plunge_wrench(cut, kHead, middle).force.z() - 1, kRound);
  }
  const int falling =
      falls(cone.volume) + falls(cone.force) + falls(cone.torque) + falls(ball.force) + falls(ball.torque);
  return {volume.check("C33 energy flat", "default model: volume of the flat head, error", kVoxels),
          thrust.check("C33 energy thrust", "default model: force of the flat head against C20, error",
                       "5 %, layer of R/20"),
          torque.check("C33 energy torque", "default model: torque of the flat head against C20, error", kVoxels),
          {"C33 energy flat is constant", "volume of the last step over the second", "1", 1,
           flat.volume[13] / flat.volume[1], kInvariant},
          cones.check("C33 energy cone", "volume of the cone and force against C29, error", kVoxels),
          balls.check("C33 energy sphere", "volume of the sphere and force against C28, error", kVoxels),
          error_of("C33 energy rise", "steps in which cone or sphere do not rise", falling, {0, "none"})};
}

}  // namespace figures

std::vector<Experiment> figure_experiments() {
  return {// Proves: figures 7.1-7.3; law of the thesis.
          {"figures of the thesis", figures::of_the_thesis},
          // Proves: figures 7.1-7.3.
          {"figures by the default model", figures::of_the_default}};
}

}  // namespace hapticut::experiments
