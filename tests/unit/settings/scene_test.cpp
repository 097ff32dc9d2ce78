// SPDX-License-Identifier: Apache-2.0
// A scene as text: the resulting objects, and the errors for wrong texts.
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

/// The error for a scene that differs from `kScene`.
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

// The origin of a ball is its centre, also on a shank.
TEST(Scene, MovesTheTipOfABallAlongItsPathAlsoOnAShank) {
  std::string text = kScene + kPath;
  const std::string point = "point = \"head\"\n", head = "head = \"sphere\"\n";
  text.erase(text.find(point), point.size());
  const auto centre = [&] { return settings::from_toml(text).motion->pose_at(0.5).translation; };
  const Vec3 of_a_ball = centre();
  EXPECT_LT((of_a_ball - Vec3(1.5, 1.5, 1.5 + 0.8) * mm).norm(), 1e-12);
  text.insert(text.find(head), "shank = \"friction_grip\"\nshank_neck_mm = 0.6\n");
  EXPECT_EQ(centre(), of_a_ball);
}

TEST(Scene, LeavesTheTablesOfTheProgramAlone) {
  EXPECT_EQ(settings::from_toml(kScene + "[output]\njson = 7\n[loop]\nanything = true\n").config.update_rate, 2000);
}

TEST(Scene, NamesLineKeyAndRangeOfAWrongValue) {
  EXPECT_EQ(complaint("radius_mm = 0.8", "radius_mm = -1"),
            "scene:12: tool.radius_mm: must be a number > 0 and <= 300, not -1.");
  EXPECT_EQ(complaint("source = \"block\"", "source = 3"),
            "scene:2: workpiece.source: must be a text that is not empty, not a number.");
  EXPECT_EQ(complaint("cutting_ratio = 0.4", "cutting_ratio = -2").substr(0, 53),
            "scene:8: material.cortical_bone.cutting_ratio: must b");
  EXPECT_EQ(complaint("rate_Hz = 2000", "rate_Hz = 5"),
            "scene:18: simulation.rate_Hz: must be a number from 10 to 1e+06, not 5.");
  EXPECT_EQ(complaint("[simulation]", "[force]\nthesis_spin_exponent = 11\n[simulation]"),
            "scene:18: force.thesis_spin_exponent: must be a number from -10 to 10, not 11.");
  EXPECT_EQ(complaint("[simulation]", "[effects]\nforce_axes = [1, 2, 0]\n[simulation]"),
            "scene:18: effects.force_axes: must be 3 numbers, each 0 or 1, not [1, 2, 0].");
  EXPECT_EQ(complaint("[workpiece]", "effects = 3\n[workpiece]"),
            "scene:1: effects: must be a table, written [effects].");
}

TEST(Scene, RefusesATextThatIsNotTomlWithTheCure) {
  const auto expect = [](const std::string& in_its_place, const std::string& part, int line = 3) {
    const std::string message = complaint("size_mm = [3, 3, 1]", in_its_place);
    EXPECT_TRUE(message.starts_with("scene:" + std::to_string(line) + ": ")) << in_its_place << '\n' << message;
    EXPECT_NE(message.find(part), std::string::npos) << in_its_place << '\n' << message;
    EXPECT_EQ(message.find("pars"), std::string::npos) << "words of a library: " << message;
    EXPECT_EQ(message.back(), '.');
  };
  for (const char* path : {R"(grid = "C:\Users\me")", R"(grid = "C:\data\skull.stl")"})
    expect(path, "write paths with / or in single quotes.");
  for (const char* text : {"grid = bone", "grid = bone.stl # ours", "grid = yes", "grid = \u22121"})
    expect(text, "put texts in quotation marks");
  for (const char* text : {"grid = \u201cbone\u201d", "grid = \u2018bone\u2019", "grid = \u00abbone\u00bb"})
    expect(text, "put texts in straight ones");
  for (const char* text : {"grid = \"bone", "grid = 'bone", "grid = \"a\"b\""}) expect(text, "close the text");
  for (const char* number : {"0,2", "1, 2, 3", "2 mm", ".2", "2.", "02", "-.5"})
    expect(std::string("unit_mm = ") + number, "with a decimal point between digits");
  for (const char* list : {"[1; 2]", "(1, 2, 3)", "{x = 1"}) expect(std::string("size_mm = ") + list, "[1.5, 2, 3]");
  for (const char* flag : {"True", "FALSE # not"}) expect(std::string("large = ") + flag, "in lower case");
  for (const char* empty : {"unit_mm =", "unit_mm = # mm"}) expect(empty, "there is no value after the =");
  for (const char* line : {"unit_mm: 3", "unit mm = 3", "unit_mm"}) expect(line, "neither [table] nor name = value");
  expect("size_mm = [3, 3", "write it like this, and close it", 4);
  for (const char* table : {"[tool", "[tool] large = true"}) expect(table, "write [tool]");
  expect("unit_mm = 1\nunit_mm = 2", "leave one of them out", 4);
  expect("[workpiece]", "leave one of them out");
  expect("grid = \"M\xfcller\"", "save it in UTF-8");
}

TEST(Scene, RefusesControlCharactersInNamesOfFiles) {
  EXPECT_EQ(complaint("\"block\"", R"("C:\temp\notes.stl")"),
            "scene:2: workpiece.source: the file name contains a control character, which a backslash in "
            "double quotes makes; write paths with / or in single quotes.");
}

TEST(Scene, NamesTheNearestKeyOfAnUnknownOne) {
  const auto expect = [](const std::string& part, const std::string& in_its_place, const std::string& message) {
    EXPECT_EQ(complaint(part, in_its_place), "scene:" + message);
  };
  const std::string no = ": there is no such setting. Did you mean ";
  expect("radius_mm = 0.8", "radios_mm = 0.8", "12: tool.radios_mm" + no + "tool.radius_mm?");
  expect("radius_mm = 0.8", "radius_cm = 0.08", "12: tool.radius_cm" + no + "tool.radius_mm?");
  expect("feed_mm_per_s = 3", "feed_m_per_s = 3", "25: path.feed_m_per_s" + no + "path.feed_mm_per_s?");
  expect("size_mm = [3, 3, 1]", "layers = [{material = \"dentin\", thickness = 2}]",
         "3: workpiece.layers.thickness" + no + "workpiece.layers.thickness_mm?");
  EXPECT_TRUE(
      complaint("cutting_ratio", "hardness").starts_with("scene:8: material.cortical_bone.hardness: there is no"));
  EXPECT_TRUE(complaint("[tool]", "[tol]").starts_with("scene:10: tol: there is no such setting."));
}

TEST(Scene, SaysWhatIsMissingAndWhatDoesNotFit) {
  EXPECT_NE(complaint("radius_mm = 0.8", "").find("tool.radius_mm is missing"), std::string::npos);
  EXPECT_NE(complaint("kind = \"line\"", "").find("path.kind is missing"), std::string::npos);
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
