// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// @file
/// The closed forms that the library is held against by `hapticut validate`: one list, shared by the program, the
/// tests and the page of the documentation that it writes.
namespace hapticut::validation {

/// What a formula gives, and what the library gives.
struct Check {
  std::string id;    ///< e.g. "C20 thrust"; unique
  std::string what;  ///< the case in words
  std::string unit;
  double expected = 0;
  double computed = 0;
  double tolerance = 0;  ///< [1] of the relative error
  double scale = 0;      ///< errors are relative to this where it is not 0, for expected values that may be 0

  [[nodiscard]] double relative_error() const {
    const double size = scale != 0 ? std::abs(scale) : std::abs(expected);
    return std::abs(computed - expected) / size;
  }
  /// A number with the unit, as it is shown: "3.77 N", "0.5".
  [[nodiscard]] std::string with_unit(const std::string& number) const {
    return unit == "1" ? number : number + " " + unit;
  }
  [[nodiscard]] bool pass() const { return relative_error() <= tolerance; }  // not a number does not pass
};

/// Checks that come out of one simulation.
struct Experiment {
  std::string name;
  std::function<std::vector<Check>()> run;
};

/// All experiments, in the order of the closed forms.
[[nodiscard]] std::vector<Experiment> all_experiments();

// By subject; `all_experiments` joins them.
[[nodiscard]] std::vector<Experiment> static_experiments();       ///< C1-C16, C19
[[nodiscard]] std::vector<Experiment> term_experiments();         ///< friction, effects, spindle: C17, C18
[[nodiscard]] std::vector<Experiment> cutting_experiments();      ///< C20-C32, C34
[[nodiscard]] std::vector<Experiment> grid_experiments();         ///< cuts in every direction of the grid
[[nodiscard]] std::vector<Experiment> pushed_experiments();       ///< the same under a constant force of the hand
[[nodiscard]] std::vector<Experiment> law_experiments();          ///< the alternative laws, the thesis: C33
[[nodiscard]] std::vector<Experiment> measurement_experiments();  ///< rows B1 and DC4 of published measurements
[[nodiscard]] std::vector<Experiment> defect_experiments();  ///< of the thesis, in its model and in the default one

}  // namespace hapticut::validation
