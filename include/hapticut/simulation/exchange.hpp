// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material.hpp"
#include "hapticut/workpiece/removal.hpp"

/// @file
/// What a simulation is given between two steps of a loop that goes on: made beforehand, elsewhere, with all the memory
/// that it needs. The exchange itself swaps pointers; what was in place before is in the prepared object afterwards, to
/// be freed where that does no harm.
namespace hapticut {

/// A tool for a simulation of which only the size of its voxels and its configuration are known: another thread may be
/// stepping it.
class PreparedTool {
 public:
  /// @param voxel_size  [m] of the workpiece
  /// @param config      that the simulation was made with
  /// @throws Error as the constructor of Simulation, where the head does not suit the voxels or the law
  PreparedTool(Tool tool, double voxel_size, const SimulationConfig& config);
  PreparedTool(PreparedTool&&) noexcept;
  PreparedTool& operator=(PreparedTool&&) noexcept;
  ~PreparedTool();

  [[nodiscard]] bool empty() const noexcept { return state_ == nullptr; }  ///< it was moved away
  [[nodiscard]] const Tool& tool() const noexcept;
  [[nodiscard]] double voxel_size() const noexcept;     ///< [m] that it was made for
  [[nodiscard]] WorstCase worst_case() const noexcept;  ///< what a step with it may have to do at most

 private:
  friend class Simulation;
  struct State;
  std::unique_ptr<State> state_;
};

/// Constants of the materials of a workpiece that another thread may be cutting.
class PreparedMaterials {
 public:
  /// @param config  that the simulation was made with
  /// @throws Error when a stiffness is out of range
  PreparedMaterials(MaterialTable materials, const SimulationConfig& config);
  PreparedMaterials(PreparedMaterials&&) noexcept;
  PreparedMaterials& operator=(PreparedMaterials&&) noexcept;
  ~PreparedMaterials();

  [[nodiscard]] bool empty() const noexcept { return state_ == nullptr; }  ///< it was moved away
  [[nodiscard]] const MaterialTable& materials() const noexcept;

 private:
  friend class Simulation;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
