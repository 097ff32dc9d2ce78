// SPDX-License-Identifier: Apache-2.0
// The temperatures of a workpiece through the C interface: as in C++, under water, in a loop, and what is refused.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/heat/thermal_properties.hpp"
#include "hapticut/settings/scene.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "unit/c/scripted_loop.hpp"

namespace hapticut::c_heat_test {
namespace {

using namespace c_test;

constexpr int kSteps = 400;  // 0.8 mm deep
constexpr double kBody = 37;

std::string scene_of(const std::string& material) {
  std::string text = kScene;
  return text.replace(text.find("cortical_bone"), std::string("cortical_bone").size(), material);
}

hapticut_heat heat_of(hapticut_simulation simulation, const hapticut_heat_config* config = nullptr,
                      const std::vector<hapticut_thermal_properties>& by_material = {}) {
  hapticut_heat heat = 0;
  EXPECT_EQ(hapticut_heat_open(simulation, config, by_material.data(), by_material.size(), &heat), HAPTICUT_OK)
      << hapticut_last_error();
  return heat;
}

hapticut_heat_structure_info structure_of(hapticut_heat heat) {
  auto info = sized<hapticut_heat_structure_info>();
  EXPECT_EQ(hapticut_heat_structure(heat, 1, &info), HAPTICUT_OK) << hapticut_last_error();
  return info;
}

hapticut_heat_balance_info balance_of(hapticut_heat heat) {
  auto info = sized<hapticut_heat_balance_info>();
  EXPECT_EQ(hapticut_heat_balance(heat, &info), HAPTICUT_OK) << hapticut_last_error();
  return info;
}

/// The highest temperature after a cut of a scene.
hapticut_heat_structure_info after_a_cut(const std::string& scene, const hapticut_heat_config* config = nullptr,
                                         const std::vector<hapticut_thermal_properties>& by_material = {}) {
  const Owned simulation(simulation_of(scene));
  const Owned heat(heat_of(simulation.get(), config, by_material));
  cut(simulation.get(), kSteps);
  EXPECT_EQ(hapticut_heat_update(heat.get(), nullptr), HAPTICUT_OK);
  return structure_of(heat.get());
}

/// The same cut in C++.
struct InCpp {
  explicit InCpp(const std::string& text, HeatConfig config = {})
      : scene(settings::from_toml(text)),
        simulation(std::move(scene.workpiece), scene.tool, scene.config),
        collector(simulation),
        field(simulation.workpiece(), std::move(config)) {
    for (int n = 1; n <= kSteps; ++n) {
      const hapticut_step_input input = above(2e-6 * n);
      const Vec3 place(input.X_WH.position[0], input.X_WH.position[1], input.X_WH.position[2]);
      (void)simulation.step(Pose::from_translation(place), {{0, 0, -2e-3}, Vec3::Zero()}, 1e-3);
    }
    field.advance(field.drain(collector));
  }
  settings::Scene scene;
  Simulation simulation;
  HeatCollector collector;
  HeatField field;
};

TEST(CHeat, IsThatOfCppWithThePropertiesOfTheMaterialsName) {
  for (const std::string material : {"cortical_bone", "enamel"}) {
    HeatConfig config;
    config.by_material = {thermal_properties_of(material)};
    const InCpp expected(scene_of(material), config);
    const Owned simulation(simulation_of(scene_of(material)));
    const Owned heat(heat_of(simulation.get()));
    EXPECT_EQ(structure_of(heat.get()).temperature, kBody);
    cut(simulation.get(), kSteps);
    EXPECT_EQ(structure_of(heat.get()).temperature, kBody) << "the heat of the steps waits for the update";
    double time = 0;
    ASSERT_EQ(hapticut_heat_update(heat.get(), &time), HAPTICUT_OK) << hapticut_last_error();
    EXPECT_NEAR(time, kSteps * 1e-3, 1e-12);

    const hapticut_heat_structure_info info = structure_of(heat.get());
    const StructureHeat same = expected.field.structures()[0];
    EXPECT_GT(info.temperature, kBody + 1) << "drilling heats";
    EXPECT_EQ(info.material, 1U);
    EXPECT_EQ(info.temperature, same.temperature);
    EXPECT_EQ(info.peak, same.peak);
    EXPECT_EQ(info.time_above, same.time_above);
    EXPECT_EQ(info.cem43, same.cem43);
    EXPECT_EQ(info.volume_above, same.volume_above);
    const double below[3] = {3e-3, 3e-3, 2e-3};
    double temperature = 0;
    ASSERT_EQ(hapticut_heat_temperature_at(heat.get(), below, &temperature), HAPTICUT_OK);
    EXPECT_EQ(temperature, expected.field.temperature_at(Vec3(below)));

    const hapticut_heat_balance_info balance = balance_of(heat.get());
    EXPECT_EQ(balance.brought_in, expected.field.balance().brought_in);
    EXPECT_EQ(balance.stored, expected.field.balance().stored);
    EXPECT_EQ(balance.chips, expected.field.balance().chips);
    EXPECT_GT(balance.brought_in, 0);
    EXPECT_EQ(balance.irrigation, 0);
    EXPECT_LT(std::abs(balance.imbalance), 1e-9 * balance.brought_in) << "the balance closes";

    ASSERT_EQ(hapticut_heat_update(heat.get(), &time), HAPTICUT_OK);
    EXPECT_EQ(time, 0) << "there was no other step";
  }
}

TEST(CHeat, HasThePropertiesThatTheCallerTheSceneOrTheNameGives) {
  const double by_name = after_a_cut(scene_of("enamel")).temperature;
  const ThermalProperties enamel = thermal_properties_of("enamel");
  const hapticut_thermal_properties none{}, same{enamel.conductivity, enamel.heat_capacity}, slow{0, 1e8};
  EXPECT_EQ(after_a_cut(scene_of("enamel"), nullptr, {none}).temperature, by_name);
  EXPECT_EQ(after_a_cut(scene_of("enamel"), nullptr, {same}).temperature, by_name);
  EXPECT_LT(after_a_cut(scene_of("enamel"), nullptr, {slow}).temperature, kBody + 0.2 * (by_name - kBody));

  const std::string cold = scene_of("enamel") + "[heat]\non = true\nbody_temperature_degC = 20\n";
  EXPECT_NEAR(after_a_cut(cold).temperature, by_name - kBody + 20, 1e-9) << "the table [heat] of the scene";
  auto config = sized<hapticut_heat_config>();
  EXPECT_NEAR(after_a_cut(cold, &config).temperature, by_name - kBody + 20, 1e-9) << "0 is that of the scene";
  config.body_temperature = 30;
  EXPECT_NEAR(after_a_cut(cold, &config).temperature, by_name - kBody + 30, 1e-9);
  config.cutting_share = 1e-9;
  EXPECT_NEAR(after_a_cut(cold, &config).temperature, 30, 1e-3) << "without a share of the cut it stays cool";
}

TEST(CHeat, LeavesWithTheWater) {
  auto config = sized<hapticut_heat_config>();
  const double dry = after_a_cut(kScene, &config).temperature;
  config.irrigation = 5000;
  EXPECT_LT(after_a_cut(kScene, &config).temperature, dry - 1);

  const Owned simulation(simulation_of());
  const Owned heat(heat_of(simulation.get()));
  cut(simulation.get(), kSteps);
  ASSERT_EQ(hapticut_heat_update(heat.get(), nullptr), HAPTICUT_OK);
  ASSERT_EQ(hapticut_heat_advance(heat.get(), 1), HAPTICUT_OK);
  EXPECT_EQ(balance_of(heat.get()).irrigation, 0);
  EXPECT_LT(structure_of(heat.get()).temperature, dry) << "it spreads";
  const double before = structure_of(heat.get()).temperature;
  ASSERT_EQ(hapticut_heat_set_irrigation(heat.get(), 5000), HAPTICUT_OK) << hapticut_last_error();
  ASSERT_EQ(hapticut_heat_advance(heat.get(), 10), HAPTICUT_OK);
  EXPECT_LT(structure_of(heat.get()).temperature, std::min(before, kBody)) << "the water has 23 deg C";
  EXPECT_GE(structure_of(heat.get()).peak, before);
  const hapticut_heat_balance_info balance = balance_of(heat.get());
  EXPECT_GT(balance.irrigation, 0);
  EXPECT_LT(std::abs(balance.imbalance), 1e-9 * (balance.brought_in + balance.irrigation));
}

TEST(CHeat, ShowsItsCells) {
  auto config = sized<hapticut_heat_config>();
  config.voxels_per_cell = 2;
  const Owned simulation(simulation_of());
  const Owned heat(heat_of(simulation.get(), &config));
  cut(simulation.get(), kSteps);
  ASSERT_EQ(hapticut_heat_update(heat.get(), nullptr), HAPTICUT_OK);
  auto grid = sized<hapticut_heat_grid_info>();
  ASSERT_EQ(hapticut_heat_grid(heat.get(), &grid), HAPTICUT_OK);
  EXPECT_NEAR(grid.cell_size, 0.4e-3, 1e-12);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(grid.X_WC.position[axis], 0.2e-3, 1e-12);
  EXPECT_EQ(grid.X_WC.rotation[0], 1);
  const std::array<std::size_t, 3> dims = {grid.dims[0], grid.dims[1], grid.dims[2]};
  std::vector<float> now(dims[0] * dims[1] * dims[2]), peak(now.size()), dose(now.size());
  const auto copy = [&](std::uint32_t quantity, std::vector<float>& to) {
    ASSERT_EQ(hapticut_heat_cells(heat.get(), quantity, to.data(), to.size()), HAPTICUT_OK) << hapticut_last_error();
  };
  copy(HAPTICUT_HEAT_TEMPERATURE, now);
  copy(HAPTICUT_HEAT_PEAK, peak);
  copy(HAPTICUT_HEAT_DOSE, dose);
  std::size_t filled = 0;
  for (std::size_t n = 0; n < now.size(); ++n) {
    const double h = grid.cell_size;
    const std::array<std::size_t, 3> cell = {n % dims[0], n / dims[0] % dims[1], n / dims[0] / dims[1]};
    const double center[3] = {h * double(cell[0]) + 0.2e-3, h * double(cell[1]) + 0.2e-3, h * double(cell[2]) + 0.2e-3};
    double there = 0;
    const int code = hapticut_heat_temperature_at(heat.get(), center, &there);
    ASSERT_EQ(std::isnan(now[n]), std::isnan(peak[n]));
    ASSERT_EQ(std::isnan(now[n]), std::isnan(dose[n]));
    if (std::isnan(now[n])) continue;
    ++filled;
    ASSERT_EQ(code, HAPTICUT_OK);
    ASSERT_NEAR(now[n], there, 1e-3) << cell[0] << ' ' << cell[1] << ' ' << cell[2];
    ASSERT_GE(peak[n], now[n]);
    ASSERT_GT(dose[n], 0);
  }
  EXPECT_GT(filled, 15U * 15 * 6);
  EXPECT_LT(filled, now.size());
}

TEST(CHeat, GrowsBesideALoopAndSurvivesAnyOrderOfReleases) {
  for (const int order : {0, 1, 2, 3}) {
    ScriptedLoop scripted;
    Owned heat(heat_of(scripted.simulation.get()));
    scripted.start(0);
    hapticut_heat late = 0;
    EXPECT_EQ(hapticut_heat_open(scripted.simulation.get(), nullptr, nullptr, 0, &late), HAPTICUT_ERROR_BUSY);
    double total = 0;
    ASSERT_TRUE(scripted.becomes([&](const auto&) {
      double time = 0;
      EXPECT_EQ(hapticut_heat_update(heat.get(), &time), HAPTICUT_OK) << hapticut_last_error();
      total += time;
      return structure_of(heat.get()).temperature > kBody + 1;
    }));
    EXPECT_GT(total, 0);
    const hapticut_heat_balance_info balance = balance_of(heat.get());
    EXPECT_LT(std::abs(balance.imbalance), 1e-9 * balance.brought_in);
    std::array<Owned*, 4> owned = {&heat, &scripted.simulation, &scripted.device, &scripted.loop};
    std::rotate(owned.begin(), owned.begin() + order, owned.end());
    for (Owned* one : owned) {
      EXPECT_EQ(one->release(), HAPTICUT_OK) << hapticut_last_error();
      if (heat.get() != 0) {
        EXPECT_EQ(hapticut_heat_update(heat.get(), nullptr), HAPTICUT_OK) << "it keeps what it needs";
      }
    }
  }
}

TEST(CHeat, EndsWithItsHandle) {
  const Owned simulation(simulation_of());
  for (int n = 0; n < 20; ++n) {  // of eight places for observers each takes two, until it is released
    const Owned heat(heat_of(simulation.get()));
    ASSERT_NE(heat.get(), 0U);
  }
  cut(simulation.get(), 10);
}

TEST(CHeat, RefusesWhatIsWrongInTheWordsOfC) {
  const Owned simulation(simulation_of());
  hapticut_heat heat = 0;
  const auto refuses = [&](int code, int expected, const std::string& words) {
    EXPECT_EQ(code, expected) << words;
    const std::string sentence = hapticut_last_error();
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("::"), std::string::npos) << sentence;
  };
  const auto open_with = [&](auto&& change) {
    auto config = sized<hapticut_heat_config>();
    change(config);
    return hapticut_heat_open(simulation.get(), &config, nullptr, 0, &heat);
  };
  refuses(open_with([](auto& c) { c.voxels_per_cell = 3; }), HAPTICUT_ERROR_REFUSED,
          "hapticut_heat_config.voxels_per_cell = 3");
  refuses(open_with([](auto& c) { c.voxels_per_cell = 4'000'000'000; }), HAPTICUT_ERROR_REFUSED,
          "hapticut_heat_config.voxels_per_cell");
  refuses(open_with([](auto& c) { c.cutting_share = 1.5; }), HAPTICUT_ERROR_REFUSED,
          "hapticut_heat_config.cutting_share [1] = 1.5");
  refuses(open_with([](auto& c) { c.threshold = std::nan(""); }), HAPTICUT_ERROR_REFUSED,
          "hapticut_heat_config.threshold");
  refuses(open_with([](auto& c) { c.struct_size = 0; }), HAPTICUT_ERROR_STRUCT_SIZE, "config->struct_size = 0");
  const hapticut_thermal_properties wrong[2] = {{-1, 0}, {0, 0}};
  refuses(hapticut_heat_open(simulation.get(), nullptr, wrong, 1, &heat), HAPTICUT_ERROR_REFUSED,
          "hapticut_thermal_properties.conductivity [W/(m K)] = -1");
  refuses(hapticut_heat_open(simulation.get(), nullptr, wrong, 2, &heat), HAPTICUT_ERROR_ARGUMENT, "count = 2");
  EXPECT_EQ(heat, 0U) << "nothing was made";

  const Owned owned(heat_of(simulation.get()));
  heat = owned.get();
  refuses(hapticut_heat_set_irrigation(heat, -1), HAPTICUT_ERROR_REFUSED, "coefficient [W/(m^2 K)] = -1");
  refuses(hapticut_heat_advance(heat, -1), HAPTICUT_ERROR_REFUSED, "dt [s] = -1");
  refuses(hapticut_heat_advance(heat, std::nan("")), HAPTICUT_ERROR_REFUSED, "dt [s]");
  auto info = sized<hapticut_heat_structure_info>();
  refuses(hapticut_heat_structure(heat, 0, &info), HAPTICUT_ERROR_ARGUMENT, "id = 0");
  refuses(hapticut_heat_structure(heat, 2, &info), HAPTICUT_ERROR_ARGUMENT, "id = 2");
  std::array<float, 4> few{};
  refuses(hapticut_heat_cells(heat, 0, few.data(), few.size()), HAPTICUT_ERROR_ARGUMENT, "count = 4");
  refuses(hapticut_heat_cells(heat, 3, few.data(), few.size()), HAPTICUT_ERROR_ARGUMENT, "quantity = 3");
  const double nowhere[3] = {0, std::nan(""), 0}, far[3] = {1, 1, 1};
  double temperature = -1;
  refuses(hapticut_heat_temperature_at(heat, nowhere, &temperature), HAPTICUT_ERROR_ARGUMENT, "p_WQ is not finite");
  EXPECT_EQ(hapticut_heat_temperature_at(heat, far, &temperature), HAPTICUT_NOTHING);
  EXPECT_EQ(temperature, -1) << "the output is unchanged";
}

}  // namespace
}  // namespace hapticut::c_heat_test
