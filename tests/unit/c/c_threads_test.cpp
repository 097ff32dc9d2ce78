// SPDX-License-Identifier: Apache-2.0
// Several threads with the same handles, and several copies of the library in one process.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "support/places.hpp"
#include "support/temporary_folder.hpp"
#include "unit/c/scenes.hpp"

namespace hapticut::c_threads_test {
namespace {

using namespace c_test;

template <class Body>
void in_threads(int count, Body&& body) {
  std::vector<std::thread> threads;
  for (int n = 0; n < count; ++n) threads.emplace_back([&, n] { body(n); });
  for (std::thread& one : threads) one.join();
}

TEST(CThreads, ACallOnABusyObjectReturnsBusy) {
  const Owned simulation(simulation_of());
  std::atomic<int> made{0}, busy{0}, wrong{0};
  in_threads(4, [&](int) {
    auto result = sized<hapticut_step_result>();
    const hapticut_step_input input = above(-5e-3);
    for (int n = 0; n < 5000; ++n) {
      const int code = hapticut_step(simulation.get(), &input, &result);
      ++(code == HAPTICUT_OK ? made : code == HAPTICUT_ERROR_BUSY ? busy : wrong);
    }
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(made, 0);
  EXPECT_EQ(made + busy, 20000);
}

TEST(CThreads, WorkSideBySideAsTheyDoAlone) {
  auto alone = sized<hapticut_step_result>();
  {
    const Owned simulation(simulation_of());
    for (int n = 1; n <= 200; ++n) {
      const hapticut_step_input input = above(2e-6 * n);
      hapticut_step(simulation.get(), &input, &alone);
    }
  }
  std::atomic<int> different{0};
  in_threads(3, [&](int) {
    const Owned simulation(simulation_of());
    auto result = sized<hapticut_step_result>();
    for (int n = 1; n <= 200; ++n) {
      const hapticut_step_input input = above(2e-6 * n);
      hapticut_step(simulation.get(), &input, &result);
    }
    if (std::memcmp(&result, &alone, sizeof result) != 0) ++different;
  });
  EXPECT_EQ(different, 0);
}

TEST(CThreads, HaveEachItsOwnLastError) {
  hapticut_release(0);
  const std::string here = hapticut_last_error();
  EXPECT_FALSE(here.empty());
  in_threads(1, [](int) {
    EXPECT_STREQ(hapticut_last_error(), "");
    hapticut_device device = 0;
    hapticut_device_open("no_such_device", &device);
    EXPECT_STRNE(hapticut_last_error(), "");
  });
  EXPECT_EQ(hapticut_last_error(), here);
}

TEST(CThreads, AHandleIsReleasedOnceWhileOtherThreadsUseIt) {
  for (int round = 0; round < 200; ++round) {
    hapticut_sound sound = 0;
    ASSERT_EQ(hapticut_sound_open(nullptr, &sound), HAPTICUT_OK);
    std::atomic<int> released{0}, wrong{0};
    in_threads(4, [&](int thread) {
      auto input = sized<hapticut_sound_input>();
      float samples[32];
      for (int n = 0; n < 50; ++n) {
        const int code =
            thread < 2 ? hapticut_release(sound) : hapticut_sound_render(sound, &input, 48000, samples, 32);
        if (thread < 2 && code == HAPTICUT_OK) ++released;
        if (code != HAPTICUT_OK && code != HAPTICUT_ERROR_BUSY && code != HAPTICUT_ERROR_HANDLE) ++wrong;
      }
    });
    if (released == 0) released += hapticut_release(sound) == HAPTICUT_OK ? 1 : 0;
    EXPECT_EQ(released, 1);
    EXPECT_EQ(wrong, 0);
  }
}

TEST(CThreads, LookSendAndAskAtTheSameTime) {
  const Owned simulation(simulation_of(kScene, 1));
  const Owned device(device_of());
  Owned surface, loop;
  ASSERT_EQ(hapticut_surface_open(simulation.get(), surface.to()), HAPTICUT_OK);
  auto options = sized<hapticut_loop_options>();
  options.up = HAPTICUT_UP_Z;
  options.simulated_time = options.ordinary_priority = 1;
  ASSERT_EQ(hapticut_loop_start(simulation.get(), device.get(), &options, loop.to()), HAPTICUT_OK);
  std::atomic<int> wrong{0};
  in_threads(3, [&](int thread) {
    auto state = sized<hapticut_loop_state>();
    auto page = sized<hapticut_page>();
    auto command = sized<hapticut_command>();
    command.kind = HAPTICUT_COMMAND_SET_SPINDLE_SPEED;
    command.value = 3000;
    for (int n = 0; n < 2000; ++n) {
      int code = HAPTICUT_OK;
      if (thread == 0) code = hapticut_loop_latest(loop.get(), &state);
      if (thread == 1) code = hapticut_loop_send(loop.get(), &command);
      if (thread == 2) {
        code = hapticut_surface_poll(surface.get(), &page);
        if (code == HAPTICUT_OK) code = hapticut_surface_release_page(surface.get(), page.ticket);
      }
      if (code < 0 && code != HAPTICUT_ERROR_FULL) ++wrong;
    }
  });
  EXPECT_EQ(wrong, 0);
}

/// Another copy of the library, as in a plug-in of another maker.
class Copy {
 public:
  explicit Copy(const std::filesystem::path& file) : library_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  [[nodiscard]] bool is_there() const { return library_ != nullptr; }
  template <class Function>
  Function* function(const char* name, Function* /*like*/) const {
    return reinterpret_cast<Function*>(dlsym(library_, name));
  }

 private:
  void* library_;  // never unloaded
};

TEST(CCopies, LiveTogetherAndKnowTheirOwnHandles) {
  const test::TemporaryFolder folder;
  std::filesystem::copy_file(test::kCLibrary, folder / "libanother.so");
  const Copy copy(folder / "libanother.so");
  ASSERT_TRUE(copy.is_there()) << dlerror();
  const auto make = copy.function("hapticut_simulation_from_toml", &hapticut_simulation_from_toml);
  const auto step = copy.function("hapticut_step", &hapticut_step);
  const auto release = copy.function("hapticut_release", &hapticut_release);
  ASSERT_NE(make, &hapticut_simulation_from_toml) << "the copy must be another library";
  hapticut_simulation other = 0;
  ASSERT_EQ(make(kScene.c_str(), nullptr, &other), HAPTICUT_OK);
  const Owned mine(simulation_of());
  EXPECT_NE(other, mine.get());
  auto result = sized<hapticut_step_result>(), same = sized<hapticut_step_result>();
  const hapticut_step_input first = above(0);
  EXPECT_EQ(hapticut_step(other, &first, &result), HAPTICUT_ERROR_HANDLE) << "a handle of the other copy";
  EXPECT_EQ(step(mine.get(), &first, &result), HAPTICUT_ERROR_HANDLE);
  for (int n = 1; n <= 200; ++n) {
    const hapticut_step_input input = above(2e-6 * n);
    ASSERT_EQ(hapticut_step(mine.get(), &input, &result), HAPTICUT_OK);
    ASSERT_EQ(step(other, &input, &same), HAPTICUT_OK);
    ASSERT_EQ(std::memcmp(&result, &same, sizeof result), 0) << n;
  }
  EXPECT_EQ(hapticut_release(other), HAPTICUT_ERROR_HANDLE);
  EXPECT_EQ(release(other), HAPTICUT_OK);
}

}  // namespace
}  // namespace hapticut::c_threads_test
