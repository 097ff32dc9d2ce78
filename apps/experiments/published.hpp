// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// Published measurements of cutting bone and teeth, and what the presets predict for them.
namespace hapticut::experiments {

/// Gives the material of a preset under a cutter, with the constants of one case: typical, new, worn, low, high.
using PresetOf = std::function<Material(const char* preset, CutterKind cutter)>;

/// A measured number.
struct PublishedRow {
  std::string conditions;
  std::string quantity;  ///< with its unit: "thrust [N]"
  double measured;       ///< in that unit
  double scatter;        ///< as the source gives it, in that unit; 0: not given
  std::string source;
  bool fitted;         ///< a fit of the constants used it
  std::string beyond;  ///< why no constants can meet it; empty: some can
  std::function<double(const PresetOf&)> predict;
  /// The one number of the presets that enters; empty: those that resist a cut; kLawAlone: none
  std::string number = {};

  static constexpr const char* kLawAlone = "none";
  /// Whether it can tell how well the presets predict.
  [[nodiscard]] bool counts() const { return !fitted && beyond.empty() && number != kLawAlone; }
};

/// What the presets give for a row, in its unit.
struct Prediction {
  double typical;
  double fresh, worn;  ///< with a new and with a worn cutter
  double low, high;    ///< with the ends of all ranges

  [[nodiscard]] bool brackets(double value, double scatter) const {
    return std::min(fresh, worn) <= value + scatter && value - scatter <= std::max(fresh, worn);
  }
  [[nodiscard]] bool allows(double value, double scatter) const {
    return std::min(low, high) <= value + scatter && value - scatter <= std::max(low, high);
  }
};

[[nodiscard]] const std::vector<PublishedRow>& published_rows();
[[nodiscard]] Prediction prediction_of(const PublishedRow& row);

/// [1] Predicted over measured or its inverse, whichever is at least 1.
[[nodiscard]] double factor_of(const PublishedRow& row);

/// The rows that count.
struct PublishedSummary {
  int rows = 0;
  double median = 0;   ///< [1] of their factors
  int within_two = 0;  ///< rows within a factor of 2
  int bracketed = 0;   ///< rows that, with their scatter, lie between a new and a worn cutter
  int allowed = 0;     ///< rows that, with their scatter, lie between the ends of all ranges
};
[[nodiscard]] PublishedSummary summary_of_published();

/// Published measurements and the predictions, then the rates of all pairs, in Markdown: `hapticut validate
/// --measurements`, docs/measurements.md.
[[nodiscard]] std::string measurements_report();

}  // namespace hapticut::experiments
