// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hapticut/simulation/simulation.hpp"

/// @file
/// Named fixed scenes, shared by tests and benchmarks, with equal numbers everywhere.
namespace hapticut::test {

/// A workpiece, a tool and a motion.
struct Scene {
  std::string name;
  std::string description;                   ///< one sentence
  std::function<Simulation()> make;          ///< builds a new simulation
  std::function<StepInput(int tick)> input;  ///< input of step `tick` = 0, 1, 2 ...; endless
};

/// All scenes, in a fixed order.
[[nodiscard]] const std::vector<Scene>& scenes();

/// @throws Error when no scene has that name; the message lists the names
[[nodiscard]] const Scene& find_scene(const std::string& name);

}  // namespace hapticut::test
