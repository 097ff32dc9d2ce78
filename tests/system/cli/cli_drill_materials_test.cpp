// SPDX-License-Identifier: Apache-2.0
// What `hapticut drill` says of the materials: which bear the force, which cutter their constants are for, and what a
// drill needs to cut them.
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

/// A block of bone and a drill of 2 mm that goes down.
const std::string kPlunge =
    "--workpiece block --size_mm 4,4,3 --material cortical_bone --voxel_mm 0.2 --head twist_drill --diameter_mm 2 "
    "--length_mm 8 --spindle_rpm 1500 --path line --from_mm 2,2,3 --to_mm 2,2,2.6 ";

// A drill that goes 4 um a second into bone takes chips of 80 nm.
TEST_F(DrillMaterials, SaysWhatLoadAndFeedADrillNeedsToCut) {
  const std::string slow = kPlunge + "--feed_mm_per_s 0.004 --rate 50 ";
  const auto warnings = [&](const std::string& arguments) { return drill(arguments)["warnings"].dump(); };
  const std::string worn = warnings(slow + "--sharpness worn"), used = warnings(slow);
  EXPECT_NE(worn.find("they carry 15 N. Feed faster than 0.045 mm/s, or take a sharper drill with --sharpness new."),
            std::string::npos)
      << worn;
  EXPECT_NE(used.find("they carry 6 N. Feed faster than 0.018 mm/s, or take"), std::string::npos) << used;
  for (const char* fast : {"--feed_mm_per_s 0.045 --sharpness worn", "--feed_mm_per_s 0.5 --sharpness new",
                           "--feed_mm_per_s 1 --reference_stiffness 1e14"})
    EXPECT_EQ(warnings(kPlunge + "--rate 200 " + fast).find("carried the load"), std::string::npos) << fast;
}

TEST_F(DrillMaterials, AdvisesNoSharperDrillWhereSharpnessChangesNothing) {
  const std::string given = path("edge.toml");
  write_bytes(given, "[material.cortical_bone]\nedge_length_m = 5e-5\n");
  for (const std::string& more : {std::string("--feed_mm_per_s 0.001 --rate 20 --sharpness new"),
                                  "--feed_mm_per_s 0.004 --rate 50 --settings " + given}) {
    const std::string warnings = drill(kPlunge + more)["warnings"].dump();
    EXPECT_NE(warnings.find("carried the load"), std::string::npos) << more << warnings;
    EXPECT_EQ(warnings.find("sharp"), std::string::npos) << warnings;
  }
}

/// Files with the constants of two cutters, and drills of them.
class CutterOfAFile : public DrillMaterials {
 protected:
  void convert(const std::string& name, const std::string& more) {
    const ProgramOutcome outcome =
        run("convert block " + path(name) + " --size_mm 4,4,3 --material cortical_bone --voxel_mm 0.2 " + more);
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
  }
  nlohmann::json drill_file(const std::string& more) {
    return drill("--workpiece " + path("bone.vdb") +
                 " --head twist_drill --diameter_mm 2 --length_mm 8 --spindle_rpm 1500 --path line --from_mm 2,2,3.2 "
                 "--to_mm 2,2,1.5 --feed_mm_per_s 1 " +
                 more);
  }
  static std::string complaint(const nlohmann::json& report) {
    for (const nlohmann::json& warning : report["warnings"])
      if (const std::string text = warning; text.starts_with("the constants of")) return text;
    return "";
  }
};

TEST_F(CutterOfAFile, IsThatGivenToConvertAndInspectShowsIt) {
  convert("bone.vdb", "");
  EXPECT_EQ(inspect(path("bone.vdb"))["cutter"]["cortical_bone"], "carbide_bur");
  const nlohmann::json with_other = drill_file("");
  EXPECT_TRUE(complaint(with_other)
                  .starts_with("the constants of cortical_bone are for carbide_bur, and the tool cuts "
                               "with twist_drill"))
      << with_other["warnings"];
  EXPECT_NE(complaint(with_other).find("again with --cutter twist_drill"), std::string::npos) << complaint(with_other);
  const std::string again = "convert " + path("bone.vdb") + " " + path("again.vdb") + " --cutter twist_drill";
  expect_refused(again, {"--cutter = twist_drill was given, but cortical_bone", "keeps its constants for carbide_bur"});

  convert("bone.vdb", "--cutter twist_drill");
  EXPECT_EQ(inspect(path("bone.vdb"))["cutter"]["cortical_bone"], "twist_drill");
  const std::string table = read_bytes(folder / "stdout");
  EXPECT_NE(table.find("for twist_drill: cortical_bone\n"), std::string::npos) << table;
  const nlohmann::json with_own = drill_file("");
  EXPECT_EQ(complaint(with_own), "");
  EXPECT_GT(with_other["force_N"]["mean"], 2 * with_own["force_N"]["mean"].get<double>());
  EXPECT_EQ(run(again).code, 0);

  convert("bone.vdb", "--cutter twist_drill --sharpness worn");
  EXPECT_GT(drill_file("")["force_N"]["mean"], 1.2 * with_own["force_N"]["mean"].get<double>());
}

TEST_F(CutterOfAFile, IsReplacedInTheTableOfTheMaterial) {
  convert("bone.vdb", "--cutter twist_drill");
  const double right = drill_file("")["force_N"]["mean"];
  convert("bone.vdb", "");
  write_bytes(folder / "m.toml", "[material.cortical_bone]\nbased_on = \"cortical_bone\"\n");
  const nlohmann::json of_preset = drill_file("--settings " + path("m.toml"));
  EXPECT_EQ(complaint(of_preset), "");
  EXPECT_EQ(of_preset["force_N"]["mean"], right);
  const std::string constants =
      "[material.cortical_bone]\nedge_length_m = 1.8e-5\nspecific_cutting_energy_J_per_m3 = 75e6\nsize_length_m = 0\n"
      "cutting_ratio = 0.45\n";
  write_bytes(folder / "m.toml", constants);
  EXPECT_NE(complaint(drill_file("--settings " + path("m.toml"))), "") << "nobody says what they are for";
  write_bytes(folder / "m.toml", constants + "cutter = \"twist_drill\"\n");
  const nlohmann::json own = drill_file("--settings " + path("m.toml"));
  EXPECT_EQ(complaint(own), "");
  EXPECT_EQ(own["status"]["other_cutter"], 0);
  EXPECT_EQ(own["force_N"]["mean"], right);
}

TEST_F(DrillMaterials, WarnsOfACutterThatIsUnusualForTheHead) {
  const auto warnings = [&](const std::string& more) { return drill(more)["warnings"].dump(); };
  const std::string plunge = kPlunge + "--feed_mm_per_s 1 ";
  EXPECT_NE(warnings(plunge + "--cutter fine_diamond")
                .find("this head is usually a twist_drill, and with the constants "
                      "of fine_diamond"),
            std::string::npos);
  EXPECT_EQ(warnings(plunge + "--cutter twist_drill").find("usually"), std::string::npos);
  const std::string groove = kBlock + kSpinningBall + kGroove;
  EXPECT_NE(warnings(groove + "--cutter twist_drill").find("this head is usually a bur"), std::string::npos);
  for (const char* bur : {"--cutter coarse_diamond", "--cutter mastoid_cutting_bur", ""})
    EXPECT_EQ(warnings(groove + bur).find("usually"), std::string::npos) << bur;
}

}  // namespace
}  // namespace hapticut::cli_drill_materials_test
