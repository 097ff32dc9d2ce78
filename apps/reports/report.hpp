// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hapticut/core/sentence.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "reports/beside_report.hpp"
#include "reports/drill.hpp"
#include "reports/json_file.hpp"

namespace hapticut::apps {

/// A workpiece before cutting.
struct WorkpieceSummary {
  std::string source;
  std::array<int, 3> dims = {0, 0, 0};  ///< [voxels] size of the bounding box of the solid, along the grid's axes
  double voxel_size = 0;                ///< [m]
  Vec3 size = Vec3::Zero();             ///< [m] size of the bounding box of the solid, along the grid's axes
  Pose X_WV;                            ///< pose of the grid: position of the centre of voxel (0, 0, 0)
  Box box;                              ///< [m] bounding box of the solid, in W
  std::size_t memory_bytes = 0;
  std::vector<MaterialAmount> amounts;  ///< amounts by material
};

/// Up to this number of materials, a report also lists those that are not concerned.
inline constexpr int kFewMaterials = 16;

[[nodiscard]] WorkpieceSummary summarize(const std::string& source, const Workpiece& workpiece);

/// A position in mm; a pose as `position_mm` and `rotation` (rows); a box as `min_mm` and `max_mm`.
[[nodiscard]] Json in_mm(const Vec3& position);
[[nodiscard]] Json to_json(const Pose& pose);
[[nodiscard]] Json to_json(const Box& box);

/// "1 x 2 x 3".
[[nodiscard]] std::string dims_text(const std::array<int, 3>& dims);

/// "1 x 2 x 3 mm".
[[nodiscard]] std::string size_text(const Vec3& size);

/// "1 2 3", in mm.
[[nodiscard]] std::string position_text(const Vec3& position);

/// "0 0 0 to 1 2 3 mm".
[[nodiscard]] std::string box_text(const Box& box);

/// `size_mm`, `dims`, `voxel_size_mm`, `pose`, `box`, `memory_bytes`, and `voxels`, `volume_mm3` and `center_mm` by
/// material.
[[nodiscard]] Json to_json(const WorkpieceSummary& summary, const MaterialTable& materials);

/// The warning of a run with RemovalLaw::none.
[[nodiscard]] inline Sentence removal_is_off() {
  return "removal is off (" + "simulation.removal"_name + " is none), so nothing was removed.";
}

/// [1] The share of steps above their period from which on a report warns.
inline constexpr double kOftenSlow = 0.01;

/// Warnings about the numbers, as sentences; may be empty.
[[nodiscard]] std::vector<std::string> warnings_of(const DrillResult& result, const Simulation& simulation);

struct DrillReport {
  WorkpieceSummary workpiece;
  double rate;  ///< [Hz]
  std::vector<std::string> warnings;
  BesideReport beside = {};
};

[[nodiscard]] Json to_json(const DrillReport& report, const DrillResult& result, const Simulation& simulation);
[[nodiscard]] std::string to_table(const DrillReport& report, const DrillResult& result, const Simulation& simulation);

}  // namespace hapticut::apps
