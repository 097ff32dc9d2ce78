// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

/// @file
/// The fixed motions of the benchmark: a ball in a solid block of 40 x 40 x 20 mm, corner at the origin, 1 ms per tick.
namespace hapticut::bench {

inline constexpr double kTick = 1e-3;                                       // [s]
inline constexpr double kFeed = 2e-3;                                       // [m/s]
inline constexpr double kBlockX = 40e-3, kBlockY = 40e-3, kBlockZ = 20e-3;  // [m]

enum class Path {
  w1,  ///< 1 mm deep, then 1 mm sideways
  w2,  ///< 1.5 R deep, then 1 mm sideways: here the removal rule of the contestants cuts
  w3   ///< completely inside, 1 mm sideways, no removal: pure throughput
};

struct Workload {
  Path path;
  double voxel_size;  // [m]
  double radius;      // [m]

  [[nodiscard]] double depth() const { return path == Path::w1 ? 1e-3 : path == Path::w2 ? 1.5 * radius : 0.0; }
  [[nodiscard]] bool removes() const { return path != Path::w3; }
  [[nodiscard]] int ticks() const { return int(std::lround((depth() + 1e-3) / (kFeed * kTick))); }

  /// Centre of the ball at the end of tick t.
  [[nodiscard]] Vec3 center(int t) const {
    const double s = kFeed * kTick * (t + 1);
    if (path == Path::w3) return {20.013e-3 + s, 20.007e-3, 10.003e-3};
    const double down = std::min(s, depth());
    return {20.013e-3 + (s - down), 20.007e-3, kBlockZ + radius - down};
  }

  [[nodiscard]] std::string name(const std::string& contestant) const {
    const char* paths[] = {"W1", "W2", "W3"};
    const auto number = [](double mm) {
      std::string text = std::to_string(mm);
      while (text.back() == '0') text.pop_back();
      if (text.back() == '.') text.pop_back();
      return text;
    };
    return "step/" + std::string(paths[int(path)]) + "/h" + number(voxel_size * 1e3) + "/R" + number(radius * 1e3) +
           "/" + contestant;
  }
};

}  // namespace hapticut::bench
