// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

/// @file
/// The closed forms that the library is held against by `hapticut validate`: one list, shared by the program, the
/// tests and the page of the documentation that it writes.
namespace hapticut::experiments {

/// How far a case may be off, and what it is off for.
struct Tolerance {
  double share;        ///< [1] of the relative error
  const char* reason;  ///< in a few words
};

/// What a formula gives, and what the library gives.
struct Check {
  std::string id;    ///< e.g. "C20 thrust"; unique
  std::string what;  ///< the case in words
  std::string unit;
  double expected = 0;
  double computed = 0;
  Tolerance tolerance = {0, ""};
  double scale = 0;       ///< errors are relative to this where it is not 0, for expected values that may be 0
  bool at_least = false;  ///< more than expected is no error: an order of convergence

  [[nodiscard]] double relative_error() const {
    const double size = scale != 0 ? std::abs(scale) : std::abs(expected);
    if (at_least && computed > expected) return 0;
    return std::abs(computed - expected) / size;
  }
  /// A number with the unit, as it is shown: "3.77 N", "0.5".
  [[nodiscard]] std::string with_unit(const std::string& number) const {
    return unit == "1" ? number : number + " " + unit;
  }
  /// [1] How much of its tolerance the error takes up.
  [[nodiscard]] double of_tolerance() const {
    const double error = relative_error();
    return error == 0 ? 0 : error / tolerance.share;
  }
  [[nodiscard]] bool pass() const { return relative_error() <= tolerance.share; }  // not a number does not pass
};

/// An error, or another number that should be 0.
[[nodiscard]] Check error_of(const std::string& id, const std::string& what, double value, const Tolerance& allowed,
                             const char* unit = "1");
/// An order of convergence, of which more is no error.
[[nodiscard]] Check order_of(const std::string& id, double least, double found, const Tolerance& tolerance);

/// One list of several.
[[nodiscard]] std::vector<Check> joined(std::initializer_list<std::vector<Check>> parts);

/// Checks that come out of one simulation.
struct Experiment {
  std::string name;
  std::function<std::vector<Check>()> run;
};

/// All experiments, in the order of the closed forms.
[[nodiscard]] std::vector<Experiment> all_experiments();

// By subject; `all_experiments` joins them.
[[nodiscard]] std::vector<Experiment> ball_experiments();         ///< standing: C1-C3, C14, C15
[[nodiscard]] std::vector<Experiment> cone_flat_experiments();    ///< standing: C4-C9
[[nodiscard]] std::vector<Experiment> layer_experiments();        ///< standing: C10, C12
[[nodiscard]] std::vector<Experiment> any_head_experiments();     ///< standing: C13, C16, C19
[[nodiscard]] std::vector<Experiment> pressure_experiments();     ///< standing: C11
[[nodiscard]] std::vector<Experiment> term_experiments();         ///< friction, effects, spindle: C17, C18
[[nodiscard]] std::vector<Experiment> axial_experiments();        ///< C20-C23, C30-C32, C34
[[nodiscard]] std::vector<Experiment> cutting_experiments();      ///< C24-C30
[[nodiscard]] std::vector<Experiment> grid_experiments();         ///< cuts in every direction of the grid
[[nodiscard]] std::vector<Experiment> pushed_experiments();       ///< the same under a constant force of the hand
[[nodiscard]] std::vector<Experiment> law_experiments();          ///< the alternative laws
[[nodiscard]] std::vector<Experiment> figure_experiments();       ///< of the thesis: C33
[[nodiscard]] std::vector<Experiment> measurement_experiments();  ///< rows B1 and DC4 of published measurements
[[nodiscard]] std::vector<Experiment> defect_experiments();  ///< of the thesis, in its model and in the default one

}  // namespace hapticut::experiments
