// SPDX-License-Identifier: Apache-2.0
// Constants from drilling tests: the fit recovers the constants that generated
// tests, and explains published tests.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"
#include "hapticut/workpiece/preset_constants.hpp"
#include "support/calibration_advice.hpp"
#include "support/generators.hpp"

namespace hapticut::calibration_test {
namespace {

using test::expect_no_sentence;
using test::expect_sentence;
using test::number_between;
using units::mm;
using units::N_mm;
using units::rpm;

constexpr double kSearched = 1e-6;  // [1] log(kappa) is searched to 1e-12; the sum of squares is flat within 1e-8
constexpr double kNoNoise = 1e-4;   // [1] residual of a search over all kappa for tests that fit exactly

constexpr AngularSpeed kSpeed = 100 * units::rad_per_s;
constexpr ChipTerm kPressure = ChipTerm::edge_pressure;

/// The row of the presets.
const PresetConstant& preset(const char* of, const char* number) { return *find_constant(of, number); }
const PresetConstant &drill_edge = preset("twist_drill", "edge_length"),
                     &drill_ratio = preset("twist_drill", "cutting_ratio"),
                     &blade_size = preset("carbide_bur", "size_length");

DrillingTest made_by(const Calibration& constants, double radius, AngularSpeed speed, double feed) {
  const AxialCutForce force = axial_cut_force(constants, radius, speed, feed);
  return {radius, speed, feed, force.thrust, force.torque};
}

RC_GTEST_PROP(Calibration, ReturnsTheConstantsThatMadeTheTests, ()) {
  Calibration made;
  made.specific_cutting_energy = *number_between(5e7, 2e9);
  made.cutting_ratio = *number_between(0.2, 6);
  made.edge_pressure = *number_between(0, 5e6);
  std::vector<DrillingTest> tests;
  for (int n = 0; n < 6; ++n)
    tests.push_back(made_by(made, *number_between(0.5, 2) * mm, *number_between(200, 5000) * units::rad_per_s,
                            *number_between(0.2, 5) * mm * (n + 1)));
  const Calibration found = calibrate(tests, ChipTerm::edge_pressure);
  RC_PRE(found.edge_identified);  // six random feeds per revolution rarely agree within a twentieth
  RC_ASSERT(found.thrust_residual < kNoNoise);
  RC_ASSERT(found.torque_residual < kNoNoise);
  // If edge or chip is a small part of every test, the tests determine only the other.
  for (const DrillingTest& t : tests) {
    const AxialCutForce again = axial_cut_force(found, t.radius, t.spindle_speed, t.feed_speed);
    RC_ASSERT(std::abs(again.thrust / t.thrust - 1) < 10 * kNoNoise);
    RC_ASSERT(std::abs(again.torque / t.torque - 1) < 10 * kNoNoise);
  }
}

// Without noise, two feeds or two speeds determine the part of an edge or of thin chips, from thrust and torque or from
// one of them.
RC_GTEST_PROP(Calibration, ReturnsTheLengthsOfChipsThatMadeTheTests, ()) {
  const ChipTerm term = *rc::gen::element(ChipTerm::edge_length, ChipTerm::size_length);
  Calibration made;
  made.specific_cutting_energy = *number_between(5e7, 2e9);
  made.cutting_ratio = *number_between(0.2, 6);
  (term == ChipTerm::edge_length ? made.edge_length : made.size_length) = *number_between(5, 50) * 1e-6;
  const bool by_speed = *rc::gen::arbitrary<bool>();
  const int missing = *rc::gen::inRange(0, 3);  // nothing, thrust, torque
  std::vector<DrillingTest> tests;
  for (const double factor : {0.5, 1.0, 2.0}) {
    tests.push_back(by_speed ? made_by(made, 1 * mm, factor * kSpeed, 1 * mm)
                             : made_by(made, 1 * mm, kSpeed, factor * mm));
    if (missing == 1) tests.back().thrust = 0;
    if (missing == 2) tests.back().torque = 0;
  }
  const Calibration found = calibrate(tests, term);
  RC_ASSERT(found.edge_identified && found.chip_identified);
  RC_ASSERT(found.ratio_identified == (missing == 0));
  const double ratio = missing == 2 ? made.cutting_ratio / drill_ratio.typical : 1;  // thrusts determine only u/kappa
  RC_ASSERT(std::abs(found.specific_cutting_energy / made.specific_cutting_energy * ratio - 1) < kNoNoise);
  RC_ASSERT(std::abs(found.edge_length - made.edge_length) <= kNoNoise * made.edge_length);
  RC_ASSERT(std::abs(found.size_length - made.size_length) <= 2 * kNoNoise * made.size_length);
}

// One condition: u = M omega/(pi R^2 V), kappa = 2 M/(R F). Bovine bone, a 2.5 mm drill at 1000 rpm (Orelaja
// et al. 2020: 20.07 N, 41.2 N mm); the feed is not in the table, so u is given per mm/s of it.
TEST(Calibration, OfOneTestIsItsClosedFormAndSaysThatTheEdgeIsNotIdentified) {
  const double R = 1.25 * mm, feed = 1 * mm, thrust = 20.07, torque = 41.2 * N_mm;
  const AngularSpeed speed = 1000 * rpm;
  const DrillingTest bovine{R, speed, feed, thrust, torque};
  for (const ChipTerm term : {ChipTerm::edge_length, ChipTerm::size_length, kPressure}) {
    const Calibration c = calibrate({&bovine, 1}, term);
    const bool assumed = term == ChipTerm::edge_length;
    EXPECT_FALSE(c.edge_identified || c.checked);
    EXPECT_EQ(c.edge_assumed, assumed);
    EXPECT_EQ(c.edge_length, assumed ? drill_edge.typical : 0);
    EXPECT_EQ(c.edge_pressure + c.size_length, 0);
    EXPECT_NEAR(c.cutting_ratio / (2 * torque / (R * thrust)), 1, kSearched);
    const double as_speed = feed + c.edge_length * 2 * speed / (2 * units::kPi);  // two lips
    EXPECT_NEAR(c.specific_cutting_energy / (torque * speed / (units::kPi * R * R * as_speed)), 1, kSearched);
    EXPECT_LT(c.thrust_residual + c.torque_residual, kSearched);
  }
}

std::vector<DrillingTest> without_torque(std::vector<DrillingTest> tests) {
  for (DrillingTest& t : tests) t.torque = 0;
  return tests;
}

// Hillery: 3.2 mm, 50 mm/min, 48 N at 400 and 24 N at 2000 rpm.
TEST(Calibration, TakesTheOneEdgeThatFitsExactlyAndSaysThatNothingChecksIt) {
  const double R = 1.6 * mm, feed = 50.0 / 60 * mm;
  const Calibration c = calibrate(std::vector<DrillingTest>{{R, 400 * rpm, feed, 48, 0}, {R, 2000 * rpm, feed, 24, 0}});
  EXPECT_TRUE(c.edge_identified);
  EXPECT_FALSE(c.edge_assumed || c.checked);
  EXPECT_NEAR(c.edge_length, 37.5e-6, 1e-9);
  EXPECT_LT(c.thrust_residual, kSearched);
}

RC_GTEST_PROP(Calibration, TakesAnyTermThatFitsAsManyNumbersAsConstantsExactly, ()) {
  const ChipTerm term = *rc::gen::element(ChipTerm::edge_length, ChipTerm::size_length, ChipTerm::edge_pressure);
  Calibration made;
  made.specific_cutting_energy = *number_between(5e7, 2e9);
  made.cutting_ratio = *number_between(0.2, 6);
  if (term == ChipTerm::edge_length) made.edge_length = *number_between(5, 50) * 1e-6;
  if (term == ChipTerm::size_length) made.size_length = *number_between(5, 50) * 1e-6;
  if (term == ChipTerm::edge_pressure) made.edge_pressure = *number_between(1e5, 5e6);
  std::vector<DrillingTest> tests = {
      made_by(made, 1 * mm, kSpeed, 1 * mm),
      made_by(made, 1 * mm, *number_between(0.2, 0.6) * kSpeed, *number_between(0.8, 2) * mm)};
  const int missing = *rc::gen::inRange(0, 3);  // one torque, both, both thrusts
  tests[0].torque = missing == 2 ? tests[0].torque : 0;
  if (missing == 1) tests[1].torque = 0;
  if (missing == 2) tests[0].thrust = tests[1].thrust = 0;
  const Calibration c = calibrate(tests, term);
  RC_ASSERT(c.edge_identified && !c.edge_assumed && !c.checked);
  RC_ASSERT(c.thrust_residual < kNoNoise && c.torque_residual < kNoNoise);
  RC_ASSERT(std::abs(c.edge_length - made.edge_length) <= 0.01 * made.edge_length);
  tests.push_back(made_by(made, 1.2 * mm, 3 * kSpeed, 1 * mm));
  RC_ASSERT(calibrate(tests, term).checked);
}

TEST(Calibration, AssumesAnEdgeLengthWhereTheTestsDoNotTellIt) {
  const DrillingTest one{1 * mm, 1000 * rpm, 1 * mm, 20, 0}, same_chip{1.5 * mm, 2000 * rpm, 2 * mm, 32, 0},
      other_chip{1 * mm, 1000 * rpm, 3 * mm, 0, 40 * N_mm};
  for (const std::vector<DrillingTest>& tests :
       {std::vector{one}, std::vector{one, same_chip}, std::vector{one, other_chip},
        without_torque({{1 * mm, 1000 * rpm, 1 * mm, 20, 0}, {1 * mm, 1000 * rpm, 1.06 * mm, 20.5, 0}, same_chip})}) {
    const Calibration c = calibrate(tests);
    EXPECT_TRUE(c.edge_assumed);
    EXPECT_FALSE(c.edge_identified);
    EXPECT_EQ(c.edge_length, drill_edge.typical);
    EXPECT_GT(c.specific_cutting_energy, 0);
  }
}

// Thrusts nearly proportional to chips of a micrometre; with an edge of eighteen micrometres they would be nearly
// equal.
TEST(Calibration, DoesNotAssumeAnEdgeLengthThatTheTestsContradict) {
  const double feed = 0.5 * mm;
  const AngularSpeed speed = 10000 * rpm;
  const Calibration c = calibrate(std::vector<DrillingTest>{
      {1 * mm, speed, feed, 1.15, 0}, {1 * mm, speed, 2 * feed, 1.75, 0}, {1 * mm, speed, 4 * feed, 4.3, 0}});
  EXPECT_FALSE(c.edge_assumed);
  EXPECT_LT(c.edge_length, drill_edge.typical / 10);
  const Calibration steeper =
      calibrate(std::vector<DrillingTest>{{1 * mm, speed, feed, 1, 0}, {1 * mm, speed, 2 * feed, 3, 0}});
  EXPECT_FALSE(steeper.edge_identified || steeper.edge_assumed) << "more than proportional, which no edge can give";
}

/// Tests at these feeds of a drill in a material of u = 5e8 J/m^3, kappa = 3 and p_e = 1 MPa, with relative scatter of
/// thrust and torque.
struct Scattered {
  double feed, of_thrust, of_torque;
};
std::vector<DrillingTest> scattered(const std::vector<Scattered>& all) {
  Calibration made;
  made.specific_cutting_energy = 5e8;
  made.cutting_ratio = 3;
  made.edge_pressure = 1e6;
  std::vector<DrillingTest> tests;
  for (const Scattered& one : all) {
    tests.push_back(made_by(made, 1.25 * mm, 1000 * rpm, one.feed));
    tests.back().thrust *= 1 + one.of_thrust;
    tests.back().torque *= 1 + one.of_torque;
  }
  return tests;
}

TEST(Calibration, ClaimsAnEdgeOnlyWhereTheTestsDifferMoreThanTheyScatter) {
  const Calibration near = calibrate(scattered({{1 * mm, -0.02, -0.02}, {1.06 * mm, 0.02, 0.02}}), kPressure);
  EXPECT_FALSE(near.edge_identified) << "feeds that differ by 6 %, tests that scatter by 2 %";
  EXPECT_EQ(near.edge_pressure, 0);
  const Calibration far =
      calibrate(scattered({{0.2 * mm, 0.02, -0.02}, {1 * mm, -0.02, 0.02}, {2 * mm, 0.01, 0.01}}), kPressure);
  EXPECT_TRUE(far.edge_identified);
  EXPECT_TRUE(far.chip_identified);
  EXPECT_NEAR(far.edge_pressure / 1e6, 1, 0.05) << "about the scatter of the tests";
}

TEST(Calibration, SaysThatTheChipIsNotKnownWhereTheEdgeCarriesAll) {
  const Calibration c =
      calibrate(scattered({{0.001 * mm, 0.02, 0.01}, {0.003 * mm, -0.02, -0.01}, {0.002 * mm, 0.01, 0}}), kPressure);
  EXPECT_TRUE(c.edge_identified);
  EXPECT_FALSE(c.chip_identified);
  EXPECT_NEAR(c.edge_pressure / 1e6, 1, 0.05);
}

// A carbide bur of 0.84 mm with six lips at 250000 rpm: chips of 20 nm.
TEST(Calibration, AssumesTheSizeEffectOfBladesForTheThinChipsOfABur) {
  Calibration made;
  made.specific_cutting_energy = 1e8;
  made.cutting_ratio = 0.5;
  made.size_length = blade_size.typical;
  const double radius = 0.42 * mm, feed = 20e-9 * 6 * 250000.0 / 60;
  const AxialCutForce force = axial_cut_force(made, radius, 250000 * rpm, feed, 6);
  const Calibration c = calibrate(std::vector<DrillingTest>{{radius, 250000 * rpm, feed, force.thrust, 0, 6}});
  EXPECT_TRUE(c.size_assumed);
  EXPECT_FALSE(c.edge_assumed || c.edge_identified);
  EXPECT_EQ(c.edge_length, 0);
  EXPECT_EQ(c.size_length, blade_size.typical);
  EXPECT_NEAR(c.specific_cutting_energy / 1e8, 1, kSearched);
  expect_sentence(c, "0.02 um the chips are those of blades");
  // A chip of half a millimetre is hardly dearer for an edge, so none is assumed.
  const Calibration thick = calibrate(std::vector<DrillingTest>{{2 * mm, 60 * rpm, 1 * mm, 100, 0}});
  EXPECT_FALSE(thick.edge_assumed || thick.size_assumed);
  EXPECT_EQ(thick.edge_length, 0);
  expect_sentence(thick, "No edge was assumed: at feeds per lip below 500 um");
}

// Two tests of nearly equal chips that fit without an edge by chance.
TEST(Calibration, KeepsTheAssumedEdgeLengthWhereTwoTestsCannotTellIt) {
  const double feed = 1 * mm;
  const Calibration c = calibrate(std::vector<DrillingTest>{{1 * mm, 1000 * rpm, feed, 20, 4.5 * N_mm},
                                                            {1 * mm, 1000 * rpm, 1.08 * feed, 21.6, 4.86 * N_mm}});
  EXPECT_TRUE(c.edge_assumed);
  EXPECT_EQ(c.edge_length, drill_edge.typical);
  expect_sentence(c, "To separate edge and chip");
}

// Thrusts of drills in bovine bone: Hillery, Alam, Lee, Orelaja.
TEST(Calibration, SaysThatTestsContradictEachOther) {
  const double per_minute = mm / 60;
  const std::vector<DrillingTest> tests = {{1.6 * mm, 400 * rpm, 50 * per_minute, 48, 14.5 * N_mm},
                                           {1.6 * mm, 2000 * rpm, 50 * per_minute, 24, 10 * N_mm},
                                           {1.25 * mm, 1000 * rpm, 100 * per_minute, 20.07, 41.2 * N_mm},
                                           {2 * mm, 600 * rpm, 50 * per_minute, 85, 23 * N_mm},
                                           {1.6 * mm, 1000 * rpm, 120 * per_minute, 198, 186 * N_mm},
                                           {1.25 * mm, 1000 * rpm, 100 * per_minute, 5.6, 13.6 * N_mm}};
  const Calibration c = calibrate(tests);
  EXPECT_GT(c.worst_factor, 2);
  expect_sentence(c, "They contradict each other, or are not of one material and tool");
  const Calibration alone = calibrate(std::span(tests).first(2));
  EXPECT_LT(alone.worst_factor, 1.5);
  expect_no_sentence(alone, "contradict");
  expect_no_sentence(alone, "differ");
}

// Hillery and Alam: two laboratories.
TEST(Calibration, SaysThatAFactorOfTwoBetweenLaboratoriesIsUsual) {
  std::vector<DrillingTest> tests = test::drillings_of_hillery();
  tests.push_back({2 * mm, 600 * rpm, 50.0 / 60 * mm, 85, 23 * N_mm});
  tests.push_back({2 * mm, 3000 * rpm, 10.0 / 60 * mm, 25, 10 * N_mm});
  const Calibration c = calibrate(tests);
  EXPECT_NEAR(c.worst_factor, 1.64, 0.01);
  expect_sentence(c, "differ by a factor of up to 1.64. Up to 2 is usual between laboratories");
  expect_no_sentence(c, "contradict");
  expect_no_sentence(c, "outside");
}

TEST(Calibration, NamesTheTermThatDescribesTheTests) {
  Calibration drill;
  drill.specific_cutting_energy = 7e7;
  drill.cutting_ratio = 0.45;
  drill.edge_length = 60e-6;
  std::vector<DrillingTest> tests;
  for (const double feed : {0.05, 0.2, 1.0, 4.0, 12.0}) tests.push_back(made_by(drill, 1 * mm, 1000 * rpm, feed * mm));
  tests[1].thrust *= 1.05, tests[3].thrust *= 0.95;
  const Calibration c = calibrate(tests, ChipTerm::size_length);
  ASSERT_TRUE(c.better_term.has_value());
  EXPECT_EQ(*c.better_term, ChipTerm::edge_length);
  expect_sentence(c, "edge_length describes these tests better than size_length");
  EXPECT_FALSE(calibrate(tests).better_term.has_value());
}

TEST(Calibration, SaysThatALengthOfNanometresIsNoEdge) {
  Calibration made;
  made.specific_cutting_energy = 5e10;
  made.cutting_ratio = 0.5;
  made.edge_length = 8e-9;
  std::vector<DrillingTest> tests;
  for (const double feed : {0.2, 0.5}) {
    const AxialCutForce force = axial_cut_force(made, 0.42 * mm, 250000 * rpm, feed * mm, 6);
    tests.push_back({0.42 * mm, 250000 * rpm, feed * mm, force.thrust, force.torque, 6});
  }
  const Calibration c = calibrate(tests, ChipTerm::edge_length);
  EXPECT_TRUE(c.edge_identified);
  EXPECT_NEAR(c.edge_length / 8e-9, 1, 0.01);
  expect_sentence(c, "0.008 um is right for these tests, but it is not the edge of a tool");
  expect_sentence(c, "so fit size_length");
}

// B8, B15, DC8: thrust and torque rise with feed and diameter; force falls with speed.
TEST(Calibration, PredictsTheTrendsThatOthersMeasured) {
  const DrillingTest bovine{1.25 * mm, 1000 * rpm, 1 * mm, 20.07, 41.2 * N_mm};
  Calibration c = calibrate({&bovine, 1});
  c.edge_pressure = 1e6;
  const auto at = [&](double radius, double speed, double feed) {
    return axial_cut_force(c, radius, speed * units::rad_per_s, feed);
  };
  const AxialCutForce base = at(1.25 * mm, 100, 1 * mm);
  EXPECT_GT(at(1.25 * mm, 100, 2 * mm).thrust, base.thrust);
  EXPECT_GT(at(1.25 * mm, 100, 2 * mm).torque, base.torque);
  EXPECT_GT(at(1.5 * mm, 100, 1 * mm).thrust, base.thrust);
  EXPECT_GT(at(1.5 * mm, 100, 1 * mm).torque, base.torque);
  EXPECT_LT(at(1.25 * mm, 200, 1 * mm).thrust, base.thrust);
  EXPECT_LT(at(1.25 * mm, 200, 1 * mm).torque, base.torque);
  // The energy per volume, F v + M omega over pi R^2 v, falls with the chip, because the cost of the edge is constant.
  const auto energy = [&](double feed) {
    const AxialCutForce f = at(1.25 * mm, 100, feed);
    return (f.thrust * feed + f.torque * 100) / feed;
  };
  EXPECT_LT(energy(2 * mm), energy(1 * mm));
}

TEST(CalibrationInput, OutOfRangeIsRefusedByName) {
  EXPECT_THROW((void)calibrate({}), Error);
  const DrillingTest in_mm_per_s{1 * mm, kSpeed, 1, 10, 0}, in_mm{1, kSpeed, 1 * mm, 10, 0};
  EXPECT_THROW((void)calibrate({&in_mm_per_s, 1}), Error);
  EXPECT_THROW((void)calibrate({&in_mm, 1}), Error);
  const DrillingTest bad{1 * mm, kSpeed, 1 * mm, 10, -1};
  test::expect_refused([&] { (void)calibrate({&bad, 1}); }, {"DrillingTest::torque [N m]"});
}

TEST(CalibrationInput, ThatNoCuttingRatioExplainsIsRefusedWithThatOfThePresets) {
  const DrillingTest wrong{1.25 * mm, 1000 * rpm, 1 * mm, 20, 41.2 * N_mm * 1e6};
  test::expect_refused(
      [&] {
        (void)calibrate({&wrong, 1});
      },
      {"no cutting ratio between 0.001 and 1000 explains",
       "twist_drill have " + format_number(drill_ratio.low) + " to " + format_number(drill_ratio.high)});
}

TEST(CalibrationInput, AFeedThatNoDrillHasIsRefused) {
  const auto with = [](const auto& change) {
    std::vector<DrillingTest> tests = test::drillings_of_hillery();
    change(tests[1] = tests[0]);
    return tests;
  };
  for (const std::vector<DrillingTest>& tests :
       {with([](DrillingTest& t) { t.feed_speed *= 60; }), with([](DrillingTest& t) { t.spindle_speed = 6.67 * rpm; }),
        with([](DrillingTest& t) { t.radius *= 1e-3; }), with([](DrillingTest& t) { t.feed_speed = 1e-300; })})
    test::expect_refused(
        [&] { (void)calibrate(tests); },
        {"drilling test 2 has a feed of ", "must be from 1e-06 mm to the diameter of the tool", "Check"});
}

}  // namespace
}  // namespace hapticut::calibration_test
