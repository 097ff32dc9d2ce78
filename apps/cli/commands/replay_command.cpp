// SPDX-License-Identifier: Apache-2.0
// hapticut replay and hapticut export.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands/command.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "reports/delivery.hpp"
#include "reports/fail_without.hpp"
#include "reports/json_file.hpp"
#include "reports/progress.hpp"
#include "reports/table.hpp"
#include "settings/force_settings.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/recording/replay.hpp"
#ifdef HAPTICUT_HAS_VIEW
#include "page/session/page_folder.hpp"
#include "page/session/replay_page.hpp"
#endif
#endif

namespace hapticut::apps {

using namespace settings;

namespace {

struct ReplaySettings {
  std::string recording, json;
  ForceSettings force;
};

struct ExportSettings {
  std::string recording, target, page;
};

#ifdef HAPTICUT_HAS_IO
Json to_json(const RecordingInfo& info) {
  return {{"format", info.format}, {"version", info.version}, {"commit", info.commit},  {"compiler", info.compiler},
          {"cpu", info.cpu},       {"begun", info.begun},     {"device", info.device},  {"note", info.note},
          {"closed", info.closed}, {"lost_steps", info.lost}, {"remarks", info.remarks}};
}

Json to_json(const std::optional<ReplayDifference>& difference) {
  if (!difference) return nullptr;
  return {{"step", difference->step},
          {"column", difference->column},
          {"element", difference->element},
          {"recorded", difference->recorded},
          {"replayed", difference->replayed}};
}

std::string text_of(const ReplayDifference& d) {
  return "step " + std::to_string(d.step) + ", " + d.column + "[" + std::to_string(d.element) + "]: recorded " +
         rounded(d.recorded, 17) + ", replayed " + rounded(d.replayed, 17);
}

/// @throws Error unless every step was replayed and is identical
void require_identical(const ReplaySettings& s, const Recording& recording, const ReplayReport& report) {
  if (!report.identical)
    throw Error("the replay of '" + s.recording + "' differs from the recording at " +
                text_of(*report.first_difference) + ". docs/files.md says when a replay must be identical.");
  if (report.skipped > 0)
    throw Error(std::to_string(report.skipped) + " of " + std::to_string(recording.size()) + " steps of '" +
                s.recording + "' follow a lost step, so they could not be replayed.");
}

void run_replay(const ReplaySettings& s) {
  Delivery delivery({s.json});
  const Recording recording = read_recording(s.recording);
  ProgressBar progress("replaying", std::size_t(recording.size()));
  ReplayOptions options;
  const std::shared_ptr<const ForceLaw> law = make_law(s.force);  // throws for constants of another law
  if (s.force.law) options.law = law;
  options.progress = [&](std::uint64_t steps) { progress.advance_to(std::size_t(steps)); };
  const ReplayReport report = replay(recording, options);
  const RecordingInfo& info = recording.info();

  Table table("hapticut replay: " + s.recording);
  table.add("recorded", info.begun + " by hapticut " + info.version + (info.commit.empty() ? "" : " " + info.commit) +
                            ", " + info.compiler + ", " + info.cpu);
  table.add("steps", std::to_string(report.steps) + " of " + std::to_string(recording.size()));
  const char* const same =
      recording.size() > 0 ? "yes, every bit" : "yes, but it has no steps, so nothing was compared";
  table.add("identical", report.identical ? same : "no");
  if (report.first_difference) table.add("difference", text_of(*report.first_difference));
  if (!report.identical) table.add("force", "at most " + rounded(report.max_force_difference) + " N off");
  for (const std::string& remark : info.remarks) table.add("remark", remark);
  write_json(delivery, s.json,
             {{"steps", report.steps},
              {"identical", report.identical},
              {"first_difference", to_json(report.first_difference)},
              {"max_force_difference_N", report.max_force_difference},
              {"recorded_steps", recording.size()},
              {"skipped", report.skipped},
              {"recording", to_json(info)},
              {"build", build_json()}});
  delivery.print(table.text());
  delivery.attempt([&] { require_identical(s, recording, report); });
  delivery.finish();
}

void write_html(const Recording& recording, const ExportSettings& s) {
#ifdef HAPTICUT_HAS_VIEW
  write_replay_page(recording, find_page(s.page), s.target);
#else
  (void)recording;
  fail_without("view", "'" + s.target + "' cannot be written");
#endif
}

void run_export(const ExportSettings& s) {
  const std::string extension = extension_in_lower_case(s.target);
  if (extension != ".csv" && extension != ".npz" && extension != ".wav" && extension != ".html")
    throw UsageError("cannot write '" + s.target + "': its extension must be .csv, .npz, .wav or .html.");
  if (!s.page.empty() && extension != ".html")
    throw UsageError(
        "--page is set; must be left out, because only a .html shows the page. Leave it out, or write a .html.");
  const Recording recording = read_recording(s.recording);
  require_writable(s.target);
  if (extension == ".csv")
    write_csv(recording, s.target);
  else if (extension == ".npz")
    write_npz(recording, s.target);
  else if (extension == ".html")
    write_html(recording, s);
  else
    write_wav(recording, s.target);
  print_on_stdout(s.target + ": " + std::to_string(recording.size()) + " steps\n");
}
#else
void run_replay(const ReplaySettings& s) { fail_without("io", "'" + s.recording + "' cannot be read"); }

void run_export(const ExportSettings& s) { run_replay({s.recording, "", {}}); }
#endif

}  // namespace

Command replay_command() {
  auto settings = std::make_shared<ReplaySettings>();
  std::vector<Setting> all = {
      path("replay.recording", "RECORDING", settings->recording, "recording of drill --record or loop --record"),
      json_setting(settings->json)};
  return {"replay", "Repeat a recording and compare the results bit by bit",
          together({std::move(all), law_settings_of(settings->force)}), [settings] {
            if (settings->recording.empty()) throw UsageError("the recording is missing. Use: hapticut replay FILE.");
            run_replay(*settings);
          }};
}

Command export_command() {
  auto settings = std::make_shared<ExportSettings>();
  return {"export",
          "Export a recording as CSV, NumPy, sound or a page that replays it",
          {path("export.recording", "RECORDING", settings->recording, "recording of drill --record or loop --record"),
           path("output.target", "TARGET", settings->target, "file to write: .csv, .npz, .wav or .html"),
           path("export.page", "--page", settings->page, ".html: folder of the built page [next to the program]")},
          [settings] {
            if (settings->recording.empty() || settings->target.empty())
              throw UsageError("a file is missing. Use: hapticut export RECORDING TARGET.");
            run_export(*settings);
          }};
}

}  // namespace hapticut::apps
