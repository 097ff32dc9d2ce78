// SPDX-License-Identifier: Apache-2.0
// Loops on a mock device, with commands, pages, sound and recordings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <vector>

#include "support/temporary_folder.hpp"
#include "unit/c/scripted_loop.hpp"

namespace hapticut::c_loop_test {
namespace {

using namespace c_test;

/// The vertices of all pages by their place, independent of the time of polling.
using Pages = std::map<std::tuple<int, int, int>, std::vector<unsigned char>>;
void read_pages(hapticut_surface surface, Pages& pages) {
  auto page = sized<hapticut_page>();
  int code = HAPTICUT_OK;
  while ((code = hapticut_surface_poll(surface, &page)) == HAPTICUT_OK) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(page.vertices);
    std::vector<unsigned char> content(bytes, bytes + sizeof(hapticut_vertex) * page.vertex_count);
    for (std::uint32_t n = 0; n < page.index_count; ++n) {
      ASSERT_LT(page.indices[n], page.vertex_count);
      content.push_back((unsigned char)(page.indices[n] & 0xffU));
      content.push_back((unsigned char)(page.indices[n] >> 8U));
    }
    const std::tuple place{page.origin[0], page.origin[1], page.origin[2]};
    if (content.empty())
      pages.erase(place);
    else
      pages[place] = std::move(content);
    ASSERT_EQ(hapticut_surface_release_page(surface, page.ticket), HAPTICUT_OK);
  }
  ASSERT_EQ(code, HAPTICUT_NOTHING) << hapticut_last_error();
}

TEST(CLoop, CutsAndIsSeen) {
  ScriptedLoop scripted;
  scripted.open_surface();
  const double whole = volume_of(scripted.simulation.get());
  scripted.start(5);
  Pages pages;
  for (int running = 1; running == 1;) {
    ASSERT_EQ(hapticut_loop_is_running(scripted.loop.get(), &running), HAPTICUT_OK);
    read_pages(scripted.surface.get(), pages);
  }
  const hapticut_loop_state last = scripted.latest();
  auto report = sized<hapticut_loop_report>();
  ASSERT_EQ(hapticut_loop_stop(scripted.loop.get(), &report), HAPTICUT_OK) << hapticut_last_error();
  EXPECT_GE(report.ticks, 5000U);
  EXPECT_EQ(report.fault, 0U);
  EXPECT_NE(std::string(report.end), "");
  EXPECT_EQ(hapticut_loop_stop(scripted.loop.get(), &report), HAPTICUT_NOTHING);
  EXPECT_EQ(last.tick, report.ticks);
  EXPECT_GT(last.removed_volume, 0);
  EXPECT_EQ(last.arming, std::uint32_t(HAPTICUT_ARMING_ON));
  EXPECT_NEAR(whole - volume_of(scripted.simulation.get()), last.removed_volume, 1e-6 * whole);

  // The polled pages equal those of the present workpiece.
  ASSERT_EQ(hapticut_surface_catch_up(scripted.surface.get()), HAPTICUT_OK) << hapticut_last_error();
  read_pages(scripted.surface.get(), pages);
  Owned fresh;
  ASSERT_EQ(hapticut_surface_open(scripted.simulation.get(), fresh.to()), HAPTICUT_OK);
  Pages expected;
  read_pages(fresh.get(), expected);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(pages, expected);
}

TEST(CLoop, AppliesCommandsWhileItRuns) {
  ScriptedLoop scripted;
  scripted.start(0);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.removed_volume > 0; }));
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_HOLD_FORCE, 1), HAPTICUT_OK);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return (state.flags & HAPTICUT_LOOP_FORCE_HELD) != 0; }));
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_HOLD_FORCE, 0), HAPTICUT_OK);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return (state.flags & HAPTICUT_LOOP_FORCE_HELD) == 0; }));
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_SET_UNDO_MARK), HAPTICUT_OK) << hapticut_last_error();
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.undo_marks == 1; }));
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_UNDO), HAPTICUT_OK);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.undo_marks == 0; }));
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_OPEN_CLUTCH), HAPTICUT_OK);
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_CLOSE_CLUTCH), HAPTICUT_OK);
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_SET_SCALE, 1.5), HAPTICUT_OK) << hapticut_last_error();
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_SET_FORCE_MASK, 63), HAPTICUT_OK);
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_SET_REMOVAL, 1), HAPTICUT_OK);
  ASSERT_EQ(hapticut_loop_set_tool(scripted.loop.get(), kOtherTool.c_str()), HAPTICUT_OK) << hapticut_last_error();
  ASSERT_EQ(scripted.send(HAPTICUT_COMMAND_SET_SPINDLE_SPEED, 2000), HAPTICUT_OK);

  EXPECT_EQ(scripted.send(HAPTICUT_COMMAND_SET_SCALE, -1), HAPTICUT_ERROR_REFUSED);
  EXPECT_TRUE(std::string_view(hapticut_last_error()).starts_with("value of HAPTICUT_COMMAND_SET_SCALE = -1"))
      << hapticut_last_error();
  EXPECT_EQ(scripted.send(HAPTICUT_COMMAND_HOLD_FORCE, 0.5), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(scripted.send(HAPTICUT_COMMAND_SET_FORCE_MASK, 64), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(scripted.send(HAPTICUT_COMMAND_SET_FORCE_MASK, std::nan("")), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(scripted.send(0), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(scripted.send(999), HAPTICUT_ERROR_ARGUMENT);
  EXPECT_EQ(hapticut_loop_set_tool(scripted.loop.get(), "[tool]\nradius_mm = -1\n"), HAPTICUT_ERROR_REFUSED);

  ASSERT_EQ(hapticut_loop_emergency_stop(scripted.loop.get()), HAPTICUT_OK);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.arming == HAPTICUT_ARMING_FAULT; }));
  ASSERT_EQ(hapticut_loop_reset_fault(scripted.loop.get()), HAPTICUT_OK);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.arming != HAPTICUT_ARMING_FAULT; }));
  EXPECT_EQ(scripted.latest().commands_refused, 0U);
  ASSERT_EQ(hapticut_loop_stop(scripted.loop.get(), nullptr), HAPTICUT_OK);
  EXPECT_EQ(scripted.send(HAPTICUT_COMMAND_UNDO), HAPTICUT_ERROR_REFUSED) << "the loop was stopped";
}

TEST(CLoop, OwnsItsSimulationAndItsDeviceExclusively) {
  ScriptedLoop scripted;
  scripted.open_surface();
  Owned coupling;
  ASSERT_EQ(hapticut_coupling_open(scripted.simulation.get(), nullptr, coupling.to()), HAPTICUT_OK);
  scripted.start(0);
  const hapticut_step_input input = above(0);
  auto result = sized<hapticut_step_result>();
  EXPECT_EQ(hapticut_step(scripted.simulation.get(), &input, &result), HAPTICUT_ERROR_BUSY);
  EXPECT_NE(std::string(hapticut_last_error()).find("hapticut_loop_stop"), std::string::npos);
  EXPECT_EQ(hapticut_coupling_step(coupling.get(), &input, &result), HAPTICUT_ERROR_BUSY);
  EXPECT_EQ(hapticut_undo(scripted.simulation.get()), HAPTICUT_ERROR_BUSY);
  EXPECT_EQ(hapticut_surface_catch_up(scripted.surface.get()), HAPTICUT_ERROR_BUSY);
  hapticut_handle made = 0;
  EXPECT_EQ(hapticut_surface_open(scripted.simulation.get(), &made), HAPTICUT_ERROR_BUSY);
  const hapticut_loop_options options = for_mock(1);
  EXPECT_EQ(hapticut_loop_start(scripted.simulation.get(), scripted.device.get(), &options, &made),
            HAPTICUT_ERROR_BUSY);
  const Owned other(simulation_of(kScene, 1));
  EXPECT_EQ(hapticut_loop_start(other.get(), scripted.device.get(), &options, &made), HAPTICUT_ERROR_BUSY);
  auto info = sized<hapticut_scene_info>();
  EXPECT_EQ(hapticut_scene(scripted.simulation.get(), &info), HAPTICUT_OK) << "the scene never changes";
  ASSERT_EQ(hapticut_loop_stop(scripted.loop.get(), nullptr), HAPTICUT_OK);
  EXPECT_EQ(hapticut_step(scripted.simulation.get(), &input, &result), HAPTICUT_OK) << hapticut_last_error();
  // The device runs again, with another simulation.
  Owned again;
  ASSERT_EQ(hapticut_loop_start(other.get(), scripted.device.get(), &options, again.to()), HAPTICUT_OK)
      << hapticut_last_error();
}

TEST(CLoop, EndsWithItsHandleForAnyOrderOfReleases) {
  for (const int order : {0, 1, 2, 3, 4, 5}) {
    ScriptedLoop scripted;
    scripted.open_surface();
    scripted.start(0);
    std::array<Owned*, 4> owned = {&scripted.simulation, &scripted.surface, &scripted.device, &scripted.loop};
    std::rotate(owned.begin(), owned.begin() + order % 4, owned.end());
    if (order > 3) std::swap(owned[0], owned[1]);
    for (Owned* one : owned) EXPECT_EQ(one->release(), HAPTICUT_OK) << hapticut_last_error();
  }
}

TEST(CLoop, RefusesWhatDoesNotFit) {
  const Owned stiff(simulation_of());  // made without for_coupling
  const Owned device(device_of());
  hapticut_loop loop = 0;
  auto options = for_mock(1);
  EXPECT_EQ(hapticut_loop_start(stiff.get(), device.get(), &options, &loop), HAPTICUT_ERROR_REFUSED);
  EXPECT_NE(std::string(hapticut_last_error()).find("for_coupling"), std::string::npos) << hapticut_last_error();
  options.coupling = HAPTICUT_COUPLING_NEVER;
  EXPECT_EQ(hapticut_loop_start(stiff.get(), device.get(), &options, &loop), HAPTICUT_ERROR_REFUSED) << "too stiff";
  options.coupling = 7;
  EXPECT_EQ(hapticut_loop_start(stiff.get(), device.get(), &options, &loop), HAPTICUT_ERROR_ARGUMENT);
  options = for_mock(-1);
  const Owned coupled(simulation_of(kScene, 1));
  EXPECT_EQ(hapticut_loop_start(coupled.get(), device.get(), &options, &loop), HAPTICUT_ERROR_REFUSED);
  options = for_mock(1);
  options.has_X_WB = 1;  // all zero: an invalid pose
  EXPECT_EQ(hapticut_loop_start(coupled.get(), device.get(), &options, &loop), HAPTICUT_ERROR_REFUSED);
  EXPECT_EQ(loop, 0U);
  const hapticut_step_input input = above(0);
  auto result = sized<hapticut_step_result>();
  EXPECT_EQ(hapticut_step(coupled.get(), &input, &result), HAPTICUT_OK) << "a refusal does not claim the simulation";
  hapticut_device none = 0;
  EXPECT_EQ(hapticut_device_open("no_such_device", &none), HAPTICUT_ERROR_REFUSED);
  EXPECT_NE(std::string(hapticut_last_error()).find("mock:"), std::string::npos) << "the error lists the known devices";
}

TEST(CLoop, LeavesTheSignalsOfTheProcessAlone) {
  ScriptedLoop scripted;
  std::map<int, void (*)(int)> before;
  const auto handler_of = [](int signal) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    return action.sa_handler;
  };
  const std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};
  for (const int signal : kSignals) before[signal] = handler_of(signal);
  scripted.start(0);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.tick > 100; }));
  for (const int signal : kSignals) EXPECT_EQ(handler_of(signal), before[signal]) << signal;
}

TEST(CSound, IsMadeOfWhatTheLoopShows) {
  ScriptedLoop scripted;
  scripted.start(0);
  ASSERT_TRUE(scripted.becomes([](const auto& state) { return state.power > 0 && state.spindle_speed > 0; }));
  const hapticut_loop_state state = scripted.latest();
  auto options = sized<hapticut_sound_options>();
  options.volume = 1;
  Owned sound;
  ASSERT_EQ(hapticut_sound_open(&options, sound.to()), HAPTICUT_OK) << hapticut_last_error();
  auto input = sized<hapticut_sound_input>();
  input.touching = 1;
  input.spindle_speed = state.spindle_speed;
  input.power = 1;
  input.removal_rate = 1e-9;
  std::vector<float> samples(4800);
  ASSERT_EQ(hapticut_sound_render(sound.get(), &input, 48000, samples.data(), samples.size()), HAPTICUT_OK);
  EXPECT_GT(*std::max_element(samples.begin(), samples.end()), 0.05F);
  EXPECT_LE(*std::max_element(samples.begin(), samples.end()), 1.0F);
  ASSERT_EQ(hapticut_sound_render(sound.get(), &input, 17, samples.data(), samples.size()), HAPTICUT_OK);
  EXPECT_EQ(*std::max_element(samples.begin(), samples.end()), 0.0F) << "silence at no sample rate";
  options.volume = 2;
  hapticut_sound loud = 0;
  EXPECT_EQ(hapticut_sound_open(&options, &loud), HAPTICUT_ERROR_REFUSED);
}

#ifdef HAPTICUT_HAS_IO
TEST(CRecording, HoldsEveryStepOfALoop) {
  const test::TemporaryFolder folder;
  const std::string path = (folder / "loop.h5").string();
  ScriptedLoop scripted;
  Owned recording;
  ASSERT_EQ(hapticut_recording_start(scripted.simulation.get(), scripted.device.get(), path.c_str(), recording.to()),
            HAPTICUT_OK)
      << hapticut_last_error();
  scripted.start(1);
  EXPECT_EQ(hapticut_recording_stop(recording.get(), nullptr), HAPTICUT_ERROR_BUSY);
  for (int running = 1; running == 1;) ASSERT_EQ(hapticut_loop_is_running(scripted.loop.get(), &running), HAPTICUT_OK);
  ASSERT_EQ(hapticut_loop_stop(scripted.loop.get(), nullptr), HAPTICUT_OK);
  auto report = sized<hapticut_recording_report>();
  ASSERT_EQ(hapticut_recording_stop(recording.get(), &report), HAPTICUT_OK) << hapticut_last_error();
  EXPECT_GE(report.recorded, 1000U);
  EXPECT_EQ(hapticut_recording_stop(recording.get(), nullptr), HAPTICUT_NOTHING);

  // A device plays the recording back.
  const Owned player(device_of(("replay:" + path).c_str()));
  auto info = sized<hapticut_device_info>();
  ASSERT_EQ(hapticut_device_describe(player.get(), &info), HAPTICUT_OK);
  EXPECT_EQ(info.input_degrees_of_freedom, 6);
  hapticut_recording late = 0;
  EXPECT_EQ(hapticut_recording_start(scripted.simulation.get(), 0, path.c_str(), &late), HAPTICUT_ERROR_REFUSED)
      << "the simulation has made steps";
}
#endif

}  // namespace
}  // namespace hapticut::c_loop_test
