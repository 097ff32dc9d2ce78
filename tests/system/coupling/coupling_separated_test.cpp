// SPDX-License-Identifier: Apache-2.0
// Material that a tool has not cut its way into is neither felt nor cut: after exchanges, jumps, flipped readings and
// half rotations, behind a coupling and in a custom loop.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/coupling.hpp"

namespace hapticut::separated_tool_test {
namespace {

using units::mm;
using namespace test;

constexpr double kSlow = 300;   // [rad/s]
constexpr double kDeep = 2e-3;  // [m] depth of the hand below the surface

struct Exchange {
  const char* name;
  std::function<void(Simulation&, const WorkpieceSnapshot& fresh)> make;
};

const std::vector<Exchange>& exchanges() {
  static const std::vector<Exchange> all = {
      {"undo", [](Simulation& s, const auto&) { undo_all(s); }},
      {"a part of an undo", [](Simulation& s, const auto&) { (void)s.history().undo(1); }},
      {"redo",
       [](Simulation& s, const auto&) {
         undo_all(s);
         redo_all(s);
       }},
      {"restore", [](Simulation& s, const auto& fresh) { s.history().restore(fresh); }},
      {"larger tool", [](Simulation& s, const auto&) { s.set(tool_of(SphereHead{2 * kRadius}, kSlow)); }},
      {"tool on a shank",
       [](Simulation& s, const auto&) {
         s.set(Tool(SphereHead{kRadius}, RayHandle{1 * mm}, Spindle{kSlow * units::rad_per_s}));
       }},
      {"materials",
       [](Simulation& s, const auto&) {
         Material harder = plain_material();
         harder.relative_stiffness *= 4;
         s.set(MaterialTable({harder}));
       }},
      {"another simulation",
       [](Simulation& s, const auto&) {
         Simulation prepared(half_space(), ball(kSlow), s.config());
         s.exchange(prepared);
       }},
      {"reset", [](Simulation& s, const auto&) { s.reset(half_space()); }},
  };
  return all;
}

void expect_to_wait(const CoupledResult& result) {
  EXPECT_EQ(result.status, StepStatus::tool_waits);
  EXPECT_EQ(result.removed_volume, 0);
  EXPECT_EQ(result.hand.force, Vec3::Zero());
}

Simulation cutting_simulation(ContactTime time) {
  SimulationConfig config = implicit(1e14);
  config.contact_time = time;
  Simulation simulation(half_space(), ball(kSlow), config);
  simulation.history().reserve(4096);
  return simulation;
}

TEST(SeparatedTool, CutsAndFeelsNothingAfterAnExchangeBehindTheCoupling) {
  for (const Exchange& exchange : exchanges()) {
    SCOPED_TRACE(exchange.name);
    Simulation simulation = cutting_simulation(ContactTime::end);
    const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
    VirtualCoupling coupling(simulation, touch_gains());
    simulation.history().mark();
    const Pose hand = at_height(kRadius - kDeep);
    for (int n = 0; n <= 1000; ++n) coupling.step(at_height(kRadius + 1e-3 - 3e-6 * n), {}, kTick);
    ASSERT_GT(coupling.last_result().hand.force.norm(), 0.1);
    const Pose X_WH = coupling.last_result().X_WH;
    exchange.make(simulation, fresh);
    for (int n = 0; n < 20; ++n) {
      const CoupledResult& result = coupling.step(hand, {}, kTick);
      expect_to_wait(result);
      EXPECT_EQ(result.X_WH.translation, X_WH.translation);
    }
    for (int n = 0; n <= 500; ++n)
      coupling.step(at_height(kRadius - kDeep + 1e-5 * n), {Vec3(0, 0, 1e-2), Vec3::Zero()}, kTick);
    EXPECT_EQ(coupling.last_result().status, StepStatus::ok);
    EXPECT_NEAR(coupling.last_result().X_WH.translation.z(), kRadius + 3e-3, 0.1 * mm);
    EXPECT_LT(simulation.last_result().energy.entered, 1e-5);
    exchange.make(simulation, fresh);
    EXPECT_EQ(coupling.step(at_height(kRadius + 3e-3), {}, kTick).status, StepStatus::ok) << "not noticed in the air";
  }
}

TEST(SeparatedTool, CutsAndFeelsNothingAfterAnExchangeInACustomLoop) {
  for (const Exchange& exchange : exchanges()) {
    if (exchange.name == std::string("reset")) continue;  // like a new simulation, whose first step may be anywhere
    SCOPED_TRACE(exchange.name);
    Simulation simulation = cutting_simulation(ContactTime::middle);
    const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
    simulation.history().mark();
    const Twist down = {Vec3(0, 0, -3e-3), Vec3::Zero()};
    for (int n = 0; n <= 400; ++n) simulation.step(at_height(kRadius + 0.2e-3 - 3e-6 * n), down, kTick);
    ASSERT_GT(simulation.last_result().force.norm(), 0.1);
    exchange.make(simulation, fresh);
    for (int n = 400; n < 420; ++n) {
      const StepResult& result = simulation.step(at_height(kRadius + 0.2e-3 - 3e-6 * n), down, kTick);
      EXPECT_EQ(result.status, StepStatus::tool_waits);
      EXPECT_EQ(result.removed_volume, 0);
      EXPECT_EQ(result.force, Vec3::Zero());
    }
    const Twist up = {Vec3(0, 0, 0.3), Vec3::Zero()};  // the tool was inside in the tick before
    int felt = 0;
    double removed = 0;
    for (int n = 0; n <= 20; ++n) {
      const StepResult& result = simulation.step(at_height(kRadius - kDeep + 3e-4 * n), up, kTick);
      felt += result.force.norm() > 0 ? 1 : 0;
      removed += result.removed_volume;
    }
    EXPECT_EQ(felt, 0);
    EXPECT_EQ(removed, 0);
    EXPECT_EQ(simulation.last_result().status, StepStatus::ok);
    for (int n = 0; n <= 200; ++n)
      simulation.step(at_height(kRadius + 4e-3 - 3e-5 * n), {Vec3(0, 0, -3e-2), Vec3::Zero()}, kTick);
    EXPECT_GT(simulation.last_result().force.norm(), 0.1) << "it has a force again";
  }
}

TEST(SeparatedTool, BeginsOnASurface) {
  for (const double lower : {-0.1, -0.05, 0.0, 0.05, 0.1}) {  // [voxels]
    Simulation simulation = cutting_simulation(ContactTime::end);
    simulation.spindle().halt();
    VirtualCoupling coupling(simulation, touch_gains());
    const double start = kRadius - lower * simulation.workpiece().voxel_size();
    for (int n = 0; n <= 1000; ++n) {
      const CoupledResult& result = coupling.step(at_height(start - 2e-6 * n), {}, kTick);
      EXPECT_FALSE(has_any(result.status, StepStatus::tool_waits)) << lower << " voxels, tick " << n;
    }
    EXPECT_GT(coupling.last_result().hand.force.z(), 0.5) << lower;
  }
}

// A driver in millimetres lets a hand move a thousand times as fast.
TEST(SeparatedTool, IsNotPutWhereReadingsInMillimetresAre) {
  Simulation simulation = cutting_simulation(ContactTime::end);
  VirtualCoupling coupling(simulation, touch_gains());
  int accepted = 0;
  for (int n = 1; n <= 1000; ++n) {
    const double millimetres = 20 - 8e-3 * n;  // 8 mm/s
    accepted += coupling.step(at_height(millimetres), {}, kTick).status == StepStatus::ok ? 1 : 0;
  }
  EXPECT_LE(accepted, 1) << "the first pose may be anywhere";
}

TEST(SeparatedTool, IsPutWhereTheHandIsAfterReleaseOnlyInTheAir) {
  for (const double spin : {0.0, kSlow}) {
    Simulation simulation(half_space(), ball(spin), implicit(1e14));
    VirtualCoupling coupling(simulation, {});
    for (int n = 0; n <= 1000; ++n) coupling.step(at_height(kRadius + 1e-3 - 3e-6 * n), {}, kTick);
    const Vec3 place = coupling.last_result().X_WH.translation;
    coupling.reset();
    for (int n = 0; n < 10; ++n) {
      const CoupledResult& result = coupling.step(at_height(kRadius - kDeep), {}, kTick);
      expect_to_wait(result);
      EXPECT_EQ(result.X_WH.translation, place);
    }
    EXPECT_NEAR(coupling.step(at_height(2e-3), {}, kTick).X_WH.translation.z(), 2e-3, 1e-12);
    coupling.reset();
    EXPECT_NEAR(coupling.step(at_height(4e-3), {}, kTick).X_WH.translation.z(), 4e-3, 1e-12);
    EXPECT_EQ(coupling.last_result().status, StepStatus::ok);
  }
}

TEST(SeparatedTool, CutsNothingOnItsWayToAHandThatIsElsewhere) {
  Simulation simulation = cutting_simulation(ContactTime::end);
  VirtualCoupling coupling(simulation, {});
  const Vec3 at_the_edge(-2.7e-3, 0, 0);
  for (int n = 0; n <= 1000; ++n)
    coupling.step(Pose::from_translation(at_the_edge + Vec3(0, 0, kRadius + 1e-3 - 3e-6 * n)), {}, kTick);
  coupling.park(VirtualCoupling::Rejoin::free);
  const Pose beside = Pose::from_translation({-5.1e-3, 0, -1e-3});  // the wall is between
  for (int n = 0; n < 5; ++n) {
    const CoupledResult& result = coupling.step(beside, {}, kTick);
    EXPECT_EQ(result.removed_volume, 0);
    EXPECT_LT(result.hand.force.norm(), 1e-9);
    EXPECT_LT((result.X_WH.translation - beside.translation).norm(), 1e-9);
  }
}

TEST(SeparatedTool, OneReadingBehindAPlateDoesNotPullItThrough) {
  for (const double spin : {0.0, 4000.0})
    for (const bool rubbish_first : {false, true}) {
      Simulation simulation(half_space(3e-3, presets::trabecular_bone()), ball(spin), implicit(0));
      VirtualCoupling coupling(simulation, touch_gains());
      for (int n = 0; n <= 600; ++n) coupling.step(at_height(kRadius + 0.1e-3 - 1e-6 * n), {}, kTick);
      const Pose hand = at_height(kRadius - 0.5e-3);
      const double removed = simulation.totals().removed_volume[1];
      if (rubbish_first) coupling.step(Pose::from_translation(Vec3::Constant(NAN)), {}, kTick);
      coupling.step(at_height(-8e-3), {}, kTick);
      for (int n = 0; n < 300; ++n) coupling.step(hand, {}, kTick);
      EXPECT_LT(simulation.totals().removed_volume[1] - removed, 0.3e-9);
      EXPECT_GT(coupling.last_result().X_WH.translation.z(), rubbish_first ? -8.1e-3 : 0.0);
      for (int n = 0; n < 10; ++n) coupling.step(at_height(10e-3), {}, kTick);
      EXPECT_LT(coupling.last_result().hand.force.norm(), 1e-6) << "in the air the hand holds the tool again";
      EXPECT_NEAR(coupling.last_result().X_WH.translation.z(), 10e-3, 0.1e-3);
    }
}

TEST(SeparatedTool, FollowsAFastHandAtEveryRateAndVoxel) {
  for (const double voxel : {0.05e-3, 0.2e-3})
    for (const double period : {4e-3, 1e-3, 0.25e-3}) {
      Simulation simulation(half_space(1e-3, plain_material(), voxel), ball(), implicit(1e14));
      VirtualCoupling coupling(simulation, {});
      int refused = 0;
      for (int n = 0; n < 200; ++n) {
        const double time = n * period, x = 0.2 * std::sin(10 * time);
        const Pose pose{rotation_from_vector({0, 0, 30 * time}), Vec3(x, 0, 20e-3)};
        const Twist velocity{Vec3(2 * std::cos(10 * time), 0, 0), Vec3(0, 0, 30)};
        refused += has_any(coupling.step(pose, velocity, period).status, kRejected) ? 1 : 0;
      }
      EXPECT_EQ(refused, 0) << voxel << ", " << period;
    }
}

TEST(SeparatedTool, ANewCouplingDoesNotTakeItThroughWhatItHasNotCut) {
  Simulation simulation = cutting_simulation(ContactTime::end);
  for (int n = 0; n <= 400; ++n) simulation.step(at_height(kRadius + 0.2e-3 - 3e-6 * n), {}, kTick);
  simulation.set(tool_of(SphereHead{2 * kRadius}, kSlow));
  VirtualCoupling coupling(simulation, {});
  for (int n = 0; n < 10; ++n) expect_to_wait(coupling.step(at_height(kRadius - 1e-3), {}, kTick));
}

// --- readings that flip ---------------------------------------------------------------------------------------------

struct Flip {
  const char* name;
  Vec3 rotation;  // [rad]
  Vec3 shift;     // [m]
};

const Flip kFlips[] = {{"half revolution", {std::numbers::pi, 0, 0}, {0, 0, 0}},
                       {"quarter revolution", {0, std::numbers::pi / 2, 0}, {0, 0, 0}},
                       {"about its axis", {0, 0, std::numbers::pi}, {0, 0, 0}},
                       {"small rotation of a long lever", {0.3, 0, 0}, {0, 0, 0}},
                       {"elsewhere", {0, 0, 0}, {0, 0, 0.2}}};

/// A hand that comes down into the surface.
Pose hand_at(int n, const Tool& tool) {
  return Pose::from_translation(Vec3(0, 0, kRadius + 0.1e-3 - 1e-6 * std::min(n, 400))) * tool.X_HT().inverse();
}

/// Force and removal with every `every`-th reading changed.
template <typename Step>
auto story_of(int every, const Tool& tool, const std::function<Pose(const Pose&)>& changed, Step step) {
  std::vector<std::pair<Vec3, double>> story;
  for (int n = 0; n < 800; ++n) {
    const Pose hand = hand_at(n, tool);
    story.push_back(step(n % every == every - 1 ? changed(hand) : hand));
  }
  return story;
}

Pose rubbish(const Pose& pose) { return {pose.rotation, Vec3::Constant(NAN)}; }

TEST(SeparatedTool, WaitsForAReadingThatFlipsAsForOneThatIsNoNumber) {
  for (const double spin : {0.0, kSlow})
    for (const double shank : {0.0, 60 * mm})
      for (const Flip& flip : kFlips) {
        if (shank == 0 && flip.rotation.norm() < 1 && flip.shift.isZero()) continue;  // the tool can follow this motion
        const auto flipped = [&](const Pose& pose) {
          return Pose{rotation_from_vector(flip.rotation) * pose.rotation, pose.translation + flip.shift};
        };
        const Tool tool(SphereHead{kRadius}, RayHandle{shank}, Spindle{spin * units::rad_per_s});
        for (const int every : {2, 10, 100}) {
          SCOPED_TRACE(std::string(flip.name) + ", every " + std::to_string(every) + ", spin " + std::to_string(spin) +
                       ", shank " + std::to_string(shank));
          const auto direct = [&](const auto& changed) {
            Simulation simulation(half_space(), tool, on_foundation(1e14));
            return story_of(every, tool, changed, [&](const Pose& pose) {
              const StepResult& result = simulation.step(pose, {}, kTick);
              return std::pair(result.force, result.removed_volume);
            });
          };
          const auto coupled = [&](const auto& changed) {
            Simulation simulation(half_space(), tool, implicit(1e14));
            VirtualCoupling coupling(simulation, {});
            return story_of(every, tool, changed, [&](const Pose& pose) {
              const CoupledResult& result = coupling.step(pose, {}, kTick);
              return std::pair(result.hand.force, result.removed_volume);
            });
          };
          EXPECT_EQ(direct(flipped), direct(rubbish)) << "in a custom loop";
          EXPECT_EQ(coupled(flipped), coupled(rubbish)) << "behind the coupling";
        }
      }
}

TEST(SeparatedTool, IsNotPutWhereNoTwoReadingsAgree) {
  Simulation simulation(half_space(), ball(), on_foundation(1e14));
  for (int n = 0; n < 100; ++n) simulation.step(at_height(kRadius + 0.05e-3 - 1e-6 * n), {}, kTick);
  Pose hand = at_height(kRadius - 0.05e-3);
  simulation.step(hand, {}, kTick);
  const Vec3 force = simulation.step(hand, {}, kTick).force;  // at rest
  ASSERT_GT(force.z(), 0);
  for (int n = 1; n <= 8; ++n) {
    hand.rotation = rotation_from_vector({n % 2 == 1 ? 2.0 : -2.0, 0, 0});
    EXPECT_EQ(simulation.step(hand, {}, kTick).status, StepStatus::jump_rejected) << n;
  }
  hand.rotation.setIdentity();
  const Vec3 again = simulation.step(hand, {}, kTick).force;
  EXPECT_LT((again - force).norm(), 1e-6 * force.norm()) << "it continues from where it was; friction still settles";
}

TEST(SeparatedTool, IsNotTurnedIntoMaterialByTwoReadingsThatAgree) {
  for (const double angle : {1.5, std::numbers::pi}) {
    Simulation simulation(half_space(), tool_of(FlatHead{0.5 * mm, 4 * mm}, kSlow), on_foundation(1e14));
    for (int n = 0; n < 100; ++n) simulation.step(at_height(0.05e-3 - 1e-6 * n), {}, kTick);
    Pose flipped = at_height(-0.05e-3);
    flipped.rotation = rotation_from_vector({angle, 0, 0});
    const double entered = simulation.last_result().energy.entered;
    for (int n = 0; n < 5; ++n) {
      const StepResult& result = simulation.step(flipped, {}, kTick);
      EXPECT_EQ(result.removed_volume, 0) << angle;
      EXPECT_EQ(result.force, Vec3::Zero()) << angle;
    }
    EXPECT_EQ(simulation.last_result().energy.entered, entered);
    simulation.step(at_height(-0.05e-3), {}, kTick);
    EXPECT_FALSE(has_any(simulation.last_result().status, kRejected)) << "the tool continues when the hand is back";
  }
}

// --- half a revolution against a head that cannot follow ------------------------------------------------------------

TEST(SeparatedTool, IsReleasedWhenTheHandRotatesByHalfARevolutionAgainstIt) {
  CouplingGains gains = coupling_gains(capabilities(device_model("premium6dof")));
  ASSERT_GT(gains.angular_stiffness, 0);
  gains.max_torque = 0.05;  // [N m] the head slips out before the torque of the device is reached
  const Tool tool(SphereHead{kRadius}, RayHandle{20 * mm});
  Simulation simulation(half_space(4e-3, presets::cortical_bone()), tool, implicit(0));
  VirtualCoupling coupling(simulation, gains);
  // The hand stays just above the surface and rotates the head into the material, until the spring is at its limit.
  const Mat3 lying = Eigen::Quaterniond::FromTwoVectors(tool.X_HT().translation, Vec3::UnitX()).toRotationMatrix();
  const auto hand = [&](double angle) {
    return Pose{rotation_from_vector({0, angle, 0}) * lying, Vec3(-20 * mm, 0, kRadius + 0.05 * mm)};
  };
  Vec3 last = Vec3::Zero();
  double max_torque = 0, released = 0;
  for (int n = 0; n < 4000; ++n) {
    const double angle = 1e-3 * n;
    const CoupledResult& result = coupling.step(hand(angle), {Vec3::Zero(), Vec3(0, 1, 0)}, kTick);
    const Vec3& torque = result.hand.torque;
    EXPECT_GE(torque.dot(last), -1e-9) << "at " << angle << " rad it pulls in the other direction";
    if (last.norm() > 0.01 && torque.norm() < 1e-6) released = angle;
    last = torque;
    max_torque = std::max(max_torque, torque.norm());
  }
  EXPECT_NEAR(max_torque, gains.max_torque, 0.01 * gains.max_torque);
  EXPECT_GT(released, 2.7);
  EXPECT_LT(released, 3.2);
  EXPECT_LT(coupling.last_result().hand.torque.norm(), 1e-6) << "the hand is in the air and holds the tool again";
  EXPECT_EQ(coupling.last_result().status, StepStatus::ok);
}

}  // namespace
}  // namespace hapticut::separated_tool_test
