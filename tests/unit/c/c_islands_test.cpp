// SPDX-License-Identifier: Apache-2.0
// The removal of loose pieces through the C interface: in steps, in a loop, by a scene, and its end.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "unit/c/scripted_loop.hpp"

namespace hapticut::c_islands_test {
namespace {

using namespace c_test;

/// A beam of 6 mm along x, and a ball that is wider than the beam.
const std::string kBeam = R"([workpiece]
source = "block"
size_mm = [6, 0.8, 0.8]
voxel_mm = 0.1
material = "cortical_bone"

[tool]
head = "sphere"
radius_mm = 0.6
handle = "ray"
handle_length_mm = 20
spindle_rpm = 40000

[simulation]
reserved_blocks = 500
)";

constexpr int kThrough = 525;
constexpr double kWhole = 6e-3 * 0.8e-3 * 0.8e-3;  // [m^3]

/// A step with the ball at x = 4 mm, 4 um lower each tick, until it is below the beam.
void cut_through(hapticut_simulation simulation, int tick) {
  auto input = above(0);
  auto result = sized<hapticut_step_result>();
  input.X_WH.position[0] = 4e-3;
  input.X_WH.position[1] = 0.4e-3;
  input.X_WH.position[2] = 20e-3 + 1.4e-3 - 4e-6 * tick;
  input.linear_velocity[2] = -4e-3;
  ASSERT_EQ(hapticut_step(simulation, &input, &result), HAPTICUT_OK) << hapticut_last_error();
}

hapticut_material_info material_of(hapticut_simulation simulation) {
  auto info = sized<hapticut_material_info>();
  EXPECT_EQ(hapticut_material(simulation, 1, &info), HAPTICUT_OK) << hapticut_last_error();
  return info;
}

/// Cuts through the beam, and stays below it until the condition is met.  @return whether it was
template <class Condition>
bool cut_until(hapticut_simulation simulation, const Condition& condition, int tries = 60'000) {
  for (int tick = 1; tick <= kThrough; ++tick) cut_through(simulation, tick);
  for (int n = 0; n < tries && !condition(); ++n) {
    cut_through(simulation, kThrough);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

hapticut_islands islands_of(hapticut_simulation simulation, const hapticut_islands_options* options = nullptr) {
  hapticut_islands islands = 0;
  EXPECT_EQ(hapticut_islands_open(simulation, options, &islands), HAPTICUT_OK) << hapticut_last_error();
  return islands;
}

std::uint64_t count_of(hapticut_islands islands) {
  std::uint64_t count = 0;
  EXPECT_EQ(hapticut_islands_count(islands, &count), HAPTICUT_OK) << hapticut_last_error();
  return count;
}

void expect_one_piece_is_gone(hapticut_simulation simulation) {
  const hapticut_material_info info = material_of(simulation);
  EXPECT_GT(info.detached_volume, 0.6e-9);  // a piece of 1.4 mm
  EXPECT_LT(info.detached_volume, 1.2e-9);
  EXPECT_NEAR(info.volume + info.removed_volume + info.detached_volume, kWhole, 1e-6 * kWhole);
}

TEST(CIslands, ThatTheToolCutsLooseAreRemovedBySteps) {
  const Owned simulation(simulation_of(kBeam));
  const Owned islands(islands_of(simulation.get()));
  auto info = sized<hapticut_island_info>();
  EXPECT_EQ(hapticut_islands_poll(islands.get(), &info), HAPTICUT_NOTHING);
  ASSERT_TRUE(cut_until(simulation.get(), [&] { return count_of(islands.get()) > 0; }));
  EXPECT_EQ(count_of(islands.get()), 1U);
  expect_one_piece_is_gone(simulation.get());
  for (int n = 0; n < 60'000 && hapticut_islands_poll(islands.get(), &info) == HAPTICUT_NOTHING; ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_NEAR(double(info.voxels), 8 * 8 * 14, 150);
  EXPECT_NEAR(info.center_W[0], 5.3e-3, 0.2e-3);
  EXPECT_NEAR(info.center_W[1], 0.4e-3, 0.05e-3);
  EXPECT_EQ(hapticut_islands_poll(islands.get(), &info), HAPTICUT_NOTHING);
}

TEST(CIslands, AreThePiecesOutsideABoxThatIsFixed) {
  auto options = sized<hapticut_islands_options>();
  options.has_fixed = 1;
  options.fixed_min[0] = 5.5e-3;
  for (double& end : options.fixed_max) end = 7e-3;
  const Owned simulation(simulation_of(kBeam));
  const Owned islands(islands_of(simulation.get(), &options));
  ASSERT_TRUE(cut_until(simulation.get(), [&] { return count_of(islands.get()) > 0; }));
  EXPECT_GT(material_of(simulation.get()).detached_volume, 1.8e-9) << "the longer piece has gone";
}

TEST(CIslands, StayWithoutAHandleAndAfterItsRelease) {
  const auto stays = [](hapticut_simulation simulation) {
    (void)cut_until(
        simulation, [] { return false; }, 100);
    EXPECT_EQ(material_of(simulation).detached_volume, 0);
  };
  const Owned simulation(simulation_of(kBeam)), released(simulation_of(kBeam));
  stays(simulation.get());
  {
    const Owned islands(islands_of(released.get()));
    hapticut_islands another = 0;
    EXPECT_EQ(hapticut_islands_open(released.get(), nullptr, &another), HAPTICUT_ERROR_REFUSED);
    EXPECT_NE(std::string(hapticut_last_error()).find("release it"), std::string::npos) << hapticut_last_error();
  }
  stays(released.get());
  const Owned again(islands_of(released.get()));
  EXPECT_NE(again.get(), 0U);
}

TEST(CIslands, AreRemovedWhereTheSceneDemandsIt) {
  const Owned simulation(simulation_of(kBeam + "remove_loose_pieces = true\n"));
  EXPECT_TRUE(cut_until(simulation.get(), [&] { return material_of(simulation.get()).detached_volume > 0.6e-9; }))
      << "without a handle";
  const Owned seen(simulation_of(kBeam + "remove_loose_pieces = true\n"));
  const Owned islands(islands_of(seen.get()));
  EXPECT_TRUE(cut_until(seen.get(), [&] { return count_of(islands.get()) > 0; })) << "a handle takes its place";
}

TEST(CIslands, AreRemovedInALoopAndInAnyOrderOfReleases) {
  for (const int order : {0, 1, 2, 3}) {
    ScriptedLoop scripted(kBeam, "mock:press");
    Owned islands(islands_of(scripted.simulation.get()));
    scripted.start(0);
    hapticut_islands late = 0;
    EXPECT_EQ(hapticut_islands_open(scripted.simulation.get(), nullptr, &late), HAPTICUT_ERROR_BUSY);
    ASSERT_TRUE(scripted.becomes([&](const auto&) { return count_of(islands.get()) > 0; }));
    if (order == 0) {
      ASSERT_EQ(hapticut_loop_stop(scripted.loop.get(), nullptr), HAPTICUT_OK);
      const hapticut_material_info info = material_of(scripted.simulation.get());
      EXPECT_GT(info.detached_volume, 1e-9);
      EXPECT_NEAR(info.volume + info.removed_volume + info.detached_volume, kWhole, 1e-6 * kWhole);
    }
    std::array<Owned*, 4> owned = {&islands, &scripted.simulation, &scripted.device, &scripted.loop};
    std::rotate(owned.begin(), owned.begin() + order, owned.end());
    for (Owned* one : owned) EXPECT_EQ(one->release(), HAPTICUT_OK) << hapticut_last_error();
  }
}

TEST(CIslands, AreRefusedInTheWordsOfC) {
  const Owned simulation(simulation_of(kBeam));
  hapticut_islands islands = 0;
  const auto refuses = [&](auto&& change, int expected, const std::string& words) {
    auto options = sized<hapticut_islands_options>();
    change(options);
    EXPECT_EQ(hapticut_islands_open(simulation.get(), &options, &islands), expected);
    const std::string sentence = hapticut_last_error();
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("::"), std::string::npos) << sentence;
  };
  refuses([](auto& o) { o.min_fill = 2; }, HAPTICUT_ERROR_REFUSED, "hapticut_islands_options.min_fill [1] = 2");
  refuses([](auto& o) { o.period = -1; }, HAPTICUT_ERROR_REFUSED, "hapticut_islands_options.period [s] = -1");
  refuses([](auto& o) { o.has_fixed = 1; }, HAPTICUT_ERROR_REFUSED, "hapticut_islands_options.fixed_min ... fixed_max");
  refuses([](auto& o) { o.has_fixed = 2; }, HAPTICUT_ERROR_ARGUMENT, "has_fixed = 2");
  refuses([](auto& o) { o.struct_size = 4; }, HAPTICUT_ERROR_STRUCT_SIZE, "options->struct_size = 4");
  EXPECT_EQ(islands, 0U);
  cut_through(simulation.get(), 1);
}

}  // namespace
}  // namespace hapticut::c_islands_test
