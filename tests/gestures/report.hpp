// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/spatial.hpp"

namespace hapticut::gestures {

/// A number with three digits and its unit: "2.36 N"; as a share where the unit is "%".
[[nodiscard]] std::string shown(double value, const std::string& unit);

/// Adds one to a list of numbers, as they are shown.
inline void list(std::string& text, const std::string& of, const std::string& value) {
  text += (text.empty() ? "" : ", ") + of + " " + value;
}

/// One demand on one scene of a gesture.
struct Row {
  std::string gesture;    // "G7"
  std::string scene;      // tool, material, how it is driven
  double voxel_size = 0;  // [m]; 0: no voxels take part, or several sizes are compared
  std::string demand;     // what is asked, in a few words, "axial force"; with `gesture` it names a known failure
  std::string expected;   // in words and numbers, with the unit
  std::string seen;       // the same of what the library gives
  bool is_met = false;    // what was seen is what was expected
  double strain = 0;      // [1] how near it is to its bound, which is 1; 0 of what is so or not
};

/// A number that must not depend on how finely space and time are cut up.
struct Quantity {
  std::string scene, what, unit;
  double value = 0;
  double tolerance = 0;  // [1] between one size of voxels and the next
};

/// What one run of a gesture at one size of voxels has to say, and how it is to be run.
class Report {
 public:
  Report(std::string gesture, double voxel_size) : gesture_(std::move(gesture)), voxel_(voxel_size) {}

  // --- how it is to be run ------------------------------------------------------------------------------------------
  [[nodiscard]] double voxel() const { return voxel_; }  ///< [m]
  double period = 1e-3;                                  ///< [s] of a tick
  Mat3 turn = Mat3::Identity();                          ///< of the whole scene, grid and hand, about the origin of W
  bool probing = false;  ///< every step is followed by probes, which must not change anything

  // --- what is seen -------------------------------------------------------------------------------------------------
  /// Names what follows: tool, material, how it is driven.
  void scene(std::string text) { scene_ = std::move(text); }

  void that(const std::string& demand, const std::string& expected, const std::string& seen, bool is_met,
            double strain = 0);

  /// @param why  the formula in words; empty where the bound speaks for itself
  void at_most(const std::string& demand, double seen, double bound, const std::string& unit,
               const std::string& why = "");
  void at_least(const std::string& demand, double seen, double bound, const std::string& unit,
                const std::string& why = "");
  void between(const std::string& demand, double seen, double low, double high, const std::string& unit,
               const std::string& why = "");
  /// @param tolerance  [1] of `expected`
  void near(const std::string& demand, double seen, double expected, double tolerance, const std::string& unit,
            const std::string& why = "");

  /// What is compared between sizes of voxels and rates: invariant 7.
  void quantity(const std::string& what, double value, const std::string& unit, double tolerance) {
    quantities_.push_back({scene_, what, unit, value, tolerance});
  }

  /// Bits that must be the same in every run: invariant 6.
  void add_bits(std::uint64_t hash) { bits_ = (bits_ ^ hash) * 0x100000001b3ULL; }

  [[nodiscard]] std::uint64_t bits() const { return bits_; }
  [[nodiscard]] const std::vector<Quantity>& quantities() const { return quantities_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  std::string gesture_, scene_;
  double voxel_;
  std::vector<Row> rows_;
  std::vector<Quantity> quantities_;
  std::uint64_t bits_ = 0xcbf29ce484222325ULL;
};

}  // namespace hapticut::gestures
