// SPDX-License-Identifier: Apache-2.0
// Fitted constants beside the ranges of the presets: what is said about wrong units, and about what the tests of a bur
// do not tell.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"
#include "support/calibration_advice.hpp"

namespace hapticut::calibration_ranges_test {
namespace {

using test::drillings_of_hillery;
using test::expect_no_sentence;
using test::expect_sentence;
using units::mm;
using units::rpm;

template <class Change>
Calibration fit_of_changed(const Change& change) {
  std::vector<DrillingTest> tests = drillings_of_hillery();
  for (DrillingTest& t : tests) change(t);
  return calibrate(tests);
}

TEST(CalibrationRanges, AreThoseOfThePresetsOfTheCutter) {
  const Calibration drill = calibrate(drillings_of_hillery());
  EXPECT_EQ(drill.cutter, CutterKind::twist_drill);
  for (const char* number : {"specific_cutting_energy", "cutting_ratio", "edge_length"})
    EXPECT_EQ(presets_beside(drill, number), find_constant("twist_drill", number)) << number;
  EXPECT_EQ(presets_beside(drill, "size_length"), nullptr);
  const Calibration bur = calibrate(drillings_of_hillery(), {}, CutterKind::carbide_bur);
  EXPECT_EQ(presets_beside(bur, "size_length"), find_constant("carbide_bur", "size_length"));
  EXPECT_EQ(presets_beside(bur, "edge_length"), find_constant("twist_drill", "edge_length"));
}

TEST(CalibrationRanges, GoodTestsAreWithinThem) {
  const Calibration c = calibrate(drillings_of_hillery());
  const PresetConstant& edges = *presets_beside(c, "edge_length");
  ASSERT_GT(c.edge_length, edges.high) << "Hillery's drills were worn";
  expect_sentence(c, "The edge_length of 58.");
  expect_no_sentence(c, " \n");
  expect_no_sentence(c, "Warning");
  expect_no_sentence(c, "specific_cutting_energy");
  expect_no_sentence(c, "cutting_ratio");
}

TEST(CalibrationRanges, ADiameterForTheRadiusIsSlightlyOutside) {
  const Calibration c = fit_of_changed([](DrillingTest& t) { t.radius *= 2; });
  expect_sentence(
      c,
      "The specific_cutting_energy of 1.25e+07 J/m^3 is outside the presets' 3e+07 J/m^3 ... 1.3e+08 J/m^3 of "
      "twist_drill: check that the feed is per second, not per minute, that the radius is not the "
      "diameter");
  expect_sentence(c, "Softer materials have down to 0.025 times as much");
  expect_sentence(c, "The cutting_ratio of 0.222 is outside the presets' 0.3 ... 0.6 of twist_drill");
  expect_no_sentence(c, "Warning");
}

TEST(CalibrationRanges, AThrustInKilogramsIsFarOutside) {
  const Calibration c = fit_of_changed([](DrillingTest& t) { t.thrust /= 9.8; });
  expect_sentence(c,
                  "Warning: the cutting_ratio of 4.35 is far outside the presets' 0.3 ... 0.6 of twist_drill: check "
                  "the units of thrust and torque");
  expect_sentence(c, "in a deep hole whose chips clog");
}

// At these speeds the feed per revolution is less than the diameter.
TEST(CalibrationRanges, AnEdgeThatIsTooLongIsNoEdge) {
  const Calibration c = fit_of_changed([](DrillingTest& t) {
    t.feed_speed *= 60;
    t.spindle_speed = 5 * t.spindle_speed;
  });
  EXPECT_NEAR(c.edge_length, 704e-6, 5e-6);
  expect_sentence(c,
                  "Warning: an edge length of 704 um is right for these tests, but it is not the edge of a tool, which "
                  "has 6 um ... 45 um: check that the feed is per second, not per minute");
  expect_no_sentence(c, "size_length");
  expect_sentence(c, "Warning: the specific_cutting_energy of ");
}

/// A bur of 0.84 mm with six lips at 250000 rpm: chips of 11 ... 48 nm.
std::vector<DrillingTest> tests_of_a_bur() {
  constexpr double R = 0.42 * mm;
  return {{R, 250000 * rpm, 0.273 * mm, 0.98, 0, 6},
          {R, 250000 * rpm, 0.7 * mm, 2.0, 0, 6},
          {R, 250000 * rpm, 1.2 * mm, 3.0, 0, 6}};
}

TEST(CalibrationRanges, ThinChipsOfABurFixOnlyOneNumber) {
  const PresetConstant& size = *find_constant("carbide_bur", "size_length");
  for (const std::optional<ChipTerm> term : {std::optional<ChipTerm>(), std::optional(ChipTerm::size_length)}) {
    const Calibration c = calibrate(tests_of_a_bur(), term);
    EXPECT_EQ(c.cutter, CutterKind::carbide_bur);
    EXPECT_EQ(c.term, ChipTerm::size_length);
    EXPECT_TRUE(c.size_assumed);
    EXPECT_FALSE(c.edge_identified || c.better_term);
    EXPECT_EQ(c.size_length, size.typical);
    EXPECT_EQ(c.edge_length, 0);
    // The force for u and h_s of the preset is that of the first test within a half.
    EXPECT_LT(std::abs(std::log(c.specific_cutting_energy / 1.5e8)), std::log(1.5));
    expect_sentence(c, "these tests fix only u sqrt(h_s) = ");
    expect_sentence(c, "the size length of the presets, 180 um, was assumed");
    expect_no_sentence(c, "Warning");
  }
}

TEST(CalibrationRanges, ThickerChipsOfABurTellTheSizeLength) {
  Calibration made;
  made.specific_cutting_energy = 1e8;
  made.cutting_ratio = 0.5;
  made.size_length = 90e-6;
  std::vector<DrillingTest> tests;
  for (const double feed : {1.0, 3.0, 10.0, 30.0}) {
    const AxialCutForce force = axial_cut_force(made, 1 * mm, 5000 * rpm, feed * mm, 8);
    tests.push_back({1 * mm, 5000 * rpm, feed * mm, force.thrust, force.torque, 8});
  }
  const Calibration c = calibrate(tests, {}, CutterKind::mastoid_cutting_bur);
  EXPECT_TRUE(c.edge_identified);
  EXPECT_FALSE(c.size_assumed);
  EXPECT_NEAR(c.size_length / made.size_length, 1, 0.01);
}

}  // namespace
}  // namespace hapticut::calibration_ranges_test
