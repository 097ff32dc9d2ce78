// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::material_presets_test {
namespace {

/// Calls `visit(field)` for each number of a material.
template <class Visit>
void for_each_number(const Visit& visit) {
  for_each_field<Material>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), double Material::*>) visit(field);
  });
}

std::vector<double> numbers_of(const Material& m) {
  std::vector<double> numbers;
  for_each_number([&](const auto& field) { numbers.push_back(m.*field.member); });
  return numbers;
}

/// The rows of the first table of the page: name -> the nine numbers.
std::map<std::string, std::vector<double>> documented_presets() {
  std::ifstream page(HAPTICUT_DOCS "/materials.md");
  std::map<std::string, std::vector<double>> rows;
  std::string line;
  while (std::getline(page, line)) {
    if (line.rfind("## ", 0) == 0) break;
    if (line.rfind("| ", 0) != 0 || line.rfind("| name", 0) == 0) continue;
    std::replace(line.begin(), line.end(), '|', ' ');
    std::istringstream cells(line);
    std::string name, number;
    cells >> name;
    while (cells >> number) rows[name].push_back(std::stod(number));
  }
  return rows;
}

TEST(MaterialPresets, AreExactlyTheTableOfTheDocumentation) {
  const auto rows = documented_presets();
  EXPECT_EQ(rows.size(), preset_names().size());
  for (const std::string_view name : preset_names()) {
    const auto row = rows.find(std::string(name));
    ASSERT_NE(row, rows.end()) << name;
    EXPECT_EQ(row->second, numbers_of(find_preset(name))) << name;
  }
}

TEST(MaterialPresets, StandInATableOfAllTheFieldsOfAMaterial) {
  std::string expected = "| name |";
  for_each_number([&](const auto& field) { expected += std::string(" ") + field.name + " [" + field.unit + "] |"; });
  std::ifstream page(HAPTICUT_DOCS "/materials.md");
  std::string line;
  while (std::getline(page, line) && line.rfind("| name", 0) != 0) continue;
  EXPECT_EQ(line, expected);
}

TEST(MaterialPresets, AreValidAndNamedLikeTheirFunction) {
  for (const std::string_view name : preset_names()) {
    const Material material = find_preset(name);
    EXPECT_EQ(material.name, name);
    EXPECT_NO_THROW(validate(material));
  }
  EXPECT_EQ(presets::cortical_bone().name, "cortical_bone");
}

TEST(MaterialPresets, FitIntoOneTable) {
  MaterialTable table;
  for (const std::string_view name : preset_names()) table.add(find_preset(name));
  EXPECT_EQ(table.size(), 9);
}

TEST(MaterialPresets, AreNeverStifferThanEnamel) {
  for (const std::string_view name : preset_names()) {
    EXPECT_LE(find_preset(name).relative_stiffness, 1) << name;
    if (name == "enamel_with_diamond") continue;  // another kind of tool
    EXPECT_LE(find_preset(name).specific_cutting_energy, presets::enamel().specific_cutting_energy) << name;
  }
}

// delta = sqrt(2 u v / (kappa k_v omega R)): the documentation promises at most 1.2 times that of enamel.
TEST(MaterialPresets, AreEngagedAtMostAFifthDeeperThanEnamel) {
  const auto layer = [](const Material& m) {
    return std::sqrt(m.specific_cutting_energy / (m.cutting_ratio * m.relative_stiffness));
  };
  for (const std::string_view name : preset_names()) {
    if (name == "enamel_with_diamond") continue;
    EXPECT_LE(layer(find_preset(name)) / layer(presets::enamel()), 1.2) << name;
  }
  EXPECT_NEAR(layer(presets::enamel_with_diamond()) / layer(presets::enamel()), 8, 0.1)
      << "and the documentation says so of the diamond";
}

TEST(MaterialPresets, LetADentalBurrCutEnamelWithTheLoadThatDentistsUse) {
  const Material enamel = presets::enamel();
  const double radius = 0.6 * units::mm;
  const double chip = 2 * units::kPi * radius * enamel.specific_cutting_energy * 1e-3 / (enamel.cutting_ratio * 20000);
  const double edge = units::kPi * radius * radius * enamel.edge_pressure;
  EXPECT_GT(chip + edge, 0.43);  // the tested range of handpiece loads: 0.43 ... 1.79 N
  EXPECT_LT(chip + edge, 1.79);
  EXPECT_LT(edge, 0.43);
}

TEST(MaterialPresets, RefuseAnUnknownNameAndListTheKnownOnes) {
  try {
    (void)find_preset("granite");
    FAIL() << "granite was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'granite'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("trabecular_bone"), std::string::npos);
  }
  EXPECT_THROW((void)preset_color("granite"), Error);
}

TEST(MaterialPresets, HaveColorsThatCanBeToldApart) {
  for (const std::string_view a : preset_names())
    for (const std::string_view b : preset_names()) {
      if (a >= b) continue;
      const Color one = preset_color(a), other = preset_color(b);
      const int difference =
          std::abs(one.red - other.red) + std::abs(one.green - other.green) + std::abs(one.blue - other.blue);
      EXPECT_GT(difference, 30) << a << " and " << b;
    }
}

}  // namespace
}  // namespace hapticut::material_presets_test
