// SPDX-License-Identifier: Apache-2.0
// Defects of the thesis's model. Both models compute the same case: a check "thesis" expects the defect, a check
// "cured" expects its absence in the default model.
#include <cmath>
#include <memory>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/safety/device_limits.hpp"
#include "hapticut/safety/guard.hpp"
#include "hapticut/simulation/thesis_mode.hpp"

namespace hapticut::experiments {
namespace defects {

/// The two models.
enum class Model { thesis, cured };

/// A ball at rest, or moving only for its damper, with its tip `depth` below the surface.
struct PressedBall {
  double voxel = 0.1 * mm;
  double depth = 0.5 * kR;
  double speed = 0;                              // [m/s] upwards
  double damping = 0;                            // [N s/m] per voxel in the thesis, [s/m] in the default model
  Quadrature quadrature = Quadrature::centroid;  // quadrature of the thesis's model
  double block_height = 0.8 * mm;                // below the surface

  [[nodiscard]] double force(Model model) const {
    SimulationConfig config = static_config();
    Material material = plain_material();
    if (model == Model::thesis) {
      ThesisLaw::Constants constants;
      constants.damping = damping;
      config.law = std::make_shared<ThesisLaw>(constants);
      config.quadrature = quadrature;
    } else {
      material.damping = damping;
    }
    Simulation simulation(
        build_block({Vec3(-1.2 * mm, -1.2 * mm, -block_height), Vec3(1.2 * mm, 1.2 * mm, 0)}, voxel, material),
        Tool(SphereHead{kR}), config);
    return rest_at(simulation, Pose::from_translation(Vec3(0, 0, kR - depth)), {Vec3(0, 0, speed), Vec3::Zero()})
        .force.z();
  }
};

std::vector<Check> refinement() {
  PressedBall coarse, fine;
  fine.voxel = coarse.voxel / 2;
  const auto ratio = [&](Model model) { return fine.force(model) / coarse.force(model); };
  // D1: sums over all voxels on paper, with k = 1 and lengths in radii.
  constexpr Tolerance kPrinted = {1e-3, "four printed digits"};
  const double unit = kStiffness * std::pow(0.1 * mm, 2) * kR * kR;
  return {{"D1 thesis", "force of a ball when voxels halve: four times as large", "1", 32.690 / 8.148,
           ratio(Model::thesis), kPartialVoxels},
          {"D1 thesis, l = R/10", "force over k R^2, summed on paper", "1", 8.148, coarse.force(Model::thesis) / unit,
           kPrinted},
          {"D1 thesis, l = R/20", "force over k R^2, summed on paper", "1", 32.690, fine.force(Model::thesis) / unit,
           kPrinted},
          {"D1 cured", "force of a ball when voxels halve: unchanged", "1", 1, ratio(Model::cured), kPartialVoxels}};
}

/// [1] Fraction of the force at rest that a retreating ball keeps: `Int w c/(1 + x c)` over `Int w c`, c = -n_z.
/// @param depth  [1] of the radius
/// @param x      [1] chi times its speed
double share_on_retreat(double depth, double x) {
  constexpr int kSteps = 400;
  double at_rest = 0, leaving = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double r = 1 - depth * (i + 0.5) / kSteps, least = (1 - depth) / r;
    for (int j = 0; j < kSteps; ++j) {
      const double c = 1 - (1 - least) * (j + 0.5) / kSteps, push = (1 - r) * r * r * (1 - least) * c;
      at_rest += push;
      leaving += push / (1 + x * c);
    }
  }
  return leaving / at_rest;
}

std::vector<Check> damper() {
  constexpr double kDamping = 20;  // [s/m]
  const auto damped = [](Model model, double voxel) {
    PressedBall still, moving;
    still.voxel = moving.voxel = voxel;
    moving.damping = model == Model::thesis ? 1 : 10;
    moving.speed = -0.01;
    return moving.force(model) - still.force(model);
  };
  const auto ratio = [&](Model model) { return damped(model, 0.05 * mm) / damped(model, 0.1 * mm); };
  const auto on_retreat = [](Model model, double speed) {
    PressedBall still, leaving;
    leaving.damping = model == Model::thesis ? 0.01 : kDamping;
    leaving.speed = speed;
    return leaving.force(model) / still.force(model);
  };
  PressedBall still;
  const double pull = 1 - 0.01 * 0.1 * 656 / still.force(Model::thesis);  // b V of each of the 656 voxels inside
  constexpr Tolerance kCounted = {7e-4, "half of a counted voxel"};
  std::vector<Check> checks = {
      {"D2 thesis", "damping force of a ball when voxels halve: as the number of voxels", "1", 5252.0 / 656,
       ratio(Model::thesis), kPartialVoxels},
      {"D2 thesis, l = R/10", "damping force over that of a voxel", "1", 656, damped(Model::thesis, 0.1 * mm) / 0.01,
       kCounted},
      {"D2 thesis, l = R/20", "damping force over that of a voxel", "1", 5252, damped(Model::thesis, 0.05 * mm) / 0.01,
       kCounted},
      {"D2 cured", "damping force of a ball when voxels halve: unchanged", "1", 1, ratio(Model::cured), kPartialVoxels},
      {"D2 thesis, retreat", "force over that at rest, 0.1 m/s outwards: it pulls the tool in", "1", pull,
       on_retreat(Model::thesis, 0.1), kPartialVoxels}};
  Largest pushes;
  for (const double speed : {0.01, 0.05, 0.1, 1.0})
    pushes.add(on_retreat(Model::cured, speed) / share_on_retreat(still.depth / kR, kDamping * speed) - 1,
               kPartialVoxels.share);
  checks.push_back(pushes.check("D2 cured, retreat",
                                "retreat at 0.01 ... 1 m/s: it still pushes, less at higher speed; error",
                                "1 %, cut voxels"));
  return checks;
}

// --- a flat head fed along its axis ----------------------------------------------------------------------------------

struct AxialFeed {
  double speed = 2e-3;    // [m/s]
  double dt = 1e-3;       // [s]
  double spin = 2000;     // [rad/s]
  double removed_at = 0;  // [m] depth at which the thesis's threshold removes a voxel, at 2000 rad/s
  static constexpr double kRadius = 0.5 * mm, kVoxel = 0.025 * mm;

  [[nodiscard]] SteadyState run(Model model) const {
    SimulationConfig config;
    ThesisLaw::Constants constants;
    constants.cutting_speed = 2000 * units::rad_per_s;
    constants.cutting_force = ThesisLaw::cutting_force_for(removed_at, kRadius, kVoxel);
    if (model == Model::thesis)
      config.law = std::make_shared<ThesisLaw>(constants);
    else
      config.reference_stiffness = 1e15;  // a thin engaged layer
    Simulation simulation(
        build_block({Vec3(-0.7, -0.7, -0.9) * mm, Vec3(0.7, 0.7, 0) * mm}, kVoxel, plain_material()),
        Tool(FlatHead{kRadius, 2 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
    return feed(simulation, Vec3(0.013, 0.021, 0) * mm, Vec3(0, 0, -speed), 0.6 * mm, dt);
  }
  /// [J/m^3] Power of hand and motor over the volume removed per second.
  [[nodiscard]] double energy_of_a_volume(Model model) const {
    const SteadyState steady = run(model);
    return (steady.force.z() * speed - steady.torque.z() * spin) / (kPi * kRadius * kRadius * speed);
  }
};

std::vector<Check> threshold() {
  AxialFeed slow, fast;
  slow.removed_at = fast.removed_at = 0.1 * mm;
  slow.speed = 0.5e-3;
  const auto ratio = [&](Model model) { return fast.run(model).force.z() / slow.run(model).force.z(); };
  const double k_v = 1e13 * std::pow(0.1 * mm / AxialFeed::kVoxel, 2);  // [N/m^4] stiffness of the thesis's springs
  constexpr Tolerance kLayers = {0.25, "layers met or missed"};
  return {
      {"D5 thesis", "thrust at four times the feed: unchanged", "1", 1, ratio(Model::thesis), kThickLayer},
      {"D5 thesis, depth", "thrust is that at the depth of the threshold", "N",
       forms::flat_bottom_force(k_v, AxialFeed::kRadius, slow.removed_at), slow.run(Model::thesis).force.z(), kLayers},
      {"D5 cured", "thrust at four times the feed: proportional", "1", 4, ratio(Model::cured), kThickLayer}};
}

std::vector<Check> step_size() {
  AxialFeed whole, half;
  whole.speed = half.speed =
      AxialFeed::kVoxel / 12.618 / whole.dt;  // so that the head meets layers at varying parts of a step
  half.dt = whole.dt / 2;
  const auto ratio = [&](Model model) { return whole.run(model).force.z() / half.run(model).force.z(); };
  return {{"D6 thesis", "thrust over that at half the step, all touched voxels go: the square of the step", "1", 4,
           ratio(Model::thesis), kWholeVoxels},
          {"D6 cured", "thrust over that at half the step: unchanged", "1", 1, ratio(Model::cured), kInvariant}};
}

std::vector<Check> energy() {
  AxialFeed once, twice;
  once.removed_at = twice.removed_at = 0.2 * mm;
  twice.spin = 2 * once.spin;
  const auto ratio = [&](Model model) { return twice.energy_of_a_volume(model) / once.energy_of_a_volume(model); };
  const EnergyLedger spent = once.run(Model::thesis).energy;
  const double lost = (spent.released + spent.rubbing) / (spent.hand_work + spent.motor_work);
  constexpr Tolerance kStored = {0.1, "what is stored"};
  return {{"D7 thesis, ledger", "fraction of the work that is released or rubbed; none pays for a volume", "1", 1,
           spent.cutting == 0 ? lost : 0, kStored, 0, true},
          {"D7 thesis", "energy per volume at twice the spindle speed: half, without a physical reason", "1", 0.5,
           ratio(Model::thesis), kThickLayer},
          {"D7 cured", "energy per volume at twice the spindle speed: u", "1", 1, ratio(Model::cured), kRim}};
}

// --- output ----------------------------------------------------------------------------------------------------------

constexpr int kTouched = 1000;  // [ticks] until the ball is lifted
constexpr int kReleased = 250;  // [ticks] after that

/// Limits of a loop on a Touch: 3.3 N, 437.5 N/s.
OutputLimits touch_limits() { return output_limits(capabilities(device_model("touch"))); }

/// Force on the hand when a standing ball touches a block with about 3 N and is lifted again.
struct Touch {
  double pressed = 0;  // [N] force of the model
  double rise = 0;     // [s] until the hand gets the full force
  double left = 0;     // [N] on the hand after the ball was lifted

  explicit Touch(Model model) {
    SimulationConfig config;
    if (model == Model::thesis) config = thesis_mode();
    if (model == Model::cured) {
      config.effects.limits = touch_limits();
      config.friction = DryFriction{0, 0, 1};
    }
    config.reference_stiffness = 3.67e13;
    Simulation simulation(
        build_block({Vec3(-1.2, -1.2, -0.8) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm, plain_material()),
        Tool(SphereHead{kR}), config);
    const auto step_at = [&](double depth) -> const StepResult& {
      return simulation.step(Pose::from_translation(Vec3(0, 0, kR - depth)), {}, kTick);
    };
    (void)step_at(-0.1 * mm);
    for (int tick = 1; tick <= kTouched; ++tick) {
      const StepResult& result = step_at(0.5 * kR);
      pressed = result.model.force.z();
      if (rise == 0 && tick > 1 && result.force.z() >= (1 - 1e-9) * pressed) rise = tick * kTick;
    }
    for (int tick = 0; tick < kReleased; ++tick) left = step_at(-0.1 * mm).force.z();
  }
};

std::vector<Check> filter() {
  const Touch thesis(Model::thesis), cured(Model::cured);
  const DeltaFilter constants;
  const double growth = touch_limits().force_growth;
  const Tolerance of_tick = {kTick * growth / cured.pressed, "a tick"};
  return {{"D8 thesis", "force on the hand 0.25 s after a release of 3 N: not zero", "N",
           thesis.pressed - kReleased * constants.epsilon, thesis.left, kInvariant},
          {"D8 cured", "force on the hand 0.25 s after a release of 3 N: none", "N", 0, cured.left, kDoublePrecision,
           cured.pressed},
          {"D8 thesis, rise", "time until the hand gets a force of 3 N", "s",
           (thesis.pressed - constants.delta) / constants.epsilon * kTick, thesis.rise, kPartialVoxels},
          {"D8 cured, rise", "time until the hand gets 3 N with the limits of a Touch, 437.5 N/s; within a tick", "s",
           cured.pressed / growth, cured.rise, of_tick}};
}

// --- static ----------------------------------------------------------------------------------------------------------

/// The surface lies in the middle of a layer of voxels. The thesis counts cut voxels as whole, so the surface appears
/// half a voxel higher.
std::vector<Check> binary_voxels() {
  constexpr double kLayers = 24;  // layers of voxels below the surface: half a radius or more
  std::vector<Check> checks;
  for (const int parts : {25, 50}) {
    PressedBall ball;
    ball.voxel = kR / parts;
    ball.depth = 0.2 * kR;
    ball.block_height = (kLayers + 0.5) * ball.voxel;
    ball.quadrature = Quadrature::voxel_center;
    const double k_v = kStiffness * std::pow(1e-4 / ball.voxel, 2);  // [N/m^4] stiffness of the thesis's springs
    const std::string of = ", l = R/" + std::to_string(parts);
    checks.push_back({"D11 thesis" + of, "ball, d = 0.2 R, over the force of C1: half a voxel too deep", "1",
                      forms::cap_force(1, kR, ball.depth + ball.voxel / 2) / forms::cap_force(1, kR, ball.depth),
                      ball.force(Model::thesis) / forms::cap_force(k_v, kR, ball.depth), kRim});
    checks.push_back({"D11 cured" + of, "ball, d = 0.2 R, over the force of C1", "1", 1,
                      ball.force(Model::cured) / forms::cap_force(kStiffness, kR, ball.depth), kPartialVoxels});
  }
  return checks;
}

std::vector<Check> pop_through() {
  const auto pushed = [](Model model) {
    SimulationConfig config = static_config();
    config.max_sweep = 64;
    config.deep_contact = model == Model::cured;
    if (model == Model::thesis) config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
    Simulation simulation(
        build_block({Vec3(-1.2, -1.2, -2.2) * mm, Vec3(1.2, 1.2, 0) * mm}, 0.1 * mm, plain_material()),
        Tool(SphereHead{kR}), config);
    double at_radius = 0, least = 1e9, last = 0;
    for (int step = 0; step <= 160; ++step) {
      const double height = kR - 0.01 * kR * step;
      last = rest_at(simulation, Pose::from_translation(Vec3(0.013 * mm, 0.021 * mm, height))).force.z();
      if (step == 100) at_radius = last;
      if (step >= 100) least = std::min(least, last);
    }
    return std::pair(last / at_radius, least / at_radius);
  };
  return {{"D15 thesis", "ball pushed to 1.6 R, force over that at R: it falls, by C1", "1",
           forms::cap_force(1, kR, 1.6 * kR) / forms::cap_force(1, kR, kR), pushed(Model::thesis).first, kRim},
          {"D15 cured", "smallest force from R to 1.6 R over that at R", "1", 1, pushed(Model::cured).second,
           kPartialVoxels}};
}

}  // namespace defects

std::vector<Experiment> defect_experiments() {
  using namespace defects;
  // Proves: defects of the thesis's model.
  return {{"defect D1", refinement}, {"defect D2", damper}, {"defect D5", threshold},      {"defect D6", step_size},
          {"defect D7", energy},     {"defect D8", filter}, {"defect D11", binary_voxels}, {"defect D15", pop_through}};
}

}  // namespace hapticut::experiments
