// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/calibration.hpp"

namespace hapticut {
namespace {

constexpr double kDiffers = 1.5, kContradicts = 2;  // [1] Calibration::worst_factor
constexpr double kFarOutside = 3;                   // [1] number over the end of its range, or the inverse

std::string brief(double value) { return detail::with_digits(value, 3); }

std::string in_um(double length) { return brief(length / units::um) + " um"; }

/// A number in the unit of its range, lengths in um.
std::string text_of(double value, const PresetConstant& range) {
  if (range.unit == "m") return in_um(value);
  return range.unit == "1" ? brief(value) : brief(value).append(" ").append(range.unit);
}

/// "6 um ... 45 um", "0.3 ... 0.6"
std::string text_of(const PresetConstant& range) {
  const std::string low = text_of(range.low, range);
  return range.low < range.high ? low + " ... " + text_of(range.high, range) : low;
}

/// [1] 1 within the range, 3 at three times its upper end or at a third of its lower end.
double excess(double value, const PresetConstant& range) {
  return std::max({1.0, value / range.high, range.low / value});
}

/// How much less or more than the range some material costs.
std::string other_materials(bool less) {
  double share = 1;
  for (const PresetConstant& row : preset_constants())
    if (row.number == "share") share = less ? std::min(share, row.low) : std::max(share, row.high);
  return (less ? "Softer materials have down to " : "Harder materials have up to ") + brief(share) +
         " times as much as dentin and cortical bone.";
}

/// A sentence about a fitted number that is out of the range of the presets; empty: it is within.
/// @param check  what may be wrong
std::string remark_on(const Calibration& c, std::string_view number, double value, const std::string& check) {
  const PresetConstant* const range = presets_beside(c, number);
  if (range == nullptr) return "";
  const double out = excess(value, *range);
  const bool is_far = out > kFarOutside, has_range = range->low < range->high;
  if (!is_far && (!has_range || out == 1)) return "";
  return (is_far ? "Warning: the " : "The ") + std::string(number) + " of " + text_of(value, *range) + " is " +
         (is_far ? "far " : "") + "outside the presets' " + text_of(*range) + " of " + std::string(range->of) +
         ": check " + check + ".";
}

const char* const kOfFeed = "that the feed is per second, not per minute, and the speed in its unit";
const char* const kOfEnergy =
    "that the feed is per second, not per minute, that the radius is not the diameter, and the units of speed and "
    "force";
const char* const kOfRatio = "the units of thrust and torque, and that the radius is not the diameter";

/// Sentences about the fitted numbers beside the ranges of the presets, each in a line.
std::string remarks_on(const Calibration& c) {
  std::string remarks;
  const auto add = [&](const std::string& remark, const std::string& more) {
    if (!remark.empty()) remarks += remark + (more.empty() ? "" : " ") + more + "\n";
  };
  if (const double u = c.specific_cutting_energy; c.chip_identified)
    add(remark_on(c, "specific_cutting_energy", u, kOfEnergy),
        other_materials(u < presets_beside(c, "specific_cutting_energy")->low));
  if (c.ratio_identified)
    add(remark_on(c, "cutting_ratio", c.cutting_ratio, kOfRatio),
        "Source of the range: " + std::string(presets_beside(c, "cutting_ratio")->source) + ".");
  if (!c.edge_identified) return remarks;
  if (c.size_length > 0) add(remark_on(c, "size_length", c.size_length, kOfFeed), "Chips much thinner do not tell it.");
  if (!(c.edge_length > 0)) return remarks;
  const PresetConstant& edges = *presets_beside(c, "edge_length");
  if (excess(c.edge_length, edges) <= kFarOutside) {
    add(remark_on(c, "edge_length", c.edge_length, kOfFeed), "");
    return remarks;
  }
  const bool is_short = c.edge_length < edges.low;
  return remarks + "Warning: an edge length of " + in_um(c.edge_length) +
         " is right for these tests, but it is not the edge of a tool, which has " + text_of(edges) + ": check " +
         kOfFeed + (is_short ? "; if the chips are so thin, they have a size effect, so fit size_length.\n" : ".\n");
}

/// What may be wrong with tests that one set of constants does not meet.
std::string remark_on_scatter(double worst_factor) {
  if (worst_factor > kContradicts)
    return "No constants of this kind fit these tests: one differs by a factor of " + brief(worst_factor) +
           ". They contradict each other, or are not of one material and tool; fit those of each laboratory and each "
           "bone alone.\n";
  if (worst_factor < kDiffers) return "";
  return "A measured number and the fit differ by a factor of up to " + brief(worst_factor) + ". Up to " +
         brief(kContradicts) +
         " is usual between laboratories; for constants of one bone and tool, fit the tests of one laboratory alone.\n";
}

}  // namespace

const PresetConstant* presets_beside(const Calibration& c, std::string_view number) noexcept {
  if (const PresetConstant* const own = find_constant(name_or_null(c.cutter), number)) return own;
  return number == "edge_length" ? find_constant(name_or_null(CutterKind::twist_drill), number) : nullptr;
}

std::string advice_on(const Calibration& c) {
  std::string advice =
      "These constants belong together: set all of them in the material, including zeros, and set cutter and lips of "
      "the tests in the tool.\n";
  if (c.better_term)
    advice += std::string(name_or_null(*c.better_term)) + " describes these tests better than " + name_or_null(c.term) +
              ", with less than half of its residual: fit that.\n";
  advice += remark_on_scatter(c.worst_factor) + remarks_on(c);
  if (c.size_assumed)
    advice += "With feeds per lip of " + in_um(c.thinnest_chip) +
              " the chips are those of blades, not of a drill: these tests fix only u sqrt(h_s) = " +
              brief(c.specific_cutting_energy * std::sqrt(c.size_length)) +
              " J/m^2.5, so the size length of the presets, " + in_um(c.size_length) +
              ", was assumed, and no edge. Much thicker chips would tell both.\n";
  if (!c.edge_identified && !c.better_term && !c.size_assumed)
    advice +=
        "To separate edge and chip, add tests at other feeds per revolution, or repeat these tests if they scatter.\n";
  else if (!c.checked)
    advice +=
        "The constants fit exactly, which proves nothing: to check them, add a test at another feed per revolution.\n";
  if (!c.edge_identified && !c.edge_assumed && !c.size_assumed)
    advice += "No edge was assumed: at feeds per lip below " + in_um(c.thinnest_chip) + " the force may be too low.\n";
  if (!c.ratio_identified) advice += "To identify the cutting ratio, add tests with thrust and torque.\n";
  if (!c.chip_identified)
    advice +=
        "The edge causes nearly all of thrust and torque; to identify the chip, add tests at a larger feed per "
        "revolution.\n";
  return advice;
}

}  // namespace hapticut
