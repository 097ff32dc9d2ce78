// SPDX-License-Identifier: Apache-2.0
// Makes one step of a scene from a text. The error message of a wrong text must name the line, the key and the allowed
// values.
#include <hapticut/settings/scene.hpp>
#include <hapticut/simulation/simulation.hpp>
#include <string>
#include <utility>

namespace {

constexpr const char* kScene = R"(
[workpiece]
source = "block"
size_mm = [4, 4, 2]
material = "cortical_bone"

[tool]
head = "sphere"
radius_mm = 1
spindle_rpm = 30000

[simulation]
reference_stiffness_N_per_m4 = 1e14

[path]
kind = "line"
point = "head"
from_mm = [-2, 2, 2.5]
to_mm = [6, 2, 2.5]
feed_mm_per_s = 4

[output]
json = "what the program writes"
)";

bool names_the_mistake() {
  std::string text = kScene;
  text.replace(text.find("radius_mm = 1"), 13, "radius_mm = -1");
  try {
    (void)hapticut::settings::from_toml(text);
  } catch (const hapticut::Error& error) {
    return std::string(error.what()) == "scene:9: tool.radius_mm: must be a number > 0 and <= 300, not -1.";
  }
  return false;
}

}  // namespace

bool use_settings() {
  using namespace hapticut;
  settings::Scene scene = settings::from_toml(kScene);
  const double middle = scene.motion->duration() / 2;
  Simulation simulation(std::move(scene.workpiece), scene.tool, scene.config);
  const Pose X_WH = scene.motion->pose_at(middle) * simulation.tool().X_HT().inverse();
  const StepResult& step = simulation.step(X_WH, Twist{Vec3(4e-3, 0, 0), Vec3::Zero()}, 1 / scene.config.update_rate);
  return step.force.z() > 0 && step.removed_volume > 0 && names_the_mistake();
}
