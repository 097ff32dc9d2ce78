// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/heat/heat_field.hpp"
#include "reports/json_file.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {

/// Temperatures of a run, at its end.
struct HeatReport {
  HeatConfig config;
  std::vector<StructureHeat> structures;  ///< one entry per material
  HeatBalance balance;
  std::optional<WarmestPlace> warmest;
  double longest_interval = 0;  ///< [s] longest time of steps that the field advanced by at once
};

/// Pieces that were removed because the tool had cut them loose.
struct LoosePieces {
  std::uint64_t count = 0;
  double volume = 0;  ///< [m^3]
};

/// What was computed beside the steps of a run.
struct BesideReport {
  std::optional<HeatReport> heat;           ///< nullopt: temperatures were not computed
  std::optional<LoosePieces> loose_pieces;  ///< nullopt: loose pieces were not removed
};

/// Warnings as sentences; may be empty.
[[nodiscard]] std::vector<std::string> warnings_of(const BesideReport& report, const MaterialTable& materials);

/// Adds `heat` and `loose_pieces`, if there are any, to the report of a run.
void add_to(Json& json, const BesideReport& report, const MaterialTable& materials);
void add_to(Table& table, const BesideReport& report, const MaterialTable& materials);

}  // namespace hapticut::apps
