// SPDX-License-Identifier: Apache-2.0
#include "reports/beside_report.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "hapticut/core/units.hpp"
#include "reports/flag_words.hpp"
#include "reports/report.hpp"

namespace hapticut::apps {
namespace {

/// [deg C], [s] Bone just survives it (Eriksson and Albrektsson, J Prosthet Dent 50, 1983, 101).
constexpr double kSurvived = 47, kSurvivedTime = 60;
/// [K] Rise of a pulp above which 15 % of pulps die (Zach and Cohen, Oral Surg 19, 1965, 515).
constexpr double kMaxRiseOfPulp = 5.5;
constexpr double kLongInterval = 0.5;  // [s] ten times the usual one
constexpr std::string_view kPulp = "pulp";
constexpr std::array<std::string_view, 4> kWithoutLife = {"enamel", "caries", "amalgam", "clay"};

constexpr double kManyMinutes = 1e6;  // CEM43 doubles with each degree, so it grows beyond all meaning

Sentence advice(const HeatConfig& config) {
  if (config.irrigation > 0) return "Press less, make pauses, or let more water reach the place.";
  return "Press less, make pauses, or set " + "heat.irrigation_W_per_m2K"_name + " to the water of a spray, e.g. 3000.";
}

/// [min]
std::string dose(double cem43) {
  return cem43 > kManyMinutes ? "more than " + rounded(kManyMinutes) + " min" : rounded(cem43, 3) + " min";
}

std::string degrees(double temperature) { return rounded(temperature) + " deg C"; }

/// The materials that a report lists.
std::vector<StructureHeat> listed(const HeatReport& report) {
  std::vector<StructureHeat> all = report.structures;
  if (all.size() > kFewMaterials)
    std::erase_if(all, [&](const StructureHeat& heat) { return heat.peak <= report.config.body_temperature; });
  return all;
}

Json to_json(const HeatReport& report, const MaterialTable& materials) {
  Json by_material = Json::object();
  for (const StructureHeat& heat : listed(report))
    by_material[materials[heat.material].name] = {
        {"temperature_degC", heat.temperature},
        {"peak_degC", heat.peak},
        {"time_above_s", heat.time_above},
        {"cem43_min", std::min(heat.cem43, std::numeric_limits<double>::max())},
        {"volume_above_mm3", heat.volume_above / units::mm3}};
  Json warmest;
  if (report.warmest)
    warmest = {{"temperature_degC", report.warmest->temperature}, {"position_mm", in_mm(report.warmest->p_WQ)}};
  return {{"body_temperature_degC", report.config.body_temperature},
          {"threshold_degC", report.config.threshold},
          {"irrigation_W_per_m2K", report.config.irrigation},
          {"by_material", by_material},
          {"warmest", warmest},
          {"balance_J",
           {{"brought_in", report.balance.brought_in},
            {"stored", report.balance.stored},
            {"chips", report.balance.chips},
            {"irrigation", report.balance.irrigation}}}};
}

void add_rows(Table& table, const HeatReport& report, const MaterialTable& materials) {
  table.add("warmest", report.warmest
                           ? degrees(report.warmest->temperature) + " at " + position_text(report.warmest->p_WQ) + " mm"
                           : "nothing was warmer than " + degrees(report.config.body_temperature));
  for (const StructureHeat& heat : listed(report))
    table.add("  " + materials[heat.material].name,
              "now " + degrees(heat.temperature) + ", peak " + degrees(heat.peak) + ", above " +
                  degrees(report.config.threshold) + " for " + rounded(heat.time_above) + " s, CEM43 " +
                  dose(heat.cem43) + ", " + rounded(heat.volume_above / units::mm3) + " mm^3 were above");
  table.add("heat", "brought in " + rounded(report.balance.brought_in) + " J, stored " +
                        rounded(report.balance.stored) + " J, with the chips " + rounded(report.balance.chips) +
                        " J, to the water " + rounded(report.balance.irrigation) + " J");
}

}  // namespace

std::vector<std::string> warnings_of(const BesideReport& beside, const MaterialTable& materials) {
  std::vector<std::string> warnings;
  if (!beside.heat) return warnings;
  const HeatReport& report = *beside.heat;
  const auto warn = [&](const Sentence& warning) { warnings.push_back(in_words_of_flags(warning)); };
  const double survived = cem43(kSurvived, kSurvivedTime);
  for (const StructureHeat& heat : report.structures) {
    const std::string& name = materials[heat.material].name;
    const double rise = heat.peak - report.config.body_temperature;
    if (name == kPulp && rise > kMaxRiseOfPulp) {
      warn(name + " became " + rounded(rise, 3) + " K warmer, and after " + rounded(kMaxRiseOfPulp) +
           " K some pulps die (Zach and Cohen 1965). " + advice(report.config));
    } else if (heat.cem43 > survived && std::ranges::find(kWithoutLife, name) == kWithoutLife.end()) {
      warn(name + " was above " + degrees(report.config.threshold) + " for " + rounded(heat.time_above, 3) +
           " s and reached " + degrees(heat.peak) + ", which is a dose of " + dose(heat.cem43) +
           " CEM43, and bone survives " + rounded(survived) + " (one minute at " + degrees(kSurvived) + "). " +
           advice(report.config));
    }
  }
  if (report.longest_interval > kLongInterval)
    warn("the temperatures were computed in intervals of up to " + rounded(report.longest_interval, 3) +
         " s, because the processor is too slow, so they are coarse; raise " + "heat.voxels_per_cell"_name +
         ", or choose larger voxels.");
  return warnings;
}

void add_to(Json& json, const BesideReport& report, const MaterialTable& materials) {
  if (report.heat) json["heat"] = to_json(*report.heat, materials);
  if (report.loose_pieces)
    json["loose_pieces"] = {{"removed", report.loose_pieces->count},
                            {"volume_mm3", report.loose_pieces->volume / units::mm3}};
}

void add_to(Table& table, const BesideReport& report, const MaterialTable& materials) {
  if (report.heat) add_rows(table, *report.heat, materials);
  if (report.loose_pieces)
    table.add("loose pieces", std::to_string(report.loose_pieces->count) + " removed, " +
                                  rounded(report.loose_pieces->volume / units::mm3) + " mm^3");
}

}  // namespace hapticut::apps
