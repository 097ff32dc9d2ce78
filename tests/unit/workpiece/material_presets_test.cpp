// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "hapticut/core/units.hpp"
#include "hapticut/force/stiffness.hpp"
#include "support/places.hpp"
#include "support/refusal.hpp"

namespace hapticut::material_presets_test {
namespace {

std::vector<double> numbers_of(const Material& m) {
  std::vector<double> numbers;
  for_each_number<Material>([&](const auto& field) { numbers.push_back(m.*field.member); });
  return numbers;
}

/// The rows of the tables under a heading of the page: first cell -> numbers.
std::map<std::string, std::vector<double>> documented_under(const std::string& heading) {
  std::ifstream page(test::source_path("docs/heads-and-materials.md"));
  std::map<std::string, std::vector<double>> rows;
  std::string line, here;
  while (std::getline(page, line)) {
    if (line.rfind("## ", 0) == 0) here = line.substr(3);
    if (here != heading || line.rfind("| ", 0) != 0 || line.rfind("| name", 0) == 0) continue;
    std::replace(line.begin(), line.end(), '|', ' ');
    std::istringstream cells(line);
    std::string name, number;
    cells >> name;
    while (cells >> number) rows[name].push_back(std::stod(number));
  }
  return rows;
}

TEST(MaterialPresets, AreTheTableOfTheDocumentationInSixDigits) {
  const auto rows = documented_under("Materials");
  EXPECT_EQ(rows.size(), preset_names().size());
  for (const std::string_view name : preset_names()) {
    const auto row = rows.find(std::string(name));
    ASSERT_NE(row, rows.end()) << name;
    const std::vector<double> numbers = numbers_of(find_preset(name));
    ASSERT_EQ(row->second.size(), numbers.size()) << name;
    for (std::size_t n = 0; n < numbers.size(); ++n) EXPECT_NEAR(row->second[n], numbers[n], 5e-6 * numbers[n]) << name;
  }
}

TEST(MaterialPresets, HaveATableOfAllTheFieldsOfAMaterial) {
  std::string expected = "| name |";
  for_each_number<Material>(
      [&](const auto& field) { expected += std::string(" ") + field.name + " [" + field.unit + "] |"; });
  std::ifstream page(test::source_path("docs/heads-and-materials.md"));
  std::string line;
  while (std::getline(page, line) && line.rfind("| name", 0) != 0) continue;
  EXPECT_EQ(line, expected);
}

/// The lines of a table of the page under a heading, without its head.
std::vector<std::string> lines_under(const std::string& heading) {
  std::ifstream page(test::source_path("docs/heads-and-materials.md"));
  std::vector<std::string> lines;
  std::string line, here;
  while (std::getline(page, line)) {
    if (line.rfind("## ", 0) == 0) here = line.substr(3);
    if (here == heading && line.rfind("| ", 0) == 0 && line.rfind("| of |", 0) != 0) lines.push_back(line);
  }
  return lines;
}

TEST(PresetConstants, AreTheTableOfTheDocumentation) {
  std::vector<std::string> expected;
  for (const PresetConstant& c : preset_constants()) {
    std::string line = "| " + std::string(c.of) + " | " + std::string(c.number) + " [" + std::string(c.unit) + "] | ";
    for (const double value : {c.low, c.typical, c.high}) line += format_number(value) + " | ";
    expected.push_back(line + (c.wears ? "new ... worn | " : " | ") + std::string(c.source) + " |");
  }
  const std::vector<std::string> found = lines_under("Where each number comes from");
  for (std::size_t n = 0; n < std::max(expected.size(), found.size()); ++n)
    EXPECT_EQ(n < found.size() ? found[n] : "", n < expected.size() ? expected[n] : "") << "row " << n;
}

TEST(PresetConstants, AreInOrderAndBelongToACutterOrAMaterial) {
  for (const PresetConstant& c : preset_constants()) {
    const std::string what = std::string(c.of) + ", " + std::string(c.number);
    EXPECT_LE(c.low, c.typical) << what;
    EXPECT_LE(c.typical, c.high) << what;
    EXPECT_FALSE(c.source.empty()) << what;
    EXPECT_EQ(find_constant(c.of, c.number), &c) << what << " is there twice";
    const auto names = preset_names();
    EXPECT_TRUE(c.of == "solid" || value_named<CutterKind>(c.of) || std::ranges::find(names, c.of) != names.end())
        << what;
  }
  EXPECT_EQ(find_constant("enamel", "hardness"), nullptr);
}

/// A preset has the numbers of its own rows, of its cutter, and of all solids; nothing else.
TEST(MaterialPresets, HaveTheNumbersOfTheTable) {
  for (const auto& kind : names_of(Of<CutterKind>{}))
    for (const std::string_view name : preset_names()) {
      const Material m = find_preset(name, kind.value);
      EXPECT_EQ(m.name, name);
      EXPECT_NO_THROW(validate(m));
      const PresetConstant* share = find_constant(name, "share");
      const double e = share == nullptr ? 1 : share->typical;
      EXPECT_EQ(m.cutter.has_value(), share != nullptr) << name;
      for_each_number<Material>([&](const auto& field) {
        const PresetConstant* row = constant_of(name, kind.name, field.name);
        if (row == nullptr) {
          EXPECT_EQ(m.*field.member, Material{}.*field.member) << name << field.name;
          return;
        }
        const std::string_view number = field.name;
        const double factor = number == "specific_cutting_energy" ? e : number == "size_length" ? 1 / e : 1;
        EXPECT_DOUBLE_EQ(m.*field.member, row->typical * factor) << name << ", " << kind.name << ", " << number;
      });
    }
}

TEST(MaterialPresets, WearInOneNumberOfTheirCutter) {
  for (const auto& kind : names_of(Of<CutterKind>{})) {
    int worn_numbers = 0;
    for (const PresetConstant& c : preset_constants()) {
      if (!c.wears || c.of != kind.name) continue;
      ++worn_numbers;
      for_each_number<Material>([&](const auto& field) {
        if (c.number != field.name) return;
        const auto number = [&](Sharpness sharpness) { return presets::enamel(kind.value, sharpness).*field.member; };
        const double used = number(Sharpness::used);
        EXPECT_DOUBLE_EQ(number(Sharpness::new_) / used, c.low / c.typical) << kind.name;
        EXPECT_DOUBLE_EQ(number(Sharpness::worn) / used, c.high / c.typical) << kind.name;
      });
    }
    EXPECT_EQ(worn_numbers, 1) << kind.name;
    EXPECT_EQ(numbers_of(presets::pulp(kind.value, Sharpness::worn)), numbers_of(presets::pulp(kind.value)));
  }
}

TEST(MaterialPresets, GoToTheEndsOfTheirRanges) {
  const Material bone = presets::cortical_bone(CutterKind::twist_drill);
  const Material weak = bone.with(Estimate::low), strong = bone.with(Estimate::high);
  EXPECT_DOUBLE_EQ(weak.specific_cutting_energy, 0.5 * 30e6);
  EXPECT_DOUBLE_EQ(strong.specific_cutting_energy, 2 * 130e6);
  EXPECT_DOUBLE_EQ(weak.edge_length, 6e-6);
  EXPECT_DOUBLE_EQ(strong.edge_length, 45e-6);
  EXPECT_EQ(weak.cutting_ratio, bone.cutting_ratio) << "does not resist";
  EXPECT_EQ(numbers_of(bone.with(Estimate::typical)), numbers_of(bone));

  Material changed = bone;
  changed.density = 1234;
  changed = changed.with(Estimate::high, "cutting_ratio");
  EXPECT_DOUBLE_EQ(changed.cutting_ratio, 0.6);
  EXPECT_EQ(changed.density, 1234) << "a number without that range stays";
  EXPECT_EQ(changed.edge_length, bone.edge_length);
  EXPECT_DOUBLE_EQ(presets::enamel().with(Estimate::low, "share").size_length, 180e-6 / 1.5);
  EXPECT_DOUBLE_EQ(presets::pulp().with(Estimate::high).viscosity, 30e6);

  Material granite = bone;
  granite.name = "granite";
  test::expect_refused([&] { (void)granite.with(Estimate::low); }, {"'granite'", "trabecular_bone"});
  test::expect_refused([&] { (void)bone.with(Estimate::low, "hardness"); }, {"'cortical_bone'", "'hardness'"});
  test::expect_refused([&] { (void)bone.with(Estimate::low, "viscosity"); }, {"'viscosity'"});
}

// docs/model.md, "Crushing and deep contact": w_c of a ball of 1 mm on voxels of 0.1 mm, by default.
TEST(MaterialPresets, AreCrushedFromTheDepthOfThePage) {
  const double k_v = stiffness_for_head(SphereHead{1 * units::mm});
  const auto depth = [&](const Material& m) {
    return std::sqrt(2 * m.compressive_strength / (k_v * m.relative_stiffness));
  };
  EXPECT_NEAR(depth(presets::cortical_bone()), 0.12 * units::mm, 0.005 * units::mm);
  EXPECT_NEAR(depth(presets::enamel()), 0.2 * units::mm, 0.005 * units::mm);
}

TEST(MaterialPresets, RefuseAnUnknownNameAndListTheKnownOnes) {
  test::expect_refused([] { (void)find_preset("granite"); }, {"'granite'", "trabecular_bone"});
  EXPECT_THROW((void)preset_color("granite"), Error);
}

// Values copied from a page in J/mm^3, mm and MPa.
TEST(Material, IsRefusedInUnitsOfAWorkshop) {
  const auto expect = [](double Material::*member, double value, const char* words) {
    Material bone = presets::cortical_bone();
    bone.*member = value;
    test::expect_refused([&] { validate(bone); }, {words});
  };
  expect(&Material::specific_cutting_energy, 0.065, "0.3 J/mm^3, or 300 MPa, are 3e8");
  expect(&Material::specific_cutting_energy, 300, "300 MPa, are 3e8");
  expect(&Material::edge_length, 0.018, "must be between");
  expect(&Material::size_length, 0.18, "must be between");
  expect(&Material::compressive_strength, 150, "150 MPa are 150e6");
  expect(&Material::edge_pressure, 2, "The unit is Pa");
}

TEST(MaterialPresets, HaveDistinctColors) {
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
