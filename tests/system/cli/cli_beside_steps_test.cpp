// SPDX-License-Identifier: Apache-2.0
// Temperatures and loose pieces of hapticut drill and loop, run like a user does.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "support/program.hpp"

namespace hapticut::cli_beside_steps_test {
namespace {

using namespace test;

/// A hole of 1.5 mm into bone.
const std::string kHole = "--path line --from_mm 3,3,3.1 --to_mm 3,3,1.5 --feed_mm_per_s 0.5 ";
const std::string kHotDrill = kBlock + kSpinningBall + kHole + "--heat --voxels_per_cell 2 ";
const std::string kWater = "--irrigation_W_per_m2K 5000 ";

/// A bar of 0.8 mm x 0.8 mm x 6 mm, and a ball that cuts through it at a height of 4 mm.
const std::string kBar = "--workpiece block --size_mm 0.8,0.8,6 --material cortical_bone --voxel_mm 0.1 ";
const std::string kThroughBar =
    kBar +
    "--head sphere --radius_mm 0.6 --spindle_rpm 30000 --path line --point head --from_mm -1.6,0.4,4 --to_mm 2.4,0.4,4 "
    "--feed_mm_per_s 5 ";

class BesideSteps : public Program {
 protected:
  nlohmann::json loop(const std::string& arguments) { return report("loop " + arguments); }
  static bool warns(const nlohmann::json& report, const std::string& of) {
    return report["warnings"].dump().find(of) != std::string::npos;
  }
};

TEST_F(BesideSteps, ADryHoleIsHotAndWaterCoolsIt) {
  const nlohmann::json dry = drill(kHotDrill), wet = drill(kHotDrill + kWater);
  const auto &hot = dry["heat"]["by_material"]["cortical_bone"], &cool = wet["heat"]["by_material"]["cortical_bone"];
  EXPECT_GT(hot["peak_degC"], 42);
  EXPECT_GE(hot["peak_degC"], hot["temperature_degC"]);
  EXPECT_LT(cool["temperature_degC"].get<double>(), hot["temperature_degC"].get<double>() - 1);
  EXPECT_LT(cool["peak_degC"], hot["peak_degC"]);
  EXPECT_LE(cool["cem43_min"], hot["cem43_min"]);
  EXPECT_EQ(dry["removed_volume_mm3"], wet["removed_volume_mm3"]) << "no force depends on the temperature";
}

TEST_F(BesideSteps, TheWarmestPlaceIsInTheHole) {
  const nlohmann::json heat = drill(kHotDrill)["heat"];
  const auto& at = heat["warmest"]["position_mm"];
  EXPECT_NEAR(at[0], 3, 1.3);
  EXPECT_NEAR(at[1], 3, 1.3);
  EXPECT_GT(at[2], 1);
  EXPECT_GE(heat["warmest"]["temperature_degC"], heat["by_material"]["cortical_bone"]["peak_degC"]);
}

TEST_F(BesideSteps, TheBalanceOfTheHeatCloses) {
  const nlohmann::json heat = drill(kHotDrill + kWater)["heat"];
  const auto& balance = heat["balance_J"];
  const double in = balance["brought_in"];
  EXPECT_GT(in, 0);
  EXPECT_NEAR(in,
              balance["stored"].get<double>() + balance["chips"].get<double>() + balance["irrigation"].get<double>(),
              1e-9 * in);
  EXPECT_GT(balance["irrigation"], 0);
  EXPECT_EQ(heat["irrigation_W_per_m2K"], 5000);
  EXPECT_EQ(heat["body_temperature_degC"], 37);
  EXPECT_EQ(heat["threshold_degC"], 47);
}

TEST_F(BesideSteps, TwoRunsOfDrillGiveTheSameTemperatures) {
  EXPECT_EQ(drill(kHotDrill)["heat"], drill(kHotDrill)["heat"]);
}

TEST_F(BesideSteps, ADoseThatBoneDoesNotSurviveIsAWarningWithAdvice) {
  const std::string all = kHotDrill + "--cutting_share 1 ";
  const nlohmann::json report = drill(all);
  EXPECT_GT(report["heat"]["by_material"]["cortical_bone"]["time_above_s"], 0);
  EXPECT_GT(report["heat"]["by_material"]["cortical_bone"]["volume_above_mm3"], 0);
  EXPECT_TRUE(warns(report, "cortical_bone was above 47 deg C for")) << report["warnings"];
  EXPECT_TRUE(warns(report, "set --irrigation_W_per_m2K to the water of a spray")) << report["warnings"];
  EXPECT_FALSE(warns(drill(kHotDrill + "--cutting_share 0.001 "), "CEM43"));
}

TEST_F(BesideSteps, APulpThatBecomesTooWarmIsAWarning) {
  const std::string pulp =
      "--workpiece slab --size_mm 5,5,2 --voxel_mm 0.2 --layer dentin=1 --layer pulp=1 --heat --path line "
      "--from_mm 2.5,2.5,2.1 --to_mm 2.5,2.5,1.1 --feed_mm_per_s 0.3 --voxels_per_cell 2 " +
      kSpinningBall;
  const nlohmann::json report = drill(pulp + "--cutting_share 1 ");
  EXPECT_GT(report["heat"]["by_material"]["pulp"]["peak_degC"], 42.5);
  EXPECT_TRUE(warns(report, "K warmer, and after 5.5 K some pulps die (Zach and Cohen 1965)")) << report["warnings"];
  EXPECT_FALSE(warns(drill(pulp + "--cutting_share 0.001 "), "Zach"));
}

TEST_F(BesideSteps, TheTableOfDrillHasTheTemperatures) {
  const ProgramOutcome outcome = run("drill " + kHotDrill);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* text : {"warmest", "now ", "CEM43", "brought in ", "to the water 0 J"})
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << '\n' << outcome.out;
}

TEST_F(BesideSteps, WithoutTheirSettingsAReportHasNeither) {
  const nlohmann::json report = drill(kBlock + kBall + kGroove);
  EXPECT_FALSE(report.contains("heat"));
  EXPECT_FALSE(report.contains("loose_pieces"));
}

TEST_F(BesideSteps, ANumberOfTheHeatNeedsItsSwitch) {
  expect_refused("drill " + kBlock + kBall + kGroove + kWater,
                 {"--irrigation_W_per_m2K = 5000; must be left out, because a run without --heat has none. Leave it "
                  "out, or set --heat."});
}

TEST_F(BesideSteps, CellsOfThreeVoxelsAreRefused) {
  expect_refused("drill " + kBlock + kBall + kGroove + "--heat --voxels_per_cell 3",
                 {"--voxels_per_cell = 3; must be 1, 2, 4 or 8."});
}

TEST_F(BesideSteps, APieceThatIsCutLooseLeavesTheWorkpiece) {
  const auto left = [this](const std::string& switches) {
    const nlohmann::json report = drill(kThroughBar + switches + "--save " + path("left.vdb"));
    return std::pair(report, inspect(path("left.vdb"))["volume_mm3"]["cortical_bone"].get<double>());
  };
  const auto [kept, whole] = left("");
  const auto [removed, rest] = left("--remove_loose_pieces ");
  EXPECT_EQ(removed["loose_pieces"]["removed"], 1);
  EXPECT_NEAR(removed["loose_pieces"]["volume_mm3"], 0.8 * 0.8 * 1.4, 0.1);
  const auto cut = [](const nlohmann::json& report) { return report["removed_volume_mm3"]["total"].get<double>(); };
  EXPECT_NEAR(rest + cut(removed) + removed["loose_pieces"]["volume_mm3"].get<double>(), whole + cut(kept), 1e-6)
      << "a loose piece is not cut";
  EXPECT_LT(cut(removed), cut(kept)) << "the tool does not cut a piece that has left";
  EXPECT_EQ(drill(kThroughBar + "--remove_loose_pieces ")["loose_pieces"], removed["loose_pieces"]);
}

TEST_F(BesideSteps, ARecordingRefusesTheRemovalOfLoosePieces) {
  for (const std::string& command :
       {"drill " + kThroughBar, "loop mock:press --seconds 0.1 --simulated-time " + kBar}) {
    expect_refused(command + "--remove_loose_pieces --record " + path("run.h5"),
                   {"--record = ",
                    "; must be left out with --remove_loose_pieces, because a recording does not contain "
                    "removed pieces and would end at the first one. Leave out one of the two."});
    EXPECT_FALSE(std::filesystem::exists(folder / "run.h5"));
  }
}

TEST_F(BesideSteps, ALoopInSimulatedTimeRepeatsItsTemperatures) {
  const std::string run = "mock:spiral --seconds 2 --simulated-time " + kBlock + kSpinningBall + "--heat ";
  const nlohmann::json dry = loop(run), again = loop(run), wet = loop(run + kWater);
  EXPECT_GT(dry["heat"]["by_material"]["cortical_bone"]["peak_degC"], 37.5);
  EXPECT_EQ(dry["heat"], again["heat"]);
  EXPECT_LT(wet["heat"]["by_material"]["cortical_bone"]["temperature_degC"],
            dry["heat"]["by_material"]["cortical_bone"]["temperature_degC"]);
}

TEST_F(BesideSteps, ALoopInRealTimeHasTemperaturesBesideIt) {
  const nlohmann::json report =
      loop("mock:spiral --seconds 1.5 " + kBlock + kSpinningBall + "--heat --remove_loose_pieces ");
  const auto& balance = report["heat"]["balance_J"];
  EXPECT_GT(report["heat"]["by_material"]["cortical_bone"]["peak_degC"], 37);
  EXPECT_GT(balance["brought_in"], 0);
  EXPECT_EQ(report["loose_pieces"]["removed"], 0);
}

TEST_F(BesideSteps, ALoopRemovesThePieceThatItsToolCutsLoose) {
  // A ball is pressed through the middle of a bar that lies on its side.
  const std::string bar =
      "mock:press --workpiece block --size_mm 6,0.6,0.6 --material clay --voxel_mm 0.1 --head sphere --radius_mm 0.8 "
      "--spindle_rpm 30000 --seconds 3 --remove_loose_pieces ";
  for (const char* time : {"--simulated-time", ""}) {
    const nlohmann::json report = loop(bar + time);
    EXPECT_EQ(report["loose_pieces"]["removed"], 1) << time;
    EXPECT_GT(report["loose_pieces"]["volume_mm3"], 0.3) << time;
  }
}

}  // namespace
}  // namespace hapticut::cli_beside_steps_test
