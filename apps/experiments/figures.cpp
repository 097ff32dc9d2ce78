// SPDX-License-Identifier: Apache-2.0
// Figures 7.1-7.3 of the thesis, C33: a head steps into a cube, and each step removes all engaged material; with the
// thesis's model and with the default model.
#include <cmath>
#include <memory>
#include <vector>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/simulation/thesis_mode.hpp"

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
const FlatHead kFlatWithSides{kHead, kHead};
const ConeHead kCone{45 * deg, kHead};
const SphereHead kBall{kHead};

constexpr AngularSpeed kTurbine = 300'000 * units::rpm;

Simulation cube(const ToolHead& head, const SimulationConfig& config, AngularSpeed spin) {
  Material material = plain_material();
  material.relative_stiffness = kRelative;
  return Simulation(build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, kVoxel, material),
                    Tool(head, RayHandle{0}, Spindle{spin}), config);
}

/// Thesis mode as it is: the tool moves by a step in a tick.
Stepping step_down(const ToolHead& head) {
  Simulation simulation = cube(head, thesis_mode(), kTurbine);
  Stepping stepping;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3 at(0.0013 * mm, 0.0021 * mm, -head.bounding_box().min.z() - kStep * i);
    const StepResult& result = simulation.step(Pose::from_translation(at), {}, kTick);
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
  Simulation simulation = cube(head, config, 20000 * units::rad_per_s);
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

constexpr double kOfACone = 0.03, kOfABall = 0.01;  // [1] tolerances in thesis mode
constexpr const char* kWholeVoxelsGo = "whole voxels: flat 2 %, cone 3 %, ball 1 %";
constexpr double kWhole = 0.02, kSlope = 0.1, kRound = 0.05;  // [1]
constexpr const char* kVoxels = "whole voxels: 2 %, slopes 10 %, balls 5 %";

/// Material stays that is shallower than the removal depth w, so cone and ball cut like ones that are smaller by w.
std::vector<Check> of_the_thesis() {
  const Stepping flat = step_down(kFlat), cone = step_down(kCone), ball = step_down(kBall);
  const Stepping sided = step_down(kFlatWithSides);
  const double w = ThesisLaw(ThesisLaw::Constants{}).removal_depth(kTurbine, kHead, kVoxel);
  const double moved = kVoxel / 2;  // motion in each of the parts into which the library divides a step
  Largest volume, constant, cone_volume, ball_volume;
  double total_cone = 0, total_ball = 0;
  for (std::size_t i = 0; i < flat.volume.size(); ++i) {
    const double d = kStep * double(i + 1) - moved / 2;  // the last part is evaluated in its middle
    volume.add(flat.volume[i] / forms::step_volume_of_a_flat_head(kHead, kStep) - 1, kWhole);
    constant.add(flat.force[i] / flat.force[0] - 1, 1e-3);
    constant.add(sided.force[i] / sided.force[0] - 1, 1e-3);
    constant.add(flat.torque[i] / flat.torque[0] - 1, 1e-3);
    total_cone += cone.volume[i], total_ball += ball.volume[i];
    if (i < 3) continue;
    const double cone_depth = d - w / std::sin(45 * deg), ball_depth = d - w;
    cone_volume.add(total_cone / forms::step_volume_of_a_cone(45 * deg, cone_depth, cone_depth) - 1, kOfACone);
    ball_volume.add(total_ball / forms::step_volume_of_a_ball(kHead - w, ball_depth, ball_depth) - 1, kOfABall);
  }
  // At voxel size l the thesis's springs are those of k_v = k / l0^2 times (l0/l)^2.
  const double k_v = kRelative * kStiffnessOfPoints * std::pow(0.1 * mm / kVoxel, 2);
  const int falling = falls(cone.volume) + falls(cone.force) + falls(cone.torque) + falls(ball.volume, 0.98);
  return {
      volume.check("C33 flat volume", "thesis 7.1: volume per step of the flat head, error", kWholeVoxelsGo),
      constant.check("C33 flat is constant", "flat head: force and torque over those of the first step",
                     "0.1 %, constant"),
      // A layer of voxels meets the head in every second part of a step, a quarter of a voxel deep, and goes.
      {"C33 flat force", "flat head: force per step", "N", forms::step_force_of_a_flat_head(k_v, kHead, moved),
       flat.force[5], kRim},
      cone_volume.check("C33 cone volume", "7.2: volume of the cone until each step, error", kWholeVoxelsGo),
      // The layer is half a voxel thick, so the sum over whole voxels is off by a few percent.
      {"C33 cone force", "cone: force of the thirteenth step", "N",
       forms::step_force_of_a_cone(k_v, 45 * deg, 12.5 * kStep, moved, w), cone.force[12], kWholeVoxels},
      ball_volume.check("C33 sphere volume", "7.3: volume of the sphere until each step, error", kWholeVoxelsGo),
      {"C33 sphere force", "sphere: force of the seventh step", "N",
       forms::step_force_of_a_ball(k_v, kHead, 6.5 * kStep, moved, w), ball.force[6], kWholeVoxels},
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
