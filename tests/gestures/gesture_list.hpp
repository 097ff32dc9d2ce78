// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gestures/report.hpp"

namespace hapticut::gestures {

/// What a hand does, as scenes that say what they see.
struct Gesture {
  std::string id, name;
  void (*run)(Report& report);
  bool has_voxels = true;  ///< otherwise it runs once
};

// By subject; `all_gestures` joins them.
[[nodiscard]] std::vector<Gesture> hole_gestures();          ///< in a hole of one's own, or of another
[[nodiscard]] std::vector<Gesture> press_gestures();         ///< a head that stands
[[nodiscard]] std::vector<Gesture> cutting_gestures();       ///< a head that cuts
[[nodiscard]] std::vector<Gesture> motor_gestures();         ///< the spindle, and what is felt of it
[[nodiscard]] std::vector<Gesture> device_gestures();        ///< the guard and the coupling of each device
[[nodiscard]] std::vector<Gesture> loop_gestures();          ///< the loop, its clutch, its commands and its faults
[[nodiscard]] std::vector<Gesture> further_gestures();       ///< G26 and on
[[nodiscard]] std::vector<Gesture> further_loop_gestures();  ///< the same, in the loop of a device
[[nodiscard]] std::vector<Gesture> coupled_gestures();       ///< G42 and on: behind a coupling, whatever rate and head

/// All of them, by their number.
[[nodiscard]] std::vector<Gesture> all_gestures();

/// What it gives at each size of voxels [m], from coarse to fine; then at the coarsest with probes between the steps,
/// at twice the rate, and turned. The same rows every time.
[[nodiscard]] std::vector<Row> rows_of(const Gesture& gesture, std::vector<double> voxel_sizes);

}  // namespace hapticut::gestures
