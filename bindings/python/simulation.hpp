// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hapticut/simulation/simulation.hpp"
#include "workpiece.hpp"

namespace hapticut::python {

/// A voxel that became empty in a run.
struct RemovedInRun {
  std::int64_t step;            ///< index of the step in the run
  std::int32_t index[3];        ///< index in the workpiece's grid
  std::uint8_t material;        ///< material id
  std::uint8_t unused[3] = {};  ///< so that equal rows have equal bytes
};

/// A simulation owned by Python.
class PythonSimulation : public std::enable_shared_from_this<PythonSimulation> {
 public:
  explicit PythonSimulation(Simulation given) : simulation(std::move(given)) {}

  Simulation simulation;
  Occupancy occupancy;
  std::vector<RemovedInRun> removed;  ///< voxels of the last run
  std::weak_ptr<void>
      recorder;  ///< recorder that observes the simulation; code that makes steps without the lock keeps it alive

  std::vector<std::shared_ptr<StepObserver>> observers;  ///< observers made in Python; destroyed first

  /// Removes the observers that Python has deleted. They stay until then, because another thread may make steps.
  void remove_deleted_observers() {
    std::erase_if(observers, [](const auto& observer) { return observer.use_count() == 1; });
  }

  /// @throws Error while another thread uses it
  [[nodiscard]] const Simulation& read() const {
    occupancy.require_readable("The simulation");
    return simulation;
  }
  /// @throws Error while another thread uses or reads it
  [[nodiscard]] Simulation& write() {
    occupancy.require_writable("The simulation");
    return simulation;
  }

  void remember(std::span<const RemovedVoxel> voxels, std::size_t step) {
    for (const RemovedVoxel& voxel : voxels)
      removed.push_back({std::int64_t(step), {voxel.index[0], voxel.index[1], voxel.index[2]}, voxel.material});
  }
};

/// A result of a step that stays valid after the next step: it owns its list of voxels.
struct PythonStepResult {
  StepResult result;
  std::vector<RemovedVoxel> voxels;

  explicit PythonStepResult(const StepResult& given)
      : result(given), voxels(given.removed_voxels.begin(), given.removed_voxels.end()) {
    result.removed_voxels = voxels;
  }
  PythonStepResult(PythonStepResult&&) = default;  // moving a vector does not move its elements
};

}  // namespace hapticut::python
