// SPDX-License-Identifier: Apache-2.0
// The scenes of `hapticut view`, and the first material that a drill meets in the skull.
#include "page/session/view_scenes.hpp"

#include <gtest/gtest.h>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "support/places.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::view_scenes_test {
namespace {

using apps::make_view_scene;
using apps::ViewScene;
using units::mm;

Simulation simulation_of(const ViewScene& scene) { return {scene.workpiece.clone(), scene.tool, scene.config}; }

/// Whether the tool starts in free air and meets material on its axis through the centre.
void expect_ready_to_drill(const ViewScene& scene) {
  const Simulation simulation = simulation_of(scene);
  Pose X_WT = apps::start_pose(scene);
  const auto touches = [&] { return simulation.touches(X_WT * scene.tool.X_HT().inverse()); };
  EXPECT_FALSE(touches()) << scene.name;
  EXPECT_LT((X_WT.rotation.col(2) - scene.axis).norm(), 1e-12) << scene.name;
  bool met = false;
  for (int n = 0; n < 100 && !met; ++n, met = touches()) X_WT.translation -= 0.5 * mm * scene.axis;
  EXPECT_TRUE(met) << scene.name;
}

TEST(ViewScenes, AreReadyToBeDrilled) {
  for (const char* name : {"clay", "molar"}) {
    const ViewScene scene = make_view_scene(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_GT(scene.tool.spindle().speed, 0);
    expect_ready_to_drill(scene);
  }
}

// A Touch has a friction of its own of 0.13 N.
TEST(ViewScenes, OfClayIsFelt) {
  const ViewScene scene = make_view_scene("clay");
  Simulation simulation = simulation_of(scene);
  Pose X_WT = apps::start_pose(scene);
  double felt = 0;  // [N]
  for (int tick = 0; tick < 10'000 && felt < 0.5; ++tick) {
    X_WT.translation -= 5e-6 * scene.axis;
    const Twist down{-5 * mm * scene.axis, Vec3::Zero()};
    felt = simulation.step(X_WT * scene.tool.X_HT().inverse(), down, 1e-3).force.norm();
  }
  EXPECT_GE(felt, 0.5);
}

TEST(ViewScenes, OfASettingsFileHaveWhatItSays) {
  const test::TemporaryFolder folder;
  test::write_bytes(folder / "a.toml",
                    "[workpiece]\nsource = \"block\"\nsize_mm = [6, 6, 3]\nmaterial = \"dentin\"\nvoxel_mm = 0.3\n"
                    "[tool]\nhead = \"cone\"\nhalf_angle_deg = 30\nheight_mm = 2\nspindle_rpm = "
                    "30000\ncutter = \"coarse_diamond\"\n[simulation]\nrate_Hz = 1000\n");
  const ViewScene scene = make_view_scene((folder / "a.toml").string());
  EXPECT_EQ(scene.workpiece.materials()[MaterialId(1)].name, "dentin");
  EXPECT_EQ(scene.workpiece.materials()[MaterialId(1)].cutter, CutterKind::coarse_diamond);
  EXPECT_TRUE(std::holds_alternative<ConeHead>(scene.tool.head().shape()));
  expect_ready_to_drill(scene);
}

TEST(ViewScenes, HaveHeatAndLoosePiecesAsTheSettingsFileSays) {
  const ViewScene clay = make_view_scene("clay");
  EXPECT_FALSE(clay.shows_heat);
  EXPECT_FALSE(clay.removes_loose_pieces);
  const test::TemporaryFolder folder;
  const std::string block =
      "[workpiece]\nsource = \"block\"\nsize_mm = [6, 6, 3]\nmaterial = \"dentin\"\nvoxel_mm = 0.3\n";
  test::write_bytes(
      folder / "a.toml",
      block + "[simulation]\nremove_loose_pieces = true\n[heat]\non = true\nirrigation_W_per_m2K = 2000\n");
  const ViewScene wet = make_view_scene((folder / "a.toml").string());
  EXPECT_TRUE(wet.shows_heat);
  EXPECT_TRUE(wet.removes_loose_pieces);
  EXPECT_EQ(wet.heat.irrigation, 2000);
  EXPECT_EQ(wet.heat.by_material.at(0), thermal_properties_of("dentin"));
}

TEST(ViewScenes, OfAWorkpieceHaveABallThatSuitsIt) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "a.vdb").string();
  save_vdb(build_block({Vec3::Zero(), Vec3(24, 12, 12) * mm}, 0.5 * mm, Material{.name = "a"}), path);
  const ViewScene scene = make_view_scene(path);
  EXPECT_NEAR(scene.tool.head().max_radius(), 1 * mm, 1e-12);  // a twelfth of the size
  expect_ready_to_drill(scene);
}

TEST(ViewScenes, ThatDoNotExistAreRefusedInASentence) {
  try {
    (void)make_view_scene("mollar");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("there is no scene 'mollar'. Choose clay, molar or skull"),
              std::string::npos);
  }
}

TEST(ViewScenes, AreNoOtherFiles) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.nrrd", "a.stl", "a.h5"}) test::write_bytes(folder / name, "any");
  std::filesystem::create_directory(folder / "scan");
  std::filesystem::create_directory(folder / "b.vdb");
  for (const std::string& name : {(folder / "a.nrrd").string(), (folder / "a.stl").string(), (folder / "scan").string(),
                                  (folder / "b.vdb").string(), std::string("/dev/zero")}) {
    const std::string said = test::refusal([&] { return make_view_scene(name); });
    test::expect_part(said, "'" + name + "' is no scene. Choose clay, molar or skull, a settings file (.toml), or");
    EXPECT_EQ(said.find("--"), std::string::npos) << said;
  }
  test::expect_refused([&] { return make_view_scene((folder / "a.h5").string()); }, "is a recording");
}

TEST(ViewScenes, OfTheSkullMeetACorticalPlateFirst) {
  if (!std::filesystem::exists("/usr/share/doc/invesalius-examples/examples/Cranium.inv3"))
    GTEST_SKIP() << "needs the Debian package invesalius-examples";
  ViewScene scene = make_view_scene("skull");
  expect_ready_to_drill(scene);
  // From its start, a ball of 3 mm moves in until it has cut 3 mm^3. By grey values alone, 90 % of this would be
  // trabecular bone.
  constexpr double kWanted = 3e-9, kMaxTrabecular = 0.2, kDt = 1e-3;
  const Tool ball(SphereHead{1.5 * mm}, RayHandle{0}, scene.tool.spindle());
  Simulation simulation(scene.workpiece.clone(), ball, scene.config);
  Pose X_WT = apps::start_pose(scene);
  const Twist feed{-10 * mm * scene.axis, Vec3::Zero()};
  const auto& removed = simulation.totals().removed_volume;
  for (int n = 0; n < 2000 && removed[1] + removed[2] < kWanted; ++n) {
    X_WT.translation += kDt * feed.linear;
    (void)simulation.step(X_WT * ball.X_HT().inverse(), feed, kDt);
  }
  ASSERT_EQ(scene.workpiece.materials()[MaterialId(1)].name, "trabecular_bone");
  EXPECT_GE(removed[1] + removed[2], kWanted);
  EXPECT_LT(removed[1] / (removed[1] + removed[2]), kMaxTrabecular);
}

}  // namespace
}  // namespace hapticut::view_scenes_test
