// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hapticut/core/abi.hpp"

/// @file
/// What a hand does with a tool, as scenes: it plunges, tilts in its own hole, stalls, lifts off, breaks through, opens
/// the clutch. Each runs through the library as a program would use it, and says what physics demands beside what was
/// seen. docs/gestures.md is the table of all of them.
namespace hapticut {

/// One demand on one scene of a gesture.
struct GestureRow {
  std::string gesture;    ///< "G7"
  std::string name;       ///< what the hand does
  std::string scene;      ///< tool, material, how it is driven
  double voxel_size = 0;  ///< [m]; 0: no voxels take part, or several sizes are compared
  std::string demand;     ///< what is asked, in a few words, "axial force"; with `gesture` it names a known failure
  std::string expected;   ///< in words and numbers, with the unit
  std::string seen;       ///< the same of what the library gives
  bool pass = false;      ///< what was seen is what was expected
  double strain = 0;      ///< [1] how near it is to its bound, which is 1; 0 of what is so or not
  std::string known;      ///< of a row that does not pass: the reason, where it is on the list of known failures
};

/// Which gestures run, and how fine.
struct GestureOptions {
  std::string only;                                      ///< the one of this id; empty: all
  std::vector<double> voxel_sizes = {2e-4, 1e-4, 5e-5};  ///< [m] from coarse to fine
  std::function<void(std::size_t done)> progress;        ///< called after each gesture of `gesture_ids`; may be empty
};

/// Runs the gestures: in the order of their ids, of the sizes of voxels, of their scenes. The same rows every time.
/// @throws Error when no gesture has that id, a voxel size is not positive, or there is none
[[nodiscard]] std::vector<GestureRow> run_gestures(const GestureOptions& options = {});

/// "G1", "G2", ...
[[nodiscard]] std::vector<std::string> gesture_ids();

/// A demand that the library does not meet yet.
struct KnownGestureFailure {
  std::string_view gesture, demand;  ///< as in GestureRow
  std::string_view reason;           ///< one line
  std::string_view seen;             ///< when it was put on the list
};

/// The demands that are not met, in the order of the gestures. The tests hold it both ways: what is on it fails in a
/// scene at least, and what is not does not.
[[nodiscard]] std::span<const KnownGestureFailure> known_gesture_failures();

}  // namespace hapticut
