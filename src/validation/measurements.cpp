// SPDX-License-Identifier: Apache-2.0
#include "validation/measurements.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "hapticut/workpiece/material_presets.hpp"
#include "validation/bench.hpp"
#include "validation/checks.hpp"

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

/// The library with constants from one drilling test, on that test again.
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
    config.reference_stiffness = 2 * c.specific_cutting_energy * test.feed_speed /
                                 (c.cutting_ratio * test.spindle_speed * test.radius * layer * layer);
    Simulation simulation(
        build_block({Vec3(-1.61, -1.57, -1.713) * mm, Vec3(1.61, 1.57, 0) * mm}, 0.05 * mm, material),
        Tool(FlatHead{test.radius, 4 * mm, FlatRule::bottom_only}, RayHandle{}, Spindle{test.spindle_speed}), config);
    const Steady steady =
        feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -test.feed_speed), 1.5 * mm, 0.5, 2e-4);
    const std::string id = published.id, of = std::string(published.material) + ", 2.5 mm drill, 1000 rpm: measured ";
    checks.push_back({id.substr(0, 3), of + "thrust", "N", test.thrust, steady.force.z(), 0.03});
    checks.push_back({id.substr(5), of + "torque", "N m", test.torque, -steady.torque.z(), 0.03});
  }
  return checks;
}

void add_drilling(std::ostream& page) {
  page << "## Drilling of bone (B1)\n"
          "\n"
          "Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6: 2.5 mm twist drill, 1000 rpm. Each material has "
          "one test, so\n"
          "p_e = 0, kappa = 2 M/(R F) and u = 2 M/(R^2 a). The feed per turn a is not in the source's table: u is "
          "given for\n"
          "a = 0.1 mm and is inversely proportional to a. `hapticut validate` drills with these constants and gets the "
          "measured\n"
          "thrust and torque back (B1a ... B1f in [validation.md](validation.md)).\n"
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
  const double u = DiamondBur::energy(), preset = presets::enamel().specific_cutting_energy;
  page << "## Enamel (DC4)\n"
          "\n"
          "Fais et al. 2010, Braz J Oral Sci 9:39: 0.1117 g of enamel in 12 min under 50 ... 80 g with a diamond bur. "
          "At 65 g with\n"
          "a bur of 1.2 mm at 300000 rpm and kappa = 0.5 (assumed) its side spends "
       << digits(DiamondBur::power(DiamondBur::kLoad)) << " W on " << digits(DiamondBur::kRemoval / 1e-9)
       << " mm^3/s:\n"
          "\n"
          "    u = kappa F omega R / (dV/dt) = "
       << digits(u)
       << " J/m^3\n"
          "\n"
          "So for a diamond bur set\n"
          "\n"
          "```toml\n"
          "[material.enamel]\n"
          "specific_cutting_energy_J_per_m3 = "
       << digits(u)
       << "\n"
          "```\n"
          "\n"
          "The preset of "
       << digits(preset) << " J/m^3 is that of a carbide burr with chips of micrometres, " << digits(u / preset, 2)
       << " times less: u belongs to\n"
          "tool and material. What load the bur of DC4 needs on its side, with either:\n"
          "\n"
          "| removal [mm^3/s] | load with u of DC4 [N] | load with the preset [N] |\n"
          "|---|---|---|\n";
  for (const double removal : {0.01, 0.0526, 0.1, 0.2, 0.5, 1.0})
    page << "| " << digits(removal) << " | " << digits(DiamondBur::load(removal * 1e-9, u)) << " | "
         << digits(DiamondBur::load(removal * 1e-9, preset)) << " |\n";
  page << "\n"
          "Dentists press with 0.43 ... 1.79 N (DC3), at most 1.03 N was measured in enamel (DC2a): with u of DC4 a "
          "bur then\n"
          "removes "
       << digits(DiamondBur::power(0.43) / u / 1e-9, 2) << " ... " << digits(DiamondBur::power(1.79) / u / 1e-9, 2)
       << " mm^3/s. With the preset the same loads remove " << digits(DiamondBur::power(0.43) / preset / 1e-9, 2)
       << " ... " << digits(DiamondBur::power(1.79) / preset / 1e-9, 2)
       << " mm^3/s less what the\n"
          "edge pressure takes: a bur that cuts chips, not one that grinds.\n"
          "\n";
}

}  // namespace

std::vector<Experiment> measurement_experiments() { return {{"drillings of bone", drillings}}; }

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
          "`MeasuredTrends.DC8ForceRisesWithTheChipAndTheEnergyOfAVolumeFalls` |\n";
  return page.str();
}

}  // namespace hapticut::validation
