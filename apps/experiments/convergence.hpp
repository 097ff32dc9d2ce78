// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "experiments/checks.hpp"
#include "experiments/setup/static_contact.hpp"

/// @file
/// A standing head in a workpiece with a misaligned grid, and the order in which the error of its force falls with the
/// voxel size.
namespace hapticut::experiments {

using test::box_at_phase;
using test::half_space;
using test::kPhases;
using test::MaterialAt;
using test::materials_of_stiffness;
using test::phase;
using test::rest_ok_at;

/// Errors at three sizes of the voxels, or of another refined quantity. Each size is half of the one before.
struct Convergence {
  std::array<double, 3> size;   // [m]
  std::array<double, 3> error;  // [1] relative, root mean square over the grid phases

  /// p of error ~ size^p, from the coarsest to the finest.
  [[nodiscard]] double order() const;
};

/// @param relative_error  for a voxel size [m] and a phase of the grid
[[nodiscard]] Convergence converge(double coarsest, const std::function<double(double, const Vec3&)>& relative_error);

/// The bound `constant * (l / length)^2`.
[[nodiscard]] std::function<double(double)> second_order(double constant, double length);

/// Orders of root mean squares over twelve phases are known to about 0.2.
inline constexpr Tolerance kOrder = {0.15, "of twelve phases"};
inline constexpr double kSecondOrder = 2;  ///< [1]
inline constexpr double kRimOrder = 1.5;   ///< [1] order for lattice points in a disk
inline constexpr Tolerance kOfRimOrder = {1.0 / 6, "of twelve phases"};

/// The largest of several errors, each over its own bound.
struct Largest {
  double of_bound = 0;  // [1]

  void add(double value, double bound);
  [[nodiscard]] Check check(const std::string& id, const std::string& what, const char* reason) const;
};

/// Several cases of one closed form: the largest error over the bound for its voxel size, and the lowest order.
class Refined {
 public:
  /// @param reason  formula or cause of the bound
  Refined(std::string id, std::string what, double order, const char* reason, Tolerance of_order = kOrder);

  /// @param bound  [1] bound of the relative error for a size [m]
  void add(const Convergence& c, const std::function<double(double)>& bound);
  [[nodiscard]] std::vector<Check> checks() const;

 private:
  std::string id_, what_;
  double order_;
  const char* reason_;
  Tolerance of_order_;
  Largest worst_;
  double min_order_ = 1e9;
};

}  // namespace hapticut::experiments
