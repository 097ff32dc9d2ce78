// SPDX-License-Identifier: Apache-2.0
// Which settings of a simulation follow from others.
#include "settings/simulation_settings.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace hapticut::simulation_settings_test {
namespace {

settings::SimulationSettings felt() {
  settings::SimulationSettings s;
  s.texture_by_default = true;  // as loop and view
  return s;
}

void expect_texture(bool expected, const settings::SimulationSettings& s) {
  const SimulationConfig config = settings::make_config(s);
  EXPECT_EQ(config.grain, expected);
  EXPECT_EQ(config.effects.teeth.has_value(), expected);
}

TEST(SimulationSettings, HaveATextureWhereAHandFeelsTheDefaultLawOrAsGiven) {
  expect_texture(false, {});
  expect_texture(true, felt());
  settings::SimulationSettings thesis = felt();
  thesis.thesis_mode = true;
  expect_texture(false, thesis);
  settings::SimulationSettings off = felt(), on;
  off.texture = false, on.texture = true;
  expect_texture(false, off);
  expect_texture(true, on);
}

TEST(SimulationSettings, GiveAmplitudesToTheTeethOnlyWithATexture) {
  settings::SimulationSettings s = felt();
  s.effects.teeth[&ToothPassing::per_tooth] = 0.1;
  const std::optional<ToothPassing> teeth = settings::make_config(s).effects.teeth;
  ASSERT_TRUE(teeth);
  EXPECT_EQ(teeth->per_tooth, 0.1);
  EXPECT_EQ(teeth->once_per_turn, ToothPassing{}.once_per_turn);
  s.texture = false;
  test::expect_refused([&] { (void)settings::make_config(s); }, {"effects.texture_per_tooth", "simulation.texture"});
}

}  // namespace
}  // namespace hapticut::simulation_settings_test
