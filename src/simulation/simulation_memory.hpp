// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// What a simulation keeps from step to step, as bytes: pose, motor, output, energies, counters and reserved blocks,
/// but not the workpiece, tool and configuration. With these, a copy continues as the simulation would: its next steps
/// have the same bits.
///
/// Undo marks and observers are not part of it. The bytes are for the same build of the library only.
struct SimulationMemory {
  /// @throws Error when the simulation has marks for undo or redo
  [[nodiscard]] static std::string bytes_of(const Simulation& simulation);

  /// The simulation that had this memory.
  /// @param workpiece, tool, config  as that simulation has them
  /// @throws Error when the bytes are of another build
  [[nodiscard]] static Simulation restored(Workpiece workpiece, Tool tool, SimulationConfig config,
                                           const std::string& bytes);

  template <class Archive>
  static void visit(Archive& archive, Simulation::State& state);
};

/// A simulation that continues as the given one would.
/// @throws Error when the simulation has marks for undo or redo
[[nodiscard]] Simulation copy_of(const Simulation& simulation);

}  // namespace hapticut
