// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

/// The reference for `ClosedLoop`: the maximum stable stiffness of a linear wall, rendered by the simulated devices in
/// simulated hands, from an independent program of the same plant.
namespace hapticut {

inline constexpr int kWallDelays = 3;  ///< 0, 1, 2 ticks

struct WallRow {
  std::string_view device, hand;                  ///< names of a DeviceModel and of a HandModel
  std::array<double, kWallDelays> max_stiffness;  ///< [N/m] by ticks of delay, rounded to whole numbers
};

inline constexpr std::array<WallRow, 14> kWallTable = {{{"touch", "released", {400, 133, 80}},
                                                        {"touch", "light", {3415, 1142, 689}},
                                                        {"touch", "nominal", {8442, 2825, 1705}},
                                                        {"touch", "nominal-pad", {7194, 2774, 1873}},
                                                        {"touch", "light-pad", {3934, 1583, 1090}},
                                                        {"premium15", "released", {100, 33, 20}},
                                                        {"premium15", "nominal", {8131, 2718, 1638}},
                                                        {"premium15", "nominal-pad", {7504, 3158, 2221}},
                                                        {"premium6dof", "released", {200, 67, 40}},
                                                        {"premium6dof", "nominal", {8225, 2748, 1654}},
                                                        {"premium6dof", "nominal-pad", {8379, 3829, 2806}},
                                                        {"omega", "released", {1000, 334, 200}},
                                                        {"omega", "nominal", {9020, 3012, 1812}},
                                                        {"omega", "nominal-pad", {10710, 5442, 4218}}}};

}  // namespace hapticut
