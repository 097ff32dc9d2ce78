// SPDX-License-Identifier: Apache-2.0
#include "hapticut/workpiece/material_presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "hapticut/closed_forms.hpp"
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

TEST(MaterialPresets, AreThoseOfTheTablesForEachCutter) {
  const auto cutters = documented_under("By cutter"), relative_energies = documented_under("By material");
  EXPECT_EQ(cutters.size(), names_of(Of<CutterKind>{}).size());
  for (const auto& kind : names_of(Of<CutterKind>{}))
    for (const std::string_view name : preset_names()) {
      const Material m = find_preset(name, kind.value);
      EXPECT_EQ(m.name, name);
      EXPECT_NO_THROW(validate(m));
      if (!relative_energies.contains(m.name)) {
        EXPECT_EQ(numbers_of(m), numbers_of(find_preset(name))) << name << ": equal for each cutter";
        continue;
      }
      const std::vector<double>& of = cutters.at(kind.name);
      const double relative_energy = relative_energies.at(m.name).at(0);
      const double found[] = {m.cutting_ratio, m.specific_cutting_energy, m.edge_length, m.size_length};
      const double expected[] = {of.at(0), of.at(1) * relative_energy, of.at(2), of.at(3) / relative_energy};
      for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(found[n], expected[n], 0.006 * found[n]) << name << kind.name;
    }
}

/// [m^3/s] Volume rate of a ball that is plunged deeper than its radius under a load (C38).
double rate_of(CutterKind kind, const Material& m, double load, double radius = 1 * units::mm) {
  constexpr double kSpin = 8000;  // [rad/s]
  closed_forms::SteadyCut cut{m.specific_cutting_energy, m.cutting_ratio, kSpin, 0};
  cut.tooth_rate = tooth_rate(Cutter{kind}, kSpin);
  cut.edge_length = m.edge_length;
  cut.size_length = m.size_length;
  double low = 0, high = 1e3;  // [m/s]
  for (int halving = 0; halving < 100; ++halving) {
    cut.feed_speed = (low + high) / 2;
    (closed_forms::ball_plunge_chip_wrench(cut, radius).force.z() < load ? low : high) = cut.feed_speed;
  }
  return low < 1e-15 ? 0 : low * units::kPi * radius * radius;
}

TEST(MaterialPresets, AreInTheSameOrderUnderEveryCutterAndLoad) {
  const std::vector<std::vector<std::string>> slower_first = {
      {"enamel"}, {"amalgam"}, {"dentin", "cortical_bone"}, {"caries"}, {"trabecular_bone"}, {"pulp"}, {"clay"}};
  for (const auto& kind : names_of(Of<CutterKind>{}))
    for (const double load : {0.3, 1.0, 3.0, 6.0, 10.0, 30.0}) {
      double last = 0;
      for (const auto& alike : slower_first) {
        const double rate = rate_of(kind.value, find_preset(alike.front(), kind.value), load);
        const std::string at = alike.front() + ", " + kind.name + ", " + std::to_string(load) + " N";
        EXPECT_TRUE(rate > 1.1 * last || rate + last == 0) << at << ": " << rate << " after " << last;
        for (const auto& other : alike)
          EXPECT_EQ(rate_of(kind.value, find_preset(other, kind.value), load), rate) << at << ", as " << other;
        last = rate;
      }
    }
}

TEST(MaterialPresets, LetCuttingBursThroughBoneFasterThanDiamondsFromOneAndAHalfNewtonsOn) {
  using enum CutterKind;
  struct Pair {
    CutterKind blades, grains;
    double max_radius;  // [m]
  };
  for (const Pair& pair :
       {Pair{mastoid_cutting_bur, mastoid_diamond_bur, 3.5 * units::mm},
        Pair{carbide_bur, fine_diamond, 1.2 * units::mm}, Pair{carbide_bur, coarse_diamond, 1.2 * units::mm}})
    for (const double radius : {0.5 * units::mm, pair.max_radius})
      for (const char* bone : {"cortical_bone", "trabecular_bone"})
        for (const double load : {1.5, 3.0, 10.0})
          EXPECT_GT(rate_of(pair.blades, find_preset(bone, pair.blades), load, radius),
                    rate_of(pair.grains, find_preset(bone, pair.grains), load, radius))
              << names_of(Of<CutterKind>{})[std::size_t(pair.grains)].name << ", " << load << " N, " << radius << " m";
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
