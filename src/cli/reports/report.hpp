// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/commands/drill.hpp"
#include "cli/reports/json_file.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::cli {

/// A workpiece before it was cut.
struct WorkpieceSummary {
  std::string source;
  std::array<int, 3> dims = {0, 0, 0};  ///< voxels along the grid's axes, of the smallest box around what is solid
  double voxel_size = 0;                ///< [m]
  Pose X_WV;                            ///< pose of the grid: position of the centre of voxel (0, 0, 0)
  Box box;                              ///< [m] around what is solid, in W
  std::size_t memory_bytes = 0;
  std::vector<MaterialAmount> amounts;  ///< by material
};

[[nodiscard]] WorkpieceSummary summarize(const std::string& source, const Workpiece& workpiece);

/// A pose as `position_mm` and `rotation` (rows), and the box around something as `min_mm` and `max_mm`.
[[nodiscard]] Json to_json(const Pose& pose);
[[nodiscard]] Json to_json(const Box& box);

/// "1 x 2 x 3".
[[nodiscard]] std::string dims_text(const std::array<int, 3>& dims);

/// "0 0 0 to 1 2 3 mm".
[[nodiscard]] std::string box_text(const Box& box);

/// `dims`, `voxel_size_mm`, `pose`, `box`, `memory_bytes`, and `voxels` and `volume_mm3` by material.
[[nodiscard]] Json to_json(const WorkpieceSummary& summary, const MaterialTable& materials);

/// What a user should know before trusting the numbers, as sentences; empty when there is nothing to say.
[[nodiscard]] std::vector<std::string> warnings_of(const DrillResult& result, const Simulation& simulation);

struct DrillReport {
  WorkpieceSummary workpiece;
  double rate;  ///< [Hz]
  std::vector<std::string> warnings;
};

[[nodiscard]] Json to_json(const DrillReport& report, const DrillResult& result, const Simulation& simulation);
[[nodiscard]] std::string to_table(const DrillReport& report, const DrillResult& result, const Simulation& simulation);

}  // namespace hapticut::cli
