// SPDX-License-Identifier: Apache-2.0
// The motor: its torque, its power, and what a limit of it does to the cut.
#include <gtest/gtest.h>

#include "hapticut/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/cutting.hpp"

namespace hapticut::spindle_test {
namespace {

using test::plain_material;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
constexpr double kSpin = 2000;    // [rad/s]

constexpr double kRipple = 0.02;   // [1] of a power that voxels of a layer make ripple
constexpr double kClosure = 1e-4;  // [1] of the ledger (docs/model.md, accuracy)

/// A flat head fed axially needs u pi R^2 v_f in all, whatever its speed.
double power_needed() {
  const Material m = plain_material();
  return closed_forms::cutting_power({m.specific_cutting_energy, m.cutting_ratio, kSpin, kFeed},
                                     kPi * kRadius * kRadius * kFeed);
}

Simulation axial_cut(double power_limit) {
  SimulationConfig config;
  config.reference_stiffness = 1e14;
  return Simulation(build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
                    Tool(FlatHead{kRadius, 4 * mm}, RayHandle{0}, Spindle{kSpin * units::rad_per_s, power_limit}),
                    config);
}

const StepResult& plunge(Simulation& simulation, int tick) {
  const Vec3 tip(0.029 * mm, 0.011 * mm, -kFeed * 1e-3 * (tick + 1));
  return simulation.step(Pose::from_translation(tip), {Vec3(0, 0, -kFeed), Vec3::Zero()}, 1e-3);
}

TEST(Spindle, WithoutALimitItKeepsItsSpeedAndDeliversThePowerOfTheCut) {
  Simulation simulation = axial_cut(std::numeric_limits<double>::infinity());
  double power = 0;
  for (int tick = 0; tick < 800; ++tick) {
    const StepResult& result = plunge(simulation, tick);
    EXPECT_EQ(result.spindle.speed, kSpin);
    EXPECT_FALSE(has_any(result.status, StepStatus::power_limited));
    if (tick >= 400) power += result.spindle.torque * result.spindle.speed / 400;
  }
  EXPECT_NEAR(power / power_needed(), 1, kRipple);
}

// Proves: power limit.
TEST(Spindle, APowerLimitSlowsItDownAndTheWorkStaysWithinIt) {
  const double limit = 0.5 * power_needed();
  Simulation simulation = axial_cut(limit);
  StepStatus status = StepStatus::ok;
  double slowest = kSpin;
  const int ticks = 500;
  for (int tick = 0; tick < ticks; ++tick) {
    const StepResult& result = plunge(simulation, tick);
    status |= result.status;
    slowest = std::min(slowest, result.spindle.speed);
    EXPECT_GT(result.spindle.speed, 0);
  }
  EXPECT_TRUE(has_any(status, StepStatus::power_limited));
  EXPECT_LT(slowest, 0.5 * kSpin);
  EXPECT_LT(simulation.last_result().energy.motor_work, 1.003 * limit * ticks * 1e-3);
  EXPECT_LT(test::unbooked(simulation.last_result().energy), kClosure);
}

TEST(Spindle, RecoversItsSpeedWhenTheToolIsLifted) {
  Simulation simulation = axial_cut(0.5 * power_needed());
  for (int tick = 0; tick < 300; ++tick) (void)plunge(simulation, tick);
  EXPECT_LT(simulation.last_result().spindle.speed, kSpin);
  double z = -kFeed * 0.3;
  for (int tick = 0; tick < 400; ++tick) {
    z += 4 * mm * 1e-3;
    (void)simulation.step(Pose::from_translation(Vec3(0.029 * mm, 0.011 * mm, z)), {Vec3(0, 0, 4 * mm), Vec3::Zero()},
                          1e-3);
  }
  EXPECT_EQ(simulation.last_result().spindle.speed, kSpin);
}

TEST(Spindle, StandingItCutsNothingAndNeedsNoTorque) {
  Simulation simulation = axial_cut(1.0);
  simulation.set_spindle_speed(0);
  for (int tick = 0; tick < 100; ++tick) (void)plunge(simulation, tick);
  const StepResult& result = simulation.last_result();
  EXPECT_GT(result.force.z(), 0);
  EXPECT_EQ(result.energy.cutting, 0);
  EXPECT_EQ(result.energy.motor_work, 0);
}

// `Tool(head)` has a spindle that stands, and presses without a word.
TEST(Spindle, OfAToolThatHasNoSpeedIsToldWhereItTouchesWhatCouldBeCut) {
  const auto pressed = [](const Spindle& spindle, RemovalLaw removal, double depth) {
    SimulationConfig config;
    config.removal = removal;
    Simulation simulation(build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
                          Tool(SphereHead{0.5 * mm}, RayHandle{0}, spindle), config);
    return simulation.step(Pose::from_translation(Vec3(0, 0, 0.5 * mm - depth)), {}, 1e-3).status;
  };
  const RemovalLaw cuts = SimulationConfig{}.removal;
  EXPECT_EQ(describe(pressed({}, cuts, 0.05 * mm)), "spindle_stands");
  EXPECT_EQ(sentences_of(pressed({}, cuts, 0.05 * mm)),
            "The spindle of this tool has no speed, so nothing is cut: give it one.");
  EXPECT_FALSE(has_any(pressed({}, cuts, -0.05 * mm), StepStatus::spindle_stands));
  EXPECT_FALSE(has_any(pressed({}, RemovalLaw::none, 0.05 * mm), StepStatus::spindle_stands));
  EXPECT_FALSE(has_any(pressed(Spindle{kSpin * units::rad_per_s}, cuts, 0.05 * mm), StepStatus::spindle_stands));
}

TEST(Spindle, ThatTurnsAnotherCutterThanMaterialsAreMadeForIsTold) {
  using enum CutterKind;
  const auto tool = [](const Cutter& cutter, double speed = kSpin) {
    return Tool(SphereHead{0.5 * mm}, RayHandle{0}, Spindle{speed * units::rad_per_s}, cutter);
  };
  const auto block = [](const Material& material) {
    return build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, material);
  };
  Simulation simulation(block(presets::dentin()), tool({}));
  const auto is_told = [&](double depth = 0.05 * mm) {
    const StepStatus status = simulation.step(Pose::from_translation(Vec3(0, 0, 0.5 * mm - depth)), {}, 1e-3).status;
    return has_any(status, StepStatus::other_cutter);
  };
  const auto start_again = [&](const Material& material, const Tool& with) {
    simulation = Simulation(block(material), with);
  };
  EXPECT_FALSE(is_told());
  start_again(presets::dentin(), tool(Cutter{coarse_diamond}));
  EXPECT_TRUE(is_told());
  (void)is_told(-0.05 * mm);  // on its way out it still touches
  EXPECT_FALSE(is_told(-0.05 * mm)) << "in the air";
  start_again(presets::dentin(), tool(Cutter{coarse_diamond}, 0));
  EXPECT_FALSE(is_told()) << "standing it cuts nothing";
  start_again(presets::dentin(coarse_diamond), tool(Cutter{coarse_diamond}));
  EXPECT_FALSE(is_told());
  start_again(plain_material(), tool(Cutter{twist_drill}));
  EXPECT_FALSE(is_told()) << "constants of one's own";
  start_again(presets::clay(), tool(Cutter{twist_drill}));
  EXPECT_FALSE(is_told()) << "as every cutter meets it";

  start_again(presets::dentin(), tool({}));
  simulation.set_tool(tool(Cutter{twist_drill}));
  (void)is_told(-0.1 * mm);
  EXPECT_TRUE(is_told());
  simulation.set_materials(MaterialTable({presets::dentin(twist_drill)}));
  (void)is_told(-0.1 * mm);
  EXPECT_FALSE(is_told());
}

TEST(Spindle, TheHandFeelsTheMotorsReaction) {
  Simulation simulation = axial_cut(std::numeric_limits<double>::infinity());
  for (int tick = 0; tick < 400; ++tick) (void)plunge(simulation, tick);
  const StepResult& result = simulation.last_result();
  EXPECT_NEAR(result.torque.z(), -result.spindle.torque, 1e-12);
}

// A ball pushed at 20 mm/s, held, and drawn out slowly: a turbine stalls, stays so while it is held, and runs again.
// Proves: droop.
TEST(Spindle, OfAnAirTurbineStallsUnderAPushAndRunsAgainWhenTheHandYields) {
  for (const double inertia : {0.0, 1e-10})
    for (const double sign : {1.0, -1.0})
      for (const double dt : {1e-3, 2.5e-4}) {
        Spindle spindle{sign * 300e3 * units::rpm};
        spindle.droop = std::abs(spindle.speed) / (0.2 * units::N_mm);
        spindle.rotor_inertia = inertia;
        Simulation simulation(
            build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
            Tool(SphereHead{kRadius}, RayHandle{0}, spindle));
        const double most_power = 0.25 * spindle.speed * spindle.speed / spindle.droop;
        double z = kRadius, most = 0, work_before_hold = 0, turned = 0, largest_jump = 0, before = 0;
        int changes = 0;
        bool stalled = false, stalled_while_held = true;
        StepStatus seen = StepStatus::ok;
        const int ticks = int(std::lround(0.7 / dt));
        for (int n = 0; n < ticks; ++n) {
          const double time = n * dt;
          const double feed = time < 0.03 ? -20 * mm : time < 0.2 ? 0 : 2 * mm;
          z += feed * dt;
          const StepResult& result = simulation.step(Pose::from_translation(Vec3(0.029 * mm, 0.011 * mm, z)),
                                                     {Vec3(0, 0, feed), Vec3::Zero()}, dt);
          seen |= result.status;
          most = std::max(most, result.spindle.torque * result.spindle.speed / most_power);
          if (time < 0.03) work_before_hold = result.energy.motor_work;
          const bool stalls = has_any(result.status, StepStatus::spindle_stalled);
          if (stalls) {
            EXPECT_EQ(result.spindle.speed, 0);
            EXPECT_EQ(result.removed_volume, 0);
            EXPECT_LE(std::abs(result.spindle.torque), 0.204 * units::N_mm);
            EXPECT_GT(sign * result.spindle.torque, 0) << "it pushes on the way that it cannot turn";
          }
          if (time > 0.05 && time < 0.2) stalled_while_held &= stalls;
          changes += stalls != stalled;
          stalled = stalls;
          if (time > 0.031 && time < 0.199) largest_jump = std::max(largest_jump, std::abs(result.force.z() - before));
          before = result.force.z();
          turned = result.spindle.speed;
        }
        if (inertia == 0) {
          EXPECT_LT(most, 1.02);
        }
        EXPECT_LT(work_before_hold, most_power * 0.03 + 0.5 * inertia * spindle.speed * spindle.speed);
        EXPECT_TRUE(stalled_while_held);
        EXPECT_EQ(changes, 2) << "it does not alternate";
        EXPECT_LT(largest_jump, 0.01) << "[N] while it is held";
        EXPECT_NEAR(turned, spindle.speed, 1e-6 * kSpin);
        EXPECT_LT(test::unbooked(simulation.last_result().energy), kClosure);
        EXPECT_TRUE(has_any(seen, StepStatus::spindle_stalled));
      }
}

// The friction of a head that may roll under its motor bears nothing about the axis: a ball that lies in bone.
TEST(Spindle, StalledAndRubbedAlongItsSideHasTheTorqueOfTheMotorAlone) {
  for (const double sign : {1.0, -1.0}) {
    const Spindle turbine = common_spindle(MotorKind::air_turbine, sign * 100e3 * units::rpm);
    Simulation simulation(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, presets::cortical_bone()),
                          Tool(SphereHead{kRadius}, RayHandle{0}, turbine));
    const Mat3 lying = rotation_from_vector(Vec3(0, 0.5 * kPi, 0));
    Vec3 place(0.013 * mm, 0.007 * mm, kRadius);
    int stalled = 0;
    for (int n = 0; n < 400; ++n) {
      const Vec3 feed = n < 100 ? Vec3(0, 0, -5e-3) : Vec3(0, 5e-4, -5e-4);
      place += 1e-3 * feed;
      const StepResult& result = simulation.step({lying, place}, {feed, Vec3::Zero()}, 1e-3);
      if (!has_any(result.status, StepStatus::spindle_stalled)) continue;
      ++stalled;
      EXPECT_LT(sign * result.spindle.torque, 1.02 * 1.5 * units::N_mm) << n;
    }
    EXPECT_GT(stalled, 100);
    EXPECT_LT(test::unbooked(simulation.last_result().energy), kClosure);
  }
}

// Proves: ramp.
TEST(Spindle, RampsToANewSettingWhenItHasAnAccelerationLimit) {
  Simulation simulation(
      build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, 0.1 * mm, plain_material()),
      Tool(FlatHead{kRadius, 4 * mm}, RayHandle{0}, Spindle{0, std::numeric_limits<double>::infinity(), 1e5}));
  simulation.set_spindle_speed(kSpin * units::rad_per_s);
  double before = 0;
  for (int tick = 0; tick <= 20; ++tick) {
    const StepResult& result = simulation.step(Pose::from_translation(Vec3(0, 0, 1 * mm)), {}, 1e-3);
    EXPECT_NEAR(result.spindle.speed, 100.0 * tick, 1e-9);
    EXPECT_FALSE(has_any(result.status, StepStatus::power_limited)) << "a ramp is no load";
    EXPECT_GE(result.spindle.speed, before);
    before = result.spindle.speed;
  }
  EXPECT_THROW(simulation.set_spindle_speed(std::nan("") * units::rad_per_s), Error);
  EXPECT_EQ(simulation.step(Pose::from_translation(Vec3(0, 0, 1 * mm)), {}, 1e-3).spindle.speed, kSpin);
}

}  // namespace
}  // namespace hapticut::spindle_test
