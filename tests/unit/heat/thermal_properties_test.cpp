// SPDX-License-Identifier: Apache-2.0
#include "hapticut/heat/thermal_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/places.hpp"

namespace hapticut::thermal_properties_test {
namespace {

/// The rows of the table of properties on the page, without its head.
std::vector<std::string> rows_of_page() {
  std::ifstream page(test::source_path("docs/beside-the-step.md"));
  std::vector<std::string> rows;
  std::string line, here;
  while (std::getline(page, line)) {
    if (line.starts_with("### ")) here = line.substr(4);
    if (here == "Properties" && line.starts_with("| ") && !line.starts_with("| material |")) rows.push_back(line);
  }
  return rows;
}

TEST(ThermalProperties, AreTheTableOfTheDocumentation) {
  std::vector<std::string> expected;
  for (const KnownThermalProperties& known : known_thermal_properties())
    expected.push_back("| " + std::string(known.material) + " | " + format_number(known.properties.conductivity) +
                       " | " + format_number(known.properties.heat_capacity) + " | " + std::string(known.source) +
                       " |");
  EXPECT_EQ(rows_of_page(), expected);
}

TEST(ThermalProperties, BelongToTheNameOfEachPreset) {
  const auto presets = preset_names();
  EXPECT_EQ(known_thermal_properties().size(), presets.size());
  for (const KnownThermalProperties& known : known_thermal_properties()) {
    EXPECT_NE(std::ranges::find(presets, known.material), presets.end()) << known.material;
    EXPECT_EQ(thermal_properties_of(known.material), known.properties) << known.material;
    EXPECT_FALSE(known.source.empty()) << known.material;
    EXPECT_NO_THROW(require_fields_within(known.properties, "ThermalProperties::")) << known.material;
  }
  EXPECT_NE(thermal_properties_of("enamel"), thermal_properties_of("dentin"));
}

TEST(ThermalProperties, OfAnUnknownMaterialAreThoseOfCorticalBone) {
  EXPECT_EQ(thermal_properties_of("wood"), thermal_properties_of("cortical_bone"));
  EXPECT_EQ(thermal_properties_of(""), ThermalProperties{});
}

}  // namespace
}  // namespace hapticut::thermal_properties_test
