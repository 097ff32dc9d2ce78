// SPDX-License-Identifier: Apache-2.0
// A fuzzer of one kind of user text, FUZZ_FORMAT: settings, poses or a profile, and of the objects made from them,
// except the workpiece.
#include <algorithm>
#include <cstdint>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/tool/profile.hpp"
#include "settings/pose_file.hpp"
#include "settings/profile_file.hpp"
#include "settings/scene_settings.hpp"
#include "settings/settings_file.hpp"

namespace hapticut::test {
namespace {

/// Limits the path to few points, to save time; up to 1e7 are allowed.
[[maybe_unused]] bool is_short(const settings::PathSettings& path) {
  constexpr double kFar = 100, kNear = 0.1;  // [mm]
  const auto within = [](const std::optional<double>& length) { return length.value_or(0) <= kFar; };
  return within(path.turns) && within(path.depth_mm) && within(path.start_radius_mm) && within(path.end_radius_mm) &&
         within(path.top_radius_mm) && within(path.bottom_radius_mm) && path.pitch_mm.value_or(1) >= kNear &&
         path.layer_mm.value_or(1) >= kNear;
}

[[maybe_unused]] void fuzz_settings(const std::string& text) {
  settings::SceneSettings scene;
  settings::read_settings(text, "a.toml", settings_of(scene), {"output", "loop"});
  const Tool tool = make_tool(scene.tool);
  if (is_short(scene.path)) (void)make_motion(scene.path, tool);
  (void)make_config(scene.simulation);
}

[[maybe_unused]] void fuzz_poses(const std::string& text) {
  (void)settings::Motion(settings::poses_of_text(text, "a.csv", Mat3::Identity()));
}

[[maybe_unused]] void fuzz_profile(const std::string& text) {
  constexpr double kCoarse = 0.1;  // the coarsest; a finer table repeats the same work
  (void)ProfileHead(settings::profile_of_text(text, "a.csv"), kCoarse);
}

}  // namespace
}  // namespace hapticut::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    hapticut::test::FUZZ_FORMAT({reinterpret_cast<const char*>(data), size});
  } catch (const hapticut::Error&) {
  }
  return 0;
}
