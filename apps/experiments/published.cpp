// SPDX-License-Identifier: Apache-2.0
#include "experiments/published.hpp"

#include <cmath>
#include <sstream>
#include <utility>

#include "experiments/heat_rows.hpp"
#include "experiments/measurements.hpp"
#include "experiments/pairs.hpp"
#include "experiments/report.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::experiments {
namespace {

using units::N_mm;
using units::rpm;
using enum CutterKind;

// --- predictions -----------------------------------------------------------------------------------------------------

/// A twist drill of two lips with a common point, in one material.
struct Drill {
  double diameter, speed;  // [m], [rad/s]
  const char* preset;
  double pilot = 0;  // [m] diameter of the hole that it widens

  [[nodiscard]] double lips_per_second() const { return 2 * speed / (2 * kPi); }
  [[nodiscard]] static double slope() { return std::sin(kCommonDrillPoint / 2); }  // [1] chip over feed per lip

  /// [m] What the chip and the edge of a lip count for.
  [[nodiscard]] double thickness(const Material& m, double feed) const {
    return slope() * feed / lips_per_second() + m.edge_length;
  }
  /// [1] What chips cost that fill the flutes.
  [[nodiscard]] double crowding(double feed) const {
    return std::pow(std::max(1.0, feed / (kCrowdedFeed * diameter * lips_per_second())), 8);
  }
  /// [N]  @param feed  [m/s]
  [[nodiscard]] double thrust(const PresetOf& of, double feed) const {
    const Material m = of(preset, twist_drill);
    return m.specific_cutting_energy * crowding(feed) * (diameter - pilot) * thickness(m, feed) / m.cutting_ratio;
  }
  /// [N mm]
  [[nodiscard]] double torque(const PresetOf& of, double feed) const {
    const Material m = of(preset, twist_drill);
    return m.specific_cutting_energy * crowding(feed) * diameter * diameter / 4 * thickness(m, feed) / slope() / N_mm;
  }
  /// [m/s]  @param load  [N]
  [[nodiscard]] double feed(const PresetOf& of, double load) const {
    double low = 0, high = diameter * lips_per_second();
    while (high - low > 1e-9 * high) {
      const double middle = 0.5 * (low + high);
      (thrust(of, middle) < load ? low : high) = middle;
    }
    return low;
  }
};

/// [mm/s] Speed of a carbide bur along its axis, by C36.
double axial_rate(const PresetOf& of, const char* preset) {
  const Material m = of(preset, carbide_bur);
  forms::SteadyCut cut = {m.specific_cutting_energy, m.cutting_ratio, CarbideBur::kSpeed, 1};
  cut.tooth_rate = tooth_rate(Cutter{carbide_bur}, CarbideBur::kSpeed);
  cut.size_length = m.size_length;
  return forms::feed_with_chips_under(CarbideBur::kLoad, cut, CarbideBur::kRadius) / mm;
}

/// [mm^3/s] Rate of the side of a diamond on a turbine that slows under the load.
/// @param harder  [1] energy of the body over that of the preset
double side_rate(const PresetOf& of, const char* preset, CutterKind kind, double radius, double load, double speed,
                 double harder = 1) {
  const Material m = of(preset, kind);
  const Spindle turbine = common_spindle(MotorKind::air_turbine, speed * units::rad_per_s);
  const double drag = m.cutting_ratio * load;  // [N]
  const double loaded = speed - turbine.droop * drag * radius;
  return drag * radius * std::max(0.0, loaded) / (harder * m.specific_cutting_energy) / 1e-9;
}

/// [s] Four drills one after the other, each 10 mm deep.
double widening_time(const PresetOf& of) {
  double time = 0, pilot = 0;
  for (const double diameter : {2.2 * mm, 2.8 * mm, 3.4 * mm, 4.0 * mm}) {
    time += 10 * mm / Drill{diameter, 800 * rpm, "bone_d2", pilot}.feed(of, 2 * 9.80665);
    pilot = diameter;
  }
  return time;
}

// --- the rows --------------------------------------------------------------------------------------------------------

const char* const kClogged = "the flutes of a deep hole clog: torque over thrust is 6 ... 10 times that of the law";
const char* const kHardBone = "2 ... 8 times the thrust and 6 ... 19 times the torque of Hillery and Alam";
const char* const kNoBone = "a foam with a skin, not bone";

void add_drill(std::vector<PublishedRow>& rows, const std::string& conditions, const Drill& drill, double feed,
               std::pair<double, double> thrust, std::pair<double, double> torque, const std::string& source,
               bool thrust_fitted, bool torque_fitted = false, const char* thrust_beyond = "",
               const char* torque_beyond = "") {
  if (thrust.first > 0)
    rows.push_back({conditions, "thrust [N]", thrust.first, thrust.second, source, thrust_fitted, thrust_beyond,
                    [=](const PresetOf& of) { return drill.thrust(of, feed); }});
  if (torque.first > 0)
    rows.push_back({conditions, "torque [N·mm]", torque.first, torque.second, source, torque_fitted, torque_beyond,
                    [=](const PresetOf& of) { return drill.torque(of, feed); }});
}

void add_drills(std::vector<PublishedRow>& rows) {
  constexpr double kPerMinute = 1e-3 / 60;  // [m/s] a millimetre
  const auto cortical = [](double diameter, double speed) {
    return Drill{diameter * mm, speed * rpm, "cortical_bone"};
  };
  const std::string hillery = "Hillery and Shuaib 1999, recalled; range in Orelaja et al. 2020";
  add_drill(rows, "bovine tibia, 3.2 mm, 400 rpm, 50 mm/min", cortical(3.2, 400), 50 * kPerMinute, {48, 0}, {14.5, 0},
            hillery, true, true);
  add_drill(rows, "bovine tibia, 3.2 mm, 2000 rpm, 50 mm/min", cortical(3.2, 2000), 50 * kPerMinute, {24, 0}, {10, 0},
            hillery, true, true);
  const std::string alam = "Alam et al. 2011, conditions recalled; range in Orelaja et al. 2020";
  add_drill(rows, "bovine femur, 4 mm, 600 rpm, 50 mm/min", cortical(4, 600), 50 * kPerMinute, {85, 0}, {23, 0}, alam,
            false);
  add_drill(rows, "bovine femur, 4 mm, 3000 rpm, 10 mm/min", cortical(4, 3000), 10 * kPerMinute, {25, 0}, {10, 0}, alam,
            false);
  const std::string orelaja = "Orelaja, Wang et al. 2020, J Healthc Eng 8817422, table 6";
  const double feed = 100 * kPerMinute;
  add_drill(rows, "bovine femur, 2.5 mm, 1000 rpm, 100 mm/min assumed", cortical(2.5, 1000), feed, {20.07, 0},
            {41.2, 0}, orelaja, true, false, "", kClogged);
  add_drill(rows, "bovine femur, 2.5 mm, 1500 rpm, 100 mm/min assumed", cortical(2.5, 1500), feed, {12.34, 0},
            {24.2, 0}, orelaja, false, false, "", kClogged);
  add_drill(rows, "porcine femur, 2.5 mm, 1000 rpm, 100 mm/min assumed", cortical(2.5, 1000), feed, {11.25, 0}, {37, 0},
            orelaja, false, false, "", kClogged);
  add_drill(rows, "porcine femur, 2.5 mm, 1500 rpm, 100 mm/min assumed", cortical(2.5, 1500), feed, {8.14, 0},
            {21.6, 0}, orelaja, false, false, "", kClogged);
  add_drill(rows, "artificial femur, 2.5 mm, 1000 rpm, 100 mm/min assumed", cortical(2.5, 1000), feed, {5.62, 0},
            {13.6, 0}, orelaja, false, false, kNoBone, kNoBone);
  const std::string macavelia = "MacAvelia et al. 2012, J Biomech Eng 134:121003";
  const struct {
    double speed, thrust, thrust_scatter, torque, torque_scatter;
  } femur[] = {{1000, 198.4, 14.2, 186.3, 16.9}, {1250, 180.6, 14, 157.8, 16.1}, {1500, 176.3, 11.2, 140.2, 16.4}};
  for (const auto& at : femur)
    add_drill(rows, "human femur, 3.2 mm, " + digits(at.speed, 4) + " rpm, 120 mm/min", cortical(3.2, at.speed),
              120 * kPerMinute, {at.thrust, at.thrust_scatter}, {at.torque, at.torque_scatter}, macavelia, false, false,
              kHardBone, kHardBone);
  add_drill(rows, "bovine bone, 2 mm, 12000 rpm, 50 mm/min", cortical(2, 12000), 50 * kPerMinute, {14.11, 0}, {0, 0},
            "J Braz Soc Mech Sci Eng 2020, 42:349, 10.1007/s40430-020-02436-w", false);
  add_drill(rows, "human trochanter, cancellous, 2.5 mm, 1000 rpm, 100 mm/min assumed",
            {2.5 * mm, 1000 * rpm, "trabecular_bone"}, feed, {1.25, 0.25}, {0, 0},
            "Tsai et al. 2007; range in Orelaja et al. 2020", true);
  add_drill(rows, "dog jaw, new drill, 2 mm, 1500 rpm, 30 mm/min assumed", cortical(2, 1500), 30 * kPerMinute, {4, 0.9},
            {0, 0}, "an assessment of cutting force for dental implant drilling, HSS drill", true);
  add_drill(rows, "by hand, six drills, 2 mm, 2000 rpm, 60 mm/min assumed", cortical(2, 2000), 60 * kPerMinute,
            {9.16, 0}, {0, 0}, "Hobkirk and Rusiniak 1977, 20 operators", true);
}

std::vector<PublishedRow> make_rows() {
  std::vector<PublishedRow> rows;
  add_drills(rows);
  const auto ratio = [&](const std::string& what, double measured, double scatter, double slow, double fast) {
    rows.push_back({what, "ratio of times [1]", measured, scatter, "Gurdan et al. 2017, J Oral Sci 59:47", false, "",
                    [=](const PresetOf& of) {
                      const auto at = [&](double speed) {
                        return Drill{1.5 * mm, speed * rpm, "bone_d2"}.feed(of, 2 * 9.80665);
                      };
                      return at(fast) / at(slow);
                    },
                    PublishedRow::kLawAlone});
  };
  ratio("pig rib, pilot drill, equal load, 100 and 200 rpm", 1.91, 0.9, 100, 200);
  ratio("pig rib, pilot drill, equal load, 200 and 1200 rpm", 11, 3.8, 200, 1200);
  rows.push_back({"rib, four drills of 2.2 ... 4 mm in turn, 2 kg, 800 rpm; 10 mm deep, bone D2 assumed", "time [s]",
                  10.1, 5.9, "Gedik et al. 2025, 10.1186/s12903-025-06860-z", false, "", widening_time});

  const std::string white = "White 1998, Proc SPIE 3248, 10.1117/12.306013";
  const std::string bur = ", carbide bur of 0.84 mm along its axis, 250000 rpm, 0.98 N assumed";
  rows.push_back({"enamel" + bur, "speed [mm/s]", CarbideBur::kInEnamel / mm, 0.047, white, true, "",
                  [](const PresetOf& of) { return axial_rate(of, "enamel"); }});
  rows.push_back({"dentin" + bur, "speed [mm/s]", CarbideBur::kInDentin / mm, 0, white, true, "",
                  [](const PresetOf& of) { return axial_rate(of, "dentin"); }});
  const std::string fais = "Fais et al. 2010, Braz J Oral Sci 9:39";
  const auto fine = [](const PresetOf& of) {
    return side_rate(of, "enamel", fine_diamond, DiamondBur::kRadius, DiamondBur::kLoad, DiamondBur::kSpeed);
  };
  rows.push_back({"human enamel, side of a fine diamond of 1.2 mm, 0.64 N, 300000 rpm assumed", "rate [mm^3/s]",
                  DiamondBur::kRemoval / 1e-9, 0.004, fais, true, "", fine});
  rows.push_back({"bovine enamel, side of a fine diamond of 1.2 mm, 0.64 N, 300000 rpm assumed", "rate [mm^3/s]", 0.066,
                  0.008, fais, false, "", fine});
  rows.push_back({"tooth in resin, side of a coarse diamond of 1.6 mm, 1 N, 350000 rpm assumed", "rate [mm^3/s]", 0.54,
                  0, "Benedettini, Melilli, Baldissara 2003, J Dent Res 82", true, "", [](const PresetOf& of) {
                    return side_rate(of, "dentin", coarse_diamond, 0.8 * mm, 1, 350000 * rpm, 1.14);
                  }});
  const std::string yang = "Yang, Li et al. 2023, Front Mech Eng 18(1), 10.1007/s11465-022-0717-z";
  const auto kappa = [](const PresetOf& of) { return of("cortical_bone", mastoid_diamond_bur).cutting_ratio; };
  rows.push_back({"bone, diamond ball, dry", "tangential over normal force [1]", 0.335, 0, yang, false, "", kappa,
                  "cutting_ratio"});
  rows.push_back({"bone, diamond ball, drip of saline", "tangential over normal force [1]", 0.277, 0, yang, false, "",
                  kappa, "cutting_ratio"});
  rows.push_back({"leucite ceramic, coarse diamond, least and largest forces", "tangential over normal force [1]", 0.5,
                  0.1, "Song and Yin 2009", true, "",
                  [](const PresetOf& of) { return of("enamel", coarse_diamond).cutting_ratio; }, "cutting_ratio"});
  rows.push_back({"machinable ceramic, first cut, medium grit (fine_diamond) over coarse", "ratio of rates [1]", 1, 0,
                  "Siegel and von Fraunhofer 2000, JADA", true, "", [](const PresetOf& of) {
                    return of("dentin", coarse_diamond).specific_cutting_energy /
                           of("dentin", fine_diamond).specific_cutting_energy;
                  }});
  return rows;
}

std::string number_or_endless(double value) { return std::isfinite(value) ? digits(value) : "never"; }

std::string use_of(const PublishedRow& row) {
  if (row.fitted) return "by a fit";
  if (row.number == PublishedRow::kLawAlone) return "no; law alone";
  return row.beyond.empty() ? "no" : "no; beyond: " + row.beyond;
}

void add_table(std::ostream& report) {
  report << "| conditions | quantity | measured | predicted | new ... worn | low ... high | factor | used | source |\n"
            "|---|---|---|---|---|---|---|---|---|\n";
  for (const PublishedRow& row : published_rows()) {
    const Prediction p = prediction_of(row);
    report << "| " << row.conditions << " | " << row.quantity << " | " << digits(row.measured, 4);
    if (row.scatter > 0) report << " +- " << digits(row.scatter);
    report << " | " << digits(p.typical) << " | " << number_or_endless(p.fresh) << " ... " << number_or_endless(p.worn)
           << " | " << number_or_endless(p.low) << " ... " << number_or_endless(p.high) << " | "
           << digits(factor_of(row), 3) << " | " << use_of(row) << " | " << row.source << " |\n";
  }
}

}  // namespace

const std::vector<PublishedRow>& published_rows() {
  static const std::vector<PublishedRow> rows = make_rows();
  return rows;
}

Prediction prediction_of(const PublishedRow& row) {
  const auto with = [&](Sharpness sharpness, Estimate estimate) {
    return row.predict([&](const char* preset, CutterKind cutter) {
      const Material material = find_preset(preset, cutter, sharpness);
      if (estimate == Estimate::typical || row.number == PublishedRow::kLawAlone) return material;
      return row.number.empty() ? material.with(estimate) : material.with(estimate, row.number);
    });
  };
  using enum Sharpness;
  return {with(used, Estimate::typical), with(new_, Estimate::typical), with(worn, Estimate::typical),
          with(used, Estimate::low), with(used, Estimate::high)};
}

double factor_of(const PublishedRow& row) {
  const double ratio = prediction_of(row).typical / row.measured;
  return std::max(ratio, 1 / ratio);
}

namespace {

using Chosen = std::function<bool(const PublishedRow&)>;

PublishedSummary summary_of(const Chosen& chosen) {
  PublishedSummary summary;
  std::vector<double> factors;
  for (const PublishedRow& row : published_rows()) {
    if (!chosen(row)) continue;
    const Prediction p = prediction_of(row);
    factors.push_back(factor_of(row));
    summary.within_two += int(factors.back() <= 2);
    summary.bracketed += int(p.brackets(row.measured, row.scatter));
    summary.allowed += int(p.allows(row.measured, row.scatter));
  }
  std::ranges::sort(factors);
  summary.rows = int(factors.size());
  const std::size_t middle = factors.size() / 2;
  summary.median = factors.size() % 2 == 1 ? factors[middle] : 0.5 * (factors[middle - 1] + factors[middle]);
  return summary;
}

void add_summary(std::ostream& report) {
  const auto is = [](const char* quantity) {
    return [=](const PublishedRow& row) { return row.counts() && row.quantity.starts_with(quantity); };
  };
  const auto other = [&](const PublishedRow& row) { return row.counts() && !is("thrust")(row) && !is("torque")(row); };
  const struct {
    const char* name;
    Chosen chosen;
  } groups[] = {{"**all that count**", [](const PublishedRow& row) { return row.counts(); }},
                {"thrust of drills", is("thrust")},
                {"torque of drills", is("torque")},
                {"times, rates and ratios of forces", other},
                {"not used, with those beyond", [](const PublishedRow& row) { return !row.fitted; }},
                {"used by a fit", [](const PublishedRow& row) { return row.fitted; }}};
  report << "| rows | number | median factor | within 2 | new ... worn | low ... high |\n|---|---|---|---|---|---|\n";
  for (const auto& [name, chosen] : groups) {
    const PublishedSummary s = summary_of(chosen);
    report << "| " << name << " | " << s.rows << " | " << digits(s.median) << " | " << s.within_two << " | "
           << s.bracketed << " | " << s.allowed << " |\n";
  }
}

}  // namespace

PublishedSummary summary_of_published() {
  return summary_of([](const PublishedRow& row) { return row.counts(); });
}

std::string measurements_report() {
  std::ostringstream report;
  report
      << "<!-- SPDX-License-Identifier: Apache-2.0 -->\n# Published measurements\n\n"
         "Outside a preset's own rows expect no better than a factor of 2. The thrust of drills is worse: most of\n"
         "its rows are farther off, and human femora took five times as much. `hapticut validate --measurements\n"
         "FILE` writes this page, and a test compares it with the presets.\n\n"
         "## Predictions\n\n"
         "The factor is predicted over measured, or its inverse. A row counts if no fit used it, constants of the\n"
         "presets enter, and it is not \"beyond\": of another material, of a hole whose chips clog, or of a source\n"
         "that contradicts others at like conditions. \"New ... worn\" and \"low ... high\" are how many\n"
         "measurements lie, with their scatter, between a new and a worn cutter, and between the ends of the ranges\n"
         "of all numbers that resist a cut. These ends are far apart, a factor of 30 ... 100 for drills. Every\n"
         "prediction is for a used cutter, because no source but the dog jaw says how sharp its cutter was.\n\n";
  add_summary(report);
  report << "\nA fit meets its rows together and not each: the trochanter is softer than typical trabecular bone, and\n"
            "the new drill of the dog jaw is compared with a used one.\n\n"
            "\"Measured\" has its scatter where the source gives it. \"Low ... high\" are the least and largest\n"
            "resistance of `Material::with`, or the range of the one number that enters. \"Assumed\" and \"recalled\"\n"
            "conditions are ours, because the source was not at hand in full.\n\n";
  add_table(report);
  report << "\n" << pairs_report() << "\n" << heat_report();
  return report.str();
}

}  // namespace hapticut::experiments
