// SPDX-License-Identifier: Apache-2.0
#include "page/session/view_scenes.hpp"

#include <filesystem>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "io/file_errors.hpp"
#include "reports/progress.hpp"
#include "reports/report.hpp"
#include "settings/scene_settings.hpp"
#include "settings/settings_file.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

constexpr const char* kSkull = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";

SceneSettings clay_scene() {
  SceneSettings s;
  s.workpiece.source = "block";
  s.workpiece.size_mm = Vec3(20, 20, 20);
  s.workpiece.voxel_mm = 0.2;
  s.workpiece.material = "clay";
  s.tool.set_sphere(2);
  s.tool.handle = ToolSettings::HandleKind::ray;
  s.tool.handle_length_mm = 100;
  s.tool.spindle_rpm = 1000;  // about 1 N at 5 mm/s; at 20 000 rpm a hand would feel nothing
  return s;
}

SceneSettings molar_scene() {
  SceneSettings s;
  s.workpiece.source = "molar";
  s.workpiece.voxel_mm = 0.1;
  s.tool.set_sphere(0.8);
  s.tool.handle = ToolSettings::HandleKind::angled;
  s.tool.handle_length_mm = 100;
  s.tool.handle_neck_mm = 15;
  s.tool.handle_bend_deg = 90;
  s.tool.spindle_rpm = 200000;
  return s;
}

/// The right temporal bone, as in scripts/demo.sh.
SceneSettings skull_scene() {
  if (!std::filesystem::exists(kSkull))
    throw Error(std::string("the skull scene needs '") + kSkull +
                "': install Debian's package invesalius-examples, or show another scene.");
  SceneSettings s;
  s.workpiece.source = kSkull;
  s.workpiece.crop_mm = {52, 78, 14, 92, 122, 46};
  s.workpiece.voxel_mm = 0.2;
  s.workpiece.largest_component = true;
  s.workpiece.grey = {{"trabecular_bone", 226, 700}, {"cortical_bone", 700, std::nullopt}};
  s.tool.set_sphere(2);
  s.tool.handle = ToolSettings::HandleKind::ray;
  s.tool.handle_length_mm = 120;
  s.tool.spindle_rpm = 40000;
  return s;
}

SceneSettings scene_of_file(const std::string& name) {
  SceneSettings s;
  if (extension_in_lower_case(name) == ".toml") {
    read_settings_file(name, settings_of(s), {"output", "loop"});
    return s;
  }
  if (is_missing(name))
    throw Error("there is no scene '" + name +
                "'. Choose clay, molar or skull, a settings file (.toml), or a workpiece (.vdb).");
  if (extension_in_lower_case(name) == ".h5")
    throw Error("'" + name + "' is a recording, which replaces the whole page. To show it: hapticut view " + name +
                ".");
  if (extension_in_lower_case(name) != ".vdb" || !unreachable(name).empty() || !std::filesystem::is_regular_file(name))
    throw Error("'" + name +
                "' is no scene. Choose clay, molar or skull, a settings file (.toml), or a workpiece that hapticut has "
                "saved (.vdb). A settings file names another file, and its materials, under [workpiece].");
  s.workpiece.source = name;
  return s;
}

/// The default tool: a ball with a twelfth of the size of the workpiece, so it is visible.
void complete_tool(ToolSettings& tool, const Box& box) {
  if (tool.head) return;
  const double size = (box.max - box.min).maxCoeff();
  tool.set_sphere(std::clamp(size / 24 / units::mm, 0.3, 5.0));
  if (!tool.handle) {
    tool.handle = ToolSettings::HandleKind::ray;
    tool.handle_length_mm = 100;
  }
  if (!tool.spindle_rpm) tool.spindle_rpm = 40000;
}

}  // namespace

ViewScene make_view_scene(const std::string& name) {
  SceneSettings s = name == "clay"    ? clay_scene()
                    : name == "molar" ? molar_scene()
                    : name == "skull" ? skull_scene()
                                      : scene_of_file(name);
  tell_on_stderr(s.workpiece);
  if (s.workpiece.source.empty()) s.workpiece.source = "molar";
  // A tool of the scene determines the constants; without one a ball is chosen to suit the workpiece.
  const CutterKind cutter =
      s.tool.head ? make_tool(s.tool).cutter().kind : s.tool.cutter.value_or(CutterKind::carbide_bur);
  Workpiece workpiece =
      with_bar(s.workpiece.source, [&] { return make_workpiece(s.workpiece, cutter, s.tool.sharpness); });
  const Box box = summarize(name, workpiece).box;
  complete_tool(s.tool, box);
  s.simulation.texture_by_default = true;
  SimulationConfig config = make_config(s.simulation);
  config.contact_time = ContactTime::end;
  config.reserved_blocks = std::max<std::size_t>(config.reserved_blocks, 16384);
  ViewScene scene{name, std::move(workpiece), make_tool(s.tool), std::move(config), box};
  if (name == "skull") scene.axis = Vec3(-1, 0, 0);
  scene.shows_heat = std::exchange(s.heat.on, true);  // its numbers also count when a page turns it on
  scene.heat = *make_heat(s.heat, scene.workpiece.materials(), s.workpiece.materials);
  scene.removes_loose_pieces = s.simulation.remove_loose_pieces;
  return scene;
}

Pose start_pose(const ViewScene& scene) {
  const Vec3 middle = 0.5 * (scene.box.min + scene.box.max), half = 0.5 * (scene.box.max - scene.box.min);
  const Vec3 z = scene.axis;
  const Vec3 x = (std::abs(z.x()) > 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
  Pose X_WT;
  X_WT.rotation.col(2) = z;
  X_WT.rotation.col(0) = (x - x.dot(z) * z).normalized();
  X_WT.rotation.col(1) = z.cross(Vec3(X_WT.rotation.col(0)));
  const double tip = scene.tool.head().bounding_box().min.z();
  X_WT.translation = middle + (half.cwiseProduct(z.cwiseAbs()).sum() + 4e-3 - tip) * z;
  return X_WT;
}

}  // namespace hapticut::apps
