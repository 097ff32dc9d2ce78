// SPDX-License-Identifier: Apache-2.0
// Hand and tool at different poses: after a clutch, an invalid reading, or a start inside the material.
#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::separated_test {
namespace {

using namespace test::scripted_loop;

TEST(Separated, AnOpenClutchLeavesTheToolStandingAndClosingItMovesNothing) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop scripted(3000, coupled);
    double removed = 0;
    Vec3 place = Vec3::Zero();
    // The hand presses from tick 300 to 400. The clutch is open from 600 to 900; meanwhile the hand moves 5 mm up and
    // back.
    const auto hand = [](int n) { return n > 600 && n < 800 ? 5e-3 : press(1e-3)(n); };
    scripted.run(
        1000, hand,
        [&](int n) {
          if (n == 600) {
            removed = scripted.snapshot.tool.removed_volume;
            place = scripted.snapshot.X_WT.translation;
            EXPECT_GT(removed, 0);
            EXPECT_EQ(scripted.snapshot.tool.spindle_speed, 3000);
            EXPECT_TRUE(scripted.tell(commands::OpenClutch{}));
          }
          if (n == 900) {
            EXPECT_TRUE(scripted.tell(commands::CloseClutch{}));
          }
        },
        [&](int n) {
          if (n < 600) return;
          EXPECT_EQ(scripted.snapshot.tool.removed_volume, removed) << n;
          EXPECT_EQ(scripted.snapshot.tool.spindle_speed, 0) << n;
          EXPECT_LT((scripted.snapshot.X_WT.translation - place).norm(), n < 900 ? 1e-9 : 1e-3) << n;
          if (n < 900) {
            EXPECT_TRUE(scripted.commanded.isZero(0)) << n;
          }
          if (n > 900) {
            EXPECT_TRUE(scripted.device->last_output().applied.force.isZero(0)) << "the tool was not free yet, " << n;
          }
        });
    EXPECT_EQ(scripted.events(SafetyEvent::reclutched), 1U);
  }
}

TEST(Separated, AToolThatBeginsInsideWaitsForAFreeHand) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop scripted(3000, coupled);
    scripted.run(
        900, [](int n) { return n < 300 ? -1e-3 : std::min(-1e-3 + 1e-5 * (n - 300), 1e-3); }, [](int) {},
        [&](int n) {
          constexpr int kAtSurface = 398, kFree = 410;  // it begins a fifth of a voxel below the surface, and leaves it
          if (n < kAtSurface || n > kFree) {
            EXPECT_EQ(*scripted.model.contact().touching, n < kFree) << n;
          }
          if (n < kAtSurface) {
            EXPECT_TRUE(scripted.device->last_output().applied.force.isZero(0)) << n;
            EXPECT_EQ(has_any(scripted.snapshot.tool.status, StepStatus::tool_waits), coupled) << n;
          }
        });
    EXPECT_LT(scripted.snapshot.tool.removed_volume, 1e-15) << "it may graze the surface on which it begins";
    EXPECT_EQ(scripted.report.arming, ArmingState::on);
  }
}

// A student begins with the bur on the tooth.
TEST(Separated, AToolThatBeginsOnTheSurfaceGetsItsForceWithoutALift) {
  for (const double depth : {-1e-5, 0.0, 1e-5}) {
    ScriptedLoop scripted(3000, true);
    double applied = 0;
    scripted.run(
        3000, [&](int n) { return -depth - 2.5e-7 * std::max(0, n - 2000); }, [](int) {},
        [&](int n) { applied = n > 2900 ? scripted.device->last_output().applied.force.norm() : 0; });
    EXPECT_EQ(scripted.report.arming, ArmingState::on) << depth;
    EXPECT_EQ(scripted.events(SafetyEvent::start_inside), 0U) << depth;
    EXPECT_GT(applied, 0.01) << depth;
  }
}

TEST(Separated, AScaleChangesTheGainsAndNotWhatTheDeviceFeels) {
  const CouplingGains touch = touch_gains();
  WorkspaceMapOptions map;
  map.scale = 3;
  map.force_scale = 0.5;
  const CouplingGains world = gains_in_world(touch, map);
  EXPECT_DOUBLE_EQ(WorkspaceMap(map).felt_stiffness(world.stiffness), touch.stiffness);
  EXPECT_DOUBLE_EQ(world.max_force * map.force_scale, touch.max_force);
  EXPECT_DOUBLE_EQ(world.damping / (2 * std::sqrt(world.stiffness * world.mass)),
                   touch.damping / (2 * std::sqrt(touch.stiffness * touch.mass)));
  EXPECT_DOUBLE_EQ(world.stiffness / world.mass, touch.stiffness / touch.mass);

  // The hand moves by 3 mm, from 1 mm above a wall.
  for (const double scale : {0.5, 1.0, 3.0}) {
    ScriptedLoop scripted(0, true);
    double force = 0, height = 0;
    scripted.run(
        800, press(2e-3),
        [&](int n) {
          if (n == 100) {
            EXPECT_TRUE(scripted.tell(commands::SetScale{scale}));
          }
        },
        [&](int n) {
          if (n < 799) return;
          force = scripted.commanded.z();
          height = scripted.snapshot.X_WT.translation.z();
        });
    const double stretch = (height - (kRadius + 1e-3 - scale * 3e-3)) / scale;  // [m] at the hand
    EXPECT_GT(force, 0.2) << scale;
    EXPECT_NEAR(force, std::min(touch.max_force, touch.stiffness * stretch), 1e-3) << scale;
  }
}

TEST(Separated, AScaleIsRefusedWithWhichADirectContactWouldBuzz) {
  ScriptedLoop scripted(3000, false);
  EXPECT_NO_THROW(scripted.model.check(commands::SetScale{2}));
  EXPECT_THROW(scripted.model.check(commands::SetScale{1e6}), Error);
}

}  // namespace
}  // namespace hapticut::separated_test
