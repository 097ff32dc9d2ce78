// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <sstream>

#include "experiments/measurements.hpp"
#include "experiments/report.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

using units::N_mm;
using units::rpm;

constexpr double kThickestChip = 0.2;  // [mm] twice that of the tests

/// [m/s] Rate of a carbide bur, by C36.
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

void add_drilling(std::ostream& report) {
  report << R"(## Drilling of bone (B1)

Orelaja, Wang et al. 2020, J Healthc Eng 8817422, Table 6: 2.5 mm twist drill, 1000 rpm. Each material has one test,
so p_e = 0, kappa = 2 M/(R F) and u = 2 M/(R^2 a). The source does not give the feed per revolution a. The table
assumes a = 0.1 mm; u is inversely proportional to a. `hapticut validate` drills with these constants (B1a ... B1f).
It must find the thrust and torque that the constants were fitted to, so this tests the formula C22 and the voxels and
is not a prediction.

| rows | material | thrust [N] | torque [N·mm] | kappa [1] | u [J/m^3] |
|---|---|---|---|---|---|
)";
  for (const PublishedDrilling& p : kPublishedDrillings) {
    const Calibration c = p.constants();
    report << "| " << p.id << " | " << p.material << " | " << digits(p.thrust, 4) << " | " << digits(p.torque / N_mm)
           << " | " << digits(c.cutting_ratio) << " | " << digits(c.specific_cutting_energy) << " |\n";
  }
  report << R"(
Predictions, thrust [N] and torque [N·mm], for other speeds and feeds: spindles from 500 rpm (drills) to 55000 rpm
(B15), feeds of 20 (B15) and 100 mm/min, and feeds with a chip of 0.01, 0.05 and 0.1 mm per revolution (B13). We know
no measurement of these cases. The values scale with the assumed 0.1 mm.

| spindle [rpm] | feed [mm/min] | chip [um per revolution] |)";
  for (const PublishedDrilling& p : kPublishedDrillings) report << " " << p.material << " |";
  report << R"(
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
      report << "| " << digits(speed, 5) << " | " << digits(feed_speed, 4) << " | " << digits(1000 * chip) << " |";
      for (const PublishedDrilling& p : kPublishedDrillings) {
        const AxialCutForce f =
            axial_cut_force(p.constants(), PublishedDrilling::kRadius, speed * rpm, feed_speed / 60 * mm);
        report << " " << digits(f.thrust) << ", " << digits(f.torque / N_mm) << " |";
      }
      report << "\n";
    }
  }
  report << R"(
Without an edge force, thrust and torque are proportional to the chip, feed over speed. Below about 25 um per
revolution measured forces fall less, because the edge rubs. One test cannot identify this: give `hapticut calibrate`
two tests with different feeds. Below 10 um and above 100 um per revolution other mechanisms take over (B13: shear
below 50 um, fracture above 100 um).

)";
}

/// Predictions for 1500 rpm from the tests at 1000 rpm, at the same feed speed.
void add_other_speed(std::ostream& report) {
  report << R"(### A prediction: 1500 rpm

The source also drilled at 1500 rpm. An equal feed speed is assumed. With the constants of 1000 rpm:

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
    report << "| " << p.material << " | " << beside(kAt1500[n].thrust, f.thrust) << " | "
           << beside(kAt1500[n].torque, f.torque / N_mm) << " |\n";
  }
  report << R"(
The torque falls more than in proportion to the chip, so an edge force (h_e > 0) would predict it worse. At one tooth
of a saw with chips of 2 ... 10 um (James et al. 2012, 2013) the tangential force did not change with the chip, and
the normal force rose by 30 %: h_e = 17 ... 25 um. The size effect alone would predict a rise of 124 %.

)";
}

void add_tooth(std::ostream& report) {
  report << R"(## Tooth (DC4, DC9)

Fais et al. 2010, Braz J Oral Sci 9:39: 0.1117 g of enamel in 12 min under 50 ... 80 g with a diamond bur. At 65 g
with
a bur of 1.2 mm at 300000 rpm and kappa = 0.5 (assumed) its side spends )"
         << digits(DiamondBur::power(DiamondBur::kLoad)) << " W on " << digits(DiamondBur::kRemoval / 1e-9)
         << R"( mm^3/s:

    u = kappa F omega R / (dV/dt) = )"
         << digits(DiamondBur::energy()) << R"( J/m^3

This is the preset of enamel for a fine diamond; loads far from 0.6 N are extrapolated. `hapticut validate` presses
this bur into a plate of enamel (DC4).

White 1998, Proc SPIE 3248 (10.1117/12.306013): a carbide bur at high speed, axially, )"
         << digits(CarbideBur::kInEnamel / mm) << " +- 0.047 mm/s in enamel and\n"
         << digits(CarbideBur::kInDentin / mm)
         << R"( in dentin; the load is not given. The presets for blades were fitted to these rates with 0.98 N,
250000 rpm and six blades of a bur of 0.84 mm; `hapticut validate` pushes such a bur (DC9). Axial rates [mm/s] of the
model under other loads:

| load [N] | enamel | dentin | dentin over enamel |
|---|---|---|---|
)";
  for (const double load : {0.5, CarbideBur::kLoad, 1.5, 2.0}) {
    const double enamel = rate_of(load, presets::enamel()), dentin = rate_of(load, presets::dentin());
    report << "| " << digits(load) << " | " << digits(enamel / mm) << " | " << digits(dentin / mm) << " | "
           << digits(dentin / enamel, 2) << " |\n";
  }
  report << R"(
With thin chips the rate grows with the square of the load, because of the size effect. We found no measurement of
this. At low speed White's bur removed 0 mm/s of enamel and 0.042 mm/s of dentin; the law has no such threshold.

)";
}

}  // namespace

std::string measurements_report() {
  std::ostringstream report;
  report << R"(# Published measurements

Constants calibrated on published measurements, and what the model predicts with them elsewhere. docs/validation.md
has the sources.

)";
  add_drilling(report);
  add_other_speed(report);
  add_tooth(report);
  return report.str();
}

}  // namespace hapticut::experiments
