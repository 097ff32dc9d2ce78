// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hapticut/core/units.hpp"
#include "hapticut/core/volume.hpp"

namespace hapticut::test {

/// A volume of zeros; by default somewhere in the world and rotated.
template <class Value>
Volume<Value> volume_of(std::array<int, 3> dims, const Vec3& spacing,
                        const Pose& X_WG = {rotation_from_vector({0.2, 0.9, -0.4}), Vec3(3, -2, 8) * units::mm}) {
  Volume<Value> volume;
  volume.dims = dims;
  volume.spacing = spacing;
  volume.X_WG = X_WG;
  volume.values.resize(volume.size());
  return volume;
}

/// Calls `function` with the indices of each sample, in the order of the samples.
template <class Value, class Function>
void for_each_sample(const Volume<Value>& volume, const Function& function) {
  for (int k = 0; k < volume.dims[2]; ++k)
    for (int j = 0; j < volume.dims[1]; ++j)
      for (int i = 0; i < volume.dims[0]; ++i) function(i, j, k);
}

/// Sets all samples whose index is within a distance of a point, counted in millimetres of the grid's axes.
inline void add_ball(LabelVolume& volume, const Vec3& center_mm, double radius_mm, std::uint16_t label) {
  for_each_sample(volume, [&](int i, int j, int k) {
    if ((Vec3(i, j, k).cwiseProduct(volume.spacing) / units::mm - center_mm).norm() <= radius_mm)
      volume.at(i, j, k) = label;
  });
}

inline std::int64_t count(const LabelVolume& volume, std::uint16_t label) {
  return std::count(volume.values.begin(), volume.values.end(), label);
}

}  // namespace hapticut::test
