// SPDX-License-Identifier: Apache-2.0
// What the presets predict for published measurements, and the page that says so.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "experiments/heat_rows.hpp"
#include "experiments/published.hpp"
#include "experiments/setup/cutting.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/places.hpp"

namespace hapticut::published_test {
namespace {

using units::kPi;
using units::mm;
using units::rpm;

constexpr double kVoxels = 0.05;  // [1] difference of rates between kinds of processors

/// The words of a text. Numbers are apart from what surrounds them.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string word; lines >> word;) words.push_back(word);
  return words;
}

/// Whether two words are the same, or numbers within a few percent.
bool alike(const std::string& one, const std::string& other) {
  if (one == other) return true;
  char *end_of_one = nullptr, *end_of_other = nullptr;
  const double a = std::strtod(one.c_str(), &end_of_one), b = std::strtod(other.c_str(), &end_of_other);
  return end_of_one != one.c_str() && std::string(end_of_one) == end_of_other &&
         std::abs(a - b) <= kVoxels * std::max(std::abs(a), std::abs(b));
}

TEST(PublishedMeasurements, AreThePageOfTheDocumentation) {
  std::ifstream page(test::source_path("docs/measurements.md"));
  std::stringstream text;
  text << page.rdbuf();
  const std::vector<std::string> found = words_of(text.str()), expected = words_of(experiments::measurements_report());
  ASSERT_EQ(found.size(), expected.size()) << "write it with hapticut validate --measurements docs/measurements.md";
  for (std::size_t n = 0; n < found.size(); ++n)
    EXPECT_TRUE(alike(found[n], expected[n])) << found[n] << " on the page, computed " << expected[n];
}

TEST(PublishedMeasurements, ArePredictedWithinAFactorOfTwoInTheMedian) {
  const experiments::PublishedSummary summary = experiments::summary_of_published();
  EXPECT_GE(summary.rows, 10);
  EXPECT_LE(summary.median, 2.0);
  EXPECT_GE(2 * summary.within_two, summary.rows);
  EXPECT_GE(2 * summary.bracketed, summary.rows) << "between a new and a worn cutter";
  EXPECT_GE(2 * summary.allowed, summary.rows) << "between the ends of the ranges";
}

TEST(PublishedMeasurements, HaveASourceAndAConditionEach) {
  for (const experiments::PublishedRow& row : experiments::published_rows()) {
    EXPECT_FALSE(row.conditions.empty() || row.source.empty() || row.quantity.empty());
    EXPECT_GT(experiments::prediction_of(row).typical, 0) << row.conditions;
    EXPECT_FALSE(row.fitted && !row.beyond.empty()) << row.conditions << ": a fit cannot use it";
  }
}

TEST(PublishedTemperatures, ArePredictedWithinAFactorOfTwo) {
  for (const experiments::HeatRow& row : experiments::heat_rows()) EXPECT_LE(row.factor(), 2) << row.conditions;
}

/// The closed forms of the page are those of the simulation: a drill with a point, fed through bone.
TEST(PublishedMeasurements, AreWhatTheSimulationGives) {
  constexpr double kDiameter = 3.2 * mm, kSpeed = 400 * rpm, kFeed = 50.0 / 60 * mm;
  const Material bone = presets::cortical_bone(CutterKind::twist_drill);
  Simulation simulation(build_block({Vec3(-2.11, -2.07, -4.013) * mm, Vec3(2.09, 2.13, 0) * mm}, 0.1 * mm, bone),
                        Tool(twist_drill_head(kDiameter, 12 * mm), RayHandle{0}, Spindle{kSpeed * units::rad_per_s},
                             Cutter{CutterKind::twist_drill}),
                        {});
  const test::SteadyState steady =
      test::feed(simulation, Vec3(0.0293, 0.0113, 0) * mm, Vec3(0, 0, -kFeed), 2.5 * mm, 2e-3, 0.8);
  for (const experiments::PublishedRow& row : experiments::published_rows()) {
    if (row.conditions != "bovine tibia, 3.2 mm, 400 rpm, 50 mm/min") continue;
    const double predicted = experiments::prediction_of(row).typical;
    const double simulated = row.quantity == "thrust [N]" ? steady.force.z() : -steady.torque.z() / units::N_mm;
    EXPECT_NEAR(simulated, predicted, 0.05 * predicted) << row.quantity;
  }
}

}  // namespace
}  // namespace hapticut::published_test
