// SPDX-License-Identifier: Apache-2.0
// The alternative force laws and the figures of the thesis: Table 5.1, C31 by its own law, C33.
#include <cmath>
#include <memory>

#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/tolerances.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"

namespace hapticut::validation {
namespace {

using units::deg;
using units::mm;

constexpr double kCoarse = 0.05;  // [1] where whole voxels at a face count or do not

double pressed(const std::shared_ptr<const ForceLaw>& law, const ToolHead& head, double depth) {
  SimulationConfig config = static_config();
  config.law = law;
  Simulation simulation(half_space(head.largest_radius(), depth, 0.04 * mm), Tool(head), config);
  return hold(simulation, Pose::from_translation(Vec3(0, 0, -depth - head.bounding_box().min.z()))).force.z();
}

std::vector<Check> contact_mechanics() {
  const double E = 3e6, d = 0.4 * mm, C = 2e6;
  const auto law = std::make_shared<ContactMechanicsLaw>(E);
  constexpr double kVolume = 0.03;  // [1] a volume on voxels of a tenth of the depth, to the power 1.5 or 2
  return {{"Table 5.1 flat", "2 R E* d", "N", forms::flat_punch_force(E, kR, d), pressed(law, FlatHead{kR, 2 * mm}, d),
           kCoarse},
          {"Table 5.1 sphere", "4/3 E* sqrt(R) d^1.5", "N", forms::ball_punch_force(E, kR, d),
           pressed(law, SphereHead{kR}, d), kVolume},
          {"Table 5.1 cone", "2/pi E* tan(alpha) d^2", "N", forms::cone_punch_force(E, 50 * deg, d),
           pressed(law, ConeHead{50 * deg, 2 * mm}, d), kVolume},
          {"Hertzian burr", "C1 R^2 (h/R)^1.5", "N", forms::hertzian_burr_force(C, kR, d),
           pressed(std::make_shared<HertzianBurrLaw>(C), SphereHead{kR}, d), kVolume}};
}

std::vector<Check> drill_and_damping() {
  const double speed = 2e-3, spin = 2000, u = 3e8, mu = 0.4;
  SimulationConfig config;
  config.law = std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{u});
  const double half_angle = 59 * deg;
  const ConeHead point{half_angle, kR / std::tan(half_angle)};
  Simulation drill(build_block({Vec3(-1.3, -1.3, -2.7) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.05 * mm, plain_material()),
                   Tool(point, RayHandle{0}, Spindle{spin * units::rad_per_s}), config);
  const SteadyState s = feed(drill, Vec3(0.029, 0.011, 0) * mm, Vec3(0, 0, -speed), 2.2 * mm, kTick, 0.8);
  const Wrench expected = forms::twist_drill_wrench({u, 1, spin, speed}, 2 * kR, 2 * half_angle);

  SimulationConfig damping = static_config();
  damping.longest_sweep = 64;
  damping.law = std::make_shared<DampingMatrixLaw>(DampingMatrixLaw::Constants{2e8, mu});
  Simulation block(half_space(2 * mm, 0.4 * mm, 0.1 * mm),
                   Tool(SphereHead{kR}, RayHandle{0}, Spindle{500 * units::rad_per_s}), damping);
  Pose pose = Pose::from_translation(Vec3(0, 0, 0.7 * mm));
  (void)block.step(pose, {}, 1e-3);
  pose.translation.x() += 5e-6;
  const StepResult& result = block.step(pose, {}, 1e-3);
  return {{"twist drill thrust", "its own law, point angle 118 deg", "N", expected.force.z(), s.force.z(), kThickLayer},
          {"twist drill torque", "K_s a D^2/8", "N m", expected.torque.z(), s.torque.z(), kWholeVoxels},
          {"damping matrix", "m V along the motion", "N", -2e8 * result.contact.volume / result.contact.depth * 5e-3,
           result.force.x(), kInvariant},
          {"damping matrix across", "mu of it across", "1", mu, result.force.y() / result.force.x(), kSinglePrecision}};
}

/// Thesis mode: the head jumps to a depth, rests for a tick, and whatever it touches goes.
struct Stepping {
  std::vector<double> volume, force;
};
Stepping step_down(const ToolHead& head) {
  SimulationConfig config;
  config.longest_sweep = 1;
  ThesisLaw::Constants constants;
  constants.required_power = 0;
  config.law = std::make_shared<ThesisLaw>(constants);
  Simulation simulation(
      build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, 0.01 * mm, plain_material()),
      Tool(head, RayHandle{0}, Spindle{1000 * units::rad_per_s}), config);
  Stepping stepping;
  for (int i = 0; i <= 14; ++i) {
    const StepResult& result =
        hold(simulation, Pose::from_translation(Vec3(0, 0, -head.bounding_box().min.z() - 0.02 * mm * i)));
    if (i == 0) continue;
    stepping.volume.push_back(result.removed_volume);
    stepping.force.push_back(result.force.z());
  }
  return stepping;
}

/// Energy mode: the head is fed the same steps in 20 ms each, with an engaged layer of 2 um.
std::vector<double> feed_down(const ToolHead& head) {
  SimulationConfig config;
  config.reference_stiffness = 4e16;
  Simulation simulation(
      build_block({Vec3(-0.36, -0.36, -0.4) * mm, Vec3(0.36, 0.36, 0) * mm}, 0.01 * mm, plain_material()),
      Tool(head, RayHandle{0}, Spindle{20000 * units::rad_per_s}), config);
  std::vector<double> volume(14);
  for (int tick = 1; tick <= 20 * 14; ++tick) {
    const double z = -head.bounding_box().min.z() - 0.001 * mm * tick;
    volume[std::size_t((tick - 1) / 20)] +=
        simulation.step(Pose::from_translation(Vec3(0.0013 * mm, 0.0021 * mm, z)), {}, 1e-3).removed_volume;
  }
  return volume;
}

std::vector<Check> figures_of_the_thesis() {
  const double R = 0.3 * mm, D = 0.02 * mm;
  const Stepping flat = step_down(FlatHead{R, R, FlatRule::bottom_only}), cone = step_down(ConeHead{45 * deg, R}),
                 ball = step_down(SphereHead{R});
  const auto total = [](const Stepping& s) {
    double sum = 0;
    for (const double v : s.volume) sum += v;
    return sum;
  };
  const std::vector<double> fed_flat = feed_down(FlatHead{R, R, FlatRule::bottom_only}),
                            fed_cone = feed_down(ConeHead{45 * deg, R}), fed_ball = feed_down(SphereHead{R});
  const double d = 14 * D, k_v = 1e13 * std::pow(0.1 / 0.01, 2);  // springs of the thesis at its voxels
  return {
      {"C33 flat volume", "thesis 7.1: volume per step of the flat head", "m^3",
       forms::step_volume_of_a_flat_head(R, D), flat.volume[7], kRim},
      {"C33 flat force", "its force per step", "N", forms::step_force_of_a_flat_head(k_v, R, D), flat.force[7], kRim},
      {"C33 flat is constant", "force of the last step over the first", "1", 1, flat.force[13] / flat.force[0],
       kInvariant},
      {"C33 cone volume", "all steps of the cone", "m^3", forms::step_volume_of_a_cone(45 * deg, d, d), total(cone),
       kCoarse},
      {"C33 cone force", "its thirteenth step", "N", forms::step_force_of_a_cone(k_v, 45 * deg, 12.5 * D, D),
       cone.force[12], kWholeVoxels},
      {"C33 sphere force", "its seventh step", "N", forms::step_force_of_a_ball(k_v, R, 6.5 * D, D), ball.force[6],
       kWholeVoxels},
      {"C33 sphere volume", "all steps of the sphere", "m^3", forms::step_volume_of_a_ball(R, d, d), total(ball),
       kCoarse},
      {"C33 energy flat", "the same by the default model: volume of the flat head's seventh step", "m^3",
       forms::step_volume_of_a_flat_head(R, D), fed_flat[6], kRim},
      {"C33 energy flat is constant", "volume of the last step over the second", "1", 1, fed_flat[13] / fed_flat[1],
       kInvariant},
      {"C33 energy cone", "volume of the cone's last step", "m^3", forms::step_volume_of_a_cone(45 * deg, d, D),
       fed_cone[13], kCoarse},
      {"C33 energy sphere", "volume of the sphere's seventh step", "m^3", forms::step_volume_of_a_ball(R, 7 * D, D),
       fed_ball[6], kCoarse}};
}

}  // namespace

std::vector<Experiment> law_experiments() {
  return {{"contact mechanics", contact_mechanics},
          {"twist drill and damping matrix", drill_and_damping},
          {"figures of the thesis", figures_of_the_thesis}};
}

}  // namespace hapticut::validation
