// SPDX-License-Identifier: Apache-2.0
#include "experiments/measurements.hpp"

#include <string>

#include "experiments/steady_cuts.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

constexpr double kSluggish = 0.1;  // [1] inertia of a hand over load/speed; settles in a few tenths of a second

/// Runs a drilling test with constants fitted to this test: a round trip, not a prediction.
std::vector<Check> drillings() {
  std::vector<Check> checks;
  for (const PublishedDrilling& published : kPublishedDrillings) {
    const DrillingTest test = published.test();
    const Calibration c = published.constants();
    Material material = plain_material();
    material.specific_cutting_energy = c.specific_cutting_energy;
    material.cutting_ratio = c.cutting_ratio;
    SimulationConfig config;
    const double layer = 0.08 * mm;
    config.reference_stiffness = forms::stiffness_for_layer(
        {c.specific_cutting_energy, c.cutting_ratio, test.spindle_speed, test.feed_speed}, layer, test.radius);
    Simulation simulation(
        build_block({Vec3(-1.61, -1.57, -1.713) * mm, Vec3(1.61, 1.57, 0) * mm}, 0.05 * mm, material),
        Tool(FlatHead{test.radius, 4 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{test.spindle_speed}), config);
    const SteadyState steady =
        feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -test.feed_speed), 1.5 * mm, 2e-4);
    const std::string id = published.id,
                      of = std::string(published.material) + ", 2.5 mm drill, 1000 rpm; round trip of the measured ";
    checks.push_back({id.substr(0, 3), of + "thrust", "N", test.thrust, steady.force.z(), kThinLayer});
    checks.push_back({id.substr(5), of + "torque", "N m", test.torque, -steady.torque.z(), kThinLayer});
  }
  return checks;
}

/// A plate of enamel, 0.3 mm thick, whose edge is cut by the side of the bur over 1 mm.
class Plate {
 public:
  static constexpr double kArea = 0.3 * 1e-6;  ///< [m^2] area of contact

  /// @param layer  [m] engaged layer at the removal rate of DC4
  Plate(const Material& material, double layer)
      : simulation_(build_block({Vec3(0, -0.15, -0.5) * mm, Vec3(0.8, 0.15, 0.5) * mm}, 0.0125 * mm, material),
                    Tool(FlatHead{DiamondBur::kRadius, 3 * mm, FlatRule::side_only}, RayHandle{0},
                         Spindle{DiamondBur::kSpeed * units::rad_per_s}),
                    with_layer(material, layer)) {}

  /// [N] Force against the feed.
  [[nodiscard]] double load_at(double removal) {
    const double speed = removal / kArea;
    double load = 0;
    const int steps = int(0.3 * mm / (speed * kTick)), from = steps * 3 / 4;
    for (int i = 0; i < steps; ++i) {
      const double force = feed_to(speed * kTick * (i + 1));
      if (i >= from) load += force / (steps - from);
    }
    return load;
  }
  /// [m^3/s] Removal rate under a constant load of the hand.
  [[nodiscard]] double removal_under(double load) {
    const Hand hand = {load, kSluggish * load * kArea / DiamondBur::kRemoval, 3000, 1500};
    return hand.mean_speed([this](double depth, double /*speed*/) { return feed_to(depth); }) * kArea;
  }

 private:
  static SimulationConfig with_layer(const Material& material, double layer) {
    SimulationConfig config;
    config.reference_stiffness = forms::stiffness_for_layer(
        {material.specific_cutting_energy, material.cutting_ratio, DiamondBur::kSpeed, DiamondBur::kRemoval / kArea},
        layer, DiamondBur::kRadius);
    return config;
  }
  double feed_to(double depth) {
    const Vec3 place(depth - DiamondBur::kRadius, 0.003 * mm, -1.5 * mm);
    return -simulation_.step(Pose::from_translation(place), {}, kTick).force.x();
  }

  Simulation simulation_;
};

/// [m/s] Speed of a carbide bur pushed along its axis.
double carbide_rate(const Material& material) {
  Simulation simulation(build_block({Vec3(-0.6, -0.6, -1.2) * mm, Vec3(0.6, 0.6, 0) * mm}, 0.04 * mm, material),
                        Tool(FlatHead{CarbideBur::kRadius, 2 * mm, FlatRule::bottom_only}, RayHandle{0},
                             Spindle{CarbideBur::kSpeed * units::rad_per_s}, Cutter{CutterKind::carbide_bur}),
                        {});
  const Hand hand = {CarbideBur::kLoad, kSluggish * CarbideBur::kLoad / CarbideBur::kInEnamel, 1500, 501};
  return hand.mean_speed([&](double depth, double speed) {
    const Pose pose = Pose::from_translation({0.0093 * mm, 0.0113 * mm, -depth});
    return simulation.step(pose, {{0, 0, -speed}, Vec3::Zero()}, kTick).force.z();
  });
}

/// A diamond bur with the energy of DC4 under its load, and the presets of a carbide bur under White's load.
std::vector<Check> tooth() {
  Material diamond = presets::enamel(CutterKind::fine_diamond);
  diamond.specific_cutting_energy = DiamondBur::energy();  // of this source alone, where the preset serves several
  const auto plate = [&] { return Plate(diamond, 0.025 * mm); };
  const double load = plate().load_at(DiamondBur::kRemoval);
  // A load below the threshold of the edges cuts nothing.
  Material carbide = diamond;
  carbide.specific_cutting_energy = 1.75e9;
  carbide.edge_pressure = 200e3;
  const double edges = carbide.edge_pressure * Plate::kArea;
  constexpr Tolerance kScatter = {CarbideBur::kScatter, "scatter of the source"}, kTenth = {0.1, "a tenth"},
                      kRange = {0.61, "range of the source"}, kSettled = {0.01, "what settles"};
  return {{"DC4 removal", "enamel under a fine diamond with 65 g: removal rate of Fais et al.", "m^3/s",
           DiamondBur::kRemoval, plate().removal_under(DiamondBur::kLoad), kThickLayer},
          {"DC4 half", "enamel under a fine diamond with half the load: half the rate", "m^3/s",
           DiamondBur::kRemoval / 2, plate().removal_under(DiamondBur::kLoad / 2), kThickLayer},
          {"DC4 load", "load needed for the removal rate of Fais et al.", "N", DiamondBur::kLoad, load, kThickLayer},
          {"DC3 load", "this load is within 0.43 ... 1.79 N, the range of dentists", "N", 1.11, load, kRange},
          {"DC4 below", "carbide bur under four fifths of the threshold of its edges: removal rate", "m^3/s", 0,
           Plate(carbide, 0.015 * mm).removal_under(0.8 * edges), kSettled, DiamondBur::kRemoval},
          {"DC9 enamel", "carbide bur pushed with 0.98 N: White's axial rate", "m/s", CarbideBur::kInEnamel,
           carbide_rate(presets::enamel()), kScatter},
          {"DC9 dentin", "carbide bur pushed with 0.98 N into dentin: White's axial rate", "m/s", CarbideBur::kInDentin,
           carbide_rate(presets::dentin()), kTenth}};
}

}  // namespace

std::vector<Experiment> measurement_experiments() { return {{"drillings of bone", drillings}, {"tooth", tooth}}; }

}  // namespace hapticut::experiments
