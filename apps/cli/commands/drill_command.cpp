// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include "cli/commands/command.hpp"
#include "reports/beside_steps.hpp"
#include "reports/outputs.hpp"
#include "reports/progress.hpp"
#include "reports/recording_source.hpp"
#include "reports/report.hpp"
#include "settings/scene_settings.hpp"

namespace hapticut::apps {

using namespace settings;

namespace {

struct DrillSettings {
  SceneSettings scene;
  OutputSettings output;
};

void write_files(Delivery& delivery, const OutputSettings& output, const DrillResult& result,
                 const Workpiece& workpiece) {
  const ProgressBar progress("writing the results");
  delivery.write(output.steps_csv, [&] { write_steps(output.steps_csv, result.rows); });
  delivery.write(output.workpiece, [&] { write_workpiece(output.workpiece, workpiece); });
  delivery.write(output.surface, [&] { write_surface(output.surface, workpiece); });
  delivery.write(output.picture, [&] { write_picture_of(output, workpiece); });
}

/// @throws Error when steps were rejected
void require_every_step(const DrillResult& result) {
  if (result.steps_rejected > 0)
    throw Error(std::to_string(result.steps_rejected) + " of " + std::to_string(result.steps) +
                " steps were rejected, so the path was not drilled completely; see the status bits in the report.");
}

void run_drill(const DrillSettings& s) {
  require_replayable(s.output.record, s.scene.simulation.remove_loose_pieces);
  Delivery delivery = delivery_of(s.output);
  const std::string& source = s.scene.workpiece.source;
  settings::Scene scene = with_bar(source, [&] { return make_scene(s.scene); });
  DrillReport report{summarize(source, scene.workpiece), s.scene.simulation.rate_Hz, std::move(scene.warnings)};
  Simulation simulation(std::move(scene.workpiece), scene.tool, scene.config);

  const auto recorder = start_recording(delivery, s.output.record, simulation, Pace::own, nullptr);
  BesideSteps beside(simulation, scene.heat, scene.remove_loose_pieces);
  const DrillResult result = drill(simulation, *scene.motion, report.rate, delivery.wants(s.output.steps_csv), beside);
  recorder->close();
  report.beside = beside.finish();
  for (std::string& warning : warnings_of(report.beside, simulation.workpiece().materials()))
    report.warnings.push_back(std::move(warning));
  for (std::string& warning : warnings_of(result, simulation)) report.warnings.push_back(std::move(warning));
  const std::string empty = warning_of_empty_outputs(s.output, simulation.workpiece());
  if (!empty.empty()) report.warnings.push_back(empty);
  write_json(delivery, s.output.json, to_json(report, result, simulation));
  delivery.print(to_table(report, result, simulation));
  write_files(delivery, s.output, result, simulation.workpiece());
  delivery.attempt([&] { recorder->require_complete(); });
  delivery.attempt([&] { require_every_step(result); });
  delivery.finish();
}

}  // namespace

Command drill_command() {
  auto settings = std::make_shared<DrillSettings>();
  tell_on_stderr(settings->scene.workpiece);
  return {"drill", "Move a tool along a path through a workpiece at a fixed rate; report forces and removal",
          together({settings_of(settings->scene), settings_of(settings->output)}),
          [settings] { run_drill(*settings); }};
}

}  // namespace hapticut::apps
