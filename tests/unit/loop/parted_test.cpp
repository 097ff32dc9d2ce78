// SPDX-License-Identifier: Apache-2.0
// When hand and tool have parted: by a clutch, a reading that means nothing, a beginning inside the material.
#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "support/loop_rig.hpp"

namespace hapticut::parted_test {
namespace {

using namespace test::loop_rig;

TEST(Parted, AnOpenClutchLeavesTheToolStandingAndClosingItMovesNothing) {
  for (const bool coupled : {false, true}) {
    Rig rig(3000, coupled);
    double removed = 0;
    Vec3 place = Vec3::Zero();
    // Pressed in from 300 to 400, open from 600 to 900, meanwhile 5 mm up and down again.
    const auto hand = [](int n) { return n > 600 && n < 800 ? 5e-3 : press(1e-3)(n); };
    rig.run(
        1000, hand,
        [&](int n) {
          if (n == 600) {
            removed = rig.snapshot.tool.removed_volume;
            place = rig.snapshot.X_WT.translation;
            EXPECT_GT(removed, 0);
            EXPECT_EQ(rig.snapshot.tool.spindle_speed, 3000);
            EXPECT_TRUE(rig.tell(commands::OpenClutch{}));
          }
          if (n == 900) {
            EXPECT_TRUE(rig.tell(commands::CloseClutch{}));
          }
        },
        [&](int n) {
          if (n < 600) return;
          EXPECT_EQ(rig.snapshot.tool.removed_volume, removed) << n;
          EXPECT_EQ(rig.snapshot.tool.spindle_speed, 0) << n;
          EXPECT_LT((rig.snapshot.X_WT.translation - place).norm(), n < 900 ? 1e-9 : 1e-3) << n;
          if (n < 900) {
            EXPECT_TRUE(rig.commanded.isZero(0)) << n;
          }
          if (n > 900) {
            EXPECT_TRUE(rig.device->last_output().applied.force.isZero(0)) << "it was not free yet, " << n;
          }
        });
    EXPECT_EQ(rig.events(SafetyEvent::reclutched), 1U);
  }
}

TEST(Parted, AToolThatBeginsInsideWaitsForAFreeHand) {
  for (const bool coupled : {false, true}) {
    Rig rig(3000, coupled);
    rig.run(
        900, [](int n) { return n < 300 ? -1e-3 : std::min(-1e-3 + 1e-5 * (n - 300), 1e-3); }, [](int) {},
        [&](int n) {
          if (n < 400 || n > 404) {
            EXPECT_EQ(*rig.model.contact().touching, n < 402) << n;
          }
          if (n < 400) {
            EXPECT_TRUE(rig.device->last_output().applied.force.isZero(0)) << n;
            EXPECT_EQ(has_any(rig.snapshot.tool.status, StepStatus::tool_waits), coupled) << n;
          }
        });
    EXPECT_EQ(rig.snapshot.tool.removed_volume, 0);
    EXPECT_EQ(rig.report.guard, ArmingState::on);
  }
}

// In a loop of one's own, as docs/your-own-loop.md has it: the stylus goes through the bone before there is a force.
TEST(Parted, AScaleChangesTheGainsAndNotWhatTheDeviceFeels) {
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

  // 3 mm of the hand from 1 mm above a wall.
  for (const double scale : {0.5, 1.0, 3.0}) {
    Rig rig(0, true);
    double force = 0, height = 0;
    rig.run(
        800, press(2e-3),
        [&](int n) {
          if (n == 100) {
            EXPECT_TRUE(rig.tell(commands::SetScale{scale}));
          }
        },
        [&](int n) {
          if (n < 799) return;
          force = rig.commanded.z();
          height = rig.snapshot.X_WT.translation.z();
        });
    const double stretch = (height - (kRadius + 1e-3 - scale * 3e-3)) / scale;  // [m] at the hand
    EXPECT_GT(force, 0.2) << scale;
    EXPECT_NEAR(force, std::min(touch.max_force, touch.stiffness * stretch), 1e-3) << scale;
  }
}

TEST(Parted, AScaleIsRefusedWithWhichADirectContactWouldBuzz) {
  Rig rig(3000, false);
  EXPECT_NO_THROW(rig.model.check(commands::SetScale{2}));
  EXPECT_THROW(rig.model.check(commands::SetScale{1e6}), Error);
}

}  // namespace
}  // namespace hapticut::parted_test
