// SPDX-License-Identifier: Apache-2.0
// What `hapticut drill` says of the materials: which bear the force, and what a drill needs to cut them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

namespace hapticut::cli_drill_materials_test {
namespace {

using namespace test;
using DrillMaterials = Program;

TEST_F(DrillMaterials, TellsWhichMaterialsBearTheForce) {
  const nlohmann::json report =
      drill("--workpiece slab --size_mm 6,6,3 --layer enamel=1 --layer dentin=2 --voxel_mm 0.1 " + kSpinningBall +
            "--path line --from_mm 3,3,3.2 --to_mm 3,3,1 --feed_mm_per_s 2");
  const nlohmann::json& share = report["normal_force_share"];
  ASSERT_EQ(share.size(), 2U) << share;
  EXPECT_GT(share["enamel"], 0.1);
  EXPECT_GT(share["dentin"], 0.1);
  EXPECT_NEAR(share["enamel"].get<double>() + share["dentin"].get<double>(), 1, 1e-9);
}

// A drill that goes 4 um a second into bone takes chips of 80 nm.
TEST_F(DrillMaterials, SaysWhatLoadADrillNeedsToCut) {
  const std::string bone =
      "--workpiece block --size_mm 4,4,3 --material cortical_bone --voxel_mm 0.2 --head twist_drill --diameter_mm 2 "
      "--length_mm 8 --spindle_rpm 1500 --path line --from_mm 2,2,3 --to_mm 2,2,2.6 ";
  const std::string slow = bone + "--feed_mm_per_s 0.004 --rate 50 ";
  const auto warned = [&](const std::string& command, const std::string& words) {
    const nlohmann::json report = drill(command);
    return std::ranges::any_of(report["warnings"], [&](const nlohmann::json& warning) {
      return warning.get<std::string>().find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(warned(slow + "--sharpness worn", "press harder than 15 N"));
  EXPECT_TRUE(warned(slow, "press harder than 6 N"));
  EXPECT_FALSE(warned(bone + "--feed_mm_per_s 0.5 --sharpness new", "press harder"));
}

}  // namespace
}  // namespace hapticut::cli_drill_materials_test
