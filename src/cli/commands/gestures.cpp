// SPDX-License-Identifier: Apache-2.0
// hapticut gestures: what a hand does, what physics demands of it, what is seen.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/reports/json_file.hpp"
#include "cli/reports/progress.hpp"
#include "cli/reports/table.hpp"
#include "hapticut/bench/gestures.hpp"
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/errors.hpp"
#include "io/atomic_file.hpp"

namespace hapticut::cli {

using namespace settings;

namespace {

struct GestureSettings {
  std::string only, json, markdown;
};

std::string size_of(const GestureRow& row) {
  return row.voxel_size > 0 ? rounded(1e3 * row.voxel_size, 3) + " mm" : "";
}

const char* verdict_on(const GestureRow& row) {
  if (row.pass) return "ok";
  return row.known.empty() ? "FAIL" : "known";
}

/// Two lines, so that none is wider than it must be.
void print(const GestureRow& row) {
  std::printf("%-5s %-4s %s: %s%s%s\n      expected %s\n      seen     %s\n", verdict_on(row), row.gesture.c_str(),
              row.demand.c_str(), row.scene.c_str(), row.voxel_size > 0 ? ", voxels of " : "", size_of(row).c_str(),
              row.expected.c_str(), row.seen.c_str());
  if (!row.known.empty()) std::printf("      known    %s\n", row.known.c_str());
}

Json json_of(const GestureRow& row) {
  return {{"gesture", row.gesture}, {"name", row.name},         {"scene", row.scene}, {"voxel_size", row.voxel_size},
          {"demand", row.demand},   {"expected", row.expected}, {"seen", row.seen},   {"pass", row.pass},
          {"known", row.known}};
}

/// All of one demand on one scene, at each size of voxels.
struct Line {
  std::vector<const GestureRow*> rows;  // from coarse to fine
  bool pass = true;
};

std::vector<Line> lines_of(const std::vector<GestureRow>& rows, const std::string& gesture) {
  std::vector<Line> lines;
  for (const GestureRow& row : rows) {
    if (row.gesture != gesture) continue;
    const auto same = std::ranges::find_if(
        lines, [&](const Line& l) { return l.rows[0]->scene == row.scene && l.rows[0]->demand == row.demand; });
    Line& line = same != lines.end() ? *same : lines.emplace_back();
    line.rows.push_back(&row);
    line.pass = line.pass && row.pass;
  }
  return lines;
}

constexpr const char* kPreface = R"(<!-- SPDX-License-Identifier: Apache-2.0 -->
# Gestures

What a hand does with a tool, what physics demands of it, and what the library gives: scenes through a loop of one's own or
the whole chain of a simulated device. Three values stand for voxels of 0.2, 0.1 and 0.05 mm. Written by
`hapticut gestures --markdown docs/gestures.md`.
What is **bold** is not what is expected; why, stands in [the list](#not-met-yet) at the end, which the tests hold both ways:
what is on it fails, and nothing else does.

## Invariants

Beside its own demands every gesture is held to these:

1. Hand and motor never get back more than they gave, but for a thousandth of what was turned over. Nor does `entered`, a term
   of the energy ledger that should be nothing, take more, beyond what vanishes with the step (the change of force along each
   motion); nor does the coupling leave more than a hundredth unexplained. The same holds at the device, where a spring that
   is held between two ticks gives back `K dx^2/2` by itself.
2. Nothing is cut while the device gets no force.
3. No solid material, of voxels at least half full, is deeper in the head than where the foundation's pressure is that of
   crushing; or, where the tool is fed whatever the force, than the engaged layer (C34) half a voxel beside the axis.
4. What is asked of a device is within its peaks before the guard shortens it, spring and damper of the coupling together.
5. The motor's power is within its characteristic.
6. A second run gives the same bits, whatever was probed between the steps.
7. What is measured changes by less than a tolerance where voxels halve, the rate doubles, or grid and hand are turned.

Crushing is taken to be at 150 MPa in cortical bone, 5 in trabecular bone, 384 in enamel and 297 in dentin; a material without
a name counts as cortical bone.
)";

/// One text where all sizes of voxels have the same; else each in turn, and once what stands in brackets behind all.
std::string by_size(std::vector<std::string> texts) {
  if (std::ranges::adjacent_find(texts, std::ranges::not_equal_to()) == texts.end()) return texts[0];
  const std::string& first = texts[0];
  std::string tail = first.substr(std::min(first.find(" ("), first.size()));
  if (!std::ranges::all_of(texts, [&](const std::string& text) { return text.ends_with(tail); })) tail.clear();
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text.substr(0, text.size() - tail.size());
  return all + tail;
}

std::string column(const Line& line, const std::function<std::string(const GestureRow&)>& text) {
  std::vector<std::string> texts;
  for (const GestureRow* row : line.rows) texts.push_back(text(*row));
  return by_size(std::move(texts));
}

std::string seen_of(const GestureRow& row) { return row.pass ? row.seen : "**" + row.seen + "**"; }

/// A scene of the page: its demands as a table, but the invariants that hold, which are a sentence.
std::string scene_of(const std::vector<Line>& lines, const std::string& scene) {
  constexpr std::string_view kInvariant = "invariant ";
  std::string table, held;
  for (const Line& line : lines) {
    if (line.rows[0]->scene != scene) continue;
    if (line.pass && line.rows[0]->demand.starts_with(kInvariant))
      held += (held.empty() ? "" : ", ") + line.rows[0]->demand.substr(kInvariant.size());
    else
      table += "| " + line.rows[0]->demand + " | " + column(line, [](const GestureRow& row) { return row.expected; }) +
               " | " + column(line, seen_of) + " |\n";
  }
  if (table.empty()) return "\n" + scene + ": invariant " + held + " holds.\n";
  const std::string what = held.empty() ? scene : scene + "; invariants that hold: " + held;
  return "\n" + what + ":\n\n| demand | expected | seen |\n|---|---|---|\n" + table;
}

/// What a tool behind a coupling must keep to, at any rate and in any voxels.
struct Figure {
  std::string_view gesture, demand, words;  // gesture "": any
};
constexpr auto kFigures = std::to_array<Figure>({
    {"G42", "volume", "volume, 0.5 ... 16 kHz"},
    {"G42", "mean force", "mean force, 0.5 ... 16 kHz"},
    {"G42", "not in balance", "ticks not in balance, 0.5 ... 16 kHz"},
    {"G43", "tool's speed 50 ms later", "speed beyond the hand's 50 ms after a jerk"},
    {"G44", "hole", "hole of a twist drill over the drill"},
    {"G46", "invariant 7", "volume under a constant force, from one size of voxels to the next"},
    {"G51", "voxels in a tick", "voxels in a tick, a rigid hand 6 mm inside"},
    {"G45", "sinks", "depth of a standing head under 1 N"},
    {"G45", "hole that is left", "hole that it leaves"},
    {"", "invariant 1", "work gained, `entered` and unexplained, of all gestures"},
    {"G49", "torque at 2 ... 8 mm", "torque of a deep drill over C35, least"},
    {"G49", "torque at 2 ... 8 mm, most", "torque of a deep drill over C35, most"},
});

/// Of each figure, the row nearest to its bound or beyond it, at each size of voxels.
std::string figures_of(const std::vector<GestureRow>& rows) {
  std::string table;
  for (const Figure& figure : kFigures) {
    std::vector<const GestureRow*> worst;
    for (const GestureRow& row : rows) {
      if (!figure.gesture.empty() && row.gesture != figure.gesture) continue;
      if (row.demand != figure.demand) continue;
      const auto same = std::ranges::find(worst, row.voxel_size, &GestureRow::voxel_size);
      if (same == worst.end())
        worst.push_back(&row);
      else if (row.strain > (*same)->strain)
        *same = &row;
    }
    for (const GestureRow* row : worst) {
      const std::string scene = row->scene.substr(0, row->scene.find(','));
      table += "| " + (row == worst.front() ? std::string(figure.words) : "") + " | " + size_of(*row) + " | " + scene +
               " | " + row->expected.substr(0, row->expected.find(" (")) + " | " + seen_of(*row) + " |\n";
    }
  }
  if (table.empty()) return table;
  return "\n## Behind a coupling, at any rate and in any voxels\n\nOf all scenes the one that is nearest to its "
         "bound.\n"
         "\n| what | voxels | scene | must be | seen |\n|---|---|---|---|---|\n" +
         table;
}

std::string page_of(const std::vector<GestureRow>& rows) {
  std::string page = kPreface + figures_of(rows);
  for (const std::string& gesture : gesture_ids()) {
    const std::vector<Line> lines = lines_of(rows, gesture);
    if (lines.empty()) continue;
    page += "\n## " + gesture + ": " + lines.front().rows[0]->name + "\n";
    std::vector<std::string> scenes;
    for (const Line& line : lines)
      if (std::ranges::find(scenes, line.rows[0]->scene) == scenes.end()) scenes.push_back(line.rows[0]->scene);
    for (const std::string& scene : scenes) page += scene_of(lines, scene);
  }
  page += "\n## Not met yet\n\n| gesture | demand | why | seen when it was put on the list |\n|---|---|---|---|\n";
  for (const KnownGestureFailure& failure : known_gesture_failures())
    page += "| " + std::string(failure.gesture) + " | " + std::string(failure.demand) + " | " +
            std::string(failure.reason) + " | " + std::string(failure.seen) + " |\n";
  return page;
}

void run_all(const GestureSettings& s) {
  for (const std::string& path : {s.json, s.markdown}) require_writable(path);
  const auto start = std::chrono::steady_clock::now();
  std::vector<GestureRow> rows;
  {
    ProgressBar progress("gestures", gesture_ids().size());
    GestureOptions options;
    options.only = s.only;
    options.progress = [&](std::size_t done) { progress.advance_to(done); };
    rows = run_gestures(options);
  }
  std::size_t failed = 0, known = 0;
  Json cases = Json::array();
  for (const GestureRow& row : rows) {
    print(row);
    cases.push_back(json_of(row));
    failed += row.pass ? 0 : 1;
    known += row.known.empty() ? 0 : 1;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%zu demands, %zu not met, %zu of these known, %s s\n", rows.size(), failed, known,
              rounded(seconds, 3).c_str());
  write_json(s.json, {{"rows", cases},
                      {"failed", failed},
                      {"known", known},
                      {"seconds", seconds},
                      {"build", {{"version", build_info().version}, {"commit", build_info().commit}}}});
  if (!s.markdown.empty()) write_atomically(s.markdown, [&](std::ostream& stream) { stream << page_of(rows); });
  if (failed > 0)
    throw Error(std::to_string(failed) + " of " + std::to_string(rows.size()) + " demands on gestures are not met, " +
                std::to_string(known) + " of these known: this build is not what a hand needs.");
}

}  // namespace

Command gestures_command() {
  auto settings = std::make_shared<GestureSettings>();
  return {"gestures",
          "Run what a hand does with a tool, and say what physics demands of it and what is seen",
          {text("gestures.only", "--only", settings->only, "run only this one, as G7"),
           path("output.json", "--json", settings->json, "report for machines"),
           path("output.markdown", "--markdown", settings->markdown, "the same as a page of the documentation")},
          [settings] { run_all(*settings); }};
}

}  // namespace hapticut::cli
