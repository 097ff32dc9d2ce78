// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>

#include "hapticut/workpiece/builders.hpp"
#include "settings/workpiece_settings.hpp"

namespace hapticut::settings {

/// Reads a volume of labels or grey values and builds a workpiece from it, as `labels`, `grey` or `grade_...` say.
/// @throws Error when the file cannot be read, or not exactly one of these is set
[[nodiscard]] Workpiece make_workpiece_from_volume(const WorkpieceSettings& settings);

/// What a volume contains before it becomes a workpiece.
struct VolumeSummary {
  std::array<int, 3> dims;
  Vec3 spacing;                                                  ///< [m]
  Pose X_WG;                                                     ///< of the first sample
  Box box;                                                       ///< [m] around all samples, in W
  double lowest, highest;                                        ///< grey values, without what is no number
  std::size_t not_a_number;                                      ///< how many samples are none
  std::size_t padding;                                           ///< samples of the file outside the field of view
  std::size_t memory_bytes;                                      ///< of the samples in memory
  std::optional<std::size_t> voxels_at_or_above = std::nullopt;  ///< a threshold
  std::map<int, std::size_t> voxels_by_label = {};               ///< empty unless all values are a few whole numbers
};

/// @throws Error when the file cannot be read
[[nodiscard]] VolumeSummary summarize_volume(const WorkpieceSettings& settings, std::optional<double> threshold);

}  // namespace hapticut::settings
