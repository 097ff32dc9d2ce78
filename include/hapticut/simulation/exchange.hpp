// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hapticut/contact/removal.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/worst_case.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material.hpp"

/// Objects that replace parts of a simulation between two steps of a running loop. They are made beforehand, in another
/// thread, with all the memory that they need. The exchange only swaps pointers. Afterwards the prepared object has
/// the old part, which can be freed outside the loop.
namespace hapticut {

/// A tool that is prepared for a simulation. Only the voxel size and the configuration of that simulation are needed,
/// so another thread may be stepping it.
class PreparedTool {
 public:
  /// @param voxel_size  [m] of the workpiece
  /// @param config      of the simulation
  /// @throws Error when the head does not suit the voxels or the law, as the constructor of Simulation
  PreparedTool(Tool tool, double voxel_size, const SimulationConfig& config);
  PreparedTool(PreparedTool&&) noexcept;
  PreparedTool& operator=(PreparedTool&&) noexcept;
  ~PreparedTool();

  [[nodiscard]] bool empty() const noexcept { return state_ == nullptr; }  ///< it was moved from
  [[nodiscard]] const Tool& tool() const noexcept;
  [[nodiscard]] double voxel_size() const noexcept;     ///< [m] it was made for
  [[nodiscard]] WorstCase worst_case() const noexcept;  ///< upper bound on the work of a step with it

 private:
  friend class Simulation;
  struct State;
  std::unique_ptr<State> state_;
};

/// Constants of materials that are prepared for a workpiece, which another thread may be cutting.
class PreparedMaterials {
 public:
  /// @param config  of the simulation
  /// @throws Error when a stiffness is out of range
  PreparedMaterials(MaterialTable materials, const SimulationConfig& config);
  PreparedMaterials(PreparedMaterials&&) noexcept;
  PreparedMaterials& operator=(PreparedMaterials&&) noexcept;
  ~PreparedMaterials();

  [[nodiscard]] bool empty() const noexcept { return state_ == nullptr; }  ///< it was moved from
  [[nodiscard]] const MaterialTable& materials() const noexcept;

 private:
  friend class Simulation;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
