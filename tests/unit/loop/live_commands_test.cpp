// SPDX-License-Identifier: Apache-2.0
// The commands to a simulation while its loop runs, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "hapticut/core/errors.hpp"
#include "support/scripted_loop.hpp"

namespace hapticut::live_commands_test {
namespace {

using namespace test::scripted_loop;

void nothing(int /*tick*/) {}

TEST(LiveCommands, SetToolSwapsTheToolAndGivesNoForceUntilItIsFree) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop scripted(3000, coupled);
    // The first ball rests 1 mm above the face. A ball of 4 mm with the same centre is 1.5 mm deep.
    scripted.run(
        1500, [](int n) { return n < 1000 ? 1e-3 : 8e-3; },
        [&](int n) {
          if (n == 500) {
            EXPECT_EQ(scripted.device->last_arming(), ArmingState::on);
            EXPECT_TRUE(scripted.tell(scripted.model.prepare_tool(ball(4e-3, 2000))));
          }
        },
        [&](int n) {
          if (n < 500) return;
          EXPECT_EQ(radius_of(scripted.simulation.tool()), 4e-3);
          if (n == 500) {
            EXPECT_TRUE(scripted.commanded.isZero(0)) << "the guard has not read the request yet";
          }
          if (n > 500 && n < 1000) {
            EXPECT_EQ(scripted.device->last_arming(), ArmingState::wait_free) << n;
            EXPECT_TRUE(scripted.device->last_output().applied.force.isZero(0)) << n;
            EXPECT_EQ(scripted.snapshot.tool.spindle_speed, 0) << n;
          }
        });
    EXPECT_EQ(scripted.events(SafetyEvent::model_swapped), 1U);
    EXPECT_EQ(scripted.report.arming, ArmingState::on) << "the tool was free";
    EXPECT_EQ(scripted.snapshot.tool.spindle_speed, 2000) << "of the new tool";
    EXPECT_EQ(scripted.snapshot.tool.removed_volume, 0);
    EXPECT_EQ(scripted.report.fault, DeviceFault::none);
  }
}

TEST(LiveCommands, ALargerToolCutsAsIfItHadBeenThereFromTheBeginning) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop with(3000, coupled);
    with.run(900, press(0.5e-3), nothing, nothing);
    ScriptedLoop changed(3000, coupled);
    EXPECT_TRUE(changed.tell(changed.model.prepare_tool(ball(0.5e-3))));
    changed.run(
        900, press(0.5e-3),
        [&](int n) {
          if (n == 50) {
            EXPECT_TRUE(changed.tell(changed.model.prepare_tool(ball())));
          }
        },
        nothing);
    EXPECT_EQ(changed.simulation.workpiece().hash(), with.simulation.workpiece().hash());
    EXPECT_EQ(changed.snapshot.tool.removed_volume, with.snapshot.tool.removed_volume);
    EXPECT_GT(with.snapshot.tool.removed_volume, 0);
    EXPECT_FALSE(has_any(changed.snapshot.tool.status_seen, StepStatus::removed_list_full));
  }
}

TEST(LiveCommands, SetToolHoldsTheSpindleUntilItMayCutWithAnyRamp) {
  Spindle slow{3000 * units::rad_per_s};
  slow.acceleration_limit = 3000;  // it needs a second to stop
  ScriptedLoop scripted;
  scripted.run(
      900, press(0.2e-3),
      [&](int n) {
        if (n == 500) {
          EXPECT_GT(scripted.snapshot.tool.removed_volume, 0);
          EXPECT_TRUE(scripted.tell(scripted.model.prepare_tool(Tool(SphereHead{3e-3}, RayHandle{0}, slow))));
        }
      },
      [&, at = 0.0](int n) mutable {
        if (n == 499) at = scripted.snapshot.tool.removed_volume;
        if (n > 500) {
          EXPECT_EQ(scripted.snapshot.tool.removed_volume, at);
        }
      });
}

TEST(LiveCommands, SetMaterialsChangesWhatIsFeltAfterTheToolWasFree) {
  ScriptedLoop scripted(0);
  Material soft = test::plain_material();
  soft.relative_stiffness = 0.25;
  double hard_force = 0;
  const std::uint64_t whole = scripted.simulation.workpiece().hash();
  scripted.run(
      1600, [](int n) { return press(1e-3, n > 800 ? 0 : 700)(n > 800 ? n - 600 : n); },
      [&](int n) {
        if (n == 600) {
          hard_force = scripted.snapshot.tool.force.z();
          EXPECT_TRUE(scripted.tell(scripted.model.prepare_materials(MaterialTable({soft}))));
        }
        if (n == 650) {
          EXPECT_EQ(scripted.device->last_arming(), ArmingState::wait_free) << "the tool is still in the material";
        }
      },
      nothing);
  EXPECT_EQ(scripted.events(SafetyEvent::model_swapped), 1U);
  EXPECT_EQ(scripted.report.arming, ArmingState::on);
  EXPECT_EQ(scripted.simulation.workpiece().materials()[1].relative_stiffness, 0.25);
  EXPECT_EQ(scripted.simulation.workpiece().hash(), whole);
  EXPECT_GT(hard_force, 0);
}

TEST(LiveCommands, SetFrictionSetEffectsAndSetForceMaskActFromTheNextTickOn) {
  ScriptedLoop scripted(0);
  double free_weight = 0;
  Effects heavy;
  heavy.gravity = Gravity{0.1, Vec3::Zero()};
  scripted.run(
      1200, press(1e-3),
      [&](int n) {
        if (n == 200) {
          EXPECT_TRUE(scripted.tell(commands::SetEffects{heavy}));
        }
        if (n == 250) {
          free_weight = scripted.snapshot.tool.force.z();
          EXPECT_TRUE(scripted.tell(commands::SetEffects{}));
        }
        if (n == 600) {
          EXPECT_GT(scripted.snapshot.tool.force.z(), 0.5);
          EXPECT_TRUE(scripted.tell(commands::SetForceMask{{{true, true, false}, {true, true, true}}}));
        }
        if (n == 700) {
          EXPECT_TRUE(scripted.tell(commands::SetForceMask{}));
        }
        if (n == 800) {
          EXPECT_TRUE(scripted.tell(commands::SetFriction{DryFriction{0.7, 0.6, 500}}));
        }
      },
      [&](int n) {
        if (n >= 600 && n < 700) {
          EXPECT_EQ(scripted.snapshot.tool.force.z(), 0) << n;
        }
        if (n >= 700) {
          EXPECT_GT(scripted.snapshot.tool.force.z(), 0.5) << n;
        }
      });
  EXPECT_NEAR(free_weight, -0.980665, 1e-9);
  EXPECT_EQ(scripted.simulation.config().friction->static_friction, 0.7);
  EXPECT_EQ(scripted.events(SafetyEvent::model_swapped), 0U);
}

TEST(LiveCommands, SetRemovalSwitchesTheCuttingOffAndOn) {
  ScriptedLoop scripted;
  double at_off = 0, at_on = 0;
  scripted.run(
      900, [](int n) { return 1e-3 - 5e-6 * std::max(0, n - 300); },
      [&](int n) {
        if (n == 600) {
          at_off = scripted.snapshot.tool.removed_volume;
          EXPECT_TRUE(scripted.tell(commands::SetRemoval{RemovalLaw::none}));
        }
        if (n == 700) {
          at_on = scripted.snapshot.tool.removed_volume;
          EXPECT_TRUE(scripted.tell(commands::SetRemoval{RemovalLaw::constant_energy}));
        }
      },
      nothing);
  EXPECT_GT(at_off, 0);
  EXPECT_EQ(at_on, at_off);
  EXPECT_GT(scripted.snapshot.tool.removed_volume, at_on);
}

TEST(LiveCommands, HoldForceKeepsTheForceAtAnyPoseOfTheHandAndCutsNothing) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop scripted(3000, coupled);
    Vec3 held;
    double removed = 0;
    scripted.run(
        1600,
        [](int n) {  // pressed, deeper while the force is held, then out
          return n < 700 ? press(0.3e-3)(n) : n < 1200 ? -0.3e-3 - 5e-6 * (n - 700) : 3e-3;
        },
        [&](int n) {
          if (n == 700) {
            held = scripted.snapshot.tool.force;
            removed = scripted.snapshot.tool.removed_volume;
            EXPECT_TRUE(scripted.tell(commands::HoldForce{}));
          }
          if (n == 1000) {
            EXPECT_TRUE(scripted.tell(commands::HoldForce{false}));
          }
        },
        [&](int n) {
          EXPECT_EQ(scripted.snapshot.tool.force_held, n >= 700 && n < 1000);
          if (n >= 700 && n < 1000) {
            EXPECT_EQ(scripted.commanded, held) << n;
            EXPECT_EQ(scripted.snapshot.tool.force, held) << n;
            EXPECT_EQ(scripted.snapshot.tool.spindle_speed, 0) << n;
          }
          if (n == 1000) {
            EXPECT_TRUE(scripted.commanded.isZero(0));
          }
          if (n > 1000 && n < 1200) {
            EXPECT_EQ(scripted.device->last_arming(), ArmingState::wait_free) << "the tool is deeper than before";
          }
        });
    EXPECT_GT(held.norm(), 0.01);
    EXPECT_EQ(scripted.snapshot.tool.removed_volume, removed);
    EXPECT_EQ(scripted.report.arming, ArmingState::on);
    EXPECT_EQ(scripted.events(SafetyEvent::reclutched), 1U);
  }
}

TEST(LiveCommands, ExchangeWorkpieceBringsAnotherOneWithItsTool) {
  for (const bool coupled : {false, true}) {
    ScriptedLoop scripted(3000, coupled);
    std::uint64_t cut = 0;
    LoopCommand exchange = scripted.model.prepare_workpiece(block(3e-4, 4e-3), ball(2e-3, 1000));
    scripted.run(
        1800, [](int n) { return press(0.4e-3, n > 900 ? 0 : 800)(n > 900 ? n - 700 : n); },
        [&](int n) {
          if (n == 700) {
            cut = scripted.simulation.workpiece().hash();
            EXPECT_GT(scripted.snapshot.tool.removed_volume, 0);
            EXPECT_TRUE(scripted.model.apply(exchange));
          }
        },
        [&](int n) {
          EXPECT_EQ(scripted.snapshot.tool.workpiece, n >= 700 ? 1U : 0U);
          if (n == 700) {
            EXPECT_TRUE(scripted.commanded.isZero(0));
          }
        });
    EXPECT_EQ(scripted.simulation.workpiece().voxel_size(), 3e-4);
    EXPECT_EQ(scripted.simulation.workpiece().undo_blocks(), 2000U);
    EXPECT_EQ(radius_of(scripted.simulation.tool()), 2e-3);
    EXPECT_EQ(scripted.events(SafetyEvent::model_swapped), 1U);
    EXPECT_EQ(scripted.report.arming, ArmingState::on);
    EXPECT_EQ(std::get<commands::ExchangeWorkpiece>(exchange).simulation->workpiece().hash(), cut)
        << "the old workpiece came back in the command";
  }
}

TEST(LiveCommands, RedoRestoresTheUndoneCutUnlessSomethingElseWasCut) {
  ScriptedLoop scripted;
  std::uint64_t cut = 0;
  const std::uint64_t whole = scripted.simulation.workpiece().hash();
  const auto down = [](int n) { return press(0.3e-3, n % 1200 > 900 ? 0 : 800)(n % 1200); };
  scripted.run(
      2400, down,
      [&](int n) {
        if (n == 100) {
          EXPECT_FALSE(scripted.tell(commands::Undo{})) << "there is no mark";
          EXPECT_FALSE(scripted.tell(commands::Redo{}));
          EXPECT_TRUE(scripted.tell(commands::SetUndoMark{}));
        }
        if (n == 850) {
          cut = scripted.simulation.workpiece().hash();
          EXPECT_TRUE(scripted.tell(commands::Undo{}));
          EXPECT_FALSE(scripted.tell(commands::Redo{})) << "refused during the undo";
          EXPECT_FALSE(scripted.tell(commands::SetUndoMark{}));
        }
        if (n == 950) {
          EXPECT_EQ(scripted.simulation.workpiece().hash(), whole);
          EXPECT_EQ(scripted.snapshot.tool.redo_marks, 1U);
          EXPECT_TRUE(scripted.tell(commands::Redo{}));
        }
        if (n == 1050) {
          EXPECT_EQ(scripted.simulation.workpiece().hash(), cut);
          EXPECT_EQ(scripted.snapshot.tool.undo_marks, 1U);
          EXPECT_EQ(scripted.snapshot.tool.redo_marks, 0U);
          EXPECT_TRUE(scripted.tell(commands::Undo{}));
        }
        if (n == 2100) {  // the tool has cut again
          EXPECT_NE(scripted.simulation.workpiece().hash(), whole);
          EXPECT_FALSE(scripted.tell(commands::Redo{}));
        }
      },
      [&](int n) {
        if (scripted.snapshot.tool.redoing || scripted.snapshot.tool.undoing) {
          EXPECT_TRUE(scripted.commanded.isZero(0)) << n;
        }
      });
  EXPECT_GT(scripted.events(SafetyEvent::model_swapped), 2U);
}

TEST(LiveCommands, RefuseValuesOutOfRangeInTheThreadOfTheSender) {
  ScriptedLoop scripted(3000, true);
  const auto refused = [&](LoopCommand command) { EXPECT_THROW(scripted.model.check(command), Error); };
  refused(commands::SetSpindleSpeed{2 * kMaxSpindleSpeed * units::rad_per_s});
  refused(commands::SetScale{0});
  refused(commands::SetFriction{DryFriction{0.1, 0.2, 1000}});
  Effects effects;
  effects.vibration = Vibration{};
  effects.vibration->frequency = 1e6;
  refused(commands::SetEffects{effects});
  refused(commands::ExchangeWorkpiece(Simulation(block(), ball(), config(false))));
  LoopCommand tool = scripted.model.prepare_tool(ball());
  const LoopCommand moved = std::move(tool);
  refused(std::move(tool));  // NOLINT(bugprone-use-after-move): a moved-from command is refused
  EXPECT_NO_THROW(scripted.model.check(moved));
  EXPECT_THROW((void)scripted.model.prepare_tool(ball(1e-5)), Error);
  EXPECT_THROW((void)scripted.model.prepare_workpiece(block(4e-3), ball()), Error);
}

TEST(LiveCommands, RefuseObjectsInTheLoopThatDoNotSuitThePresentOnes) {
  ScriptedLoop scripted;
  EXPECT_FALSE(scripted.tell(commands::SetTool(ball(), 1e-4, config())));
  Material other = test::plain_material();
  other.name = "other";
  EXPECT_FALSE(scripted.tell(scripted.model.prepare_materials(MaterialTable({test::plain_material(), other}))));
  EXPECT_EQ(radius_of(scripted.simulation.tool()), kRadius);
  EXPECT_EQ(scripted.simulation.totals().exchanges, 0U);
  scripted.run(
      300, [](int) { return 1e-3; }, nothing, nothing);
  EXPECT_EQ(scripted.events(SafetyEvent::model_swapped), 0U) << "nothing was swapped";
}

}  // namespace
}  // namespace hapticut::live_commands_test
