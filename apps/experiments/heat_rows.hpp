// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// @file
/// Published temperatures of drilling and grinding, and what the heat field predicts for them.
namespace hapticut::experiments {

/// A measured rise of temperature.
struct HeatRow {
  std::string conditions;
  double measured;   ///< [K]
  double predicted;  ///< [K]
  std::string source;

  /// [1] Predicted over measured, or its inverse: whichever is at least 1.
  [[nodiscard]] double factor() const {
    const double ratio = predicted / measured;
    return ratio > 1 ? ratio : 1 / ratio;
  }
};

/// Simulates all rows.
[[nodiscard]] std::vector<HeatRow> heat_rows();

/// The rows, in Markdown.
[[nodiscard]] std::string heat_report();

}  // namespace hapticut::experiments
