// SPDX-License-Identifier: Apache-2.0
// A scene as text: what an application makes of it, and what it is told where the text is wrong.
#include "hapticut/settings/scene.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::scene_test {
namespace {

using namespace units;

const std::string kScene = R"([workpiece]
source = "block"
size_mm = [3, 3, 1]
voxel_mm = 0.1
material = "cortical_bone"

[material.cortical_bone]
cutting_ratio = 0.4

[tool]
head = "sphere"
radius_mm = 0.8
handle = "ray"
handle_length_mm = 20
spindle_rpm = 40000

[simulation]
rate_Hz = 2000
reference_stiffness_N_per_m4 = 1e14
)";

const std::string kPath = R"([path]
kind = "line"
point = "head"
from_mm = [0, 1.5, 1.5]
to_mm = [3, 1.5, 1.5]
feed_mm_per_s = 3
)";

/// What is said of a scene that differs from `kScene`.
std::string complaint(const std::string& part, const std::string& in_its_place) {
  std::string text = kScene + kPath;
  text.replace(text.find(part), part.size(), in_its_place);
  try {
    (void)settings::from_toml(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Scene, GivesTheForceOfTheSameNumbersInCpp) {
  settings::Scene scene = settings::from_toml(kScene);
  EXPECT_EQ(scene.config.update_rate, 2000);
  EXPECT_EQ(scene.motion, std::nullopt);
  Simulation from_text(std::move(scene.workpiece), scene.tool, scene.config);

  Material bone = presets::cortical_bone();
  bone.cutting_ratio = 0.4;
  SimulationConfig config;
  config.update_rate = 2000;
  config.reference_stiffness = 1e14;
  Simulation from_code(build_block({Vec3::Zero(), Vec3(3, 3, 1) * mm}, 0.1 * mm, bone),
                       Tool(SphereHead{0.8 * mm}, RayHandle{20 * mm}, Spindle{40000 * rpm}), config);

  const Pose hand = Pose::from_translation(Vec3(1.5, 1.5, 1.5 + 20) * mm);
  const Vec3 force = from_text.step(hand, Twist{}, 5e-4).force;
  EXPECT_GT(force.z(), 0);
  EXPECT_EQ(force, from_code.step(hand, Twist{}, 5e-4).force);
}

TEST(Scene, MovesTheHeadAlongItsPath) {
  const settings::Scene scene = settings::from_toml(kScene + kPath);
  ASSERT_TRUE(scene.motion.has_value());
  EXPECT_NEAR(scene.motion->duration(), 1, 1e-12);  // 3 mm at 3 mm/s
  EXPECT_LT((scene.motion->pose_at(0.5).translation - Vec3(1.5, 1.5, 1.5) * mm).norm(), 1e-12);
}

TEST(Scene, LeavesTheTablesOfTheProgramAlone) {
  EXPECT_EQ(settings::from_toml(kScene + "[output]\njson = 7\n[loop]\nanything = true\n").config.update_rate, 2000);
}

TEST(Scene, NamesLineKeyAndRangeOfAWrongValue) {
  EXPECT_EQ(complaint("radius_mm = 0.8", "radius_mm = -1"), "scene:12: tool.radius_mm: must be a number > 0, not -1.");
  EXPECT_EQ(complaint("source = \"block\"", "source = 3"),
            "scene:2: workpiece.source: must be a text that is not empty, not a number.");
  EXPECT_EQ(complaint("cutting_ratio = 0.4", "cutting_ratio = -2").substr(0, 53),
            "scene:8: material.cortical_bone.cutting_ratio: must b");
}

TEST(Scene, NamesTheNearestKeyOfAnUnknownOne) {
  EXPECT_EQ(complaint("radius_mm = 0.8", "radios_mm = 0.8"),
            "scene:12: tool.radios_mm: there is no such setting. Did you mean tool.radius_mm?");
}

TEST(Scene, SaysWhatIsMissingAndWhatDoesNotFit) {
  EXPECT_NE(complaint("radius_mm = 0.8", "").find("tool.radius_mm is missing"), std::string::npos);
  EXPECT_NE(complaint("kind = \"line\"", "").find("the path is missing"), std::string::npos);
  EXPECT_NE(
      complaint("rate_Hz = 2000", "rate_Hz = 2000\nremoval = \"magic\"").find("simulation.removal: must be one of"),
      std::string::npos);
}

TEST(Scene, SaysOfAFileWhereItIsWrong) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "scene.toml";
  test::write_bytes(path, kScene);
  EXPECT_EQ(settings::from_file(path).config.reference_stiffness, 1e14);
  test::write_bytes(path, "[tool\n");
  EXPECT_THROW(
      try { (void)settings::from_file(path); } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(path.string() + ":1: not valid TOML: ")) << error.what();
        throw;
      },
      Error);
  EXPECT_THROW((void)settings::from_file(folder / "none.toml"), Error);
}

TEST(Scene, OfATextNamesFilesInTheGivenFolder) {
  const test::TemporaryFolder folder;
  test::write_bytes(folder / "p.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n1,1,0,0\n");
  const std::string text = kScene + "[path]\nkind = \"poses\"\nfile = \"p.csv\"\n";
  EXPECT_EQ(settings::from_toml(text, folder / "").motion.value().poses().size(), 2U);
  try {
    (void)settings::from_toml(text);
    ADD_FAILURE() << "it is not in the working folder";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find((std::filesystem::current_path() / "p.csv").string()), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace hapticut::scene_test
