// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hapticut/io/recording/recorder.hpp"
#include "simulation.hpp"
#include "steps.hpp"

namespace hapticut::python {

/// A recorder and its simulation.
struct PythonRecorder {
  std::shared_ptr<PythonSimulation> simulation;
  py::object driven_by;  // kept alive
  std::unique_ptr<Recorder> recorder;

  [[nodiscard]] Stepper stepper(const DeviceTick* device = nullptr) const {
    return [this, device](const StepInput& input) -> const StepResult& { return recorder->step(input, device); };
  }
  void close() const {
    simulation->occupancy.require_writable("The simulation");
    const ReleasedWriting released(simulation->occupancy);
    recorder->close();
  }
};

}  // namespace hapticut::python
