// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <thread>

#include "unit/c/scenes.hpp"

namespace hapticut::c_test {

inline hapticut_loop_options for_mock(double seconds) {
  auto options = sized<hapticut_loop_options>();
  options.up = HAPTICUT_UP_Z;
  options.seconds = seconds;
  options.simulated_time = 1;
  options.ordinary_priority = 1;
  return options;
}

/// A loop on a mock device, as fast as possible.
struct ScriptedLoop {
  explicit ScriptedLoop(const std::string& scene = kScene, const char* device_name = "mock:spiral,hand=nominal")
      : simulation(simulation_of(scene, 1, 8192)), device(device_of(device_name)) {}

  Owned simulation, device, surface, loop;

  void open_surface() {
    ASSERT_EQ(hapticut_surface_open(simulation.get(), surface.to()), HAPTICUT_OK) << hapticut_last_error();
  }
  void start(double seconds) {
    const hapticut_loop_options options = for_mock(seconds);
    ASSERT_EQ(hapticut_loop_start(simulation.get(), device.get(), &options, loop.to()), HAPTICUT_OK)
        << hapticut_last_error();
  }
  hapticut_loop_state latest() {
    auto state = sized<hapticut_loop_state>();
    EXPECT_EQ(hapticut_loop_latest(loop.get(), &state), HAPTICUT_OK) << hapticut_last_error();
    return state;
  }
  int send(std::uint32_t kind, double value = 0) {
    auto command = sized<hapticut_command>();
    command.kind = kind;
    command.value = value;
    return hapticut_loop_send(loop.get(), &command);
  }
  template <class Condition>
  bool becomes(Condition&& condition) {
    for (int n = 0; n < 1'000'000; ++n) {
      if (condition(latest())) return true;
      std::this_thread::yield();
    }
    return false;
  }
};

}  // namespace hapticut::c_test
