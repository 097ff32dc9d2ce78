// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/workpiece/builders.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::settings {

/// Reads a volume of labels or grey values and builds a workpiece from it by `labels`, `grey` or `grade_...`.
/// @throws Error when the file cannot be read, or unless exactly one of the three is set
[[nodiscard]] Workpiece make_workpiece_from_volume(const WorkpieceSettings& settings);

/// Content of a volume before it becomes a workpiece.
struct VolumeSummary {
  std::array<int, 3> dims;
  Vec3 spacing;                                                  ///< [m]
  Pose X_WG;                                                     ///< pose of the first sample
  Box box;                                                       ///< [m] around all samples, in W
  double lowest, highest;                                        ///< grey values, ignoring NaN
  std::size_t not_a_number;                                      ///< number of samples that are NaN
  std::size_t padding;                                           ///< samples of the file outside the field of view
  std::vector<std::string> remarks;                              ///< remarks of the reader
  std::size_t memory_bytes;                                      ///< memory of the samples
  std::optional<std::size_t> voxels_at_or_above = std::nullopt;  ///< number of samples at or above the threshold
  std::map<int, std::size_t> voxels_by_label = {};               ///< empty unless the values are a few whole numbers
};

/// @throws Error when the file cannot be read
[[nodiscard]] VolumeSummary summarize_volume(const WorkpieceSettings& settings, std::optional<double> threshold);

}  // namespace hapticut::settings
