// SPDX-License-Identifier: Apache-2.0
#include "experiments/measurements.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "experiments/page.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

using units::N_mm;
using units::rpm;

constexpr double kThickestChip = 0.2;  // [mm] twice that of the tests

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
    : simulation_(
          build_block({Vec3(0, -0.15, -0.5) * mm, Vec3(0.8, 0.15, 0.5) * mm}, 0.0125 * mm, material),
          Tool(FlatHead{kRadius, 3 * mm, FlatRule::side_only}, RayHandle{0}, Spindle{kSpeed * units::rad_per_s}),
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

closed_forms::SteadyCut carbide_cut(const Material& m) {
  const Cutter cutter = Cutter{CutterKind::carbide_bur};
  return {m.specific_cutting_energy,
          m.cutting_ratio,
          CarbideBur::kSpeed,
          1,
          m.edge_pressure,
          tooth_rate(cutter, CarbideBur::kSpeed),
          m.edge_length,
          m.size_length};
}

}  // namespace

double CarbideBur::rate_of(double load, const Material& material) {
  return closed_forms::feed_with_chips_under(load, carbide_cut(material), kRadius);
}

/// As a hand would find it: the speed adapts until the cut pushes back as much as the hand does.
double CarbideBur::rate_under(double load, const Material& material) {
  constexpr double kDt = 1e-3;                    // [s]
  const double inertia = 0.1 * load / kInEnamel;  // [N s/m] settles in a few tenths of a second
  constexpr int kSteps = 1500, kFrom = 500;
  Simulation simulation(build_block({Vec3(-0.6, -0.6, -1.2) * mm, Vec3(0.6, 0.6, 0) * mm}, 0.04 * mm, material),
                        Tool(FlatHead{kRadius, 2 * mm, FlatRule::bottom_only}, RayHandle{0},
                             Spindle{kSpeed * units::rad_per_s}, Cutter{CutterKind::carbide_bur}),
                        {});
  double z = 0, speed = 0, begin = 0;
  for (int n = 0; n < kSteps; ++n) {
    z -= speed * kDt;
    if (n == kFrom) begin = z;
    const Pose pose = Pose::from_translation({0.0093 * mm, 0.0113 * mm, z});
    const double force = simulation.step(pose, {{0, 0, -speed}, Vec3::Zero()}, kDt).force.z();
    speed = std::max(0.0, speed + (load - force) / inertia * kDt);
  }
  return (begin - z) / (kDt * (kSteps - 1 - kFrom));
}

namespace {

/// The preset for a diamond bur under the load of DC4, and those for a carbide bur under the load of White's.
std::vector<Check> tooth() {
  const Material diamond = presets::enamel(CutterKind::fine_diamond);
  const auto plate = [&] { return DiamondBur::Plate(diamond, 0.025 * mm); };
  const double load = plate().load_at(DiamondBur::kRemoval);
  // A load that the edges carry cuts nothing.
  Material carbide = diamond;
  carbide.specific_cutting_energy = 1.75e9;
  carbide.edge_pressure = 200e3;
  const double edges = carbide.edge_pressure * DiamondBur::Plate::kArea;
  constexpr Tolerance kScatter = {CarbideBur::kScatter, "scatter of the source"};
  return {{"DC4 energy",
           "u of enamel under a fine diamond, the preset's",
           "J/m^3",
           DiamondBur::energy(),
           diamond.specific_cutting_energy,
           {5e-3, "three digits of the preset"}},
          {"DC4 removal", "enamel and a fine diamond under 65 g: what Fais et al. removed", "m^3/s",
           DiamondBur::kRemoval, plate().removal_under(DiamondBur::kLoad), kThickLayer},
          {"DC4 half", "under half the load: half of it", "m^3/s", DiamondBur::kRemoval / 2,
           plate().removal_under(DiamondBur::kLoad / 2), kThickLayer},
          {"DC4 load", "the load that their removal needs", "N", DiamondBur::kLoad, load, kThickLayer},
          {"DC3 load",
           "it is within 0.43 ... 1.79 N, what dentists press with",
           "N",
           1.11,
           load,
           {0.61, "range of the source"}},
          {"DC4 below",
           "a carbide bur under four fifths of what its edges bear: removal",
           "m^3/s",
           0,
           DiamondBur::Plate(carbide, 0.015 * mm).removal_under(0.8 * edges),
           {0.01, "what settles"},
           DiamondBur::kRemoval},
          {"DC9 enamel", "carbide bur pushed with 0.98 N: White's axial rate", "m/s", CarbideBur::kInEnamel,
           CarbideBur::rate_under(CarbideBur::kLoad, presets::enamel()), kScatter},
          {"DC9 dentin", "the same into dentin", "m/s", CarbideBur::kInDentin,
           CarbideBur::rate_under(CarbideBur::kLoad, presets::dentin()), kScatter}};
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
          "Without an edge force both are proportional to the chip, feed over speed. Below some 25 um per turn "
          "measured forces\n"
          "fall less than that, because the edge rubs; one test cannot tell: give `hapticut calibrate` two that differ "
          "in feed.\n"
          "Below 10 um and above 100 um per turn other mechanisms take over (B13: shear below 50 um, fracture above "
          "100 um).\n"
          "\n";
}

/// Predicted from the tests at 1000 rpm, at the same feed speed.
void add_other_speed(std::ostream& page) {
  page << "### A prediction: 1500 rpm\n"
          "\n"
          "The same source drilled at 1500 rpm too; that the feed speed was the same is an assumption. With the "
          "constants of "
          "1000 rpm:\n"
          "\n"
          "| material | thrust [N]: measured, predicted, error | torque [N·mm]: measured, predicted, error |\n"
          "|---|---|---|\n";
  struct Row {
    double thrust, torque;  // [N], [N·mm]
  };
  constexpr std::array<Row, 3> kAt1500 = {{{12.34, 24.2}, {8.14, 21.6}, {3.86, 6.7}}};
  const auto compared = [](double measured, double predicted) {
    return digits(measured) + ", " + digits(predicted) + ", " + digits(100 * (predicted / measured - 1), 2) + " %";
  };
  for (std::size_t n = 0; n < kAt1500.size(); ++n) {
    const PublishedDrilling& p = kPublishedDrillings[n];
    const DrillingTest test = p.test();
    const AxialCutForce f = axial_cut_force(p.constants(), test.radius, 1.5 * test.spindle_speed, test.feed_speed);
    page << "| " << p.material << " | " << compared(kAt1500[n].thrust, f.thrust) << " | "
         << compared(kAt1500[n].torque, f.torque / N_mm) << " |\n";
  }
  page << "\n"
          "Torque falls more than in proportion to the chip here, so that an edge force (h_e > 0) would predict it "
          "worse; "
          "in one tooth\n"
          "of a saw at 2 ... 10 um (James et al. 2012, 2013) the tangential force did not change with the chip at all, "
          "and "
          "the normal\n"
          "force rose by 30 %: h_e = 17 ... 25 um, while the size effect alone would have it rise by 124 %.\n"
          "\n";
}

void add_tooth(std::ostream& page) {
  page << "## Tooth (DC4, DC9)\n"
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
          "That is the preset of enamel for a fine diamond; at loads far from 0.6 N it is extrapolated. "
          "`hapticut validate` presses it\n"
          "into a plate of enamel (DC4 in [validation.md](validation.md)).\n"
          "\n"
          "White 1998, Proc SPIE 3248 (10.1117/12.306013): a carbide bur at high speed, axially, "
       << digits(CarbideBur::kInEnamel / mm) << " +- 0.047 mm/s in enamel and\n"
       << digits(CarbideBur::kInDentin / mm)
       << " in dentin; the load is not given. The presets for blades were fitted to that at 0.98 N, 250000 rpm and six "
          "blades of\n"
          "a bur of 0.84 mm, and `hapticut validate` pushes such a bur (DC9). Axial rates [mm/s] of the model under "
          "other loads:\n"
          "\n"
          "| load [N] | enamel | dentin | dentin over enamel |\n"
          "|---|---|---|---|\n";
  for (const double load : {0.5, CarbideBur::kLoad, 1.5, 2.0}) {
    const double enamel = CarbideBur::rate_of(load, presets::enamel()),
                 dentin = CarbideBur::rate_of(load, presets::dentin());
    page << "| " << digits(load) << " | " << digits(enamel / mm) << " | " << digits(dentin / mm) << " | "
         << digits(dentin / enamel, 2) << " |\n";
  }
  page << "\n"
          "The rate grows with the square of the load where chips are thin, by the size effect; nobody whom we found "
          "has "
          "measured it.\n"
          "At low speed White's bur took 0 mm/s of enamel and 0.042 of dentin: the law has no threshold there.\n"
          "\n";
}

}  // namespace

std::vector<Experiment> measurement_experiments() { return {{"drillings of bone", drillings}, {"tooth", tooth}}; }

std::string measurements_page() {
  std::ostringstream page;
  page << "<!-- SPDX-License-Identifier: Apache-2.0 -->\n"
          "# Published measurements\n"
          "\n"
          "Constants calibrated on what others measured, and what the model predicts with them elsewhere. Written by\n"
          "`hapticut validate --measurements docs/measurements.md`.\n"
          "\n";
  add_drilling(page);
  add_other_speed(page);
  add_tooth(page);
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
          "| DC8 | Song, Peng, Lin, Yin 2013, J Manuf Sci Eng 135:011014 |\n"
          "| DC9 | White 1998, Proc SPIE 3248, doi 10.1117/12.306013 |\n"
          "| | James, Pearlman, Saigal 2012, J Biomech Eng 134:071001; 2013, Med Eng Phys 35:1638 |\n";
  return page.str();
}

}  // namespace hapticut::experiments
