// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "workloads.hpp"

/// @file
/// Alternatives to this library that a competent user would write. All compute the sum of (R - r) r_hat over solid
/// voxels with r < R, in millimetres, on the ball. If the workload removes material, they empty voxels with r < R/2.
namespace hapticut::bench {

struct TickResult {
  double force_z = 0;  ///< [mm] upwards
  double force_x = 0;  ///< [mm]
  long contact = 0;    ///< solid voxels inside the ball
  long removed = 0;    ///< voxels emptied
};

class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual TickResult tick(const Vec3& center) = 0;
};

/// Makes a contestant by its name: vdb_accessor, vdb_leaf, dense, dense_simd.
[[nodiscard]] std::unique_ptr<Contestant> make_contestant(const std::string& name, const Workload& workload);
[[nodiscard]] const std::vector<std::string>& contestant_names();

}  // namespace hapticut::bench
