// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <memory>
#include <utility>

#include "cli/commands/command.hpp"
#include "cli/commands/recording_source.hpp"
#include "cli/reports/outputs.hpp"
#include "cli/reports/progress.hpp"
#include "cli/reports/report.hpp"
#include "settings/scene_settings.hpp"

namespace hapticut::cli {

using namespace settings;

namespace {

struct DrillSettings {
  SceneSettings scene;
  OutputSettings output;
};

void write_files(const OutputSettings& output, const Json& report, const DrillResult& result,
                 const Workpiece& workpiece) {
  const ProgressBar progress("writing the results");
  if (!output.steps_csv.empty()) write_steps(output.steps_csv, result.rows);
  if (!output.workpiece.empty()) write_workpiece(output.workpiece, workpiece);
  if (!output.surface.empty()) write_surface(output.surface, workpiece);
  if (!output.picture.empty()) write_picture_of(output, workpiece);
  write_json(output.json, report);
}

void run_drill(const DrillSettings& s) {
  check_outputs(s.output);
  const std::string& source = s.scene.workpiece.source;
  settings::Scene scene = with_bar(source, [&] { return make_scene(s.scene); });
  DrillReport report{summarize(source, scene.workpiece), s.scene.simulation.rate_Hz, std::move(scene.warnings)};
  Simulation simulation(std::move(scene.workpiece), scene.tool, scene.config);

  RunRecorder recorder(s.output.record, simulation, Pace::own, nullptr);
  const DrillResult result = drill(simulation, *scene.motion, report.rate, !s.output.steps_csv.empty());
  recorder.close();
  for (std::string& warning : warnings_of(result, simulation)) report.warnings.push_back(std::move(warning));
  std::fputs(to_table(report, result, simulation).c_str(), stdout);
  write_files(s.output, to_json(report, result, simulation), result, simulation.workpiece());
  recorder.require_complete();

  if (result.steps_rejected > 0)
    throw Error(std::to_string(result.steps_rejected) + " of " + std::to_string(result.steps) +
                " steps were rejected, so the path was not drilled completely; see the status bits in the report.");
}

}  // namespace

Command drill_command() {
  auto settings = std::make_shared<DrillSettings>();
  tell_on_stderr(settings->scene.workpiece);
  return {"drill", "Move a tool along a path through a workpiece at a fixed rate; report forces and removal",
          together({settings_of(settings->scene), settings_of(settings->output)}),
          [settings] { run_drill(*settings); }};
}

}  // namespace hapticut::cli
