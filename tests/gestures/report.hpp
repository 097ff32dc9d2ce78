// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/core/spatial.hpp"

namespace hapticut::gestures {

/// A number with three digits and its unit: "2.36 N".
[[nodiscard]] std::string shown(double value, const std::string& unit);

/// Appends a number, as text, to a list.
inline void list(std::string& text, const std::string& of, const std::string& value) {
  text += (text.empty() ? "" : ", ") + of + " " + value;
}

/// One demand on one scene of a gesture.
struct Row {
  std::string gesture;    // "G7"
  std::string scene;      // tool, material, kind of drive
  double voxel_size = 0;  // [m]; 0: the scene has no voxels, or compares several sizes
  std::string demand;     // a few words: "axial force"; `gesture` and `demand` name a known failure
  std::string expected;   // words and numbers, with the unit
  std::string seen;       // the result of the library, in words and numbers
  bool is_met = false;    // the result meets the demand
  double strain = 0;      // [1] result over its bound; 0 for a demand without a number
};

/// A result that must not depend on voxel size and rate.
struct Quantity {
  std::string scene, what, unit;
  double value = 0;
  double tolerance = 0;  // [1] between one size of voxels and the next
};

/// The settings and the results of one run of a gesture with one voxel size.
class Report {
 public:
  Report(std::string gesture, double voxel_size) : gesture_(std::move(gesture)), voxel_(voxel_size) {}

  // --- settings of the run ------------------------------------------------------------------------------------------
  [[nodiscard]] double voxel() const { return voxel_; }  ///< [m]
  double period = 1e-3;                                  ///< [s] duration of a tick
  Mat3 turn = Mat3::Identity();  ///< rotation of the whole scene, grid and hand, about the origin of W
  bool probing = false;          ///< adds probes after every step, which must not change any result

  // --- results ------------------------------------------------------------------------------------------------------
  /// Names the following scene: tool, material, kind of drive.
  void scene(std::string text) { scene_ = std::move(text); }

  void that(const std::string& demand, const std::string& expected, const std::string& seen, bool is_met,
            double strain = 0);

  /// @param why  reason of the bound in words; may be empty
  void at_most(const std::string& demand, double seen, double bound, const std::string& unit,
               const std::string& why = "");
  void at_least(const std::string& demand, double seen, double bound, const std::string& unit,
                const std::string& why = "");
  void between(const std::string& demand, double seen, double low, double high, const std::string& unit,
               const std::string& why = "");
  /// @param tolerance  [1] of `expected`
  void near(const std::string& demand, double seen, double expected, double tolerance, const std::string& unit,
            const std::string& why = "");

  /// A result to be compared between voxel sizes and rates: invariant 7.
  void quantity(const std::string& what, double value, const std::string& unit, double tolerance) {
    quantities_.push_back({scene_, what, unit, value, tolerance});
  }

  /// Bits that must be equal in every run: invariant 6.
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
