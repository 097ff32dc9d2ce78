// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hapticut/bench/gestures.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut::gestures {

/// A number with three digits and its unit: "2.36 N"; as a share where the unit is "%".
[[nodiscard]] std::string shown(double value, const std::string& unit);

/// A number that must not depend on how finely space and time are cut up.
struct Quantity {
  std::string scene, what, unit;
  double value = 0;
  double tolerance = 0;  // [1] between one size of voxels and the next
};

/// What one run of a gesture at one size of voxels has to say, and how it is to be run.
class Report {
 public:
  Report(std::string gesture, std::string name, double voxel_size)
      : gesture_(std::move(gesture)), name_(std::move(name)), voxel_(voxel_size) {}

  // --- how it is to be run ------------------------------------------------------------------------------------------
  [[nodiscard]] double voxel() const { return voxel_; }  ///< [m]
  double period = 1e-3;                                  ///< [s] of a tick
  Mat3 turn = Mat3::Identity();                          ///< of the whole scene, grid and hand, about the origin of W
  bool probing = false;  ///< every step is followed by probes, which must not change anything

  // --- what is seen -------------------------------------------------------------------------------------------------
  /// Names what follows: tool, material, how it is driven.
  void scene(std::string text) { scene_ = std::move(text); }

  void that(const std::string& demand, const std::string& expected, const std::string& seen, bool pass,
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
  [[nodiscard]] std::vector<GestureRow>& rows() { return rows_; }

 private:
  std::string gesture_, name_, scene_;
  double voxel_;
  std::vector<GestureRow> rows_;
  std::vector<Quantity> quantities_;
  std::uint64_t bits_ = 0xcbf29ce484222325ULL;
};

}  // namespace hapticut::gestures
