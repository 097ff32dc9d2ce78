// SPDX-License-Identifier: Apache-2.0
// Warnings of `hapticut drill` and `loop` have numbers whose use ends the warning.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

namespace hapticut::cli_warnings_test {
namespace {

using namespace test;

class Warnings : public Program {
 protected:
  /// The first warning of a report that contains a text; empty if none does.
  static std::string with(const nlohmann::json& report, const std::string& part) {
    for (const nlohmann::json& warning : report["warnings"])
      if (const std::string text = warning; text.find(part) != std::string::npos) return text;
    return "";
  }
  nlohmann::json loop(const std::string& more) {
    return report("loop mock:press,hand=nominal --seconds 3 --simulated-time " + more);
  }
};

TEST_F(Warnings, SayThatNoHandGivesTheForce) {
  const std::string fast = kBlock + "--head sphere --radius_mm 1 --spindle_rpm 2000 --motor ideal " + kGroove;
  const nlohmann::json strong = drill(fast + "--cutter fine_diamond");
  ASSERT_GT(strong["force_N"]["max"], 50);
  EXPECT_NE(with(strong, "more than the 50 N that a hand can give"), "") << strong["warnings"];
  const nlohmann::json weak = drill(kBlock + kBall + kGroove);
  ASSERT_LT(weak["force_N"]["max"], 50);
  EXPECT_EQ(with(weak, "that a hand can give"), "") << weak["warnings"];
}

TEST_F(Warnings, NameTheStiffnessInUseAndOneThatIsEnough) {
  const std::string run = kBlock + kSpinningBall + kGroove + "--reference_stiffness ";
  const std::string warning = with(drill(run + "1e12"), "the engaged layer was thicker");
  double enough = 0;
  const std::size_t at = warning.find("raise --reference_stiffness");
  ASSERT_NE(at, std::string::npos) << warning;
  ASSERT_EQ(std::sscanf(warning.c_str() + at, "raise --reference_stiffness, which is 1e+12 N/m^4, to %lf", &enough), 1)
      << warning;
  EXPECT_GT(enough, 1e12);
  EXPECT_EQ(with(drill(run + std::to_string(enough)), "the engaged layer was thicker"), "") << enough;
}

TEST_F(Warnings, NameTheLimitsOfTheMotorThatTheLoadStalls) {
  const std::string run = kBlock + "--head sphere --radius_mm 1 --spindle_rpm 30000 " + kGroove;
  const std::string electric = with(drill(run + "--motor electric --torque_limit_Nmm 0.001"), "stalled the spindle");
  EXPECT_NE(
      electric.find("the motor gives at most 0.001 Nmm and 60 W, which are 19.1 Nmm at 30000 rpm. Lower the feed, "
                    "or raise --torque_limit_Nmm, or raise --power_limit_W."),
      std::string::npos)
      << electric;
  const std::string turbine = with(drill(run + "--motor air_turbine --droop_rpm_per_Nmm 1e7"), "stalled the spindle");
  EXPECT_NE(turbine.find("the motor gives at most 0.003 Nmm. Lower the feed, or lower --droop_rpm_per_Nmm."),
            std::string::npos)
      << turbine;
}

TEST_F(Warnings, SayThatTheHeadCrushesWhatItDoesNotCut) {
  const std::string slow =
      "--workpiece block --size_mm 6,6,3 --material trabecular_bone --voxel_mm 0.2 --head sphere "
      "--radius_mm 1 --motor ideal " +
      kGroove + "--spindle_rpm ";
  const nlohmann::json crushes = drill(slow + "30");
  ASSERT_GT(crushes["status"]["material_crushed"], 0);
  EXPECT_NE(with(crushes, "crushed material where it did not cut it"), "") << crushes["warnings"];
  EXPECT_EQ(with(drill(slow + "30000"), "crushed material"), "");
  const nlohmann::json of_loop = loop(
      "--workpiece block --size_mm 24,24,8 --material bone_d5 --voxel_mm 0.3 --head "
      "sphere --radius_mm 0.3 --motor ideal --spindle_rpm 30");
  EXPECT_NE(with(of_loop, "crushed material where it did not cut it"), "") << of_loop["warnings"];
}

TEST_F(Warnings, OfALoopNameTheLoadThatADrillNeeds) {
  const std::string drills =
      "--workpiece block --size_mm 24,24,8 --material cortical_bone --voxel_mm 0.2 --head "
      "twist_drill --length_mm 8 --spindle_rpm 1500 ";
  const nlohmann::json blunt = loop(drills + "--diameter_mm 2");
  const std::string warning =
      with(blunt, "so it cut hardly anything; press harder than 6 N, of which the device gives");
  EXPECT_NE(warning.find("N, or take a thinner drill, or take a sharper drill with --sharpness new."),
            std::string::npos)
      << blunt["warnings"];
  EXPECT_EQ(with(loop(drills + "--diameter_mm 0.6 --sharpness new"), "hardly anything"), "");
  EXPECT_NE(with(loop(drills + "--diameter_mm 2 --cutter fine_diamond"), "usually a twist_drill"), "");
}

TEST_F(Warnings, AreNotHiddenByBitsThatOnlyTheEntryHas) {
  const std::string plunge =
      "--workpiece block --size_mm 4,4,4 --material cortical_bone --voxel_mm 0.1 --head twist_drill --diameter_mm 2 "
      "--length_mm 8 --spindle_rpm 1500 --path line --from_mm 2,2,4.2 --to_mm 2,2,2 --feed_mm_per_s ";
  const auto prints = [&] { return read_bytes(folder / "stdout").find("edges_carry_load in ") != std::string::npos; };
  const nlohmann::json usual = drill(plunge + "1");
  ASSERT_GT(usual["status"]["edges_carry_load"], 0);
  ASSERT_LT(usual["status"]["edges_carry_load"], 0.05 * usual["steps_in_contact"].get<double>());
  EXPECT_FALSE(prints());
  (void)drill(plunge + "0.004 --rate 20");
  EXPECT_TRUE(prints());
}

TEST_F(Warnings, ExplainThatAShareIsAFactorOfPresets) {
  write_bytes(folder / "s.toml", "[material.my_bone]\nbased_on = \"cortical_bone\"\nshare = 0.5\n");
  expect_refused("drill --settings " + path("s.toml"),
                 {":3: material.my_bone.share: there is no such setting, because the share is a factor",
                  "Multiply specific_cutting_energy_J_per_m3 by it"});
}

}  // namespace
}  // namespace hapticut::cli_warnings_test
