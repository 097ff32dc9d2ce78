// SPDX-License-Identifier: Apache-2.0
// hapticut drill, run like a user does: its results and its files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "support/program.hpp"
#include "support/test_data.hpp"

namespace hapticut::cli_drill_test {
namespace {

using namespace test;
using Drill = Program;

TEST_F(Drill, ReportsEveryField) {
  const nlohmann::json report = drill(kBlock + kBall + kGroove);
  for (const char* pointer : {"/steps",
                              "/first_touch_s/cortical_bone",
                              "/removed_volume_mm3/total",
                              "/removed_volume_mm3/by_material/cortical_bone",
                              "/removed_voxels",
                              "/force_N/max",
                              "/force_N/mean",
                              "/torque_Nmm/max",
                              "/torque_Nmm/mean",
                              "/energy_closure",
                              "/step_time_us/p50",
                              "/step_time_us/p99",
                              "/step_time_us/p999",
                              "/step_time_us/max",
                              "/deadline_misses",
                              "/workpiece/dims/2",
                              "/workpiece/voxel_size_mm",
                              "/workpiece/memory_bytes",
                              "/energy_J/cutting",
                              "/status/engaged_layer_thick",
                              "/warnings",
                              "/build/version",
                              "/build/commit",
                              "/build/compiler",
                              "/build/cpu"})
    EXPECT_TRUE(report.contains(nlohmann::json::json_pointer(pointer))) << pointer;
  EXPECT_EQ(report["steps"], 500);
  EXPECT_EQ(report["workpiece"]["dims"], nlohmann::json({30, 30, 15}));
  EXPECT_LT(report["energy_closure"], 1e-3);
  EXPECT_GT(report["force_N"]["max"], report["force_N"]["mean"]);
  const auto& time = report["step_time_us"];
  EXPECT_GT(time["p50"], 0);
  EXPECT_LE(time["p50"], time["p99"]);
  EXPECT_LE(time["p99"], time["p999"]);
  EXPECT_LE(time["p999"], time["max"]);
}

TEST_F(Drill, RunsTheScenesOfTheThesis) {
  for (const char* name : {"case_6_5", "figures_7"})
    for (const char* head :
         {"", " --head cone --half_angle_deg 30 --height_mm 0.3", " --head flat --radius_mm 0.3 --height_mm 0.3"}) {
      const nlohmann::json report = drill("--settings " + test::source_path("examples/thesis").string() + "/" + name +
                                          ".toml" + head + " --spindle_rpm 300000");
      EXPECT_GT(report["removed_volume_mm3"]["total"], 0.001) << name << head;
      for (const auto& warning : report["warnings"])
        EXPECT_NE(warning.get<std::string>().find("took longer than 1 ms"), std::string::npos)
            << name << head << warning;
    }
}

// A flat head of 3 mm needs several milliseconds a step in such voxels, on any machine of today.
TEST_F(Drill, SaysThatItsStepsTakeLongerThanALoopAllows) {
  const auto says_so = [this](const std::string& voxels) {
    const nlohmann::json report = drill(
        "--workpiece block --size_mm 8,8,4 --material cortical_bone --head flat --radius_mm 3 --height_mm 4 "
        "--spindle_rpm 0 --path line --from_mm 4,4,4.1 --to_mm 4,4,3.8 --feed_mm_per_s 10 --voxel_mm " +
        voxels);
    return report["warnings"].dump().find("took longer than 1 ms") != std::string::npos;
  };
  EXPECT_TRUE(says_so("0.04"));
  EXPECT_FALSE(says_so("0.4"));
}

TEST_F(Drill, PrintsTheLossesBesideTheWork) {
  const auto energy = [this](const std::string& head) {
    const nlohmann::json losses = drill(kBlock + head + kGroove)["energy_J"];
    const std::string out = read_bytes(folder / "stdout");
    const std::size_t line = out.find("  energy ");
    EXPECT_NE(line, std::string::npos) << out;
    return std::pair(losses, out.substr(line, out.find('\n', line) - line));
  };
  const auto [turning, of_turning] = energy(kStiffBall);
  EXPECT_GT(turning["rubbing"], 0.1 * turning["cutting"].get<double>());
  EXPECT_NE(of_turning.find(" J, rubbing "), std::string::npos) << of_turning;
  EXPECT_EQ(of_turning.find("crushed") != std::string::npos, turning["crushed"].get<double>() > 0) << of_turning;
  const auto [standing, of_standing] = energy("--head sphere --radius_mm 1 --spindle_rpm 0 ");
  EXPECT_GT(standing["crushed"], 0);
  EXPECT_NE(of_standing.find(" J, crushed "), std::string::npos) << of_standing;
}

TEST_F(Drill, CutsTheVolumeThatABallSweeps) {
  // The tip passes 0.5 mm below the face. The groove is a circular segment of that height, 6 mm long. The engaged layer
  // remains behind the ball: 1 % of the volume here.
  const nlohmann::json report =
      drill("--workpiece block --size_mm 6,6,3 --material cortical_bone --voxel_mm 0.1 " + kSpinningBall +
            "--reference_stiffness 1e18 --path line --from_mm -2,3,2.5 --to_mm 8,3,2.5 --feed_mm_per_s 4");
  const double half_angle = std::acos(0.5);
  const double segment = half_angle - std::sin(half_angle) * std::cos(half_angle);
  EXPECT_NEAR(report["removed_volume_mm3"]["total"].get<double>() / (6 * segment), 1, 0.02);
}

TEST_F(Drill, WithoutSpindleTakesNothingAway) {
  // The foundation is soft, so the pressure stays below the bone's strength. A stiffer foundation would crush the bone.
  const nlohmann::json report =
      drill(kBlock + "--head sphere --radius_mm 1 --spindle_rpm 0 --reference_stiffness 1e11 " + kGroove);
  EXPECT_EQ(report["removed_volume_mm3"]["total"], 0);
  EXPECT_GT(report["force_N"]["max"], 0);
}

TEST_F(Drill, WritesALineForEveryStep) {
  const nlohmann::json report = drill(kBlock + kBall + kGroove + "--steps-csv " + path("steps.csv"));
  const auto columns = read_csv(read_bytes(folder / "steps.csv"));
  const std::size_t steps = report["steps"];
  for (const char* name : {"t_s", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz", "force_x_N", "force_y_N", "force_z_N",
                           "torque_x_Nmm", "torque_y_Nmm", "torque_z_Nmm", "removed_mm3", "contact_voxels", "status"})
    ASSERT_EQ(columns.at(name).size(), steps) << name;
  double removed = 0, max_force = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    removed += columns.at("removed_mm3")[i];
    max_force = std::max(
        max_force, std::hypot(columns.at("force_x_N")[i], columns.at("force_y_N")[i], columns.at("force_z_N")[i]));
  }
  EXPECT_NEAR(removed / report["removed_volume_mm3"]["total"].get<double>(), 1, 1e-4);  // six printed digits
  EXPECT_NEAR(max_force / report["force_N"]["max"].get<double>(), 1, 1e-4);
  EXPECT_NEAR(columns.at("t_s").back(), 0.5, 1e-9);
  EXPECT_NEAR(columns.at("z_mm").back(), 3.5, 1e-9);  // the centre of the ball
}

TEST_F(Drill, FollowsItsOwnStepsAsPoses) {
  const nlohmann::json first = drill(kBlock + kBall + kGroove + "--steps_csv " + path("steps.csv"));
  const nlohmann::json again = drill(kBlock + kBall + "--path poses --point head --poses " + path("steps.csv"));
  EXPECT_EQ(again["steps"], 499);  // the first line of the file is the start of the path
  EXPECT_NEAR(again["removed_volume_mm3"]["total"].get<double>() / first["removed_volume_mm3"]["total"].get<double>(),
              1, 1e-4);
}

TEST_F(Drill, InterpolatesBetweenTimedPoses) {
  // From upright to lying on the side (a quarter turn about y) in half a second, with a fixed centre.
  write_bytes(folder / "poses.csv",
              "# made by hand\n t_s , x_mm, y_mm, z_mm, qw, qx, qy, qz, note\n"
              "0, 3, 3, 5, 1, 0, 0, 0, upright\n\n0.5, 3, 3, 5, 0.70710678, 0, 0.70710678, 0, lying\n");
  const auto columns = steps(kBlock + kBall + "--path poses --point head --poses " + path("poses.csv") + " --rate 100");
  ASSERT_EQ(columns.at("qw").size(), 50U);
  EXPECT_NEAR(columns.at("qw")[24], std::cos(units::kPi / 16 * 2), 1e-6);  // halfway: an eighth of a turn
  EXPECT_NEAR(columns.at("qy")[24], std::sin(units::kPi / 16 * 2), 1e-6);
  EXPECT_NEAR(columns.at("z_mm")[24], 5, 1e-9);
}

TEST_F(Drill, ReadsRotationMatricesAndPosesOfTheHand) {
  write_bytes(folder / "poses.csv",
              "t_s,x_mm,y_mm,z_mm,r00,r01,r02,r10,r11,r12,r20,r21,r22\n"
              "0,3,3,53,1,0,0,0,1,0,0,0,1\n1,3,3,52,1,0,0,0,1,0,0,0,1\n");
  const auto columns =
      steps(kBlock + kBall + "--handle_length_mm 50 --path poses --point handle --poses " + path("poses.csv"));
  EXPECT_NEAR(columns.at("z_mm").back(), 2, 1e-9);
}

TEST_F(Drill, FollowsCirclesAtConstantFeed) {
  const auto columns =
      steps(kBlock + kBall + "--path circle --center_mm 3,3,2.5 --circle_radius_mm 1.5 --turns 1 --feed_mm_per_s 10 " +
            "--approach_mm 2");
  const std::size_t steps = columns.at("t_s").size();
  EXPECT_EQ(steps, std::size_t(std::ceil((2 + 2 * units::kPi * 1.5) / 10 * 1000)));
  EXPECT_NEAR(columns.at("z_mm")[0], 5.49, 1e-6);
  for (std::size_t i = 200; i < steps; ++i)
    ASSERT_NEAR(std::hypot(columns.at("x_mm")[i] - 3, columns.at("y_mm")[i] - 3), 1.5, 1e-4);
}

TEST_F(Drill, WidensAndDeepensAlongASpiral) {
  const auto columns = steps(
      kBlock + kBall + "--path spiral --center_mm 3,3,3 --start_radius_mm 0.2 --end_radius_mm 1.4 --depth_mm 0.9 " +
      "--pitch_mm 0.5 --feed_mm_per_s 20 --approach_mm 1 --point head");
  EXPECT_NEAR(columns.at("z_mm").back(), 2.1, 1e-6);
  EXPECT_NEAR(std::hypot(columns.at("x_mm").back() - 3, columns.at("y_mm").back() - 3), 1.4, 1e-6);
  // sqrt(1.2^2 + 0.9^2) = 1.5 mm of cone at 0.5 mm per turn: three turns, so the path ends at its initial angle.
  EXPECT_NEAR(columns.at("y_mm").back(), 3, 1e-6);
}

TEST_F(Drill, ClearsACavityLayerByLayer) {
  const nlohmann::json report =
      drill(kBlock + "--head flat --radius_mm 0.6 --height_mm 4 --spindle_rpm 100000 --reference_stiffness 3e17 " +
            "--path cavity --center_mm 3,3,3 --top_radius_mm 1.2 --bottom_radius_mm 1.2 --depth_mm 1 --layer_mm 0.5 " +
            "--pitch_mm 0.5 --feed_mm_per_s 10 --approach_mm 1 --retract_mm 2");
  // A cylinder of 1.2 + 0.6 mm radius, 1 mm deep; the first layer leaves the part that only the engaged layer would
  // reach.
  EXPECT_NEAR(report["removed_volume_mm3"]["total"].get<double>() / (units::kPi * 1.8 * 1.8), 1, 0.05);
}

TEST_F(Drill, EntersAndLeavesAlongTheToolAxis) {
  const auto columns =
      steps(kBlock + kBall + "--path line --from_mm 1,3,2.5 --to_mm 5,3,2.5 --feed_mm_per_s 10 --tool_axis 0,0,2 " +
            "--approach_mm 3 --retract_mm 4 --approach_feed_mm_per_s 20");
  const std::size_t steps = columns.at("t_s").size();
  EXPECT_EQ(steps, 150U + 400 + 200);
  const double kRadius = 1;  // the tip is below the centre
  EXPECT_NEAR(columns.at("z_mm")[149], 2.5 + kRadius, 1e-6);
  EXPECT_NEAR(columns.at("x_mm")[149], 1, 1e-6);
  EXPECT_NEAR(columns.at("x_mm")[549], 5, 1e-6);
  EXPECT_NEAR(columns.at("z_mm").back(), 2.5 + kRadius + 4, 1e-6);
  EXPECT_NEAR(columns.at("z_mm")[649], 2.5 + kRadius + 2, 1e-6);
}

TEST_F(Drill, ReportsWhenEachMaterialIsFirstTouched) {
  const std::string down = kBall + "--path line --from_mm 3,3,5 --to_mm 3,3,1 --feed_mm_per_s 4 --point head ";
  const auto columns = steps(kBlock + down);  // the head's lowest point meets the top, at 3 mm, after 0.25 s
  std::size_t first = 0;
  while (columns.at("contact_voxels")[first] == 0) ++first;
  const nlohmann::json report = drill(kBlock + down);
  EXPECT_DOUBLE_EQ(report["first_touch_s"]["cortical_bone"], columns.at("t_s")[first]);
  EXPECT_NEAR(report["first_touch_s"]["cortical_bone"], 0.25, 0.01);
  EXPECT_NE(read_bytes(folder / "stdout").find("cortical_bone at 0.2"), std::string::npos);
}

TEST_F(Drill, WarnsWhenThePathNeverTouches) {
  const nlohmann::json report =
      drill(kBlock + kBall + "--path line --from_mm 0,0,50 --to_mm 5,0,50 --feed_mm_per_s 20");
  ASSERT_EQ(report["warnings"].size(), 1U);
  EXPECT_TRUE(report["first_touch_s"].empty());
  EXPECT_NE(report["warnings"][0].get<std::string>().find("never touches"), std::string::npos);
  EXPECT_NE(read_bytes(folder / "stdout").find("never touches"), std::string::npos);
}

TEST_F(Drill, WarnsWhenThePathStartsInside) {
  const nlohmann::json report = drill(kBlock + kBall + "--path line --from_mm 3,3,1 --to_mm 3,3,2 --feed_mm_per_s 20");
  ASSERT_GE(report["warnings"].size(), 1U);
  EXPECT_NE(report["warnings"][0].get<std::string>().find("starts inside"), std::string::npos);
}

TEST_F(Drill, WarnsOfASpindleThatStandsOrStallsInsteadOfTheStiffness) {
  const std::string feed = kBlock + "--head sphere --radius_mm 1 " + kGroove;
  const nlohmann::json standing = drill(feed + "--spindle_rpm 0");
  ASSERT_EQ(standing["warnings"].size(), 1U) << standing["warnings"];
  const std::string stands = standing["warnings"][0];
  EXPECT_NE(stands.find("the spindle stood in " + standing["status"]["spindle_stands"].dump() + " steps"),
            std::string::npos)
      << stands;
  EXPECT_NE(stands.find("--spindle_rpm"), std::string::npos) << stands;
  const nlohmann::json stalling = drill(feed + "--spindle_rpm 30000 --motor electric --torque_limit_Nmm 0.001");
  ASSERT_EQ(stalling["warnings"].size(), 1U) << stalling["warnings"];
  EXPECT_NE(stalling["warnings"][0].get<std::string>().find("stalled the spindle"), std::string::npos);
}

TEST_F(Drill, SaysThatRemovalIsOffInsteadOfACureForAStall) {
  const nlohmann::json report =
      drill(kBlock + "--head sphere --radius_mm 1 --spindle_rpm 30000 --removal none " + kGroove);
  EXPECT_GT(report["status"]["spindle_stalled"], 0);
  ASSERT_EQ(report["warnings"].size(), 1U) << report["warnings"];
  EXPECT_EQ(report["warnings"][0], "removal is off (--removal is none), so nothing was removed.");
}

TEST_F(Drill, CountsOfTheStepsWithAThickLayerThoseThatRemoveMaterial) {
  const nlohmann::json report = drill(kBlock + kSpinningBall + "--reference_stiffness 1e12 " + kGroove);
  ASSERT_GT(report["status"]["engaged_layer_thick"], report["steps_cutting"]) << "some steps only touch";
  std::string counts;
  for (const nlohmann::json& warning : report["warnings"])
    if (warning.dump().find("the engaged layer was thicker") != std::string::npos) counts = warning;
  std::size_t thick = 0, cutting = 0;
  ASSERT_EQ(std::sscanf(counts.c_str(), "in %zu steps of %zu that cut", &thick, &cutting), 2) << counts;
  EXPECT_EQ(cutting, report["steps_cutting"]);
  EXPECT_LE(thick, cutting);
}

TEST_F(Drill, FailsWhenStepsAreRejected) {
  expect_refused("drill " + kBlock + kBall + "--path line --from_mm -20,3,2 --to_mm 20,3,2 --feed_mm_per_s 10000 " +
                     "--json " + path("report.json"),
                 {"rejected"});
  EXPECT_GT(read_json(folder / "report.json")["status"]["jump_rejected"], 0);
}

TEST_F(Drill, SaysWhichStepWasRejectedFirst) {
  // Above the block for 0.1 s, then a jump of 24 mm within a millisecond into the block.
  write_bytes(folder / "poses.csv", "t_s,x_mm,y_mm,z_mm\n0,3,3,25\n0.1,3,3,24.9\n0.101,3,3,0.9\n0.2,3,3,0.8\n");
  expect_refused(
      "drill " + kBlock + kBall + "--path poses --poses " + path("poses.csv") + " --json " + path("report.json"),
      {"were rejected"});
  const nlohmann::json report = read_json(folder / "report.json");
  ASSERT_GE(report["warnings"].size(), 1U);
  const std::string first = report["warnings"][0];
  EXPECT_NE(
      first.find(report["status"]["jump_rejected"].dump() + " steps of 200 were rejected, the first is step 101;"),
      std::string::npos)
      << first;
  EXPECT_EQ(report["warnings"].dump().find("never touches"), std::string::npos) << report["warnings"];
}

TEST_F(Drill, RefillsTheBlocksBetweenSteps) {
  const nlohmann::json report = drill(kBlock + kBall + kGroove + "--reserved_blocks 64");
  EXPECT_EQ(report["status"]["blocks_exhausted"], 0);
}

TEST_F(Drill, CutsTheLayersOfASlab) {
  const nlohmann::json report =
      drill("--workpiece slab --size_mm 6,6,3 --layer enamel=0.4 --layer dentin=2 --voxel_mm 0.2 " + kBall +
            "--path line --from_mm 3,3,4 --to_mm 3,3,2 --feed_mm_per_s 5");
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["enamel"], 0);
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["dentin"], 0);
}

TEST_F(Drill, SaysWhichLayersOfASlabAreNotOfWholeVoxels) {
  const auto warnings = [&](const std::string& enamel) {
    return drill("--workpiece slab --size_mm 6,6,3 --layer enamel=" + enamel + " --layer dentin=2 --voxel_mm 0.2 " +
                 kBall + "--path line --from_mm 3,3,4 --to_mm 3,3,2 --feed_mm_per_s 5")["warnings"]
        .dump();
  };
  EXPECT_EQ(warnings("0.4").find("too coarse"), std::string::npos);
  EXPECT_NE(warnings("0.27").find("voxels of 0.2 mm are too coarse for the layers: 'enamel' fills 7.2 mm^3, its "
                                  "layers 9.72 mm^3"),
            std::string::npos)
      << warnings("0.27");
}

TEST_F(Drill, SavesTheRemainingMaterialAndContinuesFromIt) {
  const nlohmann::json first = drill(kBlock + kStiffBall + kGroove + "--save " + path("left.vdb"));
  const nlohmann::json second = drill("--workpiece " + path("left.vdb") + " " + kStiffBall + kGroove);
  EXPECT_LT(second["removed_volume_mm3"]["total"].get<double>(),
            0.2 * first["removed_volume_mm3"]["total"].get<double>());
  EXPECT_NEAR(second["workpiece"]["volume_mm3"]["cortical_bone"].get<double>(),
              108 - first["removed_volume_mm3"]["total"].get<double>(), 1e-3);
}

TEST_F(Drill, TakesSettingsFromAFileAndFlagsOverride) {
  write_bytes(folder / "settings.toml", R"(
[workpiece]
source = "block"
size_mm = [6, 6, 3]
voxel_mm = 0.2
material = "hard"
[material.hard]
based_on = "cortical_bone"
specific_cutting_energy_J_per_m3 = 3e9
[tool]
head = "sphere"
radius_mm = 1           # a whole number is a number
spindle_rpm = 30000
[path]
kind = "line"
from_mm = [-2, 3, 2.5]
to_mm = [8, 3, 2.5]
feed_mm_per_s = 20
[simulation]
rate_Hz = 1000
reference_stiffness_N_per_m4 = 3e15
)");
  const nlohmann::json hard = drill("--settings " + path("settings.toml"));
  const nlohmann::json soft = drill("--settings " + path("settings.toml") + " --material cortical_bone --rate 500");
  EXPECT_EQ(hard["steps"], 500);
  EXPECT_EQ(soft["steps"], 250);
  EXPECT_TRUE(hard["removed_volume_mm3"]["by_material"].contains("hard"));
  EXPECT_GT(hard["force_N"]["mean"].get<double>(), 2 * soft["force_N"]["mean"].get<double>());
}

TEST_F(Drill, PreparesTheMolarOfTheDemo) {
  const nlohmann::json report =
      drill("--settings " + test::source_path("examples/demo/molar.toml").string() + " --voxel_mm 0.2 --rate 200");
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["enamel"], 1);
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["dentin"], 1);
  EXPECT_LT(report["force_N"]["max"], 50);
  EXPECT_LT(report["energy_closure"], 0.01);
}

#ifdef HAPTICUT_HAS_IMPORT
TEST_F(Drill, ClearsTheMastoidOfTheDemo) {
  const std::filesystem::path project = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(project)) GTEST_SKIP() << "needs the Debian package invesalius-examples";
  const nlohmann::json report =
      drill("--settings " + test::source_path("examples/demo/skull.toml").string() + " --voxel_mm 0.5 --rate 100");
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["cortical_bone"], 10);
  EXPECT_GT(report["removed_volume_mm3"]["by_material"]["trabecular_bone"], 10);
  EXPECT_LT(report["force_N"]["max"], 50);  // [N] a hand can apply this force
  EXPECT_EQ(report["status"]["spindle_stalled"], 0);
  EXPECT_LT(report["energy_closure"], 0.01);
}
#endif

}  // namespace
}  // namespace hapticut::cli_drill_test
