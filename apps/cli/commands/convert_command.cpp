// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/commands/command.hpp"
#include "reports/delivery.hpp"
#include "reports/outputs.hpp"
#include "reports/progress.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

struct ConvertSettings {
  WorkpieceSettings workpiece;
  std::string target;
};

void run_convert(const ConvertSettings& s) {
  if (s.target.empty()) throw UsageError("the file to write is missing. Use: hapticut convert SOURCE TARGET.");
  check_workpiece_file(s.target);
  const Workpiece workpiece = with_bar(s.workpiece.source, [&] { return make_workpiece(s.workpiece); });
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
  all.push_back(workpiece_file("output.target", "TARGET", settings->target, "file to write"));
  return {"convert", "Turn a file or a built-in workpiece into another file", std::move(all),
          [settings] { run_convert(*settings); }};
}

}  // namespace hapticut::apps
