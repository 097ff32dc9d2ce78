// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gestures/report.hpp"

namespace hapticut::gestures {

/// A motion of a hand: a function that runs its scenes and reports the results.
struct Gesture {
  std::string id, name;
  void (*run)(Report& report);
  bool has_voxels = true;  ///< false: runs once, without voxels
};

// The gestures by subject. `all_gestures` joins these lists.
[[nodiscard]] std::vector<Gesture> hole_gestures();          ///< a tool in a hole
[[nodiscard]] std::vector<Gesture> press_gestures();         ///< a standing head
[[nodiscard]] std::vector<Gesture> cutting_gestures();       ///< a cutting head
[[nodiscard]] std::vector<Gesture> motor_gestures();         ///< the spindle
[[nodiscard]] std::vector<Gesture> device_gestures();        ///< guard and coupling of each device
[[nodiscard]] std::vector<Gesture> loop_gestures();          ///< the loop: clutch, commands, faults
[[nodiscard]] std::vector<Gesture> further_gestures();       ///< from G26 on, without a device
[[nodiscard]] std::vector<Gesture> further_loop_gestures();  ///< from G28 on, in the loop of a device
[[nodiscard]] std::vector<Gesture> coupled_gestures();       ///< from G42 on, behind a coupling

/// All gestures, by number.
[[nodiscard]] std::vector<Gesture> all_gestures();

/// Runs a gesture with each voxel size [m], from coarse to fine, and then with the coarsest size and probes between the
/// steps, at twice the rate, and in a rotated scene.
[[nodiscard]] std::vector<Row> rows_of(const Gesture& gesture, std::vector<double> voxel_sizes);

}  // namespace hapticut::gestures
