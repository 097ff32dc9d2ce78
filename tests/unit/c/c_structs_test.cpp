// SPDX-License-Identifier: Apache-2.0
// Structs of callers that are older or newer than the library.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/loop/snapshot.hpp"
#include "unit/c/layout.h"
#include "unit/c/scenes.hpp"

namespace hapticut::c_structs_test {
namespace {

using namespace c_test;

using Layout = std::vector<std::pair<std::string, std::size_t>>;

/// Sizes of all structs and offsets of their fields, in one of the languages.
Layout layout_of(void (*language)(layout_user)) {
  static Layout found;
  found.clear();
  language([](const char* name, std::size_t bytes) { found.emplace_back(name, bytes); });
  return found;
}

/// The names of the fields of a struct, which follow its own in the layout.
std::set<std::string> fields_in_c(const std::string& type) {
  std::set<std::string> fields;
  bool inside = false;
  for (const auto& [name, bytes] : layout_of(layout_in_c)) {
    if (name.starts_with("hapticut_"))
      inside = name == type;
    else if (inside)
      fields.insert(name);
  }
  return fields;
}

TEST(CStructs, LieInMemoryInCAsTheyDoInCpp) {
  const Layout in_cpp = layout_of(every_layout);
  ASSERT_GT(in_cpp.size(), 150U);
  EXPECT_EQ(layout_of(layout_in_c), in_cpp);
}

// The structs of ABI version 1 may grow at their ends; their fields never move.
TEST(CStructs, KeepTheirPublishedSizes) {
  const std::map<std::string, std::size_t> given_out = {{"hapticut_pose", 96},
                                                        {"hapticut_vertex", 12},
                                                        {"hapticut_simulation_options", 16},
                                                        {"hapticut_scene_info", 336},
                                                        {"hapticut_material_info", 96},
                                                        {"hapticut_step_input", 160},
                                                        {"hapticut_step_result", 312},
                                                        {"hapticut_ray_hit", 64},
                                                        {"hapticut_probe_result", 352},
                                                        {"hapticut_energy_ledger", 120},
                                                        {"hapticut_coupling_gains", 72},
                                                        {"hapticut_device_info", 240},
                                                        {"hapticut_loop_options", 160},
                                                        {"hapticut_loop_state", 472},
                                                        {"hapticut_command", 16},
                                                        {"hapticut_loop_report", 1344},
                                                        {"hapticut_page", 160},
                                                        {"hapticut_sound_options", 24},
                                                        {"hapticut_sound_input", 32},
                                                        {"hapticut_recording_report", 24},
                                                        {"hapticut_heat_config", 56},
                                                        {"hapticut_thermal_properties", 16},
                                                        {"hapticut_heat_structure_info", 48},
                                                        {"hapticut_heat_balance_info", 48},
                                                        {"hapticut_heat_grid_info", 120},
                                                        {"hapticut_islands_options", 80},
                                                        {"hapticut_island_info", 40}};
  std::size_t seen = 0;
  for (const auto& [name, bytes] : layout_of(every_layout)) {
    if (!name.starts_with("hapticut_")) continue;  // a field
    ++seen;
    ASSERT_TRUE(given_out.contains(name)) << name << " has " << bytes << " bytes";
    EXPECT_EQ(bytes, given_out.at(name)) << name;
  }
  EXPECT_EQ(seen, given_out.size());
}

// A new field of a snapshot goes to the end of hapticut_loop_state, or into this list.
TEST(CStructs, HaveEachFieldOfASnapshotExceptThese) {
  const std::set<std::string> left_out = {
      "device",         "output",   "tool",    "max_commanded", "max_applied", "blocks_waiting", "velocity",
      "blocks_outside", "sequence", "epoch",   "temperature",   "valid",       "steps",          "effort",
      "max_effort",     "undoing",  "redoing", "force_held",    "workpiece"};
  const std::set<std::string> in_c = fields_in_c("hapticut_loop_state");
  const auto expect_fields = [&]<class S>(Of<S>) {
    for_each_field<S>([&](const auto& field) {
      const bool is_in_c = in_c.contains(field.name);
      EXPECT_NE(is_in_c, left_out.contains(field.name)) << field.name;
    });
  };
  expect_fields(Of<LoopSnapshot>{});
  expect_fields(Of<ToolSnapshot>{});
  expect_fields(Of<DeviceState>{});
}

/// Checks what a function writes into a struct of a caller that has a shorter or longer version of it.
/// @param call  returns the function's code
template <class S>
void expect_writes_within_its_size(const char* name, const std::function<int(S*)>& call) {
  SCOPED_TRACE(name);
  constexpr std::size_t kMore = 64;
  alignas(8) std::array<unsigned char, sizeof(S) + kMore> whole, part;
  const auto run = [&](auto& bytes, std::size_t size) {
    bytes.fill(0xa5);
    const auto struct_size = std::uint32_t(size);
    std::memcpy(bytes.data(), &struct_size, sizeof struct_size);
    return call(reinterpret_cast<S*>(bytes.data()));
  };
  ASSERT_GE(run(whole, sizeof(S)), 0) << hapticut_last_error();
  for (std::size_t size = 8; size <= sizeof(S) + kMore; size += 8) {
    ASSERT_GE(run(part, size), 0) << hapticut_last_error();
    const std::size_t known = std::min(size, sizeof(S));
    ASSERT_EQ(std::memcmp(part.data() + 4, whole.data() + 4, known - 4), 0) << size;
    for (std::size_t n = known; n < part.size(); ++n)
      ASSERT_EQ(int(part[n]), n < size ? 0 : 0xa5) << n << " of " << size;
  }
  for (const std::size_t wrong : {std::size_t(0), std::size_t(4), std::size_t(12), std::size_t(1) << 20}) {
    EXPECT_EQ(run(part, wrong), HAPTICUT_ERROR_STRUCT_SIZE) << wrong;
    EXPECT_NE(std::string(hapticut_last_error()).find("set it to sizeof"), std::string::npos) << hapticut_last_error();
    for (std::size_t n = 4; n < part.size(); ++n) ASSERT_EQ(int(part[n]), 0xa5) << n;
  }
}

TEST(CStructs, AreWrittenNoFurtherThanTheCallerSays) {
  const Owned simulation(simulation_of());
  const Owned device(device_of());
  cut(simulation.get(), 100);
  const hapticut_handle s = simulation.get();
  expect_writes_within_its_size<hapticut_scene_info>("scene", [&](auto* to) { return hapticut_scene(s, to); });
  expect_writes_within_its_size<hapticut_material_info>("material",
                                                        [&](auto* to) { return hapticut_material(s, 1, to); });
  expect_writes_within_its_size<hapticut_energy_ledger>("energy", [&](auto* to) { return hapticut_energy(s, to); });
  expect_writes_within_its_size<hapticut_device_info>(
      "device", [&](auto* to) { return hapticut_device_describe(device.get(), to); });
  const hapticut_step_input input = above(2e-4);
  expect_writes_within_its_size<hapticut_probe_result>("probe",
                                                       [&](auto* to) { return hapticut_probe(s, &input, to); });
  const double from[3] = {3e-3, 3e-3, 1e-2}, down[3] = {0, 0, -1};
  expect_writes_within_its_size<hapticut_ray_hit>(
      "ray", [&](auto* to) { return hapticut_first_hit(s, from, down, 0, 0, to); });
  // The tool is above the block, so all steps are equal.
  const hapticut_step_input still = above(-5e-3);
  auto result = sized<hapticut_step_result>();
  const Owned fresh(simulation_of());
  for (int n = 0; n < 3; ++n) ASSERT_EQ(hapticut_step(fresh.get(), &still, &result), HAPTICUT_OK);
  expect_writes_within_its_size<hapticut_step_result>("step",
                                                      [&](auto* to) { return hapticut_step(fresh.get(), &still, to); });
}

TEST(CStructs, OfAnOlderCallerHaveTheirDefaults) {
  const Owned simulation(simulation_of());
  const Owned same(simulation_of());
  auto result = sized<hapticut_step_result>(), expected = sized<hapticut_step_result>();
  // An old caller has only poses: velocity and dt are 0, so the step sets a status bit.
  hapticut_step_input old_input = above(1e-4), whole = above(1e-4);
  old_input.struct_size = offsetof(hapticut_step_input, linear_velocity);
  whole.linear_velocity[2] = 0;
  whole.dt = 0;
  ASSERT_EQ(hapticut_step(simulation.get(), &old_input, &result), HAPTICUT_OK) << hapticut_last_error();
  ASSERT_EQ(hapticut_step(same.get(), &whole, &expected), HAPTICUT_OK);
  EXPECT_EQ(std::memcmp(&result, &expected, sizeof result), 0);
  EXPECT_NE(result.status, 0U);
}

TEST(CStructs, OfANewerCallerMayNotSetUnknownFields) {
  const Owned simulation(simulation_of());
  struct Newer {
    hapticut_step_input input;
    double wish;
  } newer{above(1e-4), 0};
  newer.input.struct_size = sizeof newer;
  auto result = sized<hapticut_step_result>();
  EXPECT_EQ(hapticut_step(simulation.get(), &newer.input, &result), HAPTICUT_OK) << hapticut_last_error();
  newer.wish = 1;
  EXPECT_EQ(hapticut_step(simulation.get(), &newer.input, &result), HAPTICUT_ERROR_STRUCT_SIZE);
  EXPECT_NE(std::string(hapticut_last_error()).find("older library"), std::string::npos) << hapticut_last_error();
}

}  // namespace
}  // namespace hapticut::c_structs_test
