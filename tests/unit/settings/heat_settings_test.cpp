// SPDX-License-Identifier: Apache-2.0
// The temperatures and the removal of loose pieces in a scene as text.
#include "settings/heat_settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hapticut/settings/scene.hpp"
#include "support/refusal.hpp"

namespace hapticut::heat_settings_test {
namespace {

const std::string kScene = R"([workpiece]
source = "slab"
size_mm = [2, 2, 1.5]
voxel_mm = 0.25
layers = [
  {material = "enamel", thickness_mm = 0.5},
  {material = "soft_dentin", thickness_mm = 0.5},
  {material = "clay", thickness_mm = 0.5},
]

[material.soft_dentin]
based_on = "dentin"
density_kg_per_m3 = 1800

[tool]
head = "sphere"
radius_mm = 0.5
spindle_rpm = 40000

)";

settings::Scene scene(const std::string& more) { return settings::from_toml(kScene + more); }

TEST(HeatSettings, AreOffUnlessTheyAreAskedFor) {
  EXPECT_FALSE(scene("").heat);
  EXPECT_FALSE(scene("[heat]\non = false\n").heat);
  EXPECT_FALSE(scene("").remove_loose_pieces);
}

TEST(HeatSettings, GiveTheConfigurationOfAHeatField) {
  const auto heat = scene(R"([heat]
on = true
voxels_per_cell = 2
cutting_share = 0.3
rubbing_share = 0.4
body_temperature_degC = 36
irrigation_W_per_m2K = 3000
water_temperature_degC = 20
threshold_degC = 50
)")
                        .heat;
  ASSERT_TRUE(heat);
  EXPECT_EQ(heat->voxels_per_cell, 2);
  EXPECT_EQ(heat->cutting_share, 0.3);
  EXPECT_EQ(heat->rubbing_share, 0.4);
  EXPECT_EQ(heat->body_temperature, 36);
  EXPECT_EQ(heat->irrigation, 3000);
  EXPECT_EQ(heat->water_temperature, 20);
  EXPECT_EQ(heat->threshold, 50);
}

TEST(HeatSettings, HaveTheDefaultsOfTheLibrary) {
  const auto heat = scene("[heat]\non = true\n").heat;
  ASSERT_TRUE(heat);
  const HeatConfig standard;
  EXPECT_EQ(heat->voxels_per_cell, standard.voxels_per_cell);
  EXPECT_EQ(heat->cutting_share, std::nullopt);
  EXPECT_EQ(heat->rubbing_share, standard.rubbing_share);
  EXPECT_EQ(heat->body_temperature, standard.body_temperature);
  EXPECT_EQ(heat->irrigation, standard.irrigation);
  EXPECT_EQ(heat->water_temperature, standard.water_temperature);
  EXPECT_EQ(heat->threshold, standard.threshold);
}

TEST(HeatSettings, TakeTheThermalPropertiesOfAMaterialFromItsNameOrItsPreset) {
  const auto heat = scene("[heat]\non = true\n").heat;
  ASSERT_TRUE(heat);
  const std::vector<ThermalProperties> expected = {thermal_properties_of("enamel"), thermal_properties_of("dentin"),
                                                   thermal_properties_of("clay")};
  EXPECT_EQ(heat->by_material, expected);
}

TEST(HeatSettings, RefuseANumberWithoutTheSwitch) {
  EXPECT_EQ(test::refusal([] { (void)scene("[heat]\nirrigation_W_per_m2K = 3000\n"); }),
            "heat.irrigation_W_per_m2K = 3000; must be left out, because a run without heat.on has none. Leave it out, "
            "or set heat.on.");
  EXPECT_EQ(test::refusal([] { (void)scene("[heat]\non = false\ncutting_share = 0.5\n"); }),
            "heat.cutting_share = 0.5; must be left out, because a run without heat.on has none. Leave it out, or set "
            "heat.on.");
}

TEST(HeatSettings, RefuseANumberOutOfItsRange) {
  EXPECT_EQ(test::refusal([] { (void)scene("[heat]\non = true\ncutting_share = 2\n"); }),
            "scene:22: heat.cutting_share: must be a number from 0 to 1, not 2.");
  EXPECT_EQ(test::refusal([] { (void)scene("[heat]\non = true\nvoxels_per_cell = 9\n"); }),
            "scene:22: heat.voxels_per_cell: must be a whole number from 1 to 8, not 9.");
}

TEST(LoosePieces, LeaveAWorkpieceWhenTheSceneSaysSo) {
  EXPECT_TRUE(scene("[simulation]\nremove_loose_pieces = true\n").remove_loose_pieces);
}

}  // namespace
}  // namespace hapticut::heat_settings_test
