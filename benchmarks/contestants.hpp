// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "workloads.hpp"

/// @file
/// What a competent user would write instead of this library. All compute the same: the sum over solid voxels with
/// r < R of (R - r) r_hat, in millimetres, on the ball; and, where the workload removes, they empty voxels with r <
/// R/2.
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

/// By name: vdb_accessor, vdb_leaf, dense, dense_simd.
[[nodiscard]] std::unique_ptr<Contestant> make_contestant(const std::string& name, const Workload& workload);
[[nodiscard]] const std::vector<std::string>& contestant_names();

}  // namespace hapticut::bench
