// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

/// @file
/// The experiments of `hapticut validate`, which compare the library with closed forms. The program and the tests share
/// them.
namespace hapticut::experiments {

/// Allowed error of a case, and the reason for it.
struct Tolerance {
  double share;        ///< [1] allowed relative error
  const char* reason;  ///< a few words
};

/// One comparison: the value of a formula and the value of the library.
struct Check {
  std::string id;    ///< e.g. "C20 thrust"; unique
  std::string what;  ///< the case in words
  std::string unit;
  double expected = 0;
  double computed = 0;
  Tolerance tolerance = {0, ""};
  double scale = 0;       ///< if not 0, errors are relative to this: for expected values that may be 0
  bool at_least = false;  ///< a larger value is no error: an order of convergence

  [[nodiscard]] double relative_error() const {
    const double size = scale != 0 ? std::abs(scale) : std::abs(expected);
    if (at_least && computed > expected) return 0;
    return std::abs(computed - expected) / size;
  }
  /// A number with its unit: "3.77 N", "0.5".
  [[nodiscard]] std::string with_unit(const std::string& number) const {
    return unit == "1" ? number : number + " " + unit;
  }
  /// [1] Error over tolerance.
  [[nodiscard]] double of_tolerance() const {
    const double error = relative_error();
    return error == 0 ? 0 : error / tolerance.share;
  }
  [[nodiscard]] bool pass() const { return relative_error() <= tolerance.share; }  // NaN does not pass
};

/// A check of an error, or of another number that should be 0.
[[nodiscard]] Check error_of(const std::string& id, const std::string& what, double value, const Tolerance& allowed,
                             const char* unit = "1");
/// A check of an order of convergence. A higher order is no error.
[[nodiscard]] Check order_of(const std::string& id, double least, double found, const Tolerance& tolerance);

/// Joins several lists.
[[nodiscard]] std::vector<Check> joined(std::initializer_list<std::vector<Check>> parts);

/// A named function that runs simulations and returns checks.
struct Experiment {
  std::string name;
  std::function<std::vector<Check>()> run;
};

/// All experiments, in the order of the closed forms.
[[nodiscard]] std::vector<Experiment> all_experiments();

// The experiments by subject. `all_experiments` joins these lists.
[[nodiscard]] std::vector<Experiment> ball_experiments();         ///< standing: C1-C3, C14, C15
[[nodiscard]] std::vector<Experiment> cone_flat_experiments();    ///< standing: C4-C9
[[nodiscard]] std::vector<Experiment> layer_experiments();        ///< standing: C10, C12
[[nodiscard]] std::vector<Experiment> any_head_experiments();     ///< standing: C13, C16, C19
[[nodiscard]] std::vector<Experiment> pressure_experiments();     ///< standing: C11
[[nodiscard]] std::vector<Experiment> term_experiments();         ///< friction, effects, spindle: C17, C18
[[nodiscard]] std::vector<Experiment> axial_experiments();        ///< C20-C23, C30-C32, C34
[[nodiscard]] std::vector<Experiment> cutting_experiments();      ///< C24-C30
[[nodiscard]] std::vector<Experiment> grid_experiments();         ///< cuts in every direction of the grid
[[nodiscard]] std::vector<Experiment> pushed_experiments();       ///< cuts under a constant force of the hand
[[nodiscard]] std::vector<Experiment> law_experiments();          ///< alternative laws
[[nodiscard]] std::vector<Experiment> figure_experiments();       ///< figures of the thesis: C33
[[nodiscard]] std::vector<Experiment> measurement_experiments();  ///< rows B1 and DC4 of published measurements
[[nodiscard]] std::vector<Experiment> defect_experiments();  ///< defects of the thesis, in its and the default model

}  // namespace hapticut::experiments
