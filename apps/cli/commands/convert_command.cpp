// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/commands/command.hpp"
#include "reports/delivery.hpp"
#include "reports/outputs.hpp"
#include "reports/progress.hpp"
#include "reports/shared_warnings.hpp"
#include "settings/tool_settings.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

struct ConvertSettings {
  WorkpieceSettings workpiece;
  std::optional<CutterKind> cutter;
  std::optional<Sharpness> sharpness;
  std::string target;
};

/// @throws Error when materials of a file keep constants for another cutter than the given one
void require_constants_for(CutterKind cutter, const MaterialTable& materials, const std::string& source) {
  for (const auto& [kind, names] : names_by_cutter(materials)) {
    if (kind == cutter) continue;
    throw Error("tool.cutter"_name + " = " + std::string(name_or_null(cutter)) + " was given, but " +
                text_of_names(names) + " of '" + source + "' keeps its constants for " +
                std::string(name_or_null(kind)) +
                ". Leave it out, convert the source of that file again, or write based_on = \"a preset\" into " +
                "[material." + names.front() + "] of a settings file.");
  }
}

void run_convert(const ConvertSettings& s) {
  if (s.target.empty()) throw UsageError("the file to write is missing. Use: hapticut convert SOURCE TARGET.");
  check_workpiece_file(s.target);
  const CutterKind cutter = s.cutter.value_or(CutterKind::carbide_bur);
  const Workpiece workpiece =
      with_bar(s.workpiece.source, [&] { return make_workpiece(s.workpiece, cutter, s.sharpness); });
  if (s.cutter) require_constants_for(cutter, workpiece.materials(), s.workpiece.source);
  {
    const ProgressBar progress("writing " + s.target);
    write_workpiece(s.target, workpiece);
  }
  const std::string empty = warning_of_empty_file(s.target, workpiece);
  if (!empty.empty()) tell_error(empty);
  print_on_stdout(s.target + ": " + std::to_string(workpiece.solid_voxels()) + " voxels\n");
}

}  // namespace

Command convert_command() {
  auto settings = std::make_shared<ConvertSettings>();
  tell_on_stderr(settings->workpiece);
  std::vector<Setting> all = settings_of(settings->workpiece);
  all.front().flag = "SOURCE";
  all.push_back(cutter_setting(settings->cutter, "carbide_bur"));
  all.push_back(sharpness_setting(settings->sharpness));
  all.push_back(workpiece_file("output.target", "TARGET", settings->target, "file to write"));
  return {"convert", "Turn a file or a built-in workpiece into another file", std::move(all),
          [settings] { run_convert(*settings); }};
}

}  // namespace hapticut::apps
