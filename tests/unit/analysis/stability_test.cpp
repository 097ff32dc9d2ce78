// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/stability.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "analysis/wall_table.hpp"
#include "hapticut/core/errors.hpp"
#include "support/refusal.hpp"

namespace hapticut::stability_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPeriod = 1e-3;           // [s]
constexpr double kClosedForm = 0.02;       // relative; the integration is exact, the search is not
constexpr double kTable = 0.05;            // relative; the table is rounded and comes from another program
constexpr double kRestitution = 0.01;      // [1] the table has three digits and uses other entry phases
constexpr double kRestitutionNoise = 0.1;  // [1] with dry friction and encoder it depends on the entry phase

ClosedLoopConfig loop_of(std::string_view device, std::string_view hand, int delay = 0) {
  ClosedLoopConfig config;
  config.device = device_model(device);
  config.hand = hand_model(hand);
  config.delay = delay;
  return config;
}

ModelFactory wall(double damping = 0, double filter = 0, bool one_sided = true) {
  return [=](double stiffness) {
    LinearWall w;
    w.stiffness = stiffness;
    w.damping = damping;
    w.filter = filter;
    w.one_sided = one_sided;
    return ForceModel(w);
  };
}

ModelFactory linear_wall(double damping = 0, double filter = 0) { return wall(damping, filter, false); }

void expect_near_relative(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(value / expected, 1, tolerance) << what << ": " << value << " instead of " << expected;
}

TEST(StabilityLimit, OfAReleasedDeviceWithoutDelayIsTwiceItsDampingByThePeriod) {
  for (const DeviceModel& device : device_models()) {
    const double limit = max_stable_stiffness(loop_of(device.name, "released"), linear_wall());
    expect_near_relative(limit, 2 * device.damping / kPeriod, kClosedForm, std::string(device.name));
  }
}

TEST(StabilityLimit, OfDevicesInHandsIsThatOfTheTable) {
  for (const WallRow& row : kWallTable)
    for (int delay = 0; delay < kWallDelays; ++delay)
      expect_near_relative(max_stable_stiffness(loop_of(row.device, row.hand, delay), linear_wall()),
                           row.max_stiffness[std::size_t(delay)], kTable,
                           std::string(row.device) + ", " + std::string(row.hand) + ", delay " + std::to_string(delay));
}

TEST(StabilityLimit, WithSoftwareDampingIsThatOfTheTable) {
  struct Row {
    double damping;
    std::array<double, 3> without_delay, with_delay;  // no filter, 100 Hz, 50 Hz
  };
  const std::array<double, 3> filters = {0, 100, 50};
  for (const Row& row : std::initializer_list<Row>{{1, {2349, 2098, 1720}, {781, 737, 658}},
                                                   {2, {4212, 3447, 2574}, {1396, 1247, 1029}},
                                                   {5, {9315, 6331, 4160}, {3040, 2353, 1678}},
                                                   {20, {25757, 11682, 6611}, {6588, 2891, 1545}}})
    for (std::size_t f = 0; f < 3; ++f) {
      const std::string what = "B = " + std::to_string(row.damping) + ", filter " + std::to_string(filters[f]);
      const ModelFactory model = linear_wall(row.damping, filters[f]);
      expect_near_relative(max_stable_stiffness(loop_of("touch", "released", 0), model), row.without_delay[f], kTable,
                           what);
      expect_near_relative(max_stable_stiffness(loop_of("touch", "released", 1), model), row.with_delay[f], kTable,
                           what + ", delay 1");
    }
  EXPECT_EQ(max_stable_stiffness(loop_of("touch", "released", 1), linear_wall(40)), 0)
      << "B = 40 N·s/m with a delay is unstable at any stiffness";
}

TEST(Bounce, GainsNoSpeedUpToTheStabilityLimitOfAReleasedDevice) {
  for (const DeviceModel& device : device_models())
    for (int delay = 0; delay < 3; ++delay) {
      const ClosedLoopConfig config = loop_of(device.name, "released", delay);
      const double limit = max_stable_stiffness(config, linear_wall());
      BounceTest test;
      test.time_limit = 4;
      for (const double fraction : {0.25, 0.5, 0.9, 0.98})
        EXPECT_LE(measure_bounce(config, wall(), fraction * limit, test).restitution, 1 + kRestitution)
            << device.name << ", delay " << delay << ", " << fraction << " of " << limit << " N/m";
    }
}

TEST(Bounce, ReturnsTheSpeedsOfTheTable) {
  struct Row {
    double stiffness;
    std::array<double, 2> by_delay;
  };
  for (const Row& row : std::initializer_list<Row>{{200, {0.949, 1.048}},
                                                   {400, {0.999, 1.146}},
                                                   {800, {1.051, 1.270}},
                                                   {1600, {1.112, 1.435}},
                                                   {3000, {1.182, 1.632}}})
    for (int delay = 0; delay < 2; ++delay) {
      ClosedLoopConfig config = loop_of("touch", "released", delay);
      config.saturation = true;
      EXPECT_NEAR(measure_bounce(config, wall(), row.stiffness).restitution, row.by_delay[std::size_t(delay)],
                  kRestitution)
          << row.stiffness << " N/m, delay " << delay;
    }
  const std::array<double, 3> dampings = {1, 2, 4};
  const std::array<double, 3> without_delay = {0.847, 0.694, 0.489};
  for (std::size_t n = 0; n < 3; ++n) {
    ClosedLoopConfig config = loop_of("touch", "released");
    config.saturation = true;
    EXPECT_NEAR(measure_bounce(config, wall(dampings[n], 100), 800).restitution, without_delay[n], kRestitution)
        << "B = " << dampings[n];
  }
}

TEST(Bounce, LosesSpeedToDryFrictionAsInTheTable) {
  struct Row {
    double stiffness;
    std::array<double, 2> by_delay;
  };
  for (const Row& row : std::initializer_list<Row>{{400, {0.23, 0.38}}, {800, {0.57, 0.75}}, {1600, {0.78, 1.05}}})
    for (int delay = 0; delay < 2; ++delay) {
      ClosedLoopConfig config = loop_of("touch", "released", delay);
      config.saturation = config.dry_friction = config.encoder = true;
      EXPECT_NEAR(measure_bounce(config, wall(), row.stiffness).restitution, row.by_delay[std::size_t(delay)],
                  kRestitutionNoise)
          << row.stiffness << " N/m, delay " << delay;
    }
}

// A force held over a tick does more work than a spring without delay. Device and hand dissipate the difference.
TEST(ClosedLoop, GeneratedEnergyIsTheChangeOfKineticEnergyAndOfWhatFrictionTook) {
  ClosedLoop loop(loop_of("touch", "released"));
  loop.reset(Pose::from_translation({0, 0, 0.5e-3}));
  loop.plant().set_velocity({0, 0, -0.1});
  const double before = loop.plant().kinetic_energy();
  const ForceModel model = wall()(700);
  for (int n = 0; n < 60; ++n) loop.tick(model);
  const double gained = loop.plant().kinetic_energy() - before;
  EXPECT_GT(loop.generated_energy(), 0);
  // Simpson's rule for b v^2 over ticks in which the speed decays by 0.4 %.
  EXPECT_NEAR(loop.generated_energy(), gained + loop.device_dissipation(), 1e-6 * before);
}

TEST(Press, BuzzesWhereTheTableSaysAndNotBelow) {
  for (const int delay : {0, 1}) {
    ClosedLoopConfig config = loop_of("touch", "nominal-pad", delay);
    config.saturation = config.dry_friction = config.encoder = true;
    for (const double stiffness : {500.0, 1000.0, 2000.0, 4000.0})
      EXPECT_FALSE(measure_buzz(config, wall(), stiffness).buzzes()) << stiffness << " N/m, delay " << delay;
  }
  ClosedLoopConfig config = loop_of("touch", "nominal-pad", 1);
  config.saturation = config.dry_friction = config.encoder = true;
  const Buzz buzz = measure_buzz(config, wall(), 6000);
  EXPECT_TRUE(buzz.buzzes());
  EXPECT_NEAR(buzz.position_rms, 439e-6, 0.1 * 439e-6);  // a limit cycle, sensitive to how friction is integrated
  EXPECT_NEAR(buzz.frequency, 50, 5);
  EXPECT_NEAR(buzz.force_peak_to_peak, 3.3, 0.01);  // from zero to the device's maximum
  EXPECT_GT(buzz.generated_power, 5e-3);
}

TEST(ClosedLoop, GivesTheSameBitsOnEveryRun) {
  const auto run = [] {
    ClosedLoopConfig config = loop_of("touch", "nominal-pad", 1);
    config.dry_friction = config.encoder = config.rotation = config.saturation = true;
    ClosedLoop loop(config);
    loop.plant().set_target(Pose::from_translation({1e-3, 0, -5e-3}));
    const ForceModel model = wall(1)(1500);
    for (int n = 0; n < 500; ++n) loop.tick(model);
    return loop.plant().pose().translation;
  };
  EXPECT_EQ(run(), run());
}

TEST(StabilitySearch, RefusesNumbersThatMakeNoSense) {
  const auto refused = [](auto member, double value, const std::string& part) {
    StabilitySearch search;
    search.*member = static_cast<std::remove_reference_t<decltype(search.*member)>>(value);
    test::expect_refused([&] { return max_stable_stiffness(loop_of("touch", "nominal"), linear_wall(), search); },
                         part);
  };
  refused(&StabilitySearch::tolerance, 1e-16, "StabilitySearch::tolerance [1] = 1e-16; must be between 1e-09 and 1.");
  refused(&StabilitySearch::windows, 0, "StabilitySearch::windows");
  for (const double value : {0.0, kNan, HUGE_VAL}) refused(&StabilitySearch::window, value, "StabilitySearch::window");
  for (const double value : {0.0, -1.0, kNan}) refused(&StabilitySearch::nudge, value, "StabilitySearch::nudge");
  for (const double value : {-1.0, kNan, HUGE_VAL}) refused(&StabilitySearch::settle, value, "StabilitySearch::settle");
  for (const double value : {-1.0, kNan}) refused(&StabilitySearch::forgotten, value, "StabilitySearch::forgotten");
  refused(&StabilitySearch::high, 2, "StabilitySearch::low = 5; must be below StabilitySearch::high = 2.");
}

TEST(ClosedLoop, IsNotMeasuredWithNumbersThatMakeNoSense) {
  const ClosedLoopConfig config = loop_of("touch", "nominal");
  test::expect_refused([&] { return is_stable(config, wall(), kNan); }, "the stiffness = nan");
  BounceTest bounce;
  for (double BounceTest::*member : {&BounceTest::height, &BounceTest::speed, &BounceTest::time_limit}) {
    bounce = {};
    bounce.*member = kNan;
    test::expect_refused([&] { return measure_bounce(config, wall(), 500, bounce); }, "BounceTest::");
  }
  for (double PressTest::*member : {&PressTest::height, &PressTest::depth, &PressTest::speed, &PressTest::approach,
                                    &PressTest::seconds, &PressTest::measured})
    for (const double value : {kNan, -HUGE_VAL}) {
      PressTest press;
      press.*member = value;
      test::expect_refused([&] { return measure_buzz(config, wall(), 500, press); }, "PressTest::");
    }
  ClosedLoop loop(config);
  test::expect_refused(
      [&] {
        loop.miss_tick(kNan);
        return 0;
      },
      "the scale of the last wrench = nan");
  test::expect_refused(
      [&] {
        loop.tick({});
        return 0;
      },
      "needs a force model");
}

TEST(ClosedLoop, RefusesAWrenchThatIsNotFinite) {
  const ModelFactory broken = [](double) {
    return ForceModel([](const DeviceState&) { return Wrench{Vec3(0, 0, kNan), Vec3::Zero()}; });
  };
  const ClosedLoopConfig config = loop_of("touch", "nominal");
  for (const auto& said : {test::refusal([&] { return is_stable(config, broken, 100); }),
                           test::refusal([&] { return measure_bounce(config, broken, 100); }),
                           test::refusal([&] { return measure_buzz(config, broken, 100); })})
    test::expect_part(said, "a force model must return finite numbers");
  // A loop that diverges during settling counts as unstable before its numbers overflow.
  StabilitySearch search;
  search.start = Pose::from_translation({0, 0, 1e-3});
  search.settle = 2;
  EXPECT_FALSE(is_stable(config, linear_wall(), 1e7, search));
}

TEST(DeviceModels, AreFoundByNameAndAnUnknownNameListsThem) {
  EXPECT_EQ(device_model("touch").peak_force, 3.3);
  EXPECT_EQ(capabilities(device_model("premium6dof")).output_degrees_of_freedom, 6);
  try {
    (void)hand_model("robot");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("nominal-pad"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace hapticut::stability_test
