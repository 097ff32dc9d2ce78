// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <sstream>

#include "experiments/measurements.hpp"
#include "experiments/page.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

using units::N_mm;
using units::rpm;

constexpr double kThickestChip = 0.2;  // [mm] twice that of the tests

/// [m/s] of a carbide bur, by C36.
double rate_of(double load, const Material& m) {
  const forms::SteadyCut cut = {m.specific_cutting_energy,
                                m.cutting_ratio,
                                CarbideBur::kSpeed,
                                1,
                                m.edge_pressure,
                                tooth_rate(Cutter{CutterKind::carbide_bur}, CarbideBur::kSpeed),
                                m.edge_length,
                                m.size_length};
  return forms::feed_with_chips_under(load, cut, CarbideBur::kRadius);
}

void add_drilling(std::ostream& page) {
  page << R"(## Drilling of bone (B1)

Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6: 2.5 mm twist drill, 1000 rpm. Each material has one test, so
p_e = 0, kappa = 2 M/(R F) and u = 2 M/(R^2 a). The feed per turn a is not in the source's table: u is given for
a = 0.1 mm and is inversely proportional to a. `hapticut validate` drills with these constants (B1a ... B1f in
[validation.md](validation.md)). Its thrust and torque are those that the constants were fitted to: that is a round trip
through the formula of C22 and the voxels, and no prediction. A prediction is in the next table.

| rows | material | thrust [N] | torque [N·mm] | kappa [1] | u [J/m^3] |
|---|---|---|---|---|---|
)";
  for (const PublishedDrilling& p : kPublishedDrillings) {
    const Calibration c = p.constants();
    page << "| " << p.id << " | " << p.material << " | " << digits(p.thrust, 4) << " | " << digits(p.torque / N_mm)
         << " | " << digits(c.cutting_ratio) << " | " << digits(c.specific_cutting_energy) << " |\n";
  }
  page << R"(
Predictions, thrust [N] and torque [N·mm], for the other speeds and feeds of the collected measurements: spindles of 500 rpm
(drills) to 55000 rpm (B15), feeds of 20 (B15) and 100 mm/min, and those that give a chip of 0.01, 0.05 and 0.1 mm per turn
(B13). Nobody measured these here: they are what the model says, to be tried, and they scale with the assumed 0.1 mm.

| spindle [rpm] | feed [mm/min] | chip [um per turn] |)";
  for (const PublishedDrilling& p : kPublishedDrillings) page << " " << p.material << " |";
  page << R"(
|---|---|---|---|---|---|
)";
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
  page << R"(
Without an edge force both are proportional to the chip, feed over speed. Below some 25 um per turn measured forces
fall less than that, because the edge rubs; one test cannot tell: give `hapticut calibrate` two that differ in feed.
Below 10 um and above 100 um per turn other mechanisms take over (B13: shear below 50 um, fracture above 100 um).

)";
}

/// Predicted from the tests at 1000 rpm, at the same feed speed.
void add_other_speed(std::ostream& page) {
  page << R"(### A prediction: 1500 rpm

The same source drilled at 1500 rpm too; that the feed speed was the same is an assumption. With the constants of 1000 rpm:

| material | thrust [N]: measured, predicted, error | torque [N·mm]: measured, predicted, error |
|---|---|---|
)";
  struct Row {
    double thrust, torque;  // [N], [N·mm]
  };
  constexpr std::array<Row, 3> kAt1500 = {{{12.34, 24.2}, {8.14, 21.6}, {3.86, 6.7}}};
  const auto beside = [](double measured, double predicted) {
    return digits(measured) + ", " + digits(predicted) + ", " + digits(100 * (predicted / measured - 1), 2) + " %";
  };
  for (std::size_t n = 0; n < kAt1500.size(); ++n) {
    const PublishedDrilling& p = kPublishedDrillings[n];
    const DrillingTest test = p.test();
    const AxialCutForce f = axial_cut_force(p.constants(), test.radius, 1.5 * test.spindle_speed, test.feed_speed);
    page << "| " << p.material << " | " << beside(kAt1500[n].thrust, f.thrust) << " | "
         << beside(kAt1500[n].torque, f.torque / N_mm) << " |\n";
  }
  page << R"(
Torque falls more than in proportion to the chip here, so that an edge force (h_e > 0) would predict it worse; in one tooth
of a saw at 2 ... 10 um (James et al. 2012, 2013) the tangential force did not change with the chip at all, and the normal
force rose by 30 %: h_e = 17 ... 25 um, while the size effect alone would have it rise by 124 %.

)";
}

void add_tooth(std::ostream& page) {
  page
      << R"(## Tooth (DC4, DC9)

Fais et al. 2010, Braz J Oral Sci 9:39: 0.1117 g of enamel in 12 min under 50 ... 80 g with a diamond bur. At 65 g with
a bur of 1.2 mm at 300000 rpm and kappa = 0.5 (assumed) its side spends )"
      << digits(DiamondBur::power(DiamondBur::kLoad)) << " W on " << digits(DiamondBur::kRemoval / 1e-9) << R"( mm^3/s:

    u = kappa F omega R / (dV/dt) = )"
      << digits(DiamondBur::energy()) << R"( J/m^3

That is the preset of enamel for a fine diamond; at loads far from 0.6 N it is extrapolated. `hapticut validate` presses it
into a plate of enamel (DC4 in [validation.md](validation.md)).

White 1998, Proc SPIE 3248 (10.1117/12.306013): a carbide bur at high speed, axially, )"
      << digits(CarbideBur::kInEnamel / mm) << " +- 0.047 mm/s in enamel and\n"
      << digits(CarbideBur::kInDentin / mm)
      << R"( in dentin; the load is not given. The presets for blades were fitted to that at 0.98 N, 250000 rpm and six blades of
a bur of 0.84 mm, and `hapticut validate` pushes such a bur (DC9). Axial rates [mm/s] of the model under other loads:

| load [N] | enamel | dentin | dentin over enamel |
|---|---|---|---|
)";
  for (const double load : {0.5, CarbideBur::kLoad, 1.5, 2.0}) {
    const double enamel = rate_of(load, presets::enamel()), dentin = rate_of(load, presets::dentin());
    page << "| " << digits(load) << " | " << digits(enamel / mm) << " | " << digits(dentin / mm) << " | "
         << digits(dentin / enamel, 2) << " |\n";
  }
  page << R"(
The rate grows with the square of the load where chips are thin, by the size effect; nobody whom we found has measured it.
At low speed White's bur took 0 mm/s of enamel and 0.042 of dentin: the law has no threshold there.

)";
}

}  // namespace

std::string measurements_page() {
  std::ostringstream page;
  page << R"(<!-- SPDX-License-Identifier: Apache-2.0 -->
# Published measurements

Constants calibrated on what others measured, and what the model predicts with them elsewhere. Written by
`hapticut validate --measurements docs/measurements.md`.

)";
  add_drilling(page);
  add_other_speed(page);
  add_tooth(page);
  page << R"(## Trends

| rows | trend | test |
|---|---|---|
| B8 | thrust and torque rise with feed and diameter | `MeasuredTrends.B8ThrustAndTorqueRiseWithFeedAndDiameter` |
| B15 | the force of a burr falls with speed, rises with feed and depth | `MeasuredTrends.B15TheForceOfABurrFallsWithSpeedAndRisesWithFeedAndDepth` |
| DC8 | force rises with removal rate and chip, specific energy falls | `MeasuredTrends.DC8ForceRisesWithTheChipAndTheEnergyOfAVolumeFalls` |

## Sources

| rows | source |
|---|---|
| B1a ... B1f | Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6 |
| B8 | Sui and Sugita 2018, Ann Biomed Eng, doi 10.1007/s10439-018-02196-8 |
| B13 | Luo et al. 2022, Chin J Mech Eng |
| B15 | Babbar 2020: a burr on skull bone, best at 55000 rpm, 20 mm/min, 0.5 mm deep |
| DC2a | Liao, Taira et al. 1995, J Oral Rehabil 22:67 |
| DC3 | Siegel and von Fraunhofer, on the load of dental handpieces |
| DC4 | Fais et al. 2010, Braz J Oral Sci 9:39 |
| DC8 | Song, Peng, Lin, Yin 2013, J Manuf Sci Eng 135:011014 |
| DC9 | White 1998, Proc SPIE 3248, doi 10.1117/12.306013 |
| | James, Pearlman, Saigal 2012, J Biomech Eng 134:071001; 2013, Med Eng Phys 35:1638 |
)";
  return page.str();
}

}  // namespace hapticut::experiments
