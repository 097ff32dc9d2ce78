// SPDX-License-Identifier: Apache-2.0
// What runs beside the step in a session of `hapticut view`: temperatures and loose pieces, and the materials of a cut.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/errors.hpp"
#include "page/session/heat_watch.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "system/cli/view_desk.hpp"
#include "unit/view/command_bytes.hpp"

namespace hapticut::view_beside_test {
namespace {

using namespace std::chrono_literals;
using test::Desk;
using test::small_scene;
using units::mm;
using view_test::number_at;
using view_test::soon;

constexpr std::size_t kNow = 156, kPeak = 164;  // places in a message of heat with one material

/// A desk whose page reads the newest message of each kind.
struct Shown : Desk {
  using Desk::Desk;
  /// Waits until the page has received something.
  bool until(const std::function<bool()>& condition) {
    return soon([&] { return receive(), condition(); });
  }
  void receive() {
    session.frame(0.016);
    while (auto message = page.read()) {
      const auto kind = view::MessageKind((*message)[0]);
      if (kind == view::MessageKind::notice) notices.append(message->begin() + 12, message->end()).append("\n");
      newest[kind] = std::move(*message);
      if (kind == view::MessageKind::snapshot) return;
    }
  }
  [[nodiscard]] double heat(std::size_t place) const {
    const auto found = newest.find(view::MessageKind::heat);
    return found == newest.end() || found->second.size() <= kPeak ? 0 : number_at<double>(found->second, place);
  }
  view_test::Page page{server};
  std::map<view::MessageKind, view::Message> newest;
  std::string notices;
};

apps::ViewScene warm_scene() {
  apps::ViewScene scene = small_scene("block");
  scene.heat.cutting_share = 1;
  return scene;
}

TEST(ViewHeat, OfACutIsShownWhileItIsOn) {
  Shown desk(warm_scene());
  desk.lead(Vec3(0, 0, 1 * mm), false);
  ASSERT_TRUE(desk.until([&] { return desk.newest.contains(view::MessageKind::instruments); }));
  EXPECT_FALSE(desk.newest.contains(view::MessageKind::heat)) << "it is off";
  desk.turn("Heat", 1);
  desk.lead(Vec3(0, 0, 1 * mm), false);
  ASSERT_TRUE(desk.until([&] { return desk.heat(kNow) > 0; }));
  EXPECT_EQ(desk.heat(kNow), 37);
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  ASSERT_TRUE(desk.until([&] { return desk.heat(kPeak) > 37.5; }));
  const double peak = desk.heat(kPeak);
  desk.turn("Irrigation", 20000);
  desk.turn("Water", 1);
  ASSERT_TRUE(desk.until([&] { return desk.heat(kNow) < 37; })) << "water cools the whole block";
  EXPECT_GE(desk.heat(kPeak), peak);
  desk.turn("Heat", 0);
  ASSERT_TRUE(desk.until([&] { return desk.newest[view::MessageKind::heat].size() < kPeak; })) << "no cells";
}

TEST(ViewHeat, IsOnFromTheBeginningIfTheSceneSaysSo) {
  apps::ViewScene scene = warm_scene();
  scene.shows_heat = true;
  scene.heat.irrigation = 3000;
  scene.heat.body_temperature = 30;
  Shown desk(std::move(scene));
  ASSERT_TRUE(desk.until([&] { return desk.heat(kNow) > 0; }));
  EXPECT_LE(desk.heat(kPeak), 30);
}

TEST(ViewHeat, ThatCannotBeComputedIsRefusedAndTheRunContinues) {
  apps::ViewScene scene = small_scene("block");
  scene.heat.voxels_per_cell = 3;
  Shown desk(std::move(scene));
  desk.turn("Heat", 1);
  desk.frames();
  ASSERT_TRUE(desk.until([&] { return !desk.notices.empty(); }));
  test::expect_part(desk.notices, "must be 1, 2, 4 or 8");
  EXPECT_TRUE(desk.session.device().is_running());
}

TEST(ViewHeat, HasAByteForEachCell) {
  const apps::ViewScene scene = small_scene("block");
  const HeatField field(scene.workpiece, scene.heat);
  const view::Heat heat = apps::shown_heat(field);
  const auto [x, y, z] = heat.dims;
  EXPECT_EQ(heat.cells.size(), std::size_t(x) * y * z);
  EXPECT_EQ(heat.cell_size, field.cell_size());
  EXPECT_EQ(heat.X_WC.translation, field.center({0, 0, 0}));
  const std::array<int, 3> cell = {2, 3, 1};
  const Vec3 center = heat.X_WC * Vec3(heat.cell_size * Vec3(cell[0], cell[1], cell[2]));
  EXPECT_LT((center - field.center(cell)).norm(), 1e-12);
  const double byte = heat.cells[std::size_t(cell[0]) + x * (std::size_t(cell[1]) + y * std::size_t(cell[2]))];
  EXPECT_NEAR(heat.first + heat.step * (byte - 1), 37, heat.step / 2);
  const double line = (heat.threshold - heat.first) / heat.step;
  EXPECT_NEAR(line - std::floor(line), 0.5, 1e-9) << "between two bytes";
}

/// A thin bar that a ball cuts through at a height of 4 mm.
apps::ViewScene bar_scene() {
  apps::ViewScene scene = small_scene("bar");
  scene.box = {Vec3(-0.2, -0.2, 0) * mm, Vec3(0.2, 0.2, 6) * mm};
  scene.workpiece = build_block(scene.box, 0.1 * mm, test::plain_material());
  scene.tool = Tool(SphereHead{0.6 * mm}, RayHandle{20 * mm}, Spindle{3000 * units::rad_per_s});
  return scene;
}
constexpr VoxelIndex kTop = {1, 1, 55};

/// In small steps, so that the ball does not slip off.
void cut_through(Desk& desk) {
  desk.lead(Vec3(-1, 0, 3.4) * mm, false);
  for (const double y : {0.0, -0.2, 0.2})
    for (double x = -0.9; x < 1; x += 0.15) desk.lead(Vec3(x, y, 3.4) * mm, true);
}

TEST(ViewLoosePieces, DisappearWithANoticeAndComeBackWithAnUndo) {
  Shown desk(bar_scene());
  desk.turn("Remove loose pieces", 1);
  cut_through(desk);
  ASSERT_TRUE(desk.until([&] { return !desk.notices.empty(); }));
  EXPECT_EQ(desk.notices, "A loose piece was removed, 1 so far.\n");
  desk.lead(Vec3(2, 0, 3.4) * mm, false);
  EXPECT_EQ(desk.model().workpiece().material_at(kTop), kEmpty);
  desk.session.apply(view::LookAt{});
  desk.session.apply(commands::Undo{});
  ASSERT_TRUE(soon([&] { return desk.session.latest().tool.undo_marks == 0; }));
  desk.frames();
  EXPECT_NE(desk.model().workpiece().material_at(kTop), kEmpty) << "the bar is whole again";
}

TEST(ViewLoosePieces, StayWhileTheyAreNotAskedFor) {
  Desk desk(bar_scene());
  cut_through(desk);
  std::this_thread::sleep_for(200ms);
  EXPECT_NE(desk.model().workpiece().material_at(kTop), kEmpty);
  EXPECT_EQ(find_islands(desk.session.simulation().workpiece()).size(), 1U) << "the top is loose";
}

TEST(ViewLoosePieces, StayInARecording) {
  const test::TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  {
    apps::ViewScene scene = bar_scene();
    scene.removes_loose_pieces = true;
    Desk desk(std::move(scene));
    desk.turn("Record", 1);
    cut_through(desk);
    std::this_thread::sleep_for(200ms);
    EXPECT_NE(desk.model().workpiece().material_at(kTop), kEmpty);
    desk.session.suspend();
    EXPECT_TRUE(std::filesystem::exists(folder / "session-1.h5"));
  }
  std::filesystem::current_path(before);
}

TEST(ViewMaterials, OfACutAreToldWithTheirForceAndOtherwiseThatUnderTheTip) {
  Shown desk;
  desk.lead(Vec3(0, 0, 1 * mm), false);
  // Behind pose, power, ticks, missed ticks and the width of a bucket: buckets, volumes, forces, material.
  constexpr std::size_t kForce = 132 + 4 + 4 * apps::WatchedModel::kBuckets + 4 + 8 + 4, kUnder = kForce + 8;
  const auto told = [&](std::size_t place, auto number) {
    return number_at<decltype(number)>(desk.newest[view::MessageKind::instruments], place);
  };
  desk.receive();
  ASSERT_TRUE(desk.until([&] {
    const auto found = desk.newest.find(view::MessageKind::instruments);
    return found != desk.newest.end() && number_at<std::uint32_t>(found->second, kUnder) == 1;
  }));
  EXPECT_EQ(told(kForce, 0.0), 0);
  desk.lead(Vec3(0, 0, -0.3 * mm), true);
  EXPECT_TRUE(desk.until([&] { return told(kForce, 0.0) > 0.01; }));
  desk.lead(Vec3(10 * mm, 0, 1 * mm), false);
  EXPECT_TRUE(desk.until([&] { return told(kForce, 0.0) == 0 && told(kUnder, std::uint32_t(1)) == 0; })) << "air";
}

}  // namespace
}  // namespace hapticut::view_beside_test
