// SPDX-License-Identifier: Apache-2.0
// The motor: its torque, its power, and the effect of its limits on the cut.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/material_presets.hpp"

namespace hapticut::spindle_test {
namespace {

using namespace test;
using units::kPi;
using units::mm;

constexpr double kClosure = 1e-4;  // [1] error of the ledger, with what entered

/// A flat head fed axially needs the power u pi R^2 v_f, whatever its speed.
double power_needed() {
  const Material m = plain_material();
  return closed_forms::cutting_power({m.specific_cutting_energy, m.cutting_ratio, kSpin, kFeed},
                                     kPi * kRadius * kRadius * kFeed);
}

Simulation axial_cut(double power_limit) {
  return Simulation(plain_block(1.3 * mm, 3 * mm),
                    Tool(FlatHead{kRadius, 4 * mm}, RayHandle{0}, Spindle{kSpin * units::rad_per_s, power_limit}),
                    on_foundation(1e14));
}

const StepResult& plunge(Simulation& simulation, int tick) {
  return step_to(simulation, Vec3(0.029 * mm, 0.011 * mm, -kFeed * kTick * (tick + 1)), Vec3(0, 0, -kFeed));
}

// Proves: power limit.
TEST(Spindle, APowerLimitSlowsItDownAndTheWorkStaysWithinIt) {
  const double limit = 0.5 * power_needed();
  Simulation simulation = axial_cut(limit);
  StepStatus status = StepStatus::ok;
  double min_speed = kSpin;
  const int ticks = 500;
  for (int tick = 0; tick < ticks; ++tick) {
    const StepResult& result = plunge(simulation, tick);
    status |= result.status;
    min_speed = std::min(min_speed, result.spindle.speed);
    EXPECT_GT(result.spindle.speed, 0);
  }
  EXPECT_TRUE(has_any(status, StepStatus::power_limited));
  EXPECT_LT(min_speed, 0.5 * kSpin);
  EXPECT_LT(simulation.last_result().energy.motor_work, 1.003 * limit * ticks * 1e-3);
  EXPECT_LT(unbooked(simulation.last_result().energy), kClosure);
}

// `Tool(head)` has a standing spindle, and cuts nothing.
TEST(Spindle, WithoutASpeedIsReportedWhenItTouchesMaterialThatCouldBeCut) {
  const auto status_of = [](const Spindle& spindle, RemovalLaw removal, double depth) {
    SimulationConfig config;
    config.removal = removal;
    Simulation simulation(plain_block(1.3 * mm, 3 * mm), Tool(SphereHead{0.5 * mm}, RayHandle{0}, spindle), config);
    return step_to(simulation, Vec3(0, 0, 0.5 * mm - depth)).status;
  };
  const RemovalLaw cuts = SimulationConfig{}.removal;
  EXPECT_EQ(describe(status_of({}, cuts, 0.05 * mm)), "spindle_stands");
  EXPECT_EQ(sentences_of(status_of({}, cuts, 0.05 * mm)),
            "The spindle of this tool has no speed, so nothing is cut: set a speed.");
  EXPECT_FALSE(has_any(status_of({}, cuts, -0.05 * mm), StepStatus::spindle_stands));
  EXPECT_FALSE(has_any(status_of({}, RemovalLaw::none, 0.05 * mm), StepStatus::spindle_stands));
  EXPECT_FALSE(has_any(status_of(Spindle{kSpin * units::rad_per_s}, cuts, 0.05 * mm), StepStatus::spindle_stands));
}

TEST(Spindle, WithACutterThatDoesNotSuitTheMaterialsIsReported) {
  using enum CutterKind;
  const auto tool = [](const Cutter& cutter, double speed = kSpin) {
    return Tool(SphereHead{0.5 * mm}, RayHandle{0}, Spindle{speed * units::rad_per_s}, cutter);
  };
  const auto block = [](const Material& material) {
    return build_block({Vec3(-1.3, -1.3, -3) * mm, Vec3(1.3, 1.3, 0) * mm}, kVoxel, material);
  };
  Simulation simulation(block(presets::dentin()), tool({}));
  const auto is_told = [&](double depth = 0.05 * mm) {
    return has_any(step_to(simulation, Vec3(0, 0, 0.5 * mm - depth)).status, StepStatus::other_cutter);
  };
  struct Case {
    const char* name;
    Material material;
    Tool with;
    bool told;
  };
  for (const Case& c : {Case{"the usual bur", presets::dentin(), tool({}), false},
                        Case{"standing it cuts nothing", presets::dentin(), tool(Cutter{coarse_diamond}, 0), false},
                        Case{"its own material", presets::dentin(coarse_diamond), tool(Cutter{coarse_diamond}), false},
                        Case{"custom constants", plain_material(), tool(Cutter{twist_drill}), false},
                        Case{"as every cutter meets it", presets::clay(), tool(Cutter{twist_drill}), false},
                        Case{"another cutter", presets::dentin(), tool(Cutter{coarse_diamond}), true}}) {
    simulation = Simulation(block(c.material), c.with);
    EXPECT_EQ(is_told(), c.told) << c.name;
  }
  (void)is_told(-0.05 * mm);  // on the way out it still touches
  EXPECT_FALSE(is_told(-0.05 * mm)) << "in the air";

  simulation = Simulation(block(presets::dentin()), tool({}));
  simulation.set(tool(Cutter{twist_drill}));
  (void)is_told(-0.1 * mm);
  EXPECT_TRUE(is_told());
  simulation.set(MaterialTable({presets::dentin(twist_drill)}));
  (void)is_told(-0.1 * mm);
  EXPECT_FALSE(is_told());
}

// A ball pushed in at 20 mm/s, held, and drawn out slowly: a turbine stalls, stays stalled, and starts again.
// Proves: droop.
TEST(Spindle, OfAnAirTurbineStallsUnderAPushAndRunsAgainWhenTheHandYields) {
  for (const double inertia : {0.0, 1e-10})
    for (const double sign : {1.0, -1.0})
      for (const double dt : {1e-3, 2.5e-4}) {
        Spindle spindle{sign * 300e3 * units::rpm};
        spindle.droop = std::abs(spindle.speed) / (0.2 * units::N_mm);
        spindle.rotor_inertia = inertia;
        Simulation simulation(plain_block(1.3 * mm, 3 * mm), Tool(SphereHead{kRadius}, RayHandle{0}, spindle));
        const double max_power = 0.25 * spindle.speed * spindle.speed / spindle.droop;
        double z = kRadius, max_load = 0, work_before_hold = 0, last_speed = 0, max_jump = 0, before = 0;
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
          max_load = std::max(max_load, result.spindle.torque * result.spindle.speed / max_power);
          if (time < 0.03) work_before_hold = result.energy.motor_work;
          const bool stalls = has_any(result.status, StepStatus::spindle_stalled);
          if (stalls) {
            EXPECT_EQ(result.spindle.speed, 0);
            EXPECT_EQ(result.removed_volume, 0);
            EXPECT_LE(std::abs(result.spindle.torque), 0.204 * units::N_mm);
            EXPECT_GT(sign * result.spindle.torque, 0) << "it keeps pushing while it cannot turn";
          }
          if (time > 0.05 && time < 0.2) stalled_while_held &= stalls;
          changes += stalls != stalled;
          stalled = stalls;
          if (time > 0.031 && time < 0.199) max_jump = std::max(max_jump, std::abs(result.force.z() - before));
          before = result.force.z();
          last_speed = result.spindle.speed;
        }
        if (inertia == 0) {
          EXPECT_LT(max_load, 1.02);
        }
        EXPECT_LT(work_before_hold, max_power * 0.03 + 0.5 * inertia * spindle.speed * spindle.speed);
        EXPECT_TRUE(stalled_while_held);
        EXPECT_EQ(changes, 2) << "it does not alternate";
        EXPECT_LT(max_jump, 0.01) << "[N] while it is held";
        EXPECT_NEAR(last_speed, spindle.speed, 1e-6 * kSpin);
        EXPECT_LT(unbooked(simulation.last_result().energy), kClosure);
        EXPECT_TRUE(has_any(seen, StepStatus::spindle_stalled));
      }
}

// A ball lies in bone and may roll under its motor. Its friction then has no torque about the axis.
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
    EXPECT_LT(unbooked(simulation.last_result().energy), kClosure);
  }
}

// Proves: ramp.
TEST(Spindle, RampsToANewSettingWhenItHasAnAccelerationLimit) {
  Simulation simulation(plain_block(1.3 * mm, 3 * mm), Tool(FlatHead{kRadius, 4 * mm}, RayHandle{0},
                                                            Spindle{0, std::numeric_limits<double>::infinity(), 1e5}));
  simulation.spindle().set_speed(kSpin * units::rad_per_s);
  double before = 0;
  for (int tick = 0; tick <= 20; ++tick) {
    const StepResult& result = step_to(simulation, Vec3(0, 0, 1 * mm));
    EXPECT_NEAR(result.spindle.speed, 100.0 * tick, 1e-9);
    EXPECT_FALSE(has_any(result.status, StepStatus::power_limited)) << "a ramp is no load";
    EXPECT_GE(result.spindle.speed, before);
    before = result.spindle.speed;
  }
  EXPECT_THROW(simulation.spindle().set_speed(std::nan("") * units::rad_per_s), Error);
  EXPECT_EQ(step_to(simulation, Vec3(0, 0, 1 * mm)).spindle.speed, kSpin);
}

}  // namespace
}  // namespace hapticut::spindle_test
