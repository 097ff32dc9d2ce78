// SPDX-License-Identifier: Apache-2.0
#include "bench/validation/measurements.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/tolerances.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::validation {
namespace {

using units::mm;
using units::N_mm;
using units::rpm;

constexpr double kThickestChip = 0.2;  // [mm] twice that of the tests

std::string digits(double value, int count = 3) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

/// The library with constants from one drilling test, on that test again: a round trip, no prediction.
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
        Tool(FlatHead{test.radius, 4 * mm, FlatRule::bottom_only}, RayHandle{}, Spindle{test.spindle_speed}), config);
    const SteadyState steady =
        feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -test.feed_speed), 1.5 * mm, 2e-4);
    const std::string id = published.id,
                      of = std::string(published.material) + ", 2.5 mm drill, 1000 rpm; round trip of the measured ";
    checks.push_back({id.substr(0, 3), of + "thrust", "N", test.thrust, steady.force.z(), kThinLayer});
    checks.push_back({id.substr(5), of + "torque", "N m", test.torque, -steady.torque.z(), kThinLayer});
  }
  return checks;
}

SimulationConfig with_layer(const Material& material, double layer) {
  SimulationConfig config;
  const double speed = DiamondBur::kRemoval / DiamondBur::Plate::kArea;
  config.reference_stiffness =
      forms::stiffness_for_layer({material.specific_cutting_energy, material.cutting_ratio, DiamondBur::kSpeed, speed},
                                 layer, DiamondBur::kRadius);
  return config;
}

}  // namespace

DiamondBur::Plate::Plate(const Material& material, double layer)
    : simulation_(build_block({Vec3(0, -0.15, -0.5) * mm, Vec3(0.8, 0.15, 0.5) * mm}, 0.0125 * mm, material),
                  Tool(FlatHead{kRadius, 3 * mm, FlatRule::side_only}, RayHandle{}, Spindle{kSpeed}),
                  with_layer(material, layer)) {}

const StepResult& DiamondBur::Plate::feed_to(double depth) {
  return simulation_.step(Pose::from_translation(Vec3(depth - kRadius, 0.003 * mm, -1.5 * mm)), {}, kTick);
}

double DiamondBur::Plate::load_at(double removal) {
  const double speed = removal / kArea;
  double load = 0;
  const int steps = int(0.3 * mm / (speed * kTick)), from = steps * 3 / 4;
  for (int i = 0; i < steps; ++i) {
    const double force = -feed_to(speed * kTick * (i + 1)).force.x();
    if (i >= from) load += force / (steps - from);
  }
  return load;
}

/// As a hand would find it: the speed adapts until the cut pushes back as much as the hand does.
double DiamondBur::Plate::removal_under(double load) {
  const double inertia = 0.1 * load * kArea / kRemoval;  // [N s/m] settles in a few tenths of a second
  constexpr int kSteps = 3000, kCounted = kSteps / 2;
  double depth = 0, speed = 0, mean = 0;
  for (int i = 0; i < kSteps && depth < 0.7 * mm; ++i) {
    depth += speed * kTick;
    speed = std::max(0.0, speed + (load + feed_to(depth).force.x()) / inertia * kTick);
    if (i >= kSteps - kCounted) mean += speed / kCounted;
  }
  return mean * kArea;
}

namespace {

/// The preset for a diamond bur under the load of DC4, and that for a carbide burr at the same removal.
std::vector<Check> enamel() {
  const Material diamond = presets::enamel_with_diamond(), carbide = presets::enamel();
  DiamondBur::Plate under_load(diamond, 0.025 * mm), chipping(carbide, 0.015 * mm);
  return {{"DC4 removal", "enamel_with_diamond under 65 g: what Fais et al. removed", "m^3/s", DiamondBur::kRemoval,
           under_load.removal_under(DiamondBur::kLoad), kThickLayer},
          {"DC4 carbide", "enamel, the same removal: load of chips and edges", "N",
           DiamondBur::load(DiamondBur::kRemoval, carbide.specific_cutting_energy, carbide.edge_pressure,
                            DiamondBur::Plate::kArea),
           chipping.load_at(DiamondBur::kRemoval), kThickLayer}};
}

void add_drilling(std::ostream& page) {
  page << "## Drilling of bone (B1)\n"
          "\n"
          "Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6: 2.5 mm twist drill, 1000 rpm. Each material has "
          "one test, so\n"
          "p_e = 0, kappa = 2 M/(R F) and u = 2 M/(R^2 a). The feed per turn a is not in the source's table: u is "
          "given for\n"
          "a = 0.1 mm and is inversely proportional to a. `hapticut validate` drills with these constants (B1a ... B1f "
          "in\n"
          "[validation.md](validation.md)). Its thrust and torque are those that the constants were fitted to: that "
          "is a round trip\n"
          "through the formula of C22 and the voxels, and no prediction. A prediction is in the next table.\n"
          "\n"
          "| rows | material | thrust [N] | torque [N·mm] | kappa [1] | u [J/m^3] |\n"
          "|---|---|---|---|---|---|\n";
  for (const PublishedDrilling& p : kPublishedDrillings) {
    const Calibration c = p.constants();
    page << "| " << p.id << " | " << p.material << " | " << digits(p.thrust, 4) << " | " << digits(p.torque / N_mm)
         << " | " << digits(c.cutting_ratio) << " | " << digits(c.specific_cutting_energy) << " |\n";
  }
  page << "\n"
          "Predictions, thrust [N] and torque [N·mm], for the other speeds and feeds of the collected measurements: "
          "spindles of 500 rpm\n"
          "(drills) to 55000 rpm (B15), feeds of 20 (B15) and 100 mm/min, and those that give a chip of 0.01, 0.05 and "
          "0.1 mm per turn\n"
          "(B13). Nobody measured these here: they are what the model says, to be tried, and they scale with the "
          "assumed 0.1 mm.\n"
          "\n"
          "| spindle [rpm] | feed [mm/min] | chip [um per turn] |";
  for (const PublishedDrilling& p : kPublishedDrillings) page << " " << p.material << " |";
  page << "\n"
          "|---|---|---|---|---|---|\n";
  for (const double speed : {500.0, 1000.0, 2000.0, 10000.0, 55000.0}) {
    std::array<double, 5> feeds = {20, 100, 0.01 * speed, 0.05 * speed, 0.1 * speed};  // [mm/min]
    std::sort(feeds.begin(), feeds.end());
    double before = 0;
    for (const double feed_speed : feeds) {
      const double chip = feed_speed / speed;  // [mm]
      if (feed_speed == before || chip > kThickestChip) continue;
      before = feed_speed;
      page << "| " << digits(speed, 5) << " | " << digits(feed_speed, 4) << " | " << digits(1000 * chip) << " |";
      for (const PublishedDrilling& p : kPublishedDrillings) {
        const AxialCutForce f =
            axial_cut_force(p.constants(), PublishedDrilling::kRadius, speed * rpm, feed_speed / 60 * mm);
        page << " " << digits(f.thrust) << ", " << digits(f.torque / N_mm) << " |";
      }
      page << "\n";
    }
  }
  page << "\n"
          "Without an edge pressure both are proportional to the chip, feed over speed. Below some 25 um per turn "
          "measured forces\n"
          "fall less than that, because the edge rubs; one test cannot tell: give `hapticut calibrate` two that differ "
          "in feed.\n"
          "Below 10 um and above 100 um per turn other mechanisms take over (B13: shear below 50 um, fracture above "
          "100 um).\n"
          "\n";
}

void add_enamel(std::ostream& page) {
  const Material diamond = presets::enamel_with_diamond(), carbide = presets::enamel();
  const auto load = [](double removal, const Material& m) {
    return DiamondBur::load(removal, m.specific_cutting_energy, m.edge_pressure, DiamondBur::kContactArea);
  };
  const auto removed = [](double newtons, const Material& m) {
    return DiamondBur::removal(newtons, m.specific_cutting_energy, m.edge_pressure, DiamondBur::kContactArea) / 1e-9;
  };
  page << "## Enamel (DC4)\n"
          "\n"
          "Fais et al. 2010, Braz J Oral Sci 9:39: 0.1117 g of enamel in 12 min under 50 ... 80 g with a diamond bur. "
          "At 65 g with\n"
          "a bur of 1.2 mm at 300000 rpm and kappa = 0.5 (assumed) its side spends "
       << digits(DiamondBur::power(DiamondBur::kLoad)) << " W on " << digits(DiamondBur::kRemoval / 1e-9)
       << " mm^3/s:\n"
          "\n"
          "    u = kappa F omega R / (dV/dt) = "
       << digits(DiamondBur::energy())
       << " J/m^3\n"
          "\n"
          "That is the preset `enamel_with_diamond`. One measurement cannot tell edge from chip, so its edge pressure "
          "is 0, and\n"
          "loads far from 0.6 N are extrapolated. The preset `enamel`, "
       << digits(carbide.specific_cutting_energy) << " J/m^3 and " << digits(carbide.edge_pressure / 1e6)
       << " MPa, is that of a carbide burr\n"
          "with chips of micrometres, "
       << digits(diamond.specific_cutting_energy / carbide.specific_cutting_energy, 2)
       << " times less: u belongs to tool and material. `hapticut validate` presses both into\n"
          "a plate of enamel (DC4 in [validation.md](validation.md)).\n"
          "\n"
          "What a dentist's hand feels on the side of that bur, p_e A + u (dV/dt)/(kappa omega R), with "
       << digits(DiamondBur::kContactArea / 1e-6)
       << " mm^2 of it in\n"
          "contact (assumed; only the edge pressure needs it):\n"
          "\n"
          "| removal [mm^3/s] | enamel_with_diamond [N] | enamel [N] | of it edges [N] |\n"
          "|---|---|---|---|\n";
  for (const double removal : {0.01, 0.0526, 0.1, 0.2, 0.5, 1.0})
    page << "| " << digits(removal) << " | " << digits(load(removal * 1e-9, diamond)) << " | "
         << digits(load(removal * 1e-9, carbide)) << " | " << digits(carbide.edge_pressure * DiamondBur::kContactArea)
         << " |\n";
  page << "\n"
          "Dentists press with 0.43 ... 1.79 N (DC3), at most 1.03 N was measured in enamel (DC2a): a diamond bur then "
          "removes\n"
       << digits(removed(0.43, diamond), 2) << " ... " << digits(removed(1.79, diamond), 2)
       << " mm^3/s, a carbide burr " << digits(removed(0.43, carbide), 2) << " ... "
       << digits(removed(1.79, carbide), 2)
       << " mm^3/s.\n"
          "\n";
}

}  // namespace

std::vector<Experiment> measurement_experiments() { return {{"drillings of bone", drillings}, {"enamel", enamel}}; }

std::string measurements_page() {
  std::ostringstream page;
  page << "<!-- SPDX-License-Identifier: Apache-2.0 -->\n"
          "# Published measurements\n"
          "\n"
          "Constants calibrated on what others measured, and what the model predicts with them elsewhere. Written by\n"
          "`hapticut validate --measurements docs/measurements.md`.\n"
          "\n";
  add_drilling(page);
  add_enamel(page);
  page << "## Trends\n"
          "\n"
          "| rows | trend | test |\n"
          "|---|---|---|\n"
          "| B8 | thrust and torque rise with feed and diameter | "
          "`MeasuredTrends.B8ThrustAndTorqueRiseWithFeedAndDiameter` |\n"
          "| B15 | the force of a burr falls with speed, rises with feed and depth | "
          "`MeasuredTrends.B15TheForceOfABurrFallsWithSpeedAndRisesWithFeedAndDepth` |\n"
          "| DC8 | force rises with removal rate and chip, specific energy falls | "
          "`MeasuredTrends.DC8ForceRisesWithTheChipAndTheEnergyOfAVolumeFalls` |\n"
          "\n"
          "## Sources\n"
          "\n"
          "| rows | source |\n"
          "|---|---|\n"
          "| B1a ... B1f | Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6 |\n"
          "| B8 | Sui and Sugita 2018, Ann Biomed Eng, doi 10.1007/s10439-018-02196-8 |\n"
          "| B13 | Luo et al. 2022, Chin J Mech Eng |\n"
          "| B15 | Babbar 2020: a burr on skull bone, best at 55000 rpm, 20 mm/min, 0.5 mm deep |\n"
          "| DC2a | Liao, Taira et al. 1995, J Oral Rehabil 22:67 |\n"
          "| DC3 | Siegel and von Fraunhofer, on the load of dental handpieces |\n"
          "| DC4 | Fais et al. 2010, Braz J Oral Sci 9:39 |\n"
          "| DC8 | Song, Peng, Lin, Yin 2013, J Manuf Sci Eng 135:011014 |\n";
  return page.str();
}

}  // namespace hapticut::validation
