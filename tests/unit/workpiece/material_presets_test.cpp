// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "support/places.hpp"

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
  std::ifstream page(test::source_path("docs/materials.md"));
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
  std::ifstream page(test::source_path("docs/materials.md"));
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
  for (const std::string_view name : preset_names()) EXPECT_LE(find_preset(name).relative_stiffness, 1) << name;
}

/// The rows of the second table of the page: name and cutter -> kappa, u, h_e, h_s.
std::map<std::string, std::vector<double>> documented_pairs() {
  std::ifstream page(test::source_path("docs/materials.md"));
  std::map<std::string, std::vector<double>> rows;
  std::string line;
  bool here = false;
  while (std::getline(page, line)) {
    if (line.rfind("## ", 0) == 0) here = line == "## By cutter";
    if (!here || line.rfind("| ", 0) != 0 || line.rfind("| name", 0) == 0) continue;
    std::replace(line.begin(), line.end(), '|', ' ');
    std::istringstream cells(line);
    std::string name, cutter, number;
    cells >> name >> cutter;
    while (cells >> number) rows[name + " " + cutter].push_back(std::stod(number));
  }
  return rows;
}

TEST(MaterialPresets, AreForEachCutterWhatTheTableSays) {
  const auto rows = documented_pairs();
  EXPECT_EQ(rows.size(), 5U * 6U);
  for (const auto& kind : names_of(Of<CutterKind>{}))
    for (const char* name : {"enamel", "dentin", "caries", "cortical_bone", "trabecular_bone"}) {
      const auto row = rows.find(std::string(name) + " " + kind.name);
      ASSERT_NE(row, rows.end()) << name << " " << kind.name;
      const Material m = find_preset(name, kind.value);
      const double found[] = {m.cutting_ratio, m.specific_cutting_energy, m.edge_length, m.size_length};
      for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(found[n], row->second[n], 0.006 * found[n]) << name << kind.name;
      EXPECT_EQ(m.name, name);
      EXPECT_NO_THROW(validate(m));
    }
}

// White 1998, Proc SPIE 3248: a carbide bur of 0.84 mm at high speed goes 0.273 +- 0.047 mm/s into enamel, 0.493 mm/s
// into dentin. Its load is not given: that of dentists, 0.98 N, and six blades at 250000 rpm under it are assumed.
TEST(MaterialPresets, LetACarbideBurIntoEnamelAndDentinAsFastAsWhiteMeasured) {
  const double speed = 250000 * units::rpm, radius = 0.42 * units::mm, load = 0.98;
  const auto rate = [&](const Material& m) {
    closed_forms::SteadyCut cut{m.specific_cutting_energy, m.cutting_ratio, speed, 1};
    cut.tooth_rate = tooth_rate(common_cutter(CutterKind::carbide_bur), speed);
    cut.edge_length = m.edge_length;
    cut.size_length = m.size_length;
    return closed_forms::feed_with_chips_under(load, cut, radius) / units::mm;
  };
  EXPECT_NEAR(rate(presets::enamel()), 0.273, 0.047);
  EXPECT_NEAR(rate(presets::dentin()) / 0.493, 1, 0.1);
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
