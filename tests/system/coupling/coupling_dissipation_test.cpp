// SPDX-License-Identifier: Apache-2.0
// The coupling where the contact itself dissipates: Hunt-Crossley damping, sticking and slipping, rubbing and cutting.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"

namespace hapticut::coupling_dissipation_test {
namespace {

using namespace test;
using units::mm;

struct Stroke {
  double min_hand_work = 0;  // [J] minimum of the accumulated work of the hand
  double max_imbalance = 0;  // [J] imbalance of the coupling's ledger
  double rebound = 0;        // [m/s] maximum speed upwards while the hand comes down
  double jitter = 0;         // [m] along x while the hand rests
  double sideways = 0;       // [N] maximum on the hand
  int changes = 0;           // between sticking and sliding
};

/// The hand comes down on the surface, rests, moves 3 mm sideways, rests, and goes up again.
Stroke stroke(VirtualCoupling& coupling, double force) {
  Stroke seen;
  const double start = kRadius + 0.5 * mm, rest = kRadius - force / coupling.gains().stiffness;
  Vec3 hand(0, 0, start), last = hand;
  double low = 1, high = -1;
  bool was_moving = false;
  for (int n = 0; n < 4000; ++n) {
    if (n < 1000)
      hand.z() = std::max(rest, start - kApproach * n * kTick);
    else if (n < 2500)
      hand.x() = 2e-3 * (n - 1000) * kTick;
    else if (n >= 3500)
      hand.z() = std::min(start, hand.z() + kApproach * kTick);
    const CoupledResult& result =
        coupling.step(Pose::from_translation(kAside + hand), {(hand - last) / kTick, Vec3::Zero()}, kTick);
    last = hand;
    seen.min_hand_work = std::min(seen.min_hand_work, result.energy.hand_work);
    seen.max_imbalance = std::max(seen.max_imbalance, std::abs(result.energy.imbalance()));
    if (n < 1000) seen.rebound = std::max(seen.rebound, result.V_WH.linear.z());
    if (n >= 1000 && n < 2500) {
      seen.sideways = std::max(seen.sideways, -result.coupling.force.x());
      const bool moving = result.V_WH.linear.x() > 1e-3;
      seen.changes += moving != was_moving;
      was_moving = moving;
    }
    if (n >= 3000 && n < 3400) {
      low = std::min(low, result.X_WH.translation.x());
      high = std::max(high, result.X_WH.translation.x());
    }
  }
  seen.jitter = high - low;
  return seen;
}

Material material(double damping, double friction_stiffness) {
  Material m = plain_material();
  m.damping = damping;
  m.static_friction = 0.4;
  m.dynamic_friction = 0.25;
  m.tangential_stiffness = friction_stiffness;
  return m;
}

/// k_v [N/m^4], chi [s/m]
class DampedContact : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(DampedContact, IsStableAndPassiveUnderAHandThatStrikesRubsAndLeaves) {
  const auto [k, chi] = GetParam();
  for (const double friction_stiffness : {1e3, 1e6}) {
    Simulation simulation(half_space(4 * mm, material(chi, friction_stiffness)), ball(), implicit(k));
    VirtualCoupling coupling(simulation, {});
    const Stroke seen = stroke(coupling, 3);
    std::ostringstream at;
    at << "k_v " << k << ", chi " << chi << ", k_t " << friction_stiffness;
    EXPECT_GE(seen.min_hand_work, 0) << at.str() << ": the hand never gets back more than it gave";
    EXPECT_LT(seen.rebound, 0.5 * kApproach) << at.str();
    EXPECT_LT(seen.jitter, 2e-8) << at.str();
    EXPECT_GT(seen.sideways, 0.25 * 2) << at.str() << ": friction is felt";
    EXPECT_LT(seen.sideways, 0.45 * 3) << at.str() << ": and never above its cone";
    const CouplingEnergy& energy = coupling.last_result().energy;
    EXPECT_GE(energy.damper, 0);
    EXPECT_GE(energy.implicit, 0);
    EXPECT_GT(energy.tool_work, 0) << at.str() << ": the contact gives no energy back";
    EXPECT_LT(std::abs(energy.closure()), 1e-3) << at.str();
    EXPECT_LT(seen.max_imbalance, 1e-3 * energy.hand_work) << at.str();
    EXPECT_LT(unbooked(simulation.last_result().energy), 1e-5) << at.str();
  }
}

INSTANTIATE_TEST_SUITE_P(Coupling, DampedContact,
                         testing::Combine(testing::Values(1e14, 1e16, 1e17), testing::Values(0.0, 10.0, 100.0)),
                         [](const auto& p) {
                           return "k1e" + std::to_string(int(std::lround(std::log10(std::get<0>(p.param))))) + "chi" +
                                  std::to_string(int(std::get<1>(p.param)));
                         });

TEST(CouplingDamping, IsThereByDefaultOnlyWhereContactIsTakenAtTheEndOfAStep) {
  const auto damping_of = [](SimulationConfig config) {
    return Simulation(half_space(), ball(), std::move(config)).config().contact_damping;
  };
  EXPECT_EQ(damping_of({}), 0);
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  EXPECT_EQ(damping_of(config), kCalmingDamping);
  config.contact_damping = 0;
  EXPECT_EQ(damping_of(config), 0);
  config.contact_damping = -1;
  EXPECT_THROW((void)damping_of(config), Error);
  config.contact_damping.reset();
  config.law = std::make_shared<ThesisLaw>(ThesisLaw::Constants{});
  EXPECT_EQ(damping_of(config), 0) << "its damper grows with the number of voxels, not with their forces";
}

// With a late or wrong velocity the damper does work on the tool, so its loss is negative.
TEST(CouplingEnergy, IsJudgedByWhatWasTurnedOverAlsoWhereTheDamperGives) {
  Simulation simulation(half_space(4 * mm, material(0, 1e3)), ball(), implicit(1e14));
  VirtualCoupling coupling(simulation, {});
  double last = 0;
  for (int n = 0; n < 400; ++n) {
    const double angle = 0.05 * n;
    const Vec3 speed = 0.05 * Vec3(std::cos(angle), 0, -std::sin(angle));
    const Pose pose = Pose::from_translation(Vec3(1e-3 * std::sin(angle), 0, 3e-3 + 1e-3 * std::cos(angle)));
    const CouplingEnergy& energy = coupling.step(pose, {-4 * speed, Vec3::Zero()}, 1e-3).energy;
    EXPECT_GE(energy.turnover, last);
    last = energy.turnover;
  }
  const CouplingEnergy& energy = coupling.last_result().energy;
  EXPECT_LT(energy.damper, 0);
  EXPECT_GE(energy.turnover, std::abs(energy.hand_work));
  EXPECT_GE(energy.turnover, std::abs(energy.damper) + std::abs(energy.implicit));
  EXPECT_EQ(energy.closure(), energy.imbalance() / energy.turnover);
  EXPECT_LT(std::abs(energy.closure()), 1e-3);
}

TEST(CouplingEnergy, ClosesAlsoWhereGainsChangeWhileTheToolIsPulled) {
  for (const double factor : {2.0, 0.5}) {
    Simulation simulation(half_space(), ball(), implicit(1e16));
    VirtualCoupling coupling(simulation, {});
    press(coupling, 1, 500);
    CouplingGains others = coupling.gains();
    others.stiffness *= factor;
    others.mass *= factor;
    coupling.set_gains(others);
    EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
    press(coupling, factor, 500);
    EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
  }
}

/// A needle, pressed with 2 N by a hand that comes down within 0.2 s, waits, and lifts by 8 mm within 1 s.
struct Prick {
  double pull = 0, height = 0;  // [N] maximum force to draw it out, [m] of its tip at the end
  int unsolved = 0, ticks = 0;
};
Prick prick(double dt) {
  const double handle = 20 * mm, before = 0.1 * mm;
  Simulation simulation(half_space(3 * mm, presets::dentin()), Tool(needle_head(1.6 * mm, 4 * mm), RayHandle{handle}),
                        implicit(0, std::nullopt));
  VirtualCoupling coupling(simulation, touch_gains());
  const double down = 2 / coupling.gains().stiffness;
  const auto smooth = [](double q) { return q < 0 ? 0 : q > 1 ? 1 : q * q * (3 - 2 * q); };
  Prick seen;
  double last = handle + before;
  for (double time = dt; time < 1.7; time += dt, ++seen.ticks) {
    const double z = handle + before - (before + down) * smooth(time / 0.2) + (down + 8 * mm) * smooth(time - 0.6);
    const CoupledResult& result =
        coupling.step(Pose::from_translation(Vec3(0, 0, z)), {Vec3(0, 0, (z - last) / dt), Vec3::Zero()}, dt);
    last = z;
    if (time > 0.6) seen.pull = std::max(seen.pull, -result.hand.force.z());
    seen.unsolved += has_any(result.status, StepStatus::not_in_balance);
  }
  seen.height = coupling.last_result().X_WH.translation.z() - handle;
  return seen;
}

// Friction is mu/tan(alpha) = 1.5 times the upward push of the normal forces, so the needle locks. It releases within a
// tick.
TEST(CouplingFriction, ReleasesASlenderPointAtEveryRate) {
  for (const double rate : {500.0, 1000.0, 4000.0}) {
    const Prick seen = prick(1 / rate);
    EXPECT_GT(seen.pull, 0.1) << rate;
    EXPECT_LT(seen.pull, 0.6) << rate;
    EXPECT_NEAR(seen.height, 8 * mm, 0.1 * mm) << rate;
    EXPECT_LE(seen.unsolved, 0.002 * seen.ticks) << rate;
  }
}

TEST(CouplingFriction, SticksAndSlipsBehindALooseCoupling) {
  Material grippy = material(0, 1e5);
  grippy.static_friction = 0.6;
  grippy.dynamic_friction = 0.2;
  Simulation simulation(half_space(4 * mm, grippy), ball(), implicit(1e16));
  CouplingGains loose;
  loose.stiffness = 2000;
  loose.damping = 2;
  VirtualCoupling coupling(simulation, loose);
  const Stroke seen = stroke(coupling, 2);
  EXPECT_GE(seen.changes, 4) << "it stops and breaks loose again";
  EXPECT_GE(seen.min_hand_work, 0);
  EXPECT_LT(std::abs(coupling.last_result().energy.closure()), 1e-3);
  EXPECT_GT(simulation.last_result().energy.sliding, 0);
}

}  // namespace
}  // namespace hapticut::coupling_dissipation_test
