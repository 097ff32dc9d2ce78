// SPDX-License-Identifier: Apache-2.0
#include "gestures/page.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string_view>
#include <utility>

#include "gestures/gesture_list.hpp"
#include "gestures/known_failures.hpp"

namespace hapticut::gestures {
namespace {

constexpr const char* kPreface = R"(<!-- SPDX-License-Identifier: Apache-2.0 -->
# Gestures

A gesture is what a hand does with a tool: it drills, stops, lifts off, leans, stalls, breaks through, opens the clutch. The tests
play each one as scenes, in a loop of their own or through the whole chain of a simulated device, with voxels of 0.2, 0.1 and
0.05 mm, and compare what is seen with what physics demands. What is **bold** on this page does not meet its demand;
[the list](#not-met-yet) at the end says why. The tests hold that list both ways: what is on it fails, and nothing else does.

They are in `tests/gestures`, and take half a minute:
```sh
ninja -C build/release test_gestures && cd build/release/tests/gestures
./test_gestures                                                             # all
HAPTICUT_PRINT_GESTURES=1 ./test_gestures --gtest_filter='*/G7'             # one, and what is seen of each demand
HAPTICUT_WRITE_GESTURES=1 ./test_gestures --gtest_filter='GesturesPage.*'   # writes this page
```

## Invariants

Every gesture has demands of its own. Beside them it is held to these:

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

constexpr std::string_view kInvariant = "invariant ", kNumbers = "## Numbers";
constexpr auto kInvariants =
    std::to_array({"energy", "nothing cut unfelt", "solid material in the head", "peaks of the device",
                   "power of the motor", "the same bits", "the same in other voxels, at another rate, turned"});

/// What users ask first: how far a gesture is from its bound, at any rate, in any voxels.
struct Figure {
  std::string_view gesture, demand, words;  // gesture "": any
};
constexpr auto kFigures = std::to_array<Figure>({
    {"G42", "volume", "volume cut, 0.5 ... 16 kHz"},
    {"G42", "mean force", "mean force, 0.5 ... 16 kHz"},
    {"G42", "not in balance", "ticks not in balance, 0.5 ... 16 kHz"},
    {"G46", "invariant 7", "volume under a constant force, from one size of voxels, rate or grid to another"},
    {"G43", "tool's speed 50 ms later", "speed beyond the hand's 50 ms after a jerk"},
    {"G51", "voxels in a tick", "voxels in a tick, a rigid hand 6 mm inside"},
    {"G44", "hole", "hole of a twist drill over the drill"},
    {"G49", "torque at 2 ... 8 mm", "torque of a deep drill over C35, least"},
    {"G49", "torque at 2 ... 8 mm, most", "torque of a deep drill over C35, most"},
    {"G45", "sinks", "depth of a sharp head that stands under 1 N"},
    {"G45", "hole that is left", "hole that it leaves"},
    {"G10", "converges", "work unexplained in a corner"},
    {"", "invariant 1", "work gained, `entered` and unexplained, of all gestures"},
});

/// One text where all sizes of voxels have the same; else each in turn.
std::string by_size(const std::vector<std::string>& texts) {
  if (std::ranges::adjacent_find(texts, std::ranges::not_equal_to()) == texts.end()) return texts[0];
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

/// Of each size of voxels the row that is not met, or else nearest to its bound.
std::vector<const Row*> worst_of(const std::vector<Row>& rows, const Figure& figure) {
  std::vector<const Row*> worst;
  for (const Row& row : rows) {
    if (row.demand != figure.demand || (!figure.gesture.empty() && row.gesture != figure.gesture)) continue;
    const auto same = std::ranges::find(worst, row.voxel_size, &Row::voxel_size);
    if (same == worst.end())
      worst.push_back(&row);
    else if (std::pair(!row.is_met, row.strain) > std::pair(!(*same)->is_met, (*same)->strain))
      *same = &row;
  }
  return worst;
}

std::string figures_of(const std::vector<Row>& rows) {
  std::string table = "| what | gesture | scene | must be | seen |\n|---|---|---|---|---|\n";
  for (const Figure& figure : kFigures) {
    const std::vector<const Row*> worst = worst_of(rows, figure);
    const auto column = [&](const std::function<std::string(const Row&)>& text) {
      std::vector<std::string> texts;
      for (const Row* row : worst) texts.push_back(text(*row));
      return " | " + by_size(texts);
    };
    table += "| " + std::string(figure.words) + column([](const Row& row) { return row.gesture; }) +
             column([](const Row& row) { return row.scene.substr(0, row.scene.find(',')); }) +
             column([](const Row& row) { return row.expected.substr(0, row.expected.find(" (")); }) +
             column([](const Row& row) { return row.is_met ? row.seen : "**" + row.seen + "**"; }) + " |\n";
  }
  return table;
}

/// How many rows there are of each kind of demand, and how many are not met.
std::string counts_of(const std::vector<Row>& rows) {
  std::string table = "| demands | number | not met |\n|---|---|---|\n";
  const auto line = [&](const std::string& words, const std::function<bool(const Row&)>& is_one) {
    const auto is_missed = [&](const Row& row) { return is_one(row) && !row.is_met; };
    table += "| " + words + " | " + std::to_string(std::ranges::count_if(rows, is_one)) + " | " +
             std::to_string(std::ranges::count_if(rows, is_missed)) + " |\n";
  };
  line("of the gestures themselves", [](const Row& row) { return !row.demand.starts_with(kInvariant); });
  for (std::size_t n = 1; n <= kInvariants.size(); ++n) {
    const std::string invariant = std::string(kInvariant) + std::to_string(n);
    line(invariant + ": " + kInvariants[n - 1], [&](const Row& row) { return row.demand == invariant; });
  }
  line("all", [](const Row&) { return true; });
  return table;
}

bool is_known_to_fail(const std::string& gesture, const std::string& demand) {
  return std::ranges::any_of(known_failures(), [&](const KnownFailure& failure) {
    return failure.gesture == gesture && failure.demand == demand;
  });
}

std::string gestures_of(const std::vector<Row>& rows) {
  std::string table = "| gesture | what the hand does | demands beside the invariants |\n|---|---|---|\n";
  for (const Gesture& gesture : all_gestures()) {
    std::vector<std::string> demands;
    for (const Row& row : rows)
      if (row.gesture == gesture.id && !row.demand.starts_with(kInvariant) &&
          std::ranges::find(demands, row.demand) == demands.end())
        demands.push_back(row.demand);
    std::string all;
    for (const std::string& demand : demands) {
      const std::string mark = is_known_to_fail(gesture.id, demand) ? "**" : "";
      all += (all.empty() ? "" : "; ") + mark + demand + mark;
    }
    table += "| " + gesture.id + " | " + gesture.name + " | " + all + " |\n";
  }
  return table;
}

std::string list_of_known_failures() {
  std::string table = "| gesture | demand | why | seen when it was put on the list |\n|---|---|---|---|\n";
  for (const KnownFailure& failure : known_failures()) {
    for (const std::string_view cell : {failure.gesture, failure.demand, failure.reason, failure.seen})
      table += "| " + std::string(cell) + " ";
    table += "|\n";
  }
  return table;
}

}  // namespace

std::string page_of(const std::vector<Row>& rows) {
  return std::string(kPreface) + "\n" + std::string(kNumbers) +
         "\n\nOf all scenes the one that is nearest to its bound. Several values stand for voxels of 0.2, 0.1 and 0.05 "
         "mm.\n\n" +
         figures_of(rows) + "\nA demand is counted in each scene and at each size of voxels.\n\n" + counts_of(rows) +
         "\n## The gestures\n\n" + gestures_of(rows) + "\n## Not met yet\n\n" + list_of_known_failures();
}

std::vector<std::string> lasting_lines(const std::string& page) {
  std::vector<std::string> lines;
  std::istringstream in(page);
  bool is_seen = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) is_seen = line == kNumbers;
    if (is_seen && line.starts_with("| ")) line.resize(line.find('|', 2));
    lines.push_back(line);
  }
  return lines;
}

}  // namespace hapticut::gestures
