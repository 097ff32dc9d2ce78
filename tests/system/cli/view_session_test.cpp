// SPDX-License-Identifier: Apache-2.0
// A scene during drilling: the model executes the commands of a page, and the page gets the results.
#include "page/session/view_session.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "support/temporary_folder.hpp"
#include "system/cli/view_desk.hpp"

namespace hapticut::view_session_test {
namespace {

using namespace std::chrono_literals;
using test::Desk;
using units::mm;
using view_test::soon;

TEST(ViewSession, BeginsASentenceWithACapitalButKeepsNames) {
  const auto sentence = [](const char* text) { return apps::as_sentence(Error(text)); };
  EXPECT_EQ(sentence("there is no scene"), "There is no scene");
  EXPECT_EQ(sentence("cannot, however"), "Cannot, however");
  for (const char* name :
       {"pipe.toml: it is a pipe.", "tool.radius_mm = 0; must be > 0.", "scene: line 3", "a/b is not"})
    EXPECT_EQ(sentence(name), name);
}

TEST(ViewSession, SendsChangedControlsToTheModel) {
  Desk desk;
  desk.lead(Vec3(0, 0, 2 * mm), true);
  EXPECT_NEAR(desk.model().spindle().setting(), 1000, 1e-9);
  desk.turn("Cutting", 0);
  EXPECT_EQ(desk.model().config().removal, RemovalLaw::none);
  desk.turn("Cutting", 1);
  EXPECT_NE(desk.model().config().removal, RemovalLaw::none);
  desk.turn("Spindle", 0);
  EXPECT_EQ(desk.model().spindle().setting(), 0);
  desk.turn("Spindle", 1);
  EXPECT_NE(desk.model().spindle().setting(), 0);
  desk.turn("Gravity", 1);
  EXPECT_TRUE(desk.model().config().effects.gravity.has_value());
  desk.session.apply(commands::SetSpindleSpeed{500 * units::rad_per_s});
  EXPECT_NEAR(desk.model().spindle().setting(), 500, 1e-6);
}

TEST(ViewSession, AHandOfTheSceneBeforeMovesNothing) {
  Desk desk;
  const Pose inside = Pose::from_translation({0, 0, -1 * mm});
  const auto press = [&] {
    for (int n = 0; n < 100; ++n) {
      desk.session.apply(view::MoveHand{inside, true});
      desk.session.frame(0.016);
      std::this_thread::sleep_for(10ms);
    }
  };
  press();
  EXPECT_EQ(desk.model().totals().removed_volume[1], 0) << "the page has not looked at this scene yet";
  desk.session.apply(view::LookAt{});
  press();
  EXPECT_GT(desk.model().totals().removed_volume[1], 0);
}

TEST(ViewSession, ThePointerCutsOnlyWhileItPresses) {
  Desk desk;
  for (const double x : {1, -1, 1, -1}) desk.lead(Vec3(x * mm, 0, -0.3 * mm), false);  // passes through the block
  EXPECT_GT(desk.session.latest().tool.contact_voxels, 0);
  EXPECT_EQ(desk.session.latest().tool.spindle_speed, 0);
  EXPECT_EQ(desk.session.latest().tool.removed_volume, 0);
  EXPECT_EQ(desk.session.latest().tool.undo_marks, 0U);
  desk.lead(Vec3(0, 0, 1 * mm), false);
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  EXPECT_GT(desk.session.latest().tool.removed_volume, 0);
  EXPECT_EQ(desk.session.latest().tool.undo_marks, 1U);
}

TEST(ViewSession, SetsAnUndoMarkAfterTheMarksAreUsedUp) {
  Desk desk;
  desk.lead(Vec3(0, 0, 1 * mm), false);
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  desk.lead(Vec3(0, 0, 1 * mm), false);
  desk.lead(Vec3(0, 0, 1.1 * mm), true);  // stays in air
  desk.lead(Vec3(0, 0, 1 * mm), false);
  for (unsigned left = desk.session.latest().tool.undo_marks; left-- > 0;) {
    desk.session.apply(commands::Undo{});
    ASSERT_TRUE(soon([&] { return desk.session.latest().tool.undo_marks == left; }));
  }
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  EXPECT_EQ(desk.session.latest().tool.undo_marks, 1U);
}

TEST(ViewSession, InThesisModeCutsWithTheHeadsOfTheThesis) {
  const test::TemporaryFolder folder;
  const std::string scene = (folder / "thesis.toml").string();
  for (const char* head : {"\"sphere\"\nradius_mm = 1", "\"cone\"\nhalf_angle_deg = 30\nheight_mm = 1.5",
                           "\"flat\"\nradius_mm = 1\nheight_mm = 2"}) {
    test::write_bytes(scene,
                      "[workpiece]\nsource = \"block\"\nsize_mm = [6, 6, 3]\nmaterial = \"clay\"\nvoxel_mm = 0.1\n"
                      "[simulation]\nthesis_mode = true\n[tool]\nspindle_rpm = 40000\nhead = " +
                          std::string(head) + "\n");
    Desk desk(apps::make_view_scene(scene));
    desk.lead(Vec3(3, 3, 4) * mm, false);
    desk.lead(Vec3(3, 3, 2) * mm, true);
    EXPECT_GT(desk.session.latest().tool.removed_volume, 1e-10) << head;
  }
}

TEST(ViewSession, TellsTheForceThatTheHandIsGiven) {
  Desk desk;
  desk.lead(Vec3(0, 0, 1 * mm), false);
  desk.lead(Vec3(0, 0, -0.3 * mm), false);
  EXPECT_GT(desk.session.latest().tool.force.norm(), 0.1);
  desk.session.apply(view::Stop{});
  ASSERT_TRUE(soon([&] { return desk.session.latest().arming == ArmingState::fault; }));
  std::this_thread::sleep_for(50ms);
  EXPECT_GT(desk.session.latest().tool.contact_voxels, 0);
  EXPECT_EQ(desk.session.latest().tool.force, Vec3::Zero());
}

TEST(ViewSession, KeepsTheVolumeAndTheUndoMarksUnderAnotherHandle) {
  Desk desk;
  desk.lead(Vec3(0, 0, 1 * mm), false);
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  desk.lead(Vec3(0, 0, 1 * mm), false);
  const double removed = desk.session.latest().tool.removed_volume;
  ASSERT_GT(removed, 0);
  desk.turn("Handle length", 40);
  desk.lead(Vec3(0, 0, 1 * mm), false);
  EXPECT_EQ(desk.session.latest().tool.removed_volume, removed);
  EXPECT_EQ(desk.session.latest().tool.undo_marks, 1U);
}

TEST(ViewSession, ChangesTheHeadInTheRunAndTheHandleBesideIt) {
  Desk desk;
  desk.turn("Head", 1);
  desk.turn("Diameter", 2);
  EXPECT_NEAR(desk.model().tool().head().cutting_radius(), 1 * mm, 1e-9);
  const double before = desk.session.simulation().tool().X_HT().translation.norm();
  desk.turn("Handle length", 40);
  const Tool& tool = desk.model().tool();
  EXPECT_NEAR(tool.X_HT().translation.norm(), 40 * mm, 1e-9);
  EXPECT_NE(tool.X_HT().translation.norm(), before);
  EXPECT_NEAR(tool.head().cutting_radius(), 1 * mm, 1e-9) << "the head stays";
}

TEST(ViewSession, RecordsACompleteRun) {
  const test::TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  {
    Desk desk;
    desk.turn("Record", 1);
    desk.frames();
    desk.session.suspend();
    EXPECT_TRUE(std::filesystem::exists(folder / "session-1.h5"));
    EXPECT_FALSE(std::filesystem::exists(folder / "session-1.h5.new"));
  }
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace hapticut::view_session_test
